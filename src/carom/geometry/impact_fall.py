"""Impacts of a ball that moves along a parabola, seen from the shape; None for a miss.

The gap to a line is a quadratic in time. The squared distance |p + v·t + g·t²/2|² from a point is a quartic,
p² + 2(p·v)·t + (v² + p·g)·t² + (v·g)·t³ + g²·t⁴/4. It turns where the distance is least or greatest, at the roots of a
cubic, which are enclosed between those of a quadratic; from one turn to the next it only falls or only rises, so the
squared distances at the turns tell between which of them the ball touches. They are taken from the places there, not
from the quartic's coefficients, and so are the cubic's values; the quartic is set up anew from the nearer of the two
turns. So no digits are lost to a ball that comes from far away. All roots are looked for until the ball is out of reach
for good, so a time depends on the path and the shape alone, and `duration`, which may be infinite, leaves out what is
later. Most misses within it are seen before all this, by bounds that cost a few products; they leave out only what
keeps clear of a touch by more than rounding (`GRAZING`).
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import (
    APPROACH_ROUNDING_SQUARED,
    END_DEPTH_CONTINUOUS,
    ESCAPE_MARGIN,
    GRAZING,
    ROOT_STEPS,
    ROOT_TOLERANCE,
)
from carom.geometry.figures import CentredArc
from carom.geometry.path import Path, path_after, place_on
from carom.geometry.reach import slab_touch_within, touch_in_sector, touch_in_slab, touches_arc
from carom.geometry.roots import Quartic, falling_time, newton_step, quadratic_roots, root_between, time_within
from carom.geometry.vector import dot, larger, length_squared, smaller, unit


def fall_on_line(path: Path, extent: float, radius: float, duration: float, slop: float) -> float | None:
    """When a ball touches a segment of length `extent`, on either side.

    Its path is seen from the segment: x is along it, from its first end, and y off its line, at least 0 at first.
    """
    along, side, along_rate, rate, along_acceleration, acceleration = path
    gap = side - radius
    if gap > 0.0:
        time = falling_time(gap, rate, acceleration)
    else:
        time = fall_from_overlap(gap, rate, acceleration, along_rate, radius, -slop <= along <= extent + slop)
    if time is not None and 0.0 + time < inf:
        touch = touch_in_slab(0.0 + time, path, extent, slop, radius)
        if touch is not None:
            return time_within(0.0 + touch, duration)
    # Past an end it may get to the other side, and come back to the segment from there. On that side it begins below
    # the line, so what it falls from is the crest of its path.
    mirrored = Path(along, -side, along_rate, -rate, along_acceleration, -acceleration)
    time = fall_from_crest(-side - radius, -rate, -acceleration, radius)
    if time is None:
        return None
    return slab_touch_within(0.0 + time, mirrored, extent, slop, radius, duration)


def fall_from_overlap(
    gap: float, rate: float, acceleration: float, along_rate: float, radius: float, beside: bool
) -> float | None:
    """When a ball that touches or overlaps (gap <= 0) is next pressed on: now, back from clear, or as deep as now.

    The last only if it is not about to pass, so if it is `beside` the segment or overlaps by the end depth at most.
    """
    # A rate as small as the rounding of the velocity's direction is none.
    slides = rate * rate <= APPROACH_ROUNDING_SQUARED * (rate * rate + along_rate * along_rate)
    # Without a pull towards the line it is pressed on now or never, with one at once unless it leaves.
    if acceleration >= 0.0:
        if rate < 0.0 and not slides:
            return 0.0
        return None
    if rate <= 0.0 or slides:
        return 0.0
    time = falling_time(gap, rate, acceleration)
    if time is None and (beside or gap >= -END_DEPTH_CONTINUOUS * radius):
        # It never gets clear; rate·t + acceleration·t²/2 is 0 again.
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
        # The rate is 0 at t = -rate/acceleration, where the gap is gap - rate²/(2·acceleration).
        crest = gap - 0.5 * rate * (rate / acceleration)
        if crest >= -END_DEPTH_CONTINUOUS * radius:
            return rate / (0.0 - acceleration)
    return time


def fall_on_disc(path: Path, reach: float, duration: float) -> float | None:
    """When the centre comes as near as `reach` to 0 from outside."""
    if stays_outside(path, reach, duration):
        return None
    return fall_on_perimeter(path, 0.0, reach, duration)


def fall_on_ring(path: Path, r: float, radius: float, duration: float) -> float | None:
    """When a ball whose centre is inside the circle of radius r about 0 touches it."""
    if stays_inside(path, r - radius, duration):
        return None
    return fall_on_perimeter(path, r, radius, duration)


def fall_on_perimeter(path: Path, r: float, radius: float, duration: float) -> float | None:
    """When the ball touches the circle of radius r about 0, from wherever it is."""
    return fall_time(path, radius, CentredArc(r, 0.0, 0.0, 0.0, 0.0, 0.0), True, duration)


def fall_on_arc(path: Path, radius: float, arc: CentredArc, duration: float) -> float | None:
    """When the ball touches the arc."""
    r = arc.r
    if length_squared(path.x, path.y) > r * r:
        if stays_outside(path, r + radius, duration):
            return None
    elif stays_inside(path, r - radius, duration):
        return None
    return fall_time(path, radius, arc, False, duration)


def stays_apart(p: float, v: float, g: float, reach: float, duration: float) -> bool:
    """Whether along one axis alone the centre clearly stays farther than `reach` from 0."""
    if p < 0.0:
        p, v, g = -p, -v, -g
    # Each of the terms v·t and g·t²/2 is least at one of the ends; so their sum is no less than the sum of the least.
    lowest = p - reach
    if v < 0.0:
        lowest += v * duration
    if g < 0.0:
        lowest += 0.5 * g * duration * duration
    return lowest > GRAZING * (p + reach)


def stays_outside(path: Path, reach: float, duration: float) -> bool:
    """Whether the centre clearly stays farther than `reach` from 0, or leaves from there."""
    px, py, vx, vy, gx, gy = path
    # Most balls are far off along one of the axes, and that takes the fewest products.
    if stays_apart(px, vx, gx, reach, duration) or stays_apart(py, vy, gy, reach, duration):
        return True
    away = px * px + py * py
    height = away - reach * reach
    if height < -GRAZING * reach * reach:
        return False
    # The squared distance without its fourth power, and with t³ replaced by t²·duration where it is negative.
    speed_squared = vx * vx + vy * vy
    bend = speed_squared + px * gx + py * gy
    drift = dot(vx, vy, gx, gy)
    if drift < 0.0:
        bend += drift * duration
    span = path_size(away + reach * reach, speed_squared, gx * gx + gy * gy, duration)
    return stays_above(height, 2.0 * dot(px, py, vx, vy), bend, duration, span)


def stays_inside(path: Path, room: float, duration: float) -> bool:
    """Whether the centre clearly stays nearer than `room` to 0."""
    px, py, vx, vy, gx, gy = path
    away = px * px + py * py
    height = room * room - away
    if room <= 0.0 or height < -GRAZING * room * room:
        return False
    # Here the squared distance must not be too small: t⁴ is replaced by t²·duration², t³ by t²·duration where positive.
    speed_squared, pull_squared = vx * vx + vy * vy, gx * gx + gy * gy
    bend = speed_squared + px * gx + py * gy + 0.25 * pull_squared * duration * duration
    drift = dot(vx, vy, gx, gy)
    if drift > 0.0:
        bend += drift * duration
    span = path_size(away + room * room, speed_squared, pull_squared, duration)
    return stays_above(height, -2.0 * dot(px, py, vx, vy), -bend, duration, span)


def path_size(size: float, speed_squared: float, pull_squared: float, duration: float) -> float:
    """No less than the squares, of which `size` is the first ones' sum, whose rounding a squared distance has."""
    return size + (speed_squared + 0.25 * pull_squared * duration * duration) * duration * duration


