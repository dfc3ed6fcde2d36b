"""Pairs of balls whose boxes overlap, by a hierarchical grid: levels of cells, each half as wide as the last."""

from __future__ import annotations

from math import fabs, floor

from carom.constants import CELL_CLAMP, CELL_SIDE, FINEST_LEVEL, GOLDEN_SECTION, GRID_CELLS_AHEAD, GRID_CELLS_PER_BALL
from carom.geometry.vector import larger, smaller
from carom.rows.ball import BallRow
from carom.rows.index import PairTables, SlotRow
from carom.rows.state import StateRow
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.pairs import may_touch, measure_balls, put_pair

#: Sorted balls that are looked at after every one: those next to it in its line of cells, and those in the next line.
OWN_LINE, NEXT_LINE = 2, 3

#: A grid of cells of one width: left, bottom, 1/side, columns and lines that balls may be in, stride and mask of
#: numbers.
Grid = tuple[float, float, float, float, float, int, int]


def cell_of(offset: float, inverse_side: float) -> int:
    """The number of the column (or line) that a coordinate's `offset` from the grid's corner lies in.

    Far outside it is clamped; clamping keeps the order, so neighbours stay neighbours. NaN, which a step that overflows
    may come by before it is rolled back, counts as far below.
    """
    # Multiplied, not divided: this is done for every ball in every search.
    cell = offset * inverse_side
    if not cell > -CELL_CLAMP:
        return floor(-CELL_CLAMP)
    return floor(CELL_CLAMP if cell > CELL_CLAMP else cell)


def level_of(diameter: float, side: float) -> int:
    """The finest level whose cells are at least a ball's diameter (times `CELL_SIDE`) wide: each halves the last's."""
    level = 0
    width = 0.5 * side
    while level < FINEST_LEVEL and diameter * CELL_SIDE <= width:
        width = 0.5 * width
        level += 1
    return level


def inverse_side_of(side: float, level: int) -> float:
    """One over the width of the cells of a level."""
    return float(1 << level) / side


def grid_size(width: float, height: float, side: float, count: int, cells_per_ball: float) -> tuple[int, int, int]:
    """How cells are numbered: how many numbers there are, the step from one line to the next, and a mask for numbers.

    As long as the balls' box has no more cells than there is room for, the grid is dense, and the mask changes nothing.
    In a larger box the numbers wrap around, so cells that lie far apart share one, which costs tests and changes
    nothing else: the nine cells around a ball always have nine numbers.
    """
    # With columns and lines to spare around the balls' box the cells around a ball are never off the grid.
    columns = (width / side if width / side < CELL_CLAMP else CELL_CLAMP) + 3.0
    lines = (height / side if height / side < CELL_CLAMP else CELL_CLAMP) + 4.0
    most = 64.0 + cells_per_ball * count
    if columns * lines <= most:
        return int(columns) * int(lines), int(columns), -1
    size, stride, mask = wrapped_size(count)
    return size, int(min(columns, float(stride))), mask


def wrapped_size(count: int) -> tuple[int, int, int]:
    """The same for numbers that always wrap around; steps of the golden section spread the lines evenly."""
    size = 64
    while 2 * size <= 64.0 + GRID_CELLS_PER_BALL * count:
        size *= 2
    return size, int(GOLDEN_SECTION * size) | 1, size - 1


