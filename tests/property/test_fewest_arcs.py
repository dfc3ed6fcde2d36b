"""How many arcs follow a curve, against the fewest that a search among joints and directions finds."""

import random
from cmath import exp
from math import inf

import pytest

from carom.shapes.outlines.bow import biarc
from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.following import follow
from carom.shapes.outlines.track import Track, tracks

#: Joints that the search chooses from along each curve, and angles to its tangent at which arcs may pass them.
GRID, SLANTS = 22, (-0.2, -0.07, -0.02, 0.0, 0.02, 0.07, 0.2)


def random_tracks(count: int) -> list[Track]:
    """Cubics without cusps, whose control points are anywhere in a square, the same in every run."""
    source = random.Random(11)
    cubics = [Cubic(*(complex(source.uniform(-1, 1), source.uniform(-1, 1)) for _ in range(4))) for _ in range(count)]
    return [track for cubic in cubics for track in tracks([cubic])]


def keeps(track: Track, start: float, out: complex, end: float, into: complex, tolerance: float) -> int:
    """How many arcs a biarc along a stretch has, if some places of the track are near enough to them; else none."""
    bows = biarc(track.point(start), out, track.point(end), into)
    if bows is None:
        return 0
    for share in (0.5, 0.25, 0.75, 0.12, 0.38, 0.62, 0.88):
        place = track.point(start + share * (end - start))
        if min(bow.distance(place) for bow in bows) > tolerance:
            return 0
    return 1 if abs(bows[0].curvature - bows[1].curvature) < 1e-9 else 2


def fewest(track: Track, tolerance: float) -> float:
    """The fewest arcs of all chains of biarcs between the joints and directions of the search."""
    spots = [track.end * index / GRID for index in range(GRID + 1)]
    ways = [
        [track.heading(u, 0.0) * exp(1j * slant) for slant in (SLANTS if 0 < index < GRID else (0.0,))]
        for index, u in enumerate(spots)
    ]
    best = [[inf] * len(each) for each in ways]
    best[0] = [0.0]
    for end in range(1, GRID + 1):
        for start in range(end):
            for given, out in enumerate(ways[start]):
                for taken, into in enumerate(ways[end]):
                    if best[start][given] + 2.0 < best[end][taken]:
                        arcs = keeps(track, spots[start], out, spots[end], into, tolerance)
                        best[end][taken] = best[start][given] + arcs if arcs else best[end][taken]
    return best[GRID][0]


@pytest.mark.slow
@pytest.mark.parametrize("tolerance", [3e-2, 3e-3])
def test_arcs_are_half_as_many_again_as_the_fewest_at_most(tolerance: float) -> None:
    ratios = []
    for track in random_tracks(8):
        least = fewest(track, tolerance)
        if least < inf:
            ratios.append(len(follow(track, tolerance)) / least)
    assert len(ratios) >= 5
    assert sum(ratios) / len(ratios) <= 1.5
