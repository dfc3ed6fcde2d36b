"""The search for touches with turning shapes: the gap, its bounds, and the first fall through zero."""

from math import cos, inf, sin
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.geometry import turning as search
from tests.flat import flat
from tests.strategies import seeds

turning = flat(search)


def test_the_gap_of_a_circle_goes_on_smoothly_where_its_form_changes() -> None:
    for form in (search.OUTER, search.INNER):
        for x in (4.9999999, 5.0000001):
            gap, rate = turning.seen_gap(0.0, form, 0.0, 0.0, 5.0, x, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0)
            sign = 1.0 if form == search.OUTER else -1.0
            assert gap == pytest.approx(sign * (x - 5.0), rel=1e-6)
            assert rate == pytest.approx(sign * 2.0, rel=1e-6)


@given(
    st.lists(st.floats(-10.0, 10.0), min_size=8, max_size=8), st.floats(0.0, 2.0), st.sampled_from((0, 1, 2)), st.data()
)
def test_the_bounds_of_the_search_hold(numbers: list[float], duration: float, form: int, data: st.DataObject) -> None:
    px, py, vx, vy, gx, gy, spin, angle = numbers
    kx, ky, level = (cos(angle), sin(angle), 0.5) if form == search.LINE else (angle, 1.0, 3.0)
    motion = (px, py, vx, vy, gx, gy, spin)
    speed, acceleration = turning.seen_bounds(*motion, duration)
    bend_fall, bend_rise = turning.seen_bends(form, level, speed, acceleration)
    first, second = sorted(data.draw(st.lists(st.floats(0.0, 1.0), min_size=2, max_size=2)))
    gap1, rate1 = turning.seen_gap(first * duration, form, kx, ky, level, *motion)
    gap2, _ = turning.seen_gap(second * duration, form, kx, ky, level, *motion)
    step = (second - first) * duration
    noise = 1e-9 * (1.0 + speed) * (1.0 + speed)
    if gap1 > 0.0:  # as long as it stays above 0, so at least up to where the bound itself falls to 0
        bound = gap1 + rate1 * step - 0.5 * bend_fall * step * step
        assert gap2 >= bound - noise or step > turning.safe_step(gap1, rate1, bend_fall)
    else:
        bound = gap1 + rate1 * step + 0.5 * bend_rise * step * step
        assert gap2 <= bound + noise or step > turning.safe_step(noise - gap1, -rate1, bend_rise)
    assert abs(rate1) <= speed + noise


@pytest.mark.parametrize("form", [search.OUTER, search.INNER])
def test_the_bounds_know_how_a_circle_curves(form: int) -> None:
    # straight across a circle, whose form there is the square of the distance
    level, motion = 3.0, (-0.1, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0)
    speed, acceleration = turning.seen_bounds(*motion, 0.2)
    gap1, rate1 = turning.seen_gap(0.0, form, 0.0, 0.0, level, *motion)
    gap2, rate2 = turning.seen_gap(0.2, form, 0.0, 0.0, level, *motion)
    bend_fall, bend_rise = turning.seen_bends(form, level, speed, acceleration)
    assert acceleration == 0.0
    assert rate2 - rate1 == pytest.approx(0.2 * (bend_rise if form == search.OUTER else -bend_fall), rel=1e-6)
    assert gap1 == pytest.approx(gap2, abs=1e-12)


@pytest.mark.slow
@given(st.sampled_from((search.LINE, search.OUTER, search.INNER)), seeds)
def test_the_first_fall_of_a_gap_is_found_where_many_moments_say(form: int, seed: int) -> None:
    random = Random(seed)
    motion = [*(random.uniform(-4, 4) for _ in range(6)), random.uniform(-6, 6)]
    angle, level = random.uniform(0, 6), random.uniform(0.5, 3)
    kx, ky = (cos(angle), sin(angle)) if form == search.LINE else (random.uniform(-2, 2), random.uniform(-2, 2))
    gaps = [turning.seen_gap(0.001 * k, form, kx, ky, level, *motion)[0] for k in range(2001)]
    found = turning.next_fall(0.0, gaps[0] > 0.0, 1e-9, form, kx, ky, level, *motion, 2.0)
    falls = [k for k in range(1, 2001) if gaps[k - 1] > 0.0 >= gaps[k]]
    if falls:
        assert found == pytest.approx(0.001 * falls[0], abs=0.002)
    else:
        assert found is None


@pytest.mark.parametrize(
    ("gap", "rate", "bend"), [(1.0, 2.0, 3.0), (1.0, -2.0, 3.0), (0.5, 0.0, 8.0), (2.0, -1.0, 0.0)]
)
def test_a_safe_step_ends_where_the_bound_does(gap: float, rate: float, bend: float) -> None:
    step = turning.safe_step(gap, rate, bend)
    assert gap + rate * step - 0.5 * bend * step * step == pytest.approx(0.0, abs=1e-12)
    assert turning.safe_step(1.0, 0.0, 0.0) == inf
