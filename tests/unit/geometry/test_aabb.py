"""Boxes: their edges belong to them, and they hold their shapes tightly."""

from math import cos, pi, sin

import pytest
from hypothesis import given

from carom.geometry import aabb
from carom.geometry.angle import sweep
from carom.geometry.arc import arc_ends
from tests.strategies import arcs, fractions, points

UNIT = (0.0, 0.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("other", "overlap"),
    [
        ((0.2, 0.2, 0.8, 0.8), True),
        ((-1.0, -1.0, 2.0, 2.0), True),
        ((1.0, 0.0, 2.0, 1.0), True),
        ((1.0, 1.0, 2.0, 2.0), True),
        ((1.0 + 1e-15, 0.0, 2.0, 1.0), False),
        ((0.0, 1.1, 1.0, 2.0), False),
        ((-2.0, 0.0, -0.1, 1.0), False),
        ((0.0, -2.0, 1.0, -0.1), False),
    ],
)
def test_boxes_that_touch_overlap(other: tuple[float, float, float, float], overlap: bool) -> None:
    assert aabb.boxes_overlap(*UNIT, *other) is overlap
    assert aabb.boxes_overlap(*other, *UNIT) is overlap


def test_the_edge_of_a_box_belongs_to_it() -> None:
    assert all(aabb.box_contains(*UNIT, x, y) for x in (0.0, 0.5, 1.0) for y in (0.0, 0.5, 1.0))
    outside = ((-0.1, 0.5), (1.1, 0.5), (0.5, -0.1), (0.5, 1.1))
    assert not any(aabb.box_contains(*UNIT, x, y) for x, y in outside)


def test_a_box_grows_just_enough_to_hold_a_point() -> None:
    assert aabb.box_including(*UNIT, 0.5, 0.5) == UNIT
    assert aabb.box_including(*UNIT, -1.0, 3.0) == (-1.0, 0.0, 1.0, 3.0)
    assert aabb.box_including(*UNIT, 2.0, -3.0) == (0.0, -3.0, 2.0, 1.0)


def test_boxes_of_segments_and_circles() -> None:
    assert aabb.segment_box(3.0, 1.0, 2.0, 5.0) == (2.0, 1.0, 3.0, 5.0)
    assert aabb.circle_box(1.0, 2.0, 3.0) == (-2.0, -1.0, 4.0, 5.0)


@pytest.mark.parametrize(
    ("start", "end", "box"),
    [
        (0.25 * pi, 0.75 * pi, (-(0.5**0.5), 0.5**0.5, 0.5**0.5, 1.0)),
        (0.75 * pi, 0.25 * pi, (-1.0, -1.0, 1.0, 0.5**0.5)),
        (0.0, 0.5 * pi, (0.0, 0.0, 1.0, 1.0)),
        (pi, 0.0, (-1.0, -1.0, 1.0, 0.0)),
        (1e-6, 0.0, (-1.0, -1.0, 1.0, 1.0)),
    ],
)
def test_the_box_of_an_arc_reaches_to_its_quadrant_points(
    start: float, end: float, box: tuple[float, float, float, float]
) -> None:
    assert aabb.arc_box(0.0, 0.0, 1.0, *arc_ends(0.0, 0.0, 1.0, start, end)) == pytest.approx(box, abs=1e-15)


@given(arcs(), fractions)
def test_the_box_of_an_arc_holds_all_its_points(arc: tuple[float, float, float, float, float], fraction: float) -> None:
    cx, cy, radius, start, end = arc
    left, bottom, right, top = aabb.arc_box(cx, cy, radius, *arc_ends(*arc))
    angle = start + fraction * sweep(start, end)
    slack = 1e-13
    assert aabb.box_contains(
        left - slack, bottom - slack, right + slack, top + slack, cx + radius * cos(angle), cy + radius * sin(angle)
    )


@given(points, points)
def test_the_box_of_a_segment_holds_its_ends(a: tuple[float, float], b: tuple[float, float]) -> None:
    box = aabb.segment_box(*a, *b)
    assert aabb.box_contains(*box, *a)
    assert aabb.box_contains(*box, *b)
    assert box == aabb.segment_box(*b, *a)
