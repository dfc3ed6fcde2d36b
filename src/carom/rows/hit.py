"""The row of a hit."""

from typing import TypedDict

import numpy as np

from carom.rows.tables import dtype_of, f8, i8

# What a hit is (`HitKind` names them for users).
BOUNCE = 0
ENTER = 1
EXIT = 2

HIT = np.dtype(
    [
        ("time", "f8"),
        ("kind", "i8"),
        ("ball", "i8"),
        ("shape", "i8"),
        ("point", "f8", (2,)),
        ("normal", "f8", (2,)),
        ("setback", "f8"),
        ("speed", "f8"),
        ("impulse", "f8"),
        ("velocity", "f8", (2,)),
        ("position", "f8", (2,)),
    ]
)


class HitRow(TypedDict):
    """A hit as the kernels write it: the same bytes, each number a field of its own."""

    time: f8
    kind: i8
    ball: i8
    shape: i8
    point_x: f8
    point_y: f8
    normal_x: f8
    normal_y: f8
    setback: f8
    speed: f8
    impulse: f8
    velocity_x: f8
    velocity_y: f8
    position_x: f8
    position_y: f8


HIT_ROW = dtype_of(HitRow)
