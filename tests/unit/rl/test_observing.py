"""What is seen is scaled to the table, bounded, and in the order that is told."""

from typing import Any

import numpy as np
import pytest

import carom
from carom.rl import Observation, Task
from carom.rl.names import Names
from carom.rl.observing import Numbers, fastest
from carom.rl.picturing import table_box
from carom.rl.scoring import Score
from tests.rl_tasks import drop_task, yard, yard_task
from tests.slow_worlds import SlowWorlds


def watched(task: Task, copies: int = 2) -> tuple[Any, Score, Numbers]:
    """Copies of a task's world, their score, and who sees them."""
    world = task.scene.build()
    names = Names(world)
    worlds: Any = SlowWorlds(task.scene, copies)
    score = Score(task, names, copies)
    return worlds, score, Numbers(task, names, worlds, score, table_box(world))


def test_balls_are_seen_between_the_sides_of_the_table() -> None:
    worlds, _, numbers = watched(yard_task(observation=Observation(speed=4.0)))
    worlds.balls.position[0] = [(0.0, 0.0), (10.0, 5.0)]
    worlds.balls.position[1] = [(5.0, 5.0), (40.0, -40.0)]
    worlds.balls.velocity[...] = [(1.0, -2.0), (0.0, 9.0)]
    assert numbers.see().tolist() == [
        [-1.0, -1.0, 0.25, -0.5, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
        [0.0, 0.0, 0.25, -0.5, 1.0, 1.0, -1.0, 0.0, 1.0, 1.0],
    ]
    assert numbers.space.shape == (10,)


def test_a_ball_that_is_lost_is_seen_as_nothing() -> None:
    _, score, numbers = watched(yard_task(observation=Observation()))
    score.in_play[1, 0] = False
    seen = numbers.see()
    assert seen[1, :5].tolist() == [0.0] * 5
    assert seen[0, 4] == seen[1, 9] == 1.0


def test_one_ball_alone_needs_no_word_on_whether_it_is_there() -> None:
    assert watched(drop_task(observation=Observation()))[2].space.shape == (4,)


def test_orientation_goes_from_stop_to_stop_and_round_where_there_is_none() -> None:
    _, _, numbers = watched(yard_task(observation=Observation(balls=None, turning="flipper|spinner")))
    flipper, spinner = numbers.see()[0, :2], numbers.see()[0, 2:]
    assert flipper.tolist() == pytest.approx([(0.0 - 0.3) / 0.5, 0.0])
    assert spinner.tolist() == [0.0, 1.0, 1.0]
    worlds, _, numbers = watched(yard_task(observation=Observation(balls=None, turning="flipper|spinner")))
    worlds.shapes["flipper"].angular_velocity = [12.0, -9.0]
    for _ in range(20):
        worlds.step(0.05)
    seen = numbers.see()
    assert seen[:, 0].tolist() == [1.0, -1.0]
    assert seen[:, 2:4].tolist() == [pytest.approx([np.sin(3.0), np.cos(3.0)], abs=1e-6)] * 2


def test_travelling_shapes_have_place_and_velocity() -> None:
    worlds, _, numbers = watched(yard_task(observation=Observation(balls=None, travelling="paddle")))
    worlds.shapes["paddle"].velocity = [(6.0, 0.0), (-3.0, 0.0)]
    assert numbers.see().tolist() == [
        pytest.approx([0.2, -0.8, 1.0, 0.0]),
        pytest.approx([0.2, -0.8, -0.5, 0.0]),
    ]


def test_lights_are_seen_as_they_are_lit() -> None:
    _, score, numbers = watched(yard_task(observation=Observation(balls=None, lights="brick.*")))
    score.lights.hit[1, 0] = True
    assert numbers.see().tolist() == [[0.0, 0.0], [1.0, 0.0]]


def test_the_speed_that_is_one_is_told_or_the_worlds_or_the_tables() -> None:
    def seen(task: Task) -> float:
        worlds, _, numbers = watched(task)
        worlds.balls.velocity[...] = (2.0, 0.0)
        return float(numbers.see()[0, 2])

    limited = yard().model_copy(update={"world": yard().world.model_copy(update={"max_speed": 5.0})})
    assert seen(yard_task(observation=Observation(speed=4.0))) == 0.5
    assert seen(yard_task(observation=Observation(), scene=limited)) == pytest.approx(0.4)
    assert seen(yard_task(observation=Observation())) == pytest.approx(0.2), "ten a second, the room's side"


def test_a_table_without_height_is_seen_too() -> None:
    scene = carom.Scene(
        shapes=[carom.Segment((0, 0), (4, 0), motion="kinematic", name="bar")], balls=[carom.Ball((1.0, 0.0), 0.5)]
    )
    task = Task(scene=scene, actuators=[{"kind": "turn", "shape": "bar", "speed": 1.0}])
    assert watched(task)[2].see()[0].tolist() == [-0.5, 0.0, 0.0, 0.0]


def test_shapes_are_as_fast_as_an_actuator_drives_them_or_as_they_are() -> None:
    names = Names(yard().build())
    speeds = {names.shapes[index].name: speed for index, speed in fastest(yard_task(), names).items()}
    assert (speeds["flipper"], speeds["paddle"], speeds["spinner"], speeds["bumper 1"]) == (12.0, 6.0, 3.0, 1.0)
