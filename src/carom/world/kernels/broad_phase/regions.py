"""Where kinematic shapes may be from now on: each in a region that it does not leave, and an index of the regions.

One at rest has its own place; one that turns in place the box of the circle that it can sweep about its pivot; one that
travels the box of what it sweeps while regions hold, `entry["span"]` seconds from now. Then the index is made anew, and
when something is changed from outside. A region that is far wider than the others is near everywhere: its shape stands
in a list of its own. Where regions would lie over each other so much that a step of the discrete mode had more to look
at than it saves, each is the shape's own place, until one moves.

When the index was made last is no part of a world's state, so nothing that is counted may depend on it.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import (
    FEW_BALLS,
    FEW_SHAPES,
    INDEX_MARGIN,
    INDEX_SLACK,
    REGION_CELLS,
    REGION_LOAD,
    REGION_SUBSTEPS,
    REGION_WAY,
    REGION_WIDE,
    ROUNDING,
    SEARCH_MARGIN,
)
from carom.geometry.instants import seconds_since
from carom.geometry.vector import length
from carom.rows.index import NO_CHILD, CellRow, IndexRow, ShapeIndex
from carom.rows.pose import is_moving, reach_of
from carom.rows.shape import ShapeRow
from carom.rows.state import BRUTE, GRID, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import (
    FIXED,
    MOVING,
    cell_side,
    cell_span,
    comes_first,
    index_box,
    locate,
    longest_list,
    open_cells,
    share_members,
)

#: In place of an index, FIXED or MOVING: the list of the kinematic shapes that are asked everywhere; and how many such
#: lists there are.
WIDE = 2
LISTS = 3


def build_regions(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    shape_index: ShapeIndex,
    span: float,
    shown: bool,
) -> bool:
    """True if the index of the kinematic shapes' regions was made; False where room ran out, as in `build_index`.

    Args:
        state: The world's state.
        shapes: Its shapes.
        order: The order in which they are met.
        shape_index: The index, whose static part is right.
        span: Seconds for which the regions of shapes that travel are to hold; infinite where that is not known.
        shown: Whether rows show where shapes are now, and not where their motion began.
    """
    index, cells, members = shape_index
    entry = index[MOVING]
    entry["phase"] = GRID
    entry["reach"] = state["reach"]
    # That of the static shapes may grow a little.
    entry["cells_begin"] = index[FIXED]["cells_end"] + index[FIXED]["cells_end"] // INDEX_SLACK
    entry["cells_end"] = entry["cells_begin"]
    count = int(state["shapes"] - state["fixed"])
    entry["members_begin"] = index[FIXED]["members_end"] + (index[FIXED]["members_end"] + count) // INDEX_SLACK
    entry["members_end"] = entry["members_begin"]
    entry["shown"] = int(shown)
    few = are_few(state, shown)
    if few and shown and state["broad_phase"] == GRID:
        return list_around(state, shapes, order, entry, cells, members)
    list_all(entry)
    entry["swept"] = int(not few and state["broad_phase"] != BRUTE)
    if entry["swept"] != 0:
        width, height = divide(state, shapes, order, entry, span)
        if entry["widest"] >= 0.0:
            if not open_cells(state, entry, width, height, cells):
                return False
            mark_regions(state, shapes, order, entry, cells, members, False)
            if not share_members(state, entry, cells, len(members)):
                return False
            mark_regions(state, shapes, order, entry, cells, members, True)
    return list_wide(state, shapes, order, entry, cells, members)


def are_few(state: StateRow, shown: bool) -> bool:
    """True if there are so few kinematic shapes, and balls, that cells for them would save nothing."""
    count = int(state["shapes"] - state["fixed"])
    if not shown:
        return count <= FEW_SHAPES
    return count == 0 or (state["balls"] <= FEW_BALLS and count <= FEW_SHAPES)


def list_around(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True if all kinematic shapes are in one cell around where they are now; False where room ran out.

    For few shapes and balls, to make that anew whenever one moves costs less than a wider cell.
    """
    begin, end = int(state["fixed"]), int(state["shapes"])
    cell, first = int(entry["cells_begin"]), int(entry["members_begin"])
    entry["span"] = 0.0
    entry["swept"] = 0
    entry["resting"] = 0
    entry["moving"] = 0
    entry["longest"] = end - begin
    entry["wide_begin"] = first
    entry["wide_end"] = first
    if begin == end:
        return True
    if cell + 1 > len(cells) or first + end - begin > len(members):
        state["wanted_cells"] = cell + 1
        state["wanted_members"] = first + end - begin
        return False
    left, bottom, right, top = index_box(shapes, order, begin, end, float(entry["reach"]))
    side = INDEX_MARGIN * max(right - left, top - bottom)
    # One that spans all numbers is everywhere.
    entry["left"] = left if side < inf else 0.0
    entry["bottom"] = bottom if side < inf else 0.0
    entry["side"] = side if side > 0.0 else 1.0
    entry["columns"] = 1
    entry["lines"] = 1
    for k in range(begin, end):
        members[first + k - begin] = order[k]
    cells[cell]["child"] = NO_CHILD
    cells[cell]["begin"] = first
    cells[cell]["end"] = first + end - begin
    entry["cells_end"] = cell + 1
    entry["members_end"] = first + end - begin
    return True


