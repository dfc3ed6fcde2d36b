"""Touches with shapes that turn: worked examples, tips and stops, speeds that would tunnel, and the search's limits."""

from math import asin, cos, hypot, inf, pi, sin
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.constants import END_DEPTH_CONTINUOUS
from carom.geometry import advance as advances
from carom.geometry.arc import arc_ends
from carom.geometry.path import Path, Turning, path_after, path_beside
from carom.geometry.vector import rotated, unit
from tests.flat import flat
from tests.naive_impact import Carriage, Flight, carom_advance, gap
from tests.strategies import Figure, seeds
from tests.unit.geometry.impact_figures import SLOP, STILL

advance = flat(advances)
ORIGIN = (0.0, 0.0, 0.0, 0.0)
HAND = (0.0, 0.0, 1.0, 0.0, 10.0)
finite = st.floats(allow_nan=False, allow_infinity=False)
positive = st.floats(0.0, allow_infinity=False, exclude_min=True)


def test_a_turning_segment_hits_a_ball_at_rest() -> None:
    # the hand of a clock, at a right angle to the ball's place, meets it when the angle's sine is radius/distance
    time = advance.advance_segment(*HAND, *ORIGIN, 2.0, 0.0, 5.0, 3.0, *STILL, *STILL, 1.0, SLOP)
    assert time == pytest.approx((0.5 * pi - 0.643501108793284386802809228717) / 2.0, rel=1e-15)


def test_it_hits_with_its_other_side_when_it_turns_the_other_way() -> None:
    time = advance.advance_segment(*HAND, *ORIGIN, -2.0, 0.0, -5.0, 3.0, *STILL, *STILL, 1.0, SLOP)
    assert time == pytest.approx((0.5 * pi - 0.643501108793284386802809228717) / 2.0, rel=1e-15)


def test_a_ball_out_of_its_reach_is_not_hit() -> None:
    assert advance.advance_segment(*HAND, *ORIGIN, 2.0, 0.0, 12.0, 1.0, *STILL, *STILL, 1.0, SLOP) is None


def test_a_ball_that_is_in_time_ahead_of_it_is_not_hit() -> None:
    # it runs round the pivot as fast as the hand turns, a quarter of a turn ahead
    assert advance.advance_segment(*HAND, *ORIGIN, 0.1, 0.0, 5.0, 1.0, -0.6, 0.0, *STILL, 0.5, SLOP) is None


@pytest.mark.parametrize("spin", [1e3, -1e3, 1e6, 1e8])
def test_no_spin_is_so_fast_that_it_tunnels(spin: float) -> None:
    time = advance.advance_segment(*HAND, *ORIGIN, spin, 0.0, 5.0, 0.1, *STILL, *STILL, 1.0, SLOP)
    quarter = 0.5 * pi if spin > 0.0 else 1.5 * pi
    assert time is not None
    assert time * abs(spin) == pytest.approx(quarter - 0.02, abs=1e-4)


def test_no_ball_is_so_fast_that_it_tunnels() -> None:
    time = advance.advance_segment(*HAND, *ORIGIN, 1e-3, 5.0, 5e5, 0.1, 0.0, -1e6, *STILL, 1.0, SLOP)
    assert time is not None
    assert 5e5 - 1e6 * time == pytest.approx(0.1, abs=0.01)


def test_a_tip_is_no_segment_and_the_point_on_it_is_hit_instead() -> None:
    # the ball is beyond the hand's end, by less than its radius
    ball = (0.0, 10.5, 1.0, *STILL, *STILL, 1.0)
    assert advance.advance_segment(*HAND, *ORIGIN, 2.0, *ball, SLOP) is None
    time = advance.advance_point(10.0, 0.0, *ORIGIN, 2.0, *ball)
    assert time is not None
    tip = (10.0 * cos(2.0 * time), 10.0 * sin(2.0 * time))
    assert hypot(tip[0], tip[1] - 10.5) == pytest.approx(1.0, rel=1e-14)


def test_a_moving_pivot_takes_the_shape_along() -> None:
    still = advance.advance_segment(*HAND, *ORIGIN, 2.0, 1.0, 5.0, 1.0, 0.0, -1.0, *STILL, 1.0, SLOP)
    moving = advance.advance_segment(*HAND, 0.0, 0.0, 7.0, -3.0, 2.0, 1.0, 5.0, 1.0, 7.0, -4.0, *STILL, 1.0, SLOP)
    assert moving == still
    assert still is not None


def test_a_circle_on_an_arm_is_met_from_outside_and_inside() -> None:
    outside = advance.advance_circle(10.0, 0.0, 2.0, 0, *ORIGIN, 2.0, 0.0, 10.0, 1.0, *STILL, *STILL, 1.0)
    assert outside == pytest.approx((0.5 * pi - 2.0 * asin(3.0 / 20.0)) / 2.0, rel=1e-14)
    inside = advance.advance_circle(10.0, 0.0, 2.0, 0, *ORIGIN, 2.0, 10.0, 0.0, 1.0, *STILL, *STILL, 1.0)
    assert inside == pytest.approx(2.0 * asin(1.0 / 20.0) / 2.0, rel=1e-14)
    solid = advance.advance_circle(10.0, 0.0, 2.0, 1, *ORIGIN, 2.0, 10.0, 0.0, 1.0, *STILL, *STILL, 1.0)
    assert solid is None