def stays_above(height: float, rate: float, bend: float, duration: float, span: float) -> bool:
    """Whether height + rate·t + bend·t² is clearly above 0 for 0 < t <= duration; a negative height counts as 0.

    Clearly is by a share of `span`; but for what leaves at once, which is above 0 and rises first.
    """
    if height < 0.0:
        height = 0.0
    noise = GRAZING * span
    if not height + (rate + bend * duration) * duration > noise:
        return False
    # Concave, rising from the start, or falling to the end: then it is least at one of the ends.
    if rate >= 0.0:
        return True
    if bend <= 0.0 or -rate >= 2.0 * bend * duration:
        return height > noise
    # Else it is least at t = -rate/(2·bend), where it is height - rate²/(4·bend).
    return 4.0 * bend * (height - noise) > rate * rate


def escape_time(path: Path, reach: float) -> float:
    """A time after which the centre is farther than `reach` from 0 for good; below 0 if it is so from the start.

    It is farther off than that along the pull alone, by `ESCAPE_MARGIN`. Infinite without a pull.
    """
    px, py, vx, vy, gx, gy = path
    direction = unit(gx, gy)
    if direction is None:
        return inf
    ux, uy = direction
    pull, rate = dot(gx, gy, ux, uy), dot(vx, vy, ux, uy)
    room = ESCAPE_MARGIN * reach + GRAZING * (fabs(px) + fabs(py)) - dot(px, py, ux, uy)
    # The square of the rate at which it goes through that distance, as by the conservation of energy.
    rate_squared = rate * rate + 2.0 * pull * room
    if rate_squared < 0.0:
        return -1.0
    root = sqrt(rate_squared)
    if rate > 0.0:
        return 2.0 * room / (root + rate)
    return (root - rate) / pull


