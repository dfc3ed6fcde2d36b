"""What lies in a box, and what overlaps what, found by looking through the cells of a grid that a box comes into."""

from __future__ import annotations

from carom.geometry.aabb import boxes_overlap
from carom.geometry.boxes import box_meets_circle
from carom.geometry.figures import CircleGeometry
from carom.rows.ball import BallRow
from carom.rows.contact import contact_of_balls, contact_with_shape
from carom.rows.kinds_near import box_meets_shape
from carom.rows.query import ContactRow, InBoxRow, QueryRow, SearchGrid, SearchGridRow
from carom.rows.shape import ShapeRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.pairs import may_touch
from carom.world.kernels.queries.casting import is_seen
from carom.world.kernels.queries.search_grid import cells_around, is_box, is_first_visit, item_box, slack_at


def overlapping_many(
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
    inside: Table[InBoxRow],
) -> int:
    """How many items there are in the boxes of all queries; `inside` gets as many of them as it has room for.

    A query's box goes from x, y to to_x, to_y. Grids and stamps are as `cast_many` takes them.
    """
    count = 0
    for k in range(len(queries)):
        query = queries[k]
        count = search_box(query, shapes, balls, (still[0], still_starts, still_members), stamps, k, inside, count)
        count = search_box(query, shapes, balls, (lively[0], lively_starts, lively_members), stamps, k, inside, count)
    return count


def search_box(
    query: QueryRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    search_grid: SearchGrid,
    stamps: Table[int],
    k: int,
    inside: Table[InBoxRow],
    count: int,
) -> int:
    """The count of items found so far after those of one grid that are in the box of query `k`."""
    grid, starts, members = search_grid
    left, bottom, right, top = float(query["x"]), float(query["y"]), float(query["to_x"]), float(query["to_y"])
    slack = slack_at(grid, left, bottom) + slack_at(grid, right, top)
    first_column, last_column, first_line, last_line = cells_around(grid, left, bottom, right, top, slack)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            cell = line * int(grid["columns"]) + column
            for place in range(starts[cell], starts[cell + 1]):
                item = int(members[place])
                if is_first_visit(stamps, shapes, item, k):
                    member_id = id_in_box(query, shapes, balls, item, left, bottom, right, top)
                    # Counted also where there is no room, so the caller knows how much to make.
                    if member_id != 0:
                        if count < len(inside):
                            inside[count]["box"] = k
                            inside[count]["shape"] = member_id
                        count += 1
    return count


def id_in_box(
    query: QueryRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    item: int,
    left: float,
    bottom: float,
    right: float,
    top: float,
) -> int:
    """The id of an item that a query sees and that has a point in common with a box, else 0."""
    if item < 0:
        ball = balls[-1 - item]
        disc = CircleGeometry(float(ball["x"]), float(ball["y"]), float(ball["radius"]), True)
        if is_seen(ball, query) and box_meets_circle(left, bottom, right, top, disc):
            return int(ball["id"])
        return 0
    shape = shapes[item]
    if is_seen(shape, query) and box_meets_shape(shape, left, bottom, right, top):
        return int(shape["id"])
    return 0


def overlaps_of_balls(
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
    contacts: Table[ContactRow],
) -> int:
    """How many overlaps of balls with shapes and balls there are; `contacts` gets as many as it has room for.

    The one query says which ones to see. Grids and stamps are as `cast_many` takes them.
    """
    query = queries[0]
    count = 0
    for i in range(len(balls)):
        left, bottom, right, top = item_box(shapes, balls, -1 - i)
        if is_seen(balls[i], query) and is_box(left, bottom, right, top):
            count = touch_all(query, shapes, balls, (still[0], still_starts, still_members), stamps, i, contacts, count)
            count = touch_all(
                query, shapes, balls, (lively[0], lively_starts, lively_members), stamps, i, contacts, count
            )
    return count


def touch_all(
    query: QueryRow,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    search_grid: SearchGrid,
    stamps: Table[int],
    i: int,
    contacts: Table[ContactRow],
    count: int,
) -> int:
    """The count of overlaps found so far after those of ball `i` with the items of one grid, later balls left out."""
    grid, starts, members = search_grid
    x, y, radius = float(balls[i]["x"]), float(balls[i]["y"]), float(balls[i]["radius"])
    slack = radius + slack_at(grid, x, y)
    first_column, last_column, first_line, last_line = cells_around(grid, x, y, x, y, slack)
    for line in range(first_line, last_line + 1):
        for column in range(first_column, last_column + 1):
            cell = line * int(grid["columns"]) + column
            for place in range(starts[cell], starts[cell + 1]):
                item = int(members[place])
                if -1 - item < i and is_first_visit(stamps, shapes, item, i):
                    if item < 0:
                        count = touch_ball(query, balls, -1 - item, i, contacts, count)
                    else:
                        count = touch_shape(query, shapes[item], balls[i], contacts, count)
    return count


def touch_ball(query: QueryRow, balls: Table[BallRow], i: int, j: int, contacts: Table[ContactRow], count: int) -> int:
    """The count of overlaps after that of ball `i` with ball `j`, which was added later, if there is one."""
    first, second = balls[i], balls[j]
    x1, y1, r1 = float(first["x"]), float(first["y"]), float(first["radius"])
    x2, y2, r2 = float(second["x"]), float(second["y"]), float(second["radius"])
    if not (may_touch(x2 - x1, y2 - y1, r1 + r2) and is_seen(first, query)):
        return count
    contact = contact_of_balls(first, second)
    if contact is None:
        return count
    px, py, nx, ny, setback, speed = contact
    return write_contact(contacts, count, int(first["id"]), int(second["id"]), px, py, nx, ny, setback, speed)


def touch_shape(query: QueryRow, shape: ShapeRow, ball: BallRow, contacts: Table[ContactRow], count: int) -> int:
    """The count of overlaps after that of a ball with a shape, if there is one; a gate's closed side alone counts."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # Boxes, then masks, then the overlap itself: from the cheapest to the dearest.
    left, bottom, right, top = float(shape["left"]), float(shape["bottom"]), float(shape["right"]), float(shape["top"])
    if not boxes_overlap(left, bottom, right, top, x - radius, y - radius, x + radius, y + radius):
        return count
    if not is_seen(shape, query):
        return count
    contact = contact_with_shape(shape, ball)
    if contact is None:
        return count
    px, py, nx, ny, setback, speed = contact
    return write_contact(contacts, count, int(shape["id"]), int(ball["id"]), px, py, nx, ny, setback, speed)


def write_contact(
    contacts: Table[ContactRow],
    count: int,
    shape_id: int,
    ball_id: int,
    px: float,
    py: float,
    nx: float,
    ny: float,
    setback: float,
    speed: float,
) -> int:
    """The count of contacts after one more, which is written where there is room for it."""
    if count < len(contacts):
        contact = contacts[count]
        contact["shape"] = shape_id
        contact["ball"] = ball_id
        contact["point"][0] = px
        contact["point"][1] = py
        contact["normal"][0] = nx
        contact["normal"][1] = ny
        contact["setback"] = setback
        contact["speed"] = speed
    return count + 1
