"""Changing the index of the static shapes where shapes have come, gone or moved, instead of making it anew.

What comes of it has the same members in the same cells in the same order as an index that is made anew; for flights,
maybe in cells that are laid a little otherwise.
"""

from __future__ import annotations

from math import inf

from carom.rows.index import CellRow, IndexRow
from carom.rows.shape import ShapeRow
from carom.rows.state import CONTINUOUS, GRID, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import (
    FIXED,
    QUARTERS,
    cell_side,
    cells_around,
    clear_towards,
    comes_near,
    find_free,
    index_box,
    mark_parts,
    reach_of_cell,
    set_clear,
)


def patch_index(
    state: StateRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
) -> bool:
    """True if the index of the static shapes is right again; False where it has to be made anew.

    Behind all shapes, and a place for each kinematic one, `order` names the `state["taken"]` shapes that are to be
    taken out, then as many rows with the geometries by which they were put in, then the `state["put"]` shapes that are
    to be put in.
    """
    first = 2 * int(state["shapes"]) - int(state["fixed"])
    geometries = first + int(state["taken"])
    begin = geometries + int(state["taken"])
    end = begin + int(state["put"])
    entry = index[FIXED]
    if not is_laid_alike(state, shapes, order, entry, geometries, end):
        return False
    for k in range(state["taken"]):
        take_out(shapes, shapes[order[geometries + k]], order[first + k], entry, cells, members)
    find_free(shapes, order, entry, int(state["dropped"]), int(state["fixed"]))
    more = 0
    for k in range(begin, end):
        more += announce(shapes[order[k]], entry, cells)
    if more == 0:
        return True
    if entry["members_end"] + more > len(members):
        return False
    for k in range(begin, end):
        put_in(shapes, order[k], entry, cells, members)
    return True


def is_laid_alike(
    state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow, begin: int, end: int
) -> bool:
    """True if a grid that is made anew has the cells of the one there is, or these do as well.

    `order[begin:end]` are the geometries of what is taken out and of what is put in. In discrete mode the boxes that
    are tested count, so the cells must be the very same. Flights find the same in any cells: where the outermost goes
    these stay, as long as they are of about the right size.
    """
    left, bottom = float(entry["left"]), float(entry["bottom"])
    right, top, reach = float(entry["right"]), float(entry["top"]), float(entry["reach"])
    if state["broad_phase"] != GRID or entry["cells_end"] == entry["cells_begin"] or entry["side"] == inf:
        return False
    count = int(state["fixed"] - state["dropped"])
    if count == 0:
        return False
    side, wanted = float(entry["side"]), cell_side(state, right - left, top - bottom, count, reach)
    flights = state["detection"] == CONTINUOUS
    if not (0.5 * side <= wanted <= 2.0 * side if flights else wanted == side):
        return False
    inside = True
    for k in range(begin + int(state["taken"]) if flights else begin, end):
        shape = shapes[order[k]]
        inside = (
            inside
            and float(shape["left"]) - reach > left
            and float(shape["bottom"]) - reach > bottom
            and float(shape["right"]) + reach < right
            and float(shape["top"]) + reach < top
        )
    # What is outermost, others may be as well: bricks in a row. All shapes are asked, which is quicker than a new grid.
    return inside or (left, bottom, right, top) == index_box(
        shapes, order, int(state["dropped"]), int(state["fixed"]), reach
    )


def take_out(
    shapes: Table[ShapeRow],
    geometry: ShapeRow,
    row: int,
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
) -> None:
    """Take the shape in `row` out of the cells that it was put into by a geometry."""
    near = reach_of_cell(entry)
    first_column, last_column, first_line, last_line = cells_around(geometry, entry)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            if comes_near(geometry, entry, column, line, near):
                cell = cells[int(entry["cells_begin"]) + line * int(entry["columns"]) + column]
                kept = int(cell["begin"])
                cell["marks"] = 0
                for k in range(cell["begin"], cell["end"]):
                    if members[k] != row:
                        members[kept] = members[k]
                        mark_parts(cell, shapes[members[k]], entry, column, line)
                        kept += 1
                cell["end"] = kept


