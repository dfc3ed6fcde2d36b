"""The gap between a ball and a shape, and the normal there: `gap_<kind>`.

The shape comes first, then the ball's centre `x, y`, its `radius`, and `wx, wy`, its velocity relative to the shape,
which decides the normal where the centre lies on the shape. Each returns `(gap, nx, ny)`: how far the ball is from the
shape, negative where they overlap, and the unit normal from the shape to the ball. One that lies beyond the ends of a
segment by more than `slop` has no gap: None. A point is a solid circle of radius 0, an arc a circle that is not solid,
where the ball is in its sector. `placed` closes a gap.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import GAP_ROUNDING
from carom.geometry.figures import CircleGeometry, SegmentGeometry
from carom.geometry.vector import cross, dot, length


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
