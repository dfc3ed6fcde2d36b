"""Whether a ball that is pushed has room to go: no push takes its centre across the side of a shape."""

from __future__ import annotations

from math import sqrt

from carom.constants import END_SLOP, PUSH_MARGIN, SIDE_ROOM
from carom.geometry.circle import circle_contains
from carom.geometry.line import distance_to_segment
from carom.geometry.reach import in_wide_sector
from carom.geometry.vector import cross, dot, larger, length, smaller
from carom.rows.ball import BallRow
from carom.rows.contact import find_contact, gate_opens, may_meet
from carom.rows.index import CellRow, IndexRow
from carom.rows.relation import PASSING, RelationRow
from carom.rows.shape import ARC, CIRCLE, GATE, POINT, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import cell_span, locate
from carom.world.kernels.continuous.surfaces import is_moving
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
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    pusher: int,
    dx: float,
    dy: float,
) -> int:
    """Whether a push by (dx, dy) takes a ball's centre ACROSS the side of a shape, too NEAR to it, or is FREE.

    `pusher` is the row of the shape that pushes, or BY_BALL. What stands still pushes a ball across what moves.
    """
    still = pusher != BY_BALL and not is_moving(shapes[pusher])
    found = FREE
    if length(dx, dy) * PUSH_MARGIN > float(ball["radius"]):
        # The index knows what a ball touches where it comes to, and no more.
        for row in range(state["shapes"]):
            if row != pusher and found != ACROSS:
                found = max(found, barrier_of(ball, shapes[row], row, still, relations, dx, dy))
        return found
    x, y = float(ball["x"]) + dx, float(ball["y"]) + dy
    for which in range(2):
        begin, end = cell_span(cells, locate(state, index[which], cells, x, y))
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
    if shape["kind"] == POINT or (shape["kind"] == GATE and gate_opens(shape, x, y)):
        return FREE
    if crosses_side(shape, x, y, dx, dy, END_SLOP * radius):
        return ACROSS
    if shape["solid"] != 0 and circle_contains(float(shape["cx"]), float(shape["cy"]), float(shape["radius"]), x, y):
        return FREE
    return NEAR if comes_near(shape, x, y, dx, dy, room) else FREE


def comes_near(shape: ShapeRow, x: float, y: float, dx: float, dy: float, room: float) -> bool:
    """True if the way from (x, y) by (dx, dy) ends nearer to a shape than it began, and with less than `room` left."""
    after = find_contact(shape, x + dx, y + dy, room, dx, dy)
    if after is None:
        return False
    before = find_contact(shape, x, y, room, dx, dy)
    if before is None:
        return True
    _px, _py, _nx, _ny, depth = after
    _px, _py, _nx, _ny, depth_before = before
    return depth > depth_before


def holds_back(ball: BallRow, shape: ShapeRow, still: bool) -> bool:
    """True if a shape is in the way of a ball at all; one that moves is not in the way of a push by one that stands."""
    if shape["sensor"] != 0 or ball["sensor"] != 0 or (still and is_moving(shape)):
        return False
    return may_meet(ball, shape)


def crosses_side(shape: ShapeRow, x: float, y: float, dx: float, dy: float, slop: float) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses a segment, gate, arc or perimeter, or comes into a solid circle.

    What begins on a shape does not cross it. The ends reach `slop` far.
    """
    kind = shape["kind"]
    if kind == CIRCLE:
        return crosses_circle(shape, x, y, dx, dy)
    if kind == ARC:
        return crosses_arc(shape, x, y, dx, dy, slop)
    ax, ay, tx, ty = float(shape["ax"]), float(shape["ay"]), float(shape["tx"]), float(shape["ty"])
    before, after = cross(tx, ty, x - ax, y - ay), cross(tx, ty, x + dx - ax, y + dy - ay)
    if before == 0.0 or (before > 0.0 and after > 0.0) or (before < 0.0 and after < 0.0):
        return False
    share = before / (before - after)
    along = dot(x + share * dx - ax, y + share * dy - ay, tx, ty)
    return bool(-slop <= along <= float(shape["length"]) + slop)


def crosses_circle(shape: ShapeRow, x: float, y: float, dx: float, dy: float) -> bool:
    """True if the way from (x, y) by (dx, dy) comes into a circle, or leaves one that is not solid."""
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    away = length(x - cx, y - cy)
    if away < r:
        return bool(shape["solid"] == 0 and length(x + dx - cx, y + dy - cy) >= r)
    return away > r and distance_to_segment(x, y, x + dx, y + dy, cx, cy) < r


def crosses_arc(shape: ShapeRow, x: float, y: float, dx: float, dy: float, slop: float) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses an arc: its circle, within the sector."""
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    ax, ay, bx, by = float(shape["ax"]) - cx, float(shape["ay"]) - cy, float(shape["bx"]) - cx, float(shape["by"]) - cy
    x, y = x - cx, y - cy
    away = length(x, y)
    squared, along = dx * dx + dy * dy, dot(x, y, dx, dy)
    within = along * along - squared * (away - r) * (away + r)
    if away == r or squared == 0.0 or within < 0.0:
        return False
    root = sqrt(within)
    for share in ((-along - root) / squared, (-along + root) / squared):
        if 0.0 < share <= 1.0 and in_wide_sector(ax, ay, bx, by, x + share * dx, y + share * dy, slop * r):
            return True
    return False


def pressed_depth(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    pusher: int,
    nx: float,
    ny: float,
    setback: float,
) -> float:
    """How deep a push by `setback` along (nx, ny) presses a ball onto a shape at rest that opposes it; 0 for none."""
    x, y, radius = float(ball["x"]) + setback * nx, float(ball["y"]) + setback * ny, float(ball["radius"])
    deepest = 0.0
    for which in range(2):
        begin, end = cell_span(cells, locate(state, index[which], cells, x, y))
        for k in range(begin, end):
            row = int(members[k])
            shape = shapes[row]
            if row == pusher or not holds_back(ball, shape, True):
                continue
            contact = find_contact(shape, x, y, radius, nx, ny)
            if contact is None or find_relation(relations, ball, PASSING, row):
                continue
            _px, _py, mx, my, depth = contact
            if dot(nx, ny, mx, my) < OPPOSITE and (shape["kind"] != GATE or not gate_opens(shape, x, y)):
                deepest = larger(deepest, depth)
    return deepest
