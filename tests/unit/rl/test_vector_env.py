"""A vector environment is so many single ones, to the bit, and keeps Gymnasium's rules in every mode."""

from functools import partial
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import carom
from carom.rl import Task, TaskEnv, TaskVectorEnv
from tests.rl_tasks import NaiveEnv, drop_task, shot_task, yard_task

COPIES = 3
MODES = list(AutoresetMode)


def vector(task: Task, copies: int = COPIES, **options: Any) -> TaskVectorEnv:
    """A vector environment of few copies."""
    return TaskVectorEnv(task, copies, threads=1, **options)


def check_twins(task: Task, seed: int, copies: int, steps: int) -> int:
    """Assert that each copy goes the way of a plain world; the number of episodes that were over."""
    env = vector(task, copies, autoreset_mode="Disabled")
    env.action_space.seed(seed)
    twins = [NaiveEnv(task, seed, copy) for copy in range(copies)]
    observations, _ = env.reset(seed=seed)
    assert observations.tolist() == [twin.reset() for twin in twins]
    over, episodes = np.zeros(copies, bool), 0
    for _ in range(steps):
        if over.any():
            observations, _ = env.reset(options={"reset_mask": over})
            expected = [twin.reset() if over[copy] else twin.observation() for copy, twin in enumerate(twins)]
            assert observations.tolist() == expected
        actions = env.action_space.sample()
        observations, rewards, terminated, truncated, infos = env.step(actions)
        made = [twin.step(action) for twin, action in zip(twins, actions, strict=True)]
        assert observations.tolist() == [one[0] for one in made]
        assert rewards.tolist() == [one[1] for one in made]
        assert terminated.tolist() == [one[2] for one in made]
        assert truncated.tolist() == [one[3] for one in made]
        assert infos == {}
        for twin in twins:
            twin.take_out()
        over = terminated | truncated
        episodes += int(over.sum())
    return episodes


@pytest.mark.parametrize("make", [yard_task, shot_task])
def test_each_copy_goes_the_way_of_a_plain_world(make: Any) -> None:
    check_twins(make(), 0, 2, 6)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("make", [yard_task, shot_task])
def test_each_copy_goes_the_way_of_a_plain_world_for_many_episodes(make: Any, detection: str) -> None:
    task = make()
    world = task.scene.world.model_copy(update={"detection": detection})
    task = task.model_copy(update={"scene": task.scene.model_copy(update={"world": world})})
    for seed in range(3):
        assert check_twins(task, seed, COPIES, 60) > COPIES


@pytest.mark.parametrize("mode", MODES)
def test_it_is_what_gymnasium_makes_of_single_environments(mode: AutoresetMode) -> None:
    task = drop_task()
    seeds: list[int | None] = [5, 6, 7]
    ours = vector(task, autoreset_mode=mode)
    theirs = SyncVectorEnv([partial(TaskEnv, task)] * COPIES, autoreset_mode=mode)
    ours.action_space.seed(1)
    assert same(ours.reset(seed=seeds), theirs.reset(seed=seeds))
    ended = np.zeros(2, int)
    for _ in range(30):
        actions = ours.action_space.sample()
        mine = ours.step(actions)
        assert same(mine, theirs.step(actions))
        assert mine[0] in ours.observation_space
        ended += [mine[2].sum(), mine[3].sum()]
        over = mine[2] | mine[3]
        if mode == AutoresetMode.DISABLED and over.any():
            assert same(ours.reset(options={"reset_mask": over}), theirs.reset(options={"reset_mask": over}))
    assert (ended > 0).all(), "some are terminated, some are cut off"


def same(a: Any, b: Any) -> bool:
    """Whether two answers hold the same, to the bit and in their types."""
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, np.ndarray) and a.dtype == object:
        return bool(all(map(same, a, b)))
    if isinstance(a, np.ndarray):
        return bool(a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes())
    return type(a) is type(b) and bool(a == b)


def test_a_seed_gives_each_copy_numbers_of_its_own_that_a_single_environment_can_have_too() -> None:
    task = drop_task()
    observations, _ = vector(task).reset(seed=11)
    assert len({row.tobytes() for row in observations}) == COPIES
    single = TaskEnv(task)
    for copy in range(COPIES):
        assert single.reset(seed=11, options={"copy": copy})[0].tobytes() == observations[copy].tobytes()
    more, _ = vector(task, copies=2 * COPIES).reset(seed=11)
    assert same(more[:COPIES], observations)


def trained(seed: int, number: int) -> bytes:
    """What comes of a short training run: players of few weights, of which the best make the next ones."""
    env = TaskVectorEnv(drop_task(), 8, threads=number, autoreset_mode="SameStep")
    random, middle = np.random.default_rng(seed), np.zeros((3, env.single_observation_space.shape[0]))
    for generation in range(3):
        players = middle + random.normal(size=(8, *middle.shape))
        seen, _ = env.reset(seed=seed + generation)
        score = np.zeros(8)
        for _ in range(12):
            seen, reward, *_ = env.step((players @ seen.astype(float)[:, :, None])[:, :, 0].argmax(axis=1))
            score += reward
        middle = players[np.argsort(score, kind="stable")[-3:]].mean(axis=0)
    return middle.tobytes() + score.tobytes()


