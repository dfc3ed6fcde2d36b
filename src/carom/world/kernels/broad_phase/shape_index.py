"""Which shapes a ball may meet: an index from the place of its centre to a short list of shapes.

The index of the static shapes is made when they change, that of the kinematic ones (`regions`) when they may be
elsewhere than it says. Lists hold shapes in the order in which a ball meets them: points, segments and gates, circles,
arcs.
"""

from __future__ import annotations

from math import fabs, floor, inf, sqrt

from carom.constants import (
    CELL_PARTS,
    FEW_FIXED,
    FLIGHT_CELLS_PER_SHAPE,
    INDEX_CELLS_MOST,
    INDEX_CELLS_PER_SHAPE,
    INDEX_MARGIN,
    INDEX_SLACK,
    PART_MARGIN,
    ROUNDING,
)
from carom.geometry.vector import larger, smaller
from carom.rows.ball import BallRow
from carom.rows.index import NO_CHILD, CellRow, IndexRow, ShapeIndex
from carom.rows.kinds_near import distance_to_shape
from carom.rows.shape import ShapeRow
from carom.rows.state import BRUTE, DISCRETE, GRID, QUADTREE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.quadtree import build_tree, locate_node, plant_root

FIXED = 0
MOVING = 1

#: The ways in which a grid is looked through from a cell, right and up, left and up, right and down, left and down; and
#: the bits in which how far is kept for each, with the most that they hold.
QUARTERS = 4
CLEAR_BITS, CLEAR_MOST = 16, 32767

#: Whether static shapes are in a grid, and kinematic ones, if there are any, in another; that of the static ones: left,
#: bottom, 1/side, columns, lines; and a rectangle that is free of all: left, bottom, right, top.
Front = tuple[bool, float, float, float, float, float, float, float, float, float]


def locate(entry: IndexRow, cells: Table[CellRow], x: float, y: float) -> int:
    """The cell whose members are all the shapes that a ball at (x, y) may overlap, or -1 where there are none."""
    first = int(entry["cells_begin"])
    if entry["cells_end"] == first:
        return -1
    if entry["phase"] == BRUTE:
        return first
    if entry["phase"] == GRID:
        columns, lines = int(entry["columns"]), int(entry["lines"])
        across = (x - float(entry["left"])) / float(entry["side"])
        along = (y - float(entry["bottom"])) / float(entry["side"])
        if 0.0 <= across < columns and 0.0 <= along < lines:
            return first + floor(along) * columns + floor(across)
        return -1
    return locate_node(cells, first, x, y)


def front_of(state: StateRow, index: Table[IndexRow]) -> Front:
    """What `is_free` and `cell_near` have to know of the index; of one that is not made of grids, nothing."""
    entry = index[FIXED]
    free = inf, inf, -inf, -inf
    moving = state["fixed"] < state["shapes"]
    if state["broad_phase"] != GRID or (moving and index[MOVING]["swept"] == 0):
        return False, 0.0, 0.0, 0.0, 0.0, 0.0, *free
    if not moving:
        free = (
            float(entry["free_left"]), float(entry["free_bottom"]), float(entry["free_right"]), float(entry["free_top"])
        )  # fmt: skip
    if entry["cells_end"] == entry["cells_begin"]:
        return True, 0.0, 0.0, 0.0, 0.0, 0.0, *free
    left, bottom, inverse_side = float(entry["left"]), float(entry["bottom"]), 1.0 / float(entry["side"])
    return True, left, bottom, inverse_side, float(entry["columns"]), float(entry["lines"]), *free


def is_free(front: Front, x: float, y: float) -> bool:
    """True where the box of a ball at (x, y) surely meets no shape's, which is soon found."""
    _plain, _x, _y, _side, _columns, _lines, left, bottom, right, top = front
    return left <= x <= right and bottom <= y <= top