def pairs_by_grid(state: StateRow, balls: Table[BallRow], pair_tables: PairTables, margin: float) -> int:
    """The number of pairs found by sorting the balls into cells, or -1 if there is no room.

    Every ball's radius counts as greater by `margin`: 0, or the way it may go before the pairs are out of date.

    Every ball lies in the one cell of its level that holds its centre, so partners of the same level are in the same
    cell or in one of the eight around it, four of which are enough. Partners of a coarser level are in one of the nine
    cells there. Cells are sorted by counting; `slots` then holds the balls in the order of their cells.
    """
    slots, starts, _pairs = pair_tables
    left, bottom, right, top, smallest, largest = measure_balls(state, balls)
    # As wide as the largest ball: its partners of the same level are in the neighbouring cells.
    side = 2.0 * (largest + margin) * CELL_SIDE
    layered = level_of(2.0 * (smallest + margin), side) > 0
    if layered:
        size, stride, mask = wrapped_size(state["balls"])
    else:
        size, stride, mask = grid_size(right - left, top - bottom, side, state["balls"], GRID_CELLS_PER_BALL)
    if size + 1 > len(starts):
        state["wanted_starts"] = size + 1
        return -1
    levels = sort_balls(state, balls, slots, starts, margin, left, bottom, side, layered, size, stride, mask)
    if layered:
        return pairs_of_levels(state, pair_tables, left, bottom, side, stride, mask, levels)
    return pairs_of_cells(state, pair_tables, size, stride, mask)


def lay_grid(
    state: StateRow, left: float, bottom: float, right: float, top: float, smallest: float, largest: float
) -> None:
    """Lay a grid ahead, around the places that the balls come to in a substep; there is none where radii differ much.

    Shapes may push a ball out of it again, but hardly by more than the cells that there are to spare.
    """
    side = 2.0 * largest * CELL_SIDE
    state["grid_size"] = 0
    if level_of(2.0 * smallest, side) > 0:
        return
    width, height = right - left + 2.0 * side, top - bottom + 2.0 * side
    size, stride, mask = grid_size(width, height, side, state["balls"], GRID_CELLS_AHEAD)
    state["grid_size"] = size
    state["grid_stride"] = stride
    state["grid_mask"] = mask
    state["grid_left"] = left - side
    state["grid_bottom"] = bottom - side
    state["grid_side"] = side


def clear_grid(state: StateRow, starts: Table[int]) -> bool:
    """True when the cells of a grid that was laid ahead are empty; False where there is no room for them."""
    size = int(state["grid_size"])
    if size + 1 > len(starts):
        state["wanted_starts"] = size + 1
        return False
    for k in range(size + 1):
        starts[k] = 0
    return True


def count_ball(grid: Grid, slot: SlotRow, starts: Table[int]) -> bool:
    """True when the ball in a slot is counted in its cell of a grid laid ahead; False where it is off the grid."""
    left, bottom, inverse_side, columns, lines, stride, mask = grid
    x, y = float(slot["x"]), float(slot["y"])
    across, along = (x - left) * inverse_side, (y - bottom) * inverse_side
    if not (0.0 <= across < columns and 0.0 <= along < lines):
        return False
    cell = (int(across) + stride * int(along) + 1) & mask
    slot["cell"] = cell
    starts[cell] += 1
    return True


