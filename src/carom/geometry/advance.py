"""When a moving ball first touches a shape that moves and turns about a pivot: `advance_<kind>` for each kind.

The shape's numbers come first, as they are at time 0, then its pivot, the pivot's velocity and the shape's `spin`,
the angular velocity in rad/s; then the ball's centre `x, y` and `radius`, its velocity `vx, vy` and acceleration `gx,
gy`, and the `duration` to look ahead, within which none of these change. Each returns what `impact` returns: the first
time from which on a ball that touches goes on approaching, as seen from the shape, or None. A shape that does not turn
is met in closed form. What turns is met by the search of `turning`, which says how exact it is and how it ends.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import END_DEPTH_CONTINUOUS, TURN_CROSSINGS, TURN_DEPTH
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.reach import in_wide_sector, touches_arc
from carom.geometry.turning import INNER, LINE, OUTER, next_fall, seen_gap, seen_place
from carom.geometry.vector import dot, smaller


def advance_point(
    qx: float,
    qy: float,
    pivot_x: float,
    pivot_y: float,
    pivot_vx: float,
    pivot_vy: float,
    spin: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When the ball first touches the point q, or None."""
    wx, wy = vx - pivot_vx, vy - pivot_vy
    kx, ky = qx - pivot_x, qy - pivot_y
    if spin == 0.0 or (kx == 0.0 and ky == 0.0):
        return impact_point(qx, qy, x, y, radius, wx, wy, gx, gy, duration)
    px, py, depth = x - pivot_x, y - pivot_y, TURN_DEPTH * radius
    return next_fall(0.0, True, depth, OUTER, kx, ky, radius, px, py, wx, wy, gx, gy, spin, duration)


