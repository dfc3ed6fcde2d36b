"""Arcs: sectors to the last digit, middles, lengths, ends, tangents and nearest points."""

from math import atan2, cos, hypot, nextafter, pi, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import arc as arcs_
from carom.geometry.angle import sweep
from tests import naive
from tests.flat import flat
from tests.strategies import angles, arcs, fractions, points, radii

arc = flat(arcs_)
Arc = tuple[float, float, float, float, float]
Vector = tuple[float, float]
SIZES = (1e-150, 1e-8, 1.0, 3.0, 1e8, 1e150)


def rays(start: float, end: float, size: float = 1.0) -> tuple[float, float, float, float]:
    """The ends of a sector, relative to its centre."""
    return size * cos(start), size * sin(start), size * cos(end), size * sin(end)


@given(arcs(), angles, radii)
def test_a_sector_is_that_by_angles(given_: Arc, angle: float, away: float) -> None:
    start, end = given_[3:]
    assume(min(naive.between(angle, start), naive.between(angle, end)) > 1e-14)
    x, y = away * cos(angle), away * sin(angle)
    assert arc.in_sector(*rays(start, end), x, y) is naive.in_sector(start, end, x, y)


@given(arcs(), st.sampled_from(SIZES), st.sampled_from(SIZES))
def test_bounding_rays_belong_to_the_sector(given_: Arc, size: float, away: float) -> None:
    ends = rays(*given_[3:], size)
    ax, ay, bx, by = rays(*given_[3:], away)
    assert arc.in_sector(*ends, ax, ay)
    assert arc.in_sector(*ends, bx, by)
    assert arc.in_sector(*ends, *arc.middle_direction(*ends))


@given(arcs())
def test_the_opposite_of_the_middle_is_outside(given_: Arc) -> None:
    x, y = arc.middle_direction(*rays(*given_[3:]))
    assert not arc.in_sector(*rays(*given_[3:]), -x, -y)


@pytest.mark.parametrize("quarter", [0, 1, 2, 3])
def test_angles_that_are_quarters_of_a_turn_hold_the_axes(quarter: int) -> None:
    axes = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
    start, end = quarter * 0.5 * pi, (quarter + 1) % 4 * 0.5 * pi
    for other, axis in enumerate(axes):
        assert arc.in_sector(*rays(start, end), *axis) is (other in {quarter, (quarter + 1) % 4})
        assert arc.in_sector(*rays(end, start), *axis)


def test_half_a_turn_is_half_the_plane() -> None:
    for x in (-1.0, 0.0, 1.0):
        assert arc.in_sector(1.0, 0.0, -1.0, 0.0, x, 0.5)
        assert arc.in_sector(1.0, 0.0, -1.0, 0.0, x, -0.5) is False
        assert arc.in_sector(-1.0, 0.0, 1.0, 0.0, x, -0.5)
    assert arc.in_sector(1.0, 0.0, -1.0, 0.0, -5.0, 0.0)
    assert arc.in_sector(1.0, 0.0, -1.0, 0.0, 5.0, 0.0)


@pytest.mark.parametrize("start", [0.0, 0.3, 1.1, 2.0, 3.3, 4.4, 5.9])
@pytest.mark.parametrize("width", [1e-15, 1e-12, 1e-9, 1e-6, 1e-3])
def test_very_narrow_and_very_wide_sectors(start: float, width: float) -> None:
    narrow = rays(start, start + width)
    wide = narrow[2:] + narrow[:2]
    for turn in (-3.0, -1.0, -0.01, -20.0 * width, 20.0 * width, 0.01, 1.0, 3.0, pi, pi + 0.5 * width):
        x, y = cos(start + turn), sin(start + turn)
        assert arc.in_sector(*narrow, x, y) is False
        assert arc.in_sector(*wide, x, y)
    assert arc.in_sector(*narrow, *arc.middle_direction(*narrow))


def test_an_arc_whose_ends_rounding_made_one_is_a_full_circle() -> None:
    ends = (1.0, 0.5, 1.0, 0.5)
    assert all(arc.in_sector(*ends, cos(angle), sin(angle)) for angle in range(7))
    assert arc.middle_direction(2.0, 0.0, 2.0, 0.0) == (-1.0, 0.0)


def test_the_centre_is_in_every_sector() -> None:
    assert arc.in_sector(*rays(0.1, 0.2), 0.0, 0.0)
    assert arc.in_sector(*rays(0.2, 0.1), 0.0, 0.0)


