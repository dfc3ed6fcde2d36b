"""Times of impact: worked examples of each kind, touching, leaving, sliding, grazing, bare ends, joints, overflow."""

from math import cos, hypot, inf, nextafter, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.constants import END_DEPTH_CONTINUOUS
from carom.geometry import impact as impacts
from carom.geometry.arc import arc_ends
from carom.geometry.path import Path
from carom.geometry.vector import unit
from tests.flat import flat
from tests.unit.geometry.impact_figures import BOWL, FLOOR, RIGHT_HALF, SLOP, STILL

impact = flat(impacts)

finite = st.floats(allow_nan=False, allow_infinity=False)
positive = st.floats(0.0, allow_infinity=False, exclude_min=True)


# -- straight motion -----------------------------------------------------------------------------------------------


def test_two_balls_meet_by_their_relative_motion() -> None:
    right = (0.0, 0.0, 1.0, 0.0, 2.0, 1.0)
    assert impact.impact_ball(*right, 10.0, 0.0, -3.0, 0.0, 2.0, 1.0, 3.0, 5.0) == 1.75
    assert impact.impact_ball(*right, 10.0, 0.0, 1.0, 0.0, 2.0, 1.0, 3.0, 5.0) is None
    assert impact.impact_ball(0.0, 0.0, *STILL, *STILL, 0.0, 8.0, *STILL, 0.0, -10.0, 3.0, 5.0) == 1.0


# -- falling -------------------------------------------------------------------------------------------------------


# -- touching ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("gravity", [STILL, (0.0, -1.0), (0.0, 1.0)])
def test_a_ball_that_touches_and_approaches_has_its_impact_now(gravity: tuple[float, float]) -> None:
    assert impact.impact_point(0.0, 0.0, 0.0, 1.0, 1.0, 0.5, -1.0, *gravity, 1.0) == 0.0
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 0.5, -1.0, *gravity, 1.0, SLOP) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 6.0, 1.0, 0.5, -1.0, *gravity, 1.0) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, -4.0, 1.0, 0.5, -1.0, *gravity, 1.0) == 0.0
    assert impact.impact_arc(*BOWL, 0.0, -4.0, 1.0, 0.5, -1.0, *gravity, 1.0, SLOP) == 0.0


def test_a_ball_that_overlaps_and_approaches_has_its_impact_now() -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 0.5, 1.0, 0.0, -1.0, *STILL, 1.0, SLOP) == 0.0
    assert impact.impact_segment(*FLOOR, 5.0, 0.0, 1.0, 0.0, -1.0, *STILL, 1.0, SLOP) == 0.0
    assert impact.impact_segment(*FLOOR, 5.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 1.0, SLOP) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 5.0, 1.0, 0.0, 1.0, *STILL, 1.0) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 5.0, 1.0, 0.0, -1.0, *STILL, 1.0) == 0.0


@pytest.mark.parametrize("gravity", [STILL, (0.0, 1.0)])
def test_a_ball_that_touches_and_leaves_has_none(gravity: tuple[float, float]) -> None:
    assert impact.impact_point(0.0, 0.0, 0.0, 1.0, 1.0, 0.5, 1.0, *gravity, 1.0) is None
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 0.5, 1.0, *gravity, 1.0, SLOP) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 6.0, 1.0, 0.5, 1.0, *gravity, 1.0) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, -4.0, 1.0, 0.5, 1.0, *gravity, 1.0) is None
    assert impact.impact_arc(*BOWL, 0.0, -4.0, 1.0, 0.5, 1.0, *gravity, 1.0, SLOP) is None


@pytest.mark.parametrize("noise", [0.0, 5e-16, -5e-16])
def test_a_ball_that_slides_on_a_flat_or_bulging_surface_has_none(noise: float) -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 1.0, noise, *STILL, 1.0, SLOP) is None
    assert impact.impact_point(0.0, 0.0, 0.0, 1.0, 1.0, 1.0, noise, *STILL, 1.0) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 0.0, 6.0, 1.0, 1.0, noise, *STILL, 1.0) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 0.0, nextafter(6.0, 0.0), 1.0, 1.0, noise, *STILL, 1.0) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 0.0, 6.0, 1.0, 1.0, noise, 0.0, -0.1, 1.0) is None


