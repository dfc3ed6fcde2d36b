"""When a ball that touches a segment's line, or an arc's circle, is beside the segment or arc itself.

A segment is met within its slab, an arc within its sector, each reaching a little past the ends. A ball that touches
outside of it, and comes into it while it overlaps by no more than `END_DEPTH_CONTINUOUS` of its radius, touches then;
one that overlaps more is passing. The functions return the time of the touch, or None.
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import END_DEPTH_CONTINUOUS
from carom.geometry.figures import CentredArc
from carom.geometry.path import Path, place_on
from carom.geometry.roots import falling_time, time_within
from carom.geometry.vector import cross, dot


def touch_in_slab(time: float, path: Path, extent: float, slop: float, radius: float) -> float | None:
    """When a ball that touches a segment's line at `time` touches the segment of length `extent`, or None.

    Its path is seen from the segment: x is along it, from its first end, and y off its line.
    """
    along, side, along_rate, rate, along_acceleration, acceleration = path
    foot = along + (along_rate + 0.5 * along_acceleration * time) * time
    speed = along_rate + along_acceleration * time
    # How far the foot is past an end falls through zero as it comes in.
    if foot < -slop:
        entry = falling_time(-slop - foot, -speed, -along_acceleration)
    elif foot > extent + slop:
        entry = falling_time(foot - extent - slop, speed, along_acceleration)
    else:
        return time
    if entry is None:
        return None
    later = time + entry
    # It touches there if it overlaps by no more than the end depth and goes on approaching, else it is passing.
    gap = side - radius + (rate + 0.5 * acceleration * later) * later
    if -END_DEPTH_CONTINUOUS * radius <= gap and rate + acceleration * later < 0.0:
        return later
    return None


def slab_touch_within(
    time: float, path: Path, extent: float, slop: float, radius: float, duration: float
) -> float | None:
    """The same, or None if it is later than `duration`."""
    if not (time <= duration and time < inf):
        return None
    touch = touch_in_slab(time, path, extent, slop, radius)
    if touch is None:
        return None
    return time_within(0.0 + touch, duration)


def in_wide_sector(ax: float, ay: float, bx: float, by: float, x: float, y: float, margin: float) -> bool:
    """Whether (x, y) lies in the sector counterclockwise from a to b, widened by lines along its rays.

    All vectors are relative to the arc's centre; the lines are `margin` over the length of a, or b, beside the rays.
    """
    # A cross product with a is the length of a times the distance from its ray's line.
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


def in_arc(arc: CentredArc, x: float, y: float, widths: float) -> bool:
    """Whether (x, y) is in an arc's sector, widened by so many times its slop."""
    r, ax, ay, bx, by, slop = arc
    return in_wide_sector(ax, ay, bx, by, x, y, widths * slop * r)


def touches_arc(px: float, py: float, radius: float, arc: CentredArc) -> bool:
    """Whether a ball at p that overlaps the circle is not passing its arc: in the sector, or by the end depth alone."""
    if radius - fabs(sqrt(px * px + py * py) - arc.r) <= END_DEPTH_CONTINUOUS * radius:
        return True
    return in_arc(arc, px, py, 1.0)


def touch_in_sector(time: float, until: float, path: Path, radius: float, arc: CentredArc) -> float | None:
    """When a ball that touches an arc's circle at `time` touches the arc itself, or None.

    From then on it goes in one direction, in or out, up to the time `until`. It may cross both rays; the one that it
    crosses first counts.
    """
    x, y = place_on(path, time)
    if in_arc(arc, x, y, 1.0):
        return time
    r, ax, ay, bx, by, slop = arc
    _, _, vx, vy, gx, gy = path
    wx, wy = vx + gx * time, vy + gy * time
    # How far it is outside of a ray's line, times r, falls through zero as it comes in; quadratic in time, as its way.
    past_start = falling_time(-slop * r - cross(ax, ay, x, y), -cross(ax, ay, wx, wy), -cross(ax, ay, gx, gy))
    past_end = falling_time(-slop * r - cross(x, y, bx, by), -cross(wx, wy, bx, by), -cross(gx, gy, bx, by))
    touch = -1.0
    for entry in (past_start, past_end):
        if entry is not None:
            later = time + entry
            x, y = place_on(path, later)
            overlap = radius - fabs(sqrt(x * x + y * y) - r)
            # It is on a line of the sector, so rounding would decide unless the sector is wider here.
            inside = in_arc(arc, x, y, 2.0)
            sooner = touch < 0.0 or later < touch
            if sooner and later <= until and inside and fabs(overlap) <= END_DEPTH_CONTINUOUS * radius:
                touch = later
    if touch < 0.0:
        return None
    return touch


def sector_touch_within(time: float, path: Path, radius: float, arc: CentredArc, duration: float) -> float | None:
    """The same on its way for good in one direction, or None if it is later than `duration`."""
    if not (time <= duration and time < inf):
        return None
    touch = touch_in_sector(time, inf, path, radius, arc)
    if touch is None:
        return None
    return time_within(0.0 + touch, duration)
