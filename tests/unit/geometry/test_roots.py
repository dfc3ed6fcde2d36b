"""Roots of polynomials: textbook cases, cancellation, double roots, and all of them against 60 digits."""

from math import inf, nan, nextafter, sqrt

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import roots as root_functions
from tests.flat import flat

roots = flat(root_functions)
spread = st.builds(
    lambda digits, power, sign: sign * digits * 10.0**power,
    st.floats(1.0, 9.0),
    st.integers(-8, 8),
    st.sampled_from((1.0, -1.0)),
)


def test_a_height_that_falls_through_zero() -> None:
    assert roots.falling_time(5.0, -10.0, 0.0) == 0.5
    assert roots.falling_time(5.0, 0.0, -10.0) == 1.0
    assert roots.falling_time(4.0, -5.0, 2.0) == 1.0


def test_a_height_that_only_grazes_zero_does_not_fall_through_it() -> None:
    assert roots.falling_time(1.0, -2.0, 2.0) is None
    assert roots.falling_time(1.0, -2.0, 2.5) is None


def test_a_height_that_rises_for_good_does_not_fall() -> None:
    assert roots.falling_time(1.0, 1.0, 0.0) is None
    assert roots.falling_time(1.0, 0.0, 1.0) is None
    assert roots.falling_time(-1.0, 2.0, 3.0) is None


def test_from_below_zero_it_has_to_rise_above_first() -> None:
    assert roots.falling_time(-1.0, -1.0, -1.0) is None
    assert roots.falling_time(-1.0, 1.0, -1.0) is None
    assert roots.falling_time(-1.5, 4.0, -4.0) == 1.5
    assert roots.falling_time(0.0, 4.0, -4.0) == 2.0


@given(spread, spread, spread)
def test_falling_times_are_exact_to_the_last_digits(height: float, rate: float, acceleration: float) -> None:
    with mpmath.workdps(60):
        a, b, c = (mpmath.mpf(number) for number in (acceleration / 2.0, rate, height))
        squared = b * b - 4 * a * c
        # Where the two roots all but coincide, the last digits of the input decide.
        assume(abs(squared) > 1e-6 * max(b * b, abs(4 * a * c)))
        both = [(-b + sign * mpmath.sqrt(squared)) / (2 * a) for sign in (1, -1)] if a != 0 and squared > 0 else []
        both = both or ([-c / b] if a == 0 and b != 0 else [])
        exact = [root for root in both if root > 0 and 2 * a * root + b < 0]
        found = roots.falling_time(height, rate, acceleration)
        assert (found is None) == (exact == [])
        if found is not None:
            assert abs(found - exact[0]) <= 1e-9 * exact[0]


def test_no_digits_are_lost_where_the_rate_is_large() -> None:
    assert roots.falling_time(1.0, -1e8, 1e-8) == pytest.approx(1e-8, rel=1e-15)
    assert roots.quadratic_roots(1.0, -1e8, 1.0, inf) == pytest.approx((1e-8, 1e8), rel=1e-15)


def test_quadratic_roots_are_in_order_and_brought_into_the_range() -> None:
    assert roots.quadratic_roots(1.0, -3.0, 2.0, 10.0) == (1.0, 2.0)
    assert roots.quadratic_roots(-1.0, 3.0, -2.0, 10.0) == (1.0, 2.0)
    assert roots.quadratic_roots(1.0, -3.0, 2.0, 1.5) == (1.0, 1.5)
    assert roots.quadratic_roots(1.0, 1.0, -2.0, 10.0) == (0.0, 1.0)
    assert roots.quadratic_roots(1.0, 3.0, 2.0, 10.0) == (0.0, 0.0)


def test_a_quadratic_without_two_roots_has_the_rest_at_the_end() -> None:
    assert roots.quadratic_roots(1.0, 0.0, 1.0, 10.0) == (10.0, 10.0)
    assert roots.quadratic_roots(1.0, -2.0, 1.0, 10.0) == (10.0, 10.0)
    assert roots.quadratic_roots(0.0, 2.0, -4.0, 10.0) == (0.0, 2.0)
    assert roots.quadratic_roots(0.0, -2.0, 4.0, 10.0) == (2.0, 10.0)
    assert roots.quadratic_roots(0.0, 0.0, 1.0, 10.0) == (10.0, 10.0)
    assert roots.quadratic_roots(0.0, 0.0, 0.0, 10.0) == (10.0, 10.0)


def test_a_ratio_never_divides_by_zero() -> None:
    assert roots.clipped_ratio(1.0, 0.0, 7.0) == 7.0
    assert roots.clipped_ratio(0.0, 0.0, 7.0) == 0.0
    assert roots.clipped_ratio(-1.0, 0.0, 7.0) == 0.0
    assert roots.clipped_ratio(3.0, -1.0, 7.0) == 0.0
    assert roots.clipped_ratio(-3.0, -1.0, 7.0) == 3.0
    assert roots.clipped_ratio(1e300, 1e-300, 7.0) == 7.0


@pytest.mark.parametrize("guess", [0.0, 1.0, 1.4, 1.5, 2.0, -7.0, inf])
@pytest.mark.parametrize("rising", [True, False])
def test_newton_finds_the_enclosed_root_from_any_guess(guess: float, rising: bool) -> None:
    sign = 1.0 if rising else -1.0
    assert roots.root_between(sign, 0.0, 0.0, 0.0, -4.0 * sign, 0.0, 2.0, rising, guess) == pytest.approx(
        sqrt(2.0), rel=1e-15
    )


def test_newton_gives_way_to_halving_where_it_would_not_converge() -> None:
    # (t - 1)³ is so flat at its root that Newton's method alone gains a third of the distance each step
    assert roots.root_between(0.0, 1.0, -3.0, 3.0, -1.0, 0.0, 5.0, True, 4.9) == pytest.approx(1.0, abs=1e-5)


def test_a_root_at_the_end_of_its_enclosure_is_found() -> None:
    assert roots.root_between(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, True, 1.0) == pytest.approx(0.0, abs=1e-15)
    assert roots.root_between(0.0, 0.0, 0.0, 1.0, -2.0, 0.0, 2.0, True, 1.0) == pytest.approx(2.0, rel=1e-15)


def test_newton_goes_on_to_a_root_where_it_leads_out_of_the_enclosure_from_its_end() -> None:
    # Below zero at 5 and beyond its least value there: the tangent crosses zero to the right, the root is at 1.
    assert roots.root_between(0.0, 0.0, 1.0, -7.0, 6.0, 0.0, 5.0, False, 4.9999) == pytest.approx(1.0, rel=1e-15)
    assert roots.newton_step(5.0, -4.0, 3.0, 0.0, 5.0, 5.0) == 2.5
    # But a root at the end itself has been found, though rounding leads out of it.
    assert roots.newton_step(5.0, -4e-16, 3.0, 0.0, 5.0, 5.0) == 5.0


def test_a_time_within_a_duration_is_a_number_and_not_later() -> None:
    for duration in (3.0, 1e300, inf):
        assert roots.time_within(3.0, duration) == 3.0
    for time, duration in ((nextafter(3.0, inf), 3.0), (inf, inf), (nan, inf), (nan, 1.0)):
        assert roots.time_within(time, duration) is None
