"""The arguments of a kernel, and one address at which compiled code finds all of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np


class Block:
    """Arrays, or tuples of them, that a kernel is called with again and again.

    `address` is that of a table of 64-bit words: for each array, in their order, where its data lie and how long it is
    in each of its dimensions. To give a compiled kernel that one number costs far less than to give it the arrays. The
    arrays must be C-contiguous; where one is replaced, another block is needed.

    Attributes:
        arguments: The arrays, which are kept alive.
        address: Where the table of their places begins.
    """

    __slots__ = ("_words", "address", "arguments")

    def __init__(self, arguments: tuple[Any, ...]) -> None:
        self.arguments = arguments
        self._words = np.fromiter(_words(arguments), np.int64)
        self.address = self._words.ctypes.data


def _words(argument: Any) -> Iterator[int]:
    """The words of an array, or of all arrays in a tuple."""
    if isinstance(argument, tuple):
        for each in argument:
            yield from _words(each)
    else:
        yield argument.ctypes.data
        yield from argument.shape
