"""Rays and moving circles through a world: the first item that each one touches, found by walking a grid's cells."""

from __future__ import annotations

from math import fabs

from carom.constants import RAY_SLOP
from carom.geometry.figures import CircleGeometry
from carom.geometry.ray import ray_disc
from carom.rows.ball import BallRow
from carom.rows.kinds_in_motion import ray_shape
from carom.rows.query import CastRow, QueryRow, SearchGrid, SearchGridRow
from carom.rows.shape import ShapeRow
from carom.rows.tables import Numbered, Table
from carom.world.kernels.queries.search_grid import column_of, is_first_visit, slack_at


def cast_many(
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
    casts: Table[CastRow],
    found: Table[int],
) -> int:
    """How many of the queries hit something; `casts` gets what each one hits first, `found` which item that is.

    Items stand in two grids, `still` and `lively`. `stamps`, all 0, has a number for every row of shapes and balls.
    """
    hits = 0
    for k in range(len(queries)):
        query, cast = queries[k], casts[k]
        cast["shape"] = 0
        cast["fraction"] = 1.0
        cast["point"][0] = query["to_x"]
        cast["point"][1] = query["to_y"]
        cast["normal"][0] = 0.0
        cast["normal"][1] = 0.0
        cast_through(query, shapes, balls, (still[0], still_starts, still_members), stamps, k, cast, found)
        cast_through(query, shapes, balls, (lively[0], lively_starts, lively_members), stamps, k, cast, found)
        if cast["shape"] != 0:
            hits += 1
    return hits


def cast_through(
    query: QueryRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    search_grid: SearchGrid,
    stamps: Table[int],
    k: int,
    cast: CastRow,
    found: Table[int],
) -> None:
    """Find the first item of a grid that query `k` hits, where that is before the hit in `cast`.

    The grid is walked column by column in the direction of the way, or line by line where it goes up or down rather
    than across; in each, the cells that the way comes near enough to are looked through.
    """
    grid, starts, members = search_grid
    x, y = float(query["x"]) - float(grid["left"]), float(query["y"]) - float(grid["bottom"])
    dx, dy = float(query["to_x"]) - float(query["x"]), float(query["to_y"]) - float(query["y"])
    side = float(grid["side"])
    slack = slack_at(grid, float(query["x"]), float(query["y"])) + slack_at(
        grid, float(query["to_x"]), float(query["to_y"])
    )
    reach = float(query["radius"]) + slack
    # u is the coordinate that columns are numbered along, v the one along a column.
    u, v, du, dv = x, y, dx, dy
    columns, lines, step_u, step_v = int(grid["columns"]), int(grid["lines"]), 1, int(grid["columns"])
    if fabs(dy) > fabs(dx):
        u, v, du, dv = y, x, dy, dx
        columns, lines, step_u, step_v = lines, columns, step_v, step_u
    low, high = min(u, u + du) - reach, max(u, u + du) + reach
    if high < 0.0 or low > columns * side:
        return
    first, last = column_of(low, side, columns - 1), column_of(high, side, columns - 1)
    for turn in range(last - first + 1):
        column = last - turn if du < 0.0 else first + turn
        # The part of the way on which it is in the column; straight up or down, that is all of it.
        begin, end = 0.0, 1.0
        if du != 0.0:
            begin = (column * side - reach - u) / du
            end = ((column + 1) * side + reach - u) / du
            if du < 0.0:
                begin, end = end, begin
        # What was hit already is nearer than anything in this column and the ones behind it.
        if begin > cast["fraction"]:
            return
        begin, end = max(begin, 0.0), min(end, float(cast["fraction"]))
        low, high = min(v + begin * dv, v + end * dv) - reach, max(v + begin * dv, v + end * dv) + reach
        if high >= 0.0 and low <= lines * side:
            for line in range(column_of(low, side, lines - 1), column_of(high, side, lines - 1) + 1):
                cell = column * step_u + line * step_v
                for place in range(starts[cell], starts[cell + 1]):
                    item = int(members[place])
                    if is_first_visit(stamps, shapes, item, k):
                        if item >= 0:
                            better = cast_at_shape(query, shapes[item], dx, dy, cast)
                        else:
                            better = cast_at_ball(query, balls[-1 - item], dx, dy, cast)
                        if better:
                            found[k] = item


def cast_at_ball(query: QueryRow, ball: BallRow, dx: float, dy: float, cast: CastRow) -> bool:
    """True if a query touches a ball before what is in `cast`, which is that touch now."""
    x, y, radius = float(query["x"]), float(query["y"]), float(query["radius"])
    cx, cy, r = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # Most balls are far from the line; what is done here for them is most of the work.
    offset, reach = (x - cx) * dy - (y - cy) * dx, r + radius
    if offset * offset > reach * reach * (dx * dx + dy * dy) or not is_seen(ball, query):
        return False
    touch = ray_disc(CircleGeometry(cx, cy, r, True), x, y, radius, dx, dy)
    if touch is None:
        return False
    fraction, px, py, nx, ny = touch
    return write_touch(cast, int(ball["id"]), fraction, px, py, nx, ny)


def cast_at_shape(query: QueryRow, shape: ShapeRow, dx: float, dy: float, cast: CastRow) -> bool:
    """True if a query touches a shape that is no ball before what is in `cast`, which is that touch now."""
    x, y, radius = float(query["x"]), float(query["y"]), float(query["radius"])
    if is_beside(shape, x, y, radius, dx, dy, float(cast["fraction"])) or not is_seen(shape, query):
        return False
    touch = ray_shape(shape, x, y, radius, dx, dy)
    if touch is None:
        return False
    fraction, px, py, nx, ny = touch
    return write_touch(cast, int(shape["id"]), fraction, px, py, nx, ny)


def write_touch(cast: CastRow, member_id: int, fraction: float, px: float, py: float, nx: float, ny: float) -> bool:
    """True if a touch comes before the one in `cast`, or at the same place with a smaller id, and is written there."""
    # Ids decide ties, so the answer does not depend on the grid.
    later = fraction > cast["fraction"] or (fraction == cast["fraction"] and member_id > cast["shape"])
    if later and cast["shape"] != 0:
        return False
    cast["shape"] = member_id
    cast["fraction"] = fraction
    cast["point"][0] = px
    cast["point"][1] = py
    cast["normal"][0] = nx
    cast["normal"][1] = ny
    return True


def is_seen(row: Numbered, query: QueryRow) -> bool:
    """True if a query sees a row: it can collide, is no sensor unless those are asked for, and the masks agree."""
    if row["can_collide"] == 0 or (row["sensor"] != 0 and query["sensors"] == 0):
        return False
    return bool(row["layer"] & query["collides_with"]) and bool(query["layer"] & row["collides_with"])


def is_beside(shape: ShapeRow, x: float, y: float, radius: float, dx: float, dy: float, fraction: float) -> bool:
    """True if the box of a shape does not even touch that of a circle on its way up to a fraction of it."""
    to_x, to_y = x + dx * fraction, y + dy * fraction
    # The rounding of these must not decide between two shapes at the same place.
    reach = radius + RAY_SLOP * (fabs(x) + fabs(y) + fabs(dx) + fabs(dy) + radius)
    return bool(
        max(x, to_x) + reach < shape["left"]
        or min(x, to_x) - reach > shape["right"]
        or max(y, to_y) + reach < shape["bottom"]
        or min(y, to_y) - reach > shape["top"]
    )
