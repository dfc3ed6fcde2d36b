"""When a moving ball first touches a shape: `impact_<kind>` for each kind of shape.

The shape's numbers come first, then the ball's centre `x, y` and `radius`, its velocity `vx, vy` and acceleration
`gx, gy`, and the `duration` to look ahead: p(t) = p + v·t + g·t²/2 for 0 <= t <= duration. Each returns the first time
from which on a ball that touches goes on approaching, or None. So a ball that touches, to rounding or deeper, and
approaches has its impact at 0; one that leaves or slides, and a path that only grazes, have none. A ball that overlaps
and leaves has its impact when it comes back from clear, or when it would get deeper than it was. A centre exactly on a
segment or perimeter is taken to be on the side that it comes from. Near the largest and smallest doubles, where squares
overflow or vanish, impacts are missed; there is never a NaN.
"""

from __future__ import annotations

from carom.geometry.impact_fall import fall_on_arc, fall_on_disc, fall_on_line, fall_on_ring
from carom.geometry.impact_straight import reach_arc, reach_bowl, reach_disc, reach_line


def impact_point(
    qx: float,
    qy: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When a ball first touches the point q; None if it does not within `duration`."""
    if gx == 0.0 and gy == 0.0:
        return reach_disc(x - qx, y - qy, radius, vx, vy, duration)
    return fall_on_disc(x - qx, y - qy, radius, vx, vy, gx, gy, duration)


def impact_segment(
    ax: float,
    ay: float,
    tx: float,
    ty: float,
    extent: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
    slop: float,
) -> float | None:
    """When a ball first touches the segment of length `extent` from a along the unit vector t, on either side, or None.

    Its centre's foot is on the segment then, or within `slop` past an end. The motion is taken apart into that along
    the normal, which is perp(t) or its opposite and points to the ball, and that along t.
    """
    dx, dy = x - ax, y - ay
    side = tx * dy - ty * dx
    rate = tx * vy - ty * vx
    if gx == 0.0 and gy == 0.0:
        if side < 0.0 or (side == 0.0 and rate > 0.0):
            side, rate = -side, -rate
        if rate >= 0.0 or side - radius + rate * duration > 0.0:
            return None
        return reach_line(side - radius, rate, dx * tx + dy * ty, vx * tx + vy * ty, extent, radius, duration, slop)
    acceleration = tx * gy - ty * gx
    if side < 0.0 or (side == 0.0 and rate > 0.0):
        side, rate, acceleration = -side, -rate, -acceleration
    lowest = side - radius
    if rate < 0.0:
        lowest += rate * duration
    if acceleration < 0.0:
        lowest += 0.5 * acceleration * duration * duration
    if lowest > 0.0:
        return None
    along, along_rate, along_acceleration = dx * tx + dy * ty, vx * tx + vy * ty, gx * tx + gy * ty
    return fall_on_line(side, rate, acceleration, along, along_rate, along_acceleration, extent, radius, duration, slop)


def impact_circle(
    cx: float,
    cy: float,
    r: float,
    solid: int,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When a ball first touches the circle of radius r about c; None if it does not within `duration`.

    A ball whose centre is inside touches the perimeter from inside, unless the circle is solid.
    """
    px, py = x - cx, y - cy
    height, outward = px * px + py * py - r * r, px * vx + py * vy
    outside = solid != 0 or height > 0.0 or (height == 0.0 and outward < 0.0)
    if gx == 0.0 and gy == 0.0:
        if outside:
            return reach_disc(px, py, r + radius, vx, vy, duration)
        return reach_bowl(px, py, r - radius, vx, vy, duration)
    if outside:
        return fall_on_disc(px, py, r + radius, vx, vy, gx, gy, duration)
    return fall_on_ring(px, py, r, radius, vx, vy, gx, gy, duration)


def impact_arc(
    cx: float,
    cy: float,
    r: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
    slop: float,
) -> float | None:
    """When a ball first touches, from outside or inside, the arc of radius r about c from its end a to its end b.

    Its centre is in the sector then, or within `slop` past its rays. None if it does not within `duration`.
    """
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    if gx == 0.0 and gy == 0.0:
        return reach_arc(x - cx, y - cy, r, radius, ax, ay, bx, by, slop * r, vx, vy, duration)
    return fall_on_arc(x - cx, y - cy, r, radius, ax, ay, bx, by, slop * r, vx, vy, gx, gy, duration)


def impact_ball(
    x1: float,
    y1: float,
    vx1: float,
    vy1: float,
    r1: float,
    x2: float,
    y2: float,
    vx2: float,
    vy2: float,
    r2: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When two balls first touch; None if they do not within `duration`.

    `gx, gy` is the second's acceleration relative to the first: zero while both fall, and while both are at rest.
    """
    return impact_point(x1, y1, x2, y2, r1 + r2, vx2 - vx1, vy2 - vy1, gx, gy, duration)
