"""Kernels called with an address see the very arrays of the block: of every rank, in tuples, rows and numbers."""

from typing import Any

import numpy as np
import pytest

from carom.compiler import door
from carom.compiler.block import Block
from carom.compiler.kernels import Kernel
from carom.rows.hit import HIT_ROW
from carom.rows.state import STATE
from carom.world.kernels.queries.search_grid import width_of_all
from tests.worlds import crowded


def mixed(states: Any, hits: Any, pairs: Any, both: Any) -> float:
    """A number that depends on where every array lies and how long it is; one of the arrays is written to."""
    numbers, counts = both
    states[1]["time"] = numbers[len(numbers) - 1]
    pairs[len(pairs) - 1, 1] = 7
    total = 0.0
    for i in range(len(pairs)):
        total = 10.0 * total + pairs[i, 0] + 3.0 * pairs[i, 1]
    return total + states[0]["gravity_y"] + hits[2]["speed"] + 1000.0 * len(hits) + counts[0] + len(counts)


def entered(function: Kernel, block: Block) -> Any:
    """What a kernel returns that is compiled to be called with an address."""
    numba = pytest.importorskip("numba")
    from carom.compiler import entered as entrance

    numba.extending.register_jitable(function)
    entrance.note_kinds(function, numba.typeof(block.arguments))
    kernel = numba.njit(entrance.SIGNATURE)(entrance.entered(function))
    return kernel(block.address)


@pytest.mark.slow
@pytest.mark.compiled
def test_an_entry_rebuilds_the_arrays() -> None:
    def tables() -> tuple[Any, ...]:
        states, hits = np.zeros(2, STATE), np.zeros(9, HIT_ROW)
        states[0]["gravity_y"], hits[2]["speed"] = -9.5, 0.25
        pairs = np.arange(6, dtype="i4").reshape(3, 2)
        return states, hits, pairs, (np.linspace(0.5, 2.5, 4), np.full(5, 6, "u4"))

    own, given = tables(), tables()
    assert entered(mixed, Block(given)) == mixed(*own)
    assert given[0][1]["time"] == own[0][1]["time"] == 2.5
    assert given[2].tolist() == own[2].tolist()


@pytest.mark.compiled
def test_a_kernel_that_is_entered_answers_as_one_that_is_given_arrays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(door, "_loaded", {})
    arrays = crowded(balls=5)._arrays
    tables = arrays.shapes.used, arrays.balls.used
    first = door.enter(width_of_all)
    assert first(Block(tables)) == width_of_all(*tables)
    kernel = door.enter(width_of_all)
    assert isinstance(kernel, door.At)
    assert kernel(Block(tables)) == kernel.at(Block(tables).address) == width_of_all(*tables)
    assert kernel(Block((arrays.shapes.used[:1], arrays.balls.used))) == width_of_all(tables[0][:1], tables[1])


def test_interpreted_a_kernel_is_called_with_the_arrays_of_its_block(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(door, "_loaded", {})
    monkeypatch.setenv("CAROM_COMPILE", "off")
    states = np.zeros(2, STATE)
    assert door.enter(lambda table: table[0]["time"])(Block((states,))) == 0.0
