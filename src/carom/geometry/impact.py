"""When a moving ball first touches a shape: `impact_<kind>` for each kind of shape.

The shape comes first, then the path of the ball's centre, p(t) = p + v·t + g·t²/2 for t >= 0, its `radius`, and the
`duration` to look ahead. Each returns the first time from which on a ball that touches goes on approaching, or None.
The time depends on the shape, the path and the radius alone, to the bit; `duration`, which may be infinite, decides
only whether it is returned, or None because it is later. So a ball that touches, to rounding or deeper, and approaches
has its impact at 0; one that leaves or slides, and a path that only grazes, have none. A ball that overlaps and leaves
has its impact when it comes back from clear, or when it would get deeper than it was. A centre exactly on a segment or
perimeter is taken to be on the side that it comes from. Near the largest and smallest doubles, where squares overflow
or vanish, impacts are missed; there is never a NaN.
"""

from __future__ import annotations

from carom.geometry.figures import ArcGeometry, CircleGeometry, SegmentGeometry, centred_arc
from carom.geometry.impact_fall import fall_on_arc, fall_on_disc, fall_on_line, fall_on_ring, stays_apart
from carom.geometry.impact_straight import reach_arc, reach_bowl, reach_disc, reach_line
from carom.geometry.path import Path, is_straight, path_from
from carom.geometry.vector import cross, dot


def impact_point(qx: float, qy: float, path: Path, radius: float, duration: float) -> float | None:
    """When a ball first touches the point q; None if it does not within `duration`."""
    return impact_disc(path_from(path, qx, qy), radius, duration)


def impact_disc(path: Path, reach: float, duration: float) -> float | None:
    """When the centre comes as near as `reach` to 0 from outside, or None."""
    if is_straight(path):
        return reach_disc(path, reach, duration)
    return fall_on_disc(path, reach, duration)


def impact_segment(segment: SegmentGeometry, path: Path, radius: float, duration: float, slop: float) -> float | None:
    """When a ball first touches the segment, on either side, or None.

    Its centre's foot is on the segment then, or within `slop` past an end. The motion is taken apart into that along
    the normal, which is perp(t) or its opposite and points to the ball, and that along t.
    """
    ax, ay, tx, ty, extent = segment
    x, y, vx, vy, gx, gy = path
    dx, dy = x - ax, y - ay
    side, rate, acceleration = cross(tx, ty, dx, dy), cross(tx, ty, vx, vy), cross(tx, ty, gx, gy)
    if side < 0.0 or (side == 0.0 and rate > 0.0):
        side, rate, acceleration = -side, -rate, -acceleration
    # Most balls are too far off or too slow, and three products tell; the motion along t is not needed for that.
    if stays_apart(side, rate, acceleration, radius, duration):
        return None
    seen = Path(dot(dx, dy, tx, ty), side, dot(vx, vy, tx, ty), rate, dot(gx, gy, tx, ty), acceleration)
    if is_straight(path):
        return reach_line(seen, extent, radius, duration, slop)
    return fall_on_line(seen, extent, radius, duration, slop)


def impact_circle(circle: CircleGeometry, path: Path, radius: float, duration: float) -> float | None:
    """When a ball first touches the circle; None if it does not within `duration`.

    A ball whose centre is inside touches the perimeter from inside, unless the circle is solid.
    """
    cx, cy, r, solid = circle
    seen = path_from(path, cx, cy)
    px, py, vx, vy, _, _ = seen
    height, outward = px * px + py * py - r * r, px * vx + py * vy
    # On the perimeter it is outside if it goes inwards, for then that is where it comes from.
    if solid or height > 0.0 or (height == 0.0 and outward < 0.0):
        return impact_disc(seen, r + radius, duration)
    if is_straight(path):
        return reach_bowl(seen, r - radius, duration)
    return fall_on_ring(seen, r, radius, duration)


def impact_arc(arc: ArcGeometry, path: Path, radius: float, duration: float, slop: float) -> float | None:
    """When a ball first touches the arc, from outside or inside.

    Its centre is in the sector then, or within `slop` past its rays. None if it does not within `duration`.
    """
    centred, seen = centred_arc(arc, slop), path_from(path, arc.cx, arc.cy)
    if is_straight(path):
        return reach_arc(seen, radius, centred, duration)
    return fall_on_arc(seen, radius, centred, duration)


def impact_ball(first: Path, second: Path, reach: float, duration: float) -> float | None:
    """When two balls first touch, whose radii add up to `reach`; None if they do not within `duration`.

    The second as seen from the first moves straight while both fall, and while both are at rest.
    """
    x, y, vx, vy, gx, gy = first
    seen = Path(second.x - x, second.y - y, second.vx - vx, second.vy - vy, second.gx - gx, second.gy - gy)
    return impact_disc(seen, reach, duration)