def announce(shape: ShapeRow, entry: IndexRow, cells: Table[CellRow]) -> int:
    """The room that the cells need which a shape is to be put into, each of which is told.

    A cell that is told first needs as much as it has members, for all of them move.
    """
    near = reach_of_cell(entry)
    first_column, last_column, first_line, last_line = cells_around(shape, entry)
    room = 0
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            if comes_near(shape, entry, column, line, near):
                cell = cells[int(entry["cells_begin"]) + line * int(entry["columns"]) + column]
                room += 1 if cell["depth"] > 0 else int(cell["end"] - cell["begin"]) + 1
                cell["depth"] += 1
    return room


def move_members(entry: IndexRow, cell: CellRow, members: Table[int]) -> None:
    """Move a cell's members behind all others, where there is room for those that it was told of.

    To make room where they are, the members of all cells behind it would have to move. What is left behind is of no
    use until the index is made anew.
    """
    begin = int(entry["members_end"])
    end = begin
    for k in range(cell["begin"], cell["end"]):
        members[end] = members[k]
        end += 1
    entry["members_end"] = end + int(cell["depth"])
    cell["begin"] = begin
    cell["end"] = end
    cell["depth"] = 0


def put_in(
    shapes: Table[ShapeRow], row: int, entry: IndexRow, cells: Table[CellRow], members: Table[int]
) -> None:  # fmt: skip
    """Put a shape into its cells, each of which has room, at its place in the order in which shapes are met."""
    shape = shapes[row]
    near = reach_of_cell(entry)
    first_column, last_column, first_line, last_line = cells_around(shape, entry)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            if comes_near(shape, entry, column, line, near):
                cell = cells[int(entry["cells_begin"]) + line * int(entry["columns"]) + column]
                if cell["depth"] > 0:
                    move_members(entry, cell, members)
                begin, k = int(cell["begin"]), int(cell["end"])
                while k > begin and is_met_later(shapes, int(members[k - 1]), row):
                    members[k] = members[k - 1]
                    k -= 1
                members[k] = row
                mark_parts(cell, shape, entry, column, line)
                cell["end"] += 1
                entry["longest"] = max(entry["longest"], cell["end"] - begin)
                if entry["measured"] != 0:
                    lower_clear(entry, cells, column, line)


def lower_clear(entry: IndexRow, cells: Table[CellRow], column: int, line: int) -> None:
    """Let the cells around one that has members know how near it is, in each quarter as seen from them.

    Where members have gone cells say less than they could, which costs time alone.
    """
    for quarter in range(QUARTERS):
        right, up = 1 - 2 * (quarter % 2), 1 - 2 * (quarter // 2)
        away, lowered = 0, True
        # Ring by ring, up to one whose cells are all as near to others.
        while lowered:
            lowered = lower_to(entry, cells, column - right * away, line - up * away, quarter, away)
            for k in range(away):
                lowered = lower_to(entry, cells, column - right * away, line - up * k, quarter, away) or lowered
                lowered = lower_to(entry, cells, column - right * k, line - up * away, quarter, away) or lowered
            away += 1


def lower_to(entry: IndexRow, cells: Table[CellRow], column: int, line: int, quarter: int, away: int) -> bool:
    """True if there is such a cell, whose square was wider; now it is so many cells wide."""
    if not (0 <= column < entry["columns"] and 0 <= line < entry["lines"]):
        return False
    cell = cells[int(entry["cells_begin"]) + line * int(entry["columns"]) + column]
    if clear_towards(cell, quarter) <= away:
        return False
    set_clear(cell, quarter, away)
    return True


def is_met_later(shapes: Table[ShapeRow], row: int, other: int) -> bool:
    """True if a ball meets the static shape in `row` after that in `other`."""
    kind, other_kind = shapes[row]["kind"], shapes[other]["kind"]
    return bool(kind > other_kind or (kind == other_kind and row > other))
