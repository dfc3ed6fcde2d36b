"""A copy of a world is taken out of the memory of all copies into the tables of one world, and put back.

Static shapes and their index stay in those tables: they are the same in all copies, but for the switches of some.
"""

from __future__ import annotations

from carom.constants import FEW_SHAPES
from carom.rows.copies import LayoutRow
from carom.rows.index import IndexRow
from carom.rows.shape import ShapeRow
from carom.rows.state import CONTINUOUS, OTHER_REACH, STALE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import FIXED
from carom.world.kernels.continuous.movers import list_movers

#: The tables that a copy is carried into, word by word: state, balls, saved, flights, shapes, relations.
WordTables = tuple[Table[int], Table[int], Table[int], Table[int], Table[int], Table[int]]


def take_copy(
    layout: LayoutRow,
    memory: Table[int],
    marks: Table[int],
    copy: int,
    state: StateRow,
    words: WordTables,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    queue: Table[int],
    moving: Table[int],
    leaders: Table[int],
    switched: Table[int],
) -> None:
    """Take a copy out, ready to be stepped; `marks` are the bytes of the memory."""
    carry(layout, memory, marks, copy, words, shapes, queue, moving, switched, True)
    follow_leaders(shapes, moving, leaders)
    # The index of the static shapes serves all copies whose largest balls are the same.
    state["index_stale"] = 0 if index[FIXED]["reach"] == state["reach"] else OTHER_REACH
    state["moving_stale"] = STALE
    state["hits"] = 0
    if state["detection"] == CONTINUOUS:
        list_movers(state, shapes, order)
        # The bins that balls are filed in, and the regions of many kinematic shapes, are not carried.
        if state["binned"] != 0 or len(moving) > FEW_SHAPES:
            state["foreseen"] = 0


def put_copy(
    layout: LayoutRow,
    memory: Table[int],
    marks: Table[int],
    copy: int,
    state: StateRow,
    words: WordTables,
    shapes: Table[ShapeRow],
    queue: Table[int],
    moving: Table[int],
    switched: Table[int],
) -> bool:
    """True if the copy was put back; False where there is too little room for its relations, and nothing was done."""
    if state["relations_high"] > layout["relations_room"]:
        return False
    carry(layout, memory, marks, copy, words, shapes, queue, moving, switched, False)
    return True


def carry(
    layout: LayoutRow,
    memory: Table[int],
    marks: Table[int],
    copy: int,
    words: WordTables,
    shapes: Table[ShapeRow],
    queue: Table[int],
    moving: Table[int],
    switched: Table[int],
    out: bool,
) -> None:
    """Carry a copy out of the memory, or back into it."""
    state_words, ball_words, saved_words, flight_words, shape_words, relation_words = words
    begin = copy * int(layout["words"])
    carry_words(memory, begin, state_words, 0, int(layout["state_words"]), out)
    carry_moving(layout, memory, begin, shape_words, moving, out)
    carry_switches(marks, 8 * begin + int(layout["switches_at"]), shapes, switched, out)
    in_play = 8 * begin + int(layout["in_play_at"])
    row = 0
    for slot in range(int(layout["balls"])):
        if marks[in_play + slot] == 0:
            continue
        size = int(layout["ball_words"])
        carry_words(memory, begin + int(layout["balls_at"]) + slot * size, ball_words, row * size, size, out)
        size = int(layout["saved_words"])
        carry_words(memory, begin + int(layout["saved_at"]) + slot * size, saved_words, row * size, size, out)
        if layout["flights_at"] != 0:
            size = int(layout["flight_words"])
            carry_words(memory, begin + int(layout["flights_at"]) + slot * size, flight_words, row * size, size, out)
            size = int(layout["queue_words"])
            carry_words(memory, begin + int(layout["queue_at"]) + row * size, queue, row * size, size, out)
        row += 1
    # How many there are stands in the state, which has been carried.
    high = int(state_words[int(layout["high_word"])])
    size = int(layout["relation_words"])
    carry_words(memory, begin + int(layout["relations_at"]), relation_words, 0, high * size, out)


def carry_moving(
    layout: LayoutRow, memory: Table[int], begin: int, words: Table[int], moving: Table[int], out: bool
) -> None:  # fmt: skip
    """Carry the rows of kinematic shapes, those at once that follow each other, as parts of a compound do."""
    size = int(layout["shape_words"])
    k = 0
    while k < len(moving):
        end = k + 1
        while end < len(moving) and moving[end] == moving[end - 1] + 1:
            end += 1
        at = begin + int(layout["moving_at"]) + k * size
        carry_words(memory, at, words, int(moving[k]) * size, (end - k) * size, out)
        k = end


def follow_leaders(shapes: Table[ShapeRow], moving: Table[int], leaders: Table[int]) -> None:
    """Give all parts of a compound the speeds of its first one, for which alone they are set in the memory."""
    for k in range(len(moving)):
        if leaders[k] != k:
            shape, leader = shapes[moving[k]], shapes[moving[leaders[k]]]
            shape["angular_velocity"] = leader["angular_velocity"]
            shape["velocity_x"] = leader["velocity_x"]
            shape["velocity_y"] = leader["velocity_y"]


def carry_words(memory: Table[int], begin: int, table: Table[int], to: int, count: int, out: bool) -> None:
    """Carry words from the memory into a table, or back."""
    # Neither is negative; where the compiler knows, it carries many words at once, and no index is wrapped around.
    begin, to = max(begin, 0), max(to, 0)
    if out:
        for k in range(count):
            table[to + k] = memory[begin + k]
    else:
        for k in range(count):
            memory[begin + k] = table[to + k]


def carry_switches(
    marks: Table[int], begin: int, shapes: Table[ShapeRow], switched: Table[int], out: bool
) -> None:  # fmt: skip
    """Carry what may differ in static shapes: two bytes each, whether it collides at all and whether but once."""
    for k in range(len(switched)):
        shape, at = shapes[switched[k]], begin + 2 * k
        if out:
            shape["can_collide"] = marks[at]
            shape["once"] = marks[at + 1]
        else:
            marks[at] = shape["can_collide"]
            marks[at + 1] = shape["once"]
