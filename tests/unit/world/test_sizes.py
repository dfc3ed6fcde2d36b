"""How much work a call is: more for more of anything, and little where the interpreter answers at once."""

import numpy as np

import carom
from carom.compiler.behind import LONGEST, UNIT
from carom.world.sizes import query_size, step_size, table_size

#: As much work as the interpreter may be given before anything was measured.
MOST = LONGEST / UNIT


def units_of_a_step(scene: carom.Scene, detection: carom.typing.Detection = "discrete") -> float:
    """The units of work of a scene's next step."""
    world = scene.build()
    world.detection = detection
    world._arrays.prepare()
    return step_size(world._arrays.block())[1]


def test_games_are_small_and_crowds_are_not() -> None:
    for scene in (carom.scenes.toy(), carom.scenes.pinball(), carom.scenes.pool(), carom.scenes.gas(balls=100)):
        assert units_of_a_step(scene) < MOST / 2
        assert units_of_a_step(scene, "continuous") <= units_of_a_step(scene)
    assert units_of_a_step(carom.scenes.gas(balls=2_000)) > MOST
    assert units_of_a_step(carom.scenes.gas(balls=2_000), "continuous") > MOST


def test_steps_are_those_that_are_left() -> None:
    world = carom.World()
    world._states[0]["steps_left"] = 7
    assert step_size(world._arrays.block()) == (7, 0.0)


def test_a_query_may_look_at_everything_and_many_may_look_at_more() -> None:
    few, many = np.zeros(1), np.zeros(1000)
    assert query_size(few, few, few)[1] < 2.0
    assert query_size(few, many, few, None)[1] > 50.0
    assert query_size(many, many, few)[1] > MOST
    assert table_size(few, few)[1] < 2.0
    assert table_size(many, few, True)[1] > table_size(few, few)[1]
