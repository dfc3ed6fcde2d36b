"""Whether a ball overlaps a shape's row, and how: the kinds' overlaps behind one door. Numba compiles this too."""

from __future__ import annotations

from carom.geometry.overlap import overlap_arc, overlap_circle, overlap_point, overlap_segment
from carom.rows.shape import ARC, CIRCLE, POINT, ShapeRow
from carom.rows.tables import Numbered


def find_contact(
    shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """Point, unit normal and setback `(px, py, nx, ny, setback)` of a ball that overlaps the shape; a miss is None.

    `x, y, radius` are the ball's, `wx, wy` its velocity relative to the shape's surface, which matters only where
    centres coincide. The normal points from the shape to the ball. A gate is a plain segment here; whether it lets
    the ball by is for the caller to ask (`gate_opens`). Masks and switches are the caller's as well.
    """
    kind = shape["kind"]
    cx, cy = float(shape["cx"]), float(shape["cy"])
    if kind == POINT:
        return overlap_point(cx, cy, x, y, radius, wx, wy)
    if kind == CIRCLE:
        return overlap_circle(cx, cy, float(shape["radius"]), int(shape["solid"]), x, y, radius, wx, wy)
    ax, ay = float(shape["ax"]), float(shape["ay"])
    if kind == ARC:
        bx, by = float(shape["bx"]), float(shape["by"])
        return overlap_arc(cx, cy, float(shape["radius"]), ax, ay, bx, by, x, y, radius, wx, wy)
    tx, ty = float(shape["tx"]), float(shape["ty"])
    return overlap_segment(ax, ay, tx, ty, float(shape["length"]), x, y, radius, wx, wy)


def gate_opens(shape: ShapeRow, x: float, y: float) -> bool:
    """Whether (x, y) is on the side of a gate from which it lets balls pass; the gate's own line counts as that."""
    tx, ty = float(shape["tx"]), float(shape["ty"])
    side = tx * (y - float(shape["ay"])) - ty * (x - float(shape["ax"]))
    through = tx * float(shape["dy"]) - ty * float(shape["dx"])
    return side <= 0.0 if through > 0.0 else side >= 0.0


def may_meet(first: Numbered, second: Numbered) -> bool:
    """Whether two rows of shapes or balls meet at all: both can collide, each is on a layer that the other meets."""
    if not first["can_collide"] or not second["can_collide"]:
        return False
    forth = first["layer"] & second["collides_with"]
    back = second["layer"] & first["collides_with"]
    return bool(forth != 0 and back != 0)
