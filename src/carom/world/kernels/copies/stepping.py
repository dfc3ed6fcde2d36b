"""Many copies of a world are stepped by one call, each to the bits that it would come to alone."""

from __future__ import annotations

from carom.rows.copies import GIVE, LACKS_HITS, LACKS_MEMORY, PUT, STEP, STEP_DUE, TAKE, JobRow, LayoutRow
from carom.rows.hit import BOUNCE, ENTER, HitRow
from carom.rows.index import IndexRow
from carom.rows.prefetch import prefetch
from carom.rows.shape import ShapeRow
from carom.rows.state import (
    DONE,
    HAS_STRAYS,
    NEEDS_PAIRS,
    NEEDS_ROOM,
    NOT_FINITE,
    PAUSE,
    REFUSED,
    StateRow,
)
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import FIXED
from carom.world.kernels.copies.carrying import WordTables, put_copy, take_copy

#: Words that come together from memory.
LINE = 8


def step_copies(
    jobs: Table[JobRow],
    layouts: Table[LayoutRow],
    memory: Table[int],
    marks: Table[int],
    faults: Table[int],
    states: Table[StateRow],
    words: WordTables,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    queue: Table[int],
    rows: tuple[Table[int], Table[int], Table[int]],
    hits: Table[HitRow],
    given: tuple[Table[HitRow], Table[int]],
    counting: tuple[Table[int], Table[int]],
) -> int:
    """DONE when all copies of a job have been stepped; else what is needed to go on from where it is.

    That is STEP_DUE, LACKS_HITS, LACKS_MEMORY, or what the step of a copy came back with, which is out then.

    Args:
        jobs: The job, one row.
        layouts: Where the parts of a copy are, one row.
        memory: All copies, one after the other.
        marks: The same as bytes.
        faults: For each copy, why its step was refused: such a one is left out; DONE for the others.
        states: The tables of the world in which a copy is stepped, and those below.
        words: These tables as words.
        shapes: Its shapes.
        order: The order in which they are met.
        index: The index of its shapes.
        queue: The queue of its balls' events.
        rows: Which of the shapes each copy has of its own, which of these lead others, which have switches of its own.
        hits: The hits of its step.
        given: The hits of all copies, and of which copy each is.
        counting: By ids, the columns of what is counted, or -1; for each copy and column, bounces and entries.
    """
    job, layout, state = jobs[0], layouts[0], states[0]
    moving, leaders, switched = rows
    while job["next"] < job["last"]:
        copy = int(job["next"])
        if job["place"] == TAKE:
            if faults[copy] != DONE:
                job["next"] += 1
                continue
            take_copy(layout, memory, marks, copy, state, words, shapes, order, index, queue, moving, leaders, switched)
            state["dt"] = job["dt"]
            state["steps_left"] = job["steps"]
            job["place"] = STEP
            prefetch_copy(layout, memory, copy + 1)
        if job["place"] == STEP:
            status = call_step(job)
            if status == STEP_DUE or is_to_be_served(status):
                return status
            if status == NOT_FINITE or status == REFUSED:
                state["steps_left"] = 0
            if status != DONE:
                faults[copy] = status
                # What was undone may have left another index of the kinematic shapes.
                index[FIXED]["reach"] = -1.0
            job["place"] = PUT
        if job["place"] == PUT:
            # A processor drops some of so many requests at once.
            prefetch_copy(layout, memory, copy + 1)
            if not put_copy(layout, memory, marks, copy, state, words, shapes, queue, moving, switched):
                job["wanted"] = state["relations_high"]
                return LACKS_MEMORY
            count_hits(hits, int(state["hits"]), copy, counting)
            job["place"] = GIVE
        if not give_hits(job, hits, int(state["hits"]), copy, given):
            return LACKS_HITS
        job["place"] = TAKE
        job["next"] += 1
    return DONE


def prefetch_copy(layout: LayoutRow, memory: Table[int], copy: int) -> None:
    """Have what a copy needs at hand when its turn comes: to wait for memory may take as long as its step."""
    begin = copy * int(layout["words"])
    for word in range(begin, min(begin + int(layout["words"]), len(memory)), LINE):
        prefetch(memory, word)


def call_step(job: JobRow) -> int:
    """What the step of the copy that is out comes back with; STEP_DUE where the caller is to make it."""
    if job["function"] == 0:
        status = int(job["status"])
        job["status"] = STEP_DUE
        return status
    return call_at(int(job["function"]), int(job["block"]))


def call_at(function: int, block: int) -> int:  # noqa: ARG001  # compiled, it is another
    """What the compiled function at an address returns, called with one number; the interpreter can call none."""
    return STEP_DUE


def is_to_be_served(status: int) -> bool:
    """True if a step that came back with a status is to be called again when the caller has done what it needs."""
    return status == NEEDS_ROOM or status == NEEDS_PAIRS or status == HAS_STRAYS or status == PAUSE


def give_hits(
    job: JobRow, hits: Table[HitRow], count: int, copy: int, given: tuple[Table[HitRow], Table[int]]
) -> bool:  # fmt: skip
    """True if the hits of a copy were given, where they are kept at all; False where there is too little room."""
    if job["keep_hits"] == 0:
        return True
    target, copies = given
    begin = int(job["written"])
    if begin + count > len(copies):
        job["wanted"] = begin + count
        return False
    for k in range(count):
        target[begin + k] = hits[k]
        copies[begin + k] = copy
    job["written"] = begin + count
    return True


def count_hits(hits: Table[HitRow], count: int, copy: int, counting: tuple[Table[int], Table[int]]) -> None:
    """Count bounces and entries by what was met, where that is counted."""
    columns, counts = counting
    width = int(columns[0])
    for k in range(count):
        hit = hits[k]
        column = int(columns[hit["shape"]])
        if column >= 0 and hit["kind"] == BOUNCE:
            counts[2 * (copy * width + column)] += 1
        if column >= 0 and hit["kind"] == ENTER:
            counts[2 * (copy * width + column) + 1] += 1
