"""The beginning and the end of a step: what is refused, what is kept, and how all of it comes back."""

from math import inf, nan

import numpy as np
import pytest

from carom import Ball, Segment, World
from carom.rows.state import DONE, HAS_STRAYS, NOT_FINITE, REFUSED
from carom.world.kernels.step.rollback import begin_step, end_step, find_strays, roll_back
from carom.world.tables import Arrays
from tests.kernel_calls import prepared
from tests.worlds import crowded, world_of


def begun(arrays: Arrays) -> int:
    """The outcome of beginning a step."""
    return begin_step(
        arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations
    )


def contents(arrays: Arrays) -> list[bytes]:
    """The tables that a step may change, bit by bit."""
    used = int(arrays.states[0]["relations_high"])
    return [
        *(table.tobytes() for table in (arrays.states[0], arrays.balls.used, arrays.shapes.used)),
        arrays.relations[:used].tobytes(),
    ]


@pytest.mark.parametrize(
    ("field", "value", "status"),
    [
        *[(field, nan, NOT_FINITE) for field in ("x", "y", "vx", "vy", "radius", "mass", "elasticity", "friction")],
        *[("x", inf, NOT_FINITE), ("mass", inf, NOT_FINITE)],
        *[
            ("radius", 0.0, REFUSED),
            ("mass", -1.0, REFUSED),
            ("elasticity", -0.5, REFUSED),
            ("friction", -2.0, REFUSED),
        ],
        *[("elasticity", 0.0, DONE), ("friction", -1.0, DONE), ("x", -1e300, DONE)],
    ],
)
def test_a_step_does_not_begin_with_a_ball_that_cannot_be(field: str, value: float, status: int) -> None:
    arrays = prepared(world_of(*(Ball((3.0 * k, 0), 1) for k in range(3))))
    arrays.balls.rows[field][1] = value
    before = contents(arrays)
    assert begun(arrays) == status
    assert (contents(arrays) == before) == (status != DONE)


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


@pytest.mark.parametrize(("removes", "status"), [(True, HAS_STRAYS), (False, DONE)])
def test_a_step_ends_with_its_time_and_with_those_that_have_left_the_bounds(removes: bool, status: int) -> None:
    world = World(bounds=(0, 0, 10, 10), remove_strays=removes)
    for x, y in ((5, 5), (-0.99, 5), (-1.01, 5), (5, 11.01), (5, 10.99), (11.5, 11.5)):
        world.add(Ball((x, y), 1))
    arrays = prepared(world)
    arrays.states[0]["dt"], arrays.states[0]["steps_left"] = 0.25, 3
    assert begun(arrays) == DONE
    arrays.balls.rows["stray"][5] = 1
    found = end_step(arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations)
    assert found == status
    assert arrays.balls.used["stray"].tolist() == [0, 0, 1, 1, 0, 1]
    state = arrays.states[0]
    assert (state["time"], state["steps_left"], state["outside"], state["strays"]) == (0.25, 2, 3, 2)


def test_a_step_that_leaves_a_ball_infinite_is_undone() -> None:
    arrays = prepared(world_of(Segment((0, 0), (1, 0)), Ball((0, 0), 1), Ball((5, 5), 1, velocity=(1, 2))))
    assert begun(arrays) == DONE
    before = arrays.balls.used.tobytes()
    arrays.balls.rows["x"] = 3.0, nan
    # Whatever moves or turns a ball looks whether it is sound still, and notes where it is not.
    arrays.states[0]["doubtful"] = 1
    found = end_step(arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations)
    assert found == NOT_FINITE
    assert arrays.balls.used.tobytes() == before
    assert arrays.states[0]["time"] == 0.0


def test_a_ball_on_the_border_is_no_stray() -> None:
    arrays = prepared(world_of(Ball((-1, 5), 1), Ball((11, 5), 1), bounds=(0, 0, 10, 10)))
    find_strays(arrays.states[0], arrays.balls.rows)
    assert arrays.states[0]["strays"] == 0
