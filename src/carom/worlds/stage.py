"""Where copies are stepped: the tables of one world, into which one copy after the other is taken."""

from __future__ import annotations

from dataclasses import dataclass
from struct import Struct
from threading import Event
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.compiler import door
from carom.compiler.block import Block
from carom.compiler.door import At
from carom.rows.copies import JOB, LACKS_HITS, LACKS_MEMORY, STEP_DUE, TAKE, JobRow
from carom.rows.hit import HIT_ROW
from carom.rows.state import CHANGED, DISCRETE, DONE, HAS_STRAYS, PAUSE
from carom.rows.tables import Rows
from carom.shapes.table import word_of
from carom.world.kernels.copies.carrying import put_copy, take_copy
from carom.world.kernels.copies.stepping import step_copies
from carom.world.removal import remove_rows
from carom.world.sizes import step_size
from carom.world.snapshot import fill
from carom.world.snapshot_check import Contents
from carom.world.tables import Arrays, grown
from carom.world.world import STEP_KERNELS
from carom.worlds.memory import Memory

#: Steps that are made before there is a chance for Ctrl-C.
CHUNK = 4096

#: A job's row as its fields follow each other, and words of it: to set and read fields of a record takes far longer.
WHOLE_JOB = Struct("".join("d" if JOB[name].kind == "f" else "q" for name in JOB.names or ()))
NEXT, END, WRITTEN = (word_of(JOB, name) for name in ("next", "end", "written"))


@dataclass
class Common:
    """What all stages work on.

    Attributes:
        memory: All copies.
        moving: The rows of the kinematic shapes in the table of all shapes.
        leaders: For each of these, the place among them of the first part of its compound, or its own.
        switched: Those of the static shapes that have switches of their own in each copy.
        ids: Of the balls, ascending.
        faults: For each copy, why its step was refused; DONE for the others.
        columns: The number of columns of what is counted; then, by id, the column of each shape, or -1.
        counts: Bounces and entries, of shape (copies, columns, 2).
        keep_hits: Whether hits are given.
        sent: Whether a kinematic shape of any copy may be on its way to where it was sent.
    """

    memory: Memory
    moving: NDArray[np.int32]
    leaders: NDArray[np.int32]
    switched: NDArray[np.int32]
    ids: NDArray[np.int64]
    faults: NDArray[np.int64]
    columns: NDArray[np.int64]
    counts: NDArray[np.int64]
    keep_hits: bool
    sent: bool


def one_copy(*_: Any) -> tuple[int, float]:
    """The size of a call that carries a copy or two: see `Size`."""
    return 1, 4.0


