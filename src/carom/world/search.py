"""The grids that a world's queries look through, made when they are worth it and kept while they are right."""

from __future__ import annotations

import numpy as np

from carom.compiler import door
from carom.constants import SEARCH_CELLS_PER_ITEM, SEARCH_MARKS_PER_ITEM, SEARCH_SCANS
from carom.rows.query import SEARCH_GRID
from carom.rows.shape import STATIC
from carom.rows.tables import Rows
from carom.world.kernels.queries.search_grid import build_search_grid
from carom.world.sizes import query_size
from carom.world.tables import Arrays

#: The width of the one cell of a grid that is a plain list: beyond everything.
WHOLE = 1e300

Grid = tuple[Rows, Rows, Rows]


def list_of(items: Rows) -> Grid:
    """A grid of one cell, which holds all items."""
    grid = np.zeros(1, SEARCH_GRID)
    grid[0] = (0.0, 0.0, WHOLE, 1, 1)
    return grid, np.array([0, len(items)], "i4"), items


def grid_of(arrays: Arrays, items: Rows) -> Grid:
    """A grid of many cells, which hold the items that come into each."""
    grid = np.zeros(1, SEARCH_GRID)
    starts = np.zeros((3 * int(SEARCH_CELLS_PER_ITEM) + 2) * len(items) + 2, "i4")
    members = np.zeros((int(SEARCH_MARKS_PER_ITEM) + 1) * len(items), "i4")
    door.load(build_search_grid, query_size)(grid, arrays.shapes.used, arrays.balls.used, items, starts, members)
    return grid, starts, members


class Search:
    """Grids of the static shapes, which stay where they are, and of all else, which is looked at anew in every call.

    A world drops it when shapes or balls come or go, and when a static shape may have changed.
    """

    def __init__(self, arrays: Arrays) -> None:
        self._arrays = arrays
        self._tables = arrays.shapes.rows, arrays.balls.rows
        still = arrays.shapes.used["motion"] == STATIC
        balls = np.arange(-1, -1 - arrays.balls.count, -1, dtype="i4")
        self._still = list_of(np.flatnonzero(still).astype("i4"))
        self._lively = list_of(np.append(np.flatnonzero(~still).astype("i4"), balls))
        self._scans = 0
        self._gridded = not still.any()

    def is_of(self, arrays: Arrays) -> bool:
        """Whether the arrays still have the tables that they had, and no others that were restored."""
        return self._tables[0] is arrays.shapes.rows and self._tables[1] is arrays.balls.rows

    def grids(self, queries: int) -> tuple[Rows, ...]:
        """The two grids, as the kernels take them, for a number of queries."""
        self._scans += queries
        if self._scans > SEARCH_SCANS and not self._gridded:
            self._still = grid_of(self._arrays, self._still[2])
            self._gridded = True
        if queries > SEARCH_SCANS and len(self._lively[2]):
            return (*self._still, *grid_of(self._arrays, self._lively[2]))
        return (*self._still, *self._lively)

    def stamps(self) -> Rows:
        """A 0 for every shape and ball."""
        return np.zeros(self._arrays.shapes.count + self._arrays.balls.count, "i4")