def cell_near(cells: Table[CellRow], front: Front, x: float, y: float) -> int:
    """The cell of static shapes that a ball at (x, y) is in, if one's box is in reach of its part of it; -1 if not.

    The front must be one of a grid.
    """
    _plain, left, bottom, inverse_side, columns, lines, _left, _bottom, _right, _top = front
    # As `locate`, but multiplied: this is done for many balls in every substep.
    across, along = (x - left) * inverse_side, (y - bottom) * inverse_side
    if not (0.0 <= across < columns and 0.0 <= along < lines):
        return -1
    column, line = int(across), int(along)
    # The static shapes' cells come first of all.
    cell = line * int(columns) + column
    part = int((across - column) * CELL_PARTS) + CELL_PARTS * int((along - line) * CELL_PARTS)
    return cell if (cells[cell]["marks"] >> part) & 1 != 0 else -1


def cell_span(cells: Table[CellRow], cell: int) -> tuple[int, int]:
    """Where the members of a cell begin and end; (0, 0) for the cell -1, which has none."""
    if cell < 0:
        return 0, 0
    return int(cells[cell]["begin"]), int(cells[cell]["end"])


def rest_of_cell(
    shapes: Table[ShapeRow], cells: Table[CellRow], members: Table[int], cell: int, row: int
) -> tuple[int, int]:
    """Where the members of a cell begin and end that a ball meets after the shape in `row`, which may be elsewhere."""
    begin, end = cell_span(cells, cell)
    while begin < end and not comes_first(shapes, row, int(members[begin])):
        begin += 1
    return begin, end


def comes_first(shapes: Table[ShapeRow], row: int, other: int) -> bool:
    """True if members' order has a shape before another one: by kinds, and within a kind by rows."""
    kind, other_kind = shapes[row]["kind"], shapes[other]["kind"]
    return bool(kind < other_kind or (kind == other_kind and row < other))


def build_index(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    shape_index: ShapeIndex,
) -> bool:
    """True if the index of the static shapes was made for balls as large as there are.

    False where room ran out; `state["wanted_*"]` says how much. That of the kinematic shapes stands behind it.
    """
    index, cells, members = shape_index
    entry = index[FIXED]
    begin, end = int(state["dropped"]), int(state["fixed"])
    reach = float(state["reach"])
    entry["phase"] = state["broad_phase"]
    entry["reach"] = reach
    entry["cells_begin"] = 0
    entry["members_begin"] = 0
    entry["cells_end"] = 0
    entry["members_end"] = 0
    entry["longest"] = 0
    entry["measured"] = 0
    find_free(shapes, order, entry, begin, end)
    if begin == end:
        return True
    left, bottom, right, top = index_box(shapes, order, begin, end, reach)
    # From here on the fields say where cells and members are, for `locate`.
    side = cell_side(state, right - left, top - bottom, end - begin, reach)
    vast = side == inf
    entry["left"] = 0.0 if vast else left
    entry["bottom"] = 0.0 if vast else bottom
    entry["right"] = right
    entry["top"] = top
    entry["side"] = side
    entry["columns"] = 1
    entry["lines"] = 1
    width, height = right - left, top - bottom
    if state["broad_phase"] == GRID and not vast:
        built = build_grid(state, shapes, order, entry, begin, end, width, height, cells, members)
    else:
        tree = state["broad_phase"] == QUADTREE and not vast
        built = build_nodes(state, balls, shapes, order, entry, begin, end, width, height, tree, cells, members)
    entry["longest"] = longest_list(entry, cells)
    return built