def fall_time(path: Path, radius: float, arc: CentredArc, whole: bool, duration: float) -> float | None:
    """When the ball touches the arc, or the whole of its circle."""
    px, py, _, _, _, _ = path
    r = arc.r
    away = px * px + py * py
    # A ball that overlaps now and leaves counts, if it never gets clear, when it is as near again as it is now.
    held = -1.0
    if fabs(sqrt(away) - r) <= radius and (whole or touches_arc(px, py, radius, arc)):
        held = away
    escape = escape_time(path, r + radius)
    if not 0.0 <= escape < inf:
        return None
    falls, turn1, turn2, turn3 = distance_turns(path, escape)
    low = 0.0
    for high in (turn1, turn2, turn3, escape):
        if low > duration:
            return None
        # A missing turn is at `escape`, and one from a standstill at 0: an empty stretch, after which the ball turns.
        if high > low:
            x, y = place_on(path, high)
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
                    time = level_time(path, level, low, high, falls)
                if whole:
                    return time_within(time, duration)
                touch = touch_in_sector(time, high, path, radius, arc)
                if touch is not None:
                    return time_within(0.0 + touch, duration)
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
    # It turned before it was clear.
    if held >= r * r:
        return held
    if away >= shallow * shallow:
        return away
    return -1.0


def inner_level(away: float, r: float, radius: float, held: float) -> float:
    """The same for a ball inside, whose squared distance from the centre rises; infinity at none."""
    inner, shallow = r - radius, r - radius + END_DEPTH_CONTINUOUS * radius
    # A ball that is larger than the circle (`inner` is 0 or less) is never clear of it inside.
    if inner > 0.0 and away < inner * inner:
        return inner * inner
    if 0.0 <= held <= r * r:
        return held
    if inner > 0.0 and away <= shallow * shallow:
        return away
    return inf


def distance_turns(path: Path, end: float) -> tuple[bool, float, float, float]:
    """Whether the distance from 0 falls at first, and the three times at which it turns, `end` if missing.

    They are the roots of p(t)·v(t), a cubic. A ball that at first neither leaves nor approaches, to rounding, does
    neither. A double root, where the distance does not turn, is left out or given twice.
    """
    px, py, vx, vy, gx, gy = path
    outward = dot(px, py, vx, vy)
    speed_squared = length_squared(vx, vy)
    if outward * outward <= APPROACH_ROUNDING_SQUARED * speed_squared * (px * px + py * py):
        outward = 0.0
    # (p + v·t + g·t²/2)·(v + g·t), by powers of t, has this derivative.
    drift, pull_squared = dot(vx, vy, gx, gy), gx * gx + gy * gy
    bend = speed_squared + px * gx + py * gy
    still1, still2 = quadratic_roots(1.5 * pull_squared, 3.0 * drift, bend, end)
    first, second, third = end, end, end
    count = 0
    low, value = 0.0, outward
    # Between two roots of the derivative it only falls or only rises, so a sign that changes tells of one root and no
    # more. Roots out of the range have been brought to its ends, where the stretches between them are empty.
    for high in (still1, still2, end):
        if not high > low:
            continue
        value_high, _ = outward_rate(path, high)
        if (value < 0.0) != (value_high < 0.0):
            turn = low  # to the bit, where the rate is zero there
            if value != 0.0:
                turn = turn_between(path, low, high, value, value_high)
            if count == 0:
                first = turn
            elif count == 1:
                second = turn
            else:
                third = turn
            count += 1
        low, value = high, value_high
    return outward < 0.0, first, second, third


