"""The ways that balls took: noted as they go, thinned to the points that matter, and cut into bands of age."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from carom.draw.paint.painter import Points
    from carom.rows.tables import Rows
    from carom.world.world import World

Floats: TypeAlias = NDArray[np.float64]

#: Into how many steps of fading a track is cut.
BANDS = 10


@dataclass(frozen=True, slots=True)
class Track:
    """Where the centre of ball `ball` was: `points` (n, 2) at `times` (n,), in order of time."""

    ball: int
    times: Floats
    points: Points


class Ways(dict[int, deque[tuple[float, bool, float, float]]]):
    """The ways of some balls up to now, by id: the places where each was after steps, and those where it bounced.

    Of each place: the time, whether a step ended there, x, y. Where nothing was hit, `spacing` seconds lie between two.
    """

    def __init__(self, spacing: float = 0.0) -> None:
        super().__init__()
        self._spacing = spacing

    def note(self, world: World, which: slice | NDArray[np.intp], bounces: Rows, since: float) -> None:
        """Go on to where some of the world's balls are now, by the bounces of the step; forget what is before `since`.

        A bounce at the end of a step comes before that, for the ball may have moved on since.
        """
        time, balls = world.time, world.balls
        ids, centers = balls.id[which], balls.position[which].tolist()
        if len(bounces) > 0:
            bounces = bounces[np.isin(bounces["ball"], ids) | np.isin(bounces["shape"], ids)]
        met = {*bounces["ball"].tolist(), *bounces["shape"].tolist()}
        # Not the column of radii: that may be written to, so those who ask for it wake the balls that sleep.
        radii = world._arrays.balls.used["radius"][which].tolist()
        for ball, radius, (x, y) in zip(ids.tolist(), radii, centers, strict=True):
            way = self.setdefault(ball, deque())
            if ball in met:
                times, places = centers_at(bounces, ball, radius)
                way.extend((at, False, *place) for at, place in zip(times.tolist(), places.tolist(), strict=True))
            elif len(way) > 1 and way[-1][1] and (way[-1][0] == time or way[-1][0] - way[-2][0] < self._spacing):
                way.pop()
            way.append((time, True, x, y))
        for way in self.values():
            while way and way[0] < (since, True):
                way.popleft()

    def tracks(self) -> tuple[Track, ...]:
        """The ways as tracks; those of which nothing is left are none."""
        tables = [(ball, np.array(way)) for ball, way in self.items() if way]
        return tuple(Track(ball, table[:, 0], table[:, 2:]) for ball, table in tables)


def centers_at(bounces: Rows, ball: int, radius: float) -> tuple[Floats, Points]:
    """When ball `ball` bounced, and where its centre was then: (n,) and (n, 2)."""
    second = bounces["ball"] == ball
    mine = second | (bounces["shape"] == ball)
    # The normal points from a hit's shape, which may be a ball too, to its ball.
    side = np.where(second[mine], radius, -radius)
    return bounces["time"][mine], bounces["point"][mine] + side[:, None] * bounces["normal"][mine]


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
