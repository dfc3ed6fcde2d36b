"""The order in which a world's shapes are met, kept up as shapes come, go and move.

Making it anew, and the index of the shapes with it, takes a time that grows with their number. So rows of shapes that
are gone stay in the table for a while, and what has changed is told to the kernel, which changes the index there alone.
Static and kinematic shapes are listed apart: a change of the ones costs nothing that grows with the others.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from carom.rows.shape import KINEMATIC, STATIC, ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Rows

#: Static shapes that may have changed between two steps; of more, order and index are made anew.
MOST_CHANGES = 256

#: Rows of shapes that are gone and stay in the table: so many at least, and this share of all.
MOST_GONE, SHARE_GONE = 256, 0.125

#: Room that an order has before it and behind it when it is written anew: so much at least, and this share of all.
LEAST_SLACK, SHARE_SLACK = 64, 0.125

#: What a listing sorts rows by: their kinds from this bit on, and their numbers below it.
KIND_BIT = 32


class Listing:
    """The rows of the shapes of one motion in the order in which they are met: by kinds, then by rows.

    Attributes:
        rows: The rows in that order, as it was when `settle` was called last.
    """

    def __init__(self) -> None:
        self._fill(np.zeros(0, "i8"))

    def _fill(self, codes: NDArray[np.int64]) -> None:
        """List the rows that are coded, which are in order."""
        self._codes = codes
        self.rows: NDArray[np.int32] = codes.astype("u4").view("i4")
        self._left: dict[int, None] = {}
        self._come: dict[int, None] = {}

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def pending(self) -> bool:
        """Whether rows have left or come since `settle` was called."""
        return bool(self._left or self._come)

    def add(self, row: int) -> None:
        """List a row from now on."""
        if row in self._left:
            del self._left[row]
        else:
            self._come[row] = None

    def discard(self, row: int) -> None:
        """List a row no more."""
        if row in self._come:
            del self._come[row]
        else:
            self._left[row] = None

    def lay(self, rows: Rows, motion: int) -> None:
        """List all `rows` of a motion."""
        listed = np.flatnonzero(rows["motion"] == motion)
        self._fill(np.sort(_codes_of(rows, listed)))

    def settle(self, rows: Rows) -> None:
        """Take out what has left and put in what has come."""
        codes = self._codes
        if self._left:
            codes = np.delete(codes, np.searchsorted(codes, _codes_of(rows, np.array([*self._left]))))
        if self._come:
            come = np.sort(_codes_of(rows, np.array([*self._come])))
            codes = np.insert(codes, np.searchsorted(codes, come), come)
        self._fill(codes)

    def renumber(self, new: NDArray[np.int32]) -> None:
        """Have `new` rows, which ascend as the old ones do."""
        self._fill((self._codes >> KIND_BIT << KIND_BIT) + new[self.rows])


class Layout:
    """The order of the shapes in a table, as `order` tells kernels, and what has changed since they were told last.

    Attributes:
        order: The rows that are gone, then the static and the kinematic ones, each by their kinds, then by their rows;
            behind these, room for those that move, and what `patch_index` is told.
        gone: The rows of the shapes that are gone.
    """

    def __init__(self) -> None:
        self._room: NDArray[np.int32] = np.zeros(0, "i4")
        self._begin = 0
        self.order = self._room
        self.clear()

    def clear(self) -> None:
        """Forget everything: the table holds other shapes."""
        self.gone: list[int] = []
        self._dropped = 0
        self.forget()

    def forget(self) -> None:
        """Have the order, and the index of the shapes, made anew."""
        self._count = -1
        self._listings = {STATIC: Listing(), KINEMATIC: Listing()}
        self._taken: dict[int, ShapeRow | None] = {}
        self._put: dict[int, None] = {}

    @property
    def is_known(self) -> bool:
        """Whether there is an order that only has to be changed."""
        return self._count >= 0

    @property
    def moving(self) -> NDArray[np.int32]:
        """The rows of the kinematic shapes, as kernels know them."""
        return self._listings[KINEMATIC].rows

    @property
    def has_other_movers(self) -> bool:
        """Whether other kinematic shapes were laid last than before, so that nobody knows which of them move."""
        return self._other[KINEMATIC]

    # -- what has changed --------------------------------------------------------------------------------------------

    def note_moved(self, row: int, before: ShapeRow) -> None:
        """Take note that the static shape in a row was another one `before`."""
        if self.is_known:
            if row not in self._put:
                self._taken[row] = before
            self._put[row] = None
            self._forget_if_many()

    def note_other_motion(self, row: int, before: ShapeRow, motion: int) -> None:
        """Take note that the shape in a row, which had the motion that it had `before`, has another one."""
        if self.is_known:
            self._listings[int(before["motion"])].discard(row)
            self._listings[motion].add(row)
            if motion == STATIC:
                self._put[row] = None
            else:
                self._take(row, before)
            self._forget_if_many()

    def note_come(self, rows: Iterable[int], motions: Iterable[int]) -> None:
        """Take note of the rows of shapes that have come in, at the end of the table, and how they move."""
        if self.is_known:
            for row, motion in zip(rows, motions, strict=True):
                self._listings[motion].add(row)
                if motion == STATIC:
                    self._put[row] = None
            self._forget_if_many()

    def note_gone(self, rows: Iterable[int], motions: Iterable[int]) -> None:
        """Take note of the rows of shapes that are gone, and stay in the table for a while."""
        for row, motion in zip(rows, motions, strict=True):
            self.gone.append(row)
            if self.is_known:
                self._listings[motion].discard(row)
                if motion == STATIC:
                    self._take(row, None)
        self._forget_if_many()

    def _take(self, row: int, before: ShapeRow | None) -> None:
        """Have a static shape taken out of the index, by the geometry `before` or, for None, by the one that it has."""
        if row in self._put:
            # The index does not know it yet, or has been told of the place that it knows.
            del self._put[row]
        else:
            self._taken[row] = before

    def _forget_if_many(self) -> None:
        """Forget the order where it is quicker made anew."""
        if len(self._taken) + len(self._put) > MOST_CHANGES:
            self.forget()

    def is_full(self, count: int) -> bool:
        """Whether a table of so many rows has too many of shapes that are gone."""
        return len(self.gone) > max(MOST_GONE, SHARE_GONE * count)

    # -- what kernels are told ---------------------------------------------------------------------------------------

    def lay(self, rows: Rows, state: StateRow) -> int:
        """How many rows there must be behind those in use, after putting `rows`, all in use, into order."""
        if state["taken"] + state["put"] > 0:
            state["index_stale"] = STALE  # the step that was told has not come to it
        self._movers = self.order[self._count : self._count + int(state["movers"])].copy()
        self._other = {motion: listing.pending or not self.is_known for motion, listing in self._listings.items()}
        for motion, listing in self._listings.items():
            if not self.is_known:
                listing.lay(rows, motion)
            elif listing.pending:
                listing.settle(rows)
        if not self.is_known:
            state["index_stale"] = STALE
        if self._other[KINEMATIC]:
            state["moving_stale"] = STALE
            self._movers = self._movers[:0]  # `Arrays` lists them
        self._count = len(rows)
        kinematic = len(self.moving)
        state["shapes"], state["dropped"], state["fixed"] = len(rows), len(self.gone), len(rows) - kinematic
        state["movers"], state["taken"], state["put"] = len(self._movers), len(self._taken), len(self._put)
        return kinematic + len(self._taken)

    def tell(self, rows: Rows) -> None:
        """Write the order, and behind it what `patch_index` is to change, for which rows there must be."""
        geometries = []
        for place, (row, before) in enumerate(self._taken.items(), self._count + len(self.moving)):
            if before is not None:
                rows[place] = before
            geometries.append(row if before is None else place)
        self._write([*self._taken, *geometries, *self._put])
        self._taken, self._put = {}, {}

    def _write(self, told: list[int]) -> None:
        """Write into the order what differs from what stands there."""
        still, moving = self._listings[STATIC].rows, self.moving
        fresh = self.gone[self._dropped :]
        size = len(self.gone) + len(still) + 2 * len(moving) + len(told)
        # What is gone stands before those that stay where they are.
        begin = self._begin - len(fresh)
        whole = begin < 0 or begin + size > len(self._room)
        if whole:
            begin = slack = int(max(LEAST_SLACK, SHARE_SLACK * size))
            self._room, fresh = np.zeros(size + 2 * slack, "i4"), self.gone
        self.order = self._room[begin : begin + size]
        self.order[: len(fresh)] = fresh
        place = len(self.gone)
        for rows, other in ((still, whole or self._other[STATIC]), (moving, True), (self._movers, True)):
            if other:
                self.order[place : place + len(rows)] = rows
            place += len(rows)
        self.order[len(self.order) - len(told) :] = told
        self._begin, self._dropped = begin, len(self.gone)

    def renumber(self, new: NDArray[np.int32], movers: int) -> bool:
        """Whether the order stands yet after rows that are gone were taken out; `new` has the new rows of all.

        So many kinematic shapes are listed as those that move. The order begins where it did: a block of arguments that
        has it stays as it is.
        """
        pending = self._taken or self._put or any(listing.pending for listing in self._listings.values())
        known = not pending and self._count == len(new)
        listed = self.order[self._count : self._count + movers]
        self._count -= self._dropped
        self.gone, self._dropped = [], 0
        if not known:
            self.forget()
            return False
        self._movers = new[listed]
        for motion, listing in self._listings.items():
            listing.renumber(new)
            self._other[motion] = True
        self._write([])
        return True


def _codes_of(rows: Rows, listed: NDArray[np.intp]) -> NDArray[np.int64]:
    """What some of the `rows` are sorted by."""
    codes: NDArray[np.int64] = (rows["kind"][listed].astype("i8") << KIND_BIT) + listed
    return codes
