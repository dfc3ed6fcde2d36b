"""Arcs: the part of a circle that runs counterclockwise from the end a to the end b.

Sectors are decided by cross products of the two ends, seen from the centre; trigonometry turns angles into ends once.
"""

from __future__ import annotations

from math import fabs

from carom.constants import ROUNDING
from carom.geometry.angle import direction, sweep
from carom.geometry.figures import ArcGeometry
from carom.geometry.vector import cross, dot, length_squared, unit


def in_sector(ax: float, ay: float, bx: float, by: float, x: float, y: float) -> bool:
    """Whether the vector (x, y) lies in the sector counterclockwise from the vector a to the vector b, rays included.

    All three are relative to the arc's centre; a and b are equally long, (x, y) may have any length. A vector within
    the rounding of its direction from a ray lies on that ray, and the zero vector in every sector. Ends in the same
    direction, which rounding makes of the two ends of an arc that is all but a full circle, are a full circle.
    """
    # A cross product's rounding error is within this of the product of the two vectors' lengths.
    size = ROUNDING * (fabs(x) + fabs(y))
    after_start = cross(ax, ay, x, y) >= -size * (fabs(ax) + fabs(ay))
    before_end = cross(x, y, bx, by) >= -size * (fabs(bx) + fabs(by))
    turn = cross(ax, ay, bx, by)
    if turn <= 0.0:  # half a turn or more: outside is what lies strictly between the end and the start
        return after_start or before_end
    if not (after_start and before_end):
        return False
    # Opposite to a very narrow sector both tests may hold by rounding, but there the vector points away from it.
    return dot(ax, ay, bx, by) <= 0.0 or dot(x, y, ax + bx, ay + by) >= 0.0


def middle_direction(ax: float, ay: float, bx: float, by: float) -> tuple[float, float]:
    """The unit vector from an arc's centre to its middle; a and b are its ends relative to the centre.

    Of the two formulas, along a + b and across b - a, the one that does not cancel is taken. Opposite to a for ends in
    the same direction (a full circle), (1, 0) for an arc so small that its ends are its centre.
    """
    if dot(ax, ay, bx, by) < 0.0:
        middle = unit(by - ay, ax - bx)
    elif cross(ax, ay, bx, by) > 0.0:
        middle = unit(ax + bx, ay + by)
    else:
        middle = unit(-ax - bx, -ay - by)
    if middle is None:
        return 1.0, 0.0
    return middle


def arc_direction(ax: float, ay: float, bx: float, by: float, x: float, y: float) -> tuple[float, float]:
    """The unit vector along (x, y), relative to an arc's centre; for the centre itself, to the arc's middle."""
    direction = unit(x, y)
    if direction is None:
        return middle_direction(ax, ay, bx, by)
    return direction


def arc_length(radius: float, start_angle: float, end_angle: float) -> float:
    """The length of the arc of a circle from one normalized angle counterclockwise to another."""
    return radius * sweep(start_angle, end_angle)


def arc_ends(
    cx: float, cy: float, radius: float, start_angle: float, end_angle: float
) -> tuple[float, float, float, float]:
    """The ends (ax, ay, bx, by) of the arc about c from one angle counterclockwise to another."""
    start_x, start_y = direction(start_angle)
    end_x, end_y = direction(end_angle)
    return cx + radius * start_x, cy + radius * start_y, cx + radius * end_x, cy + radius * end_y


def arc_tangents(start_angle: float, end_angle: float) -> tuple[float, float, float, float]:
    """The unit tangents (t0x, t0y, t1x, t1y) at an arc's ends, pointing out of it: clockwise, then counterclockwise."""
    start_x, start_y = direction(start_angle)
    end_x, end_y = direction(end_angle)
    return start_y, 0.0 - start_x, 0.0 - end_y, end_x


def closest_on_arc(arc: ArcGeometry, x: float, y: float) -> tuple[float, float]:
    """The point nearest to (x, y) on an arc.

    It is an end itself where (x, y) is outside the sector (the first of two that are equally near), and the arc's
    middle for the centre, from which all points are equally far.
    """
    cx, cy, r, ax, ay, bx, by = arc
    if in_sector(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy):
        ux, uy = arc_direction(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy)
        return cx + r * ux, cy + r * uy
    if length_squared(x - bx, y - by) < length_squared(x - ax, y - ay):
        return bx, by
    return ax, ay
