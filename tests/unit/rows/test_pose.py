"""One substep of a shape's motion: what moves, what is remembered, and where the stops are."""

from math import cos, dist, pi, sin
from typing import Any

import pytest

from carom import Arc, Circle, Gate, Point, Segment, Shape
from carom.rows import kinds_near, pose
from carom.rows.pose import moves_with
from tests.kernel_calls import advance_pose
from tests.unit.rows.samples import KINDS, MANY, NEAR, SAMPLES, outline, row_of


def advance(shape: Shape, h: float, times: int = 1) -> bool:
    """Whether the last of some substeps moved the shape."""
    return [advance_pose(shape._row, h) for _ in range(times)][-1]


def test_a_substep_turns_and_travels() -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=pi, velocity=(4, 0))
    assert advance(hand, 0.5)
    assert (hand.orientation, hand.pivot) == (0.5 * pi, (2.0, 0.0))
    assert hand.p1 == pytest.approx((2.0, 2.0))
    row = hand._row
    assert (row["spin"], row["orientation_before"], row["pivot_before_x"]) == (pi, 0.0, 0.0)


def test_what_does_not_rotate_only_travels() -> None:
    circle = Circle((0, 0), 1, motion="kinematic", pivot=(5, 5), angular_velocity=1, rotating=False, velocity=(0, 2))
    assert advance(circle, 0.5)
    assert (circle.center, circle.pivot, circle.orientation, circle.angular_velocity) == (
        (0.0, 1.0),
        (5.0, 6.0),
        0.0,
        1.0,
    )
    assert circle._row["spin"] == 0.0


@pytest.mark.parametrize(
    "shape",
    [
        Point((0.1, 0.7)),
        Segment((0.1, 0.7), (3, 4), motion="kinematic"),
        Arc((0.1, 0.7), 3, 1, 2, motion="kinematic", angular_velocity=5, rotating=False),
        Gate((0, 0), (4, 0), motion="kinematic", angular_velocity=1, turn_limits=(0, 0)),
    ],
    ids=repr,
)
def test_what_neither_turns_nor_travels_stays_bit_for_bit(shape: Shape) -> None:
    before = {name: shape._row[name].item() for name in shape._row.dtype.names if name != "angular_velocity"}
    assert not advance(shape, 0.01)
    after = {name: shape._row[name].item() for name in before}
    assert after == before


@pytest.mark.parametrize(("spin", "stop"), [(7.0, 1.0), (-7.0, -0.5)])
def test_a_stop_is_met_exactly_within_a_substep(spin: float, stop: float) -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=spin, turn_limits=(-0.5, 1))
    advance(hand, 0.04, 3)
    assert (hand.orientation, hand.angular_velocity) == (
        pytest.approx(spin * 0.12) if spin > 0 else stop,
        spin if spin > 0 else 0.0,
    )
    assert advance(hand, 0.04) == (spin > 0)
    assert advance(hand, 0.04) is False
    assert (hand.orientation, hand.angular_velocity, hand._row["spin"]) == (stop, 0.0, 0.0)


def test_the_substep_that_meets_the_stop_still_has_its_spin() -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=5, turn_limits=(0, 1))
    assert advance(hand, 1.0)
    assert (hand.orientation, hand.angular_velocity, hand._row["spin"]) == (1.0, 0.0, 5.0)


@pytest.mark.parametrize("beyond", [0.0, 1e-12, 1e-4])
def test_a_stop_is_met_however_little_a_turn_goes_beyond_it(beyond: float) -> None:
    for sign in (1, -1):
        spin = sign * (1 + beyond)
        hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=spin, turn_limits=(-1, 1))
        advance(hand, 1.0)
        assert (hand.orientation, hand.angular_velocity) == (sign, 0.0)


def test_back_from_a_stop_it_turns_again() -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=5, turn_limits=(0, 1))
    advance(hand, 1.0)
    hand.angular_velocity = -5
    assert advance(hand, 0.1)
    assert hand.orientation == 0.5
    advance(hand, 1.0)
    assert (hand.orientation, hand.p0, hand.p1) == (0.0, (0.0, 0.0), (2.0, 0.0))


def test_a_turn_starts_from_the_initial_geometry() -> None:
    hand = Segment((0.1, 0.2), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=0.37)
    advance(hand, 0.01, 1000)
    orientation, ends = hand.orientation, (hand.p0, hand.p1)
    hand.reset()
    hand.rotate((0, 0), orientation)
    assert (hand.p0, hand.p1) == ends
    assert hand.length == pytest.approx(Segment((0.1, 0.2), (2, 0)).length, rel=1e-15)


def test_an_arc_turns_its_angles() -> None:
    arc = Arc((3, 0), 1, 6, 1, motion="kinematic", pivot=(0, 0), angular_velocity=1)
    advance(arc, 0.5)
    assert (arc.start_angle, arc.end_angle, arc.acute) == (pytest.approx(6.5 - 2 * pi), 1.5, True)
    fresh = Arc(arc.center, 1, arc.start_angle, arc.end_angle)
    assert (arc.p0, arc.p1, arc.aabb) == (fresh.p0, fresh.p1, fresh.aabb)


@KINDS
def test_the_box_is_that_of_the_outline(kind: str) -> None:
    row = row_of(kind)
    pose.derive(row)
    points = outline(SAMPLES[kind][0])
    found = [float(row[side]) for side in ("left", "bottom", "right", "top")]
    assert found == pytest.approx([*points.min(axis=0), *points.max(axis=0)], abs=NEAR)


@KINDS
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_a_posed_shape_is_the_initial_one_turned_and_moved(kind: str, turn: float) -> None:
    row = row_of(kind).copy()
    before = outline(SAMPLES[kind][0])[:: MANY // 50] - (float(row["pivot_x"]), float(row["pivot_y"]))
    row["orientation"] = turn
    row["pivot_x"] += 0.5
    row["pivot_y"] -= 0.25
    pose.pose(row)
    c, s = cos(turn), sin(turn)
    for x, y in before:
        place = float(row["pivot_x"]) + c * x - s * y, float(row["pivot_y"]) + s * x + c * y
        assert kinds_near.distance_to_shape(row, *place) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    "motion", [{"velocity": (1, 0)}, {"angular_velocity": 2.0}, {"velocity": (0, 3), "angular_velocity": 1}]
)
def test_what_moves_as_one_keeps_its_distance(motion: dict[str, Any]) -> None:
    others: list[dict[str, Any]] = [
        {"velocity": (1, 0)}, {"velocity": (0, 3), "angular_velocity": 1}, {"angular_velocity": 2.0},
        {"angular_velocity": 2.0, "pivot": (1, 0)}, {"velocity": (1, 0), "pivot": (4, 5)}, {},
    ]  # fmt: skip
    for other in others:
        one, two = (
            Point(place, motion="kinematic", **({"pivot": (0, 0)} | options))
            for place, options in (((3, 1), motion), ((1, 2), other))
        )
        before = dist(one.position, two.position)
        for shape in (one, two):
            advance(shape, 0.125)
        together = moves_with(one._row, two._row)
        assert together == (dist(one.position, two.position) == pytest.approx(before, abs=1e-12))
