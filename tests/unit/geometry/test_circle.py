"""Circles: insides, nearest points and tangents, close to the circle as well as far away."""

from fractions import Fraction
from math import cos, hypot, isfinite, nextafter, pi, sin, sqrt

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import circle
from tests.naive import tangent_points
from tests.strategies import angles, circles, coordinates, extremes, points, positive_extremes, radii

Vector = tuple[float, float]
Circle = tuple[float, float, float]


def test_the_inside_is_strict() -> None:
    assert circle.circle_contains(1.0, 1.0, 5.0, 4.0, 4.0)
    assert not circle.circle_contains(1.0, 1.0, 5.0, 4.0, 5.0)


def test_the_closest_point_is_on_the_side_of_the_point() -> None:
    assert circle.closest_on_circle(1.0, 2.0, 3.0, 1.0, 100.0) == (1.0, 5.0)
    assert circle.closest_on_circle(1.0, 2.0, 3.0, 0.9, 2.0) == (-2.0, 2.0)
    assert circle.closest_on_circle(1.0, 2.0, 3.0, 1.0, 2.0) == (4.0, 2.0)


def test_tangents_of_a_textbook_triangle() -> None:
    found = circle.tangent_points(0.0, 0.0, 3.0, 5.0, 0.0)
    assert found == pytest.approx((1.8, -2.4, 1.8, 2.4), rel=1e-15)


def test_from_inside_there_is_no_tangent() -> None:
    assert circle.tangent_points(0.0, 0.0, 5.0, 3.0, 3.9) is None
    assert circle.tangent_points(1.0, 1.0, 5.0, 1.0, 1.0) is None


@pytest.mark.parametrize("place", [(3.0, 4.0), (-5.0, 0.0), (3.0, nextafter(4.0, 9.0)), (nextafter(3.0, 0.0), 4.0)])
def test_a_point_on_the_circle_is_its_own_tangent_point(place: Vector) -> None:
    assert circle.tangent_points(0.0, 0.0, 5.0, *place) == place + place


@pytest.mark.slow
@given(circles, points)
def test_the_closest_point_of_a_circle_counts_as_on_it(given_: Circle, q: Vector) -> None:
    place = circle.closest_on_circle(*given_, *q)
    assert circle.tangent_points(*given_, *place) == place + place


@given(circles, points)
def test_tangents_are_those_by_angles(given_: Circle, q: Vector) -> None:
    cx, cy, radius = given_
    assume(hypot(q[0] - cx, q[1] - cy) > 1.001 * radius)
    first, second = tangent_points(*given_, *q)
    assert circle.tangent_points(*given_, *q) == pytest.approx((*first, *second), rel=1e-9, abs=1e-9)


@given(circles, angles, st.integers(-14, 8))
def test_tangents_touch_and_the_first_is_counterclockwise(given_: Circle, angle: float, power: int) -> None:
    cx, cy, radius = given_
    away = radius * (1.0 + 10.0**power)
    x, y = cx + away * cos(angle), cy + away * sin(angle)
    found = circle.tangent_points(*given_, x, y)
    assume(found is not None)
    x0, y0, x1, y1 = found or (0.0, 0.0, 0.0, 0.0)
    slack = 1e-14 * (abs(cx) + abs(cy) + radius)
    assert hypot(x0 - cx, y0 - cy) == pytest.approx(radius, rel=0.0, abs=slack)
    assert hypot(x1 - cx, y1 - cy) == pytest.approx(radius, rel=0.0, abs=slack)
    assert (cx - x) * (y0 - y) - (cy - y) * (x0 - x) >= (cx - x) * (y1 - y) - (cy - y) * (x1 - x)


@given(st.integers(-1024, 1024), st.integers(1, 1024), st.integers(-1024, 1024), st.integers(1, 36))
def test_tangents_from_close_by_keep_their_digits(x: int, radius: int, shift: int, power: int) -> None:
    # A point exactly above the circle's top by 2^-power: the tangent's length is known without cancellation.
    gap = 2.0**-power
    cx, cy = float(x), float(shift)
    found = circle.tangent_points(cx, cy, float(radius), cx, cy + radius + gap)
    tangent = sqrt(gap * (2.0 * radius + gap))
    back, side = radius * (radius / (radius + gap)), radius * (tangent / (radius + gap))
    expected = (cx + side, cy + back, cx - side, cy + back)
    assert found == pytest.approx(expected, rel=1e-15, abs=1e-15 * (radius + abs(x)))


def test_outer_tangents_of_a_textbook_pair() -> None:
    found = circle.common_tangents(0.0, 0.0, 4.0, 5.0, 0.0, 1.0)
    assert found == pytest.approx((2.4, 3.2, 5.6, 0.8, 2.4, -3.2, 5.6, -0.8), rel=1e-15)


