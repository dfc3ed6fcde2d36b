"""Tasks are checked as a whole, say where each fault is, and come back from a file as they were."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom.rl import Observation, Task, Travel, Turn, tasks
from tests.rl_tasks import drop_task, shot_task, yard, yard_task

TURN = {"kind": "turn", "shape": "flipper", "speeds": [-1.0, 1.0]}


def faults(**changes: Any) -> list[str]:
    """The faults of a task in the yard with some fields changed."""
    with pytest.raises(carom.TaskError) as caught:
        Task(**{"scene": yard(), "actuators": [TURN]} | changes)
    return [line.strip() for line in str(caught.value).splitlines()]


@pytest.mark.parametrize("ending", ["toml", "json"])
@pytest.mark.parametrize("make", [drop_task, yard_task, shot_task, tasks.pinball, tasks.breakout, tasks.pool])
def test_a_file_holds_all_of_it(make: Any, ending: str, tmp_path: Path) -> None:
    path = tmp_path / f"task.{ending}"
    make().save(path)
    assert Task.load(path) == make()


def test_a_file_may_name_the_file_of_its_scene(tmp_path: Path) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    yard().save(folder / "yard.toml")
    (folder / "task.toml").write_text(
        'version = 1\nscene = "yard.toml"\ndt = 0.02\n'
        '[[actuators]]\nkind = "turn"\nshape = "flipper"\nspeeds = [-3, 3]\n'
        '[observation]\nturning = "flipper"\n[[start]]\nangle = 0.5\n'
    )
    task = Task.load(folder / "task.toml")
    assert task.scene == yard()
    assert task.actuators == (Turn(shape="flipper", speeds=(-3.0, 3.0)),)
    assert (task.dt, task.steps, task.seconds) == (0.02, 1, 0.02)


def test_a_scene_is_given_by_name_as_a_table_or_as_a_world() -> None:
    by_name = Task(scene="pinball", actuators=[Turn(shape="left flipper", speed=3.0)])
    assert by_name.scene == carom.scenes.pinball()
    assert Task(scene=yard().plain(), actuators=[TURN]).scene == yard()
    world = yard().build()
    world.run(0.1)
    assert Task(scene=world, actuators=[TURN]).scene == carom.Scene.from_world(world)


def test_all_faults_are_told_at_once_each_with_its_path() -> None:
    told = faults(
        actuators=[{"kind": "turn", "shape": "flipper", "sped": 1.0}, {"kind": "push"}],
        observation={"turning": "("},
        end={"seconds": -1.0},
        reward={"points": [{"shapes": "wall"}]},
        dt=0.0,
    )
    assert told == [
        "6 faults",
        "actuators[0].sped: is unknown; did you mean speed?",
        "actuators[1].kind: must be one of 'turn', 'travel', 'impulse', not 'push'",
        "observation.turning: must be a regular expression, not '(': missing ), unterminated subpattern at position 0",
        "reward.points[0].points: is missing",
        "end.seconds: must be positive, not -1.0",
        "dt: must be positive, not 0.0",
    ]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"actuators": []}, "actuators: must be at least one"),
        (
            {"actuators": [TURN | {"shape": "wall"}]},
            "actuators[0].shape: must be the name of one shape or compound, not that of 3: 'wall'",
        ),
        (
            {"actuators": [TURN | {"shape": "bumper 1"}]},
            "actuators[0].shape: must be that of a compound or a kinematic shape, not 'bumper 1'",
        ),
        (
            {"actuators": [{"kind": "impulse", "ball": "ball 9", "speed": 1.0}]},
            "actuators[0].ball: must be the name of one ball, not that of 0: 'ball 9'",
        ),
        (
            {"actuators": [TURN, {"kind": "turn", "shape": "spinner", "speed": 1.0}]},
            "actuators: must all have `speeds` to choose from, or none of them",
        ),
        ({"observation": {"lights": "bumpr.*"}}, "observation.lights: must mean a shape of the scene, not 'bumpr.*'"),
        ({"observation": {"balls": "cue"}}, "observation.balls: must mean a ball of the scene, not 'cue'"),
        ({"observation": {"turning": "blade"}}, "observation.turning: must mean a shape of the scene, not 'blade'"),
        ({"end": {"drain": "drian"}}, "end.drain: must mean a shape of the scene, not 'drian'"),
        (
            {"reward": {"points": [{"shapes": "x", "points": 1.0}]}},
            "reward.points[0].shapes: must mean a shape of the scene, not 'x'",
        ),
        ({"start": [{"balls": "x"}]}, "start[0].balls: must mean a ball of the scene, not 'x'"),
        ({"scene": yard(0)}, "scene.balls: must hold a ball"),
        ({"scene": "pinbal"}, "scene: no shipped scene is called 'pinbal'; did you mean 'pinball'?"),
        ({"scene": {"world": {"substeps": 0}}}, "scene: world.substeps: must be at least 1, not 0"),
        ({"scene": 3}, "scene: must be a table, not 3"),
        ({"scenes": "pinball"}, "scenes: is unknown; did you mean scene?"),
    ],
)
def test_what_does_not_fit_the_scene_is_refused(changes: dict[str, Any], told: str) -> None:
    assert faults(**changes) == [told]


def test_a_file_that_is_none_is_named(tmp_path: Path) -> None:
    for name, text, told in (
        ("a.toml", "version = 1\nscene = 'pinball'\nactuators = []\n", "a.toml: actuators: must be at least one"),
        ("b.toml", "version = ", "b.toml: "),
        ("c.toml", "scene = 'pinball'\nactuators = []\n", "c.toml: version: is missing"),
    ):
        (tmp_path / name).write_text(text)
        with pytest.raises(carom.TaskError, match=told):
            Task.load(tmp_path / name)
    with pytest.raises(carom.TaskError, match=r"must end in \.toml or \.json"):
        drop_task().save(tmp_path / "task.txt")


def test_a_task_cannot_be_changed() -> None:
    task = drop_task()
    with pytest.raises(carom.UnknownName, match="cannot be changed"):
        task.dt = 1.0
    with pytest.raises(carom.UnknownName, match="cannot be changed"):
        task.observation.speed = 1.0
    assert task.observation == Observation(travelling="paddle")


def test_numbers_of_numpy_are_taken_as_those_of_python() -> None:
    task = Task(
        scene=carom.scenes.breakout(), actuators=[Travel(shape="paddle", speeds=np.array([1, 2]))], steps=np.int64(2)
    )
    assert repr((task.steps, task.actuators[0].speeds)) == "(2, (1.0, 2.0))"
    assert repr(Observation(pixels=np.array([64, 128])).pixels) == "(64, 128)"
    with pytest.raises(carom.TaskError, match="version: must be the whole number 1, not True"):
        Task(version=True, scene=carom.scenes.breakout(), actuators=task.actuators)
