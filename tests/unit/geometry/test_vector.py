"""Vectors: lengths, directions and turns, at every magnitude."""

from math import cos, hypot, isfinite, sin

import pytest
from hypothesis import given

from carom.geometry import vector
from tests.strategies import angles, extremes, vectors

SMALLEST = 5e-324


def test_dot_and_cross_tell_along_from_across() -> None:
    assert vector.dot(3.0, 4.0, 2.0, -1.0) == 2.0
    assert vector.cross(1.0, 0.0, 0.0, 1.0) == 1.0
    assert vector.cross(0.0, 1.0, 1.0, 0.0) == -1.0


def test_the_squared_length_is_the_square_of_the_length() -> None:
    assert vector.length_squared(3.0, 4.0) == 25.0
    assert vector.length(3.0, 4.0) == 5.0
    assert vector.length(0.0, -0.0) == 0.0


@pytest.mark.parametrize("scale", [SMALLEST, 1e-200, 1e-150, 1.0, 1e150, 1e200])
def test_lengths_hold_where_squares_would_not(scale: float) -> None:
    assert vector.length(3.0 * scale, 4.0 * scale) == pytest.approx(5.0 * scale, rel=1e-15, abs=SMALLEST)


@given(extremes, extremes)
def test_a_length_is_right_to_the_last_digits(x: float, y: float) -> None:
    assert vector.length(x, y) == pytest.approx(hypot(x, y), rel=4e-16, abs=0.0)


@pytest.mark.parametrize("scale", [SMALLEST, 1e-300, 1e-160, 1.0, 1e160, 1e300])
def test_a_unit_vector_has_length_one_however_small_the_vector(scale: float) -> None:
    ux, uy = vector.unit(-scale, scale) or (0.0, 0.0)
    assert hypot(ux, uy) == pytest.approx(1.0, abs=4e-16)
    assert ux == -uy < 0.0


def test_the_zero_vector_has_no_direction() -> None:
    assert vector.unit(0.0, -0.0) is None


@given(extremes, extremes)
def test_a_unit_vector_points_along_its_vector(x: float, y: float) -> None:
    direction = vector.unit(x, y)
    if direction is None:
        assert x == y == 0.0
        return
    ux, uy = direction
    assert hypot(ux, uy) == pytest.approx(1.0, abs=4e-16)
    assert ux * hypot(x, y) == pytest.approx(x, rel=1e-15, abs=1e-300 * hypot(x, y))
    assert uy * hypot(x, y) == pytest.approx(y, rel=1e-15, abs=1e-300 * hypot(x, y))


def test_a_quarter_turn_is_counterclockwise() -> None:
    assert vector.rotated(1.0, 2.0, 0.0, 1.0) == (-2.0, 1.0)
    assert vector.rotated_about(3.0, 2.0, 1.0, 2.0, 0.0, 1.0) == (1.0, 4.0)


@given(vectors, angles)
def test_a_turn_keeps_the_length(v: tuple[float, float], angle: float) -> None:
    turned = vector.rotated(*v, cos(angle), sin(angle))
    assert hypot(*turned) == pytest.approx(hypot(*v), rel=1e-15, abs=1e-300)


def test_the_parallel_component_is_the_shadow() -> None:
    assert vector.parallel_component(3.0, 4.0, 10.0, 0.0) == (3.0, 0.0)
    assert vector.parallel_component(3.0, 4.0, 0.0, -2.0) == (0.0, 4.0)
    assert vector.parallel_component(3.0, 4.0, 0.0, 0.0) is None


@given(vectors, vectors)
def test_what_is_left_of_the_parallel_component_is_across(v: tuple[float, float], w: tuple[float, float]) -> None:
    part = vector.parallel_component(*v, *w)
    if part is None:
        assert w == (0.0, 0.0)
        return
    left = (v[0] - part[0], v[1] - part[1])
    assert abs(vector.dot(*left, *w)) <= 1e-14 * hypot(*v) * hypot(*w)
    assert abs(vector.cross(*part, *w)) <= 1e-14 * hypot(*v) * hypot(*w)


@given(extremes, extremes)
def test_larger_and_smaller_are_the_two_numbers(a: float, b: float) -> None:
    assert vector.larger(a, b) == max(a, b)
    assert vector.smaller(a, b) == min(a, b)


@given(extremes, extremes, extremes, extremes)
def test_nothing_is_ever_not_a_number(ax: float, ay: float, bx: float, by: float) -> None:
    part = vector.parallel_component(ax, ay, bx, by)
    assert part is None or all(map(isfinite, part))
