"""The first touch of a ray, or of a circle that is moved along one: `ray_<kind>` for each kind of shape.

The shape comes first, then the start `x, y`, the circle's `radius` (0 for a ray proper) and the way to the
target `dx, dy`. Each returns `(fraction, px, py, nx, ny)`: how much of the way is gone at the first touch, the point
on the shape, and the unit normal there, which points against the motion; or None. What a touch is, `impact` says: a
circle that touches already and approaches touches at 0, one that leaves or slides does not. A ball is a solid circle.
"""

from __future__ import annotations

from carom.geometry.circle import circle_contains
from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.overlap import direction_or
from carom.geometry.path import Path


def ray_point(
    qx: float, qy: float, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch with the point q; a ray of radius 0 has none, however well it is aimed."""
    fraction = impact_point(qx, qy, Path(x, y, dx, dy, 0.0, 0.0), radius, 1.0)
    if fraction is None:
        return None
    nx, ny = direction_or(x + dx * fraction - qx, y + dy * fraction - qy, dx, dy)
    return fraction, qx, qy, nx, ny


def ray_segment(
    segment: SegmentGeometry, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch, on either side, with the segment, or None."""
    fraction = impact_segment(segment, Path(x, y, dx, dy, 0.0, 0.0), radius, 1.0, 0.0)
    if fraction is None:
        return None
    ax, ay, tx, ty, _ = segment
    along = (x + dx * fraction - ax) * tx + (y + dy * fraction - ay) * ty
    nx, ny = 0.0 - ty, tx
    if nx * dx + ny * dy > 0.0:
        nx, ny = ty, 0.0 - tx
    return fraction, ax + along * tx, ay + along * ty, nx, ny


def ray_circle(
    circle: CircleGeometry, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch with the circle, from outside or (unless it is solid) inside, or None."""
    path = Path(x, y, dx, dy, 0.0, 0.0)
    fraction = impact_circle(circle, path, radius, 1.0)
    return None if fraction is None else touch_of_perimeter(fraction, circle.cx, circle.cy, circle.r, path)


def ray_disc(
    circle: CircleGeometry, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch with a ball or a solid circle; None for a ray proper that starts inside, and does not see it."""
    if radius == 0.0 and circle_contains(circle.cx, circle.cy, circle.r, x, y):
        return None
    return ray_circle(circle, x, y, radius, dx, dy)


def ray_arc(
    arc: ArcGeometry, x: float, y: float, radius: float, dx: float, dy: float, slop: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch, from either side, with the arc, whose ends reach `slop` far, or None."""
    path = Path(x, y, dx, dy, 0.0, 0.0)
    fraction = impact_arc(arc, path, radius, 1.0, slop)
    return None if fraction is None else touch_of_perimeter(fraction, arc.cx, arc.cy, arc.r, path)


def touch_of_perimeter(
    fraction: float, cx: float, cy: float, r: float, path: Path
) -> tuple[float, float, float, float, float]:
    """The touch after `fraction` of the way, with its point on the circle of radius r about c and its normal."""
    x, y, dx, dy, _, _ = path
    ux, uy = direction_or(x + dx * fraction - cx, y + dy * fraction - cy, dx, dy)
    px, py = cx + r * ux, cy + r * uy
    if ux * dx + uy * dy > 0.0:
        return fraction, px, py, 0.0 - ux, 0.0 - uy
    return fraction, px, py, ux, uy
