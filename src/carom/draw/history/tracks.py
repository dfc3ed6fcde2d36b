"""The ways that balls took: thinned to the points that matter, and cut into bands of age."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from carom.draw.paint.painter import Points

Floats: TypeAlias = NDArray[np.float64]

#: Into how many steps of fading a track is cut.
BANDS = 10


@dataclass(frozen=True, slots=True)
class Track:
    """Where the centre of ball `ball` was: `points` (n, 2) at `times` (n,), in order of time."""

    ball: int
    times: Floats
    points: Points


def thinned(track: Track, tolerance: float, *, in_time: bool = False) -> Track:
    """`track` without the points that lie within `tolerance` of the line through those kept.

    If `in_time`, they lie so near to where one is on that line at their own time, which steady speed makes of it.

    Source: the method of Ramer (1972) and of Douglas and Peucker (1973).
    """
    times, points = track.times, track.points
    keep = np.zeros(len(points), dtype=bool)
    keep[[0, -1]] = True
    spans = [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        if in_time:
            distances = distances_in_time(times[first : last + 1], points[first : last + 1])
        else:
            distances = distances_to_segment(points[first + 1 : last], points[first], points[last])
        worst = int(np.argmax(distances))
        if distances[worst] > tolerance:
            middle = first + 1 + worst
            keep[middle] = True
            spans += [(first, middle), (middle, last)]
    return Track(track.ball, times[keep], points[keep])


def distances_to_segment(points: Points, start: Floats, end: Floats) -> Floats:
    """The distance (n,) of each of `points` (n, 2) from the segment between `start` and `end`, which may be equal."""
    along = end - start
    length_squared = float(along[0] * along[0] + along[1] * along[1])
    offsets = points - start
    if length_squared > 0.0:
        fractions = np.clip((offsets[:, 0] * along[0] + offsets[:, 1] * along[1]) / length_squared, 0.0, 1.0)
        offsets = offsets - fractions[:, None] * along
    return np.sqrt(offsets[:, 0] * offsets[:, 0] + offsets[:, 1] * offsets[:, 1])


def distances_in_time(times: Floats, points: Points) -> Floats:
    """The distance of each point but the first and the last from where steady speed between these has one then."""
    span = float(times[-1] - times[0]) or 1.0
    shares = ((times[1:-1] - times[0]) / span)[:, None]
    offsets = points[1:-1] - points[0] - shares * (points[-1] - points[0])
    distances: Floats = np.sqrt(offsets[:, 0] * offsets[:, 0] + offsets[:, 1] * offsets[:, 1])
    return distances


def bands(track: Track, start: float, end: float, count: int = BANDS) -> Iterator[tuple[int, Points]]:
    """The parts of `track` in each of `count` equal spans of time from `start` to `end`: (band, points), oldest first.

    Neighbouring parts share the point between them. A band in which the track has no length is left out.
    """
    times, points = track.times, track.points
    edges = np.linspace(start, end, count + 1).clip(times[0], times[-1])
    corners = np.column_stack([np.interp(edges, times, points[:, axis]) for axis in (0, 1)])
    begins, ends = times.searchsorted(edges, side="right").tolist(), times.searchsorted(edges, side="left").tolist()
    for band, (low, high) in enumerate(pairwise(edges.tolist())):
        if high > low:
            inside = points[begins[band] : ends[band + 1]]
            yield band, np.concatenate([corners[band : band + 1], inside, corners[band + 1 : band + 2]])
