"""Arcs that follow a smooth track within a tolerance, as few as will do."""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from carom.shapes.outlines.bow import WIDEST, Bow, biarc
from carom.shapes.outlines.track import Track

#: Trials of a length, at most, and where along each arc the first look at its distance is taken.
TRIALS, LOOKS = 80, (0.2, 0.5, 0.8)

#: A length is long enough that comes so near to one that is too long, and one whose arcs use up so much of their room.
NEAR_ENOUGH, USED_UP = 0.03, 0.9


class Stretch(NamedTuple):
    """A part of a track up to u, and the biarc along it, with the largest share of its room that the looks found.

    `middle` is where the track passes the joint of the biarc.
    """

    end: float
    bows: tuple[Bow, Bow]
    used: float
    middle: float


def follow(track: Track, tolerance: float) -> list[Bow]:
    """Arcs along the whole of a track, each within `tolerance` of its part of it, without a bend at their joints."""
    u, out = 0.0, track.heading(0.0, 0.0)
    bows: list[Bow] = []
    while u < track.end:
        stretch = _farthest(track, u, out, tolerance)
        u, out = stretch.end, stretch.bows[1].into
        bows.extend(stretch.bows)
    return bows


def _farthest(track: Track, start: float, out: complex, tolerance: float) -> Stretch:
    """The longest stretch from `start` that a biarc follows within the tolerance, to the last few percent.

    A rest that is shorter than it is parted into two alike.
    """
    best: Stretch | None = None
    low, high, u = start, track.end, track.end
    for _ in range(TRIALS):
        stretch = _along(track, start, out, u, tolerance)
        used = inf if stretch is None else stretch.used
        if stretch is not None and _is_sure(track, start, stretch, tolerance):
            low, best = u, stretch
            if u == track.end or USED_UP < used <= 1.0:
                break
        else:
            high = u
        if best is not None and high - low <= NEAR_ENOUGH * (high - start):
            break
        wanted = start + (u - start) * (0.97 / max(used, 1e-9)) ** (1.0 / 3.0)
        margin = (0.02 if best is None else 0.15) * (high - low)
        u = min(max(wanted, low + margin), high - max(margin, 0.1 * (high - low)))
    assert best is not None
    rest = track.end - best.end
    if 0.0 < rest < best.end - start:
        half = _along(track, start, out, 0.5 * (start + track.end), tolerance)
        if half is not None and _is_sure(track, start, half, tolerance):
            return half
    return best


def _along(track: Track, start: float, out: complex, end: float, tolerance: float) -> Stretch | None:
    """The biarc along a stretch, and how much of its room a few places of the track use; None where there is none."""
    first, last = track.point(start), track.point(end)
    bows = biarc(first, out, last, track.heading(end, 0.5 * abs(last - first)))
    if bows is None:
        return None
    middle = track.crossing(start, end, bows[1].start, bows[1].out)
    used = 0.0
    for bow, low, high in ((bows[0], start, middle), (bows[1], middle, end)):
        off = max(map(abs, map(bow.side, track.points(low, high, LOOKS))))
        used = max(used, off / max(bow.room(tolerance), 1e-3 * tolerance))
    return Stretch(end, bows, used, middle)


def _is_sure(track: Track, start: float, stretch: Stretch, tolerance: float) -> bool:
    """Whether every place of the track is within the tolerance of the arcs, and they of it."""
    if stretch.used > 1.0:
        return _is_tiny(track, start, stretch, tolerance)
    first, last = stretch.bows
    for bow, low, high in ((first, start, stretch.middle), (last, stretch.middle, stretch.end)):
        turn, room = bow.turn, bow.room(tolerance)
        wide = room <= 0.0 or abs(turn) > WIDEST or turn * bow.curvature < 0.0
        if wide or not all(bow.follows(part, room) for part in track.parts(low, high)):
            return _is_tiny(track, start, stretch, tolerance)
    return True


def _is_tiny(track: Track, start: float, stretch: Stretch, tolerance: float) -> bool:
    """Whether a stretch and its arcs are so small that all of them are within the tolerance of where it starts."""
    first, last = stretch.bows
    room = min(first.room(tolerance), last.room(tolerance))
    if max(first.reach(), abs(first.end - first.start) + last.reach()) > room:
        return False
    return all(abs(place - first.start) <= room for part in track.parts(start, stretch.end) for place in part)
