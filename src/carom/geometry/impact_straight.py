"""Impacts of a ball that moves straight: lines and quadratics, seen from the shape, None for a miss.

The ball's centre is p, relative to the shape's, its velocity v. With b = p·v and k = p × v, the line of motion passes
the centre at the distance |k|/|v|, so it is |p| = R away at the times (-b ± √(v²R² - k²))/v². That discriminant loses
no digits for a ball that is far away, unlike b² - v²(p² - R²), and neither of the two forms of each root does: the
other one is (p² - R²)/(-b ∓ √(v²R² - k²)), since the product of the two roots is (p² - R²)/v².

A time depends on the path and the shape alone. `duration`, which may be infinite, leaves out what is later; where it
spares the computing of a time, it does so for what keeps clear of a touch by more than rounding (`GRAZING`).
"""

from __future__ import annotations

from math import sqrt

from carom.constants import APPROACH_ROUNDING_SQUARED, END_DEPTH_CONTINUOUS, GRAZING
from carom.geometry.figures import CentredArc
from carom.geometry.path import Path
from carom.geometry.reach import sector_touch_within, slab_touch_within, touch_in_sector, touches_arc
from carom.geometry.roots import time_within
from carom.geometry.vector import cross, dot, length_squared


def reach_disc(path: Path, reach: float, duration: float) -> float | None:
    """When the centre comes as near as `reach` to 0 from outside."""
    px, py, vx, vy, _, _ = path
    b = dot(px, py, vx, vy)
    away = px * px + py * py
    height = away - reach * reach
    # The squared distance is convex, so it stays above its tangent at the start.
    if b >= 0.0 or height + 2.0 * b * duration > GRAZING * away:
        return None
    speed_squared = length_squared(vx, vy)
    k = cross(px, py, vx, vy)
    root_squared = speed_squared * (reach * reach) - k * k
    if not root_squared > 0.0:
        return None
    if height <= 0.0:
        # It touches, where |p| is about `reach`, and approaches at -b/|p|; the rounding of a slide is no approach.
        if b * b <= APPROACH_ROUNDING_SQUARED * speed_squared * (reach * reach):
            return None
        return 0.0
    return time_within(height / (sqrt(root_squared) - b), duration)


def reach_bowl(path: Path, room: float, duration: float) -> float | None:
    """When the centre, inside a circle, comes as far as `room` from 0, and the ball touches it from inside."""
    if stays_within(path, room, duration):
        return None
    time = bowl_time(path, room)
    if time is None:
        return None
    return time_within(0.0 + time, duration)


def stays_within(path: Path, room: float, duration: float) -> bool:
    """Whether the centre is clearly nearer than `room` to 0 at the end, so that it has not got as far before."""
    px, py, vx, vy, _, _ = path
    # The squared distance is convex: once it has risen through a level it stays above.
    rise = (2.0 * dot(px, py, vx, vy) + length_squared(vx, vy) * duration) * duration
    away, limit = px * px + py * py, room * room
    return room > 0.0 and away + rise < limit - GRAZING * (away + limit)


def bowl_time(path: Path, room: float) -> float | None:
    """When the centre comes as far as `room` from 0, however late; None for a ball at rest.

    A ball that touches and slides goes on into the circle, so its impact is at 0. One that touches, to rounding or
    deeper, and leaves so flatly that it never gets clear, is as deep again after a chord.
    """
    px, py, vx, vy, _, _ = path
    b, speed_squared = dot(px, py, vx, vy), length_squared(vx, vy)
    if not speed_squared > 0.0:
        return None
    height = px * px + py * py
    root_squared = -1.0
    if room > 0.0:
        k = cross(px, py, vx, vy)
        root_squared = speed_squared * (room * room) - k * k
    if room <= 0.0 or height >= room * room:
        if b >= 0.0 or b * b <= APPROACH_ROUNDING_SQUARED * speed_squared * height:
            return 0.0
        if not root_squared > 0.0:
            # p² + 2·b·t + v²·t² is p² again.
            return -2.0 * b / speed_squared
        return (sqrt(root_squared) - b) / speed_squared
    root = 0.0
    if root_squared > 0.0:
        root = sqrt(root_squared)
    # The later of the two roots, in the form that adds numbers of one sign.
    if b > 0.0:
        return (room * room - height) / (root + b)
    return (root - b) / speed_squared


def reach_arc(path: Path, radius: float, arc: CentredArc, duration: float) -> float | None:
    """When the ball touches the arc."""
    px, py, vx, vy, _, _ = path
    r = arc.r
    b = dot(px, py, vx, vy)
    speed_squared = length_squared(vx, vy)
    away = px * px + py * py
    room = r - radius
    if away > r * r or (away == r * r and b < 0.0):
        time = reach_disc(path, r + radius, duration)
        if time is None:
            return None
        # It goes inwards until it is nearest to the centre, at p·v + v²·t = 0; then it is a matter of the inside.
        touch = touch_in_sector(0.0 + time, -b / speed_squared, path, radius, arc)
        if touch is not None:
            return time_within(0.0 + touch, duration)
    else:
        clear = room > 0.0 and away < room * room
        if clear and stays_within(path, room, duration):
            return None
        if clear or b >= 0.0 or touches_arc(px, py, radius, arc):
            late = bowl_time(path, room)
            if late is None:
                return None
            return sector_touch_within(0.0 + late, path, radius, arc, duration)
    # It passes through the gap, or passes already. It may touch the inside on its way out, or where it enters the
    # sector after it has come all but clear, as a ball does that slides from a wall into a bowl. Its line passes the
    # centre at |k|/|v|; if that is more than `room`, it is least deep there, at the root 0.
    k = cross(px, py, vx, vy)
    room_squared, shallow = room * room, room + END_DEPTH_CONTINUOUS * radius
    if not speed_squared > 0.0 or room <= 0.0 or not k * k <= speed_squared * (shallow * shallow):
        return None
    root = 0.0
    if speed_squared * room_squared > k * k:
        root = sqrt(speed_squared * room_squared - k * k)
    return sector_touch_within((root - b) / speed_squared, path, radius, arc, duration)


def reach_line(path: Path, extent: float, radius: float, duration: float, slop: float) -> float | None:
    """When a ball touches a segment of length `extent`; its path is seen from there, as `fall_on_line` has it."""
    _, side, along_rate, rate, _, _ = path
    # One that slides along the line approaches it by rounding alone.
    if rate >= 0.0 or rate * rate <= APPROACH_ROUNDING_SQUARED * along_rate * along_rate:
        return None
    gap = side - radius
    time = 0.0
    if gap > 0.0:
        time = gap / (0.0 - rate)
    return slab_touch_within(time, path, extent, slop, radius, duration)