def grid_ahead(state: StateRow) -> Grid:
    """The grid that was laid ahead, as `count_ball` takes it."""
    size, stride, mask = int(state["grid_size"]), int(state["grid_stride"]), int(state["grid_mask"])
    if size == 0:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0, 0
    left, bottom, inverse_side = float(state["grid_left"]), float(state["grid_bottom"]), 1.0 / float(state["grid_side"])
    # A dense one has two columns and a line more than those that balls may be in; one that wraps around has no end.
    columns = float(stride - 2) if mask == -1 else CELL_CLAMP
    lines = float(size // stride - 1) if mask == -1 else CELL_CLAMP
    return left, bottom, inverse_side, columns, lines, stride, mask


def pairs_ahead(state: StateRow, pair_tables: PairTables) -> int:
    """The number of pairs of the balls that were counted in a grid laid ahead, or -1 if `pairs` ran out of room."""
    slots, starts, _pairs = pair_tables
    size = int(state["grid_size"])
    # Called again with more room, they are sorted already.
    if state["stage_entered"] == 0:
        share_slots(slots, starts, size, int(state["balls"]))
        state["stage_entered"] = 1
    return pairs_of_crowded(state, pair_tables, size, int(state["grid_stride"]), int(state["grid_mask"]))


def pairs_of_crowded(state: StateRow, pair_tables: PairTables, size: int, stride: int, mask: int) -> int:
    """What `pairs_of_cells` finds, in the same order, sooner where most balls have no partner, as in a gas.

    First the balls are listed that may have any. Of these, every candidate is written, and counted only if it is a
    pair: a branch that no processor can foresee costs more.
    """
    slots, starts, pairs = pair_tables
    count = 0
    room = len(pairs)
    total = int(state["balls"])
    for k in range(total, total + list_crowded(state, slots, starts, size, stride, mask)):
        near = int(slots[k]["cell"])
        slot = slots[near]
        ball = slot["ball"]
        x, y, radius = float(slot["x"]), float(slot["y"]), float(slot["radius"])
        cell = int(slot["cell"])
        first = (cell + stride - 1) & mask
        # Few cells have neighbours of which some are at the end of the numbers and some at the beginning.
        if cell + 2 > size or first + 3 > size:
            count = scan_around(state, pair_tables, count, near, 0.0, 0, stride, mask)
            if count < 0:
                return -1
            continue
        begin, end = near + 1, int(starts[cell + 2])
        above, last = int(starts[first]), int(starts[first + 3])
        if count + OWN_LINE + NEXT_LINE + end - begin + last - above > room:
            state["wanted_pairs"] = 2 * room + OWN_LINE + NEXT_LINE + end - begin + last - above
            return -1
        if (end - begin > OWN_LINE) | (last - above > NEXT_LINE):
            for _ in range(2):
                for other in range(begin, end):
                    count = note_pair(pairs, count, ball, slots[other], boxes_meet(slots[other], x, y, radius))
                begin = above
                end = last
            continue
        # How many there are of each no processor can foresee either: all that there may be are looked at.
        for other in range(begin, begin + OWN_LINE):
            is_one = boxes_meet(slots[other], x, y, radius) & (other < end)
            count = note_pair(pairs, count, ball, slots[other], is_one)
        for other in range(above, above + NEXT_LINE):
            is_one = boxes_meet(slots[other], x, y, radius) & (other < last)
            count = note_pair(pairs, count, ball, slots[other], is_one)
    return count


def note_pair(pairs: Pairs, count: int, ball: int, slot: SlotRow, is_one: bool) -> int:
    """The number of pairs after one that is written, and counted only if it is one; there must be room."""
    pairs[count, 0] = ball
    pairs[count, 1] = slot["ball"]
    return count + int(is_one)


def list_crowded(
    state: StateRow, slots: Table[SlotRow], starts: Table[int], size: int, stride: int, mask: int
) -> int:  # fmt: skip
    """List in the upper half of the slots the balls that may have a partner after them; returns how many there are."""
    tests = 0
    total = int(state["balls"])
    listed = total
    for k in range(total):
        slot = slots[k]
        x, y, radius = float(slot["x"]), float(slot["y"]), float(slot["radius"])
        cell = int(slot["cell"])
        first = (cell + stride - 1) & mask
        if mask != -1 and (cell + 2 > size or first + 3 > size):
            slots[listed]["cell"] = k
            listed += 1
            continue
        # Slots of a cell and of the one to its right lie side by side, and so do the three cells of the next line.
        begin, end = k + 1, int(starts[cell + 2])
        above, last = int(starts[first]), int(starts[first + 3])
        tests += end - begin + last - above
        # Most balls have no more candidates than `OWN_LINE` and `NEXT_LINE`, and none is a pair: so much is seen
        # without a branch. What is no candidate, or in the upper half of the slots, does no harm.
        gap = smaller(gap_between(slots[begin], x, y, radius), gap_between(slots[begin + 1], x, y, radius))
        gap = smaller(gap, gap_between(slots[above], x, y, radius))
        gap = smaller(gap, gap_between(slots[above + 1], x, y, radius))
        gap = smaller(gap, gap_between(slots[above + 2], x, y, radius))
        slots[listed]["cell"] = k
        listed += int((gap <= 0.0) | (end - begin > OWN_LINE) | (last - above > NEXT_LINE))
    state["box_tests"] += tests
    return listed - total


def pairs_of_cells(state: StateRow, pair_tables: PairTables, size: int, stride: int, mask: int) -> int:
    """The number of pairs of sorted balls that are all on one level, or -1 if `pairs` ran out of room.

    Every candidate is written, and counted only if it is a pair: a branch that no processor can foresee costs more.
    """
    slots, starts, pairs = pair_tables
    count = 0
    tests = 0
    room = len(pairs)
    for k in range(state["balls"]):
        slot = slots[k]
        ball = slot["ball"]
        x = float(slot["x"])
        y = float(slot["y"])
        radius = float(slot["radius"])
        cell = int(slot["cell"])
        first = (cell + stride - 1) & mask
        # Few cells have neighbours of which some are at the end of the numbers and some at the beginning.
        if cell + 2 > size or first + 3 > size:
            count = scan_around(state, pair_tables, count, k, 0.0, 0, stride, mask)
            if count < 0:
                return -1
            continue
        # Slots of a cell and of the one to its right lie side by side, and so do the three cells of the next line.
        begin = k + 1
        end = int(starts[cell + 2])
        above = int(starts[first])
        last = int(starts[first + 3])
        tests += end - begin + last - above
        # Most balls have no more candidates than these, and none is a pair: so much is seen without a branch. What is
        # no candidate, or in the upper half of the slots, does no harm.
        near = boxes_meet(slots[k + 1], x, y, radius) | boxes_meet(slots[k + 2], x, y, radius)
        near |= boxes_meet(slots[above], x, y, radius) | boxes_meet(slots[above + 1], x, y, radius)
        near |= boxes_meet(slots[above + 2], x, y, radius)
        if not (near | (end - begin > 2) | (last - above > 3)):
            continue
        if count + end - begin + last - above > room:
            state["wanted_pairs"] = 2 * room + end - begin + last - above
            return -1
        for _ in range(2):
            for other in range(begin, end):
                pairs[count, 0] = ball
                pairs[count, 1] = slots[other]["ball"]
                count += int(boxes_meet(slots[other], x, y, radius))
            begin = above
            end = last
    state["box_tests"] += tests
    return count


def boxes_meet(slot: SlotRow, x: float, y: float, radius: float) -> bool:
    """True if the boxes of a sorted ball and of one at (x, y) overlap, as `may_touch` says, without a branch."""
    reach = radius + float(slot["radius"])
    return (fabs(float(slot["x"]) - x) <= reach) & (fabs(float(slot["y"]) - y) <= reach)


def gap_between(slot: SlotRow, x: float, y: float, radius: float) -> float:
    """How far apart the boxes of a sorted ball and of one at (x, y) are; 0 or less where `boxes_meet` is true."""
    across, along = fabs(float(slot["x"]) - x), fabs(float(slot["y"]) - y)
    return larger(across, along) - (radius + float(slot["radius"]))


def cell_number(x: float, y: float, inverse_side: float, level: int, stride: int, mask: int) -> int:
    """The number of the cell at offset `x`, `y` from the grid's corner."""
    return (cell_of(x, inverse_side) + stride * cell_of(y, inverse_side) + 1 + level) & mask


def sort_balls(
    state: StateRow,
    balls: Table[BallRow],
    slots: Table[SlotRow],
    starts: Table[int],
    margin: float,
    left: float,
    bottom: float,
    side: float,
    layered: bool,
    size: int,
    stride: int,
    mask: int,
) -> int:
    """Sort the balls by cell into `slots`; returns the set of levels that hold balls, a bit each.

    The upper half of `slots` gets them in the order of their rows first, so that the rows are read once.
    """
    levels = 0
    total = int(state["balls"])
    for k in range(size + 1):
        starts[k] = 0
    for i in range(total):
        ball = balls[i]
        slot = slots[total + i]
        x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"]) + margin
        level = level_of(2.0 * radius, side) if layered else 0
        levels |= 1 << level
        cell = cell_number(x - left, y - bottom, inverse_side_of(side, level), level, stride, mask)
        slot["x"] = x
        slot["y"] = y
        slot["radius"] = radius
        slot["ball"] = i
        slot["cell"] = cell
        starts[cell] += 1
    share_slots(slots, starts, size, total)
    return levels


def share_slots(slots: Table[SlotRow], starts: Table[int], size: int, total: int) -> None:
    """Sort balls, which stand in the upper half of `slots` and are counted by cell, into the lower half."""
    # Running sums turn counts into the ends of the cells.
    end = 0
    for k in range(size + 1):
        end += starts[k]
        starts[k] = end
    # Filling each cell from its end, last ball first, leaves `starts` at the cells' beginnings and keeps the order.
    for i in range(2 * total - 1, total - 1, -1):
        cell = int(slots[i]["cell"])
        k = starts[cell] - 1
        starts[cell] = k
        slots[k] = slots[i]


def pairs_of_levels(
    state: StateRow,
    pair_tables: PairTables,
    left: float,
    bottom: float,
    side: float,
    stride: int,
    mask: int,
    levels: int,
) -> int:
    """The number of pairs of sorted balls on several levels, `levels` having a bit for each; -1: no room."""
    slots, starts, pairs = pair_tables
    count = 0
    for k in range(state["balls"]):
        slot = slots[k]
        own = level_of(2.0 * float(slot["radius"]), side)
        count = scan_around(state, pair_tables, count, k, side, own, stride, mask)
        # Levels go from coarse to fine: each pair of different levels is found from its finer ball alone.
        for level in range(own):
            if (levels >> level) & 1 and count >= 0:
                x, y = float(slot["x"]) - left, float(slot["y"]) - bottom
                centre = cell_number(x, y, inverse_side_of(side, level), level, stride, mask)
                for step in range(9):
                    cell = (centre + step % 3 - 1 + stride * (step // 3 - 1)) & mask
                    begin, end = int(starts[cell]), int(starts[cell + 1])
                    count = scan(state, slots, pairs, count, k, side, level, begin, end)
        if count < 0:
            return -1
    return count


def scan_around(
    state: StateRow,
    pair_tables: PairTables,
    count: int,
    k: int,
    side: float,
    level: int,
    stride: int,
    mask: int,
) -> int:
    """The number of pairs after the partners of slot `k`'s ball on its own level: in its cell and the next four."""
    slots, starts, pairs = pair_tables
    cell = int(slots[k]["cell"])
    count = scan(state, slots, pairs, count, k, side, level, k + 1, int(starts[cell + 1]))
    for step in range(4):
        other = (cell + (1 if step == 0 else stride + step - 2)) & mask
        count = scan(state, slots, pairs, count, k, side, level, int(starts[other]), int(starts[other + 1]))
    return count


def scan(
    state: StateRow,
    slots: Table[SlotRow],
    pairs: Pairs,
    count: int,
    k: int,
    side: float,
    level: int,
    begin: int,
    end: int,
) -> int:
    """The number of pairs after the partners of slot `k`'s ball that are on a level, among the slots `begin` to `end`.

    Numbers of cells wrap around, so the slots may hold balls of other levels, whose pairs are found elsewhere; `side`
    is 0 where there is one level alone. -1 if `pairs` ran out of room, and if `count` is -1.
    """
    if count < 0:
        return -1
    own = slots[k]
    x, y, radius = float(own["x"]), float(own["y"]), float(own["radius"])
    for other in range(begin, end):
        slot = slots[other]
        near = may_touch(slot["x"] - x, slot["y"] - y, radius + slot["radius"])
        if near and (side == 0.0 or level_of(2.0 * float(slot["radius"]), side) == level):
            count = put_pair(state, pairs, count, own["ball"], slot["ball"])
            if count < 0:
                return -1
    state["box_tests"] += max(end - begin, 0)
    return count
