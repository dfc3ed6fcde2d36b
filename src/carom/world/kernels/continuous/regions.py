"""Where kinematic shapes may be from now on: each in a region that it does not leave, and an index of the regions.

One at rest has its own place; one that turns in place the box of the circle that it can sweep about its pivot; one that
travels the box of what it sweeps until an instant, `state["valid"]`, at which the index is made anew. A region that is
far wider than the others is near everywhere: its shape stands in a list of its own. What is changed from outside makes
the index anew too.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import FEW_SHAPES, INDEX_MARGIN, REGION_CELLS, REGION_WAY, REGION_WIDE, ROUNDING, SEARCH_MARGIN
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.index import CellRow, IndexRow, ShapeIndex
from carom.rows.pose import is_moving, reach_of
from carom.rows.shape import ShapeRow
from carom.rows.state import GRID, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import (
    FIXED,
    MOVING,
    cell_side,
    cell_span,
    comes_first,
    locate,
    longest_list,
    mark_cells,
    measure_clear,
    open_cells,
    share_members,
)
from carom.world.kernels.continuous.instants import is_before, later
from carom.world.kernels.continuous.movers import age_of_mover
from carom.world.kernels.step.discrete import rebuild_static


def rebuild_regions(
    state: StateRow, balls: Table[BallRow], shapes: Table[ShapeRow], order: Table[int], shape_index: ShapeIndex
) -> bool:
    """True when the index of shapes is right for flights from now on; False where it has no room."""
    index, cells, members = shape_index
    if not rebuild_static(state, balls, shapes, order, shape_index):
        return False
    entry = index[FIXED]
    if entry["measured"] == 0 and state["broad_phase"] == GRID and state["fixed"] - state["dropped"] > FEW_SHAPES:
        measure_clear(entry, cells)
    # Balls that are parted ask where kinematic shapes are, not where they may be.
    state["moving_stale"] = 1
    return build_regions(state, shapes, order, index, cells, members)


def build_regions(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True if the index of the kinematic shapes' regions was made; False where room ran out, as in `build_index`."""
    entry = index[MOVING]
    entry["reach"] = state["reach"]
    entry["cells_begin"] = index[FIXED]["cells_end"]
    entry["cells_end"] = entry["cells_begin"]
    entry["members_begin"] = index[FIXED]["members_end"]
    entry["members_end"] = entry["members_begin"]
    width, height = divide(state, shapes, order, entry)
    if entry["widest"] >= 0.0:
        if not open_cells(state, entry, width, height, cells):
            return False
        mark_regions(state, shapes, order, entry, cells, members, False)
        if not share_members(state, entry, cells, len(members)):
            return False
        mark_regions(state, shapes, order, entry, cells, members, True)
    return list_wide(state, shapes, order, entry, cells, members)


def divide(state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow) -> tuple[float, float]:
    """The width and height of the regions' grid, whose corner and cells are set; (0, 0) where all shapes are listed."""
    begin, end = int(state["fixed"]), int(state["shapes"])
    reach = float(entry["reach"])
    list_all(state, entry)
    entry["span"] = 0.0
    if end - begin <= FEW_SHAPES or state["broad_phase"] != GRID:
        return 0.0, 0.0
    find_span(state, shapes, order, entry)
    widest = REGION_WIDE * mean_extent(state, shapes, order, entry)
    entry["widest"] = widest if widest < inf else 0.0
    left, bottom, right, top = inf, inf, -inf, -inf
    count = 0
    for k in range(begin, end):
        shape = shapes[order[k]]
        if not is_wide(state, entry, shape):
            count += 1
            x0, y0, x1, y1 = region_of(state, entry, shape)
            left, bottom = min(left, x0 - reach), min(bottom, y0 - reach)
            right, top = max(right, x1 + reach), max(top, y1 + reach)
    side = cell_side(right - left, top - bottom, count, reach) if count > 0 else inf
    if side == inf:
        # A world that spans all numbers cannot be divided.
        list_all(state, entry)
        return 0.0, 0.0
    entry["left"] = left
    entry["bottom"] = bottom
    entry["side"] = side
    entry["widest"] = min(float(entry["widest"]), REGION_CELLS * side)
    return right - left, top - bottom


def list_all(state: StateRow, entry: IndexRow) -> None:
    """Let all kinematic shapes be asked everywhere, whose regions hold for ever then."""
    entry["widest"] = -1.0
    entry["resting"] = 0
    entry["moving"] = 0
    state["valid"] = inf
    state["valid_low"] = 0.0


def find_span(state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow) -> None:
    """Choose the time for which regions hold: that in which what travels goes some of its own widths, on the whole.

    Twice as long after each renewal without an event since: a step's work does not grow with its length where nothing
    happens.
    """
    sizes, speeds = 0.0, 0.0
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        if travels(shape):
            left, bottom, right, top = place_of(shape)
            sizes += max(right - left, top - bottom) + 2.0 * float(entry["reach"])
            speeds += length(float(shape["velocity_x"]), float(shape["velocity_y"]))
    if not 0.0 < speeds < inf:
        return
    span = REGION_WAY * (sizes / speeds)
    for _ in range(state["renewals"]):
        span *= 2.0
    now, now_low = float(state["now"]), float(state["now_low"])
    time, low = later(now, now_low, span)
    if span < inf and is_before(now, now_low, time, low):
        entry["span"] = span
        state["valid"] = time
        state["valid_low"] = low


def travels(shape: ShapeRow) -> bool:
    """True if a shape moves otherwise than about its pivot."""
    return is_moving(shape) and bool(shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0)


