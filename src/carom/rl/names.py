"""What bears which name in a world, and where arrays have it."""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from carom.record.members import parts
from carom.shapes.label import name_of
from carom.world.world import World


class Names:
    """The names of a world's shapes, of their parts and of its balls, each at its place in arrays.

    `columns` are the names of all shapes that a hit can name, in order, and one more for all else that it may: a ball.
    """

    def __init__(self, world: World) -> None:
        self.shapes = list(world.shapes)
        self.balls = [ball.name or "" for ball in world.balls]
        self.ball_ids = world.balls.id.copy()
        single = parts(self.shapes)
        self.columns = [name_of(part) or "" for part in single]
        ids = [part.id or 0 for part in single]
        # Ids are given in turn to shapes and balls, so the greatest is about as large as there are members.
        self._column = np.full(max([*ids, *self.ball_ids.tolist()]) + 1, len(ids))
        self._column[ids] = np.arange(len(ids))

    def columns_of(self, ids: NDArray[np.int64]) -> NDArray[np.int64]:
        """The column of each id that a hit names as its shape."""
        found: NDArray[np.int64] = self._column[ids]
        return found

    def balls_of(self, ids: NDArray[np.int64]) -> NDArray[np.int64]:
        """The index of each ball, given its id."""
        return np.searchsorted(self.ball_ids, ids)

    def bearers(self, name: str) -> list[int]:
        """The indices of the shapes and compounds of that name."""
        return [index for index, shape in enumerate(self.shapes) if shape.name == name]

    def shapes_like(self, pattern: str | None) -> list[int]:
        """The indices of the shapes and compounds that are meant."""
        return [index for index, shape in enumerate(self.shapes) if meant(pattern, shape.name or "")]

    def balls_like(self, pattern: str | None) -> list[int]:
        """The indices of the balls that are meant."""
        return [index for index, name in enumerate(self.balls) if meant(pattern, name)]

    def columns_like(self, pattern: str | None) -> NDArray[np.bool_]:
        """Which columns are meant."""
        return np.array([*(meant(pattern, name) for name in self.columns), False])


def meant(pattern: str | None, name: str) -> bool:
    """Whether a regular expression matches the whole of a name; None matches nothing."""
    return pattern is not None and re.fullmatch(pattern, name) is not None
