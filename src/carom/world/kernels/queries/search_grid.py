"""A grid over shapes and balls for queries: each item stands in every cell that its box, or it itself, comes into.

An item is a row of `shapes`, or -1 - i for row i of `balls`. `members` holds the items cell by cell, those of cell c
from starts[c] to starts[c + 1]. A grid of one cell is a plain list. What has no finite box is in no cell.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import ROUNDING, SEARCH_CELLS_PER_ITEM, SEARCH_MARGIN, SEARCH_MARKS_PER_ITEM
from carom.rows.ball import BallRow
from carom.rows.kinds_near import distance_to_shape
from carom.rows.query import SearchGridRow
from carom.rows.shape import ShapeRow
from carom.rows.tables import Table


def item_box(shapes: Table[ShapeRow], balls: Table[BallRow], item: int) -> tuple[float, float, float, float]:
    """The box of an item."""
    if item < 0:
        ball = balls[-1 - item]
        x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
        return x - radius, y - radius, x + radius, y + radius
    shape = shapes[item]
    return float(shape["left"]), float(shape["bottom"]), float(shape["right"]), float(shape["top"])


def is_box(left: float, bottom: float, right: float, top: float) -> bool:
    """True if four sides are a finite box."""
    # Infinite sides make this infinite or NaN, and then it does not cancel.
    around = (right - left) + (top - bottom)
    return left <= right and bottom <= top and around - around == 0.0


def width_of_all(shapes: Table[ShapeRow], balls: Table[BallRow]) -> float:
    """A length that is farther than anything in a world is from anything else."""
    left, bottom, right, top = 0.0, 0.0, 0.0, 0.0
    begun = False
    for item in range(-len(balls), len(shapes)):
        low_x, low_y, high_x, high_y = item_box(shapes, balls, item)
        if is_box(low_x, low_y, high_x, high_y):
            if not begun:
                left, bottom, right, top = low_x, low_y, high_x, high_y
                begun = True
            left, bottom, right, top = min(left, low_x), min(bottom, low_y), max(right, high_x), max(top, high_y)
    return (right - left) + (top - bottom)


def build_search_grid(
    grids: Table[SearchGridRow],
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    items: Table[int],
    starts: Table[int],
    members: Table[int],
) -> int:
    """How many members the grid of some items has, after sorting them into its cells; `grids[0]` says where it lies.

    `starts` has room for 3·SEARCH_CELLS_PER_ITEM + 2 numbers an item, `members` for SEARCH_MARKS_PER_ITEM + 1.
    """
    grid = grids[0]
    lay_grid(grid, shapes, balls, items)
    cells = int(grid["columns"] * grid["lines"])
    for cell in range(cells + 1):
        starts[cell] = 0
    for k in range(len(items)):
        mark_item(grid, shapes, balls, int(items[k]), starts, members, False)
    total = 0
    for cell in range(cells + 1):
        total += int(starts[cell])
        starts[cell] = total
    # Filling each cell from its end, last item first, leaves `starts` at the cells' beginnings and keeps the order.
    for k in range(len(items) - 1, -1, -1):
        mark_item(grid, shapes, balls, int(items[k]), starts, members, True)
    return total


def lay_grid(grid: SearchGridRow, shapes: Table[ShapeRow], balls: Table[BallRow], items: Table[int]) -> None:
    """Settle where the grid lies and how wide its cells are, from the items' boxes."""
    count = 0
    left, bottom, right, top = 0.0, 0.0, 0.0, 0.0
    sides, areas = 0.0, 0.0
    for k in range(len(items)):
        low_x, low_y, high_x, high_y = item_box(shapes, balls, int(items[k]))
        if is_box(low_x, low_y, high_x, high_y):
            if count == 0:
                left, bottom, right, top = low_x, low_y, high_x, high_y
            left, bottom, right, top = min(left, low_x), min(bottom, low_y), max(right, high_x), max(top, high_y)
            sides += (high_x - low_x) + (high_y - low_y)
            areas += (high_x - low_x) * (high_y - low_y)
            count += 1
    side = cell_width(right - left, top - bottom, count, sides, areas)
    grid["left"] = left
    grid["bottom"] = bottom
    grid["side"] = side
    grid["columns"] = int((right - left) / side) + 1
    grid["lines"] = int((top - bottom) / side) + 1


