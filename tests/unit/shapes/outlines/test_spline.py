"""Cubics along functions, and slopes by differences."""

import itertools
from cmath import exp
from collections.abc import Callable
from math import pi

import pytest

from carom import InvalidArgument
from carom.shapes.outlines.spline import cubics_along, slope_by_steps, value_of
from tests.clock import within


@pytest.mark.parametrize("t", [0.0, 1e-9, 0.013, 0.5, 0.987, 1.0])
def test_slopes_by_steps_have_nine_digits_and_stay_inside(t: float) -> None:
    def place(at: float) -> complex:
        assert 0.0 <= at <= 1.0
        return exp(2j * pi * at) + at**3

    assert abs(slope_by_steps(place, t) - (2j * pi * exp(2j * pi * t) + 3 * t * t)) < 1e-8


def test_a_corner_that_no_cubic_follows_is_refused_in_time() -> None:
    steps: Callable[[float], complex] = lambda t: complex(t, t > 0.3)  # noqa: E731
    with within(20.0), pytest.raises(InvalidArgument, match=r"curve must be smooth.*near t=0\.3"):
        cubics_along(steps, lambda t: 1 + 0j, 1e-6)


def test_cubics_join_smoothly_and_keep_to_the_curve() -> None:
    cubics = cubics_along(lambda t: exp(2j * pi * t), lambda t: 2j * pi * exp(2j * pi * t), 1e-7)
    assert all((a.d, a.d - a.c) == pytest.approx((b.a, b.b - b.a)) for a, b in itertools.pairwise(cubics))
    assert all(abs(abs(cubic.point(s / 9)) - 1.0) < 1e-7 for cubic in cubics for s in range(10))


def test_a_function_must_give_places() -> None:
    assert value_of("curve", lambda t: (t, 2), 0.5) == (0.5, 2.0)
    with pytest.raises(InvalidArgument, match=r"curve\(0.5\) must be a pair"):
        value_of("curve", lambda t: None, 0.5)
