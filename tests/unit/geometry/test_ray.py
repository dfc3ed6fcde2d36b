"""Rays and moved circles: first touches, points, normals against the motion; and what a way crosses."""

from math import atan2, cos, hypot, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.geometry import ray as rays
from carom.geometry.arc import arc_ends
from carom.geometry.vector import unit
from tests.flat import flat
from tests.naive import in_sector
from tests.strategies import arcs, circles, points, segments

ray = flat(rays)
FLOOR = (0.0, 0.0, 1.0, 0.0, 10.0)
RIGHT_HALF = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 1.5 * pi, 0.5 * pi))
finite = st.floats(allow_nan=False, allow_infinity=False)

Way = tuple[tuple[float, float], tuple[float, float]]
ways = st.tuples(points, points)


def test_a_ray_meets_a_segment_from_either_side() -> None:
    assert ray.ray_segment(*FLOOR, 2.0, 3.0, 0.0, 2.0, -6.0) == (0.5, 3.0, 0.0, 0.0, 1.0)
    assert ray.ray_segment(*FLOOR, 2.0, -3.0, 0.0, 2.0, 6.0) == (0.5, 3.0, 0.0, 0.0, -1.0)


def test_a_ray_meets_a_segment_at_its_very_ends() -> None:
    assert ray.ray_segment(*FLOOR, 0.0, 1.0, 0.0, 0.0, -2.0) == (0.5, 0.0, 0.0, 0.0, 1.0)
    assert ray.ray_segment(*FLOOR, 10.0, 1.0, 0.0, 0.0, -2.0) == (0.5, 10.0, 0.0, 0.0, 1.0)
    assert ray.ray_segment(*FLOOR, -1e-12, 1.0, 0.0, 0.0, -2.0) is None


def test_a_ray_along_a_segment_passes_it() -> None:
    assert ray.ray_segment(*FLOOR, -5.0, 0.0, 0.0, 20.0, 0.0) is None


def test_a_ray_ends_at_its_target() -> None:
    assert ray.ray_segment(*FLOOR, 2.0, 3.0, 0.0, 0.0, -2.9) is None
    assert ray.ray_segment(*FLOOR, 2.0, 3.0, 0.0, 0.0, -3.0) is not None
    assert ray.ray_circle(0.0, 0.0, 5.0, 0, -10.0, 0.0, 0.0, 4.9, 0.0) is None


def test_a_ray_meets_a_circle_from_outside_and_inside() -> None:
    assert ray.ray_circle(1.0, 0.0, 5.0, 0, -9.0, 0.0, 0.0, 10.0, 0.0) == (0.5, -4.0, 0.0, -1.0, 0.0)
    assert ray.ray_circle(1.0, 0.0, 5.0, 0, 1.0, 0.0, 0.0, 10.0, 0.0) == (0.5, 6.0, 0.0, -1.0, 0.0)
    assert ray.ray_circle(1.0, 0.0, 5.0, 1, 1.5, 0.0, 0.0, 10.0, 0.0) is None


def test_a_ray_that_only_grazes_a_circle_passes_it() -> None:
    assert ray.ray_circle(0.0, 0.0, 5.0, 0, -10.0, 5.0, 0.0, 20.0, 0.0) is None


def test_a_ray_from_within_a_solid_circle_inwards_is_stopped_at_once() -> None:
    assert ray.ray_circle(0.0, 0.0, 5.0, 1, 3.0, 0.0, 0.0, -1.0, 0.0) == (0.0, 5.0, 0.0, 1.0, 0.0)


def test_a_ray_meets_an_arc_within_its_sector() -> None:
    assert ray.ray_arc(*RIGHT_HALF, 10.0, 3.0, 0.0, -12.0, 0.0, 0.0) == pytest.approx((0.5, 4.0, 3.0, 0.8, 0.6))
    assert ray.ray_arc(*RIGHT_HALF, -10.0, 3.0, 0.0, 28.0, 0.0, 0.0) == pytest.approx((0.5, 4.0, 3.0, -0.8, -0.6))
    assert ray.ray_arc(*RIGHT_HALF, -10.0, 3.0, 0.0, 12.0, 0.0, 0.0) is None


