"""What the hits of a step mean: points, balls lost, and what is lit or cleared."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.rl.marks import Marks
from carom.rows.hit import EXIT

if TYPE_CHECKING:
    from carom.rl.names import Names
    from carom.rl.task import Task
    from carom.worlds import Worlds


class Score:
    """Keeps the score of all copies, step by step: `lights` and `cleared`, and who is `in_play`, (copies, balls)."""

    def __init__(self, task: Task, names: Names, copies: int) -> None:
        self._names = names
        self._reward = task.reward
        self._seconds = task.seconds
        self._bounds = task.scene.world.bounds if task.end.bounds else None
        self._points = np.zeros((len(names.balls), len(names.columns) + 1))
        self._once = []
        for points in task.reward.points:
            balls = np.isin(np.arange(len(names.balls)), names.balls_like(points.balls))
            scoring = balls[:, None] & names.columns_like(points.shapes)
            if points.once:
                self._once.append((points.points, scoring, np.zeros((copies, len(balls)), bool)))
            else:
                self._points[scoring] += points.points
        self._drain = names.columns_like(task.end.drain)
        self.in_play = np.ones((copies, len(names.balls)), bool)
        self.lights = Marks(task.observation.lights, names, copies)
        self.cleared = Marks(task.end.cleared, names, copies)

    def count(self, worlds: Worlds, hits: NDArray[Any]) -> NDArray[np.float64]:
        """The reward of each copy for a step that had these hits; takes the balls that it has cost out of play."""
        hits = hits.view(np.ndarray)
        # Column by column: to take rows out of a structured array takes longer.
        kept = np.flatnonzero(hits["kind"] != EXIT)
        copies, columns = hits["world"][kept], self._names.columns_of(hits["shape"][kept])
        balls = self._names.balls_of(hits["ball"][kept])
        self.lights.note(copies, columns)
        self.cleared.note(copies, columns)
        # Added in the order of the hits, which is that of time within a copy.
        reward: NDArray[Any] = self._reward.second * self._seconds + np.bincount(
            copies, self._points[balls, columns], len(worlds)
        )
        for points, scoring, had in self._once:
            scored = scoring[balls, columns]
            now = np.zeros_like(had)
            now[copies[scored], balls[scored]] = True
            reward += points * (now & ~had).sum(axis=1)
            had |= now
        lost = self._strays(worlds)
        drained = self._drain[columns]
        lost[copies[drained], balls[drained]] = True
        lost &= self.in_play
        self._lose(worlds, np.flatnonzero(lost.any(axis=1)), lost)
        if self._reward.lost != 0.0:
            reward += self._reward.lost * lost.sum(axis=1)
        return reward

    def _strays(self, worlds: Worlds) -> NDArray[np.bool_]:
        """Which balls have left the bounds, of shape (copies, balls)."""
        if self._bounds is None:
            return np.zeros(self.in_play.shape, bool)
        left, bottom, right, top = self._bounds
        position = worlds.balls.position.copy()  # once, for each copy's lie on a page of their own
        x, y = position[:, :, 0], position[:, :, 1]
        strays: NDArray[np.bool_] = (x < left) | (x > right) | (y < bottom) | (y > top)
        return strays

    def _lose(self, worlds: Worlds, copies: NDArray[np.intp], lost: NDArray[np.bool_]) -> None:
        """Take balls out of play of copies that have lost some."""
        left = self.in_play[copies] & ~lost[copies]
        self.in_play[copies] = left
        # Where none is left the episode is over, and the copy need not be put in order for its next step.
        going_on = left.any(axis=1)
        worlds.balls.in_play[copies[going_on]] = left[going_on]

    def clear(self, copies: NDArray[np.int64]) -> None:
        """Begin anew in some copies."""
        self.in_play[copies] = True
        self.lights.clear(copies)
        self.cleared.clear(copies)
        for _, _, had in self._once:
            had[copies] = False
