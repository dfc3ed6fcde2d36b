"""A single environment keeps Gymnasium's rules, and says what is wrong with what it is given."""

import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import carom
from carom.rl import TaskEnv, tasks
from tests.rl_tasks import drop_task, shot_task


@pytest.mark.parametrize("name", ["Breakout", pytest.param("Pinball", marks=[pytest.mark.slow, pytest.mark.compiled])])
def test_gymnasiums_checker_has_nothing_to_say(name: str) -> None:
    env = gymnasium.make(f"carom/{name}-v0", render_mode="rgb_array")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)
    assert isinstance(env.unwrapped, TaskEnv)


@pytest.mark.slow
@pytest.mark.compiled
def test_gymnasiums_checker_has_nothing_to_say_of_one_shot() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make("carom/Pool-v0").unwrapped)


@pytest.mark.parametrize("make", [drop_task, shot_task])
def test_the_same_seed_and_actions_give_the_same_episode(make: Any) -> None:
    def episode() -> list[Any]:
        env = TaskEnv(make())
        env.action_space.seed(3)
        told: list[Any] = [env.reset(seed=4)[0].tobytes()]
        over = False
        while not over:
            observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
            told.append((observation.tobytes(), reward, terminated, truncated, info))
            over = terminated or truncated
        return told

    first = episode()
    assert first == episode()
    assert len(first) > 4


def test_without_a_seed_episodes_differ() -> None:
    env = TaskEnv(drop_task())
    starts = [env.reset(seed=1)[0], env.reset()[0], TaskEnv(drop_task()).reset()[0], TaskEnv(drop_task()).reset()[0]]
    assert len({start.tobytes() for start in starts}) == 4


@pytest.mark.parametrize("end", [{"drain": "drain"}, {"seconds": 0.1}])
def test_a_step_beyond_the_end_is_refused(end: dict[str, Any]) -> None:
    env = TaskEnv(drop_task(end=end))
    with pytest.raises(gymnasium.error.ResetNeeded, match="has not begun"):
        env.step(1)
    env.reset(seed=1)
    over = False
    while not over:
        *_, terminated, truncated, _ = env.step(1)
        over = terminated or truncated
    with pytest.raises(gymnasium.error.ResetNeeded, match="is over"):
        env.step(1)
    env.reset()
    env.step(1)


def test_a_task_is_given_as_such_by_name_or_as_a_file(tmp_path: Path) -> None:
    path = tmp_path / "drop.toml"
    drop_task().save(path)
    assert TaskEnv(path).task == TaskEnv(str(path)).task == TaskEnv(drop_task()).task == drop_task()
    assert TaskEnv("breakout").task == tasks.breakout()
    wrongs: list[tuple[Any, str]] = [("pinbal", "did you mean 'pinball'"), (3, "no shipped task is called 3")]
    for wrong, named in [*wrongs, ("x.toml", "x.toml")]:
        with pytest.raises(carom.TaskError, match=named):
            TaskEnv(wrong)


@pytest.mark.parametrize(
    "asked",
    [{"options": {"copies": 1}}, {"options": {"copy": 1}}, {"options": {"copy": -1}, "seed": 1}],
)
def test_a_reset_that_means_nothing_is_refused(asked: dict[str, Any]) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"options|seed"):
        TaskEnv(drop_task()).reset(**asked)


def test_pictures_are_those_of_the_moment() -> None:
    env = TaskEnv(drop_task(), render_mode="rgb_array")
    assert env.metadata["render_fps"] == 20.0
    env.reset(seed=1)
    first = env.render()
    env.step(0)
    second = env.render()
    assert first is not None
    assert second is not None
    assert first.dtype == np.uint8
    assert (first != second).any()
    assert TaskEnv(drop_task()).render() is None


def test_what_is_seen_may_be_pixels() -> None:
    env = TaskEnv(drop_task(observation={"pixels": (96, 64)}))
    assert env.observation_space == gymnasium.spaces.Box(0, 255, (64, 96, 3), np.uint8)
    first, _ = env.reset(seed=1)
    second = env.step(2)[0]
    assert first in env.observation_space
    assert (first != second).any()
