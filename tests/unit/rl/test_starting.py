"""Episodes start where a copy's own random numbers put them, within the spreads, and evenly."""

from collections.abc import Sequence
from math import pi
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from carom.rl import Spread, Task
from carom.rl.names import Names
from carom.rl.starting import Start, generators
from tests.rl_tasks import drop_task, yard_task


def started(task: Task, copies: int, which: Sequence[int] | None = None) -> Any:
    """The balls of many copies of a task's world, put as episodes start."""
    balls = task.scene.balls
    columns = {name: np.array([[getattr(ball, name) for ball in balls]] * copies) for name in ("position", "velocity")}
    worlds: Any = SimpleNamespace(balls=SimpleNamespace(**columns))
    Start(task, Names(task.scene.build())).put(worlds, which or range(copies), generators(0, range(copies)))
    return worlds


def test_a_copy_has_the_numbers_of_a_child_of_the_seed() -> None:
    children = np.random.SeedSequence(5).spawn(4)
    for copy, generator in zip((1, 3), generators(5, [1, 3]), strict=True):
        assert generator.random() == np.random.Generator(np.random.PCG64(children[copy])).random()
    assert generators(None, [0])[0].random() != generators(None, [0])[0].random()


def test_places_and_velocities_are_spread_evenly() -> None:
    worlds = started(drop_task(start=[Spread(position=(1.0, 0.5), velocity=(2.0, 4.0))]), 200)
    for found, middle, half in (
        (worlds.balls.position[:, 0], (0.0, 2.0), (1.0, 0.5)),
        (worlds.balls.velocity[:, 0], (0.5, 0.0), (2.0, 4.0)),
    ):
        off = (found - middle) / half
        assert np.abs(off).max() <= 1.0
        # Of 200 even numbers from -1 to 1: the mean has a deviation of 0.041, the variance is 1/3 within 0.021.
        assert np.abs(off.mean(axis=0)).max() < 4 * 0.041
        assert np.abs(off.var(axis=0) - 1 / 3).max() < 4 * 0.021


def test_a_turn_changes_the_way_and_not_the_speed() -> None:
    worlds = started(drop_task(start=[Spread(angle=pi / 2)]), 50)
    vx, vy = worlds.balls.velocity[:, 0].T
    assert np.hypot(vx, vy).tolist() == pytest.approx([0.5] * 50)
    assert np.abs(np.arctan2(vy, vx)).max() <= pi / 2
    assert np.ptp(np.arctan2(vy, vx)) > pi / 2


def test_only_the_balls_and_copies_that_are_meant_are_moved() -> None:
    task = yard_task(start=[Spread(balls="ball 2", position=(0.5, 0.5))])
    before = np.array([ball.position for ball in task.scene.balls])
    worlds = started(task, 3, which=[1])
    moved = (worlds.balls.position != before).any(axis=2)
    assert moved.tolist() == [[False, False], [False, True], [False, False]]