def mean_extent(state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow) -> float:
    """The mean extent of the regions of all shapes that move; 0 if none does."""
    total, count = 0.0, 0
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        if is_moving(shape):
            total += extent_of(state, entry, shape)
            count += 1
    return total / count if count > 0 else 0.0


def extent_of(state: StateRow, entry: IndexRow, shape: ShapeRow) -> float:
    """The greater of a region's width and height; infinite where it is not known how far a shape travels."""
    if travels(shape) and entry["span"] == 0.0:
        return inf
    left, bottom, right, top = region_of(state, entry, shape)
    return max(right - left, top - bottom)


def is_wide(state: StateRow, entry: IndexRow, shape: ShapeRow) -> bool:
    """True if a shape is in the list of those that are asked everywhere."""
    if entry["widest"] < 0.0:
        return True
    return is_moving(shape) and not extent_of(state, entry, shape) <= entry["widest"]


def place_of(shape: ShapeRow) -> tuple[float, float, float, float]:
    """The box of a shape, or that of all places to which it can turn about its pivot, as its motion begins."""
    if not is_moving(shape) or shape["spin"] == 0.0:
        return float(shape["left"]), float(shape["bottom"]), float(shape["right"]), float(shape["top"])
    x, y, reach = float(shape["pivot_x"]), float(shape["pivot_y"]), reach_of(shape) * INDEX_MARGIN
    return x - reach, y - reach, x + reach, y + reach


def region_of(state: StateRow, entry: IndexRow, shape: ShapeRow) -> tuple[float, float, float, float]:
    """The box that a shape does not leave from now on, or as long as regions hold."""
    left, bottom, right, top = place_of(shape)
    if not travels(shape):
        return left, bottom, right, top
    begin = age_of_mover(state, shape)
    end = begin + float(entry["span"]) * INDEX_MARGIN
    x0, x1 = float(shape["velocity_x"]) * begin, float(shape["velocity_x"]) * end
    y0, y1 = float(shape["velocity_y"]) * begin, float(shape["velocity_y"]) * end
    return left + min(x0, x1), bottom + min(y0, y1), right + max(x0, x1), top + max(y0, y1)


def mark_regions(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    write: bool,
) -> None:
    """Count the shapes that are not listed in every cell that their region comes within reach of, or write them."""
    entry["resting"] = 0
    entry["moving"] = 0
    for k in range(state["fixed"], state["shapes"]):
        row = int(order[k])
        shape = shapes[row]
        if is_wide(state, entry, shape):
            continue
        if is_moving(shape):
            entry["moving"] += 1
            mark_box(region_of(state, entry, shape), row, entry, cells, members, write)
        else:
            entry["resting"] += 1
            mark_cells(shape, row, entry, cells, members, write)


def mark_box(
    box: tuple[float, float, float, float],
    row: int,
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    write: bool,
) -> None:
    """Count a shape in every cell that a box comes within reach of, and write it there too if `write`."""
    box_left, box_bottom, box_right, box_top = box
    side, left, bottom = float(entry["side"]), float(entry["left"]), float(entry["bottom"])
    columns, lines = int(entry["columns"]), int(entry["lines"])
    # Rounding far from the origin must not lose a shape.
    near = float(entry["reach"]) * INDEX_MARGIN + SEARCH_MARGIN * side + 4.0 * ROUNDING * (fabs(left) + fabs(bottom))
    first_column = max(int((box_left - near - left) / side), 0)
    last_column = min(int((box_right + near - left) / side), columns - 1)
    first_line = max(int((box_bottom - near - bottom) / side), 0)
    last_line = min(int((box_top + near - bottom) / side), lines - 1)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            cell = cells[int(entry["cells_begin"]) + line * columns + column]
            if write:
                members[cell["end"]] = row
            cell["end"] += 1


def list_wide(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True when the shapes that are asked everywhere are listed behind the cells' members; False if room ran out."""
    free = int(entry["members_end"])
    most = free + int(state["shapes"] - state["fixed"])
    if most > len(members):
        state["wanted_members"] = most
        return False
    entry["wide_begin"] = free
    for k in range(state["fixed"], state["shapes"]):
        row = int(order[k])
        if is_wide(state, entry, shapes[row]):
            members[free] = row
            free += 1
    entry["wide_end"] = free
    entry["members_end"] = free
    entry["longest"] = longest_list(entry, cells) + free - int(entry["wide_begin"])
    return True


def kinematic_near(
    state: StateRow, index: Table[IndexRow], cells: Table[CellRow], x: float, y: float
) -> tuple[tuple[int, int], tuple[int, int]]:
    """The two lists of kinematic shapes that a ball at (x, y) may overlap now: those near there, and the wide ones."""
    entry = index[MOVING]
    near = cell_span(cells, locate(state, entry, cells, x, y))
    return near, (int(entry["wide_begin"]), int(entry["wide_end"]))


def is_any_near(near: tuple[int, int], wide: tuple[int, int]) -> bool:
    """True unless two lists, given as to `next_near`, are empty."""
    k, end = near
    w, wide_end = wide
    return k < end or w < wide_end


def next_near(
    shapes: Table[ShapeRow], members: Table[int], near: tuple[int, int], wide: tuple[int, int]
) -> tuple[int, tuple[int, int], tuple[int, int]]:
    """The first shape of two lists, of which one is not empty, each in members' order, and what is left of both.

    The lists are given, and returned, by where they begin and end in `members`.
    """
    k, end = near
    w, wide_end = wide
    if w == wide_end or (k < end and comes_first(shapes, int(members[k]), int(members[w]))):
        return int(members[k]) + 0, (k + 1, end), wide
    return int(members[w]) + 0, near, (w + 1, wide_end)
