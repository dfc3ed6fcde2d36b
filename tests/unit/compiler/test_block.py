"""The words of a block: where the objects of arrays say what they hold, tuples of arrays taken apart, and truths."""

import ctypes
from typing import Any

import numpy as np

from carom.compiler.block import HEADER, Block


class Fields(ctypes.Structure):
    """What NumPy's binary interface says stands in an array's object, behind the header of all objects."""

    _fields_ = (("data", ctypes.c_void_p), ("dimensions", ctypes.c_int), ("lengths", ctypes.POINTER(ctypes.c_ssize_t)))


def words_at(address: int, count: int) -> list[int]:
    """The words that stand at an address."""
    return list((ctypes.c_int64 * count).from_address(address))


def seen(word: int) -> tuple[Any, ...]:
    """The address of an array's data, and its shape, as they are found from its word."""
    fields = Fields.from_address(word)
    return fields.data, tuple(fields.lengths[: fields.dimensions])


def test_the_words_lead_to_where_each_array_lies_and_how_long_it_is() -> None:
    flat, deep, empty = np.arange(5.0), np.zeros((4, 2), "i4"), np.zeros(0, "u4")
    part = flat[2:].view(np.recarray)
    block = Block((flat, (deep, (empty,)), part))
    words = words_at(block.address, 4)
    assert words == [id(array) + HEADER for array in (flat, deep, empty, part)]
    assert list(map(seen, words)) == [(array.ctypes.data, array.shape) for array in (flat, deep, empty, part)]


def test_a_truth_is_its_own_word() -> None:
    assert words_at(Block((True, False, np.True_)).address, 3) == [1, 0, 1]


def test_a_block_keeps_its_arrays_alive() -> None:
    block = Block((np.arange(1000.0),))
    place, (length,) = seen(*words_at(block.address, 1))
    np.zeros(1000)
    assert list((ctypes.c_double * length).from_address(place)) == list(range(1000))
