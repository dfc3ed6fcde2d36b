"""The gap between a ball and a shape, and the normal there: `gap_<kind>`.

The shape comes first, then the ball's centre `x, y`, its `radius`, and `wx, wy`, its velocity relative to the shape,
which decides the normal where the centre lies on the shape. Each returns `(gap, nx, ny)`: how far the ball is from the
shape, negative where they overlap, and the unit normal from the shape to the ball. One that lies beyond the ends of a
segment by more than `slop` has no gap: None. A point is a solid circle of radius 0, an arc a circle that is not solid,
where the ball is in its sector. `placed` closes a gap.

`depth_on_entry_<kind>`, for kinds with ends, is how deep a ball overlaps one while its centre comes past an end. The
shape comes first, then the ball's radius and the straight way of its centre, from outside of the segment's slab or the
arc's sector to inside. It is the lesser of the depths at the beginning of the way and where it crosses the edge: how
deep the ball is in the segment's line or the arc's circle there, below 0 where it is clear.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import GAP_ROUNDING
from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry
from carom.geometry.vector import cross, dot, larger, length


def gap_segment(
    segment: SegmentGeometry, x: float, y: float, radius: float, wx: float, wy: float, slop: float
) -> tuple[float, float, float] | None:
    """The gap to the segment, on the side that the ball is on."""
    ax, ay, tx, ty, extent = segment
    dx, dy = x - ax, y - ay
    along = dot(dx, dy, tx, ty)
    if along < -slop or along > extent + slop:
        return None
    side = cross(tx, ty, dx, dy)
    # On the line the ball is on the side that it comes from, so that it goes on approaching.
    if side < 0.0 or (side == 0.0 and cross(tx, ty, wx, wy) > 0.0):
        return -side - radius, ty, -tx
    return side - radius, -ty, tx


def gap_circle(
    circle: CircleGeometry, x: float, y: float, radius: float, wx: float, wy: float
) -> tuple[float, float, float]:
    """The gap to the circle, from outside or, unless it is solid, from inside."""
    cx, cy, r, solid = circle
    dx, dy = x - cx, y - cy
    # 0 at c alone, however small the numbers are: so nothing is divided by zero below.
    away = length(dx, dy)
    if away == 0.0:
        # No direction is nearer than another; against the velocity the ball approaches what it meets.
        nx, ny = against(wx, wy)
        return (-r if solid else r) - radius, nx, ny
    if not solid and (away < r or (away == r and dot(dx, dy, wx, wy) > 0.0)):
        return r - away - radius, -dx / away, -dy / away
    return away - r - radius, dx / away, dy / away


def depth_on_entry_segment(
    segment: SegmentGeometry, radius: float, from_x: float, from_y: float, to_x: float, to_y: float
) -> float:
    """The depth in the line of the segment."""
    ax, ay, tx, ty, extent = segment
    along = dot(from_x - ax, from_y - ay, tx, ty)
    way = dot(to_x - from_x, to_y - from_y, tx, ty)
    edge = 0.0 if along < 0.0 else extent
    # A way that does not get to the edge but by rounding crosses it at its end; so nothing is divided by zero.
    share = (edge - along) / way if fabs(edge - along) < fabs(way) else 1.0
    side = cross(tx, ty, from_x - ax, from_y - ay)
    return radius - larger(fabs(side), fabs(side + share * cross(tx, ty, to_x - from_x, to_y - from_y)))


def depth_on_entry_arc(
    arc: ArcGeometry, radius: float, from_x: float, from_y: float, to_x: float, to_y: float
) -> float:
    """The depth in the circle of which the arc is a part."""
    cx, cy, r, ax, ay, bx, by = arc
    x0, y0, x1, y1 = from_x - cx, from_y - cy, to_x - cx, to_y - cy
    # Each crossing of a ray leads into the sector or out of it, so it crosses one of the two, and the other has 0.
    start = crossing_share(ax - cx, ay - cy, x0, y0, x1, y1)
    end = crossing_share(bx - cx, by - cy, x0, y0, x1, y1)
    share = larger(start, end)
    gap = fabs(length(x0, y0) - r)
    gap_at_edge = fabs(length(x0 + share * (x1 - x0), y0 + share * (y1 - y0)) - r)
    return radius - larger(gap, gap_at_edge)


def crossing_share(ax: float, ay: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """The share of the way from (x0, y0) to (x1, y1) at which it crosses the ray along a; 0 where it does not."""
    # The cross product with a changes evenly along the way, and is 0 on the ray's line.
    before, after = cross(ax, ay, x0, y0), cross(ax, ay, x1, y1)
    if (before > 0.0) == (after > 0.0):
        return 0.0
    share = before / (before - after)
    # The line goes on past the centre, opposite to the ray.
    return share if dot(ax, ay, x0 + share * (x1 - x0), y0 + share * (y1 - y0)) >= 0.0 else 0.0


def placed(x: float, y: float, gap: float, nx: float, ny: float, scale: float) -> tuple[float, float]:
    """The centre moved along the normal so that its ball touches, whether it was too deep or not near enough.

    A gap within the rounding of `scale`, the coordinates that it was reckoned from, is left: a time of impact brings
    the ball to the surface that closely from either side, so nothing adds up, where moves by less than a place can tell
    would have a sign.
    """
    if fabs(gap) <= GAP_ROUNDING * scale:
        return x, y
    return x - gap * nx, y - gap * ny


def against(wx: float, wy: float) -> tuple[float, float]:
    """The unit vector against a velocity, or (0, 1) where there is none."""
    speed = sqrt(wx * wx + wy * wy)
    if speed == 0.0:
        return 0.0, 1.0
    return -wx / speed, -wy / speed
