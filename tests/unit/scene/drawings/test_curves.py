"""Curves as arcs, against dense samples of the curves."""

from math import cos, hypot, inf, pi, sin
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import carom
from carom.scene.drawings.curves import fitted
from carom.scene.drawings.pieces import Conic, Course, Cubic

PLACES = st.tuples(st.floats(0.0, 10.0), st.floats(0.0, 10.0))


def shapes_of(made: list[tuple[str, dict[str, Any]]]) -> list[carom.Shape]:
    """The shapes with some geometry."""
    kinds = {"arc": carom.Arc, "segment": carom.Segment}
    return [kinds[kind](**geometry) for kind, geometry in made]


def distance(shapes: list[carom.Shape], place: tuple[float, float]) -> float:
    """How far a place is from the nearest of some shapes."""
    return min((shape.distance(place) for shape in shapes), default=inf)


@settings(max_examples=15, deadline=None)
@given(st.tuples(PLACES, PLACES, PLACES, PLACES))
def test_a_bezier_curve_is_within_the_tolerance(ends: tuple[tuple[float, float], ...]) -> None:
    assume(hypot(ends[0][0] - ends[3][0], ends[0][1] - ends[3][1]) > 0.1)
    shapes = shapes_of(fitted(Cubic(*ends), 0.05))
    for k in range(65):
        t = k / 64.0
        weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
        x, y = (sum(w * end[axis] for w, end in zip(weights, ends, strict=True)) for axis in (0, 1))
        assert distance(shapes, (x, y)) <= 0.05


def test_an_ellipse_is_within_the_tolerance_and_without_a_bend() -> None:
    ellipse = Conic((1.0, 2.0), (3.0, 1.0), (-0.5, 1.5))
    shapes = shapes_of(fitted(ellipse, 1e-3))
    assert {shape.kind for shape in shapes} == {"arc"}
    assert len(shapes) < 60
    assert carom.guard_points(shapes) == []
    for k in range(200):
        assert distance(shapes, ellipse.at(2.0 * pi * k / 200.0)) <= 1e-3


def test_a_part_of_an_ellipse_goes_from_its_start_to_its_end() -> None:
    part = Conic((0.0, 0.0), (3.0, 0.0), (0.0, 1.0), 0.3, -2.0)
    shapes = shapes_of(fitted(part, 1e-3))
    ends = [end for shape in shapes for end in (shape.p0, shape.p1)]
    for end in (part.start, part.end):
        assert min(hypot(end[0] - x, end[1] - y) for x, y in ends) < 1e-12
    assert len(carom.guard_points(shapes)) == 2


def test_any_smooth_course_is_followed() -> None:
    course = Course(lambda t: (t, 0.1 * sin(6.0 * t) * cos(t)))
    shapes = shapes_of(fitted(course, 1e-4))
    for k in range(100):
        assert distance(shapes, course.at(0.01 * k)) <= 1e-4


def test_what_is_straight_is_a_segment() -> None:
    assert fitted(Cubic((0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)), 1e-3) == [
        ("segment", {"start": (0.0, 0.0), "end": (3.0, 3.0)})
    ]


def test_a_tolerance_below_rounding_is_refused() -> None:
    with pytest.raises(carom.errors.InvalidArgument, match="tolerance"):
        fitted(Cubic((0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 3.0)), 1e-15)
