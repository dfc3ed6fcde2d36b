"""What is seen of the balls is taken back when the film goes on, and is there again where it does not."""

from math import nan
from typing import Any

import numpy as np
import pytest

from carom import Ball, InvalidArgument, NonFiniteState, World
from carom.compiler import door
from carom.rows.ball import BALL
from carom.rows.state import CHANGED, DONE, NOT_FINITE, REFUSED
from carom.world.kernels.continuous.showing import call_back_flown, look_at_balls
from tests.worlds import continuous_world

PLACE = ("x", "y", "vx", "vy")


def flown() -> World:
    """Three balls that have fallen for a while."""
    world = continuous_world(gravity=(0, -2))
    for k in range(3):
        world.add(Ball((4 * k, 2), 1, velocity=(3, 4 + k)))
    world.step(0.5)
    return world


def looked(world: World) -> tuple[int, bool, bytes]:
    """What a look at a world's balls says, and the balls' rows after it."""
    arrays = world._arrays
    found = look_at_balls(arrays.states[0], arrays.balls.rows, arrays.flights)
    return *found, arrays.balls.used.tobytes()


def rows_of(world: World) -> bytes:
    """The balls' rows."""
    return bytes(world._arrays.balls.used.tobytes())


def test_balls_that_nobody_changed_are_where_their_flights_began_and_can_be_called_back() -> None:
    world = flown()
    seen, arrays = rows_of(world), world._arrays
    status, changed, _rows = looked(world)
    assert (status, changed, arrays.states[0]["cursor"]) == (DONE, False, 3)
    assert [[float(ball[name]) for name in PLACE] for ball in arrays.balls.used] == [
        [4 * k, 2, 3, 4 + k] for k in range(3)
    ]  # fmt: skip
    call_back_flown(arrays.states[0], arrays.balls.rows, arrays.flights)
    assert rows_of(world) == seen
    assert arrays.states[0]["cursor"] == 0


@pytest.mark.parametrize("which", range(3))
def test_where_one_was_changed_all_are_as_they_are_seen(which: int) -> None:
    world = flown()
    world._arrays.balls.used["vx"][which] = 7.0
    seen = rows_of(world)
    assert looked(world) == (DONE, True, seen)
    assert world._arrays.states[0]["cursor"] == 0


def test_where_all_are_to_wake_all_are_as_they_are_seen() -> None:
    world = flown()
    world._arrays.states[0]["wake"] = CHANGED
    seen = rows_of(world)
    assert looked(world) == (DONE, True, seen)


@pytest.mark.parametrize(("field", "value", "status"), [("vy", nan, NOT_FINITE), ("radius", -1.0, REFUSED)])
@pytest.mark.parametrize("which", range(3))
def test_where_one_is_bad_all_are_as_they_are_seen(which: int, field: str, value: float, status: int) -> None:
    world = flown()
    world._arrays.balls.used[field][which] = value
    seen = rows_of(world)
    assert looked(world) == (status, False, seen)
    with pytest.raises((InvalidArgument, NonFiniteState)):
        world.step(0.5)
    assert rows_of(world) == seen


@pytest.mark.parametrize("stage", ["keep_tables", "take_up_motions"])
def test_a_step_that_is_interrupted_at_its_beginning_leaves_the_balls_as_they_are_seen(
    stage: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    world, straight = flown(), flown()
    before, picture = world.digest(), np.array(world._arrays.balls.used, BALL)

    def interrupt(*_: Any) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(door, "enter", lambda kernel, size: door.BlockEntry.interpreted(kernel))
        patched.setattr(f"carom.world.kernels.continuous.frames.{stage}", interrupt)
        world._forget_block()
        with pytest.raises(KeyboardInterrupt):
            world.step(0.25)
    assert world._arrays.balls.used.tobytes() == picture.tobytes()
    assert world.digest() == before
    for one in (world, straight):
        one.step(0.25)
    assert world.digest() == straight.digest()
