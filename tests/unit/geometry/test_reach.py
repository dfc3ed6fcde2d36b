"""When a ball that touches a line or circle is beside the segment or arc itself: in the slab or sector, or entering."""

from math import cos, hypot, inf, pi, sin
from random import Random

import numpy as np
import pytest
from hypothesis import given

from carom.constants import END_DEPTH_CONTINUOUS
from carom.geometry.arc import arc_ends
from carom.geometry.figures import CentredArc
from carom.geometry.path import Path
from carom.geometry.reach import (
    in_wide_sector,
    sector_touch_within,
    slab_touch_within,
    touch_in_sector,
    touch_in_slab,
    touches_arc,
)
from tests.naive import in_sector
from tests.strategies import seeds

RADIUS, EXTENT, SLOP = 1.0, 4.0, 1e-3


def slab(time: float, depth: float, rate: float, foot: float, speed: float) -> float | None:
    """When a ball touches a segment whose line it touches at `time`, deep by `depth` and at a foot then."""
    path = Path(foot - speed * time, RADIUS - depth - rate * time, speed, rate, 0.0, 0.0)
    touch = touch_in_slab(time, path, EXTENT, SLOP, RADIUS)
    for look in (time, 2.0, inf):
        within = None if touch is None or touch > look else touch
        assert slab_touch_within(time, path, EXTENT, SLOP, RADIUS, look) == within
    assert slab_touch_within(time, path, EXTENT, SLOP, RADIUS, 0.5 * time) is None
    return touch


def test_beside_a_segment_a_touch_of_its_line_is_one_of_the_segment() -> None:
    for foot in (0.0, 2.0, 4.0, -0.9 * SLOP, 4.0 + 0.9 * SLOP):
        assert slab(0.25, 0.0, -1.0, foot, 3.0) == 0.25


@pytest.mark.parametrize(("foot", "speed"), [(-0.5 - SLOP, 1.0), (4.5 + SLOP, -1.0)])
def test_past_an_end_a_ball_touches_if_it_comes_in_all_but_clear(foot: float, speed: float) -> None:
    flat = 0.9 * END_DEPTH_CONTINUOUS
    assert slab(0.25, 0.0, -2.0 * flat, foot, speed) == pytest.approx(0.75)
    assert slab(0.25, 0.0, -3.0 * flat, foot, speed) is None
    assert slab(0.25, 0.0, 2.0 * flat, foot, speed) is None  # it leaves
    assert slab(0.25, 0.0, -2.0 * flat, foot, -speed) is None  # it goes away


@given(seeds)
def test_a_sector_is_as_wide_as_its_margins(seed: int) -> None:
    random = Random(seed)
    start, sweep, r = random.uniform(0, 6.28), random.uniform(0.02, 6.2), random.uniform(0.5, 5)
    end, width = (start + sweep) % (2 * pi), 0.05 * r
    _, _, ax, ay, bx, by = (0.0, 0.0, *arc_ends(0.0, 0.0, r, start, end))
    for _ in range(200):
        x, y = random.uniform(-2 * r, 2 * r), random.uniform(-2 * r, 2 * r)
        inside = in_sector(start, end, x, y)
        if hypot(x, y) < 2.0 * width:
            continue  # Behind the centre, where the two rays begin, a narrow sector is not widened.
        # How far it is from the nearest of the two rays.
        rays = [(cos(edge), sin(edge)) for edge in (start, end)]
        away = min(hypot(x - max(x * c + y * s, 0.0) * c, y - max(x * c + y * s, 0.0) * s) for c, s in rays)
        if away < 0.9 * width:
            assert in_wide_sector(ax, ay, bx, by, x, y, width * r) or inside
        elif away > 1.1 * width:
            assert in_wide_sector(ax, ay, bx, by, x, y, width * r) == inside


def test_the_sector_of_a_full_circle_holds_everything() -> None:
    for angle in np.linspace(0, 6.2, 20):
        assert in_wide_sector(1.0, 0.0, 1.0, 0.0, cos(angle), sin(angle), 0.0)


def test_who_overlaps_past_an_end_is_passing_unless_by_next_to_nothing() -> None:
    quarter = CentredArc(3.0, 3.0, 0.0, 0.0, 3.0, 0.0)
    assert touches_arc(1.5, 1.5, 1.0, quarter)
    assert not touches_arc(-3.5, 0.0, 1.0, quarter)
    assert touches_arc(-4.0 + 0.9 * END_DEPTH_CONTINUOUS, 0.0, 1.0, quarter)


@pytest.mark.parametrize(("short", "later"), [(0.5, True), (5.0, False)])
def test_a_ball_that_comes_over_the_end_of_an_arc_touches_there_if_it_is_all_but_clear(
    short: float, later: bool
) -> None:
    # It flies along the tangent at the arc's end, too low by a part of the end depth, and touches the circle before.
    quarter, depth = CentredArc(3.0, 3.0, 0.0, 0.0, 3.0, 0.0), short * END_DEPTH_CONTINUOUS
    x, y, speed = 4.0 - depth, -1.0, 2.0
    touch = (1.0 - (2.0 * 4.0 * depth - depth * depth) ** 0.5) / speed
    path = Path(x, y, 0.0, speed, 0.0, 0.0)
    found = touch_in_sector(touch, 2.0, path, 1.0, quarter)
    assert found == (pytest.approx(0.5) if later else None)
    assert sector_touch_within(touch, path, 1.0, quarter, inf) == found
    for late in (
        touch_in_sector(touch, 0.49, path, 1.0, quarter),
        sector_touch_within(touch, path, 1.0, quarter, 0.49),
    ):
        assert late is None
    # In the sector already, it is the touch itself.
    assert touch_in_sector(0.1, 2.0, Path(4.0, 1.0, 0.0, speed, 0.0, 0.0), 1.0, quarter) == 0.1


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_ball_that_crosses_both_rays_touches_at_the_one_that_it_crosses_first(sign: float) -> None:
    # A ball as large as its distance all but touches; in a narrow gap it crosses a ray, and then the other.
    half, radius = 1e-9, 1e6
    arc = CentredArc(1.0, cos(half), sin(half), cos(half), -sin(half), 1e-12)
    path = Path(radius + 1.0, 0.0, 0.0, sign, 0.0, -0.5 * sign)
    assert touch_in_sector(0.0, inf, path, radius, arc) == pytest.approx(1e-3, rel=1e-2)
    assert touch_in_sector(0.0, 5e-4, path, radius, arc) is None
