"""`TaskEnv`: one task as an environment of Gymnasium."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Literal

import gymnasium
import numpy as np
from numpy.typing import NDArray

from carom.checks import instance, one_of, refuse, whole
from carom.rl import tasks
from carom.rl.episodes import Episodes
from carom.rl.starting import MOST_SEED, generators
from carom.rl.task import Task
from carom.spelling import spelled

RENDER_MODES = ("rgb_array",)


@spelled
class TaskEnv(gymnasium.Env[NDArray[Any], Any]):
    """A task, to be done once at a time.

    Args:
        task: A `Task`, the name of a shipped one, or a task file.
        render_mode: None, or "rgb_array" for pictures by `render`.

    Raises:
        TaskError: There is no such task, or something is wrong with it.
        InvalidArgument: There is no such way to render.

    >>> import carom.rl
    >>> env = carom.rl.TaskEnv("pinball")
    >>> observation, info = env.reset(seed=1)
    >>> observation in env.observation_space
    True
    """

    metadata = {"render_modes": list(RENDER_MODES)}  # noqa: RUF012  # Gymnasium's, which is no constant

    def __init__(self, task: Task | str | os.PathLike[str], render_mode: Literal["rgb_array"] | None = None) -> None:
        self.task = task_of(task)
        self.render_mode = render_mode_of(render_mode)
        self.metadata = self.metadata | {"render_fps": 1.0 / self.task.seconds}
        self._episodes = Episodes(self.task, 1, 1)
        self.action_space = self._episodes.action_space
        self.observation_space = self._episodes.observation_space
        self._over = True

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """The first observation of a new episode, and an empty dictionary.

        Args:
            seed: What it starts by is drawn from; None goes on with the numbers that come next.
            options: `{"copy": k}`, together with a seed: starts as copy `k` of a vector environment does that was
                given this seed. By default it does as copy 0.
        """
        copy = _copy_of(options, seed)
        if seed is not None:
            seed = whole("seed", seed, 0, MOST_SEED)
            super().reset(seed=seed)
            (self._np_random,) = generators(seed, [copy])
        self._episodes.random = [self.np_random]
        self._episodes.begin(np.array([0]))
        self._over = False
        return self._episodes.observe()[0], {}

    def step(self, action: Any) -> tuple[NDArray[Any], float, bool, bool, dict[str, Any]]:
        """Observation, reward, whether it is terminated, whether it is cut off, and an empty dictionary.

        Raises:
            InvalidArgument: There is no such action.
            gymnasium.error.ResetNeeded: The episode is over, or none has begun.
        """
        if self._over:
            raise gymnasium.error.ResetNeeded("the episode is over, or has not begun: call reset() first")
        reward, terminated, truncated = self._episodes.step(np.asarray(action)[None])
        self._over = bool(terminated[0] or truncated[0])
        return self._episodes.observe()[0], float(reward[0]), bool(terminated[0]), bool(truncated[0]), {}

    def render(self) -> NDArray[np.uint8] | None:
        """A picture of the world as it stands, of shape (height, width, 3), or None without a `render_mode`.

        Raises:
            MissingExtra: pygame is not installed.
        """
        return None if self.render_mode is None else self._episodes.picture(0)


def _copy_of(options: dict[str, Any] | None, seed: int | None) -> int:
    """The copy of a vector environment that options of a reset speak of."""
    given = given_options(options)
    if unknown := set(given) - {"copy"}:
        raise refuse("options", "must be 'copy' alone", sorted(map(str, unknown)))
    if "copy" in given and seed is None:
        raise refuse("seed", "must be given for a copy to start as", seed)
    return whole("options['copy']", given.get("copy", 0))


def given_options(options: Any) -> dict[str, Any]:
    """The options of a reset as a table; None is an empty one."""
    return {} if options is None else instance("options", options, dict, "a dictionary or None")


def task_of(task: Any) -> Task:
    """The task that is meant: one itself, a shipped one by its name, or one in a file."""
    if isinstance(task, Task):
        return task
    named = isinstance(task, str) and (task in tasks.__all__ or not Path(task).suffix)
    return Task.load(task) if isinstance(task, (str, os.PathLike)) and not named else tasks.by_name(task)


def render_mode_of(mode: Any) -> Any:
    """The way to render, unless there is no such."""
    return None if mode is None else one_of("render_mode", mode, RENDER_MODES)