@pytest.mark.slow
def test_a_seed_gives_a_training_run_to_the_bit_on_any_number_of_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.worlds.threads.SHARE", 1)
    assert trained(3, 1) == trained(3, 1) == trained(3, 3) != trained(4, 1)


def test_only_those_asked_for_begin_anew() -> None:
    env = vector(drop_task(), autoreset_mode=AutoresetMode.DISABLED)
    before, _ = env.reset(seed=1)
    after, _ = env.reset(options={"reset_mask": np.array([False, True, False])})
    assert (before != after).any(axis=1).tolist() == [False, True, False]
    again, _ = env.reset(seed=1, options={"reset_mask": np.array([True, False, False])})
    assert same(again[0], before[0])
    assert same(again[1], after[1])


def test_those_that_go_on_keep_their_random_numbers() -> None:
    others: list[dict[str, Any]] = [{"seed": [8, 9, 9]}, {"seed": 9}, {}]
    after = []
    for asked in others:
        env = vector(drop_task())
        env.reset(seed=1)
        env.reset(**asked, options={"reset_mask": np.array([True, False, False])})
        after.append(env.reset()[0][1:].tobytes())
    assert len(set(after)) == 1


def test_observations_are_new_each_time() -> None:
    env = vector(drop_task())
    first, _ = env.reset(seed=1)
    kept = first.copy()
    second, *_ = env.step(np.zeros(COPIES, int))
    assert same(first, kept)
    assert not np.shares_memory(first, second)


@pytest.mark.parametrize("mode", MODES)
def test_a_step_before_the_first_reset_is_refused(mode: AutoresetMode) -> None:
    env = vector(drop_task(), autoreset_mode=mode)
    with pytest.raises(gymnasium.error.ResetNeeded, match=r"copies .*0, 1, 2"):
        env.step(np.zeros(COPIES, int))


def test_a_copy_that_is_over_and_not_reset_is_named() -> None:
    env = vector(drop_task(), autoreset_mode="Disabled")
    env.reset(seed=1)
    over = np.zeros(COPIES, bool)
    while not over.any():
        _, _, terminated, truncated, _ = env.step(np.ones(COPIES, int))
        over = terminated | truncated
    with pytest.raises(gymnasium.error.ResetNeeded, match=rf"copies \{np.flatnonzero(over).tolist()}"):
        env.step(np.ones(COPIES, int))


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"num_envs": 0}, "num_envs must be from 1"),
        ({"autoreset_mode": "never"}, "autoreset_mode must be one of 'NextStep', 'SameStep', 'Disabled', not 'never'"),
        ({"render_mode": "human"}, "render_mode must be one of 'rgb_array', not 'human'"),
        ({"thread": 2}, "thread is no argument of TaskVectorEnv.*did you mean threads"),
    ],
)
def test_what_it_cannot_be_is_refused(options: dict[str, Any], named: str) -> None:
    make: Any = partial(TaskVectorEnv, drop_task())
    with pytest.raises(carom.InvalidArgument, match=named):
        make(**options)


@pytest.mark.parametrize(
    "asked",
    [
        {"seed": [1, 2]},
        {"options": {"mask": 1}},
        {"options": {"reset_mask": np.zeros(COPIES, bool)}},
        {"options": {"reset_mask": np.ones(COPIES + 1, bool)}},
        {"options": {"reset_mask": np.ones(COPIES, int)}},
    ],
)
def test_a_reset_that_means_nothing_is_refused(asked: dict[str, Any]) -> None:
    env = vector(drop_task())
    before, _ = env.reset(seed=3)
    with pytest.raises(carom.InvalidArgument, match=r"seed|options"):
        env.reset(**asked)
    assert same(env.step(np.ones(COPIES, int))[0], follower(3))
    assert before.shape == (COPIES, 8)


def follower(seed: int) -> Any:
    """The observation after a reset and one step."""
    env = vector(drop_task())
    env.reset(seed=seed)
    return env.step(np.ones(COPIES, int))[0]


def test_gymnasium_makes_it() -> None:
    made = gymnasium.make_vec("carom/Breakout-v0", num_envs=2, autoreset_mode="SameStep", render_mode="rgb_array")
    assert isinstance(made.unwrapped, TaskVectorEnv)
    assert made.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP
    assert made.unwrapped.spec is not None
    assert repr(made) == "TaskVectorEnv(carom/Breakout-v0, num_envs=2)"
    observations, _ = made.reset(seed=1)
    assert observations in made.observation_space
    frames = [np.asarray(frame) for frame in made.render() or ()]
    assert [frame.shape for frame in frames] == [(600, 480, 3)] * 2
    assert (frames[0] != frames[1]).any()
    assert vector(drop_task()).render() is None
    made.close()
