"""When a ball that touches a segment's line, or an arc's circle, is beside the segment or arc itself.

A segment is met within its slab, an arc within its sector, each reaching a little past the ends. A ball that touches
outside of it, and comes into it while it overlaps by no more than `END_DEPTH_CONTINUOUS` of its radius, touches then;
one that overlaps more is passing. Both functions return the time of the touch, or None.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import END_DEPTH_CONTINUOUS
from carom.geometry.roots import falling_time
from carom.geometry.vector import cross, dot


def touch_in_slab(
    time: float,
    duration: float,
    gap: float,
    rate: float,
    acceleration: float,
    along: float,
    along_rate: float,
    along_acceleration: float,
    extent: float,
    slop: float,
    radius: float,
) -> float | None:
    """When a ball that touches a segment's line at `time` touches the segment of length `extent`, or None.

    Its gap to the line is gap + rate·t + acceleration·t²/2, and its foot on the line, from the segment's first end,
    along + along_rate·t + along_acceleration·t²/2.
    """
    foot = along + (along_rate + 0.5 * along_acceleration * time) * time
    speed = along_rate + along_acceleration * time
    if foot < -slop:
        entry = falling_time(-slop - foot, -speed, -along_acceleration)
    elif foot > extent + slop:
        entry = falling_time(foot - extent - slop, speed, along_acceleration)
    else:
        return time
    if entry is None:
        return None
    later = time + entry
    depth = gap + (rate + 0.5 * acceleration * later) * later
    if later <= duration and -END_DEPTH_CONTINUOUS * radius <= depth and rate + acceleration * later < 0.0:
        return later
    return None


def in_wide_sector(ax: float, ay: float, bx: float, by: float, x: float, y: float, margin: float) -> bool:
    """Whether (x, y) lies in the sector counterclockwise from a to b, widened by lines along its rays.

    All vectors are relative to the arc's centre; the lines are `margin` over the length of a, or b, beside the rays.
    """
    after_start = cross(ax, ay, x, y) >= -margin
    before_end = cross(x, y, bx, by) >= -margin
    turn = cross(ax, ay, bx, by)
    if turn < 0.0:  # more than half a turn: outside is what lies between the end and the start
        return after_start or before_end
    if turn == 0.0:  # half a turn, or a full one
        return after_start or before_end or dot(ax, ay, bx, by) > 0.0
    if not (after_start and before_end):
        return False
    # The margins alone would also let in what lies opposite to a narrow sector.
    return dot(ax, ay, bx, by) <= 0.0 or dot(x, y, ax + bx, ay + by) >= 0.0


def touches_arc(
    px: float, py: float, r: float, radius: float, ax: float, ay: float, bx: float, by: float, margin: float
) -> bool:
    """Whether a ball at p that overlaps the circle is not passing its arc: in the sector, or by the end depth alone."""
    if radius - fabs(sqrt(px * px + py * py) - r) <= END_DEPTH_CONTINUOUS * radius:
        return True
    return in_wide_sector(ax, ay, bx, by, px, py, margin)


def touch_in_sector(
    time: float,
    duration: float,
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
    gx: float,
    gy: float,
) -> float | None:
    """When a ball that touches the circle of radius r about 0 at `time` touches its arc from a to b, or None.

    It moves from p with v under g, and goes on in the same direction, in or out, until `duration` at most. `margin` is
    that of `in_wide_sector`.
    """
    x = px + (vx + 0.5 * gx * time) * time
    y = py + (vy + 0.5 * gy * time) * time
    if in_wide_sector(ax, ay, bx, by, x, y, margin):
        return time
    wx, wy = vx + gx * time, vy + gy * time
    past_start = falling_time(-margin - cross(ax, ay, x, y), -cross(ax, ay, wx, wy), -cross(ax, ay, gx, gy))
    past_end = falling_time(-margin - cross(x, y, bx, by), -cross(wx, wy, bx, by), -cross(gx, gy, bx, by))
    for entry in (past_start, past_end):
        if entry is not None:
            later = time + entry
            x = px + (vx + 0.5 * gx * later) * later
            y = py + (vy + 0.5 * gy * later) * later
            overlap = radius - fabs(sqrt(x * x + y * y) - r)
            # It is on a line of the sector, so rounding would decide unless the sector is wider here.
            inside = in_wide_sector(ax, ay, bx, by, x, y, 2.0 * margin)
            if later <= duration and inside and fabs(overlap) <= END_DEPTH_CONTINUOUS * radius:
                return later
    return None
