"""What a picture needs to know of a run: where balls were after each step, and where they were hit hardest.

Some balls only: as many as can be told apart, spread evenly over all. Some steps only: the last ones. Some hits only:
the strongest. These limits bound the time, the memory and the size of the picture, whatever the run; a picture says
in words what it leaves out.
"""

from __future__ import annotations

from collections import deque
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.checks import instance
from carom.draw.history.tracks import Track, Ways
from carom.draw.parts.moment import MOST_LATEST, bounces_of, latest_of, strongest
from carom.rows.hit import HIT
from carom.rows.tables import Rows
from carom.spelling import spelled
from carom.world.hits import rows_of
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
        instance("world", world, World, "a World")
        self.bounces = 0  # how many there were, kept or not
        self._world = world
        self._all = world.balls.id.copy()
        self._ids = followed(self._all)
        self._rows = np.flatnonzero(np.isin(self._all, self._ids))
        self._followed: list[int] = self._ids.tolist()
        self._ways = Ways()
        self._times: deque[float] = deque(maxlen=MOST_STEPS + 1)
        self._waiting: list[Rows] = [np.zeros(0, HIT)]
        self._waiting_count = 0
        self._latest = np.zeros(0, HIT)
        self._go_on(np.zeros(0, HIT))

    @property
    def followed(self) -> list[int]:
        """The ids of the balls that are followed, and of those that were until they left."""
        return self._followed[:]

    def note(self, hits: Rows) -> None:
        """Remember where the followed balls are now, and the `hits` of the step that brought them there.

        Raises `InvalidArgument` where these are none, or those of another world.
        """
        bounces = bounces_of(rows_of(self._world, hits))
        self.bounces += len(bounces)
        self._go_on(bounces)
        if len(bounces) > 0:
            self._latest = np.concatenate([self._latest, bounces[-MOST_LATEST:]])[-MOST_LATEST:]
            self._waiting.append(bounces)
            self._waiting_count += len(bounces)
            if self._waiting_count > MOST_WAITING:
                self._waiting = [self.hits]
                self._waiting_count = MOST_HITS

    def _go_on(self, bounces: Rows) -> None:
        """Go on to where the followed balls are; one that left the world is followed no more."""
        ids = self._world.balls.id
        if not np.array_equal(ids, self._all):
            self._all = ids.copy()
            self._rows = np.flatnonzero(np.isin(self._all, self._ids))
            self._ids = self._all[self._rows]
        self._times.append(self._world.time)
        self._ways.note(self._world, self._rows, bounces, self._times[0])

    @property
    def latest(self) -> Rows:
        """The bounces of the last `LATEST` seconds, in order of time."""
        return latest_of(self._latest, self._world.time)

    @property
    def hits(self) -> Rows:
        """Up to `MOST_HITS` bounces, the strongest first; of equally strong ones, the earliest."""
        return strongest(np.concatenate(self._waiting), MOST_HITS)

    def tracks(self) -> tuple[Track, ...]:
        """The ways of all balls that were followed, through the places where they bounced."""
        return self._ways.tracks()
