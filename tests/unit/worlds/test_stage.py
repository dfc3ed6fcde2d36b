"""A stage: what is taken out and put back is the same, and room is made where it runs out."""

from threading import Event

import numpy as np
import pytest

import carom
from carom.compiler.door import At
from carom.rows.copies import JOB, STEP_DUE, TAKE
from carom.world import ahead
from carom.world.kernels.copies.stepping import step_copies
from tests.worlds import game_table, world_of

DT = 1 / 50


def test_what_is_taken_out_and_put_back_is_the_same() -> None:
    worlds = carom.Worlds(game_table("continuous"), 2, threads=1)
    worlds.run(0.5, DT)
    before = worlds._common.memory.words.copy()
    stage = worlds._stages[0]
    for copy in (1, 0, 1):
        stage.take(copy)
        assert stage.put(copy)
    states = worlds._common.memory.state
    # What only says how tables stand is made anew.
    for name in ("moving_stale", "hits", "index_stale"):
        for words in (before, worlds._common.memory.words):
            words[:, states.dtype.fields[name][1] // 8] = 0
    assert (before == worlds._common.memory.words).all()


def test_a_copy_gets_more_room_for_what_balls_are_in_without_touching_others() -> None:
    sensors = [carom.Circle((0, 0), 1.0 + 0.01 * number, sensor=True, solid=True) for number in range(9)]
    world = world_of(*sensors, carom.Ball((5, 0), 0.1, (-30, 0)), detection="continuous")
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.balls.velocity[0] = 0.0
    hits, alone = worlds.step(0.2), world.step(0.2)
    assert len(hits) == len(alone) == 9
    assert hits["world"].tolist() == [1] * 9
    assert worlds.digests()[1] == world.digest()
    assert int(worlds._common.memory.state["relations"][1]) == 9
    worlds.reset()
    assert len(worlds.step(0.2)) == 18


def test_nothing_is_done_once_it_is_to_stop() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    stop = Event()
    stop.set()
    stage = worlds._stages[0]
    stage.begin(0, 2, 1, DT)
    assert stage.work(stop)
    assert worlds.time.tolist() == [0.0, 0.0]
    assert len(stage.given()[1]) == 0
    assert np.array_equal(stage.common.ids, worlds.balls.id)


def test_the_kernel_is_compiled_for_the_types_that_it_is_called_with() -> None:
    numba = pytest.importorskip("numba")
    worlds = carom.Worlds(game_table("continuous"), 2, threads=1)
    (example,) = ahead.examples()[step_copies]
    assert numba.typeof(worlds._stages[0]._loop_block.arguments) == numba.typeof(example.arguments)


def test_a_job_is_written_field_by_field_where_its_row_has_them() -> None:
    stage = carom.Worlds(game_table("discrete"), 3, threads=1)._stages[0]
    stage.job["written"] = stage.job["wanted"] = 7
    stage.begin(1, 3, 5, DT)
    told = {name: stage.job[name] for name in JOB.names if name not in ("function", "block")}
    assert told == {
        "next": 1, "last": 3, "end": 3, "place": TAKE, "status": STEP_DUE, "steps": 5, "dt": DT, "keep_hits": 1,
        "written": 0, "wanted": 0,
    }  # fmt: skip
    assert stage.job["block"] == stage._block.address
    assert (stage.job["function"] != 0) == isinstance(stage._step, At)
