"""Infinite lines, as a point and a direction vector, and the nearest points of lines and segments."""

from __future__ import annotations

from math import fabs

from carom.constants import FARTHEST_CROSSING
from carom.geometry.vector import cross, dot, length, unit


def closest_on_line(px: float, py: float, dx: float, dy: float, x: float, y: float) -> tuple[float, float]:
    """The point nearest to (x, y) on the line through p along d, which may have any length; p itself for a zero d."""
    direction = unit(dx, dy)
    if direction is None:
        return px, py
    ux, uy = direction
    along = dot(x - px, y - py, ux, uy)
    return px + along * ux, py + along * uy


def intersect_lines(
    px: float, py: float, dx: float, dy: float, qx: float, qy: float, ex: float, ey: float
) -> tuple[float, float] | None:
    """The point where the line through p along d meets the line through q along e; None where they are parallel.

    d and e may have any length. Lines so nearly parallel that they would meet 1e300 times their points' distance
    away are taken as parallel, and so is a line whose direction is zero.
    """
    first = unit(dx, dy)
    second = unit(ex, ey)
    if first is None or second is None:
        return None
    ux, uy = first
    vx, vy = second
    sine = cross(ux, uy, vx, vy)
    offset = cross(qx - px, qy - py, vx, vy)
    if fabs(sine) * FARTHEST_CROSSING <= fabs(offset) or sine == 0.0:
        return None
    # (p + s·u - q) × v = 0 at the crossing, so s = ((q - p) × v)/(u × v).
    along = offset / sine
    return px + along * ux, py + along * uy


def closest_on_segment(ax: float, ay: float, bx: float, by: float, x: float, y: float) -> tuple[float, float]:
    """The point nearest to (x, y) on the segment from a to b, which is the very end a or b where an end is nearest."""
    direction = unit(bx - ax, by - ay)
    if direction is None:
        return ax, ay
    ux, uy = direction
    along = dot(x - ax, y - ay, ux, uy)
    # Seen from each end itself, so that an end's answer is that end to the bit, and none is lost to rounding.
    if along <= 0.0:
        return ax, ay
    if dot(x - bx, y - by, ux, uy) >= 0.0:
        return bx, by
    return ax + along * ux, ay + along * uy


def distance_to_segment(ax: float, ay: float, bx: float, by: float, x: float, y: float) -> float:
    """The distance from (x, y) to the segment from a to b; to a where the ends are equal."""
    direction = unit(bx - ax, by - ay)
    if direction is None:
        return length(x - ax, y - ay)
    ux, uy = direction
    if dot(x - ax, y - ay, ux, uy) <= 0.0:
        return length(x - ax, y - ay)
    if dot(x - bx, y - by, ux, uy) >= 0.0:
        return length(x - bx, y - by)
    # Not the distance to the closest point, whose rounding would drown a small distance.
    return fabs(cross(ux, uy, x - ax, y - ay))
