"""Which function answers which question for which kind of shape: what is near to a shape, and what lies in a box."""

from __future__ import annotations

from math import fabs, inf

from carom.geometry.aabb import box_contains
from carom.geometry.arc import closest_on_arc, in_sector
from carom.geometry.boxes import box_meets_arc, box_meets_circle, box_meets_segment
from carom.geometry.circle import closest_on_disc
from carom.geometry.line import closest_on_segment, distance_to_segment
from carom.geometry.ray import crosses_arc, crosses_circle, crosses_segment
from carom.geometry.vector import cross, length
from carom.rows.kinds import arc_of, circle_of, is_straight, segment_of
from carom.rows.shape import ARC, CIRCLE, POINT, ShapeRow


def distance_to_shape(shape: ShapeRow, x: float, y: float) -> float:
    """The distance from (x, y) to the nearest place of the shape, its ends included; 0 inside a solid circle.

    Not that to the closest point, whose rounding would drown a small distance. Infinite for an unknown kind.
    """
    kind = shape["kind"]
    if kind == POINT:
        return length(x - float(shape["cx"]), y - float(shape["cy"]))
    ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
    if is_straight(kind):
        return distance_to_segment(ax, ay, bx, by, x, y)
    # The distance from a circle and an arc is written out: as functions of their own they cost the step 3 %.
    if kind == CIRCLE or kind == ARC:
        cx, cy, radius = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
        outside = length(x - cx, y - cy) - radius
        if kind == CIRCLE:
            return max(outside, 0.0) if shape["solid"] != 0 else fabs(outside)
        if in_sector(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy):
            return fabs(outside)
        return min(length(x - ax, y - ay), length(x - bx, y - by))
    return inf


def closest_on_shape(shape: ShapeRow, x: float, y: float) -> tuple[float, float, bool]:
    """The point of a shape nearest to (x, y), and whether that is inside of it; infinitely far for an unknown kind."""
    kind = shape["kind"]
    if kind == POINT:
        return float(shape["cx"]), float(shape["cy"]), False
    if kind == CIRCLE:
        cx, cy, radius, solid = circle_of(shape)
        px, py, inside = closest_on_disc(cx, cy, radius, x, y)
        return px, py, inside and solid
    if is_straight(kind):
        ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
        px, py = closest_on_segment(ax, ay, bx, by, x, y)
        return px, py, False
    if kind == ARC:
        px, py = closest_on_arc(arc_of(shape), x, y)
        return px, py, False
    return inf, inf, False


def box_meets_shape(shape: ShapeRow, left: float, bottom: float, right: float, top: float) -> bool:
    """True if a shape has a point in common with a box; a shape of an unknown kind has none."""
    kind = shape["kind"]
    if kind == POINT:
        return box_contains(left, bottom, right, top, float(shape["cx"]), float(shape["cy"]))
    if kind == CIRCLE:
        return box_meets_circle(left, bottom, right, top, circle_of(shape))
    if is_straight(kind):
        ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
        return box_meets_segment(left, bottom, right, top, ax, ay, bx, by)
    if kind == ARC:
        return box_meets_arc(left, bottom, right, top, arc_of(shape))
    return False


def height_over(shape: ShapeRow, x: float, y: float, qx: float, qy: float) -> float:
    """How far a place q stands out of a shape's line or circle, on the side on which a ball at (x, y) is.

    Infinitely far for a point and for an unknown kind, which have no sides.
    """
    kind = shape["kind"]
    if is_straight(kind):
        ax, ay, tx, ty = float(shape["ax"]), float(shape["ay"]), float(shape["tx"]), float(shape["ty"])
        over = cross(tx, ty, qx - ax, qy - ay)
        return over if cross(tx, ty, x - ax, y - ay) >= 0.0 else -over
    if kind == CIRCLE or kind == ARC:
        cx, cy, radius = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
        outside = length(qx - cx, qy - cy) - radius
        within = length(x - cx, y - cy) < radius and not (kind == CIRCLE and shape["solid"] != 0)
        return -outside if within else outside
    return inf


def crosses_side(shape: ShapeRow, x: float, y: float, dx: float, dy: float, slop: float) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses a segment, gate, arc or perimeter, or comes into a solid circle.

    What begins on a shape does not cross it. The ends reach `slop` far. A point has no side.
    """
    kind = shape["kind"]
    if kind == CIRCLE:
        return crosses_circle(circle_of(shape), x, y, dx, dy)
    if is_straight(kind):
        return crosses_segment(segment_of(shape), x, y, dx, dy, slop)
    if kind == ARC:
        return crosses_arc(arc_of(shape), x, y, dx, dy, slop)
    return False
