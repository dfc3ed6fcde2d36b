"""Episodes end for the reasons that a task gives, and begin anew from the start."""

import numpy as np
import pytest

import carom
from carom.rl import End, Task
from carom.rl.episodes import Episodes
from tests.rl_tasks import drop_task, yard_task


def lengths(task: Task, copies: int = 3, most: int = 60) -> list[tuple[int, bool, bool]]:
    """How many steps the first episode of each copy takes, and whether it is terminated or truncated."""
    episodes = Episodes(task, copies, 1)
    episodes.begin(np.arange(copies))
    found: list[tuple[int, bool, bool]] = [(0, False, False)] * copies
    for step in range(1, most + 1):
        _, terminated, truncated = episodes.step(np.ones(copies, int))
        for copy in range(copies):
            if found[copy][0] == 0 and (terminated[copy] or truncated[copy]):
                found[copy] = (step, bool(terminated[copy]), bool(truncated[copy]))
    return found


def test_a_drained_ball_ends_it() -> None:
    # From 1.7 above the drain, at 9 a second and second: 0.61 s, so in the thirteenth step of 0.05.
    assert lengths(drop_task(start=[], end=End(drain="drain", seconds=5.0))) == [(13, True, False)] * 3


def test_time_cuts_it_off() -> None:
    assert lengths(drop_task(start=[], end=End(drain="drain", seconds=0.5))) == [(10, False, True)] * 3


def test_the_next_episode_has_as_much_time() -> None:
    episodes = Episodes(drop_task(start=[], end=End(seconds=0.2)), 2, 1)
    for _ in range(2):
        episodes.begin(np.arange(2))
        cut = [episodes.step(np.ones(2, int))[2].tolist() for _ in range(4)]
        assert cut == [[False, False]] * 3 + [[True, True]]


def test_a_number_of_actions_ends_it() -> None:
    assert lengths(drop_task(end=End(actions=4))) == [(4, True, False)] * 3


def test_what_is_cleared_ends_it() -> None:
    task = drop_task(start=[], end=End(cleared="drain"))
    assert [one[1:] for one in lengths(task)] == [(True, False)] * 3


def test_an_episode_begins_as_the_scene_is() -> None:
    episodes = Episodes(yard_task(start=[]), 2, 1)
    episodes.begin(np.arange(2))
    first = episodes.observe()
    for _ in range(3):
        episodes.step(np.array([[1, 2], [0, 0]]))
    later = episodes.observe()
    episodes.begin(np.array([1]))
    seen = episodes.observe()
    assert seen[1].tolist() == first[1].tolist()
    assert seen[0].tolist() == later[0].tolist() != first[0].tolist()
    assert episodes.worlds.time.tolist() == pytest.approx([0.2, 0.0])


def test_it_stands_over_the_worlds_of_carom() -> None:
    assert isinstance(Episodes(drop_task(), 2, None).worlds, carom.Worlds)
