"""The rows of queries: what is asked, the grid that serves it, and what is answered."""

from __future__ import annotations

from typing import TypedDict

import numpy as np

from carom.rows.tables import Table

#: What a query asks, and what it sees. A box goes from x, y to to_x, to_y.
QUERY = np.dtype(
    [
        ("x", "f8"),
        ("y", "f8"),
        ("to_x", "f8"),
        ("to_y", "f8"),
        ("radius", "f8"),
        ("layer", "u4"),
        ("collides_with", "u4"),
        ("sensors", "i4"),
    ]
)


class QueryRow(TypedDict):
    """A row of `QUERY`."""

    x: float
    y: float
    to_x: float
    to_y: float
    radius: float
    layer: int
    collides_with: int
    sensors: int


#: Where a grid lies that serves queries: its corner, the width of its cells, and how many there are.
SEARCH_GRID = np.dtype([("left", "f8"), ("bottom", "f8"), ("side", "f8"), ("columns", "i8"), ("lines", "i8")])


class SearchGridRow(TypedDict):
    """A row of `SEARCH_GRID`."""

    left: float
    bottom: float
    side: float
    columns: int
    lines: int


CAST_HIT = np.dtype([("shape", "i8"), ("fraction", "f8"), ("point", "f8", (2,)), ("normal", "f8", (2,))])


class CastRow(TypedDict):
    """A row of `CAST_HIT`."""

    shape: int
    fraction: float
    point: Table[float]
    normal: Table[float]


NEIGHBOR = np.dtype([("shape", "i8"), ("distance", "f8"), ("point", "f8", (2,))])


class NeighborRow(TypedDict):
    """A row of `NEIGHBOR`."""

    shape: int
    distance: float
    point: Table[float]


IN_BOX = np.dtype([("box", "i8"), ("shape", "i8")])


class InBoxRow(TypedDict):
    """A row of `IN_BOX`."""

    box: int
    shape: int


CONTACT = np.dtype(
    [
        ("shape", "i8"),
        ("ball", "i8"),
        ("point", "f8", (2,)),
        ("normal", "f8", (2,)),
        ("setback", "f8"),
        ("speed", "f8"),
    ]
)


class ContactRow(TypedDict):
    """A row of `CONTACT`."""

    shape: int
    ball: int
    point: Table[float]
    normal: Table[float]
    setback: float
    speed: float


AIM = np.dtype(
    [
        ("ball", "i8"),
        ("shape", "i8"),
        ("start", "f8", (2,)),
        ("ghost", "f8", (2,)),
        ("distance", "f8"),
        ("point", "f8", (2,)),
        ("normal", "f8", (2,)),
        ("direction", "f8", (2,)),
        ("speed", "f8"),
        ("other_direction", "f8", (2,)),
        ("other_speed", "f8"),
    ]
)


class AimRow(TypedDict):
    """A row of `AIM`."""

    ball: int
    shape: int
    start: Table[float]
    ghost: Table[float]
    distance: float
    point: Table[float]
    normal: Table[float]
    direction: Table[float]
    speed: float
    other_direction: Table[float]
    other_speed: float
