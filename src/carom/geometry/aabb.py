"""Boxes along the axes, as (left, bottom, right, top) with left <= right and bottom <= top; edges belong to the box."""

from __future__ import annotations

from carom.geometry.arc import in_sector
from carom.geometry.vector import larger, smaller


def boxes_overlap(
    left1: float,
    bottom1: float,
    right1: float,
    top1: float,
    left2: float,
    bottom2: float,
    right2: float,
    top2: float,
) -> bool:
    """Whether two boxes have a point in common; touching counts."""
    return left1 <= right2 and left2 <= right1 and bottom1 <= top2 and bottom2 <= top1


def box_contains(left: float, bottom: float, right: float, top: float, x: float, y: float) -> bool:
    """Whether the point (x, y) lies in a box or on its edge."""
    return left <= x <= right and bottom <= y <= top


def box_including(
    left: float, bottom: float, right: float, top: float, x: float, y: float
) -> tuple[float, float, float, float]:
    """The smallest box that holds a box and the point (x, y)."""
    return smaller(left, x), smaller(bottom, y), larger(right, x), larger(top, y)


def segment_box(ax: float, ay: float, bx: float, by: float) -> tuple[float, float, float, float]:
    """The box of the segment from a to b."""
    return box_including(ax, ay, ax, ay, bx, by)


def circle_box(cx: float, cy: float, radius: float) -> tuple[float, float, float, float]:
    """The box of the circle about c."""
    return cx - radius, cy - radius, cx + radius, cy + radius


def arc_box(
    cx: float, cy: float, radius: float, ax: float, ay: float, bx: float, by: float
) -> tuple[float, float, float, float]:
    """The box of the arc about c that runs counterclockwise from its end a to its end b.

    It is spanned by the two ends and those of the circle's four quadrant points that lie on the arc.
    """
    left, bottom, right, top = segment_box(ax, ay, bx, by)
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    if in_sector(ax, ay, bx, by, 1.0, 0.0):
        right = larger(right, cx + radius)
    if in_sector(ax, ay, bx, by, 0.0, 1.0):
        top = larger(top, cy + radius)
    if in_sector(ax, ay, bx, by, -1.0, 0.0):
        left = smaller(left, cx - radius)
    if in_sector(ax, ay, bx, by, 0.0, -1.0):
        bottom = smaller(bottom, cy - radius)
    return left, bottom, right, top
