"""Whether a ball that a moving shape pushes has room to go."""

from __future__ import annotations

from carom.constants import SQUEEZE_FACING, SQUEEZE_GAP
from carom.geometry.vector import cross, dot
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import lets_pass
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, moves_with
from carom.rows.shape import ShapeRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import is_any_near, kinematic_near, next_near
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.flight import is_worn
from carom.world.kernels.continuous.surfaces import age_of_motion, gap_to_shape, into_frame

# Where a ball is stopped as it is pushed: on its left, on its right; what faces it stops it on both.
NOWHERE = 0
LEFT = 1
RIGHT = 2
BOTH = LEFT | RIGHT


def is_squeezed(
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    row: int,
    push: float,
    nx: float,
    ny: float,
) -> bool:
    """True if a ball that the kinematic shape in `row` pushes so far along a normal lacks the room, or all but.

    What is in its way stands still, or moves too and comes first in order: that has the last word. It is one that faces
    the ball, or one on either side. What moves with the shape that pushes closes no room between the two; it counts
    only where impacts between them do not end.
    """
    worn = is_worn(flight)
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # The index gives the shapes that a ball touches, so it is asked where the ball would touch what is near it.
    room = SQUEEZE_GAP * radius + push
    ahead = SQUEEZE_GAP * radius + room
    stopped = NOWHERE
    begin, end = cell_span(cells, locate(index[FIXED], cells, x + ahead * nx, y + ahead * ny))
    for k in range(begin, end):
        stopped |= where_stopped(ball, flight, shapes[members[k]], room, nx, ny)
    near, wide = kinematic_near(index, cells, x + ahead * nx, y + ahead * ny)
    while is_any_near(near, wide):
        other, near, wide = next_near(shapes, members, near, wide)
        as_one = moves_with(shapes[other], shapes[row])
        has_last_word = worn if as_one else other < row or not is_moving(shapes[other])
        if other != row and has_last_word:
            stopped |= where_stopped(ball, flight, shapes[other], room, nx, ny)
    return stopped == BOTH


def where_stopped(ball: BallRow, flight: FlightRow, shape: ShapeRow, room: float, nx: float, ny: float) -> int:
    """Where a shape stops a ball that is pushed along a normal by some room: NOWHERE, LEFT, RIGHT or BOTH."""
    if shape["sensor"] != 0 or not may_collide(ball, shape):
        return NOWHERE
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    age = age_of_motion(shape, flight)
    found = gap_to_shape(shape, age, x, y, radius, nx, ny)
    if found is None:
        return NOWHERE
    gap, wall_x, wall_y = found
    facing = -dot(nx, ny, wall_x, wall_y)
    # What is aside stops it where it would touch that on its way.
    if facing <= 0.0 or gap >= (room if facing > SQUEEZE_FACING else room * facing):
        return NOWHERE
    if is_moving(shape):
        x, y = into_frame(shape, age, x, y)
    if lets_pass(shape, x, y):
        return NOWHERE
    if facing > SQUEEZE_FACING:
        return BOTH
    return LEFT if cross(nx, ny, wall_x, wall_y) > 0.0 else RIGHT
