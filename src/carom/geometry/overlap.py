"""Whether a ball overlaps a shape, and how: `overlap_<kind>` for each kind of shape.

The shape comes first, then the ball's centre `x, y` and `radius`, then `wx, wy`, the ball's velocity relative
to the shape's surface, which matters only where the normal has no direction of its own. Each returns `(px, py, nx, ny,
setback)`: the point of contact on the shape, the unit normal from the shape to the ball, and how far the ball has to
move along it to touch; or None where they do not overlap. Touching is no overlap. Opposites are taken as `0.0 - x`,
for people read normals, and -0 reads badly.
"""

from __future__ import annotations

from math import fabs

from carom.geometry.arc import arc_direction, in_sector
from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry
from carom.geometry.vector import cross, dot, length, unit


def overlap_point(
    qx: float, qy: float, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball with the point q; a ball whose centre is q is moved back against its velocity."""
    dx, dy = x - qx, y - qy
    distance = length(dx, dy)
    if distance >= radius:
        return None
    nx, ny = direction_or(dx, dy, wx, wy)
    return qx, qy, nx, ny, radius - distance


def overlap_segment(
    segment: SegmentGeometry, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball with a segment.

    None where the ball's centre lies past an end. The normal is perp(t) or its opposite, whichever points to the
    ball, so no digit is lost as the centre comes close to the segment; on it, the ball is moved back against its
    velocity.
    """
    ax, ay, tx, ty, extent = segment
    dx, dy = x - ax, y - ay
    along = dot(dx, dy, tx, ty)
    # A bare end stops no ball; where one should, there is a point of its own.
    if along < 0.0 or along > extent:
        return None
    side = cross(tx, ty, dx, dy)
    distance = fabs(side)
    if distance >= radius:
        return None
    nx, ny = outward_or(0.0 - ty, tx, side, wx, wy)
    return ax + along * tx, ay + along * ty, nx, ny, radius - distance


def overlap_gate(
    segment: SegmentGeometry, dx: float, dy: float, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball that knows no past with a gate, a segment that lets balls pass in the direction d.

    That of a segment, where the ball's centre is on the side that d points to and the ball approaches the gate; None
    elsewhere, and for a centre on the gate itself.
    """
    contact = overlap_segment(segment, x, y, radius, wx, wy)
    if contact is None:
        return None
    px, py, nx, ny, setback = contact
    ax, ay, tx, ty, _ = segment
    # On the line the normal is against the velocity, so it does not tell the side.
    on_line = cross(tx, ty, x - ax, y - ay) == 0.0
    if on_line or dot(nx, ny, dx, dy) <= 0.0 or dot(wx, wy, nx, ny) >= 0.0:
        return None
    return px, py, nx, ny, setback


def overlap_circle(
    circle: CircleGeometry, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball with a circle: with its disc if it is solid, else its perimeter.

    A centre at c is as if it were on the side of angle 0; in a solid circle, it is moved back against its velocity.
    """
    cx, cy, r, solid = circle
    if solid:
        return overlap_ball(cx, cy, r, x, y, radius, wx, wy)
    dx, dy = x - cx, y - cy
    ux, uy = direction_or(dx, dy, -1.0, 0.0)  # against (-1, 0) is angle 0
    return overlap_perimeter(circle, ux, uy, length(dx, dy), radius, wx, wy)


def overlap_arc(
    arc: ArcGeometry, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball with an arc.

    None where the ball's centre is outside the arc's sector. A centre at c is as if it were on the side of the
    arc's middle.
    """
    cx, cy, r, ax, ay, bx, by = arc
    dx, dy = x - cx, y - cy
    distance = length(dx, dy)
    # The cheaper test first: most balls near an arc's box are inside or outside of its circle.
    if fabs(distance - r) >= radius:
        return None
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    if not in_sector(ax, ay, bx, by, dx, dy):
        return None
    # From here on an arc is its circle; the direction differs at the centre alone, which is in every sector.
    ux, uy = arc_direction(ax, ay, bx, by, dx, dy)
    return overlap_perimeter(CircleGeometry(cx, cy, r, False), ux, uy, distance, radius, wx, wy)


def overlap_ball(
    x1: float, y1: float, r1: float, x2: float, y2: float, r2: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a second ball with a first, or with a solid circle: the normal is from the first to the second.

    The point is the first's nearest to the second's centre. `wx, wy` is the second's velocity relative to the first,
    which the second is moved back against where the centres coincide.
    """
    dx, dy = x2 - x1, y2 - y1
    distance = length(dx, dy)
    reach = r1 + r2
    # Lengths are compared, not squares: so what is told of has a setback above zero.
    if distance >= reach:
        return None
    nx, ny = direction_or(dx, dy, wx, wy)
    return x1 + r1 * nx, y1 + r1 * ny, nx, ny, reach - distance


def overlap_perimeter(
    circle: CircleGeometry, ux: float, uy: float, distance: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float, float, float] | None:
    """The overlap of a ball, `distance` away from c in the unit direction u, with the perimeter of a circle about c."""
    cx, cy, r, _ = circle
    side = distance - r
    gap = fabs(side)
    # An arc has asked this before its sector, a circle asks it here.
    if gap >= radius:
        return None
    nx, ny = outward_or(ux, uy, side, wx, wy)
    return cx + r * ux, cy + r * uy, nx, ny, radius - gap


def outward_or(ux: float, uy: float, side: float, wx: float, wy: float) -> tuple[float, float]:
    """The unit vector u turned to the side of the ball: u where `side` is positive, -u where it is negative.

    Where it is 0, the unit vector against w, and (0, 1) if w is zero.
    """
    if side > 0.0:
        return ux, uy
    if side < 0.0:
        return 0.0 - ux, 0.0 - uy
    return direction_or(0.0, 0.0, wx, wy)


def direction_or(dx: float, dy: float, wx: float, wy: float) -> tuple[float, float]:
    """The unit vector along d; where d is zero, the one against w, and (0, 1) if w is zero as well."""
    along = unit(dx, dy)
    if along is not None:
        return along
    against = unit(0.0 - wx, 0.0 - wy)
    if against is not None:
        return against
    return 0.0, 1.0
