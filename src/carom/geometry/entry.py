"""How deep a ball overlaps a shape while its centre comes past an end: `depth_on_entry_<kind>` for kinds with ends.

The shape comes first, then the ball's radius and the straight way of its centre, from outside of the segment's slab or
the arc's sector to inside. It is the lesser of the depths at the beginning of the way and where it crosses the edge:
how deep the ball is in the segment's line or the arc's circle there, below 0 where it is clear.
"""

from __future__ import annotations

from math import fabs

from carom.geometry.figures import ArcGeometry, SegmentGeometry
from carom.geometry.vector import cross, dot, larger, length


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