def find_free(shapes: Table[ShapeRow], order: Table[int], entry: IndexRow, begin: int, end: int) -> None:
    """Find a rectangle in which a ball's centre has none of the boxes of the shapes `order[begin:end]` in reach.

    It is what a rectangle around all of them is cut down to by one shape after the other, each where that leaves the
    most: all of a room without walls but its outer ones. Where there are many shapes it is not looked for.
    """
    reach = float(entry["reach"])
    left, bottom, right, top = -inf, -inf, inf, inf
    many = end - begin > FEW_FIXED
    if many:
        left, bottom, right, top = inf, inf, -inf, -inf
    elif begin < end:
        left, bottom, right, top = index_box(shapes, order, begin, end, reach)
        reach = reach * INDEX_MARGIN + 4.0 * ROUNDING * (fabs(left) + fabs(bottom))
    for k in range(begin, begin if many else end):
        shape = shapes[order[k]]
        low_x, low_y = float(shape["left"]) - reach, float(shape["bottom"]) - reach
        high_x, high_y = float(shape["right"]) + reach, float(shape["top"]) + reach
        if low_x > right or high_x < left or low_y > top or high_y < bottom:
            continue
        # What is left of it to the left of the shape, to the right, below and above.
        width, height = right - left, top - bottom
        beside = larger((low_x - left) * height, (right - high_x) * height)
        along = larger((low_y - bottom) * width, (top - high_y) * width)
        if beside >= along and low_x - left >= right - high_x:
            right = low_x
        elif beside >= along:
            left = high_x
        elif low_y - bottom >= top - high_y:
            top = low_y
        else:
            bottom = high_y
    entry["free_left"] = left
    entry["free_bottom"] = bottom
    entry["free_right"] = right
    entry["free_top"] = top


def longest_list(entry: IndexRow, cells: Table[CellRow]) -> int:
    """The number of members of the fullest cell."""
    longest = 0
    for cell in range(entry["cells_begin"], entry["cells_end"]):
        if cells[cell]["child"] == NO_CHILD:
            longest = max(longest, int(cells[cell]["end"] - cells[cell]["begin"]))
    return longest


