"""How deep a ball is when its centre comes past an end, into the slab of a segment or the sector of an arc."""

from math import atan2, cos, hypot, pi, sin
from random import Random

import numpy as np
import pytest
from hypothesis import given

from carom.geometry import entry as entries
from carom.geometry.arc import arc_ends
from tests.flat import flat
from tests.naive import in_sector
from tests.strategies import seeds

entry = flat(entries)


@given(seeds)
def test_the_depth_in_a_segments_line_is_the_lesser_of_those_at_the_start_and_at_the_edge(seed: int) -> None:
    random = Random(seed)
    turn, extent, radius = random.uniform(0, 6.3), random.uniform(1, 5), random.uniform(0.2, 2)
    tx, ty = cos(turn), sin(turn)
    ax, ay = random.uniform(-3, 3), random.uniform(-3, 3)
    begin = random.choice((-random.uniform(0.1, 3), extent + random.uniform(0.1, 3)))
    sides = random.uniform(-2, 2), random.uniform(-2, 2)
    end = random.uniform(0.0, extent)

    def place(along: float, side: float) -> tuple[float, float]:
        return ax + along * tx - side * ty, ay + along * ty + side * tx

    edge = 0.0 if begin < 0.0 else extent
    at_edge = sides[0] + (sides[1] - sides[0]) * (edge - begin) / (end - begin)
    found = entry.depth_on_entry_segment(ax, ay, tx, ty, extent, radius, *place(begin, sides[0]), *place(end, sides[1]))
    assert found == pytest.approx(radius - max(abs(sides[0]), abs(at_edge)))


@given(seeds)
def test_the_depth_in_an_arcs_circle_is_likewise(seed: int) -> None:
    random = Random(seed)
    cx, cy, r, radius = random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(1, 5), random.uniform(0.2, 2)
    start, sweep = random.uniform(0, 6.28), random.uniform(0.3, 5.5)
    end = (start + sweep) % (2 * pi)

    def place(inside: bool) -> tuple[float, float]:
        while True:
            x, y = random.uniform(-1.5 * r, 1.5 * r), random.uniform(-1.5 * r, 1.5 * r)
            if in_sector(start, end, x, y) == inside:
                return x, y

    (x0, y0), (x1, y1) = place(False), place(True)
    share = np.linspace(0, 1, 100_001)
    xs, ys = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
    away = np.hypot(xs, ys)
    # The last time that it comes in: it may cross the sector before.
    outside = [not in_sector(start, end, x, y) for x, y in zip(xs[::50], ys[::50], strict=True)]
    last = 50 * max(k for k, out in enumerate(outside) if out)
    edge = next(k for k in range(last, len(xs)) if in_sector(start, end, xs[k], ys[k]))
    expected = radius - max(abs(away[0] - r), abs(away[edge] - r))
    ends = arc_ends(cx, cy, r, start, end)
    found = entry.depth_on_entry_arc(cx, cy, r, *ends, radius, cx + x0, cy + y0, cx + x1, cy + y1)
    assert found == pytest.approx(expected, abs=1e-3)


def test_a_way_crosses_a_ray_where_it_crosses_its_line_on_the_rays_side() -> None:
    assert entry.crossing_share(2.0, 0.0, 1.0, -1.0, 1.0, 3.0) == 0.25
    assert entry.crossing_share(2.0, 0.0, -1.0, -1.0, -1.0, 3.0) == 0.0
    assert entry.crossing_share(2.0, 0.0, 1.0, 1.0, 1.0, 3.0) == 0.0
    x, y = cos(2.0), sin(2.0)
    share = entry.crossing_share(x, y, 0.0, 3.0, -3.0, 0.0)
    assert atan2(3 - 3 * share, -3 * share) == pytest.approx(2.0)
    assert hypot(x, y) == pytest.approx(1.0)
