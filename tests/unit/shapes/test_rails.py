"""What may be set of a shape's motion: checked first, written then, and a halt where it had been sent somewhere."""

from collections.abc import Callable
from math import cos, pi, sin

import pytest

from carom import Circle, InvalidArgument, Motion, Point, Segment
from carom.rows.tables import Row
from carom.shapes.rails import (
    send,
    target_orientation,
    target_pivot,
    write_angular_velocity,
    write_rotating,
    write_turn_limits,
    write_velocity,
)


@pytest.mark.parametrize(
    ("option", "value"), [("velocity", (1, 0)), ("angular_velocity", 0.5), ("turn_limits", (-1, 1))]
)
def test_what_would_do_nothing_on_a_static_shape_is_refused(option: str, value: object) -> None:
    with pytest.raises(InvalidArgument, match=f"{option} must not be set unless motion is 'kinematic'"):
        Circle((0, 0), 1, **{option: value})
    circle = Circle((0, 0), 1)
    with pytest.raises(InvalidArgument, match=option):
        setattr(circle, option, value)
    circle.motion = "kinematic"
    setattr(circle, option, value)
    with pytest.raises(InvalidArgument, match="motion must stay 'kinematic' while"):
        circle.motion = Motion.STATIC
    assert circle.motion is Motion.KINEMATIC


def test_nothing_is_what_a_static_shape_may_be_told() -> None:
    circle = Circle((0, 0), 1, velocity=(0, 0), angular_velocity=0, turn_limits=None, rotating=False)
    circle.velocity = (0, 0)
    circle.turn_limits = None
    assert circle.motion is Motion.STATIC


def test_only_balls_are_dynamic() -> None:
    with pytest.raises(InvalidArgument, match=r"motion must be 'static' or 'kinematic' .*, not <Motion.DYNAMIC: 2>"):
        Point((0, 0), motion=Motion.DYNAMIC)


def test_turn_limits_hold_the_orientation_and_its_beginning() -> None:
    hand = Segment((0, 0), (1, 0), motion="kinematic", turn_limits=(0, 1))
    hand.rotate((0, 0), 0.8)
    for limits in [(0, 0.5), (0.2, 1), (-1, 0.79)]:
        with pytest.raises(InvalidArgument, match=r"turn_limits must be \(low, high\) with 0 and the orientation 0\.8"):
            hand.turn_limits = limits
    with pytest.raises(InvalidArgument, match=r"angle must be within turn_limits=\(0\.0, 1\.0\), not 1\.5"):
        hand.rotate((0, 0), 1.5)
    assert (hand.orientation, hand.turn_limits) == (0.8, (0.0, 1.0))
    back = Segment((0, 0), (1, 0), motion="kinematic", turn_limits=(-1, 0))
    back.rotate((0, 0), -0.8)
    with pytest.raises(InvalidArgument, match="turn_limits must be"):
        back.turn_limits = (-1, -0.2)
    hand.turn_limits = None
    hand.rotate((0, 0), 1.5)
    assert hand.orientation == 1.5


@pytest.mark.parametrize(
    ("write", "value"),
    [
        (write_angular_velocity, 2.0),
        (write_rotating, True),
        (write_velocity, (1.0, 0.0)),
        (write_turn_limits, (-2.0, 2.0)),
        (write_turn_limits, None),
    ],
)
def test_what_is_set_halts_a_row_that_was_sent_somewhere_and_what_is_refused_does_not(
    write: Callable[[Row, object], None], value: object
) -> None:
    row = Segment((0, 0), (2, 0), motion="kinematic")._row
    send(row, (3.0, 4.0), 0.5, 2.0)
    before = row.copy()
    with pytest.raises(InvalidArgument):
        write(row, "nonsense")
    assert row == before
    write(row, value)
    assert row["time_left"] == 0.0
    assert (row["angular_velocity"], row["velocity_x"]) == (2.0 if value == 2.0 else 0.0, 1.0 * (value == (1.0, 0.0)))


def test_a_row_is_sent_with_the_speeds_that_bring_it_there() -> None:
    row = Segment((0, 0), (2, 0), motion="kinematic", pivot=(1, 1))._row
    send(row, (3.0, -4.0), 0.5, 2.0)
    assert (row["velocity_x"], row["velocity_y"], row["angular_velocity"]) == (1.0, -2.5, 0.25)
    assert (row["time_left"], row["target_pivot_x"], row["target_orientation"]) == (2.0, 3.0, 0.5)
    with pytest.raises(InvalidArgument, match="dt must be long enough for finite speeds"):
        send(row, (1e308, 0.0), 0.0, 1e-9)


@pytest.mark.parametrize("turn", [0.0, 0.5 * pi, 2.0])
def test_a_pivot_is_sent_where_the_shape_is_to_be(turn: float) -> None:
    hand = Segment((2, 0), (4, 0), motion="kinematic", pivot=(1, 0))
    x, y = target_pivot(hand._row, 9.0, 7.0, turn)
    hand.rotate((1, 0), turn)
    hand.pivot, hand.position = hand.pivot, hand.position
    # The middle of the hand is at 2 from its pivot, in the direction that it is turned to.
    assert (x + 2 * cos(turn), y + 2 * sin(turn)) == pytest.approx((9.0, 7.0))


def test_an_orientation_is_within_the_stops_and_stays_while_nothing_turns() -> None:
    row = Segment((0, 0), (2, 0), motion="kinematic", turn_limits=(-1, 1))._row
    assert (target_orientation(row, None), target_orientation(row, -1.0)) == (0.0, -1.0)
    with pytest.raises(InvalidArgument, match=r"orientation must be within turn_limits=\(-1\.0, 1\.0\), not 1\.5"):
        target_orientation(row, 1.5)
    write_rotating(row, False)
    assert target_orientation(row, 0.0) == 0.0
    with pytest.raises(InvalidArgument, match="orientation must be None while rotating is False"):
        target_orientation(row, 0.5)
