"""Impacts of balls that fall: worked examples, and what is known of a fall before its roots are looked for."""

from math import hypot, inf, nextafter

import numpy as np
import pytest
from hypothesis import given
from numpy.typing import NDArray

from carom.geometry import impact as impacts
from carom.geometry import impact_fall as fall
from carom.geometry.path import Path
from tests.flat import flat
from tests.strategies import seeds
from tests.unit.geometry.impact_figures import BOWL, FLOOR, SLOP, STILL

impact = flat(impacts)


def approx(time: float) -> object:
    """The time, but for its last digits."""
    return pytest.approx(time, rel=1e-15)


def test_a_ball_falls_onto_a_floor_a_point_and_a_bumper() -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 6.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0, SLOP) == 1.0
    assert impact.impact_point(5.0, 0.0, 5.0, 6.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0) == approx(1.0)
    assert impact.impact_circle(5.0, -3.0, 3.0, 1, 5.0, 6.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0) == approx(1.0)
    assert impact.impact_circle(5.0, -3.0, 3.0, 0, 5.0, 6.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0) == approx(1.0)


def test_a_ball_falls_within_a_circle_and_into_a_bowl() -> None:
    assert impact.impact_circle(0.0, 0.0, 6.0, 0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0) == approx(1.0)
    assert impact.impact_arc(*BOWL, 0.0, 16.0, 1.0, 0.0, 0.0, 0.0, -10.0, 5.0, SLOP) == approx(2.0)


def test_a_ball_thrown_up_meets_what_it_falls_back_on() -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 0.0, 5.0, 0.0, -10.0, 5.0, SLOP) == 1.0
    assert impact.impact_circle(0.0, -5.0, 5.0, 1, 0.0, 1.0, 1.0, 0.0, 5.0, 0.0, -10.0, 5.0) == approx(1.0)
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, -4.0, 1.0, 0.0, 5.0, 0.0, -10.0, 5.0) == approx(1.0)


def test_a_ball_thrown_past_an_end_comes_back_to_the_other_side() -> None:
    # up past the left end, back down beside it, where it meets the wall's left side
    wall = (0.0, 0.0, 0.0, 1.0, 4.0)
    assert impact.impact_segment(*wall, 3.0, 6.0, 1.0, -10.0, 0.0, 8.0, -2.0, 5.0, SLOP) == pytest.approx(2.0)


def test_of_two_dips_towards_a_point_the_first_that_is_deep_enough_counts() -> None:
    # a throw over the point: it passes closest beside it on its way up, and again on its way down
    x, y, vx, vy, pull = -1.05, -1.0, 1.0, 8.0, 8.0
    times = [0.001 * step for step in range(2001)]
    away = [hypot(x + vx * t, y + vy * t - 0.5 * pull * t * t) for t in times]
    first, second = min(away[:1000]), min(away[1000:])
    assert second < first
    for level, start in ((first + 0.01, 0), (0.5 * (first + second), 1000)):
        expected = next(t for t, distance in zip(times[start:], away[start:], strict=True) if distance <= level)
        found = impact.impact_point(0.0, 0.0, x, y, level, vx, vy, 0.0, -pull, 2.0)
        assert found == pytest.approx(expected, abs=0.001)
    assert impact.impact_point(0.0, 0.0, x, y, second - 0.01, vx, vy, 0.0, -pull, 2.0) is None


def test_a_hop_from_a_touch_too_deep_by_rounding_ends_where_it_began() -> None:
    deep = nextafter(1.0, 0.0)
    assert impact.impact_segment(*FLOOR, 5.0, deep, 1.0, 0.0, 1e-9, 0.0, -1.0, 1.0, SLOP) == pytest.approx(2e-9)
    hop = impact.impact_circle(0.0, -5.0, 5.0, 1, 0.0, 1.0 - 1e-15, 1.0, 0.0, 1e-6, 0.0, -1.0, 1.0)
    assert hop == pytest.approx(2e-6, rel=1e-2)
    assert impact.impact_circle(0.0, 0.0, 1.0, 0, 0.0, 1e-13 - 0.5, 0.5, 0.0, 1.0, *STILL, 2.0) == pytest.approx(1.0)


# -- what is known before roots are looked for ---------------------------------------------------------------------


def distances(motion: tuple[float, ...], duration: float) -> NDArray[np.float64]:
    """How far a ball is from the origin at many moments of its fall."""
    px, py, vx, vy, gx, gy = motion
    times = np.linspace(0.0, duration, 3001)[1:]
    away: NDArray[np.float64] = np.hypot(px + (vx + 0.5 * gx * times) * times, py + (vy + 0.5 * gy * times) * times)
    return away


@given(seeds)
def test_what_is_said_to_stay_apart_does_and_what_clearly_does_is_said_to(seed: int) -> None:
    random = np.random.default_rng(seed)
    px, py, vx, vy, gx, gy = motion = tuple(random.uniform(-5, 5, 6).tolist())
    duration, reach = random.uniform(0.05, 1.5), random.uniform(0.1, 6)
    away, path = distances(motion, duration), Path(*motion)
    if any(fall.stays_apart(p, v, g, reach, duration) for p, v, g in ((px, vx, gx), (py, vy, gy))):
        assert away.min() > reach
    if fall.stays_outside(path, reach, duration):
        assert away.min() > reach - 1e-9 or hypot(px, py) <= reach
    if fall.stays_inside(path, reach, duration):
        assert away.max() < reach
    # At rest nothing comes nearer, and a bound that sees nothing of that would be of no use.
    assert fall.stays_outside(Path(9.0, 0.0, 0.0, 0.0, 0.0, -1e-3), 1.0, 1.0)
    assert fall.stays_inside(Path(0.5, 0.0, 0.0, 0.0, 0.0, -1e-3), 1.0, 1.0)


