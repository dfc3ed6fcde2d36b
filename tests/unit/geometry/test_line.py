"""Lines and segments: crossings and nearest points, near the vertical as anywhere else."""

from math import hypot, isfinite

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import line
from tests.naive import least_by_search
from tests.strategies import extremes, points, segments, unit_vectors, vectors

Vector = tuple[float, float]


def test_lines_cross_where_they_should() -> None:
    assert line.intersect_lines(0.0, 0.0, 1.0, 1.0, 4.0, 0.0, 0.0, -3.0) == pytest.approx((4.0, 4.0), rel=1e-15)
    assert line.intersect_lines(0.0, 1.0, 2.0, 0.0, 5.0, -7.0, 0.0, 1.0) == (5.0, 1.0)


def test_parallel_lines_do_not_cross() -> None:
    assert line.intersect_lines(0.0, 0.0, 1.0, 2.0, 1.0, 0.0, -0.5, -1.0) is None
    assert line.intersect_lines(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0) is None
    assert line.intersect_lines(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0) is None
    assert line.intersect_lines(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1e-310) is None


@given(points, unit_vectors, points, unit_vectors)
def test_a_crossing_lies_on_both_lines(p: Vector, d: Vector, q: Vector, e: Vector) -> None:
    assume(abs(d[0] * e[1] - d[1] * e[0]) > 1e-3)
    x, y = line.intersect_lines(*p, *d, *q, *e) or (0.0, 0.0)
    assert abs((x - p[0]) * d[1] - (y - p[1]) * d[0]) < 1e-9
    assert abs((x - q[0]) * e[1] - (y - q[1]) * e[0]) < 1e-9


@given(st.tuples(*[extremes] * 8))
def test_a_crossing_is_finite_or_none(lines: tuple[float, ...]) -> None:
    place = line.intersect_lines(*lines)
    assert place is None or all(map(isfinite, place))


def test_the_closest_point_of_a_line_needs_no_unit_vector() -> None:
    assert line.closest_on_line(0.0, 1.0, 100.0, 0.0, 7.0, 9.0) == (7.0, 1.0)
    assert line.closest_on_line(2.0, 1.0, 0.0, 0.0, 7.0, 9.0) == (2.0, 1.0)


@given(points, vectors, points)
def test_the_way_to_the_closest_point_of_a_line_is_across_it(p: Vector, d: Vector, q: Vector) -> None:
    assume(d != (0.0, 0.0))
    x, y = line.closest_on_line(*p, *d, *q)
    assert abs((q[0] - x) * d[0] + (q[1] - y) * d[1]) <= 1e-12 * hypot(*d) * 100.0
    assert abs((x - p[0]) * d[1] - (y - p[1]) * d[0]) <= 1e-12 * hypot(*d) * 100.0


def test_past_an_end_the_end_itself_is_closest() -> None:
    segment = (0.1, 0.2, 10.3, 5.7)
    assert line.closest_on_segment(*segment, -3.0, 0.0) == (0.1, 0.2)
    assert line.closest_on_segment(*segment, 30.0, 5.0) == (10.3, 5.7)
    assert line.distance_to_segment(*segment, 10.3, 6.7) > 0.5


def test_a_segment_of_no_length_is_its_point() -> None:
    assert line.closest_on_segment(1.0, 2.0, 1.0, 2.0, 4.0, 6.0) == (1.0, 2.0)
    assert line.distance_to_segment(1.0, 2.0, 1.0, 2.0, 4.0, 6.0) == 5.0


def test_a_small_distance_keeps_its_digits() -> None:
    assert line.distance_to_segment(0.0, 0.0, 1e6, 0.0, 3e5, 1e-20) == 1e-20


@given(segments(), points)
def test_no_point_of_a_segment_is_closer(segment: tuple[float, float, float, float], q: Vector) -> None:
    ax, ay, bx, by = segment
    least = least_by_search(lambda part: hypot(ax + part * (bx - ax) - q[0], ay + part * (by - ay) - q[1]), 0.0, 1.0)
    x, y = line.closest_on_segment(*segment, *q)
    assert hypot(x - q[0], y - q[1]) == pytest.approx(least, rel=1e-9, abs=1e-9)
    assert line.distance_to_segment(*segment, *q) == pytest.approx(least, rel=1e-9, abs=1e-9)
