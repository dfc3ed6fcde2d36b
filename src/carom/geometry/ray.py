"""The first touch of a ray, or of a circle that is moved along one: `ray_<kind>` for each kind of shape.

The shape comes first, then the start `x, y`, the circle's `radius` (0 for a ray proper) and the way to the
target `dx, dy`. Each returns `(fraction, px, py, nx, ny)`: how much of the way is gone at the first touch, the point
on the shape, and the unit normal there, which points against the motion; or None. What a touch is, `impact` says: a
circle that touches already and approaches touches at 0, one that leaves or slides does not. A ball is a solid circle.

`crosses_<kind>` says whether a straight way crosses a side of a shape that has one.
"""

from __future__ import annotations

from math import sqrt

from carom.geometry.circle import circle_contains
from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry, centred_arc
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.line import distance_to_segment
from carom.geometry.overlap import direction_or
from carom.geometry.path import Path
from carom.geometry.reach import in_arc
from carom.geometry.vector import cross, dot, length, length_squared


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


def crosses_segment(segment: SegmentGeometry, x: float, y: float, dx: float, dy: float, slop: float) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses a segment.

    What begins on its line does not cross it. The ends reach `slop` far.
    """
    ax, ay, tx, ty, extent = segment
    # The distance from the line, above zero on one side and below it on the other, changes evenly along the way.
    before, after = cross(tx, ty, x - ax, y - ay), cross(tx, ty, x + dx - ax, y + dy - ay)
    if before == 0.0 or (before > 0.0 and after > 0.0) or (before < 0.0 and after < 0.0):
        return False
    share = before / (before - after)
    along = dot(x + share * dx - ax, y + share * dy - ay, tx, ty)
    return bool(-slop <= along <= extent + slop)


def crosses_circle(circle: CircleGeometry, x: float, y: float, dx: float, dy: float) -> bool:
    """True if the way from (x, y) by (dx, dy) comes into a circle, or leaves one that is not solid."""
    cx, cy, r, solid = circle
    away = length(x - cx, y - cy)
    if away < r:
        return bool(not solid and length(x + dx - cx, y + dy - cy) >= r)
    # It may come in and leave again, so the end of the way does not tell.
    return away > r and distance_to_segment(x, y, x + dx, y + dy, cx, cy) < r


def crosses_arc(arc: ArcGeometry, x: float, y: float, dx: float, dy: float, slop: float) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses an arc: its circle, within the sector.

    What begins on the circle does not cross it. The ends reach `slop` far.
    """
    r, centred = arc.r, centred_arc(arc, slop)
    x, y = x - arc.cx, y - arc.cy
    away = length(x, y)
    way_squared, along = length_squared(dx, dy), dot(x, y, dx, dy)
    # |p + s·d|² = r² is d²·s² + 2(p·d)·s + p² - r² = 0; p² - r² as a product, whose digits hold close to the circle.
    root_squared = along * along - way_squared * (away - r) * (away + r)
    if away == r or way_squared == 0.0 or root_squared < 0.0:
        return False
    root = sqrt(root_squared)
    for share in ((-along - root) / way_squared, (-along + root) / way_squared):
        if 0.0 < share <= 1.0 and in_arc(centred, x + share * dx, y + share * dy, 1.0):
            return True
    return False
