"""Values of parameters and measures as plain ones: what JSON can hold, with the same text wherever it is written."""

from __future__ import annotations

import json
from hashlib import blake2b
from typing import Any

import numpy as np

#: Numbers that one measure of one run may hold.
MOST_NUMBERS = 10_000
#: Whole numbers that a column of a table can hold.
LEAST_WHOLE, MOST_WHOLE = -(2**63), 2**63 - 1
WHAT = "a number, a string, True, False, None or a list of these"


class NotPlain(ValueError):
    """What a value must be, and is not."""


def plain(value: Any) -> Any:
    """A value as plain Python: NumPy's numbers as numbers, arrays and tuples as lists; raises `NotPlain`."""
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, int):
        if not LEAST_WHOLE <= value <= MOST_WHOLE:
            raise NotPlain("a whole number that 64 bits can hold")
        return int(value)
    if isinstance(value, float):
        return float(value)
    if isinstance(value, np.ndarray):
        return plain(_small(value).tolist())
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in _small(value)]
    raise NotPlain(WHAT)


def _small(items: Any) -> Any:
    """A list or an array, unless it is too long for a row of a table."""
    if np.size(items) > MOST_NUMBERS if isinstance(items, np.ndarray) else len(items) > MOST_NUMBERS:
        raise NotPlain(f"a list of at most {MOST_NUMBERS:,} items")
    return items


def text_of(value: Any, in_order: bool = True) -> str:
    """Plain values as text: JSON whose numbers have all their digits; names in order, or in their own."""
    return json.dumps(value, sort_keys=in_order, separators=(",", ":"), ensure_ascii=True)


def name_of(*values: Any) -> str:
    """A hash of plain values, as 32 hexadecimal digits."""
    return blake2b(text_of(values).encode(), digest_size=16).hexdigest()
