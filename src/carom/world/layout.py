"""The order in which a world's shapes are met, kept up as shapes come, go and move.

Making it anew, and the index of the shapes with it, takes a time that grows with their number. So rows of shapes that
are gone stay in the table for a while, and what has changed is told to the kernel, which changes the index there alone.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Rows

#: Shapes that may have changed between two steps; of more, order and index are made anew.
MOST_CHANGES = 256

#: Rows of shapes that are gone and stay in the table: so many at least, and this share of all.
MOST_GONE, SHARE_GONE = 256, 0.125


class Layout:
    """The order of the shapes in a table, as `order` tells kernels, and what has changed since they were told last.

    Attributes:
        order: The rows that are gone, then the static and the kinematic ones, each by their kinds, then by their rows;
            behind these, room for those that move, and what `patch_index` is told.
        moving: The rows of the kinematic shapes.
        gone: The rows of the shapes that are gone.
    """

    def __init__(self) -> None:
        self.order: NDArray[np.int32] = np.zeros(0, "i4")
        self.clear()

    def clear(self) -> None:
        """Forget everything: the table holds other shapes."""
        self.moving: frozenset[int] = frozenset()
        self.gone: list[int] = []
        self.forget()

    def forget(self) -> None:
        """Have the order, and the index of the shapes, made anew."""
        self._count = -1
        self._keys: NDArray[np.uint8] = np.zeros(0, "u1")
        self._fallen: list[int] = []
        self._taken: dict[int, ShapeRow | None] = {}
        self._put: dict[int, None] = {}

    @property
    def is_known(self) -> bool:
        """Whether there is an order that only has to be changed."""
        return self._count >= 0

    # -- what has changed --------------------------------------------------------------------------------------------

    def note_moved(self, row: int, before: ShapeRow) -> None:
        """Take note that the static shape in a row was another one `before`."""
        if self.is_known:
            if row not in self._put:
                self._taken[row] = before
            self._put[row] = None
            self._forget_if_many()

    def note_come(self, rows: Iterable[int]) -> None:
        """Take note of the rows of static shapes that have come in, at the end of the table."""
        if self.is_known:
            self._put.update(dict.fromkeys(rows))
            self._forget_if_many()

    def note_gone(self, rows: Iterable[int]) -> None:
        """Take note of the rows of static shapes that are gone, and stay in the table for a while."""
        for row in rows:
            self.gone.append(row)
            self._fallen.append(row)
            if row in self._put:
                del self._put[row]
            else:
                self._taken[row] = None
        self._forget_if_many()

    def _forget_if_many(self) -> None:
        """Forget the order where it is quicker made anew."""
        if len(self._taken) + len(self._put) + len(self._fallen) > MOST_CHANGES:
            self.forget()

    def is_full(self, count: int) -> bool:
        """Whether a table of so many rows has too many of shapes that are gone."""
        return len(self.gone) > max(MOST_GONE, SHARE_GONE * count)

    # -- what kernels are told ---------------------------------------------------------------------------------------

    def lay(self, rows: Rows, state: StateRow) -> int:
        """How many rows there must be behind those in use, after putting `rows`, all in use, into order."""
        if state["taken"] + state["put"] > 0:
            state["index_stale"] = state["moving_stale"] = STALE  # the step that was told has not come to it
        if not self.is_known:
            self._lay_anew(rows)
            state["index_stale"] = state["moving_stale"] = STALE
        elif self._fallen or len(rows) > self._count:
            self._change(rows)
        kinematic = len(self.moving)
        state["shapes"], state["dropped"], state["fixed"] = len(rows), len(self.gone), len(rows) - kinematic
        state["taken"], state["put"] = len(self._taken), len(self._put)
        return kinematic + len(self._taken)

    def _lay_anew(self, rows: Rows) -> None:
        """Put all rows into order, none of which are of shapes that are gone."""
        keys = _keys_of(rows)
        self.order = np.argsort(keys, kind="stable").astype("i4")
        self._keys = keys[self.order]
        first = int(np.searchsorted(self._keys, _key(KINEMATIC, 0)))
        self.moving = frozenset(self.order[first:].tolist())
        self._count = len(rows)

    def _change(self, rows: Rows) -> None:
        """Put what is gone first, and what has come into its place."""
        order, keys = self.order[: self._count], self._keys
        lost = np.zeros(len(rows), np.bool_)
        lost[self._fallen] = True
        kept = ~lost[order]
        order = np.concatenate([np.array(self._fallen, "i4"), order[kept]])
        keys = np.concatenate([np.zeros(len(self._fallen), "u1"), keys[kept]])
        new = np.array([row for row in range(self._count, len(rows)) if not lost[row]], "i4")
        if len(new):
            come = _keys_of(rows[self._count :])[new - self._count]
            by_key = np.argsort(come, kind="stable")
            new, come = new[by_key], come[by_key]
            places = np.searchsorted(keys, come, side="right")
            order, keys = np.insert(order, places, new), np.insert(keys, places, come)
        self.order, self._keys, self._count = order, keys, len(rows)

    def tell(self, rows: Rows) -> None:
        """Name behind the order what `patch_index` is to change, for which rows there must be."""
        behind = self._count + len(self.moving)
        geometries = []
        for place, (row, before) in enumerate(self._taken.items(), behind):
            if before is not None:
                rows[place] = before
            geometries.append(row if before is None else place)
        told = [*self._taken, *geometries, *self._put]
        if told or len(self.order) < behind:
            movers = np.zeros(len(self.moving), "i4")
            self.order = np.concatenate([self.order[: self._count], movers, np.array(told, "i4")])
        self._fallen, self._taken, self._put = [], {}, {}

    def renumber(self, new: NDArray[np.int32]) -> bool:
        """Whether the order stands yet after rows that are gone were taken out; `new` has the new rows of all."""
        count, gone = len(new), len(self.gone)
        pending = self._fallen or self._taken or self._put
        self.gone = []
        if pending or self._count != count:
            self.forget()
            return False
        self.order[: count - gone] = new[self.order[gone:count]]
        self._keys = self._keys[gone:]
        self._count = count - gone
        self.moving = frozenset(int(new[row]) for row in self.moving)
        return True


def _key(motion: int, kind: int) -> int:
    """A number by which static shapes come before kinematic ones, and each by their kinds; 0 is for what is gone."""
    return 1 + 8 * motion + kind


def _keys_of(rows: Rows) -> NDArray[np.uint8]:
    """The keys of rows."""
    keys: NDArray[np.uint8] = 1 + 8 * rows["motion"] + rows["kind"]
    return keys
