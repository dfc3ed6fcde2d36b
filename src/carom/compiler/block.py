"""The arguments of a kernel, and one address at which compiled code finds all of them."""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from typing import Any

import numpy as np

#: Bytes that every Python object begins with. In an array a pointer to its data comes next, then the number of its
#: dimensions and a pointer to their lengths: NumPy's binary interface promises that (`PyArrayObject_fields`).
HEADER = object.__basicsize__


class Block:
    """Arrays, or tuples of them, and truths, that a kernel is called with.

    `address` is that of a table of 64-bit words, one for each argument in their order: where an array's object says
    where its data are and how many, or 0 or 1. To give a compiled kernel that one number costs far less than to give it
    the arrays. The arrays must be C-contiguous; where one is replaced, another block is needed.

    Attributes:
        arguments: The arrays, which are kept alive.
        address: Where the table begins.
    """

    __slots__ = ("_words", "address", "arguments")

    def __init__(self, arguments: tuple[Any, ...]) -> None:
        self.arguments = arguments
        self._words = array("q", _words(arguments))
        self.address = self._words.buffer_info()[0]


def _words(arguments: tuple[Any, ...]) -> Iterator[int]:
    """The words of arguments, those in tuples too."""
    for argument in arguments:
        if isinstance(argument, np.ndarray):
            yield id(argument) + HEADER
        elif isinstance(argument, tuple):
            yield from _words(argument)
        else:
            yield int(argument)
