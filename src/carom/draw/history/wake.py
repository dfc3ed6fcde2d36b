"""What a world that goes on leaves behind: the ways of its balls and its bounces, for some seconds."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.trace import MOST_FOLLOWED, centers_at
from carom.draw.history.tracks import Track
from carom.draw.parts.moment import bounces_of, latest_of
from carom.rows.hit import HIT

if TYPE_CHECKING:
    from carom.rows.tables import Rows
    from carom.world.world import World

#: How many bounces are remembered at most.
MOST_BOUNCES = 200
#: Seconds between two places of a way where nothing was hit; between them it is drawn straight.
SPACING = 1 / 24


class Wake:
    """Remembers the last `span` seconds; `note` is to be called after each step.

    The first `MOST_FOLLOWED` of the balls that are there now are followed, whenever they came.
    """

    def __init__(self, world: World, span: float) -> None:
        self.span = span
        self._world = world
        self.forget()

    def forget(self) -> None:
        """Forget all that was."""
        # Of each ball: time, x, y, and whether it bounced there.
        self._ways: dict[int, deque[tuple[float, float, float, bool]]] = {}
        self._bounces: Rows = np.zeros(0, HIT)

    @property
    def since(self) -> float:
        """The time from which on things are remembered."""
        return self._world.time - self.span

    def note(self, hits: Rows) -> None:
        """Remember where the followed balls are now, and the `hits` of the step that brought them there."""
        bounces = bounces_of(hits)
        if len(bounces) or len(self._bounces):
            joined = np.concatenate([self._bounces, bounces])
            self._bounces = joined[joined["time"] > self.since][-MOST_BOUNCES:]
        balls = self._world.balls
        ids = balls.id[:MOST_FOLLOWED].tolist()
        for gone in self._ways.keys() - set(ids):
            del self._ways[gone]
        met = {*bounces["ball"].tolist(), *bounces["shape"].tolist()} if len(bounces) else set()
        time = self._world.time
        for row, (ball, (x, y)) in enumerate(zip(ids, balls.position[:MOST_FOLLOWED].tolist(), strict=True)):
            way = self._ways.setdefault(ball, deque())
            if ball in met:
                times, centers = centers_at(bounces, ball, balls[row].radius)
                way.extend((at, *center, True) for at, center in zip(times.tolist(), centers.tolist(), strict=True))
            elif len(way) > 1 and not way[-1][3] and way[-1][0] - way[-2][0] < SPACING:
                way.pop()
            way.append((time, x, y, False))
            while way[0][0] < self.since:
                way.popleft()

    @property
    def followed(self) -> list[int]:
        """The ids of the balls that are followed."""
        return list(self._ways)

    def tracks(self) -> tuple[Track, ...]:
        """The ways of the followed balls, through the places where they bounced."""
        tables = [(ball, np.array(way)) for ball, way in self._ways.items() if len(way) > 1]
        return tuple(Track(ball, table[:, 0], table[:, 1:3]) for ball, table in tables)

    @property
    def hits(self) -> Rows:
        """The bounces, the strongest first."""
        return np.take(self._bounces, np.argsort(-self._bounces["impulse"], kind="stable"))

    @property
    def latest(self) -> Rows:
        """The latest bounces, in order of time."""
        return latest_of(self._bounces, self._world.time)