@pytest.mark.parametrize("noise", [0.0, 5e-16, -5e-16])
def test_a_ball_pressed_to_a_surface_has_its_impact_now(noise: float) -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 1.0, noise, 0.0, -1.0, 1.0, SLOP) == 0.0
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 0.0, 0.0, 0.0, -1.0, 1.0, SLOP) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 0.0, 6.0, 1.0, 1.0, noise, 0.0, -0.2, 1.0) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, -4.0, 1.0, 1.0, noise, 0.0, -0.2, 1.0) == 0.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, -4.0, 1.0, 1.0, noise, *STILL, 1.0) == 0.0


def test_a_chord_from_a_touch_too_deep_by_rounding_ends_as_deep() -> None:
    deep, flat = nextafter(-4.0, -5.0), 1e-9
    chord = impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, deep, 1.0, cos(flat), sin(flat), *STILL, 1.0)
    assert chord == pytest.approx(8e-9)


# -- bare ends -----------------------------------------------------------------------------------------------------


def test_a_ball_that_comes_over_a_bare_end_passes() -> None:
    assert impact.impact_segment(*FLOOR, -1.0, 1.4, 1.0, 2.0, -1.0, *STILL, 9.0, SLOP) is None
    assert impact.impact_segment(*FLOOR, -1.0, 1.4, 1.0, 2.0, -1.0, 0.0, -0.1, 9.0, SLOP) is None
    assert impact.impact_arc(*RIGHT_HALF, -1.0, 6.4, 1.0, 2.0, -1.0, *STILL, 1.0, SLOP) is None
    assert impact.impact_arc(*RIGHT_HALF, -1.0, 6.4, 1.0, 2.0, -1.0, 0.0, -0.1, 1.0, SLOP) is None


def test_a_ball_that_overlaps_past_an_end_passes() -> None:
    assert impact.impact_segment(*FLOOR, -0.5, 0.5, 1.0, 1.0, -0.1, *STILL, 9.0, SLOP) is None
    assert impact.impact_segment(*FLOOR, -0.5, 0.5, 1.0, 1.0, 0.1, 0.0, -0.2, 2.0, SLOP) is None
    assert impact.impact_arc(*RIGHT_HALF, -0.5, 5.5, 1.0, 1.0, -0.1, *STILL, 2.0, SLOP) is None
    assert impact.impact_arc(*BOWL, -5.3, 0.5, 1.0, 0.0, -1.0, 0.0, -1.0, 1.0, SLOP) is None


@pytest.mark.parametrize("gravity", [STILL, (0.0, -1e-12)])
def test_an_end_reaches_as_far_as_the_slop(gravity: tuple[float, float]) -> None:
    assert impact.impact_segment(*FLOOR, -0.9e-9, 2.0, 1.0, 0.0, -1.0, *gravity, 9.0, SLOP) is not None
    assert impact.impact_segment(*FLOOR, 10.0 + 0.9e-9, 2.0, 1.0, 0.0, -1.0, *gravity, 9.0, SLOP) is not None
    assert impact.impact_segment(*FLOOR, -1.1e-9, 2.0, 1.0, 0.0, -1.0, *gravity, 9.0, SLOP) is None
    assert impact.impact_segment(*FLOOR, 10.0 + 1.1e-9, 2.0, 1.0, 0.0, -1.0, *gravity, 9.0, SLOP) is None
    assert impact.impact_arc(*RIGHT_HALF, -0.9e-9, 7.0, 1.0, 0.0, -1.0, *gravity, 9.0, SLOP) is not None
    assert impact.impact_arc(*RIGHT_HALF, -1.1e-9, 7.0, 1.0, 0.0, -1.0, *gravity, 2.0, SLOP) is None


