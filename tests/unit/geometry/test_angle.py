"""Angles: one turn's range, sweeps and directions."""

from math import cos, nextafter, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.constants import TWO_PI
from carom.geometry.angle import direction, normalize_angle, sweep
from tests.strategies import angles


@pytest.mark.parametrize(
    ("angle", "normalized"),
    [
        (0.0, 0.0),
        (-0.0, 0.0),
        (-1e-17, 0.0),
        (-5e-324, 0.0),
        (TWO_PI, 0.0),
        (-TWO_PI, 0.0),
        (4.0 * TWO_PI, 0.0),
        (nextafter(TWO_PI, 0.0), nextafter(TWO_PI, 0.0)),
        (-0.5 * pi, 1.5 * pi),
        (3.0 * pi, pi),
        (1e-300, 1e-300),
    ],
)
def test_an_angle_is_brought_into_one_turn(angle: float, normalized: float) -> None:
    assert normalize_angle(angle) == normalized
    assert str(normalize_angle(angle)) == str(normalized)


@given(st.floats(-1e9, 1e9))
def test_a_normalized_angle_is_in_range_and_points_the_same_way(angle: float) -> None:
    normalized = normalize_angle(angle)
    assert 0.0 <= normalized < TWO_PI
    assert normalize_angle(normalized) == normalized
    rounding = 1e-15 + abs(angle) * 1e-16
    assert cos(normalized) == pytest.approx(cos(angle), abs=rounding)
    assert sin(normalized) == pytest.approx(sin(angle), abs=rounding)


@given(angles)
def test_an_angle_in_range_is_left_alone(angle: float) -> None:
    assert normalize_angle(angle) == angle


@given(angles, angles)
def test_two_sweeps_make_a_turn(start: float, end: float) -> None:
    there, back = sweep(start, end), sweep(end, start)
    assert 0.0 < there <= TWO_PI
    assert there + back == pytest.approx(2.0 * TWO_PI if start == end else TWO_PI, rel=1e-15)


def test_a_sweep_is_counterclockwise() -> None:
    assert sweep(0.0, 0.5 * pi) == 0.5 * pi
    assert sweep(0.5 * pi, 0.0) == 1.5 * pi
    assert sweep(1e-17, 0.0) == TWO_PI


def test_a_direction_is_cosine_and_sine() -> None:
    assert direction(0.0) == (1.0, 0.0)
    assert direction(1.25) == (cos(1.25), sin(1.25))
