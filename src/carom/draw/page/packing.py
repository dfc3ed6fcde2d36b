"""Columns of numbers as the replay page takes them: whole numbers, small ones in few bytes, as text.

What moves evenly has second differences near 0 however finely its places are measured, so fine units cost little:
a differenced column is mostly single bytes, and deflating those leaves two or three bits of each.
"""

from __future__ import annotations

import zlib
from base64 import b64encode
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

#: What JSON can hold.
Plain: TypeAlias = dict[str, Any]

#: Bits of a number that a byte of its code holds; the eighth says that more bytes follow.
BITS = 7
#: Steps of a size's logarithm for each factor of e, and the level of the largest size: sizes of 7 powers of ten are
#: kept, to a thousandth of themselves. 2 * `TOP_SIZE` < 2**14, so that a level fits two bytes.
FINENESS, TOP_SIZE = 500, 8190


def packed(values: ArrayLike, order: int) -> Plain:
    """A column of whole numbers, (rows, length) or (length,), as differences of some `order` along each row."""
    table = np.atleast_2d(np.asarray(values, np.int64))
    rows, length = table.shape
    differences = np.diff(table, n=order, axis=1, prepend=np.zeros((rows, order), np.int64)) if order else table
    return {
        "rows": rows,
        "length": length,
        "order": order,
        "data": deflated(coded(differences.ravel())),
    }


def deflated(data: bytes) -> str:
    """Bytes, deflated, as text."""
    return b64encode(zlib.compress(data)).decode("ascii")


def coded(numbers: NDArray[np.int64]) -> bytes:
    """Whole numbers in as few bytes as each one's size needs, signs in their lowest bits."""
    folded = ((numbers << 1) ^ (numbers >> 63)).view(np.uint64)
    lengths = np.ones(len(folded), np.int64)
    for more in range(1, 9):
        lengths += folded >= np.uint64(1) << np.uint64(BITS * more)
    starts = np.cumsum(lengths) - lengths
    code = np.zeros(int(lengths.sum()), np.uint8)
    for place in range(int(lengths.max(initial=0))):
        there = lengths > place
        low = (folded[there] >> np.uint64(BITS * place)) & np.uint64(2**BITS - 1)
        code[starts[there] + place] = low.astype(np.uint8) | (lengths[there] > place + 1).astype(np.uint8) << BITS
    return code.tobytes()


def measured(values: NDArray[np.float64], first: float, unit: float, order: int) -> Plain:
    """A column of numbers, counted from `first` in whole multiples of `unit`; off by half a `unit` at most."""
    return packed(np.round((values - first) / unit), order) | {"first": first, "unit": unit}


def sizes(values: NDArray[np.float64]) -> Plain:
    """A column of sizes, none negative, by their logarithms: each to a thousandth, those of almost nothing as 0."""
    largest = float(values.max(initial=0.0)) or 1.0
    levels = np.zeros(len(values), np.int64)
    some = values > 0.0
    levels[some] = np.maximum(0, np.round(TOP_SIZE + FINENESS * (np.log(values[some]) - np.log(largest))))
    return packed(levels, 0) | {"largest": largest, "top": TOP_SIZE, "fineness": FINENESS}
