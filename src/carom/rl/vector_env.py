"""`TaskVectorEnv`: a task done in many copies at once, as a vector environment of Gymnasium."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Literal

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from carom.checks import refuse, whole
from carom.rl.env import RENDER_MODES, given_options, render_mode_of, task_of
from carom.rl.episodes import Episodes
from carom.rl.starting import MOST_SEED, generators
from carom.rl.task import Task
from carom.spelling import spelled

Flags = NDArray[np.bool_]
Step = tuple[NDArray[Any], NDArray[np.float64], Flags, Flags, dict[str, Any]]


@spelled
class TaskVectorEnv(VectorEnv[NDArray[Any], Any, NDArray[Any]]):
    """A task, done in `num_envs` copies at once; each goes the way that a `TaskEnv` goes, to the bit.

    Args:
        task: A `Task`, the name of a shipped one, or a task file.
        num_envs: How many copies there are.
        threads: How many threads step them; None for as many as there are cores. It changes no bit.
        autoreset_mode: When a copy whose episode is over begins anew, as an `AutoresetMode` or its value: with the next
            step, whose action it does not heed; within the same step, where `infos` have the last observation as
            `final_obs`; or when it is told to, by `reset(options={"reset_mask": …})`.
        render_mode: None, or "rgb_array" for pictures by `render`.

    Raises:
        TaskError: There is no such task, or something is wrong with it.
        InvalidArgument: There is no such mode, or not one copy.
    """

    metadata = {"render_modes": list(RENDER_MODES)}  # noqa: RUF012  # Gymnasium's, which is no constant

    def __init__(
        self,
        task: Task | str | os.PathLike[str],
        num_envs: int = 1,
        *,
        threads: int | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: Literal["rgb_array"] | None = None,
    ) -> None:
        self.task = task_of(task)
        self.num_envs = whole("num_envs", num_envs, 1)
        self.render_mode = render_mode_of(render_mode)
        self._mode = mode_of(autoreset_mode)
        self.metadata = self.metadata | {"render_fps": 1.0 / self.task.seconds, "autoreset_mode": self._mode}
        self._episodes = Episodes(self.task, self.num_envs, threads)
        self.single_action_space = self._episodes.action_space
        self.single_observation_space = self._episodes.observation_space
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self._over = np.ones(self.num_envs, bool)
        self._begun = False

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """The first observations of new episodes, and an empty dictionary.

        Args:
            seed: One from which a generator is spawned for each copy, or one for each, with which it starts as a
                `TaskEnv` does that is given it. None goes on with the numbers that come next.
            options: `{"reset_mask": mask}`: only these copies begin anew.
        """
        which = self._asked(options)
        if seed is not None:
            self._seed(seed, which)
        self._episodes.begin(which)
        self._over[which] = False
        self._begun = True
        return self._episodes.observe(), {}

    def _asked(self, options: dict[str, Any] | None) -> NDArray[np.int64]:
        """The copies that are to begin anew."""
        given = given_options(options)
        if unknown := set(given) - {"reset_mask"}:
            raise refuse("options", "must be 'reset_mask' alone", sorted(map(str, unknown)))
        mask = np.asarray(given.get("reset_mask", np.ones(self.num_envs, bool)))
        if mask.shape != (self.num_envs,) or mask.dtype != bool or not mask.any():
            raise refuse("options['reset_mask']", f"must be {self.num_envs} booleans, not all of them False", mask)
        return np.flatnonzero(mask)

    def _seed(self, seed: Any, which: NDArray[np.int64]) -> None:
        """Give the copies that begin anew generators of their own."""
        random = self._episodes.random
        if np.ndim(seed) == 0:
            one = whole("seed", seed, 0, MOST_SEED)
            super().reset(seed=one)
            for copy, spawned in zip(which, generators(one, which.tolist()), strict=True):
                random[copy] = spawned
            return
        if len(seed) != self.num_envs:
            raise refuse("seed", f"must be one, or {self.num_envs}", seed)
        seeds = [None if one is None else whole("seed", one, 0, MOST_SEED) for one in seed]
        for copy in which.tolist():
            own = seeds[copy]
            if own is not None:
                (random[copy],) = generators(own, [0])

    def step(self, actions: Any) -> Step:
        """Observations, rewards, whether each copy is terminated, whether it is cut off, and infos.

        Raises:
            InvalidArgument: The actions are not such.
            gymnasium.error.ResetNeeded: An episode is over, or none has begun, and it does not begin by itself.
        """
        over = self._over
        if over.any() and (self._mode != AutoresetMode.NEXT_STEP or not self._begun):
            raise gymnasium.error.ResetNeeded(f"call reset() first, for copies {np.flatnonzero(over).tolist()}")
        episodes = self._episodes
        reward, terminated, truncated = episodes.step(actions)
        infos: dict[str, Any] = {}
        if over.any():
            episodes.begin(np.flatnonzero(over))
            reward[over], terminated[over], truncated[over] = 0.0, False, False
        observations = episodes.observe()
        self._over = terminated | truncated
        if self._mode == AutoresetMode.SAME_STEP and self._over.any():
            infos = self._begin_at_once(observations)
            observations = episodes.observe()
        return observations, reward, terminated, truncated, infos

    def _begin_at_once(self, observations: NDArray[Any]) -> dict[str, Any]:
        """Begin anew where an episode is over; return what is told of its end."""
        over = self._over
        last = np.full(self.num_envs, None, dtype=object)
        for copy in np.flatnonzero(over):
            last[copy] = observations[copy]
        self._episodes.begin(np.flatnonzero(over))
        self._over = np.zeros(self.num_envs, bool)
        return {"final_obs": last, "_final_obs": over, "final_info": {}, "_final_info": over.copy()}

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """A picture of each copy as it stands, of shape (height, width, 3), or None without a `render_mode`.

        Raises:
            MissingExtra: pygame is not installed.
        """
        if self.render_mode is None:
            return None
        return tuple(self._episodes.picture(copy) for copy in range(self.num_envs))


def mode_of(mode: AutoresetMode | str) -> AutoresetMode:
    """The mode of that value; raises `InvalidArgument` where there is none."""
    try:
        return AutoresetMode(mode)
    except ValueError:
        there_are = ", ".join(repr(one.value) for one in AutoresetMode)
        raise refuse("autoreset_mode", f"must be one of {there_are}", mode) from None
