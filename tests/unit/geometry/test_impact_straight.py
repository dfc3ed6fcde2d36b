"""Impacts of balls that fly straight: worked examples of each kind."""

from math import hypot, nextafter, sqrt
from random import Random

import pytest
from hypothesis import given

from carom.geometry import impact as impacts
from carom.geometry import impact_straight as straight
from carom.geometry.path import Path
from tests.flat import flat
from tests.strategies import seeds
from tests.unit.geometry.impact_figures import FLOOR, RIGHT_HALF, SLOP, STILL

impact = flat(impacts)


def straight_on(x: float, y: float, vx: float, vy: float) -> Path:
    """A path without acceleration."""
    return Path(x, y, vx, vy, 0.0, 0.0)


def test_a_ball_meets_a_point_head_on() -> None:
    assert impact.impact_point(10.0, 0.0, 0.0, 0.0, 1.0, 3.0, 0.0, *STILL, 5.0) == 3.0


def test_a_ball_meets_a_point_off_its_line() -> None:
    assert impact.impact_point(10.0, 3.0, 0.0, 0.0, 5.0, 2.0, 0.0, *STILL, 5.0) == 3.0


def test_a_ball_whose_line_passes_a_point_at_its_radius_only_grazes_it() -> None:
    assert impact.impact_point(10.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, *STILL, 50.0) is None


def test_a_ball_that_stops_short_has_no_impact() -> None:
    assert impact.impact_point(10.0, 0.0, 0.0, 0.0, 1.0, 3.0, 0.0, *STILL, 3.0) == 3.0
    assert impact.impact_point(10.0, 0.0, 0.0, 0.0, 1.0, 3.0, 0.0, *STILL, nextafter(3.0, 0.0)) is None
    assert impact.impact_segment(*FLOOR, 5.0, 3.0, 1.0, 0.0, -1.0, *STILL, 1.9, SLOP) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 0.0, 1.0, 1.0, 0.0, *STILL, 3.9) is None


def test_a_segment_is_met_from_both_sides() -> None:
    assert impact.impact_segment(*FLOOR, 5.0, 3.0, 1.0, 0.5, -1.0, *STILL, 5.0, SLOP) == 2.0
    assert impact.impact_segment(*FLOOR, 5.0, -3.0, 1.0, 0.5, 1.0, *STILL, 5.0, SLOP) == 2.0


def test_a_circle_is_met_from_outside_and_from_inside() -> None:
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, -10.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) == 2.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 0.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) == 2.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, -2.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) == 3.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 0, 2.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) == 1.0


def test_a_solid_circle_is_met_from_outside_alone() -> None:
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, -10.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) == 2.0
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 2.0, 0.0, 1.0, 2.0, 0.0, *STILL, 5.0) is None
    assert impact.impact_circle(0.0, 0.0, 5.0, 1, 2.0, 0.0, 1.0, -2.0, 0.0, *STILL, 5.0) == 0.0


def test_an_arc_is_met_within_its_sector() -> None:
    assert impact.impact_arc(*RIGHT_HALF, 10.0, 0.0, 1.0, -2.0, 0.0, *STILL, 9.0, SLOP) == 2.0
    assert impact.impact_arc(*RIGHT_HALF, 0.0, 0.0, 1.0, 2.0, 0.0, *STILL, 9.0, SLOP) == 2.0
    assert impact.impact_arc(*RIGHT_HALF, 0.0, 0.0, 1.0, -2.0, 0.0, *STILL, 9.0, SLOP) is None


def test_a_ball_that_comes_in_by_the_gap_of_an_arc_meets_its_inside() -> None:
    assert impact.impact_arc(*RIGHT_HALF, -10.0, 0.0, 1.0, 2.0, 0.0, *STILL, 9.0, SLOP) == 7.0


def test_the_touch_of_a_ball_inside_a_circle_hardly_larger_than_it_is_exact() -> None:
    time = impact.impact_circle(0.0, 0.0, 1.0 + 1e-9, 0, 0.0, 0.0, 1.0, 3.0, 4.0, *STILL, 1.0)
    assert time == pytest.approx(((1.0 + 1e-9) - 1.0) / 5.0, rel=1e-14)


@given(seeds)
def test_a_straight_way_touches_a_disc_or_a_bowl_where_the_triangle_says(seed: int) -> None:
    random = Random(seed)
    px, py, vx, vy = (random.uniform(-4, 4) for _ in range(4))
    reach, speed, away = random.uniform(0.2, 3), hypot(vx, vy), hypot(px, py)
    middle, offset = -(px * vx + py * vy) / speed, abs(px * vy - py * vx) / speed
    found = straight.reach_disc(straight_on(px, py, vx, vy), reach, 9.0)
    if away > reach:
        meets = offset < reach and middle > 0.0
        time = (middle - sqrt(max(reach * reach - offset * offset, 0.0))) / speed
        assert found == (pytest.approx(time) if meets and time <= 9.0 else None)
    room = away + random.uniform(0.1, 2)
    found = straight.reach_bowl(straight_on(px, py, vx, vy), room, 9.0)
    time = (middle + sqrt(room * room - offset * offset)) / speed
    assert found == (pytest.approx(time) if time <= 9.0 else None)


def test_a_ball_beside_its_line_reaches_a_segment_when_its_gap_is_closed() -> None:
    assert straight.reach_line(straight_on(1.0, 3.0, 3.0, -4.0), 10.0, 1.0, 9.0, 1e-9) == 0.5
    assert straight.reach_line(straight_on(9.0, 3.0, 3.0, -4.0), 10.0, 1.0, 9.0, 1e-9) is None
    assert straight.reach_line(straight_on(1.0, 3.0, 3.0, -4.0), 10.0, 1.0, 0.4, 1e-9) is None


def test_a_ball_that_touches_from_inside_is_pressed_on_at_once_or_after_a_chord() -> None:
    # Outwards, and along the tangent but for rounding, at once; inwards after a chord of the circle that it is on.
    for vx, vy in ((1.0, 3.0), (0.0, 3.0), (-1e-16, 3.0)):
        assert straight.reach_bowl(straight_on(4.0, 0.0, vx, vy), 4.0, 9.0) == 0.0
    assert straight.reach_bowl(straight_on(4.0, 0.0, -3.0, 4.0), 4.0, 9.0) == pytest.approx(2 * 4.0 * 3.0 / 25.0)
    # Deeper than that circle it is as deep again.
    for px, room in ((4.5, 4.0), (0.5, -1.0)):
        assert straight.reach_bowl(straight_on(px, 0.0, -0.1, 3.0), room, 9.0) == pytest.approx(2 * px * 0.1 / 9.01)
    assert straight.reach_bowl(straight_on(1.0, 0.0, 0.0, 0.0), 4.0, 9.0) is None


def test_a_ball_that_overlaps_a_disc_is_pressed_on_at_once_unless_it_slides_or_leaves() -> None:
    assert straight.reach_disc(straight_on(3.0, 0.0, -1.0, 1.0), 4.0, 9.0) == 0.0
    for vx, vy in ((1.0, 1.0), (0.0, 1.0), (-1e-16, 1.0)):
        assert straight.reach_disc(straight_on(3.0, 0.0, vx, vy), 4.0, 9.0) is None
