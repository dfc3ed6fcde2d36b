"""Helpers on vectors and angles."""

from math import pi

import pytest

import carom


@pytest.mark.parametrize(
    ("angle", "expected"), [(0, 0.0), (-1e-17, 0.0), (2 * pi, 0.0), (-pi / 2, 1.5 * pi), (7.0, 7.0 - 2 * pi)]
)
def test_angles_come_back_in_one_turn(angle: float, expected: float) -> None:
    assert carom.normalize_angle(angle) == pytest.approx(expected, abs=1e-15)
    assert 0.0 <= carom.normalize_angle(angle) < 2 * pi


def test_vectors_of_the_textbook() -> None:
    assert carom.normalize((3, -4)) == (0.6, -0.8)
    assert carom.perp((3, 4)) == (-4.0, 3.0)
    assert carom.angle_to_vector(pi / 2) == pytest.approx((0.0, 1.0))
    assert carom.rotate_point((3, 1), (1, 1), pi / 2) == pytest.approx((1.0, 3.0))
    assert carom.parallel_component((3, 4), (10, 0)) == (3.0, 0.0)


def test_a_zero_vector_has_no_direction() -> None:
    with pytest.raises(carom.CaromError, match=r"v must not be zero, not \(0, 0\)"):
        carom.normalize((0, 0))
    with pytest.raises(ValueError, match="w must not be zero"):
        carom.parallel_component((1, 2), (0, 0))


def test_a_right_turn_makes_no_negative_zero() -> None:
    assert str(carom.perp((1, 0))) == "(0.0, 1.0)"
