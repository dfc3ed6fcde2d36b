"""Impacts of a ball that moves straight: lines and quadratics, seen from the shape, None for a miss.

The ball's centre is p, relative to the shape's, its velocity v. With b = p·v and k = p × v, the line of motion passes
the centre at the distance |k|/|v|, so it is |p| = R away at the times (-b ± √(v²R² - k²))/v². That discriminant loses
no digits for a ball that is far away, unlike b² - v²(p² - R²), and neither of the two forms of each root does.
"""

from __future__ import annotations

from math import inf, sqrt

from carom.constants import APPROACH_ROUNDING_SQUARED, END_DEPTH_CONTINUOUS
from carom.geometry.reach import touch_in_sector, touch_in_slab, touches_arc
from carom.geometry.vector import smaller


def reach_disc(px: float, py: float, reach: float, vx: float, vy: float, duration: float) -> float | None:
    """When the centre comes as near as `reach` to 0 from outside."""
    b = px * vx + py * vy
    height = px * px + py * py - reach * reach
    # The squared distance is convex, so it stays above its tangent at the start.
    if b >= 0.0 or height + 2.0 * b * duration > 0.0:
        return None
    speed_squared = vx * vx + vy * vy
    k = px * vy - py * vx
    squared = speed_squared * (reach * reach) - k * k
    if not squared > 0.0:
        return None
    if height <= 0.0:
        if b * b <= APPROACH_ROUNDING_SQUARED * speed_squared * (reach * reach):
            return None
        return 0.0
    time = height / (sqrt(squared) - b)
    if time <= duration:
        return time
    return None


def reach_bowl(px: float, py: float, room: float, vx: float, vy: float, duration: float) -> float | None:
    """When the centre, inside a circle, comes as far as `room` from 0, and the ball touches it from inside."""
    b = px * vx + py * vy
    speed_squared = vx * vx + vy * vy
    # The squared distance is convex, so it is greatest at an end.
    if room > 0.0 and px * px + py * py + (2.0 * b + speed_squared * duration) * duration < room * room:
        return None
    time = bowl_time(px, py, room, vx, vy, b, speed_squared)
    if time <= duration:
        return time
    return None


def bowl_time(px: float, py: float, room: float, vx: float, vy: float, b: float, speed_squared: float) -> float:
    """That time, however late; infinite for a ball at rest. `b` and `speed_squared` are p·v and v².

    A ball that touches and slides goes on into the circle, so its impact is at 0. One that touches, to rounding or
    deeper, and leaves so flatly that it never gets clear, is as deep again after a chord.
    """
    if not speed_squared > 0.0:
        return inf
    height = px * px + py * py
    squared = -1.0
    if room > 0.0:
        k = px * vy - py * vx
        squared = speed_squared * (room * room) - k * k
    if room <= 0.0 or height >= room * room:
        if b >= 0.0 or b * b <= APPROACH_ROUNDING_SQUARED * speed_squared * height:
            return 0.0
        if not squared > 0.0:
            return -2.0 * b / speed_squared
        return (sqrt(squared) - b) / speed_squared
    root = 0.0
    if squared > 0.0:
        root = sqrt(squared)
    if b > 0.0:
        return (room * room - height) / (root + b)
    return (root - b) / speed_squared


def reach_arc(
    px: float,
    py: float,
    r: float,
    radius: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    margin: float,
    vx: float,
    vy: float,
    duration: float,
) -> float | None:
    """When the ball touches the arc of radius r about 0 from a to b, whose sector is widened by `margin`."""
    b = px * vx + py * vy
    speed_squared = vx * vx + vy * vy
    away = px * px + py * py
    room = r - radius
    if away > r * r or (away == r * r and b < 0.0):
        time = reach_disc(px, py, r + radius, vx, vy, duration)
        if time is None:
            return None
        nearest = smaller(duration, -b / speed_squared)
        touch = touch_in_sector(0.0 + time, nearest, px, py, r, radius, ax, ay, bx, by, margin, vx, vy, 0.0, 0.0)
        if touch is not None:
            return touch
    else:
        clear = room > 0.0 and away < room * room
        if clear and away + (2.0 * b + speed_squared * duration) * duration < room * room:
            return None
        if clear or b >= 0.0 or touches_arc(px, py, r, radius, ax, ay, bx, by, margin):
            late = bowl_time(px, py, room, vx, vy, b, speed_squared)
            if not late <= duration:
                return None
            return touch_in_sector(late, duration, px, py, r, radius, ax, ay, bx, by, margin, vx, vy, 0.0, 0.0)
    # It passes through the gap, or passes already. It may touch the inside on its way out, or where it enters the
    # sector after it has come all but clear, as a ball does that slides from a wall into a bowl.
    k = px * vy - py * vx
    room_squared, shallow = room * room, room + END_DEPTH_CONTINUOUS * radius
    if room <= 0.0 or not k * k <= speed_squared * (shallow * shallow):
        return None
    root = 0.0
    if speed_squared * room_squared > k * k:
        root = sqrt(speed_squared * room_squared - k * k)
    if not root - b <= duration * speed_squared:
        return None
    across = (root - b) / speed_squared
    return touch_in_sector(across, duration, px, py, r, radius, ax, ay, bx, by, margin, vx, vy, 0.0, 0.0)


def reach_line(
    gap: float,
    rate: float,
    along: float,
    along_rate: float,
    extent: float,
    radius: float,
    duration: float,
    slop: float,
) -> float | None:
    """When a ball touches a segment of length `extent`; its gap to the line shrinks: `rate` < 0."""
    if rate * rate <= APPROACH_ROUNDING_SQUARED * along_rate * along_rate:
        return None
    time = 0.0
    if gap > 0.0:
        time = gap / (0.0 - rate)
    if not time <= duration:
        return None
    return touch_in_slab(0.0 + time, duration, gap, rate, 0.0, along, along_rate, 0.0, extent, slop, radius)