@given(seeds)
def test_a_fall_onto_a_disc_or_a_ring_is_found_where_many_moments_say(seed: int) -> None:
    random = np.random.default_rng(seed)
    px, py, *_ = motion = tuple(random.uniform(-4, 4, 6).tolist())
    away, reach = distances(motion, 2.0), random.uniform(0.2, 1.5)
    if hypot(px, py) > reach + 1e-3:
        found = fall.fall_on_disc(Path(*motion), reach, 2.0)
        first = 2.0 * (np.argmax(away <= reach) + 1) / 3000 if (away <= reach).any() else None
        assert found == (None if first is None else pytest.approx(first, abs=2e-3)) or abs(away.min() - reach) < 1e-4
    r = hypot(px, py) + 2.0
    found = fall.fall_on_ring(Path(*motion), r, 1.0, 2.0)
    first = 2.0 * (np.argmax(away >= r - 1.0) + 1) / 3000 if (away >= r - 1.0).any() else None
    assert found == (None if first is None else pytest.approx(first, abs=2e-3))


@given(seeds)
def test_the_distance_turns_where_the_ball_flies_across(seed: int) -> None:
    random = np.random.default_rng(seed)
    motion = tuple(random.uniform(-4, 4, 6).tolist())
    falls, *turns = fall.distance_turns(Path(*motion), 2.0)
    change = np.diff(distances(motion, 2.0))
    signs = np.flatnonzero(change[:-1] * change[1:] < 0.0)
    assert falls == (change[0] < 0.0)
    assert [turn for turn in turns if turn < 2.0] == pytest.approx((2.0 * (signs + 2) / 3000).tolist(), abs=2e-3)


def test_a_ball_that_overlaps_and_rises_touches_again_from_clear_or_turns_within_the_end_depth() -> None:
    crest = 0.5 * 2.0 * 2.0 / 10.0
    assert fall.fall_from_crest(-crest + 0.1, 2.0, -10.0, 1.0) == pytest.approx(0.2 + (0.2 / 10) ** 0.5)
    assert fall.fall_from_crest(-crest - 0.5e-6, 2.0, -10.0, 1.0) == pytest.approx(0.2)
    assert fall.fall_from_crest(-crest - 2e-6, 2.0, -10.0, 1.0) is None
    assert fall.fall_from_crest(-0.1, -2.0, -10.0, 1.0) is None


# -- how long roots are looked for ---------------------------------------------------------------------------------


@given(seeds)
def test_after_its_escape_a_ball_stays_out_of_reach(seed: int) -> None:
    random = np.random.default_rng(seed)
    px, py, vx, vy, gx, gy = motion = tuple(random.uniform(-5, 5, 6).tolist())
    reach = random.uniform(0.1, 6)
    escape = fall.escape_time(Path(*motion), reach)
    pull = hypot(gx, gy)
    if escape >= 0.0:
        x, y = px + (vx + 0.5 * gx * escape) * escape, py + (vy + 0.5 * gy * escape) * escape
        assert (x * gx + y * gy) / pull == pytest.approx(reach, rel=1e-5)
        assert (vx * gx + vy * gy) / pull + pull * escape >= 0.0
    away = distances((*fall.path_after(Path(*motion), max(escape, 0.0)),), 50.0)
    assert away.min() > reach


def test_a_ball_without_a_pull_never_escapes_and_one_below_has_escaped_at_once() -> None:
    assert fall.escape_time(Path(0.0, 5.0, 1.0, 1.0, 0.0, 0.0), 1.0) == inf
    assert fall.escape_time(Path(0.0, -5.0, 9.0, -1.0, 0.0, -1.0), 1.0) < 0.0
    assert fall.escape_time(Path(0.0, -5.0, 9.0, 1.0, 0.0, -1.0), 1.0) < 0.0


def test_the_distance_from_below_a_throw_turns_three_times() -> None:
    # Thrown up beside the origin: nearest, farthest at its crest, nearest again; and far longer than that.
    falls, *turns = fall.distance_turns(Path(-0.1, -1.0, 0.01, 8.0, 0.0, -8.0), 1e6)
    assert falls
    assert turns == pytest.approx([0.1 + 0.0343, 1.0, 1.8657], abs=1e-2)
    # Without any, and with one that is missing.
    assert fall.distance_turns(Path(0.0, -1.0, 0.0, -1.0, 0.0, -1.0), 5.0) == (False, 5.0, 5.0, 5.0)
    assert fall.distance_turns(Path(0.0, 8.0, 0.0, -1.0, 0.0, 0.0), 5.0) == (True, 5.0, 5.0, 5.0)


def test_a_turn_far_away_and_at_a_standstill_is_found_by_the_place_there() -> None:
    # Along a line through the origin all but straight up to where it stands still, five million kilometres off.
    path = Path(2007473779.5, 4610538565.0, -287.77001474922065, -660.926599277254, 2.0625818963e-05, 4.7372336601e-05)
    _, turn, _, _ = fall.distance_turns(path, 2e7)
    value, slope = fall.outward_rate(path, turn)
    assert abs(value / slope) < 1e-3