def test_a_circle_that_turns_about_its_centre_is_met_in_closed_form() -> None:
    time = advance.advance_circle(1.0, 2.0, 2.0, 0, 1.0, 2.0, 0.0, 0.0, 50.0, 8.0, 2.0, 1.0, -2.0, 0.0, *STILL, 9.0)
    assert time == 2.0
    assert advance.advance_point(1.0, 2.0, 1.0, 2.0, 0.0, 0.0, 50.0, 8.0, 2.0, 1.0, -2.0, 0.0, *STILL, 9.0) == 3.0


def test_a_ball_that_fills_a_turning_circle_touches_as_soon_as_it_leaves_the_middle() -> None:
    ball = (10.0, 0.5, 3.0, 0.0, 1.0, *STILL, 1.0)
    assert advance.advance_circle(10.0, 0.0, 2.0, 0, *ORIGIN, 1e-3, *ball) == 0.0
    ball = (10.0, 0.5, 3.0, 0.0, -1.0, *STILL, 1.0)
    assert advance.advance_circle(10.0, 0.0, 2.0, 0, *ORIGIN, 1e-3, *ball) is None


def test_an_arc_that_turns_its_gap_away_is_hit() -> None:
    gap_right = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 0.1, -0.1))
    runner = (0.0, 0.0, 1.0, 8.0, 0.0, *STILL, 1.0)
    assert advance.advance_arc(*gap_right, *ORIGIN, 1e-6, *runner, SLOP) is None
    assert advance.advance_arc(*gap_right, *ORIGIN, 1.0, *runner, SLOP) == pytest.approx(0.5, rel=1e-14)
    assert advance.advance_arc(*gap_right, *ORIGIN, -1.0, *runner, SLOP) == pytest.approx(0.5, rel=1e-14)


def test_an_arc_is_hit_from_outside_too() -> None:
    bowl = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, pi, 0.0))
    assert advance.advance_arc(*bowl, *ORIGIN, 1.0, 0.0, 10.0, 1.0, 0.0, -4.0, *STILL, 0.9, SLOP) is None
    assert advance.advance_arc(*bowl, *ORIGIN, 3.0, 0.0, 10.0, 1.0, 0.0, -4.0, *STILL, 2.0, SLOP) == pytest.approx(1.0)


def test_a_touch_that_approaches_is_now_and_one_that_leaves_is_none() -> None:
    touching = (5.0, 1.0, 1.0)
    assert advance.advance_segment(*HAND, *ORIGIN, 1.0, *touching, 0.0, 4.9, *STILL, 0.01, SLOP) == 0.0
    assert advance.advance_segment(*HAND, *ORIGIN, 1.0, *touching, 0.0, 5.1, *STILL, 0.01, SLOP) is None
    assert advance.advance_segment(*HAND, *ORIGIN, -1.0, *touching, *STILL, *STILL, 0.01, SLOP) is None


def test_a_ball_that_slides_on_a_turning_hand_to_rounding_has_none() -> None:
    # it runs along with the hand, slower by rounding, while the hand turns away from its straight way
    speed = 5.0 * (1.0 - 1e-15)
    assert advance.advance_segment(*HAND, *ORIGIN, 1.0, 5.0, 1.0, 1.0, -2.0, speed, *STILL, 0.01, SLOP) is None


def test_a_hop_that_never_gets_clear_ends_as_deep_as_it_began() -> None:
    ball = (5.0, 0.9, 1.0, 0.0, 0.5, 0.0, -10.0, 1.0)
    assert advance.advance_segment(*HAND, *ORIGIN, 1e-12, *ball, SLOP) == pytest.approx(0.1, rel=1e-9)
    quarter = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 0.25 * pi, 0.75 * pi))
    ball = (0.0, 5.9, 1.0, 0.0, 0.5, 0.0, -10.0, 1.0)
    assert advance.advance_arc(*quarter, *ORIGIN, 1e-12, *ball, SLOP) == pytest.approx(0.1, rel=1e-9)


def test_a_ball_that_a_turning_hand_flings_off_and_gravity_brings_back_is_hit_again() -> None:
    time = advance.advance_segment(*HAND, *ORIGIN, 0.1, 5.0, 1.0, 1.0, 0.0, 2.0, 0.0, -10.0, 1.0, SLOP)
    assert time is not None
    assert time == pytest.approx(2.0 * 1.5 / 10.0, abs=0.02)