def outward_rate(path: Path, time: float) -> tuple[float, float]:
    """Half the rate of change of the squared distance from 0 at a time, p·v, and its own rate of change.

    Taken from the place and the velocity then, not by powers of the time: where both are small, as at the end of a long
    flight, so is the rounding.
    """
    x, y, wx, wy, gx, gy = path_after(path, time)
    return x * wx + y * wy, wx * wx + wy * wy + x * gx + y * gy


def turn_between(path: Path, low: float, high: float, value_low: float, value_high: float) -> float:
    """When p·v, which has values of opposite signs at `low` and `high`, is zero in between; as `roots.root_between`."""
    # Newton starts where the tangent at 0 crosses zero, which is next to a turn that is much nearer to 0 than `high`;
    # else where a straight line between the ends does.
    outward, bend = outward_rate(path, 0.0)
    time = low + (high - low) * (value_low / (value_low - value_high))
    if bend != 0.0 and low < -outward / bend < high:
        time = -outward / bend
    if not low < time < high:
        time = low + 0.5 * (high - low)
    step = high - low
    for _ in range(ROOT_STEPS):
        value, slope = outward_rate(path, time)
        # The enclosure shrinks to where the sign still changes.
        if (value < 0.0) == (value_low < 0.0):
            low = time
        else:
            high = time
        following = newton_step(time, value, slope, low, high, step)
        step = following - time
        time = following
        if fabs(step) <= ROOT_TOLERANCE * fabs(time):
            break
    return time


def level_time(path: Path, level: float, low: float, high: float, falls: bool) -> float:
    """When the squared distance, which falls from `low` to `high`, or rises, gets through `level` in between.

    The quartic is set up from the end where the ball is nearer: there its coefficients are small numbers.
    """
    base = high if falls else low
    width = high - low
    x, y, wx, wy, gx, gy = path_after(path, base)
    c4, c3 = 0.25 * (gx * gx + gy * gy), dot(wx, wy, gx, gy)
    c2, c1, c0 = wx * wx + wy * wy + x * gx + y * gy, 2.0 * dot(x, y, wx, wy), x * x + y * y - level
    # Newton starts where the quadratic part alone crosses the level. Away from the base the distance grows, at first at
    # the rate |c1|, from below the level, where c0 < 0: so that is at the positive root of c2·t² + |c1|·t + c0.
    slope = fabs(c1)
    root_squared = slope * slope - 4.0 * c2 * c0
    guess = 0.5 * width
    if root_squared > 0.0:
        guess = -2.0 * c0 / (slope + sqrt(root_squared))
    quartic = Quartic(c4, c3, c2, c1, c0)
    if falls:
        time = base + root_between(quartic, -width, 0.0, False, -guess)
    else:
        time = base + root_between(quartic, 0.0, width, True, guess)
    return smaller(larger(level_polished(path, level, time), low), high)


def level_polished(path: Path, level: float, time: float) -> float:
    """The time, at which the squared distance is about `level`, after one more step by the place then.

    It takes away the rounding of the quartic of a touch far from where that was set up; nothing for a grazing touch.
    """
    x, y = place_on(path, time)
    outward, bend = outward_rate(path, time)
    excess = 0.5 * (x * x + y * y - level)
    # The next step would be that part of this one; where it is not small, the slope is of no use.
    if fabs(excess * bend) < 0.125 * outward * outward:
        return time - excess / outward
    return time
