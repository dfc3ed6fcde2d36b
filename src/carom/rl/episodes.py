"""The episodes of a task in many copies of its world: what both kinds of environment are made of."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

import carom
from carom.rl.actions import Actions
from carom.rl.names import Names
from carom.rl.observing import Numbers
from carom.rl.picturing import Camera, table_box
from carom.rl.scoring import Score
from carom.rl.starting import Start, generators

if TYPE_CHECKING:
    from carom.rl.task import Task


class Episodes:
    """One episode in each copy, which all make a step at once."""

    def __init__(self, task: Task, copies: int, threads: int | None) -> None:
        world = task.scene.build()
        names = Names(world)
        self.copies = copies
        self.worlds = carom.Worlds(task.scene, copies=copies, threads=threads)
        self.random = generators(None, range(copies))
        self.score = Score(task, names, copies)
        self._task = task
        self._actions = Actions(task, names, self.worlds)
        self._start = Start(task, names)
        self._numbers = Numbers(task, names, self.worlds, self.score, table_box(world))
        self._eye = Camera(task.scene, task.observation.pixels) if task.observation.pixels else None
        self._camera: Camera | None = None
        self._steps = np.zeros(copies, np.int64)
        seconds = task.end.seconds
        self._most = np.inf if seconds is None else max(1, round(seconds / task.seconds))

    @property
    def action_space(self) -> spaces.Space[Any]:
        """The space of the actions of one copy."""
        return self._actions.space

    @property
    def observation_space(self) -> spaces.Box:
        """The space of the observations of one copy."""
        if self._eye is None:
            return self._numbers.space
        width, height = self._eye.size
        return spaces.Box(0, 255, (height, width, 3), np.uint8)

    def begin(self, copies: NDArray[np.int64]) -> None:
        """Begin new episodes in some copies."""
        self.worlds.reset(copies)
        self.score.clear(copies)
        self._steps[copies] = 0
        self._start.put(self.worlds, copies.tolist(), self.random)

    def step(self, actions: Any) -> tuple[NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_]]:
        """The reward of each copy for one step, and whether its episode is terminated, or cut off."""
        task, worlds = self._task, self.worlds
        self._actions.act(actions)
        hits = worlds.step(task.dt) if task.steps == 1 else worlds.run(task.seconds, task.dt)
        self._steps += 1
        reward = self.score.count(worlds, hits)
        terminated = np.logical_not(self.score.in_play.any(axis=1))
        if task.end.cleared is not None:
            terminated |= self.score.cleared.hit.all(axis=1)
        if task.end.actions is not None:
            terminated |= self._steps >= task.end.actions
        return reward, terminated, self._steps >= self._most

    def observe(self) -> NDArray[Any]:
        """The observation of each copy, a new array."""
        if self._eye is None:
            return self._numbers.see()
        return np.array([self._eye.take(self.worlds[copy]) for copy in range(self.copies)])

    def picture(self, copy: int) -> NDArray[np.uint8]:
        """A picture of one copy, of shape (height, width, 3)."""
        self._camera = self._camera or Camera(self._task.scene)
        return self._camera.take(self.worlds[copy])
