"""How all that a step has changed comes back."""

from math import inf

import numpy as np

from carom.rows.state import DONE
from carom.world.kernels.step.rollback import roll_back
from tests.kernel_calls import begun, contents, prepared
from tests.worlds import crowded


def test_what_a_step_has_done_is_undone_to_the_bit() -> None:
    world = crowded()
    world.run(1.0)
    arrays = prepared(world)
    state = arrays.states[0]
    state["index_stale"], state["moving_stale"], state["step_hits"] = 1, 1, state["hits"]
    before = contents(arrays)
    assert begun(arrays) == DONE
    random = np.random.default_rng(1)
    balls, shapes = arrays.balls.used, arrays.shapes.used
    for field in ("x", "y", "vx", "vy", "still_time"):
        balls[field] = random.uniform(-9, 9, len(balls))
    balls["relation"], balls["asleep"], balls["stray"] = -1, 1, 1
    balls["vy"][3] = inf
    moving = arrays.order[len(shapes) : len(shapes) + state["movers"]]
    assert 1 < len(moving) < state["shapes"] - state["fixed"]
    shapes["orientation"][moving], shapes["right"][moving[0]] = 7.0, inf
    arrays.relations["kind"][: int(state["relations_high"])] = 99
    state["time"], state["hits"] = 99.0, 5
    roll_back(arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations)
    assert contents(arrays) == before
    # It is told besides what was not finite any more.
    assert np.flatnonzero(arrays.saved["overflowed"][: len(balls)]).tolist() == [3]
    copies = arrays.shapes.rows[len(shapes) : len(shapes) + len(moving)]
    assert copies["once"].tolist() == [1] + [0] * (len(moving) - 1)
