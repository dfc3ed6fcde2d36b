"""Biarcs through places in given directions, as few as pass all the places."""

from __future__ import annotations

from collections.abc import Sequence

from carom.shapes.outlines.bow import Bow, biarc
from carom.shapes.outlines.cubic import cross, dot

#: A biarc whose legs would be longer than its chord over this is made of two, by way of a place between.
LEAST_DIVISOR = 0.1


def through(places: Sequence[complex], headings: Sequence[complex], tolerance: float) -> list[Bow]:
    """Arcs from the first place to the last, each passed at no more than `tolerance`, in its direction where they meet.

    From each place that they go through they go on to a later one that lies as far on as doubling and halving find.
    """
    bows: list[Bow] = []
    start, step = 0, 1
    while start < len(places) - 1:
        low, high = 0, len(places) - start
        found: list[Bow] = []
        while high - low > 1:
            step = min(max(step, low + 1), high - 1)
            arcs = between(places[start], headings[start], places[start + step], headings[start + step])
            skipped = places[start + 1 : start + step]
            if step == 1 or all(_distance(arcs, place) <= tolerance for place in skipped):
                low, found = step, arcs
                step = 2 * step
            else:
                high = step
                step = (low + high) // 2
        bows += found
        start += low
        step = low
    return bows


def between(start: complex, out: complex, end: complex, into: complex) -> list[Bow]:
    """A biarc; two, where both directions lead away from the other end, so that one would have to go very far."""
    along = (end - start) / abs(end - start)
    forward, sideways = dot(out, along) + dot(into, along), cross(along, out) + cross(along, into)
    if forward + (max(4.0 - sideways * sideways, 0.0)) ** 0.5 < LEAST_DIVISOR:
        middle, across = 0.5 * (start + end), along * (-1j if sideways >= 0.0 else 1j)
        return [*between(start, out, middle, across), *between(middle, across, end, into)]
    bows = biarc(start, out, end, into)
    assert bows is not None
    return list(bows)


def _distance(bows: Sequence[Bow], place: complex) -> float:
    """How far a place is from the nearest of some arcs."""
    return min(bow.distance(place) for bow in bows)
