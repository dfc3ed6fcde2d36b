"""What a picture needs to know of a run: where balls were after each step, and where they were hit hardest.

Some balls only: as many as can be told apart, spread evenly over all. Some steps only: the last ones. Some hits only:
the strongest. These limits bound the time, the memory and the size of the picture, whatever the run; a picture says
in words what it leaves out.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.draw.history.tracks import Floats, Track
from carom.draw.parts.moment import MOST_LATEST, bounces_of, latest_of
from carom.rows.hit import HIT
from carom.rows.tables import Rows
from carom.spelling import spelled

if TYPE_CHECKING:
    from carom.draw.paint.painter import Points
    from carom.world.world import World

Ids: TypeAlias = NDArray[np.int64]

#: How many balls are followed at most.
MOST_FOLLOWED = 16
#: How many steps are remembered at most: 20 s at 60 steps a second.
MOST_STEPS = 1200
#: How many hits are kept at most, and how many wait until the strongest of them are picked out.
MOST_HITS, MOST_WAITING = 1500, 30_000


def followed(ids: Ids) -> Ids:
    """The ids to follow among `ids`: all while they are few, else `MOST_FOLLOWED` spread evenly."""
    if len(ids) <= MOST_FOLLOWED:
        return ids.copy()
    return ids[np.linspace(0, len(ids) - 1, MOST_FOLLOWED).round().astype(np.intp)]


@dataclass(frozen=True, slots=True)
class Sample:
    """The end of a step: its time, the followed balls that were there, where they were, and their bounces in it."""

    time: float
    ids: Ids
    points: Points
    bounces: Rows


@spelled
class Trace:
    """Remembers the last steps and the strongest bounces of a run; `note` is to be called after each step.

    >>> import carom
    >>> from carom import draw
    >>> world = carom.scenes.toy().build()
    >>> trace = draw.Trace(world)
    >>> for _ in range(60):
    ...     trace.note(world.step(1 / 60))
    >>> text = draw.svg(draw.picture_of(world, "One second of the toy", trace=trace))
    """

    def __init__(self, world: World) -> None:
        self.bounces = 0  # how many there were, kept or not
        self._world = world
        self._all = world.balls.id.copy()
        self._ids = followed(self._all)
        self._rows = np.flatnonzero(np.isin(self._all, self._ids))
        self._radii = {int(self._all[row]): world.balls[int(row)].radius for row in self._rows}
        self._samples: deque[Sample] = deque(maxlen=MOST_STEPS + 1)
        self._waiting: list[Rows] = [np.zeros(0, HIT)]
        self._waiting_count = 0
        self._latest = np.zeros(0, HIT)
        self._sample(np.zeros(0, HIT))

    @property
    def followed(self) -> list[int]:
        """The ids of the balls that are followed, and of those that were until they left."""
        return list(self._radii)

    def note(self, hits: Rows) -> None:
        """Remember where the followed balls are now, and the `hits` of the step that brought them there."""
        bounces = bounces_of(hits)
        self.bounces += len(bounces)
        self._sample(bounces)
        if len(bounces) > 0:
            self._latest = np.concatenate([self._latest, bounces[-MOST_LATEST:]])[-MOST_LATEST:]
            self._waiting.append(bounces)
            self._waiting_count += len(bounces)
            if self._waiting_count > MOST_WAITING:
                self._waiting = [self.hits]
                self._waiting_count = MOST_HITS

    def _sample(self, bounces: Rows) -> None:
        """Remember where the followed balls are; one that left the world is followed no more."""
        ids = self._world.balls.id
        if not np.array_equal(ids, self._all):
            self._all = ids.copy()
            self._rows = np.flatnonzero(np.isin(self._all, self._ids))
            self._ids = self._all[self._rows]
        theirs = bounces
        if len(bounces) > 0:
            theirs = bounces[np.isin(bounces["ball"], self._ids) | np.isin(bounces["shape"], self._ids)]
        self._samples.append(Sample(self._world.time, self._ids, self._world.balls.position[self._rows], theirs))

    @property
    def latest(self) -> Rows:
        """The bounces of the last `LATEST` seconds, in order of time."""
        return latest_of(self._latest, self._world.time)

    @property
    def hits(self) -> Rows:
        """Up to `MOST_HITS` bounces, the strongest first; of equally strong ones, the earliest."""
        bounces = np.concatenate(self._waiting)
        return np.take(bounces, np.argsort(-bounces["impulse"], kind="stable")[:MOST_HITS])

    def tracks(self) -> tuple[Track, ...]:
        """The ways of all balls that were followed, through the places where they bounced."""
        samples = list(self._samples)
        # The bounces before the first sample are of a step that is remembered no more.
        bounces = np.concatenate([sample.bounces for sample in samples[1:]] or [np.zeros(0, HIT)])
        return tuple(self._track(int(ball), samples, bounces) for ball in samples[0].ids)

    def _track(self, ball: int, samples: list[Sample], bounces: Rows) -> Track:
        """The way of one ball."""
        seen = [(sample.time, sample.points[sample.ids == ball][0]) for sample in samples if ball in sample.ids]
        times = np.array([time for time, _ in seen])
        points = np.array([point for _, point in seen]).reshape(-1, 2)
        return track_through(ball, times, points, *centers_at(bounces, ball, self._radii[ball]))


def track_through(ball: int, times: Floats, points: Points, bounce_times: Floats, bounce_points: Points) -> Track:
    """The way of ball `ball` through its places at the ends of steps, and through those where it bounced."""
    # A bounce at a step's end stands before the sample of that step: the ball may have moved on since.
    times = np.concatenate([bounce_times, times])
    order = np.argsort(times, kind="stable")
    return Track(ball, times[order], np.concatenate([bounce_points, points])[order])


def centers_at(bounces: Rows, ball: int, radius: float) -> tuple[Floats, Points]:
    """When ball `ball` bounced, and where its centre was then: (n,) and (n, 2)."""
    second = bounces["ball"] == ball
    mine = second | (bounces["shape"] == ball)
    # The normal points from a hit's shape, which may be a ball too, to its ball.
    side = np.where(second[mine], radius, -radius)
    return bounces["time"][mine], bounces["point"][mine] + side[:, None] * bounces["normal"][mine]
