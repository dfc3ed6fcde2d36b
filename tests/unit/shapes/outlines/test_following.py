"""Arcs along tracks: all the way, sure of the tolerance, about as few as can be."""

import itertools
import random

import pytest

from carom.shapes.outlines.cubic import Cubic, cross, dot
from carom.shapes.outlines.following import follow
from carom.shapes.outlines.track import tracks


def some_cubics(count: int) -> list[Cubic]:
    """Cubics whose control points are anywhere in a square, the same in every run."""
    source = random.Random(7)
    return [Cubic(*(complex(source.uniform(-1, 1), source.uniform(-1, 1)) for _ in range(4))) for _ in range(count)]


def ideal(cubic: Cubic, tolerance: float) -> float:
    """How many arcs would do if all could be as long as asymptotics say: √3/216·(slope of curvature)·length³."""
    total, looks = 0.0, 400
    for index in range(looks):
        t = (index + 0.5) / looks
        slope, second, third = cubic.slope(t), cubic.second(t), cubic.third()
        speed = abs(slope)
        turning = cross(slope, second)
        growth = abs(cross(slope, third) * speed**2 - 3.0 * turning * dot(slope, second)) / speed**6
        total += (3.0**0.5 / 216.0 * growth / tolerance) ** (1.0 / 3.0) * speed / looks
    return total


@pytest.mark.parametrize("cubic", some_cubics(6))
def test_arcs_go_from_end_to_end_without_a_gap_or_bend(cubic: Cubic) -> None:
    for track in tracks([cubic]):
        bows = follow(track, 1e-3)
        assert (bows[0].start, bows[-1].end) == (track.point(0.0), track.point(track.end))
        assert (bows[0].out, bows[-1].into) == (track.heading(0.0, 0.0), track.heading(track.end, 0.0))
        assert all((a.end, a.into) == (b.start, b.out) for a, b in itertools.pairwise(bows))


def test_arcs_are_few_where_the_tolerance_is_small() -> None:
    cubics = some_cubics(4)
    found = sum(len(follow(track, 1e-6)) for cubic in cubics for track in tracks([cubic]))
    assert found <= 1.5 * sum(ideal(cubic, 1e-6) for cubic in cubics)


def test_a_rest_is_no_sliver() -> None:
    for cubic in some_cubics(12):
        for track in tracks([cubic]):
            sizes = [abs(bow.end - bow.start) for bow in follow(track, 1e-3)]
            assert sizes[-1] > 0.2 * min(sizes[-4:])