class Stage:
    """The tables of one world, for one thread at a time."""

    def __init__(self, arrays: Arrays, common: Common) -> None:
        self.arrays = arrays
        self.common = common
        jobs: Any = np.zeros(1, JOB)
        self._jobs = jobs
        self.job: JobRow = jobs[0]
        self._octets, self._words = memoryview(jobs.view(np.uint8)), memoryview(jobs.view(np.int64))
        self._are_compiled = False
        self._rows = np.zeros(64, HIT_ROW)
        self._copies = np.zeros(64, np.int64)
        self.arrange()

    def arrange(self) -> None:
        """Look at all tables anew, some of which have been replaced."""
        arrays, common = self.arrays, self.common
        self._block = arrays.block()
        tables: Any = (
            arrays.states, arrays.balls.rows, arrays.saved, arrays.flights, arrays.shapes.rows, arrays.relations
        )  # fmt: skip
        words: Any = tuple(rows.view(np.int64).reshape(-1) for rows in tables)
        memory = common.memory.words.reshape(-1)
        shapes, queue = arrays.shapes.rows, arrays.queue.view(np.int64).reshape(-1)
        own = common.moving, common.leaders, common.switched
        self._carried = common.memory.layout, memory, memory.view(np.uint8), words, shapes, queue, own
        layout, _memory, marks, *_ = self._carried
        self._loop_block = Block(
            (
                self._jobs, layout, memory, marks, common.faults, arrays.states, words, shapes,
                arrays.order, arrays.index, queue, own, arrays.hits.view(HIT_ROW), (self._rows, self._copies),
                (common.columns, common.counts.reshape(-1)),
            )
        )  # fmt: skip
        self.job["block"] = self._block.address

    # -- one copy ----------------------------------------------------------------------------------------------------

    def take(self, copy: int) -> None:
        """Take one copy out."""
        layout, memory, marks, words, shapes, queue, own = self._carried
        arrays = self.arrays
        take_copy(
            layout[0], memory, marks, copy, arrays.states[0], words, shapes, arrays.order, arrays.index, queue, *own
        )  # fmt: skip
        arrays.balls.count = int(arrays.states[0]["balls"])

    def put(self, copy: int) -> bool:
        """True if one copy was put back; False where the memory lacks room for its relations."""
        layout, memory, marks, words, shapes, queue, (moving, _, switched) = self._carried
        arrays = self.arrays
        return put_copy(layout[0], memory, marks, copy, arrays.states[0], words, shapes, queue, moving, switched)

    def fill(self, contents: Contents) -> None:
        """Make the tables what a snapshot of a copy says, with room for the balls that are not in play."""
        fill(self.arrays, contents)
        self.make_room()
        self.arrange()

    def make_room(self) -> None:
        """Have room for all balls, in play or not."""
        arrays = self.arrays
        count, most = arrays.balls.count, len(self.common.ids)
        arrays.balls.reserve(most, doubling=False)
        arrays.balls.count = most
        arrays.prepare()
        arrays.balls.count = arrays.states[0]["balls"] = count

    # -- many --------------------------------------------------------------------------------------------------------

    def begin(self, first: int, last: int, steps: int, dt: float) -> None:
        """Begin a job: so many steps of the copies from the first to before the last."""
        if not self._are_compiled:
            self._find_kernels()
        WHOLE_JOB.pack_into(
            self._octets, 0,
            first, self._end_of_chunk(first, last, steps), last, TAKE, STEP_DUE, steps, dt, self._function,
            self._block.address, self.common.keep_hits, 0, 0,
        )  # fmt: skip

    @staticmethod
    def _end_of_chunk(first: int, last: int, steps: int) -> int:
        """One more than the last copy of a call that begins with the copy `first`, of a job that ends at `last`."""
        return min(first + max(1, CHUNK // max(1, steps)), last)

    def _find_kernels(self) -> None:
        """Look which kernels are compiled by now; once both are, they stay so."""
        self._step = door.enter(STEP_KERNELS[self.arrays.states[0]["detection"]], step_size)
        self._loop = door.enter(step_copies, one_copy)
        self._function = self._step.address if isinstance(self._step, At) else 0
        self._are_compiled = self._function != 0 and isinstance(self._loop, At)

    def work(self, stop: Event) -> bool:
        """True if the job is done, or was stopped; False where the memory lacks room: then it is to be called again."""
        while not stop.is_set():
            status = self._loop(self._loop_block)
            if status == DONE:
                first, last = self._words[NEXT], self._words[END]
                if first == last:
                    return True
                self.job["last"] = self._end_of_chunk(first, last, int(self.job["steps"]))
            elif status == STEP_DUE:
                self.job["status"] = self._step(self._block)
                self._find_kernels()
                self.job["function"] = self._function
            elif status == LACKS_MEMORY:
                return False
            elif status != PAUSE:
                self._serve(status)
        return True

    def _serve(self, status: int) -> None:
        """Make the room that is needed, or park the balls that have left the bounds."""
        if status == LACKS_HITS:
            room, written = 2 * int(self.job["wanted"]), int(self.job["written"])
            self._rows, self._copies = grown(self._rows, room, written), grown(self._copies, room, written)
        elif status == HAS_STRAYS:
            self.park(int(self.job["next"]), self.arrays.balls.rows[: self.arrays.states[0]["balls"]]["stray"] != 0)
        else:
            self.arrays.extend(status)
        self.arrange()

    def park(self, copy: int, gone: NDArray[np.bool_]) -> None:
        """Take balls out of play of the copy that is out, where the mask of those in play says so; as they are."""
        arrays, common = self.arrays, self.common
        arrays.balls.count = int(arrays.states[0]["balls"])
        slots = np.searchsorted(common.ids, arrays.balls.used["id"])
        common.memory.balls[copy, slots[gone]] = arrays.balls.used[gone]
        remove_rows(arrays, gone, np.zeros(arrays.shapes.count, np.bool_))
        common.memory.in_play[copy, slots[gone]] = False
        # In flight, what has left has let go of the others when it did.
        if arrays.states[0]["detection"] == DISCRETE:
            self.wake()
        arrays.prepare()

    def wake(self) -> None:
        """Have the copy that is out wake its balls in its next step."""
        state = self.arrays.states[0]
        state["wake"] = max(state["wake"], CHANGED)

    @property
    def count(self) -> int:
        """How many hits the job has given."""
        return self._words[WRITTEN]

    def given(self) -> tuple[Rows, Rows]:
        """The hits of the job, and for each the index of its copy."""
        count = self.count
        return self._rows[:count], self._copies[:count]
