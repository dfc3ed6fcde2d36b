"""Whether a ball that a moving shape pushes has room to go."""

from __future__ import annotations

from math import fabs, inf

from carom.constants import SQUEEZE_FACING, SQUEEZE_GAP
from carom.geometry.vector import cross, dot
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import lets_pass
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.shape import ShapeRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import is_any_near, kinematic_near, next_near
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.surfaces import age_of_motion, gap_to_shape, into_frame

#: What closes a ball in on its left and on its right, as it is pushed: of each side how much a way aside it takes for
#: each length of the way on (below 0: it leaves more), and how far it is away aside.
Sides = tuple[float, float, float, float]

#: Nothing on either side.
OPEN = (-inf, inf, -inf, inf)


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
    the ball, or two between which the ball cannot go on.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # The index gives the shapes that a ball touches, so it is asked where the ball would touch what is near it.
    room = SQUEEZE_GAP * radius + push
    ahead = SQUEEZE_GAP * radius + room
    sides = OPEN
    begin, end = cell_span(cells, locate(index[FIXED], cells, x + ahead * nx, y + ahead * ny))
    for k in range(begin, end):
        sides = closed_in(sides, ball, flight, shapes[members[k]], room, nx, ny)
    near, wide = kinematic_near(index, cells, x + ahead * nx, y + ahead * ny)
    while is_any_near(near, wide):
        other, near, wide = next_near(shapes, members, near, wide)
        if other != row and (other < row or not is_moving(shapes[other])):
            sides = closed_in(sides, ball, flight, shapes[other], room, nx, ny)
    left, left_gap, right, right_gap = sides
    # Going on by a length takes so much of the gaps on both sides.
    return left == inf or (left + right > 0.0 and left_gap + right_gap < room * (left + right))


def closed_in(
    sides: Sides, ball: BallRow, flight: FlightRow, shape: ShapeRow, room: float, nx: float, ny: float
) -> Sides:
    """What closes in a ball that goes along a normal, a shape with it; infinite on the left where it faces the ball.

    Of several on one side that one counts which takes most of the way aside.
    """
    left, left_gap, right, right_gap = sides
    if shape["sensor"] != 0 or not may_collide(ball, shape):
        return sides
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    age = age_of_motion(shape, flight)
    found = gap_to_shape(shape, age, x, y, radius, nx, ny)
    if found is None:
        return sides
    gap, wall_x, wall_y = found
    facing, aside = -dot(nx, ny, wall_x, wall_y), cross(nx, ny, wall_x, wall_y)
    # What is aside counts where going on surely touches it, for only that is surely found, whatever cells there are.
    if gap >= room or (facing <= SQUEEZE_FACING and gap >= 0.5 * facing * (SQUEEZE_GAP * radius + room)):
        return sides
    if is_moving(shape):
        x, y = into_frame(shape, age, x, y)
    if lets_pass(shape, x, y):
        return sides
    if facing > SQUEEZE_FACING:
        return inf, 0.0, right, right_gap
    if aside == 0.0:
        return sides
    taken, away = facing / fabs(aside), gap / fabs(aside)
    if aside > 0.0:
        return (taken, away, right, right_gap) if taken > left else sides
    return (left, left_gap, taken, away) if taken > right else sides
