"""The hits of many copies: rows with one more field, in the order of copies, then of time."""

import numpy as np
import pytest

import carom
from carom.worlds.hits import gathered
from tests.worlds import game_table


def test_an_item_says_in_which_copy_it_was() -> None:
    world = game_table("discrete")
    worlds = carom.Worlds(world, 2, threads=1)
    hits, alone = worlds.run(1.0, 1 / 50), world.run(1.0, 1 / 50)
    assert hits.dtype.names == (*(carom.Hits.DTYPE.names or ()), "world")
    assert hits["world"].tolist() == [0] * len(alone) + [1] * len(alone)
    last = hits[-1]
    assert last.world == 1
    assert (last.time, last.kind, last.point, last.impulse) == (
        alone[-1].time, alone[-1].kind, alone[-1].point, alone[-1].impulse
    )  # fmt: skip
    assert last.shape.id == alone[-1].shape.id
    assert repr(hits) == f"<{2 * len(alone)} hits in 2 worlds>"
    assert repr(worlds.step(0.0)) == "<0 hits in 0 worlds>"


def test_they_are_in_the_order_of_copies_and_then_of_time() -> None:
    rows = np.zeros(4, carom.Hits.DTYPE)
    rows["time"] = [3.0, 1.0, 2.0, 1.0]
    hits = gathered(carom.World(), [(rows[:3], np.array([0, 1, 1])), (rows[3:], np.array([0]))])
    assert hits["world"].tolist() == [0, 0, 1, 1]
    assert hits["time"].tolist() == [1.0, 3.0, 1.0, 2.0]
    with pytest.raises(IndexError):
        hits[4]