@given(arcs())
def test_the_middle_is_half_a_sweep_from_both_ends(given_: Arc) -> None:
    cx, cy, radius, start, end = given_
    angle = start + 0.5 * sweep(start, end)
    # Seen from far away the ends of a small arc are rounded, and its middle with them.
    slack = 1e-13 * (abs(cx) + abs(cy) + radius) * 1e3
    expected = (cx + radius * cos(angle), cy + radius * sin(angle))
    found = arc.closest_on_arc(cx, cy, radius, *arc.arc_ends(*given_), cx, cy)
    assert found == pytest.approx(expected, rel=0.0, abs=slack)


@pytest.mark.parametrize("width", [1e-12, 1e-6, 0.1, 1.0, pi - 1e-9, pi, pi + 1e-9, 5.0, 2.0 * pi - 1e-6])
def test_the_middle_of_any_sweep_is_sharp(width: float) -> None:
    x, y = arc.middle_direction(*rays(0.7, 0.7 + width))
    assert naive.between(atan2(y, x), 0.7 + 0.5 * width) < 1e-15 / min(width, 2.0 * pi - width, 1.0)


def test_an_arc_smaller_than_the_rounding_of_its_centre_has_a_middle() -> None:
    assert arc.middle_direction(0.0, 0.0, 0.0, 0.0) == (1.0, 0.0)


@given(arcs())
def test_an_arc_and_its_complement_make_a_circle(given_: Arc) -> None:
    _, _, radius, start, end = given_
    around = arc.arc_length(radius, start, end) + arc.arc_length(radius, end, start)
    assert around == pytest.approx(2.0 * pi * radius, rel=1e-15)


def test_a_full_arc_has_the_length_of_a_circle() -> None:
    assert arc.arc_length(2.0, 0.0, nextafter(2.0 * pi, 0.0)) == pytest.approx(4.0 * pi, rel=1e-15)
    assert arc.arc_length(2.0, 5e-324, 0.0) == pytest.approx(4.0 * pi, rel=1e-15)


def test_tangents_point_out_of_the_arc() -> None:
    t0x, t0y, t1x, t1y = arc.arc_tangents(0.0, 0.5 * pi)
    assert (t0x, t0y) == (0.0, -1.0)
    assert (t1x, t1y) == pytest.approx((-1.0, 0.0), abs=1e-16)


@given(arcs())
def test_a_step_along_a_tangent_leaves_the_sector(given_: Arc) -> None:
    start, end = given_[3:]
    ax, ay, bx, by = rays(start, end)
    t0x, t0y, t1x, t1y = arc.arc_tangents(start, end)
    assert ax * t0x + ay * t0y == pytest.approx(0.0, abs=1e-15)
    assert bx * t1x + by * t1y == pytest.approx(0.0, abs=1e-15)
    assert not arc.in_sector(ax, ay, bx, by, ax + 1e-4 * t0x, ay + 1e-4 * t0y)
    assert not arc.in_sector(ax, ay, bx, by, bx + 1e-4 * t1x, by + 1e-4 * t1y)


@given(arcs(), points)
def test_no_point_of_an_arc_is_closer(given_: Arc, q: Vector) -> None:
    cx, cy, radius, start, end = given_

    def distance(angle: float) -> float:
        return hypot(cx + radius * cos(angle) - q[0], cy + radius * sin(angle) - q[1])

    halfway = start + 0.5 * sweep(start, end)
    least = min(
        naive.least_by_search(distance, start, halfway),
        naive.least_by_search(distance, halfway, start + sweep(start, end)),
    )
    x, y = arc.closest_on_arc(cx, cy, radius, *arc.arc_ends(*given_), *q)
    assert hypot(x - q[0], y - q[1]) == pytest.approx(least, rel=1e-8, abs=1e-8)


@given(arcs(), fractions)
def test_past_an_end_the_end_itself_is_closest(given_: Arc, fraction: float) -> None:
    cx, cy, radius, start, end = given_
    ax, ay, bx, by = arc.arc_ends(*given_)
    gap = sweep(end, start)
    assume(1e-3 < fraction < 0.49)
    near_end = end + fraction * gap
    assert arc.closest_on_arc(cx, cy, radius, ax, ay, bx, by, cx + cos(near_end), cy + sin(near_end)) == (bx, by)
    near_start = start - fraction * gap
    assert arc.closest_on_arc(cx, cy, radius, ax, ay, bx, by, cx + cos(near_start), cy + sin(near_start)) == (ax, ay)


def test_the_centre_is_closest_to_the_middle() -> None:
    assert arc.closest_on_arc(1.0, 1.0, 2.0, 3.0, 1.0, -1.0, 1.0, 1.0, 1.0) == (1.0, 3.0)
