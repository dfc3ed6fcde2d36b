"""The search for the first touch of a moving ball with a turning shape: conservative advancement of second order.

In the frame that turns with the shape, about its pivot, the shape stands still, and a ball at p(t) = p + v·t + g·t²/2
from the pivot is at q = R(-ωt)·p(t). Its gap f is a smooth function of q, by `form`:

- LINE: k·q - level, the distance from a line of unit normal k;
- OUTER: the distance from a circle about k, from outside: |q - k| - level, and for a centre inside
  (|q - k|² - level²)/(2·level), which continues it smoothly;
- INNER: the same from inside, so with the opposite sign.

With speeds |q'| <= V and accelerations |q''| <= A, f'' >= -M: M is A for the first two, for the curvature of a circle
only adds to its distance, and A + V²/level for the third. So from a time where the gap is f and changes at the rate f',
it stays above -ε for as long as f + ε + f'·τ - M·τ²/2 >= 0. Each step goes to the end of that; where it finds the gap
below 0 and falling, the crossing is enclosed, and safeguarded Newton finds it to the last digits.

The search ends. If f'' <= M' too, a step of length τ from f' < 0 leaves f + ε <= (M + M')·τ²/2, so below ε, with the
gap below 0, if τ < √(2ε/(M + M')); and from f' >= 0 each step is at least √(2ε/M) long. So there are no more than
2 + duration·√((M + M')/(2ε)) steps; near a crossing each squares the error. A gap below 0 that has to rise first is
followed likewise, with the opposite signs. Source: Mirtich, Impulse-based Dynamic Simulation (1996), 2.3, for the first
order.
"""

from __future__ import annotations

from math import cos, fabs, inf, sin, sqrt

from carom.constants import APPROACH_ROUNDING, ROOT_STEPS, ROOT_TOLERANCE, TURN_STEPS
from carom.geometry.vector import larger, smaller

LINE = 0
OUTER = 1
INNER = 2


def seen_place(
    time: float, px: float, py: float, vx: float, vy: float, gx: float, gy: float, spin: float
) -> tuple[float, float, float, float]:
    """Where the ball is and how fast it moves as seen from the turning shape, as (qx, qy, q'x, q'y)."""
    x, y = px + (vx + 0.5 * gx * time) * time, py + (vy + 0.5 * gy * time) * time
    wx, wy = vx + gx * time + spin * y, vy + gy * time - spin * x
    if time == 0.0:
        return x, y, wx, wy
    c, s = cos(spin * time), sin(spin * time)
    return c * x + s * y, c * y - s * x, c * wx + s * wy, c * wy - s * wx


def seen_gap(
    time: float,
    form: int,
    kx: float,
    ky: float,
    level: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
) -> tuple[float, float]:
    """The gap and its rate of change; `level` is above 0 unless the form is LINE."""
    x, y, wx, wy = seen_place(time, px, py, vx, vy, gx, gy, spin)
    if form == LINE:
        return kx * x + ky * y - level, kx * wx + ky * wy
    x, y = x - kx, y - ky
    squared, outward = x * x + y * y, x * wx + y * wy
    if squared > level * level:
        away = sqrt(squared)
        gap, rate = away - level, outward / away
    else:
        gap, rate = 0.5 * (squared / level - level), outward / level
    if form == INNER:
        return -gap, -rate
    return gap, rate


def seen_bounds(
    px: float, py: float, vx: float, vy: float, gx: float, gy: float, spin: float, duration: float
) -> tuple[float, float]:
    """Bounds (V, A) of the ball's speed and acceleration within the duration as seen from the turning shape."""
    pull, turn = sqrt(gx * gx + gy * gy), fabs(spin)
    speed = sqrt(vx * vx + vy * vy) + pull * duration
    reach = sqrt(px * px + py * py) + speed * duration
    return speed + turn * reach, pull + turn * (2.0 * speed + turn * reach)


def seen_bends(form: int, level: float, v: float, a: float) -> tuple[float, float]:
    """Bounds of the gap's second derivative: above minus the first while it is above 0, below the second else."""
    if form == INNER:
        return a + v * (v / level), a
    if form == OUTER:
        return a, a + v * (v / level)
    return a, a


def next_fall(
    start: float,
    held: bool,
    depth: float,
    form: int,
    kx: float,
    ky: float,
    level: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
    duration: float,
) -> float | None:
    """The first time from `start` on at which the gap falls through zero; None if it does not within `duration`.

    A gap of zero or less at the start counts, if it is `held`, as soon as it gets smaller than it is; else it has to
    rise above zero first. A fall, or a rise, by less than `depth` that ends by itself may go unseen. After too many
    steps the time reached so far is returned, from which one may go on.
    """
    v, a = seen_bounds(px, py, vx, vy, gx, gy, spin, duration)
    bend_fall, bend_rise = seen_bends(form, level, v, a)
    gap, rate = seen_gap(start, form, kx, ky, level, px, py, vx, vy, gx, gy, spin)
    floor = 0.0
    if gap <= 0.0 and held:
        if rate < -APPROACH_ROUNDING * v:
            return start
        floor = gap
    time = start
    for _ in range(TURN_STEPS):
        if gap > 0.0:
            floor, held = 0.0, True
        if held:
            height = larger(gap - floor, 0.0)
            following = time + safe_step(height + depth, rate, bend_fall)
        else:
            height = -gap
            following = time + safe_step(height + depth, -rate, bend_rise)
        if not following > time:
            return None
        if following >= duration:
            if not held or height > v * (duration - time):
                return None
            following = duration
        gap, rate = seen_gap(following, form, kx, ky, level, px, py, vx, vy, gx, gy, spin)
        if held and gap <= floor and rate < 0.0:
            return fall_between(time, following, floor, form, kx, ky, level, px, py, vx, vy, gx, gy, spin)
        if following >= duration:
            return None
        time = following
    return time


def safe_step(gap: float, rate: float, bend: float) -> float:
    """How long gap + rate·t - bend·t²/2 stays above zero; `gap` is above zero, `bend` not below it."""
    root = sqrt(rate * rate + 2.0 * bend * gap)
    if rate < 0.0:
        return 2.0 * gap / (root - rate)
    if bend > 0.0:
        return (rate + root) / bend
    return inf


def fall_between(
    low: float,
    high: float,
    floor: float,
    form: int,
    kx: float,
    ky: float,
    level: float,
    px: float,
    py: float,
    vx: float,
    vy: float,
    gx: float,
    gy: float,
    spin: float,
) -> float:
    """When the gap, above `floor` after `low` and not above it at `high`, falls through it; as `roots.root_between`."""
    time = high
    step = high - low
    tolerance = ROOT_TOLERANCE * high
    for _ in range(ROOT_STEPS):
        gap, rate = seen_gap(time, form, kx, ky, level, px, py, vx, vy, gx, gy, spin)
        value = gap - floor
        if value > 0.0:
            low = time
        else:
            high = time
        following = low + 0.5 * (high - low)
        if 2.0 * fabs(value) < fabs(rate * step):
            following = smaller(larger(time - value / rate, low), high)
        step = following - time
        time = following
        if fabs(step) <= tolerance:
            break
    return time
