"""The item nearest to a place, found in rings of a grid's cells around it."""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import ROUNDING
from carom.geometry.circle import closest_on_disc
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.kinds_near import closest_on_shape
from carom.rows.query import NeighborRow, QueryRow, SearchGrid, SearchGridRow
from carom.rows.shape import ShapeRow
from carom.rows.tables import Table
from carom.world.kernels.queries.casting import is_seen
from carom.world.kernels.queries.search_grid import column_of, is_first_visit, item_box, slack_at


def nearest_many(
    queries: Table[QueryRow],
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    still: Table[SearchGridRow],
    still_starts: Table[int],
    still_members: Table[int],
    lively: Table[SearchGridRow],
    lively_starts: Table[int],
    lively_members: Table[int],
    stamps: Table[int],
    neighbors: Table[NeighborRow],
) -> int:
    """How many of the queries see anything at all; `neighbors` gets the item nearest to the place of each.

    Grids and stamps are as `cast_many` takes them.
    """
    seen = 0
    for k in range(len(queries)):
        query, neighbor = queries[k], neighbors[k]
        neighbor["shape"] = 0
        neighbor["distance"] = inf
        neighbor["point"][0] = query["x"]
        neighbor["point"][1] = query["y"]
        search_rings(query, shapes, balls, (still[0], still_starts, still_members), stamps, k, neighbor)
        search_rings(query, shapes, balls, (lively[0], lively_starts, lively_members), stamps, k, neighbor)
        if neighbor["shape"] != 0:
            seen += 1
    return seen


def search_rings(
    query: QueryRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    search_grid: SearchGrid,
    stamps: Table[int],
    k: int,
    neighbor: NeighborRow,
) -> None:
    """Find the item of a grid nearest to query `k`, where it is nearer than the one in `neighbor`.

    Square rings of cells around the place's own, or the one nearest to it, until what lies outside is farther away.
    """
    grid, starts, members = search_grid
    columns, lines, side = int(grid["columns"]), int(grid["lines"]), float(grid["side"])
    x, y = float(query["x"]) - float(grid["left"]), float(query["y"]) - float(grid["bottom"])
    own_column, own_line = column_of(x, side, columns - 1), column_of(y, side, lines - 1)
    slack = slack_at(grid, float(query["x"]), float(query["y"]))
    for ring in range(max(columns, lines)):
        for line in range(max(own_line - ring, 0), min(own_line + ring, lines - 1) + 1):
            # Of the lines between the first and the last, a ring has its two ends alone.
            step = 1 if line == own_line - ring or line == own_line + ring else max(2 * ring, 1)
            for column in range(own_column - ring, own_column + ring + 1, step):
                if 0 <= column < columns:
                    cell = line * columns + column
                    for place in range(starts[cell], starts[cell + 1]):
                        item = int(members[place])
                        if is_first_visit(stamps, shapes, item, k):
                            compare_item(query, shapes, balls, item, neighbor)
        # Of cells not looked at the nearest is outside of the square so far.
        if neighbor["distance"] < distance_outside(grid, x, y, own_column, own_line, ring) - slack:
            return


def distance_outside(grid: SearchGridRow, x: float, y: float, own_column: int, own_line: int, ring: int) -> float:
    """A distance that no cell outside of a ring's square is nearer than to (x, y), which is relative to the grid."""
    columns, lines, side = int(grid["columns"]), int(grid["lines"]), float(grid["side"])
    beside = max(max(-x, x - columns * side), 0.0)
    above = max(max(-y, y - lines * side), 0.0)
    across, along = inf, inf
    if own_column - ring > 0:
        across = min(across, x - (own_column - ring) * side)
    if own_column + ring < columns - 1:
        across = min(across, (own_column + ring + 1) * side - x)
    if own_line - ring > 0:
        along = min(along, y - (own_line - ring) * side)
    if own_line + ring < lines - 1:
        along = min(along, (own_line + ring + 1) * side - y)
    return min(sqrt(across * across + above * above), sqrt(along * along + beside * beside))


def compare_item(
    query: QueryRow, shapes: Table[ShapeRow], balls: Table[BallRow], item: int, neighbor: NeighborRow
) -> None:
    """Write an item to `neighbor` if it is nearer than what is there, or as near and of a smaller id."""
    x, y = float(query["x"]), float(query["y"])
    left, bottom, right, top = item_box(shapes, balls, item)
    # How far its box is away, below 0 inside; less the rounding, which must not decide between two that are as near.
    rounding = 4.0 * ROUNDING * (fabs(left) + fabs(bottom) + fabs(right) + fabs(top) + fabs(x) + fabs(y))
    away = max(max(left - x, x - right), max(bottom - y, y - top)) - rounding
    if away > neighbor["distance"]:
        return
    if item < 0:
        ball = balls[-1 - item]
        if not is_seen(ball, query):
            return
        member_id = int(ball["id"])
        px, py, inside = closest_on_disc(float(ball["x"]), float(ball["y"]), float(ball["radius"]), x, y)
    else:
        shape = shapes[item]
        if not is_seen(shape, query):
            return
        member_id = int(shape["id"])
        px, py, inside = closest_on_shape(shape, x, y)
    distance = length(x - px, y - py)
    if inside:
        distance = 0.0 - distance
    if distance < neighbor["distance"] or (distance == neighbor["distance"] and member_id < neighbor["shape"]):
        neighbor["shape"] = member_id
        neighbor["distance"] = distance
        neighbor["point"][0] = px
        neighbor["point"][1] = py