@pytest.mark.parametrize("gravity", [STILL, (0.0, -1e-12)])
def test_a_ball_that_overlaps_by_less_than_the_end_depth_touches_at_the_end(gravity: tuple[float, float]) -> None:
    steep, flat = 4.0 * END_DEPTH_CONTINUOUS, 0.5 * END_DEPTH_CONTINUOUS
    # its foot is at the end after one second, when it overlaps by `steep` or `flat`
    assert impact.impact_segment(*FLOOR, -1.0, 1.0, 1.0, 1.0, -steep, *gravity, 9.0, SLOP) is None
    over = impact.impact_segment(*FLOOR, -1.0, 1.0, 1.0, 1.0, -flat, *gravity, 9.0, SLOP)
    assert over == pytest.approx(1.0, abs=1e-8)
    over = impact.impact_segment(*FLOOR, 11.0, -1.0, 1.0, -1.0, flat, *gravity, 9.0, SLOP)
    assert over == pytest.approx(1.0, abs=1e-8)
    # the same over both ends of an arc, a tenth of a second before
    assert impact.impact_arc(*RIGHT_HALF, -0.1, 6.0, 1.0, 1.0, -10.0 * steep, *gravity, 1.0, SLOP) is None
    for y, rate in ((6.0, -10.0 * flat), (-6.0, 10.0 * flat)):
        over = impact.impact_arc(
            *RIGHT_HALF, -0.1, y - 0.1 * rate - (y * flat / 6.0), 1.0, 1.0, rate, *gravity, 1.0, SLOP
        )
        assert over == pytest.approx(0.1, abs=1e-8)


def test_a_ball_that_dips_past_an_end_and_rises_over_it_does_not_touch() -> None:
    # its gap is 1e-6·(t - 1)² - 5e-7, and its foot is at the end when t is 1.3
    assert impact.impact_segment(*FLOOR, -1.3, 1.0 + 5e-7, 1.0, 1.0, -2e-6, 0.0, 2e-6, 9.0, SLOP) is None


def test_a_ball_that_has_passed_the_gap_of_an_arc_touches_its_inside_not_before_it_touches() -> None:
    # it comes into the sector clear of the inside by less than the end depth
    x, y, vx, vy = -10.0, 4.0 - 5e-7 - 1e-2, 1.0, 1e-3
    for pull in (0.0, 1e-12):
        time = impact.impact_arc(*RIGHT_HALF, x, y, 1.0, vx, vy, 0.0, -pull, 20.0, SLOP)
        assert time is not None
        assert hypot(x + vx * time, y + vy * time) == pytest.approx(4.0, abs=1e-9)


def test_a_ball_that_rises_past_an_end_and_turns_over_it_all_but_clear_touches_there() -> None:
    for short in (1e-7, 0.0):
        rest = (1.0, 1.0, 1.0, 0.0, -1.0, 9.0, SLOP)
        assert impact.impact_segment(*FLOOR, -1.0, 0.5 - short, *rest) == pytest.approx(1.0, abs=1e-6)
        assert impact.impact_arc(*RIGHT_HALF, -1.0, 5.5 - short, *rest) == pytest.approx(1.0, abs=1e-6)
    deep = (1.0, 1.0, 1.0, 0.0, -1.0, 1.2, SLOP)
    assert impact.impact_segment(*FLOOR, -1.0, 0.5 - 1e-5, *deep) is None
    assert impact.impact_arc(*RIGHT_HALF, -1.0, 5.5 - 1e-5, *deep) is None


def test_a_ball_that_slides_off_a_wall_into_a_bowl_touches_at_the_joint() -> None:
    for pull in (0.0, 1e-12):
        for sink in (0.0, 1e-7):
            slide = impact.impact_arc(*RIGHT_HALF, -2.0, -4.0 - sink, 1.0, 1.0, 0.0, 0.0, -pull, 9.0, SLOP)
            assert slide == pytest.approx(2.0)
        assert impact.impact_arc(*RIGHT_HALF, -2.0, -4.0 - 1e-5, 1.0, 1.0, 0.0, 0.0, -pull, 9.0, SLOP) is None


def test_a_ball_that_skips_along_two_arcs_of_one_circle_touches_the_second() -> None:
    # too deep by rounding and leaving flatly, in the first sector, its chord ends in the second
    second = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 1.5 * pi + 1e-10, 2.5 * pi))
    for slope, pull in ((1e-9, 0.0), (1e-6, 0.0), (1e-6, 1e-9)):
        leaves = (1.0, cos(slope), sin(slope))
        chord = impact.impact_arc(*second, 0.0, nextafter(-4.0, -5.0), *leaves, 0.0, -pull, 1.0, 0.0)
        assert chord == pytest.approx(8.0 * slope, rel=1e-2)


