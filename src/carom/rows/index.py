"""The rows of the broad phase: an index of shapes, its cells, and balls sorted by cell."""

from __future__ import annotations

from typing import TypedDict

import numpy as np

NO_CHILD = -1

#: Where the candidates for a place are found: a table of two rows, one for the static shapes, one for the kinematic.
INDEX = np.dtype(
    [
        ("left", "f8"),
        ("bottom", "f8"),
        ("side", "f8"),  # of a grid's cell
        ("reach", "f8"),  # the largest radius of a ball that it serves
        ("longest", "i8"),  # members of the fullest cell
        ("columns", "i8"),
        ("lines", "i8"),
        ("cells_begin", "i8"),
        ("cells_end", "i8"),
        ("members_begin", "i8"),
        ("members_end", "i8"),
    ]
)


class IndexRow(TypedDict):
    """A row of `INDEX`."""

    left: float
    bottom: float
    side: float
    reach: float
    longest: int
    columns: int
    lines: int
    cells_begin: int
    cells_end: int
    members_begin: int
    members_end: int


#: A node of a quadtree (with its centre and the first of its four children) or a cell of a grid, and its members.
CELL = np.dtype([("x", "f8"), ("y", "f8"), ("child", "i4"), ("begin", "i4"), ("end", "i4"), ("depth", "i4")])


class CellRow(TypedDict):
    """A row of `CELL`."""

    x: float
    y: float
    child: int
    begin: int
    end: int
    depth: int


#: A ball as the grid sorts it by cell, so that neighbours in space are neighbours in memory.
SLOT = np.dtype([("x", "f8"), ("y", "f8"), ("radius", "f8"), ("ball", "i4"), ("cell", "i4")])


class SlotRow(TypedDict):
    """A row of `SLOT`."""

    x: float
    y: float
    radius: float
    ball: int
    cell: int
