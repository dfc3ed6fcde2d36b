"""Actions set speeds and strike balls, each copy as it is told, and nothing at all where one of them is none."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

import carom
from carom.rl import Impulse, Task, Travel, Turn
from carom.rl.actions import Actions
from carom.rl.names import Names
from tests.rl_tasks import drop_task, shot_task, yard_task
from tests.slow_worlds import SlowWorlds


def acting(task: Task, copies: int = 2) -> tuple[Any, Actions]:
    """Copies of a task's world, and what acts on them."""
    worlds: Any = SlowWorlds(task.scene, copies)
    return worlds, Actions(task, Names(task.scene.build()), worlds)


def test_spaces_say_what_there_is_to_choose() -> None:
    assert acting(yard_task())[1].space == spaces.MultiDiscrete([2, 3])
    assert acting(drop_task())[1].space == spaces.Discrete(3)
    assert acting(shot_task())[1].space == spaces.Box(-1.0, 1.0, (3,), np.float32)


def test_each_copy_is_driven_as_it_is_told() -> None:
    worlds, actions = acting(yard_task())
    actions.act(np.array([[0, 2], [1, 0]]))
    assert worlds.shapes["flipper"].angular_velocity.tolist() == [-9.0, 12.0]
    assert worlds.shapes["paddle"].velocity.tolist() == [[6.0, 0.0], [-6.0, 0.0]]


def test_a_paddle_goes_to_the_end_of_its_way_and_no_further() -> None:
    travel = Travel(shape="paddle", speeds=(8.0, -8.0), direction=(-3.0, 0.0), limits=(-4.0, 1.0))
    worlds, actions = acting(drop_task(actuators=[travel]))
    for _ in range(12):
        actions.act(np.array([0, 1]))
        worlds.step(0.05)
    assert (worlds.shapes["paddle"].position[:, 0] - 3.0).tolist() == pytest.approx([-1.0, 4.0])
    assert worlds.shapes["paddle"].velocity.ravel().tolist() == pytest.approx([0.0] * 4, abs=1e-9)


def test_a_way_is_of_length_one_whatever_is_given() -> None:
    travel = Travel(shape="paddle", speed=10.0, direction=(3.0, 4.0))
    worlds, actions = acting(drop_task(actuators=[travel]))
    actions.act(np.array([[1.0], [-0.5]], np.float32))
    assert worlds.shapes["paddle"].velocity.tolist() == [pytest.approx([6.0, 8.0]), pytest.approx([-3.0, -4.0])]


def test_a_stroke_adds_to_the_velocity_and_is_no_longer_than_one() -> None:
    worlds, actions = acting(shot_task(actuators=[Impulse(ball="ball 1", speed=5.0)]), 4)
    before = worlds.balls.velocity.copy()
    worlds.balls.in_play[3, 0] = False
    actions.act(np.array([[0.5, 0.0], [3.0, -4.0], [0.6, 0.8], [1.0, 0.0]]))
    added = worlds.balls.velocity - before
    assert added[:, 0].tolist() == [
        pytest.approx([2.5, 0.0]),
        pytest.approx([5.0 / 2**0.5, -5.0 / 2**0.5]),  # each number is cut at 1 first
        pytest.approx([3.0, 4.0]),
        [0.0, 0.0],
    ]
    assert (added[:, 1] == 0.0).all()


@pytest.mark.parametrize(
    ("make", "wrong"),
    [
        (yard_task, [[0, 1]]),
        (yard_task, [[0, 1], [0, 3]]),
        (yard_task, [[0, 1], [-1, 0]]),
        (yard_task, [[0.0, 1.0], [0.0, 1.0]]),
        (drop_task, [[0], [1]]),
        (drop_task, [True, False]),
        (drop_task, [0, 3]),
        (shot_task, [[0.0, 0.0, 0.0], [0.0, float("nan"), 0.0]]),
        (shot_task, [[0.0, 0.0], [0.0, 0.0]]),
        (shot_task, [["a", "b", "c"], ["a", "b", "c"]]),
    ],
)
def test_what_is_no_action_is_refused_before_anything_is_done(make: Any, wrong: Any) -> None:
    worlds, actions = acting(make())
    before = worlds.digests()
    with pytest.raises(carom.InvalidArgument, match=r"^actions must be"):
        actions.act(np.array(wrong))
    assert worlds.digests().tolist() == before.tolist()


def test_a_turn_may_be_any_part_of_its_speed() -> None:
    worlds, actions = acting(yard_task(actuators=[Turn(shape="flipper", speed=8.0)]))
    actions.act(np.array([[0.25], [-7.0]]))
    assert worlds.shapes["flipper"].angular_velocity.tolist() == [2.0, -8.0]
