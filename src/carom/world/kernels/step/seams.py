"""Points at the seams of walls: a ball beside a wall is not turned by a point on it or behind it (discrete)."""

from __future__ import annotations

from carom.constants import END_SLOP, SEAM_REACH, SEPARATION_SLACK
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.index import ShapeIndex
from carom.rows.kinds import gap_at_rest, has_side
from carom.rows.kinds_near import height_over
from carom.rows.masks import may_collide
from carom.rows.relation import PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Row, Table
from carom.world.kernels.broad_phase.regions import LISTS, list_near
from carom.world.kernels.step.narrow import Touch, Way, overlap_with, starts_passing
from carom.world.kernels.step.relations import find_relation


def overlap_beside_walls(
    state: StateRow,
    ball: BallRow,
    shape: ShapeRow,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    moved: bool,
    way: Way,
) -> Touch | None:
    """The overlap of a ball with a shape whose box it meets, as `overlap_with` gives it, or None.

    None also with a point that yields to a wall. The rest is as in `starts_passing`.
    """
    if not has_side(shape["kind"]) and yields_to_wall(state, ball, shape, shapes, shape_index, relations, moved, way):
        return None
    return overlap_with(state, ball, shape)


def yields_to_wall(
    state: StateRow,
    ball: BallRow,
    point: Row,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    moved: bool,
    way: Way,
) -> bool:
    """True if a ball overlaps a point, but meets a wall that the point stands on or lies behind.

    A ball in the wall's slab or sector comes to no such point before it comes to the wall. An overlap that is found
    late would still turn the ball by the direction to the point. The rest is as in `starts_passing`.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    if point["sensor"] != 0 or ball["sensor"] != 0:
        return False
    if length(x - float(point["cx"]), y - float(point["cy"])) >= radius:
        return False
    index, cells, members = shape_index
    # A ball that overlaps the wall is in the wall's reach, so the wall is in the cell of the ball's centre.
    for which in range(LISTS):
        k, end = list_near(index, cells, which, x, y)
        while k < end:
            row = int(members[k])
            k += 1
            if has_side(shapes[row]["kind"]) and wall_takes_ball(ball, point, shapes[row], row, relations, moved, way):
                state["full_tests"] += 1
                return True
    return False


def wall_takes_ball(
    ball: BallRow,
    point: Row,
    wall: Row,
    row: int,
    relations: Table[RelationRow],
    moved: bool,
    way: Way,
) -> bool:
    """True if a ball beside a wall overlaps it and does not pass it, and a point is on the wall or behind it."""
    radius = float(ball["radius"])
    if wall["sensor"] != 0 or not may_collide(ball, wall):
        return False
    x, y = float(ball["x"]), float(ball["y"])
    found = gap_at_rest(wall, x, y, radius, 0.0, 0.0, END_SLOP * radius)
    if found is None:
        return False
    gap, _nx, _ny = found
    # A wall that the ball does not touch yet does not hold it; the point may.
    if gap > SEPARATION_SLACK * radius:
        return False
    if height_over(wall, x, y, float(point["cx"]), float(point["cy"])) > SEAM_REACH * radius:
        return False
    if find_relation(relations, ball, PASSING, row):
        return False
    # A wall that lets the ball by does not shield it from the point.
    return not starts_passing(wall, ball, 0.0 - gap, moved, way)
