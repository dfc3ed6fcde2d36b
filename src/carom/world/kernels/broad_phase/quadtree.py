"""A quadtree over boxes, those of shapes or of balls, built level by level in two flat tables.

A node is a row of `cells` with its centre; its four children, south-west first, stand in a row from `child` on. A
leaf's members stand in `members[begin:end]`. Boxes that meet several leaves are members of each. Points outside of the
root's box belong to the leaf nearest in both coordinates, so nothing is ever outside the tree.
"""

from __future__ import annotations

from math import inf

from carom.constants import CELL_SIDE, LEAF_MEMBERS, TREE_COPIES_OF_BALLS, TREE_COPIES_OF_SHAPES
from carom.rows.ball import BallRow
from carom.rows.index import NO_CHILD, CellRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def plant_root(cell: CellRow, x: float, y: float, begin: int, end: int) -> None:
    """Make a cell the root of a tree around (x, y) with the members from `begin` to `end`."""
    cell["x"] = x
    cell["y"] = y
    cell["child"] = NO_CHILD
    cell["depth"] = 0
    cell["begin"] = begin
    cell["end"] = end


def locate_node(cells: Table[CellRow], root: int, x: float, y: float) -> int:
    """The leaf that (x, y) lies in, as a row of `cells`."""
    node = root
    while cells[node]["child"] != NO_CHILD:
        node = cells[node]["child"] + child_of(cells[node], x, y)
    return node


def child_of(cell: CellRow, x: float, y: float) -> int:
    """Which of a node's four quarters (x, y) lies in, 0 to 3."""
    east = 1 if x >= cell["x"] else 0
    north = 2 if y >= cell["y"] else 0
    return east + north


def item_box(
    balls: Table[BallRow], shapes: Table[ShapeRow], of_balls: bool, item: int, reach: float
) -> tuple[float, float, float, float]:
    """The box of a ball, a little larger than the ball, or of a shape, larger by `reach`."""
    if of_balls:
        x = float(balls[item]["x"])
        y = float(balls[item]["y"])
        half = float(balls[item]["radius"]) * CELL_SIDE
        return x - half, y - half, x + half, y + half
    shape = shapes[item]
    left, bottom = float(shape["left"]), float(shape["bottom"])
    right, top = float(shape["right"]), float(shape["top"])
    return left - reach, bottom - reach, right + reach, top + reach


def meets_quarter(cell: CellRow, quarter: int, left: float, bottom: float, right: float, top: float) -> bool:
    """True if a box that meets a node meets one of its quarters too."""
    # West of the middle is below it, east at or above, as `child_of` has it for points.
    across = right >= cell["x"] if quarter & 1 else left < cell["x"]
    along = top >= cell["y"] if quarter & 2 else bottom < cell["y"]
    return bool(across and along)


def split(
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    of_balls: bool,
    reach: float,
    cells: Table[CellRow],
    members: Table[int],
    node: int,
    child: int,
    free: int,
    quarter_width: float,
    quarter_height: float,
) -> int:
    """The number of members in use after sharing out a node's members among its children, `child` and the next three.

    Members that find no room are counted and not written.
    """
    cell = cells[node]
    cell["child"] = child
    for quarter in range(4):
        part = cells[child + quarter]
        part["x"] = cell["x"] + (quarter_width if quarter & 1 else -quarter_width)
        part["y"] = cell["y"] + (quarter_height if quarter & 2 else -quarter_height)
        part["child"] = NO_CHILD
        part["depth"] = cell["depth"] + 1
        part["begin"] = free
        for k in range(cell["begin"], cell["end"]):
            item = members[k]
            left, bottom, right, top = item_box(balls, shapes, of_balls, item, reach)
            if meets_quarter(cell, quarter, left, bottom, right, top):
                if free < len(members):
                    members[free] = item
                free += 1
        part["end"] = free
    return free


def build_tree(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    of_balls: bool,
    reach: float,
    cells: Table[CellRow],
    members: Table[int],
    root: int,
    width: float,
    height: float,
) -> int:
    """The row of `cells` after the tree's last node, or -1 where room ran out (`state["wanted_*"]` says how much).

    The root, with its centre and its members, is there already; it is `width` by `height`. A node is split while it has
    more than `LEAF_MEMBERS` members and is above the lowest of the world's `levels`, unless its quarters would hold too
    many copies of them: boxes larger than a node gain nothing from smaller ones. One that is as wide as numbers reach
    stays whole.
    """
    copies = TREE_COPIES_OF_BALLS if of_balls else TREE_COPIES_OF_SHAPES
    level_begin = root
    end = root + 1
    free = int(cells[root]["end"])
    if not (width < inf and height < inf):
        return end
    for _ in range(1, state["levels"]):
        width = 0.5 * width
        height = 0.5 * height
        level_end = end
        for node in range(level_begin, level_end):
            if cells[node]["end"] - cells[node]["begin"] > LEAF_MEMBERS:
                if end + 4 > len(cells):
                    state["wanted_cells"] = end + 4
                    return -1
                held = cells[node]["end"] - cells[node]["begin"]
                used = split(balls, shapes, of_balls, reach, cells, members, node, end, free, 0.5 * width, 0.5 * height)
                # A node whose members are larger than its quarters is not worth splitting.
                if used - free > copies * held:
                    cells[node]["child"] = NO_CHILD
                elif used > len(members):
                    state["wanted_members"] = used
                    return -1
                else:
                    free = used
                    end += 4
        level_begin = level_end
    return end