def test_a_ray_never_meets_a_point_but_a_circle_does() -> None:
    assert ray.ray_point(1.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0) is None
    assert ray.ray_point(10.0, 3.0, 0.0, 0.0, 5.0, 12.0, 0.0) == pytest.approx((0.5, 10.0, 3.0, -0.8, -0.6))


def test_a_moved_circle_touches_with_its_rim() -> None:
    assert ray.ray_segment(*FLOOR, 2.0, 4.0, 1.0, 2.0, -6.0) == (0.5, 3.0, 0.0, 0.0, 1.0)
    assert ray.ray_circle(1.0, 0.0, 5.0, 0, -9.0, 0.0, 1.0, 8.0, 0.0) == (0.5, -4.0, 0.0, -1.0, 0.0)
    assert ray.ray_circle(1.0, 0.0, 5.0, 0, 1.0, 0.0, 1.0, 8.0, 0.0) == (0.5, 6.0, 0.0, -1.0, 0.0)


def test_a_circle_that_touches_already_is_stopped_only_if_it_approaches() -> None:
    assert ray.ray_segment(*FLOOR, 2.0, 0.5, 1.0, 0.0, -1.0) == (0.0, 2.0, 0.0, 0.0, 1.0)
    assert ray.ray_segment(*FLOOR, 2.0, 0.5, 1.0, 0.0, 1.0) is None
    assert ray.ray_segment(*FLOOR, 2.0, 1.0, 1.0, 1.0, 0.0) is None


def test_no_way_at_all_meets_nothing() -> None:
    assert ray.ray_segment(*FLOOR, 2.0, 1.0, 1.0, 0.0, 0.0) is None
    assert ray.ray_circle(0.0, 0.0, 5.0, 1, 0.0, 0.0, 1.0, 0.0, 0.0) is None


@given(st.lists(st.floats(-10.0, 10.0), min_size=10, max_size=10), st.floats(0.0, 5.0), st.floats(0.01, 5.0))
def test_the_circle_touches_the_point_and_the_normal_points_against_the_motion(
    numbers: list[float], radius: float, r: float
) -> None:
    x, y, dx, dy, cx, cy, ax, ay, bx, by = numbers
    tx, ty = unit(ax, ay) or (1.0, 0.0)
    ends = (cx + r * tx, cy + r * ty, cx - r * ty, cy + r * tx)
    clear = abs(hypot(x - cx, y - cy) - r) > radius
    for found in (
        ray.ray_segment(cx, cy, tx, ty, r, x, y, radius, dx, dy),
        ray.ray_circle(cx, cy, r, 0, x, y, radius, dx, dy),
        ray.ray_arc(cx, cy, r, *ends, x, y, radius, dx, dy, 0.0),
        ray.ray_point(bx, by, x, y, radius, dx, dy),
    ):
        if found is None or not clear:
            continue
        fraction, px, py, nx, ny = found
        assert 0.0 <= fraction <= 1.0
        assert hypot(nx, ny) == pytest.approx(1.0, abs=1e-15)
        assert nx * dx + ny * dy <= 1e-15 * hypot(dx, dy)
        if fraction > 0.0:
            touch = (x + dx * fraction - radius * nx, y + dy * fraction - radius * ny)
            # a point or end that is met almost at the circle's side turns with every rounding
            assert touch == pytest.approx((px, py), abs=1e-6)


@given(st.lists(finite, min_size=10, max_size=10), st.floats(0.0, allow_infinity=False), st.booleans())
def test_no_finite_numbers_make_nan_or_an_exception(numbers: list[float], radius: float, solid: bool) -> None:
    x, y, dx, dy, cx, cy, ax, ay, bx, by = numbers
    tx, ty = unit(ax, ay) or (1.0, 0.0)
    r = sqrt(min(bx * bx, 1e300)) or 1.0
    for found in (
        ray.ray_segment(cx, cy, tx, ty, r, x, y, radius, dx, dy),
        ray.ray_circle(cx, cy, r, int(solid), x, y, radius, dx, dy),
        ray.ray_arc(cx, cy, r, ax, ay, bx, by, x, y, radius, dx, dy, 0.0),
        ray.ray_point(cx, cy, x, y, radius, dx, dy),
    ):
        assert found is None or 0.0 <= found[0] <= 1.0


