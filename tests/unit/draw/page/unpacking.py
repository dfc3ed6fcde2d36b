"""The slow twin of a page's reader: columns of numbers out of text, one by one."""

import zlib
from base64 import b64decode
from typing import Any

import numpy as np


def unpacked(column: dict[str, Any]) -> np.ndarray:
    """The numbers of a packed column, (rows, length), read one by one as the page reads them."""
    numbers, number, weight = [], 0, 1
    for byte in zlib.decompress(b64decode(column["data"])):
        number += (byte & 127) * weight
        weight *= 128
        if byte < 128:
            numbers.append(-(number + 1) // 2 if number % 2 else number // 2)
            number, weight = 0, 1
    table = np.array(numbers, np.int64).reshape(column["rows"], column["length"])
    for _ in range(column["order"]):
        table = np.cumsum(table, axis=1)
    return table
