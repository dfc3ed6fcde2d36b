"""What a world that goes on leaves behind: the ways of its balls and its bounces, for some seconds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.trace import MOST_FOLLOWED
from carom.draw.history.tracks import Track, Ways
from carom.draw.parts.moment import bounces_of, latest_of, strongest
from carom.rows.hit import HIT
from carom.world.hits import rows_of

if TYPE_CHECKING:
    from carom.rows.tables import Rows
    from carom.world.world import World

#: How many bounces are remembered at most.
MOST_BOUNCES = 200
#: Seconds between two places of a way where nothing was hit; between them it is drawn straight.
SPACING = 1 / 24


class Past:
    """Remembers the last `span` seconds; `note` is to be called after each step.

    The first `MOST_FOLLOWED` of the balls that are there now are followed, whenever they came.
    """

    def __init__(self, world: World, span: float) -> None:
        self.span = span
        self._world = world
        self.forget()

    def forget(self) -> None:
        """Forget all that was."""
        self._ways = Ways(SPACING)
        self._bounces: Rows = np.zeros(0, HIT)

    @property
    def since(self) -> float:
        """The time from which on things are remembered."""
        return self._world.time - self.span

    def note(self, hits: Rows) -> None:
        """Remember where the followed balls are now, and the `hits` of the step that brought them there."""
        bounces = bounces_of(rows_of(self._world, hits))
        if len(bounces) or len(self._bounces):
            joined = np.concatenate([self._bounces, bounces])
            self._bounces = joined[joined["time"] > self.since][-MOST_BOUNCES:]
        for gone in self._ways.keys() - set(self._world.balls.id[:MOST_FOLLOWED].tolist()):
            del self._ways[gone]
        self._ways.note(self._world, slice(MOST_FOLLOWED), bounces, self.since)

    @property
    def followed(self) -> list[int]:
        """The ids of the balls that are followed."""
        return list(self._ways)

    def tracks(self) -> tuple[Track, ...]:
        """The ways of the followed balls, through the places where they bounced."""
        return self._ways.tracks()

    @property
    def hits(self) -> Rows:
        """The bounces, the strongest first."""
        return strongest(self._bounces, MOST_BOUNCES)

    @property
    def latest(self) -> Rows:
        """The latest bounces, in order of time."""
        return latest_of(self._bounces, self._world.time)