def divide(
    state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow, span: float
) -> tuple[float, float]:
    """The width and height of a grid for regions that hold for a span, whose corner and cells are set.

    (0, 0) where it is better to list all shapes.
    """
    count = int(state["shapes"] - state["fixed"])
    entry["span"] = span
    width, height, load = lay_regions(state, shapes, order, entry)
    if entry["shown"] != 0 and load * float(state["balls"]) > REGION_LOAD * count:
        entry["span"] = 0.0
        width, height, _load = lay_regions(state, shapes, order, entry)
    return width, height


def lay_regions(
    state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow
) -> tuple[float, float, float]:
    """The same for regions as `entry["span"]` makes them, and how many of them lie over each other on the whole."""
    reach = float(entry["reach"])
    widest = REGION_WIDE * mean_extent(state, shapes, order, entry)
    entry["widest"] = widest if widest < inf else 0.0
    left, bottom, right, top = inf, inf, -inf, -inf
    area = 0.0
    count = 0
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        if not is_wide(state, entry, shape):
            count += 1
            x0, y0, x1, y1 = region_of(state, entry, shape)
            left, bottom = min(left, x0 - reach), min(bottom, y0 - reach)
            right, top = max(right, x1 + reach), max(top, y1 + reach)
            area += (x1 - x0 + 2.0 * reach) * (y1 - y0 + 2.0 * reach)
    width, height = right - left, top - bottom
    side = cell_side(state, width, height, count, reach) if count > 0 else inf
    if side == inf:
        # A world that spans all numbers cannot be divided.
        list_all(entry)
        return 0.0, 0.0, 0.0
    entry["left"] = left
    entry["bottom"] = bottom
    entry["side"] = side
    entry["widest"] = min(float(entry["widest"]), REGION_CELLS * side)
    whole = width * height
    return width, height, area / whole if 0.0 < whole < inf else 0.0


def list_all(entry: IndexRow) -> None:
    """Let all kinematic shapes be asked everywhere, whose regions hold for ever then."""
    entry["widest"] = -1.0
    entry["resting"] = 0
    entry["moving"] = 0
    entry["span"] = inf


def span_on_way(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> float:
    """Seconds in which shapes that travel go some of their own widths, on the whole; infinite if none does.

    For so long regions are to hold: they are not made anew often, nor far wider than shapes.
    """
    sizes, speeds = 0.0, 0.0
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        if travels(shape):
            left, bottom, right, top = place_of(shape)
            sizes += max(right - left, top - bottom) + 2.0 * float(state["reach"])
            speeds += length(float(shape["velocity_x"]), float(shape["velocity_y"]))
    return REGION_WAY * (sizes / speeds) if 0.0 < speeds < inf else inf


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
    if travels(shape) and entry["span"] == inf:
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
    if entry["span"] == 0.0:
        return float(shape["left"]), float(shape["bottom"]), float(shape["right"]), float(shape["top"])
    left, bottom, right, top = place_of(shape)
    if not travels(shape):
        return left, bottom, right, top
    begin = 0.0 if entry["shown"] != 0 else age_of_mover(state, shape)
    end = begin + float(entry["span"]) * INDEX_MARGIN
    x0, x1 = float(shape["velocity_x"]) * begin, float(shape["velocity_x"]) * end
    y0, y1 = float(shape["velocity_y"]) * begin, float(shape["velocity_y"]) * end
    x, y = 0.0, 0.0
    if entry["shown"] != 0:
        # A row that is moved by substeps strays a little from the way, by the rounding of each.
        share = REGION_SUBSTEPS * ROUNDING
        x = share * (fabs(float(shape["pivot_x"])) + fabs(x1))
        y = share * (fabs(float(shape["pivot_y"])) + fabs(y1))
    return left + min(x0, x1) - x, bottom + min(y0, y1) - y, right + max(x0, x1) + x, top + max(y0, y1) + y


def age_of_mover(state: StateRow, shape: ShapeRow) -> float:
    """The seconds for which a shape has moved as it does now (continuous)."""
    return seconds_since(
        float(state["now"]), float(state["now_low"]), float(shape["since"]), float(shape["since_low"])
    )  # fmt: skip


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
        else:
            entry["resting"] += 1
        mark_box(region_of(state, entry, shape), row, entry, cells, members, write)


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
    index: Table[IndexRow], cells: Table[CellRow], x: float, y: float
) -> tuple[tuple[int, int], tuple[int, int]]:
    """The two lists of kinematic shapes that a ball at (x, y) may overlap now: those near there, and the wide ones."""
    entry = index[MOVING]
    near = cell_span(cells, locate(entry, cells, x, y))
    return near, (int(entry["wide_begin"]), int(entry["wide_end"]))


def list_near(
    index: Table[IndexRow], cells: Table[CellRow], which: int, x: float, y: float
) -> tuple[int, int]:  # fmt: skip
    """Where one of the `LISTS` of shapes that a ball at (x, y) may overlap begins and ends in `members`.

    First the static shapes near there, then the kinematic ones, and last those that are wide.
    """
    if which == WIDE:
        return int(index[MOVING]["wide_begin"]), int(index[MOVING]["wide_end"])
    return cell_span(cells, locate(index[which], cells, x, y))


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
