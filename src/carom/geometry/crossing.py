"""Whether a straight way crosses the side of a shape."""

from __future__ import annotations

from math import sqrt

from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry, centred_arc
from carom.geometry.line import distance_to_segment
from carom.geometry.reach import in_arc
from carom.geometry.vector import cross, dot, length, length_squared


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
