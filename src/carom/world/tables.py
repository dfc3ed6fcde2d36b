"""The rows of a world, in tables that grow, and the scratch arrays of its kernels."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.compiler.block import Block
from carom.errors import InvalidArgument
from carom.rows.ball import BALL, BallRow
from carom.rows.flight import FLIGHT, QUEUE
from carom.rows.hit import HIT, HIT_ROW
from carom.rows.index import CELL, INDEX, SLOT
from carom.rows.island import BODY, ISLAND_CONTACT
from carom.rows.relation import INSIDE_BALL, LASTING, LYING, NO_RELATION, RELATION
from carom.rows.saved import SAVED
from carom.rows.shape import BALL_KIND, SHAPE, ShapeRow
from carom.rows.state import DISCRETE, NEEDS_ROOM, STALE, STATE, StateRow
from carom.rows.tables import LINE, Rows, Table
from carom.shapes.table import Owner, R, RowTable, word_of
from carom.world.layout import MOST_CHANGES, Layout

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape


#: Relations of a ball to another ball, not to a shape.
OF_BALLS = (INSIDE_BALL, LYING)


class WorldTable(RowTable[R]):
    """The rows of all balls or of all shapes of a world. Ids ascend, so a row is found by its id wherever it moved."""

    __slots__ = ("_id", "count")

    def __init__(self, dtype: np.dtype[Any], capacity: int = 0) -> None:
        super().__init__(np.zeros(capacity, dtype))
        self._id = word_of(dtype, "id")
        self.count = 0

    @property
    def used(self) -> Rows:
        """The rows in use."""
        return self.rows[: self.count]

    def at(self, owner: Owner) -> int:
        """The word at which `owner`'s row begins; remembered, and looked up again where rows have moved."""
        if self._seen is not self.rows:
            self._look()
        index = owner._index
        at = index * self.width
        if 0 <= index < self.count and self.whole[at + self._id] == owner._id:
            return at
        owner._index = index = self.find(owner._id)
        return index * self.width

    def id_at(self, index: int) -> int:
        """The id of the row with an index, which must be in use."""
        if self._seen is not self.rows:
            self._look()
        return self.whole[index * self.width + self._id]

    def find(self, member_id: int | None) -> int:
        """The index of the row with an id; raises `InvalidArgument` where there is none."""
        # By words: NumPy would first copy a column out of all rows.
        index = bisect_left(range(self.count), member_id or 0, key=self.id_at)
        if index == self.count or self.id_at(index) != member_id:
            raise InvalidArgument(f"id must be that of a shape or ball in the world, not {member_id!r}")
        return index

    def reserve(self, capacity: int, doubling: bool = True) -> None:
        """Make room for `capacity` rows in all, twice as many as there were unless `doubling` is False."""
        if capacity > len(self.rows):
            self.rows = grown(self.rows, max(capacity, 2 * self.count) if doubling else capacity, self.count)

    def append(self, lone: list[bytes], ids: Sequence[int]) -> None:
        """Add rows, which come as bytes, with other ids; these must be higher than those that are there."""
        # Steps look behind the rows for those of shapes that have gone: with room for a few, the first does not wait.
        self.reserve(self.count + len(ids) + min(len(ids), MOST_CHANGES))
        first, self.count = self.count, self.count + len(ids)
        words = self.rows.view(np.uint64).reshape(len(self.rows), -1)
        words[first : self.count] = np.frombuffer(b"".join(lone), np.uint64).reshape(len(ids), -1)
        self.rows["id"][first : self.count] = ids

    def drop(self, gone: NDArray[np.bool_]) -> None:
        """Take out the rows where the mask `gone` is True; the others move up and keep their order."""
        if not gone.any():
            return
        first = int(np.argmax(gone))
        # As plain words: NumPy moves structured rows field by field.
        words = self.rows.view(np.uint64).reshape(len(self.rows), -1)
        kept = np.compress(~gone[first:], words[first : self.count], axis=0)
        self.count = first + len(kept)
        words[first : self.count] = kept


