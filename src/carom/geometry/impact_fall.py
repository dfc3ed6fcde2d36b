"""Impacts of a ball that moves along a parabola, seen from the shape; None for a miss.

The gap to a line is a quadratic in time. The squared distance |p + v·t + g·t²/2|² from a point is a quartic. It turns
where the distance is least or greatest, at the roots of a cubic, which are enclosed between those of a quadratic; from
one turn to the next it only falls or only rises, so the squared distances at the turns tell between which of them the
ball touches. They are taken from the places there, not from the quartic's coefficients, and the quartic is set up anew
from the nearer of the two turns: so no digits are lost to a ball that comes from far away. Most misses are seen before
all this, by bounds that cost a few products.
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import APPROACH_ROUNDING_SQUARED, END_DEPTH_CONTINUOUS, GRAZING
from carom.geometry.reach import touch_in_sector, touch_in_slab, touches_arc
from carom.geometry.roots import cubic_roots, falling_time, root_between
from carom.geometry.vector import smaller


def fall_on_line(
    side: float,
    rate: float,
    acceleration: float,
    along: float,
    along_rate: float,
    along_acceleration: float,
    extent: float,
    radius: float,
    duration: float,
    slop: float,
) -> float | None:
    """When a ball touches a segment of length `extent`, on either side.

    Its centre's distance from the line is side + rate·t + acceleration·t²/2, with `side` at least 0, and its foot on
    the line, from the segment's first end, along + along_rate·t + along_acceleration·t²/2.
    """
    gap = side - radius
    if gap > 0.0:
        time = falling_time(gap, rate, acceleration)
    else:
        time = fall_from_overlap(gap, rate, acceleration, along_rate, radius, -slop <= along <= extent + slop)
    if time is not None and time <= duration:
        touch = touch_in_slab(
            0.0 + time, duration, gap, rate, acceleration, along, along_rate, along_acceleration, extent, slop, radius
        )
        if touch is not None:
            return touch
    # Past an end it may get to the other side, and come back to the segment from there.
    gap = -side - radius
    time = fall_from_crest(gap, -rate, -acceleration, radius)
    if time is None or time > duration:
        return None
    return touch_in_slab(
        0.0 + time, duration, gap, -rate, -acceleration, along, along_rate, along_acceleration, extent, slop, radius
    )


def fall_from_overlap(
    gap: float, rate: float, acceleration: float, along_rate: float, radius: float, beside: bool
) -> float | None:
    """When a ball that touches or overlaps (gap <= 0) is next pressed on: now, back from clear, or as deep as now.

    The last only if it is not about to pass, so if it is `beside` the segment or overlaps by the end depth at most.
    """
    slides = rate * rate <= APPROACH_ROUNDING_SQUARED * (rate * rate + along_rate * along_rate)
    if acceleration >= 0.0:
        if rate < 0.0 and not slides:
            return 0.0
        return None
    if rate <= 0.0 or slides:
        return 0.0
    time = falling_time(gap, rate, acceleration)
    if time is None and (beside or gap >= -END_DEPTH_CONTINUOUS * radius):
        return 2.0 * rate / (0.0 - acceleration)
    if time is None:
        return fall_from_crest(gap, rate, acceleration, radius)
    return time


def fall_from_crest(gap: float, rate: float, acceleration: float, radius: float) -> float | None:
    """When a ball that overlaps and leaves comes back from clear, or turns while within the end depth of it."""
    if rate <= 0.0 or acceleration >= 0.0:
        return None
    time = falling_time(gap, rate, acceleration)
    if time is None:
        crest = gap - 0.5 * rate * (rate / acceleration)
        if crest >= -END_DEPTH_CONTINUOUS * radius:
            return rate / (0.0 - acceleration)
    return time


def fall_on_disc(
    px: float, py: float, reach: float, vx: float, vy: float, gx: float, gy: float, duration: float
) -> float | None:
    """When the centre comes as near as `reach` to 0 from outside."""
    if stays_apart(px, vx, gx, reach, duration) or stays_apart(py, vy, gy, reach, duration):
        return None
    if stays_outside(px, py, reach, vx, vy, gx, gy, duration):
        return None
    return fall_time(px, py, 0.0, reach, True, 0.0, 0.0, 0.0, 0.0, 0.0, vx, vy, gx, gy, duration)


def fall_on_ring(
    px: float, py: float, r: float, radius: float, vx: float, vy: float, gx: float, gy: float, duration: float
) -> float | None:
    """When a ball whose centre is inside the circle of radius r about 0 touches it."""
    if stays_inside(px, py, r - radius, vx, vy, gx, gy, duration):
        return None
    return fall_time(px, py, r, radius, True, 0.0, 0.0, 0.0, 0.0, 0.0, vx, vy, gx, gy, duration)


def fall_on_arc(
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
    duration: float,
) -> float | None:
    """When the ball touches the arc of radius r about 0 from a to b, whose sector is widened by `margin`."""
    reach = r + radius
    if px * px + py * py > r * r:
        if stays_apart(px, vx, gx, reach, duration) or stays_apart(py, vy, gy, reach, duration):
            return None
        if stays_outside(px, py, reach, vx, vy, gx, gy, duration):
            return None
    elif stays_inside(px, py, r - radius, vx, vy, gx, gy, duration):
        return None
    return fall_time(px, py, r, radius, False, ax, ay, bx, by, margin, vx, vy, gx, gy, duration)


def stays_apart(p: float, v: float, g: float, reach: float, duration: float) -> bool:
    """Whether along one axis alone the centre stays farther than `reach` from 0."""
    if p < 0.0:
        p, v, g = -p, -v, -g
    lowest = p - reach
    if v < 0.0:
        lowest += v * duration
    if g < 0.0:
        lowest += 0.5 * g * duration * duration
    return lowest > 0.0


def stays_outside(
    px: float, py: float, reach: float, vx: float, vy: float, gx: float, gy: float, duration: float
) -> bool:
    """Whether the centre clearly stays farther than `reach` from 0, or leaves from there for good."""
    height = px * px + py * py - reach * reach
    if height < -GRAZING * reach * reach:
        return False
    # |p + v·t + g·t²/2|² without its fourth power, and with t³ replaced by t²·duration where it is negative.
    bend = vx * vx + vy * vy + px * gx + py * gy
    drift = vx * gx + vy * gy
    if drift < 0.0:
        bend += drift * duration
    return stays_above(height, 2.0 * (px * vx + py * vy), bend, duration)


def stays_inside(
    px: float, py: float, room: float, vx: float, vy: float, gx: float, gy: float, duration: float
) -> bool:
    """Whether the centre clearly stays nearer than `room` to 0."""
    height = room * room - (px * px + py * py)
    if room <= 0.0 or height < -GRAZING * room * room:
        return False
    bend = vx * vx + vy * vy + px * gx + py * gy + 0.25 * (gx * gx + gy * gy) * duration * duration
    drift = vx * gx + vy * gy
    if drift > 0.0:
        bend += drift * duration
    return stays_above(height, -2.0 * (px * vx + py * vy), -bend, duration)


def stays_above(height: float, rate: float, bend: float, duration: float) -> bool:
    """Whether height + rate·t + bend·t² is clearly above 0 for 0 < t <= duration; a negative height counts as 0."""
    if height < 0.0:
        height = 0.0
    end = height + (rate + bend * duration) * duration
    if not end > GRAZING * (height + (fabs(rate) + fabs(bend) * duration) * duration):
        return False
    if bend <= 0.0 or rate >= 0.0 or -rate >= 2.0 * bend * duration:
        return True
    return 4.0 * bend * height - rate * rate > GRAZING * rate * rate


def fall_time(
    px: float,
    py: float,
    r: float,
    radius: float,
    whole: bool,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    margin: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    duration: float,
) -> float | None:
    """When the ball touches the circle of radius r about 0, the whole of it or the arc from a to b."""
    away = px * px + py * py
    held = -1.0
    if fabs(sqrt(away) - r) <= radius and (whole or touches_arc(px, py, r, radius, ax, ay, bx, by, margin)):
        held = away
    falls, turn1, turn2, turn3 = distance_turns(px, py, vx, vy, gx, gy, duration)
    low = 0.0
    for high in (turn1, turn2, turn3, duration):
        if high > low:
            x, y = px + (vx + 0.5 * gx * high) * high, py + (vy + 0.5 * gy * high) * high
            end = x * x + y * y
            if falls:
                level = outer_level(away, r, radius, held)
                meets, at_once = end < level, away <= level
            else:
                level = inner_level(away, r, radius, held)
                meets, at_once = end > level, away >= level
            if meets:
                time = low
                if not at_once:
                    time = level_time(px, py, vx, vy, gx, gy, level, low, high, falls)
                if whole:
                    return time
                touch = touch_in_sector(time, high, px, py, r, radius, ax, ay, bx, by, margin, vx, vy, gx, gy)
                if touch is not None:
                    return touch
            low, away = high, end
        falls = not falls
    return None


def outer_level(away: float, r: float, radius: float, held: float) -> float:
    """At which squared distance a ball touches from outside that falls from the squared distance `away`; -1 at none.

    From clear, where it touches. Else as near as it was at the start, `held`, if it was outside then and not passing,
    or -1; else at once, if it overlaps by the end depth at most.
    """
    outer, shallow = r + radius, r + radius - END_DEPTH_CONTINUOUS * radius
    if away > outer * outer:
        return outer * outer
    if held >= r * r:
        return held
    if away >= shallow * shallow:
        return away
    return -1.0


def inner_level(away: float, r: float, radius: float, held: float) -> float:
    """The same for a ball inside, whose squared distance from the centre rises; infinity at none."""
    inner, shallow = r - radius, r - radius + END_DEPTH_CONTINUOUS * radius
    if inner > 0.0 and away < inner * inner:
        return inner * inner
    if 0.0 <= held <= r * r:
        return held
    if inner > 0.0 and away <= shallow * shallow:
        return away
    return inf


def distance_turns(
    px: float, py: float, vx: float, vy: float, gx: float, gy: float, duration: float
) -> tuple[bool, float, float, float]:
    """Whether the distance from 0 falls at first, and the three times at which it turns, `duration` if missing.

    They are the roots of p(t)·v(t). A ball that at first neither leaves nor approaches, to rounding, does neither.
    """
    outward = px * vx + py * vy
    speed_squared = vx * vx + vy * vy
    if outward * outward <= APPROACH_ROUNDING_SQUARED * speed_squared * (px * px + py * py):
        outward = 0.0
    drift, half = vx * gx + vy * gy, 0.5 * (gx * gx + gy * gy)
    bend = speed_squared + px * gx + py * gy
    turn1, turn2, turn3 = cubic_roots(half, 1.5 * drift, bend, outward, duration)
    return outward < 0.0, turn1, turn2, turn3


def level_time(
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    level: float,
    low: float,
    high: float,
    falls: bool,
) -> float:
    """When the squared distance, which falls from `low` to `high`, or rises, gets through `level` in between.

    The quartic is set up from the end where the ball is nearer: there its coefficients are small numbers.
    """
    base = high if falls else low
    width = high - low
    x, y = px + (vx + 0.5 * gx * base) * base, py + (vy + 0.5 * gy * base) * base
    wx, wy = vx + gx * base, vy + gy * base
    c4, c3 = 0.25 * (gx * gx + gy * gy), wx * gx + wy * gy
    c2, c1, c0 = wx * wx + wy * wy + x * gx + y * gy, 2.0 * (x * wx + y * wy), x * x + y * y - level
    # Newton starts where the quadratic part alone crosses the level.
    slope = fabs(c1)
    squared = slope * slope - 4.0 * c2 * c0
    guess = 0.5 * width
    if squared > 0.0:
        guess = -2.0 * c0 / (slope + sqrt(squared))
    if falls:
        return base + root_between(c4, c3, c2, c1, c0, -width, 0.0, False, -guess)
    return smaller(base + root_between(c4, c3, c2, c1, c0, 0.0, width, True, guess), high)