# -- far, fast, small, large ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("away", [1e2, 1e5, 1e8])
@pytest.mark.parametrize("pull", [0.0, 1e-3])
def test_a_small_ball_from_far_away_hits_to_the_last_digits(away: float, pull: float) -> None:
    radius, offset, duration = 0.5, 0.3, 2.0
    vx, vy = -away, 0.5 * pull
    time = impact.impact_point(0.0, 0.0, away, offset, radius, vx, vy, 0.0, -pull, duration)
    assert time is not None
    x, y = away + vx * time, offset + vy * time - 0.5 * pull * time * time
    assert hypot(x, y) == pytest.approx(radius, abs=1e-15 * away)
    assert x > 0.0


def test_a_ball_that_fills_a_circle_touches_as_soon_as_it_leaves_the_middle() -> None:
    assert impact.impact_circle(0.0, 0.0, 1.0, 0, 0.1, 0.0, 2.0, 1.0, 0.0, *STILL, 1.0) == 0.0
    assert impact.impact_circle(0.0, 0.0, 1.0, 0, 0.1, 0.0, 2.0, -1.0, 0.0, *STILL, 1.0) == pytest.approx(0.2)
    assert impact.impact_circle(0.0, 0.0, 1.0, 0, 0.1, 0.0, 2.0, -1.0, 0.0, 0.0, -1e-9, 1.0) == pytest.approx(0.2)


def test_a_ball_at_rest_has_no_impact() -> None:
    for place in ((0.0, 0.0), (0.0, 1.0), (0.0, 4.0), (0.0, 6.0), (0.0, 7.0)):
        assert impact.impact_point(0.0, 0.0, *place, 1.0, *STILL, *STILL, 1.0) is None
        assert impact.impact_segment(*FLOOR, *place, 1.0, *STILL, *STILL, 1.0, SLOP) is None
        assert impact.impact_circle(0.0, 0.0, 5.0, 0, *place, 1.0, *STILL, *STILL, 1.0) is None
        assert impact.impact_arc(*RIGHT_HALF, *place, 1.0, *STILL, *STILL, 1.0, SLOP) is None


def test_nothing_happens_in_no_time_but_to_what_touches() -> None:
    assert impact.impact_point(0.0, 0.0, 0.0, 3.0, 1.0, 0.0, -1.0, 0.0, -1.0, 0.0) is None
    assert impact.impact_point(0.0, 0.0, 0.0, 3.0, 1.0, 0.0, -1.0, *STILL, 0.0) is None
    assert impact.impact_segment(*FLOOR, 5.0, 1.0, 1.0, 0.0, -1.0, 0.0, -1.0, 0.0, SLOP) == 0.0


@given(st.lists(finite, min_size=17, max_size=17), positive, positive, positive, st.booleans(), st.booleans())
def test_no_finite_numbers_make_nan_or_an_exception(
    numbers: list[float], radius: float, r: float, duration: float, solid: bool, falls: bool
) -> None:
    x, y, vx, vy, cx, cy, ax, ay, bx, by = numbers[:10]
    gx, gy = numbers[10:12] if falls else STILL
    motion = (x, y, radius, vx, vy, gx, gy, duration)
    tx, ty = unit(ax, ay) or (1.0, 0.0)
    found = [
        impact.impact_point(cx, cy, *motion),
        impact.impact_segment(cx, cy, tx, ty, r, *motion, 1e-9 * radius),
        impact.impact_circle(cx, cy, r, int(solid), *motion),
        impact.impact_arc(cx, cy, r, ax, ay, bx, by, *motion, 1e-9 * radius),
        impacts.impact_ball(Path(cx, cy, ax, ay, *STILL), Path(x, y, vx, vy, gx, gy), r + radius, duration),
    ]
    assert all(time is None or 0.0 <= time <= duration < inf for time in found)