def test_outer_tangents_of_equal_circles_are_parallel_to_their_axis() -> None:
    found = circle.common_tangents(1.0, 1.0, 2.0, 1.0, 7.0, 2.0)
    assert found == (-1.0, 1.0, -1.0, 7.0, 3.0, 1.0, 3.0, 7.0)


@pytest.mark.parametrize(
    "other", [(0.5, 0.0, 1.0), (2.0, 0.0, 1.0), (0.0, 0.0, 3.0), (0.0, 0.0, 1.0), (0.0, 0.0, 9.0), (1e-17, 1e-17, 3.0)]
)
def test_a_circle_inside_another_shares_no_tangent(other: Circle) -> None:
    assert circle.common_tangents(0.0, 0.0, 3.0, *other) is None
    assert circle.common_tangents(*other, 0.0, 0.0, 3.0) is None


@given(circles, circles)
def test_common_tangents_touch_both_circles_on_one_side(first: Circle, second: Circle) -> None:
    x1, y1, r1 = first
    x2, y2, r2 = second
    away = hypot(x2 - x1, y2 - y1)
    assume(away > abs(r1 - r2) + 1e-3)
    found = circle.common_tangents(*first, *second)
    assert found is not None
    for sign, (px, py, qx, qy) in ((1.0, found[:4]), (-1.0, found[4:])):
        nx, ny = (px - x1) / r1, (py - y1) / r1
        assert hypot(nx, ny) == pytest.approx(1.0, abs=1e-13 * 100.0 / r1)
        assert ((qx - x2) / r2, (qy - y2) / r2) == pytest.approx((nx, ny), abs=1e-13 * 100.0 / min(r1, r2))
        assert (qx - px) * nx + (qy - py) * ny == pytest.approx(0.0, abs=1e-13 * away / r1)
        assert sign * ((x2 - x1) * ny - (y2 - y1) * nx) > 0.0


@given(circles, circles)
def test_common_tangents_seen_from_the_other_circle_are_the_same(first: Circle, second: Circle) -> None:
    there, back = circle.common_tangents(*first, *second), circle.common_tangents(*second, *first)
    assert (there is None) == (back is None)
    if there is not None and back is not None:
        px, py, qx, qy, sx, sy, tx, ty = there
        assert back == pytest.approx((tx, ty, sx, sy, qx, qy, px, py), rel=1e-14, abs=1e-13)


def test_touching_from_inside_is_told_from_crossing_by_the_last_digit() -> None:
    gap = 2.0**-50
    assert circle.common_tangents(0.0, 0.0, 3.0, 2.0, 0.0, 1.0) is None
    x1, y1, x2, y2, _, _, _, _ = circle.common_tangents(0.0, 0.0, 3.0, 2.0 + 2.0 * gap, 0.0, 1.0) or (0.0,) * 8
    assert hypot(x2 - x1, y2 - y1) == pytest.approx(sqrt(2.0 * gap * (4.0 + 2.0 * gap)), rel=1e-8)


@given(coordinates, coordinates, coordinates, coordinates, radii, radii)
def test_the_power_of_a_point_is_exact(x1: float, y1: float, x2: float, y2: float, r1: float, r2: float) -> None:
    exact = (Fraction(x2) - Fraction(x1)) ** 2 + (Fraction(y2) - Fraction(y1)) ** 2 - (Fraction(r1) - Fraction(r2)) ** 2
    largest = max(abs(x2 - x1), abs(y2 - y1), abs(r1 - r2)) ** 2
    error = abs(Fraction(circle.power(x1, y1, x2, y2, r1, r2)) - exact)
    assert error <= Fraction(3e-16) * abs(exact) + Fraction(1e-30 * largest + 1e-300)


@given(extremes, extremes, positive_extremes, extremes, extremes, positive_extremes)
def test_tangents_are_finite_at_any_magnitude(x1: float, y1: float, r1: float, x2: float, y2: float, r2: float) -> None:
    for found in (circle.tangent_points(x1, y1, r1, x2, y2), circle.common_tangents(x1, y1, r1, x2, y2, r2)):
        assert found is None or all(map(isfinite, found))


def test_a_common_tangent_of_circles_of_very_unlike_size() -> None:
    found = circle.common_tangents(0.0, 0.0, 1.0, 0.0, 1e6 + 1.0, 1e6)
    assert found is not None
    px, py, qx, qy, *_ = found
    assert hypot(qx - px, qy - py) == pytest.approx(2.0 * sqrt(1e6), rel=1e-12)
    assert px == pytest.approx(-2.0 * sqrt(1e6) / (1e6 + 1.0), rel=1e-12)
    assert py == pytest.approx(-(1e6 - 1.0) / (1e6 + 1.0), rel=1e-12)
    assert pi > 3.0 > qy / 1e6
