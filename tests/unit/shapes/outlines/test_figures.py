"""Polygons and what is rounded: lengths by closed forms, joints, points where there are corners."""

from math import pi, sin
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import Arc, InvalidArgument, Segment, Shape, outlines
from tests.curves import joints

sizes = st.floats(0.1, 50.0)


def perimeter(shapes: list[Shape]) -> float:
    """The length of all segments and arcs."""
    return sum(shape.length for shape in shapes if isinstance(shape, (Segment, Arc)))


def points(shapes: list[Shape]) -> set[tuple[float, float]]:
    """Where there are points."""
    return {shape.position for shape in shapes if shape.kind == "point"}


def is_closed(shapes: list[Shape], bent: int) -> bool:
    """Whether walls join from the first round to the first again, with so many bends."""
    walls = [shape for shape in shapes if shape.kind != "point"]
    found = joints([*walls, walls[0]])
    return all(gap < 1e-12 for _, gap, _ in found) and sum(bend > 1e-9 for _, _, bend in found) == bent


def test_a_polyline_goes_through_its_points_and_has_one_at_each() -> None:
    places = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (7.0, 7.0)]
    shapes = outlines.polyline(places)
    assert [shape.kind for shape in shapes] == ["segment"] * 3 + ["point"] * 4
    assert points(shapes) == set(places)
    assert perimeter(shapes) == 12.0
    assert perimeter(outlines.polyline(places, closed=True)) == pytest.approx(12.0 + 98.0**0.5)


def test_a_point_between_two_segments_in_line_is_none() -> None:
    assert points(outlines.polyline([(0, 0), (1, 1), (2, 2)])) == {(0.0, 0.0), (2.0, 2.0)}


def test_a_polygon_is_closed() -> None:
    shapes = outlines.polygon([(0, 0), (4, 0), (4, 3)])
    assert is_closed(shapes, 3)
    assert perimeter(shapes) == 12.0


@settings(max_examples=20)
@given(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0), sizes, sizes, st.floats(0.01, 0.5))
def test_a_rounded_rectangle_is_closed_without_a_bend(
    left: float, bottom: float, width: float, height: float, share: float
) -> None:
    corner = share * min(width, height) * (1.0 - 1e-12)
    shapes = outlines.rectangle(left, bottom, left + width, bottom + height, corner=corner)
    assert is_closed(shapes, 0)
    assert points(shapes) == set()
    assert perimeter(shapes) == pytest.approx(2.0 * (width + height) - (8.0 - 2.0 * pi) * corner)


def test_sides_that_arcs_use_up_are_left_out() -> None:
    assert [shape.kind for shape in outlines.rectangle(0, 0, 2, 2, corner=1)] == ["arc"] * 4
    assert [shape.kind for shape in outlines.rectangle(0, 0, 4, 2)] == ["segment"] * 4 + ["point"] * 4


@settings(max_examples=20)
@given(st.integers(3, 40), sizes, st.floats(-9.0, 9.0))
def test_a_regular_polygon_has_equal_sides_and_a_corner_at_its_angle(n: int, radius: float, angle: float) -> None:
    shapes = outlines.regular_polygon((1, 2), radius, n, angle=angle)
    walls = [shape for shape in shapes if isinstance(shape, Segment)]
    assert is_closed(shapes, n)
    assert [wall.length for wall in walls] == pytest.approx([2.0 * radius * sin(pi / n)] * n)
    assert len(points(shapes)) == n


@settings(max_examples=20)
@given(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0), sizes, st.floats(-pi, pi))
def test_a_capsule_is_closed_without_a_bend_and_all_of_it_is_a_radius_away(
    x: float, y: float, radius: float, angle: float
) -> None:
    end = complex(x, y) + 3.0 * complex(carom.angle_to_vector(angle)[0], carom.angle_to_vector(angle)[1])
    shapes = outlines.capsule((x, y), (end.real, end.imag), radius)
    assert is_closed(shapes, 0)
    assert points(shapes) == set()
    assert perimeter(shapes) == pytest.approx(6.0 + 2.0 * pi * radius)
    spine = Segment((x, y), (end.real, end.imag))
    assert all(spine.distance(place) == pytest.approx(radius) for wall in shapes for place in ends(wall))


def ends(shape: Any) -> list[tuple[float, float]]:
    """Both ends of a wall."""
    return [shape.p0, shape.p1]


def test_a_stadium_lies_about_its_center() -> None:
    shapes = outlines.stadium((1, 2), 4.0, 1.5, elasticity=0.5, name="wall")
    assert is_closed(shapes, 0)
    assert perimeter(shapes) == pytest.approx(8.0 + 3.0 * pi)
    assert {(shape.elasticity, shape.name) for shape in shapes} == {(0.5, "wall")}
    boxes = [shape.aabb for shape in shapes]
    assert min(box.left for box in boxes) == pytest.approx(1 - 3.5)
    assert max(box.top for box in boxes) == pytest.approx(3.5)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: outlines.polyline([(0, 0)]), "points must be 2 or more"),
        (lambda: outlines.polyline([(0, 0), (1, 1)], closed=True), "points must be 3 or more"),
        (lambda: outlines.polyline([(0, 0), (1, 1), (1, 1)]), r"points\[2\] must differ from the one before it"),
        (lambda: outlines.polygon([(0, 0), (1, 1), (0, 1), (0, 0)]), r"points\[0\] must differ"),
        (lambda: outlines.polyline([(0, 0), (1, 1)], closed=1), "closed must be True or False"),
        (lambda: outlines.rectangle(1, 0, 1, 2), r"right must be above left=1\.0, not 1"),
        (lambda: outlines.rectangle(0, 3, 1, 2), r"top must be above bottom=3\.0, not 2"),
        (
            lambda: outlines.rectangle(0, 0, 1, 2, corner=0.6),
            r"corner must be half of the shorter side at most, not 0\.6",
        ),
        (lambda: outlines.regular_polygon((0, 0), 1.0, 2), "n must be from 3"),
        (lambda: outlines.regular_polygon((0, 0), 0.0, 3), "radius must be positive"),
        (lambda: outlines.capsule((0, 0), (0, 0), 1.0), "b must differ from a"),
        (lambda: outlines.stadium((0, 0), 0.0, 1.0), "length must be positive"),
        (lambda: outlines.polygon([(0, 0), (1, 0), (1, 1)], kick=-1), "kick must not be negative"),
    ],
)
def test_mistakes_are_named(call: Any, message: str) -> None:
    with pytest.raises(InvalidArgument, match=message):
        call()
