"""Copies and pickles of a world: worlds of their own in the same state, with the objects that go with them."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import bits, busy, named


@pytest.mark.compiled
@pytest.mark.parametrize(
    "copied",
    [copy.copy, copy.deepcopy, *[lambda world, n=n: pickle.loads(pickle.dumps(world, n)) for n in range(6)]],
    ids=["copy", "deepcopy", *[f"pickle {n}" for n in range(6)]],
)
def test_copies_are_worlds_of_their_own_in_the_same_state(copied: Any) -> None:
    world = busy()
    world.balls[0].user, named(world, "mill").user = {"score": 3}, "a mill"
    world.shapes[0].user = [1, 2]
    twin = copied(world)
    assert twin.digest() == world.digest()
    assert twin.balls[0].user == {"score": 3}
    assert named(twin, "mill").user == "a mill"
    assert twin.shapes[0].user == [1, 2]
    assert twin.balls[0].world is twin
    assert not np.shares_memory(twin.balls.position, world.balls.position)
    before = world.digest()
    after = twin.run(1.0)
    assert world.digest() == before
    assert bits(world.run(1.0)) == bits(after)


class Table(carom.World):
    """A world of a user's own."""

    def __init__(self, score: int) -> None:
        super().__init__(gravity=(0, -1))
        self.score = score


def test_a_subclass_stays_one_with_what_it_holds_itself() -> None:
    table = Table(7)
    ball = table.add(carom.Ball((0, 0), 1))
    ball.user = table
    twin = copy.deepcopy(table)
    assert type(twin) is Table
    assert twin.score == 7
    assert twin.gravity == (0, -1)
    assert twin.balls[0].user is twin
