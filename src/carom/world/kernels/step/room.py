"""Whether a ball that is pushed has room to go: no push takes its centre across the side of a shape."""

from __future__ import annotations

from carom.constants import END_SLOP, PUSH_MARGIN, SIDE_ROOM
from carom.geometry.circle import circle_contains
from carom.geometry.vector import dot, larger, length, smaller
from carom.rows.ball import BallRow
from carom.rows.index import ShapeIndex
from carom.rows.kinds import find_contact, has_side, lets_pass
from carom.rows.kinds_near import crosses_side
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.relation import PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import LISTS, list_near
from carom.world.kernels.step.relations import find_relation

#: Cosine between the normals of two shapes at a ball: one pushes it onto the other if the angle is larger.
OPPOSITE = -0.5

#: In place of the row of the shape that pushes a ball: another ball does.
BY_BALL = -1

# What a push leads to.
FREE = 0
NEAR = 1  # too near to the side of a shape
ACROSS = 2  # across it


def barrier(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    pusher: int,
    dx: float,
    dy: float,
) -> int:
    """Whether a push by (dx, dy) takes a ball's centre ACROSS the side of a shape, too NEAR to it, or is FREE.

    `pusher` is the row of the shape that pushes, or BY_BALL. What stands still pushes a ball across what moves.
    """
    index, cells, members = shape_index
    # What moves gives way to what does not, or the two would hold a ball between them for ever.
    still = pusher != BY_BALL and not is_moving(shapes[pusher])
    found = FREE
    if length(dx, dy) * PUSH_MARGIN > float(ball["radius"]):
        # The index knows what a ball touches where it comes to, and no more.
        for row in range(state["shapes"]):
            if row != pusher and found != ACROSS:
                found = max(found, barrier_of(ball, shapes[row], row, still, relations, dx, dy))
        return found
    x, y = float(ball["x"]) + dx, float(ball["y"]) + dy
    for which in range(LISTS):
        begin, end = list_near(index, cells, which, x, y)
        for k in range(begin, end):
            row = int(members[k])
            if row != pusher and found != ACROSS:
                found = max(found, barrier_of(ball, shapes[row], row, still, relations, dx, dy))
    return found


def barrier_of(
    ball: BallRow, shape: ShapeRow, row: int, still: bool, relations: Table[RelationRow], dx: float, dy: float
) -> int:
    """The same for one shape; FREE for one that does not hold the ball."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # The box first: most of a cell's shapes are not near the push at all.
    room = SIDE_ROOM * radius
    if (
        smaller(x, x + dx) - room > shape["right"]
        or larger(x, x + dx) + room < shape["left"]
        or smaller(y, y + dy) - room > shape["top"]
        or larger(y, y + dy) + room < shape["bottom"]
    ):
        return FREE
    if not holds_back(ball, shape, still) or find_relation(relations, ball, PASSING, row):
        return FREE
    if not has_side(shape["kind"]) or lets_pass(shape, x, y):
        return FREE
    if crosses_side(shape, x, y, dx, dy, END_SLOP * radius):
        return ACROSS
    # A ball whose centre is inside a solid circle is on its way out; nearness is no reason to keep it.
    if shape["solid"] != 0 and circle_contains(float(shape["cx"]), float(shape["cy"]), float(shape["radius"]), x, y):
        return FREE
    return NEAR if comes_near(shape, x, y, dx, dy, room) else FREE


def comes_near(shape: ShapeRow, x: float, y: float, dx: float, dy: float, room: float) -> bool:
    """True if the way from (x, y) by (dx, dy) ends nearer to a shape than it began, and with less than `room` left."""
    after = find_contact(shape, x + dx, y + dy, room, dx, dy)
    if after is None:
        return False
    before = find_contact(shape, x, y, room, dx, dy)
    # It was clear by more than the room and is nearer now.
    if before is None:
        return True
    _px, _py, _nx, _ny, depth = after
    _px, _py, _nx, _ny, depth_before = before
    return depth > depth_before


def holds_back(ball: BallRow, shape: ShapeRow, still: bool) -> bool:
    """True if a shape is in the way of a ball at all; one that moves is not in the way of a push by one that stands."""
    if shape["sensor"] != 0 or ball["sensor"] != 0 or (still and is_moving(shape)):
        return False
    return may_collide(ball, shape)


def pressed_depth(
    ball: BallRow,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    pusher: int,
    nx: float,
    ny: float,
    setback: float,
) -> float:
    """How deep a push by `setback` along (nx, ny) presses a ball onto a shape at rest that opposes it; 0 for none."""
    index, cells, members = shape_index
    x, y, radius = float(ball["x"]) + setback * nx, float(ball["y"]) + setback * ny, float(ball["radius"])
    deepest = 0.0
    for which in range(LISTS):
        begin, end = list_near(index, cells, which, x, y)
        for k in range(begin, end):
            row = int(members[k])
            shape = shapes[row]
            if row == pusher or not holds_back(ball, shape, True):
                continue
            contact = find_contact(shape, x, y, radius, nx, ny)
            if contact is None or find_relation(relations, ball, PASSING, row):
                continue
            _px, _py, mx, my, depth = contact
            if dot(nx, ny, mx, my) < OPPOSITE and not lets_pass(shape, x, y):
                deepest = larger(deepest, depth)
    return deepest
