"""The words of a block: where each array lies and how long it is, tuples of arrays taken apart."""

import ctypes

import numpy as np

from carom.compiler.block import Block


def words_at(address: int, count: int) -> list[int]:
    """The words that stand at an address."""
    return list((ctypes.c_int64 * count).from_address(address))


def test_the_words_say_where_each_array_lies_and_how_long_it_is() -> None:
    flat, deep, empty = np.arange(5.0), np.zeros((4, 2), "i4"), np.zeros(0, "u4")
    block = Block((flat, (deep, (empty,)), flat[2:]))
    expected = [
        flat.ctypes.data, 5, deep.ctypes.data, 4, 2, empty.ctypes.data, 0, flat.ctypes.data + 16, 3
    ]  # fmt: skip
    assert words_at(block.address, len(expected)) == expected


def test_a_block_keeps_its_arrays_alive() -> None:
    block = Block((np.arange(1000.0),))
    place, length = words_at(block.address, 2)
    np.zeros(1000)
    assert list((ctypes.c_double * length).from_address(place)) == list(range(1000))
