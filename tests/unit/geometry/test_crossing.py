"""Whether a straight way crosses a segment, a circle or an arc: as many points along it say."""

from math import atan2, cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.geometry import crossing as crossings
from carom.geometry.arc import arc_ends
from tests.flat import flat
from tests.naive import in_sector
from tests.strategies import arcs, circles, points, segments

crossing = flat(crossings)

Way = tuple[tuple[float, float], tuple[float, float]]
ways = st.tuples(points, points)


def along(way: Way) -> tuple[np.ndarray, np.ndarray]:
    """Many places of a way."""
    share = np.linspace(0.0, 1.0, 4001)
    (x, y), (to_x, to_y) = way
    return x + share * (to_x - x), y + share * (to_y - y)


@given(ways, segments())
def test_a_way_crosses_a_segment_where_it_changes_its_side_between_the_ends(
    way: Way, segment: tuple[float, float, float, float]
) -> None:
    (x, y), (to_x, to_y) = way
    ax, ay, bx, by = segment
    extent = hypot(bx - ax, by - ay)
    tx, ty = (bx - ax) / extent, (by - ay) / extent
    xs, ys = along(way)
    side, foot = tx * (ys - ay) - ty * (xs - ax), tx * (xs - ax) + ty * (ys - ay)
    at = np.flatnonzero(side[:-1] * side[1:] < 0.0)
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    found = crossing.crosses_segment(ax, ay, tx, ty, extent, x, y, to_x - x, to_y - y, 0.0)
    if any(slack < foot[k] < extent - slack for k in at):
        assert found
    elif all(not -slack < foot[k] < extent + slack for k in at) and min(abs(side[0]), abs(side[-1])) > 1e-9:
        assert not found


@given(ways, circles, st.booleans())
def test_a_way_crosses_a_circle_where_it_comes_in_or_leaves_what_is_hollow(
    way: Way, circle: tuple[float, float, float], solid: bool
) -> None:
    (x, y), (to_x, to_y) = way
    cx, cy, r = circle
    xs, ys = along(way)
    outside = np.hypot(xs - cx, ys - cy) - r
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    found = crossing.crosses_circle(cx, cy, r, int(solid), x, y, to_x - x, to_y - y)
    if outside[0] < -slack:
        if abs(outside[-1]) > slack:
            assert found == (not solid and outside[-1] > 0.0)
    elif outside[0] > slack and abs(outside.min()) > slack:
        assert found == (outside.min() < 0.0)


@given(ways, arcs())
def test_a_way_crosses_an_arc_where_it_crosses_its_circle_in_the_sector(
    way: Way, arc: tuple[float, float, float, float, float]
) -> None:
    (x, y), (to_x, to_y) = way
    cx, cy, r, start, end = arc
    xs, ys = along(way)
    outside = np.hypot(xs - cx, ys - cy) - r
    slack = 1e-6 + hypot(to_x - x, to_y - y) / 4000.0
    at = np.flatnonzero(outside[:-1] * outside[1:] < 0.0)
    edges = [min(abs((atan2(ys[k] - cy, xs[k] - cx) - edge + pi) % (2 * pi) - pi) for edge in (start, end)) for k in at]
    if any(r * edge <= slack for edge in edges) or min(abs(outside[0]), abs(outside[-1])) <= slack:
        return
    if not len(at) and abs(outside.min()) <= slack:
        return
    expected = any(in_sector(start, end, xs[k] - cx, ys[k] - cy) for k in at)
    assert crossing.crosses_arc(cx, cy, r, *arc_ends(cx, cy, r, start, end), x, y, to_x - x, to_y - y, 0.0) == expected


def test_what_begins_on_a_side_does_not_cross_it() -> None:
    assert not crossing.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, 2.0, 0.0, 0.0, -3.0, 0.0)
    assert not crossing.crosses_circle(0.0, 0.0, 5.0, 0, 3.0, 4.0, 9.0, 9.0)
    assert not crossing.crosses_arc(0.0, 0.0, 5.0, 5.0, 0.0, -5.0, 0.0, 3.0, 4.0, 9.0, 9.0, 0.0)


@pytest.mark.parametrize(("past", "crosses"), [(0.05, True), (0.15, False)])
def test_ends_reach_as_far_as_the_slop(past: float, crosses: bool) -> None:
    assert crossing.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, 4.0 + past, 1.0, 0.0, -2.0, 0.1) == crosses
    assert crossing.crosses_segment(0.0, 0.0, 1.0, 0.0, 4.0, -past, 1.0, 0.0, -2.0, 0.1) == crosses
    angle = -past / 5.0
    way = 4.0 * cos(angle), 4.0 * sin(angle), 2.0 * cos(angle), 2.0 * sin(angle)
    assert crossing.crosses_arc(0.0, 0.0, 5.0, 5.0, 0.0, -5.0, 0.0, *way, 0.1) == crosses