def test_a_ball_that_comes_over_a_turning_end_passes() -> None:
    ball = (10.5, 0.5, 1.0, -1.0, 0.0, *STILL, 1.0)
    assert advance.advance_segment(*HAND, *ORIGIN, 0.05, *ball, SLOP) is None
    quarter = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 0.0, 0.5 * pi))
    assert advance.advance_arc(*quarter, *ORIGIN, 0.05, 5.2, -0.5, 1.0, 0.0, 1.0, *STILL, 1.0, SLOP) is None


@pytest.mark.parametrize("depth", [0.5, 4.0])
def test_an_end_depth_decides_whether_it_passes(depth: float) -> None:
    # seen from the hand, the ball comes along its line, all but touching, over the end after a tenth of a second
    spin, overlap = 1e-12, depth * END_DEPTH_CONTINUOUS
    ball = (10.1, 1.0, 1.0, -1.0, -10.0 * overlap, *STILL, 1.0)
    time = advance.advance_segment(*HAND, *ORIGIN, spin, *ball, SLOP)
    assert time == (None if depth > 1.0 else pytest.approx(0.1, rel=1e-7))
    quarter = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 0.0, 0.5 * pi))
    ball = (6.0, -0.1, 1.0, -10.0 * overlap, 1.0, *STILL, 1.0)
    time = advance.advance_arc(*quarter, *ORIGIN, spin, *ball, SLOP)
    assert time == (None if depth > 1.0 else pytest.approx(0.1, rel=1e-7))


def test_a_search_that_takes_too_many_steps_stops_where_the_ball_is_clear() -> None:
    # the ball runs round the pivot with the hand, closer to it than the depth that may go unseen, for ever so long
    near = 1.0 + 1e-12
    time = advance.advance_segment(*HAND, *ORIGIN, 1e7, 0.0, near, 1.0, -1e7 * near, 0.0, *STILL, 1e6, SLOP)
    assert time is None or time >= 0.0


@given(st.lists(finite, min_size=16, max_size=16), positive, positive, positive, st.booleans())
def test_no_finite_numbers_make_nan_or_an_exception(
    numbers: list[float], radius: float, r: float, duration: float, solid: bool
) -> None:
    x, y, vx, vy, gx, gy, cx, cy, ax, ay, bx, by = numbers[:12]
    carriage = (*numbers[12:15], ay, numbers[15])
    motion = (x, y, radius, vx, vy, gx, gy, duration)
    tx, ty = unit(ax, ay) or (1.0, 0.0)
    found = [
        advance.advance_point(cx, cy, *carriage, *motion),
        advance.advance_segment(cx, cy, tx, ty, r, *carriage, *motion, 1e-9 * radius),
        advance.advance_circle(cx, cy, r, int(solid), *carriage, *motion),
        advance.advance_arc(cx, cy, r, ax, ay, bx, by, *carriage, *motion, 1e-9 * radius),
    ]
    assert all(time is None or 0.0 <= time <= duration for time in found)


@pytest.mark.parametrize(
    "figure",
    [
        ("point", (5.0, 0.0)),
        ("segment", (0.0, 0.0, 10.0, 0.0)),
        ("circle", (5.0, 0.0, 2.0)),
        ("arc", (5.0, 0.0, 2.0, 0.5 * pi, 1.5 * pi)),
    ],
    ids=["point", "segment", "circle", "arc"],
)
@given(seeds)
def test_a_search_goes_on_from_any_time_of_a_path_as_from_its_start(figure: Figure, seed: int) -> None:
    random = Random(seed)
    spin, radius, share = random.uniform(-3.0, 3.0), random.uniform(0.1, 0.5), random.random()
    path = Path(*(random.uniform(-12.0, 12.0) for _ in range(6)))
    flight = Flight(path.x, path.y, radius, *path[2:], 2.0)
    time = carom_advance(figure, flight, Carriage(0.0, 0.0, 1.0, -1.0, spin), SLOP)
    # What overlaps at first is met when it gets deeper than it was then, so not from a later time as from an earlier.
    if time is None or gap(figure, radius, path.x, path.y) < 1e-6:
        return
    # All as seen at that time by one who travels with the pivot and turns with the shape.
    later = share * time
    x, y, vx, vy, gx, gy = path_after(path_beside(path, Turning(0.0, 0.0, 1.0, -1.0, spin)), later)
    turn = cos(spin * later), -sin(spin * later)
    x, y = rotated(x, y, *turn)
    rest = Flight(x, y, radius, *rotated(vx, vy, *turn), *rotated(gx, gy, *turn), 2.0 - later)
    found = carom_advance(figure, rest, Carriage(0.0, 0.0, 0.0, 0.0, spin), SLOP)
    if gap(figure, radius, x, y) > 1e-6:
        assert found is not None
        assert later + found == pytest.approx(time, rel=1e-6)


def test_without_an_end_what_turns_is_not_looked_for_and_what_does_not_is() -> None:
    ball = (5.0, 3.0, 1.0, 0.0, -1.0, *STILL, inf)
    assert advance.advance_segment(*HAND, *ORIGIN, 2.0, *ball, SLOP) is None
    assert advance.advance_segment(*HAND, *ORIGIN, 0.0, *ball, SLOP) == 2.0
