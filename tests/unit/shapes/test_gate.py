"""Gates: which way they open, and that the way turns with them and never flips."""

from math import pi

import pytest

from carom import Ball, Gate, InvalidArgument, Segment


def test_the_default_direction_is_the_normal() -> None:
    assert Gate((4, 0), (0, 0)).direction == (0.0, 1.0)
    assert Gate((0, 4), (0, 0)).direction == (-1.0, 0.0)
    assert isinstance(Gate((0, 0), (1, 0)), Segment)


def test_the_direction_is_kept_as_a_unit_vector() -> None:
    gate = Gate((0, 0), (4, 0), direction=(3, -4))
    assert gate.direction == (0.6, -0.8)
    gate.direction = (0, 9)
    assert gate.direction == (0.0, 1.0)


@pytest.mark.parametrize("direction", [(1, 0), (-7, 0), (1e-300, 0)])
def test_a_direction_along_the_gate_is_refused(direction: tuple[float, float]) -> None:
    with pytest.raises(InvalidArgument, match="direction must leave the gate's direction across the gate"):
        Gate((0, 0), (4, 0), direction=direction)


def test_a_gate_is_not_turned_along_its_direction() -> None:
    gate = Gate((0, 0), (4, 0), direction=(0, 1))
    with pytest.raises(InvalidArgument, match="p1 must leave"):
        gate.p1 = (0, 4)
    assert gate.p1 == (4.0, 0.0)


def test_the_direction_turns_with_the_gate_and_never_flips() -> None:
    gate = Gate((0, 0), (4, 0), motion="kinematic")
    gate.rotate((0, 0), pi)
    assert gate.p1 == pytest.approx((0.0, 0.0), abs=1e-15)
    assert gate.direction == pytest.approx((0.0, -1.0), abs=1e-15)
    assert gate.normal == pytest.approx((0.0, 1.0), abs=1e-15)
    gate.rotate((0, 0), 2 * pi)
    assert gate.direction == pytest.approx((0.0, 1.0), abs=1e-15)


@pytest.mark.parametrize(
    ("y", "vy", "stopped"),
    [
        (0.5, -1.0, True),  # against the gate, from its closed side
        (0.5, 1.0, False),  # on the closed side, and leaving
        (0.5, 0.0, False),  # at rest there
        (-0.5, 1.0, False),  # through the gate, from its open side
        (-0.5, -1.0, False),  # leaving on the open side
        (0.0, -1.0, False),  # on the gate itself
    ],
)
def test_outside_a_world_it_stops_what_approaches_from_the_closed_side(y: float, vy: float, stopped: bool) -> None:
    contact = Gate((0, 0), (4, 0)).detect(Ball((2, y), 1, velocity=(0, vy)))
    assert (contact is not None) == stopped


def test_the_approach_is_relative_to_a_moving_gate() -> None:
    gate = Gate((0, 0), (4, 0), motion="kinematic", velocity=(0, 2))
    assert gate.detect(Ball((2, 0.5), 1, velocity=(0, 1))) is not None
    assert gate.detect(Ball((2, 0.5), 1, velocity=(0, 3))) is None
    turning = Gate((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), angular_velocity=1.0)
    assert turning.detect(Ball((2, 0.5), 1, velocity=(0, 1.9))) is not None
    assert turning.detect(Ball((2, 0.5), 1, velocity=(0, 2.1))) is None