def along(way: Way) -> tuple[np.ndarray, np.ndarray]:
    """Many places of a way."""
    share = np.linspace(0.0, 1.0, 4001)
    (x, y), (to_x, to_y) = way
    return x + share * (to_x - x), y + share * (to_y - y)


@given(ways, segments())
def test_a_way_crosses_a_segment_where_it_changes_its_side_between_the_ends(
    way: Way, segment: tuple[float, float, float, float]
) -> None:
    (x, y), (to_x, to_y) = way
    ax, ay, bx, by = segment
    extent = hypot(bx - ax, by - ay)
    tx, ty = (bx - ax) / extent, (by - ay) / extent
    xs, ys = along(way)
    side, foot = tx * (ys - ay) - ty * (xs - ax), tx * (xs - ax) + ty * (ys - ay)
    at = np.flatnonzero(side[:-1] * side[1:] < 0.0)
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    found = ray.crosses_segment(ax, ay, tx, ty, extent, x, y, to_x - x, to_y - y, 0.0)
    if any(slack < foot[k] < extent - slack for k in at):
        assert found
    elif all(not -slack < foot[k] < extent + slack for k in at) and min(abs(side[0]), abs(side[-1])) > 1e-9:
        assert not found


@given(ways, circles, st.booleans())
def test_a_way_crosses_a_circle_where_it_comes_in_or_leaves_what_is_hollow(
    way: Way, circle: tuple[float, float, float], solid: bool
) -> None:
    (x, y), (to_x, to_y) = way
    cx, cy, r = circle
    xs, ys = along(way)
    outside = np.hypot(xs - cx, ys - cy) - r
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    found = ray.crosses_circle(cx, cy, r, int(solid), x, y, to_x - x, to_y - y)
    if outside[0] < -slack:
        if abs(outside[-1]) > slack:
            assert found == (not solid and outside[-1] > 0.0)
    elif outside[0] > slack and abs(outside.min()) > slack:
        assert found == (outside.min() < 0.0)


@given(ways, arcs())
def test_a_way_crosses_an_arc_where_it_crosses_its_circle_in_the_sector(
    way: Way, arc: tuple[float, float, float, float, float]
) -> None:
    (x, y), (to_x, to_y) = way
    cx, cy, r, start, end = arc
    xs, ys = along(way)
    outside = np.hypot(xs - cx, ys - cy) - r
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    at = np.flatnonzero(outside[:-1] * outside[1:] < 0.0)
    edges = [min(abs((atan2(ys[k] - cy, xs[k] - cx) - edge + pi) % (2 * pi) - pi) for edge in (start, end)) for k in at]
    if any(r * edge <= slack for edge in edges) or min(abs(outside[0]), abs(outside[-1])) <= slack:
        return
    if not len(at) and abs(outside.min()) <= slack:
        return
    expected = any(in_sector(start, end, xs[k] - cx, ys[k] - cy) for k in at)
    assert ray.crosses_arc(cx, cy, r, *arc_ends(cx, cy, r, start, end), x, y, to_x - x, to_y - y, 0.0) == expected


def test_what_begins_on_a_side_does_not_cross_it() -> None:
    assert not ray.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, 2.0, 0.0, 0.0, -3.0, 0.0)
    assert not ray.crosses_circle(0.0, 0.0, 5.0, 0, 3.0, 4.0, 9.0, 9.0)
    assert not ray.crosses_arc(0.0, 0.0, 5.0, 5.0, 0.0, -5.0, 0.0, 3.0, 4.0, 9.0, 9.0, 0.0)


@pytest.mark.parametrize(("past", "crosses"), [(0.05, True), (0.15, False)])
def test_ends_reach_as_far_as_the_slop(past: float, crosses: bool) -> None:
    assert ray.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, 4.0 + past, 1.0, 0.0, -2.0, 0.1) == crosses
    assert ray.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, -past, 1.0, 0.0, -2.0, 0.1) == crosses
    angle = -past / 5.0
    way = 4.0 * cos(angle), 4.0 * sin(angle), 2.0 * cos(angle), 2.0 * sin(angle)
    assert ray.crosses_arc(0.0, 0.0, 5.0, 5.0, 0.0, -5.0, 0.0, *way, 0.1) == crosses
