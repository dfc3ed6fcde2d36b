"""Instants: pairs of doubles that hold twice as many digits, so that no sum of a thousand steps drifts."""

from fractions import Fraction
from math import inf, ulp

from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry.instants import is_before, later, resolution, seconds_since

#: Times from a world's first moment to far beyond its last, and steps of any length.
TIMES = st.floats(0.0, 1e12)
SECONDS = st.floats(0.0, 1e6)


def instant_of(*seconds: float) -> tuple[float, float]:
    """The instant so many seconds after the beginning."""
    time, low = 0.0, 0.0
    for part in seconds:
        time, low = later(time, low, part)
    return time, low


def exact(time: float, low: float) -> Fraction:
    """An instant without rounding."""
    return Fraction(time) + Fraction(low)


@given(TIMES, SECONDS)
def test_the_sum_of_two_doubles_is_exact(time: float, seconds: float) -> None:
    assert exact(*later(time, 0.0, seconds)) == Fraction(time) + Fraction(seconds)


@given(st.lists(SECONDS, min_size=1, max_size=30))
def test_an_instant_holds_a_sum_to_twice_the_digits_and_is_normalised(seconds: list[float]) -> None:
    time, low = instant_of(*seconds)
    total = sum(map(Fraction, seconds))
    assert abs(exact(time, low) - total) <= len(seconds) * Fraction(2) ** -100 * total
    assert time + low == time
    assert time == float(total) or abs(Fraction(time) - total) <= Fraction(ulp(time))


def test_a_hundred_thousand_steps_do_not_drift() -> None:
    step = 1 / 60
    time, low, naive = 0.0, 0.0, 0.0
    for _ in range(100_000):
        time, low = later(time, low, step)
        naive += step  # as `sum` adds no longer, from Python 3.12 on
    assert abs(exact(time, low) - 100_000 * Fraction(step)) < Fraction(1, 10**24)
    assert abs(Fraction(naive) - 100_000 * Fraction(step)) > Fraction(1, 10**10)


def test_whole_steps_come_to_the_same_instant_in_any_order() -> None:
    assert instant_of(*[2.0**-10] * 1024) == (1.0, 0.0) == instant_of(*[2.0**-6] * 64) == instant_of(0.25, 0.5, 0.25)


@given(TIMES, SECONDS, SECONDS)
def test_the_seconds_between_two_instants_are_those_that_lie_between(time: float, first: float, second: float) -> None:
    begin = later(time, 0.0, first)
    end = later(*begin, second)
    assert abs(seconds_since(*end, *begin) - second) <= 2 * ulp(second) + ulp(ulp(time + first + second))
    assert seconds_since(*begin, *end) == -seconds_since(*end, *begin)
    assert seconds_since(*begin, *begin) == 0.0


def test_a_moment_after_a_year_is_as_exact_as_at_the_beginning() -> None:
    year, moment = 3.2e7, 1e-20
    begin = instant_of(year, 0.1)
    assert abs(seconds_since(*later(*begin, moment), *begin) - moment) < 1e-24
    assert year + 0.1 + moment == year + 0.1


@given(st.lists(st.tuples(TIMES, st.floats(0.0, 1e-6)), min_size=2, max_size=8))
def test_instants_come_in_the_order_of_their_sums(parts: list[tuple[float, float]]) -> None:
    instants = [later(time, 0.0, seconds) for time, seconds in parts]
    for one in instants:
        for other in instants:
            assert is_before(*one, *other) == (exact(*one) < exact(*other))


def test_what_never_comes_is_after_everything() -> None:
    assert is_before(1e300, 1e280, inf, 0.0)
    assert not is_before(inf, 0.0, 1e300, 0.0)
    assert not is_before(inf, 0.0, inf, 0.0)


@given(st.lists(SECONDS, min_size=1, max_size=30))
def test_what_is_later_by_the_resolution_is_another_instant_and_by_a_hundredth_of_it_may_be_the_same(
    seconds: list[float],
) -> None:
    time, low = instant_of(*seconds)
    assume(time > 1e-200)
    assert is_before(time, low, *later(time, low, resolution(time)))
    edge = ulp(time) * 0.499
    assert later(time, edge, 0.01 * resolution(time)) == (time, edge)