def advance_segment(
    ax: float,
    ay: float,
    tx: float,
    ty: float,
    extent: float,
    pivot_x: float,
    pivot_y: float,
    pivot_vx: float,
    pivot_vy: float,
    spin: float,
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
    """When the ball first touches, on either side, the segment of length `extent` from a along the unit t, or None."""
    wx, wy = vx - pivot_vx, vy - pivot_vy
    if spin == 0.0:
        return impact_segment(ax, ay, tx, ty, extent, x, y, radius, wx, wy, gx, gy, duration, slop)
    px, py = x - pivot_x, y - pivot_y
    ax, ay = ax - pivot_x, ay - pivot_y
    nx, ny = -ty, tx
    side, rate = nx * (px - ax) + ny * (py - ay), nx * (wx + spin * py) + ny * (wy - spin * px)
    if side < 0.0 or (side == 0.0 and rate > 0.0):
        nx, ny, side = ty, -tx, -side
    start = dot(tx, ty, ax, ay)
    held = side - radius >= -END_DEPTH_CONTINUOUS * radius
    if not held:
        held = -slop <= dot(tx, ty, px, py) - start <= extent + slop
    level = dot(nx, ny, ax, ay)
    near = advance_on_side(
        held, nx, ny, level + radius, tx, ty, start, extent, slop, radius, px, py, wx, wy, gx, gy, spin, duration
    )
    far = advance_on_side(
        False, -nx, -ny, radius - level, tx, ty, start, extent, slop, radius, px, py, wx, wy, gx, gy, spin, duration
    )
    return sooner(near, far)


def advance_on_side(
    held: bool,
    nx: float,
    ny: float,
    level: float,
    tx: float,
    ty: float,
    start: float,
    extent: float,
    slop: float,
    radius: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
    duration: float,
) -> float | None:
    """When the ball touches a segment on the side of its normal n, or None; all is seen from the pivot.

    The ball touches its line at n·q = level, and is beside it where 0 <= t·q - start <= extent.
    """
    depth = TURN_DEPTH * radius
    touch = next_fall(0.0, held, depth, LINE, nx, ny, level, px, py, vx, vy, gx, gy, spin, duration)
    for _ in range(TURN_CROSSINGS):
        if touch is None:
            return None
        time = 0.0 + touch
        qx, qy, _wx, _wy = seen_place(time, px, py, vx, vy, gx, gy, spin)
        foot = tx * qx + ty * qy - start
        if foot < -slop:
            entry = next_fall(time, True, depth, LINE, -tx, -ty, slop - start, px, py, vx, vy, gx, gy, spin, duration)
        elif foot > extent + slop:
            entry = next_fall(
                time, True, depth, LINE, tx, ty, start + extent + slop, px, py, vx, vy, gx, gy, spin, duration
            )
        else:
            return time
        if entry is not None:
            later = 0.0 + entry
            gap, rate = seen_gap(later, LINE, nx, ny, level, px, py, vx, vy, gx, gy, spin)
            if fabs(gap) <= END_DEPTH_CONTINUOUS * radius and rate < 0.0:
                return later
        touch = next_fall(time, False, depth, LINE, nx, ny, level, px, py, vx, vy, gx, gy, spin, duration)
    return touch


def advance_circle(
    cx: float,
    cy: float,
    r: float,
    solid: int,
    pivot_x: float,
    pivot_y: float,
    pivot_vx: float,
    pivot_vy: float,
    spin: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When the ball first touches the circle of radius r about c, from outside or, unless it is solid, from inside."""
    wx, wy = vx - pivot_vx, vy - pivot_vy
    kx, ky = cx - pivot_x, cy - pivot_y
    if spin == 0.0 or (kx == 0.0 and ky == 0.0):
        return impact_circle(cx, cy, r, solid, x, y, radius, wx, wy, gx, gy, duration)
    px, py, depth = x - pivot_x, y - pivot_y, TURN_DEPTH * radius
    dx, dy = px - kx, py - ky
    away, outward = dx * dx + dy * dy - r * r, dx * (wx + spin * py) + dy * (wy - spin * px)
    if solid != 0 or away > 0.0 or (away == 0.0 and outward < 0.0):
        return next_fall(0.0, True, depth, OUTER, kx, ky, r + radius, px, py, wx, wy, gx, gy, spin, duration)
    if r > radius:
        return next_fall(0.0, True, depth, INNER, kx, ky, r - radius, px, py, wx, wy, gx, gy, spin, duration)
    if outward > 0.0:
        return 0.0
    return None


def advance_arc(
    cx: float,
    cy: float,
    r: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    pivot_x: float,
    pivot_y: float,
    pivot_vx: float,
    pivot_vy: float,
    spin: float,
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
    """When the ball first touches, from outside or inside, the arc of radius r about c from its end a to its end b."""
    wx, wy = vx - pivot_vx, vy - pivot_vy
    if spin == 0.0:
        return impact_arc(cx, cy, r, ax, ay, bx, by, x, y, radius, wx, wy, gx, gy, duration, slop)
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    kx, ky = cx - pivot_x, cy - pivot_y
    px, py = x - pivot_x, y - pivot_y
    dx, dy = px - kx, py - ky
    away, outward = sqrt(dx * dx + dy * dy), dx * (wx + spin * py) + dy * (wy - spin * px)
    outside = away > r or (away == r and outward < 0.0)
    held = touches_arc(dx, dy, r, radius, ax, ay, bx, by, slop * r)
    outer = advance_on_perimeter(
        held and outside, OUTER, kx, ky, r, radius, ax, ay, bx, by, slop, px, py, wx, wy, gx, gy, spin, duration
    )
    if r > radius:
        inner = advance_on_perimeter(
            held and not outside, INNER, kx, ky, r, radius, ax, ay, bx, by, slop, px, py, wx, wy, gx, gy, spin, duration
        )
        return sooner(outer, inner)
    if held and not outside and outward > 0.0:
        return 0.0
    return outer


def advance_on_perimeter(
    held: bool,
    form: int,
    kx: float,
    ky: float,
    r: float,
    radius: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    slop: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
    duration: float,
) -> float | None:
    """When the ball touches the arc about k from a to b from outside or inside, by `form`, or None.

    k and p are relative to the pivot, a and b to k.
    """
    depth, margin = TURN_DEPTH * radius, slop * r
    level = r + radius if form == OUTER else r - radius
    touch = next_fall(0.0, held, depth, form, kx, ky, level, px, py, vx, vy, gx, gy, spin, duration)
    for _ in range(TURN_CROSSINGS):
        if touch is None:
            return None
        time = 0.0 + touch
        qx, qy, _wx, _wy = seen_place(time, px, py, vx, vy, gx, gy, spin)
        qx, qy = qx - kx, qy - ky
        if in_wide_sector(ax, ay, bx, by, qx, qy, margin):
            return time
        after = sector_entry(
            time, form, kx, ky, level, r, radius, ax, ay, bx, by, slop, px, py, vx, vy, gx, gy, spin, duration
        )
        if after is not None:
            return after
        touch = next_fall(time, False, depth, form, kx, ky, level, px, py, vx, vy, gx, gy, spin, duration)
    return touch


def sector_entry(
    time: float,
    form: int,
    kx: float,
    ky: float,
    level: float,
    r: float,
    radius: float,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    slop: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
    duration: float,
) -> float | None:
    """When a ball that touches an arc's circle at `time` outside of the sector comes into it all but touching, or None.

    The rays' lines, `slop` outside of the sector, are crossed where the distance from a line falls through zero.
    """
    depth = TURN_DEPTH * radius
    nx, ny = ay / r, -ax / r
    line = dot(nx, ny, kx, ky) + slop
    first = next_fall(time, True, depth, LINE, nx, ny, line, px, py, vx, vy, gx, gy, spin, duration)
    nx, ny = -by / r, bx / r
    line = dot(nx, ny, kx, ky) + slop
    second = next_fall(time, True, depth, LINE, nx, ny, line, px, py, vx, vy, gx, gy, spin, duration)
    for entry in (first, second):
        if entry is not None:
            later = 0.0 + entry
            gap, rate = seen_gap(later, form, kx, ky, level, px, py, vx, vy, gx, gy, spin)
            qx, qy, _wx, _wy = seen_place(later, px, py, vx, vy, gx, gy, spin)
            inside = in_wide_sector(ax, ay, bx, by, qx - kx, qy - ky, 2.0 * slop * r)
            if inside and fabs(gap) <= END_DEPTH_CONTINUOUS * radius and rate < 0.0:
                return later
    return None


def sooner(first: float | None, second: float | None) -> float | None:
    """The earlier of two times, of which either may be missing; None if both are."""
    if first is None:
        return second
    if second is None:
        return first
    return smaller(0.0 + first, 0.0 + second)