def build_nodes(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    begin: int,
    end: int,
    width: float,
    height: float,
    tree: bool,
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True if the shapes `order[begin:end]` were put into a quadtree, or into one cell.

    That is for brute force, and for a world that spans all numbers, which cannot be divided.
    """
    left, bottom, reach = float(entry["left"]), float(entry["bottom"]), float(entry["reach"])
    root = int(entry["cells_begin"])
    free = int(entry["members_begin"]) + end - begin
    if root + 1 > len(cells) or free > len(members):
        state["wanted_cells"] = root + 1
        state["wanted_members"] = free
        return False
    plant_root(cells[root], left + 0.5 * width, bottom + 0.5 * height, free - (end - begin), free)
    for k in range(begin, end):
        members[free - end + k] = order[k]
    last = root + 1
    if tree:
        last = build_tree(state, balls, shapes, False, reach, cells, members, root, width, height)
    entry["cells_end"] = max(last, root)
    entry["members_end"] = free if last <= root + 1 else cells[last - 1]["end"]
    return last > 0


def index_box(
    shapes: Table[ShapeRow], order: Table[int], begin: int, end: int, reach: float
) -> tuple[float, float, float, float]:
    """The box of the shapes `order[begin:end]`, larger by `reach` on all sides."""
    first = shapes[order[begin]]
    left, bottom = float(first["left"]), float(first["bottom"])
    right, top = float(first["right"]), float(first["top"])
    for k in range(begin + 1, end):
        shape = shapes[order[k]]
        left = min(left, float(shape["left"]))
        bottom = min(bottom, float(shape["bottom"]))
        right = max(right, float(shape["right"]))
        top = max(top, float(shape["top"]))
    return left - reach, bottom - reach, right + reach, top + reach


def cell_side(state: StateRow, width: float, height: float, count: int, reach: float) -> float:
    """The width of a grid's cells: about so many cells as suits the number of shapes, none smaller than a ball."""
    # The root of the product, not the product: width times height may be more than a number can hold.
    each = INDEX_CELLS_PER_SHAPE if state["detection"] == DISCRETE else FLIGHT_CELLS_PER_SHAPE
    most = min(each * count, INDEX_CELLS_MOST)
    side = max(sqrt(width / most) * sqrt(height), max(width, height) / most, 2.0 * reach)
    return side if side > 0.0 else 1.0


def build_grid(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    begin: int,
    end: int,
    width: float,
    height: float,
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True if the shapes `order[begin:end]` were put into every cell that they come within `entry["reach"]` of."""
    if not open_cells(state, entry, width, height, cells):
        return False
    for k in range(begin, end):
        mark_cells(shapes[order[k]], order[k], entry, cells, members, False)
    # Changes put members behind all others: see `move_members`.
    if not share_members(state, entry, cells, len(members) - len(members) // INDEX_SLACK):
        state["wanted_members"] = max(int(state["wanted_members"]), len(members) + 1)
        return False
    for k in range(begin, end):
        mark_cells(shapes[order[k]], order[k], entry, cells, members, True)
    return True


def open_cells(state: StateRow, entry: IndexRow, width: float, height: float, cells: Table[CellRow]) -> bool:
    """True when a grid has its cells, in which nothing was counted yet; False if there are too few rows for them."""
    side = float(entry["side"])
    entry["columns"] = int(width / side) + 1
    entry["lines"] = int(height / side) + 1
    first = int(entry["cells_begin"])
    last = first + int(entry["columns"] * entry["lines"])
    if last > len(cells):
        state["wanted_cells"] = last
        return False
    for cell in range(first, last):
        cells[cell]["child"] = NO_CHILD
        cells[cell]["end"] = 0
        cells[cell]["depth"] = 0
        cells[cell]["marks"] = 0
    return True


def share_members(state: StateRow, entry: IndexRow, cells: Table[CellRow], room: int) -> bool:
    """True when each cell of a grid, whose members are counted, has its place for them; False if `room` is too little.

    Each is empty then, up to where its first member is to be written.
    """
    first = int(entry["cells_begin"])
    last = first + int(entry["columns"] * entry["lines"])
    total = int(entry["members_begin"])
    for cell in range(first, last):
        held = int(cells[cell]["end"])
        cells[cell]["begin"] = total
        cells[cell]["end"] = total
        total += held
    if total > room:
        state["wanted_members"] = total
        return False
    entry["cells_end"] = last
    entry["members_end"] = total
    return True


def clear_towards(cell: CellRow, quarter: int) -> int:
    """How many cells wide the square without members is that lies from a grid's cell on towards a quarter."""
    return (int(cell["clear"]) >> (CLEAR_BITS * quarter)) & CLEAR_MOST


def set_clear(cell: CellRow, quarter: int, wide: int) -> None:
    """Keep how wide that square is."""
    bits = CLEAR_BITS * quarter
    cell["clear"] = (int(cell["clear"]) & ~(CLEAR_MOST << bits)) | (wide << bits)


def quarter_of(rightwards: bool, upwards: bool) -> int:
    """The number of one of the four `QUARTERS` in which things may be, as seen from a cell."""
    return (0 if rightwards else 1) + (0 if upwards else 2)


def measure_clear(entry: IndexRow, cells: Table[CellRow]) -> None:
    """Find how wide the squares without members are that lie from each cell of a grid on towards the four quarters.

    One is wider by 1 than the narrowest of those of its cell's three neighbours on that side, as all of them lie in it.
    """
    columns, lines, first = int(entry["columns"]), int(entry["lines"]), int(entry["cells_begin"])
    for quarter in range(QUARTERS):
        right, up = 1 - 2 * (quarter % 2), 1 - 2 * (quarter // 2)
        for k in range(columns * lines):
            # From the side that is looked to, back: what lies there is known.
            column, line = k % columns, k // columns
            column = columns - 1 - column if right > 0 else column
            line = lines - 1 - line if up > 0 else line
            cell = cells[first + line * columns + column]
            wide = 0
            if cell["end"] == cell["begin"]:
                wide = CLEAR_MOST - 1
                beside, beyond = 0 <= column + right < columns, 0 <= line + up < lines
                if beside:
                    wide = min(wide, clear_towards(cells[first + line * columns + column + right], quarter))
                if beyond:
                    wide = min(wide, clear_towards(cells[first + (line + up) * columns + column], quarter))
                if beside and beyond:
                    wide = min(wide, clear_towards(cells[first + (line + up) * columns + column + right], quarter))
                wide += 1
            set_clear(cell, quarter, wide)
    entry["measured"] = 1


def mark_cells(
    shape: ShapeRow, row: int, entry: IndexRow, cells: Table[CellRow], members: Table[int], write: bool
) -> None:
    """Count a shape in every cell that it comes within reach of, and write it there too if `write`."""
    near = reach_of_cell(entry)
    first_column, last_column, first_line, last_line = cells_around(shape, entry)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            if comes_near(shape, entry, column, line, near):
                cell = cells[int(entry["cells_begin"]) + line * int(entry["columns"]) + column]
                if write:
                    members[cell["end"]] = row
                    mark_parts(cell, shape, entry, column, line)
                cell["end"] += 1


def mark_parts(cell: CellRow, shape: ShapeRow, entry: IndexRow, column: int, line: int) -> None:
    """Mark the parts of a cell from which the box of a shape is in reach."""
    side = float(entry["side"])
    left, bottom = float(entry["left"]) + column * side, float(entry["bottom"]) + line * side
    reach = float(entry["reach"]) * INDEX_MARGIN + index_rounding(entry)
    first, last = parts_between(float(shape["left"]) - reach - left, float(shape["right"]) + reach - left, side)
    low, high = parts_between(float(shape["bottom"]) - reach - bottom, float(shape["top"]) + reach - bottom, side)
    row = ((2 << last) - 1) & ~((1 << first) - 1)
    for part in range(low, high + 1):
        cell["marks"] |= row << (CELL_PARTS * part)


def parts_between(begin: float, end: float, side: float) -> tuple[int, int]:
    """The first and the last part of a cell, along an axis, that are in a range, which is taken from its corner."""
    first = larger(CELL_PARTS * (begin / side) - PART_MARGIN, 0.0)
    last = larger(CELL_PARTS * (end / side) + PART_MARGIN, 0.0)
    return int(smaller(first, CELL_PARTS - 1.0)), int(smaller(last, CELL_PARTS - 1.0))


def reach_of_cell(entry: IndexRow) -> float:
    """The distance from a cell's middle within which a shape is one of its members."""
    # Half a cell's diagonal from its middle to its corner.
    return (float(entry["reach"]) + float(entry["side"]) * sqrt(0.5)) * INDEX_MARGIN + index_rounding(entry)


def index_rounding(entry: IndexRow) -> float:
    """What is added to distances, so that rounding far from the origin loses no shape."""
    return 4.0 * ROUNDING * (fabs(float(entry["left"])) + fabs(float(entry["bottom"])))


def cells_around(shape: ShapeRow, entry: IndexRow) -> tuple[int, int, int, int]:
    """The first and last column, and the first and last line, of the cells that a shape may be a member of."""
    side, reach = float(entry["side"]), float(entry["reach"])
    left, bottom = float(entry["left"]), float(entry["bottom"])
    first_column = max(int((float(shape["left"]) - reach - left) / side) - 1, 0)
    last_column = min(int((float(shape["right"]) + reach - left) / side) + 1, int(entry["columns"]) - 1)
    first_line = max(int((float(shape["bottom"]) - reach - bottom) / side) - 1, 0)
    last_line = min(int((float(shape["top"]) + reach - bottom) / side) + 1, int(entry["lines"]) - 1)
    return first_column, last_column, first_line, last_line


def comes_near(shape: ShapeRow, entry: IndexRow, column: int, line: int, near: float) -> bool:
    """True if a shape comes so near to the middle of a cell that it is one of its members."""
    side, left, bottom = float(entry["side"]), float(entry["left"]), float(entry["bottom"])
    return distance_to_shape(shape, left + (column + 0.5) * side, bottom + (line + 0.5) * side) <= near
