"""Whether a straight way crosses the side of a shape."""

from __future__ import annotations

from math import sqrt

from carom.geometry.line import distance_to_segment
from carom.geometry.reach import in_wide_sector
from carom.geometry.vector import cross, dot, length


def crosses_segment(
    ax: float, ay: float, tx: float, ty: float, extent: float, x: float, y: float, dx: float, dy: float, slop: float
) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses a segment from (ax, ay) along the unit vector t.

    What begins on its line does not cross it. The ends reach `slop` far.
    """
    before, after = cross(tx, ty, x - ax, y - ay), cross(tx, ty, x + dx - ax, y + dy - ay)
    if before == 0.0 or (before > 0.0 and after > 0.0) or (before < 0.0 and after < 0.0):
        return False
    share = before / (before - after)
    along = dot(x + share * dx - ax, y + share * dy - ay, tx, ty)
    return bool(-slop <= along <= extent + slop)


def crosses_circle(cx: float, cy: float, r: float, solid: int, x: float, y: float, dx: float, dy: float) -> bool:
    """True if the way from (x, y) by (dx, dy) comes into a circle, or leaves one that is not solid."""
    away = length(x - cx, y - cy)
    if away < r:
        return bool(solid == 0 and length(x + dx - cx, y + dy - cy) >= r)
    return away > r and distance_to_segment(x, y, x + dx, y + dy, cx, cy) < r


def crosses_arc(
    cx: float,
    cy: float,
    r: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    x: float,
    y: float,
    dx: float,
    dy: float,
    slop: float,
) -> bool:
    """True if the way from (x, y) by (dx, dy) crosses an arc from a to b: its circle, within the sector.

    What begins on the circle does not cross it. The ends reach `slop` far.
    """
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    x, y = x - cx, y - cy
    away = length(x, y)
    squared, along = dx * dx + dy * dy, dot(x, y, dx, dy)
    within = along * along - squared * (away - r) * (away + r)
    if away == r or squared == 0.0 or within < 0.0:
        return False
    root = sqrt(within)
    for share in ((-along - root) / squared, (-along + root) / squared):
        if 0.0 < share <= 1.0 and in_wide_sector(ax, ay, bx, by, x + share * dx, y + share * dy, slop * r):
            return True
    return False