def grown(rows: Rows, capacity: int, keep: int) -> Rows:
    """A table of `capacity` rows that begins with the first `keep` of `rows`, which lie one after the other.

    It begins where a line of memory does, all of which comes near at once: NumPy's own tables begin 16 bytes into one,
    where every row of 64 bytes lies in two.
    """
    width = rows.itemsize * prod(rows.shape[1:])
    room = np.zeros(capacity * width + LINE, np.uint8)
    begin = -room.__array_interface__["data"][0] % LINE
    # As bytes: NumPy copies structured rows field by field.
    if keep > 0:
        room[begin : begin + keep * width] = rows[:keep].reshape(-1).view(np.uint8)
    return room[begin : begin + capacity * width].view(rows.dtype).reshape(capacity, *rows.shape[1:])


def joined(parts: Sequence[Rows], dtype: np.dtype[Any]) -> Rows:
    """Tables of one type as one, which is new. As bytes, as in `grown`: so it takes a tenth of the time."""
    words = [np.ascontiguousarray(part).view(np.uint8) for part in parts]
    return np.concatenate([np.zeros(0, np.uint8), *words]).view(dtype)


class Arrays:
    """All arrays that a step's kernel works on, in the order of its arguments."""

    def __init__(self) -> None:
        self.states: Table[StateRow] = np.zeros(2, STATE)
        self.balls = WorldTable[BallRow](BALL)
        self.shape_table = WorldTable[ShapeRow](SHAPE)
        self.layout = Layout()
        self.index = np.zeros(2, INDEX)
        self.cells = np.zeros(256, CELL)
        self.members = np.zeros(256, "i4")
        self.slots = np.zeros(0, SLOT)
        self.starts = np.zeros(0, "u4")
        self.pairs = np.zeros((16, 2), "u4")
        self.saved = np.zeros(0, SAVED)
        self.hits = np.zeros(64, HIT)
        self.owed = 0
        self._hits_seen: Rows | None = None
        self.relations = np.zeros(32, RELATION)
        self.flights = np.zeros(0, FLIGHT)
        self.queue = np.zeros(1, QUEUE)
        self.island = (np.zeros(0, BODY), np.zeros(0, ISLAND_CONTACT))

    @property
    def shapes(self) -> WorldTable[ShapeRow]:
        """The table of the shapes without rows of those that are gone, which `shape_table` may have still."""
        self.settle()
        return self.shape_table

    @property
    def order(self) -> NDArray[np.int32]:
        """The rows of the shapes in the order in which they are met."""
        return self.layout.order

    def table_of(self, member: Shape | Ball) -> WorldTable[Any]:
        """The table that has the rows of what is like a member."""
        return self.balls if member._KIND == BALL_KIND else self.shape_table

    def block(self) -> Block:
        """The arguments of a step's kernel; that of the continuous mode has three more."""
        discrete = self.states[0]["detection"] == DISCRETE
        tables = (
            self.states,
            self.balls.rows,
            self.shape_table.rows,
            self.order,
            self.index,
            self.cells,
            self.members,
            self.slots,
            # In the continuous mode lists of balls begin there, of which some have none: a number below 0.
            self.starts if discrete else self.starts.view("i4"),
            self.pairs,
            self.saved,
            self.hits.view(HIT_ROW),
            self.relations,
        )
        if discrete:
            return Block(tables)
        bodies, contacts = self.island
        if len(bodies) < len(self.balls.rows) or len(contacts) < len(self.relations) // 2:
            # An island has no more balls than there are, and no more contacts than relations in use.
            room = len(self.relations) // 2
            self.island = (np.zeros(len(self.balls.rows), BODY), np.zeros(room, ISLAND_CONTACT))
        return Block((*tables, self.flights, self.queue, self.island))

    def prepare(self) -> None:
        """Make room for what the next step needs at least, and put the shapes into the order in which they are met."""
        state = self.states[0]
        if state["balls"] != self.balls.count:
            state["balls"], state["moving_stale"] = self.balls.count, STALE
        if not state["bounded"]:
            self.balls.used["stray"] = 0
        if not self.layout.is_known or self.layout.is_full(self.shape_table.count):
            self.settle()
        # Behind the shapes a step keeps a copy of the kinematic ones, to go back to if it fails.
        behind = self.layout.lay(self.shape_table.used, state)
        self.shape_table.reserve(self.shape_table.count + behind)
        self.layout.tell(self.shape_table.rows)
        if self.layout.has_other_movers:
            self._list_movers()
        if len(self.saved) < self.balls.count:
            self.saved = grown(self.saved, len(self.balls.rows), len(self.saved))
            # Each ball as it is sorted and as it was before, and two more that may be looked at behind the sorted.
            self.slots = grown(self.slots, 2 * len(self.balls.rows) + 2, 0)
        if state["detection"] != DISCRETE and len(self.flights) < 2 * self.balls.count:
            # The upper half is for the copies that a step which fails goes back to.
            count = len(self.flights) // 2
            self.flights = grown(self.flights, 2 * len(self.balls.rows), count)
            self.queue = grown(self.queue, len(self.balls.rows) + 1, 0)

    def _list_movers(self) -> None:
        """List the kinematic shapes that move behind all shapes, as steps of the continuous mode keep them listed."""
        state, rows = self.states[0], self.shape_table.used
        kinematic = self.order[int(state["fixed"]) : len(rows)]
        # Field by field: whole rows are long.
        travels = (rows["velocity_x"][kinematic] != 0.0) | (rows["velocity_y"][kinematic] != 0.0)
        goes = (rows["spin"][kinematic] != 0.0) | (rows["time_left_before"][kinematic] > 0.0)
        movers = kinematic[travels | goes]
        state["movers"] = len(movers)
        self.order[len(rows) : len(rows) + len(movers)] = movers

    def fill(self, balls: Rows, shapes: Rows) -> None:
        """Have copies of other rows in the tables."""
        for table, rows in ((self.balls, balls), (self.shape_table, shapes)):
            # With the room that there was: the next step needs some behind the rows.
            table.rows = grown(rows, max(len(table.rows), len(rows)), len(rows))
            table.count = len(rows)
        self.layout.clear()

    def held_by(self, shape: int) -> NDArray[np.int32]:
        """The rows of the balls that the shape in a row holds."""
        pool = self.relations[: int(self.states[0]["relations_high"])]
        # Those that are free are of no ball.
        held: NDArray[np.int32] = pool["ball"][(pool["kind"] == LASTING) & (pool["other"] == shape)]
        return np.extract(held != NO_RELATION, held)

    def note_come(self, first: int) -> None:
        """Take note of the shapes that have come in, from a row of their table on."""
        motions = self.shape_table.used["motion"][first:]
        self.layout.note_come(range(first, self.shape_table.count), motions.tolist())

    def bury(self, rows: NDArray[np.intp]) -> None:
        """Let the shapes in some rows be gone: no relation is to them."""
        used = self.shape_table.used
        for row in rows:
            # Until its row is taken out it meets nothing.
            used[row]["can_collide"] = used[row]["once"] = 0
        self.layout.note_gone(rows.tolist(), used["motion"][rows].tolist())

    def settle(self) -> None:
        """Take rows of shapes that are gone out of the table; what names rows names the new ones."""
        if not self.layout.gone:
            return
        gone = np.zeros(self.shape_table.count, np.bool_)
        gone[self.layout.gone] = True
        new = (np.cumsum(~gone) - 1).astype("i4")
        state = self.states[0]
        pool = self.relations[: int(state["relations_high"])]
        of_shapes = ~np.isin(pool["kind"], OF_BALLS)
        pool["other"][of_shapes] = np.take(new, pool["other"][of_shapes], mode="clip")
        self.shape_table.drop(gone)
        known = self.layout.renumber(new, int(state["movers"]))
        if known and state["taken"] + state["put"] == 0:
            end = int(self.index["members_end"].max())
            self.members[:end] = np.take(new, self.members[:end], mode="clip")
        else:
            state["index_stale"] = state["moving_stale"] = STALE
            state["taken"] = state["put"] = 0
        state["shapes"], state["dropped"] = self.shape_table.count, 0
        state["fixed"] = self.shape_table.count - len(self.layout.moving)
        state["foreseen"] = 0

    def extend(self, status: int) -> None:
        """Make the room that a kernel asked for when it came back with `status`."""
        state = self.states[0]
        if status == NEEDS_ROOM:
            self.extend_hits()
            self.extend_relations(int(state["wanted_relations"]))
        else:
            self.pairs = self._at_least(self.pairs, state["wanted_pairs"])
            self.starts = self._at_least(self.starts, state["wanted_starts"], slack=1.25)
            # The index of the shapes, which need not be made again, stands at the beginning of both.
            self.cells = self._at_least(self.cells, state["wanted_cells"], keep=len(self.cells))
            self.members = self._at_least(self.members, state["wanted_members"], keep=len(self.members))

    def hit_bytes(self, count: int) -> bytearray:
        """A copy of the first hits as bytes, since NumPy copies structured rows field by field."""
        if self._hits_seen is not self.hits:
            self._hit_bytes = memoryview(self.hits.view(np.uint8))  # type: ignore[arg-type]
            self._hits_seen = self.hits
        return bytearray(self._hit_bytes[: count * HIT.itemsize])

    def extend_hits(self) -> None:
        """Make room for `state["wanted_hits"]` hits."""
        state = self.states[0]
        self.hits = self._at_least(self.hits, state["wanted_hits"], keep=int(state["hits"]))

    def give_back(self, hits: Rows) -> None:
        """Put hits that were taken before those that are here."""
        state = self.states[0]
        count = int(state["hits"])
        self.hits = np.concatenate([hits, self.hits[:count], np.zeros(64, HIT)])
        state["hits"] = len(hits) + count

    def owe_hits(self) -> None:
        """Note that the hits that are here are owed: of steps that were made, in a call that has not returned them."""
        self.owed = int(self.states[0]["hits"])

    def owed_hits(self) -> Rows:
        """Take out the hits that are owed."""
        state, owed = self.states[0], self.owed
        count = int(state["hits"])
        rows = self.hits[:owed].copy()
        self.hits[: count - owed] = self.hits[owed:count].copy()
        state["hits"], self.owed = count - owed, 0
        return rows

    @staticmethod
    def _at_least(rows: Rows, wanted: int, keep: int = 0, slack: float = 2.0) -> Rows:
        """`rows`, or a longer copy if fewer than `wanted`."""
        return rows if wanted <= len(rows) else grown(rows, int(slack * int(wanted)) + 16, keep)

    def extend_relations(self, wanted: int) -> None:
        """Make room for `wanted` relations and, in the upper half of the pool, for their copy."""
        half = len(self.relations) // 2
        if wanted <= half:
            return
        larger = np.zeros(4 * wanted, RELATION)
        high = int(self.states[0]["relations_high"])
        larger[:half] = self.relations[:half]
        larger[2 * wanted : 2 * wanted + high] = self.relations[half : half + high]
        self.relations = larger


def clear_kernel_place(state: StateRow) -> None:
    """Forget where an interrupted step was, so that the next one begins at its beginning."""
    for field in (
        "stage",
        "stage_entered",
        "substep",
        "iteration",
        "cursor",
        "pairs",
        "found",
        "steps_left",
        "running",
        "foreseen",
    ):
        state[field] = 0
