"""Which function answers which question for which kind of shape: what the kinds are, and how a ball touches one.

This module, `kinds_near`, `kinds_in_motion` and `pose` are the only ones that take a shape's kind apart; all others ask
them. A function here ends with its last kind and then a miss, which is what a row of a kind that it does not know gets:
nothing touches such a shape.
"""

from __future__ import annotations

from math import inf

from carom.geometry.arc import in_sector
from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry
from carom.geometry.gap import depth_on_entry_arc, depth_on_entry_segment, gap_circle, gap_segment
from carom.geometry.overlap import overlap_arc, overlap_circle, overlap_gate, overlap_point, overlap_segment
from carom.geometry.reach import in_wide_sector
from carom.geometry.vector import dot, length
from carom.rows.shape import ARC, CIRCLE, GATE, POINT, SEGMENT, ShapeRow


def is_straight(kind: int) -> bool:
    """True if shapes of a kind are straight lines, with ends and a tangent."""
    return kind == SEGMENT or kind == GATE


def is_round(kind: int) -> bool:
    """True if all places of a shape of a kind are equally far from its (cx, cy): no distance at all, for a point."""
    return kind == POINT or kind == CIRCLE or kind == ARC


def has_ends(kind: int) -> bool:
    """True if shapes of a kind have bare ends, past which a ball may come onto them and then passes them."""
    return kind == SEGMENT or kind == GATE or kind == ARC


def has_side(kind: int) -> bool:
    """True if shapes of a kind have a side that a way can cross; a point has none."""
    return kind == SEGMENT or kind == GATE or kind == CIRCLE or kind == ARC


def segment_of(shape: ShapeRow) -> SegmentGeometry:
    """The geometry of a segment or gate."""
    ax, ay, tx, ty = float(shape["ax"]), float(shape["ay"]), float(shape["tx"]), float(shape["ty"])
    return SegmentGeometry(ax, ay, tx, ty, float(shape["length"]))


def circle_of(shape: ShapeRow) -> CircleGeometry:
    """The geometry of a circle."""
    return CircleGeometry(float(shape["cx"]), float(shape["cy"]), float(shape["radius"]), bool(shape["solid"] != 0))


def arc_of(shape: ShapeRow) -> ArcGeometry:
    """The geometry of an arc."""
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    return ArcGeometry(cx, cy, r, float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"]))


def lets_pass(shape: ShapeRow, x: float, y: float) -> bool:
    """True for a gate if (x, y) is on the side from which it lets balls pass; its own line counts as that."""
    if shape["kind"] != GATE:
        return False
    tx, ty = float(shape["tx"]), float(shape["ty"])
    side = tx * (y - float(shape["ay"])) - ty * (x - float(shape["ax"]))
    through = tx * float(shape["dy"]) - ty * float(shape["dx"])
    return side <= 0.0 if through > 0.0 else side >= 0.0


def find_contact(
    shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """Point, unit normal and setback `(px, py, nx, ny, setback)` of a ball that overlaps the shape; a miss is None.

    `x, y, radius` are the ball's, `wx, wy` its velocity relative to the shape's surface, which matters only where
    centres coincide. The normal points from the shape to the ball. A gate is a plain segment here; whether it lets
    the ball by is for the caller to ask (`lets_pass`). Masks and switches are the caller's as well.
    """
    kind = shape["kind"]
    if kind == POINT:
        return overlap_point(float(shape["cx"]), float(shape["cy"]), x, y, radius, wx, wy)
    if kind == CIRCLE:
        return overlap_circle(circle_of(shape), x, y, radius, wx, wy)
    if is_straight(kind):
        return overlap_segment(segment_of(shape), x, y, radius, wx, wy)
    if kind == ARC:
        return overlap_arc(arc_of(shape), x, y, radius, wx, wy)
    return None


def detect_contact(
    shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """What `find_contact` returns, but None for a gate that would not stop the ball; nobody knows its past here."""
    if shape["kind"] != GATE:
        return find_contact(shape, x, y, radius, wx, wy)
    return overlap_gate(segment_of(shape), float(shape["dx"]), float(shape["dy"]), x, y, radius, wx, wy)


def gap_at_rest(
    shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float, slop: float
) -> tuple[float, float, float] | None:
    """The gap between a ball and a shape and the unit normal from the shape, as (gap, nx, ny); negative if it overlaps.

    None beyond the shape's ends by more than `slop`. (wx, wy), the ball's velocity relative to the shape, decides the
    normal where the centre lies on the shape.
    """
    kind = shape["kind"]
    if is_round(kind):
        cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
        if kind == ARC:
            ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
            if not in_wide_sector(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy, slop * r):
                return None
        # One call for three kinds is compiled into this function; three of them are not, and cost the step 2 %.
        solid = kind == POINT or (kind == CIRCLE and shape["solid"] != 0)
        return gap_circle(CircleGeometry(cx, cy, r, solid), x, y, radius, wx, wy)
    if is_straight(kind):
        return gap_segment(segment_of(shape), x, y, radius, wx, wy, slop)
    return None


def bend_center(shape: ShapeRow) -> tuple[float, float] | None:
    """The place about which a shape is bent, and a ball turns that slides along it; None for a straight one."""
    if is_round(shape["kind"]):
        return float(shape["cx"]), float(shape["cy"])
    return None


def lacks_room(shape: ShapeRow, x: float, y: float, radius: float) -> bool:
    """True if a ball with its centre at (x, y) is in a ring, or an arc, that is smaller than the ball."""
    r = float(shape["radius"])
    if r >= radius or not (shape["kind"] == ARC or (shape["kind"] == CIRCLE and shape["solid"] == 0)):
        return False
    return length(x - float(shape["cx"]), y - float(shape["cy"])) <= r


def in_reach(shape: ShapeRow, x: float, y: float) -> bool:
    """True if (x, y) is in the slab of a segment or the sector of an arc; kinds without ends have neither."""
    kind = shape["kind"]
    ax, ay = float(shape["ax"]), float(shape["ay"])
    if is_straight(kind):
        along = dot(x - ax, y - ay, float(shape["tx"]), float(shape["ty"]))
        return 0.0 <= along <= float(shape["length"])
    if kind == ARC:
        cx, cy = float(shape["cx"]), float(shape["cy"])
        return in_sector(ax - cx, ay - cy, float(shape["bx"]) - cx, float(shape["by"]) - cy, x - cx, y - cy)
    return False


def depth_on_entry(shape: ShapeRow, radius: float, from_x: float, from_y: float, to_x: float, to_y: float) -> float:
    """How deep a ball overlapped a segment's line or an arc's circle while its centre came into the slab or sector.

    `from` is outside of that, `to` in it, and the way straight; the lesser of the depths at its beginning and where it
    crosses the edge. Below 0 where the ball was clear of the shape: it met it on this very way. -inf for kinds without
    ends, of which every ball is clear that does not touch them.
    """
    kind = shape["kind"]
    if is_straight(kind):
        return depth_on_entry_segment(segment_of(shape), radius, from_x, from_y, to_x, to_y)
    if kind == ARC:
        return depth_on_entry_arc(arc_of(shape), radius, from_x, from_y, to_x, to_y)
    return -inf
