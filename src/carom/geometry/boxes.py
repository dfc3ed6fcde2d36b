"""Whether a box along the axes and a shape have a point in common: `box_meets_<kind>`; touching counts.

The box comes first, as `left, bottom, right, top`, then the shape. A point is `aabb.box_contains`.
"""

from __future__ import annotations

from math import sqrt

from carom.geometry.aabb import box_contains, boxes_overlap, segment_box
from carom.geometry.arc import in_sector
from carom.geometry.figures import ArcGeometry, CircleGeometry
from carom.geometry.vector import cross, larger, smaller


def box_meets_segment(
    left: float, bottom: float, right: float, top: float, ax: float, ay: float, bx: float, by: float
) -> bool:
    """Whether the segment from a to b meets a box: their boxes overlap, and not all corners are on one side of it."""
    low_x, low_y, high_x, high_y = segment_box(ax, ay, bx, by)
    if not boxes_overlap(left, bottom, right, top, low_x, low_y, high_x, high_y):
        return False
    dx, dy = bx - ax, by - ay
    # A cross product is above zero for a corner on one side of the line, and below it on the other.
    first, second = cross(dx, dy, left - ax, bottom - ay), cross(dx, dy, right - ax, bottom - ay)
    third, fourth = cross(dx, dy, right - ax, top - ay), cross(dx, dy, left - ax, top - ay)
    lowest = smaller(smaller(first, second), smaller(third, fourth))
    highest = larger(larger(first, second), larger(third, fourth))
    return lowest <= 0.0 <= highest


def box_meets_circle(left: float, bottom: float, right: float, top: float, circle: CircleGeometry) -> bool:
    """Whether the circle meets a box: its disc if it is solid, else its perimeter."""
    cx, cy, radius, solid = circle
    near_x = larger(larger(left - cx, cx - right), 0.0)
    near_y = larger(larger(bottom - cy, cy - top), 0.0)
    if not near_x * near_x + near_y * near_y <= radius * radius:
        return False
    # A box that is nearer with its farthest corner too is inside of the perimeter.
    far_x = larger(cx - left, right - cx)
    far_y = larger(cy - bottom, top - cy)
    return solid or far_x * far_x + far_y * far_y >= radius * radius


def box_meets_arc(left: float, bottom: float, right: float, top: float, arc: ArcGeometry) -> bool:
    """Whether the arc meets a box: it ends inside, or crosses a side."""
    cx, cy, r, ax, ay, bx, by = arc
    if box_contains(left, bottom, right, top, ax, ay) or box_contains(left, bottom, right, top, bx, by):
        return True
    left, bottom, right, top = left - cx, bottom - cy, right - cx, top - cy
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    # A mirror that swaps the axes also swaps the ends, for it turns counterclockwise into clockwise.
    seen, mirrored = ArcGeometry(0.0, 0.0, r, ax, ay, bx, by), ArcGeometry(0.0, 0.0, r, by, bx, ay, ax)
    return (
        arc_meets_upright(left, bottom, top, seen)
        or arc_meets_upright(right, bottom, top, seen)
        or arc_meets_upright(bottom, left, right, mirrored)
        or arc_meets_upright(top, left, right, mirrored)
    )


def arc_meets_upright(x: float, low: float, high: float, arc: ArcGeometry) -> bool:
    """Whether an arc about 0 meets the upright line at `x` between the heights `low` and `high`."""
    _, _, r, ax, ay, bx, by = arc
    # r² - x² as a product, whose digits hold where the line all but touches the circle.
    y_squared = (r - x) * (r + x)
    if y_squared < 0.0:
        return False
    y = sqrt(y_squared)
    if low <= y <= high and in_sector(ax, ay, bx, by, x, y):
        return True
    return low <= -y <= high and in_sector(ax, ay, bx, by, x, -y)