def cell_width(width: float, height: float, count: int, sides: float, areas: float) -> float:
    """The width of a grid's cells: as narrow as the allowed numbers of cells and of members in all of them permit.

    A box of w by h comes into (w/s + 2)·(h/s + 2) cells of width s at most; `sides` is the sum of w + h over all boxes,
    `areas` that of w·h, so the sum over all boxes is a quadratic in 1/s.
    """
    if count == 0:
        return 1.0
    most = SEARCH_CELLS_PER_ITEM * count
    side = max(sqrt(width / most) * sqrt(height), max(width, height) / most)
    # Solved for s: areas/s² + 2·sides/s + 4·count is at most SEARCH_MARKS_PER_ITEM·count.
    spare = (SEARCH_MARKS_PER_ITEM - 4.0) * count
    side = max(side, (sides + sqrt(sides * sides + spare * areas)) / spare)
    return side if 0.0 < side < 1e300 else 1e300


def is_first_visit(stamps: Table[int], shapes: Table[ShapeRow], item: int, k: int) -> bool:
    """True if query `k` comes upon an item for the first time; an item stands in every cell that it comes into."""
    mark = item if item >= 0 else len(shapes) - 1 - item
    if stamps[mark] == k + 1:
        return False
    stamps[mark] = k + 1
    return True


def column_of(offset: float, side: float, most: int) -> int:
    """The column, of 0 to `most`, that an offset from the grid's left edge lies in or is nearest to; lines likewise."""
    return int(min(max(offset / side, 0.0), float(most)))


def cells_around(
    grid: SearchGridRow, left: float, bottom: float, right: float, top: float, slack: float
) -> tuple[int, int, int, int]:
    """The cells that a box larger by `slack` comes into: first and last column, first and last line; none beside it."""
    side = float(grid["side"])
    from_x, to_x = left - slack - float(grid["left"]), right + slack - float(grid["left"])
    from_y, to_y = bottom - slack - float(grid["bottom"]), top + slack - float(grid["bottom"])
    columns, lines = int(grid["columns"]), int(grid["lines"])
    # Clamping alone would give the border cells to what lies beside the grid.
    if to_x < 0.0 or to_y < 0.0 or from_x > columns * side or from_y > lines * side:
        return 0, -1, 0, -1
    return (
        column_of(from_x, side, columns - 1),
        column_of(to_x, side, columns - 1),
        column_of(from_y, side, lines - 1),
        column_of(to_y, side, lines - 1),
    )


def slack_at(grid: SearchGridRow, x: float, y: float) -> float:
    """How much farther a query at (x, y) looks than it has to, so that rounding never hides an item."""
    away = fabs(x - float(grid["left"])) + fabs(y - float(grid["bottom"]))
    return SEARCH_MARGIN * float(grid["side"]) + 4.0 * ROUNDING * away


def mark_item(
    grid: SearchGridRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    item: int,
    starts: Table[int],
    members: Table[int],
    write: bool,
) -> None:
    """Count an item in every cell that it comes into, or write it there."""
    left, bottom, right, top = item_box(shapes, balls, item)
    if not is_box(left, bottom, right, top):
        return
    side = float(grid["side"])
    first_column, last_column, first_line, last_line = cells_around(
        grid, left, bottom, right, top, SEARCH_MARGIN * side
    )
    corner_x, corner_y = float(grid["left"]) + 0.5 * side, float(grid["bottom"]) + 0.5 * side
    near = side * (sqrt(0.5) + 2.0 * SEARCH_MARGIN)
    # A shape's box is mostly empty where it spans several cells both ways.
    whole = item < 0 or first_column == last_column or first_line == last_line
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            x, y = corner_x + column * side, corner_y + line * side
            if whole or distance_to_shape(shapes[item], x, y) <= near:
                cell = line * int(grid["columns"]) + column
                if write:
                    starts[cell] -= 1
                    members[starts[cell]] = item
                else:
                    starts[cell] += 1
