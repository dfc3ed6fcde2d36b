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
2 + duration·√((M + M')/(2ε)) steps; near a crossing each squares the error. V and A, and so the steps and the last bits
of what they lead to, depend on the `duration`; without end there is no bound, and nothing is found. A gap below 0 that
has to rise first is followed likewise, with the opposite signs. Source: Mirtich, Impulse-based Dynamic Simulation
(1996), 2.3, for the first order.
"""

from math import cos, fabs, inf, sin, sqrt
from typing import NamedTuple

from carom.constants import APPROACH_ROUNDING, ROOT_STEPS, ROOT_TOLERANCE, TURN_STEPS
from carom.geometry.path import Path, path_after
from carom.geometry.roots import newton_step
from carom.geometry.vector import larger

LINE = 0
OUTER = 1
INNER = 2


class Edge(NamedTuple):
    """What a ball's gap is measured from: k and `level` by `form`; `level` is above 0 unless the form is LINE."""

    form: int
    kx: float
    ky: float
    level: float


class SeenPath(NamedTuple):
    """A ball's path relative to the pivot of a shape that turns with the angular velocity `spin`."""

    path: Path
    spin: float


def seen_start(seen: SeenPath) -> tuple[float, float, float, float]:
    """Where the ball is at first and how fast it moves as seen from the turning shape, as (qx, qy, q'x, q'y)."""
    (x, y, vx, vy, _, _), spin = seen
    # What stands still seems to turn the other way: with -ω·perp(p).
    return x, y, vx + spin * y, vy - spin * x


def seen_place(time: float, seen: SeenPath) -> tuple[float, float, float, float]:
    """The same at a time."""
    path, spin = seen
    x, y, wx, wy = seen_start(SeenPath(path_after(path, time), spin))
    if time == 0.0:
        return x, y, wx, wy
    # R(-ωt), of the place and of the velocity alike.
    c, s = cos(spin * time), sin(spin * time)
    return c * x + s * y, c * y - s * x, c * wx + s * wy, c * wy - s * wx


def seen_gap(time: float, edge: Edge, seen: SeenPath) -> tuple[float, float]:
    """The gap and its rate of change."""
    form, kx, ky, level = edge
    x, y, wx, wy = seen_place(time, seen)
    if form == LINE:
        return kx * x + ky * y - level, kx * wx + ky * wy
    x, y = x - kx, y - ky
    away_squared, outward = x * x + y * y, x * wx + y * wy
    if away_squared > level * level:
        away = sqrt(away_squared)
        gap, rate = away - level, outward / away
    else:
        # The distance itself has a kink at k, and no second derivative; this has the same value and slope at `level`.
        gap, rate = 0.5 * (away_squared / level - level), outward / level
    if form == INNER:
        return -gap, -rate
    return gap, rate


def seen_bounds(seen: SeenPath, duration: float) -> tuple[float, float]:
    """Bounds (V, A) of the ball's speed and acceleration within the duration as seen from the turning shape."""
    (px, py, vx, vy, gx, gy), spin = seen
    pull, turn = sqrt(gx * gx + gy * gy), fabs(spin)
    speed = sqrt(vx * vx + vy * vy) + pull * duration
    distance = sqrt(px * px + py * py) + speed * duration
    # q' is v and the turning of the frame, q'' is g and the two accelerations that the frame adds: 2ωv and ω²p.
    return speed + turn * distance, pull + turn * (2.0 * speed + turn * distance)


def seen_bends(form: int, level: float, v: float, a: float) -> tuple[float, float]:
    """Bounds of the gap's second derivative: above minus the first while it is above 0, below the second else."""
    # |q|'' is q''·n + (q'² - (q'·n)²)/|q| with n = q/|q|: from -A to A + V²/level outside of the circle. Inside of it
    # (q² - level²)/(2·level) has (q'² + q·q'')/level, within the same bounds. From inside all changes its sign.
    if form == INNER:
        return a + v * (v / level), a
    if form == OUTER:
        return a, a + v * (v / level)
    return a, a


def next_fall(start: float, held: bool, depth: float, edge: Edge, seen: SeenPath, duration: float) -> float | None:
    """The first time from `start` on at which the gap falls through zero; None if it does not within `duration`.

    A gap of zero or less at the start counts, if it is `held`, as soon as it gets smaller than it is; else it has to
    rise above zero first. A fall, or a rise, by less than `depth` that ends by itself may go unseen. After too many
    steps the time reached so far is returned, from which one may go on.
    """
    v, a = seen_bounds(seen, duration)
    bend_fall, bend_rise = seen_bends(edge.form, edge.level, v, a)
    gap, rate = seen_gap(start, edge, seen)
    floor = 0.0
    if gap <= 0.0 and held:
        # The rate has the rounding of the velocities that it is the difference of.
        if rate < -APPROACH_ROUNDING * v:
            return start
        # What overlaps already counts when it gets deeper than it is, as long as it does not get clear before.
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
        # The step is lost to the rounding of the time, or no number: there is nothing more to be found.
        if not following > time:
            return None
        if following >= duration:
            # What has not risen cannot fall, and no height is lost faster than at the greatest speed.
            if not held or height > v * (duration - time):
                return None
            following = duration
        gap, rate = seen_gap(following, edge, seen)
        if held and gap <= floor and rate < 0.0:
            return fall_between(time, following, floor, edge, seen)
        if following >= duration:
            return None
        time = following
    return time


def safe_step(gap: float, rate: float, bend: float) -> float:
    """How long gap + rate·t - bend·t²/2 stays above zero; `gap` is above zero, `bend` not below it."""
    root = sqrt(rate * rate + 2.0 * bend * gap)
    # The positive root, in the form that adds numbers of one sign.
    if rate < 0.0:
        return 2.0 * gap / (root - rate)
    if bend > 0.0:
        return (rate + root) / bend
    return inf


def fall_between(low: float, high: float, floor: float, edge: Edge, seen: SeenPath) -> float:
    """When the gap, above `floor` after `low` and not above it at `high`, falls through it; as `roots.root_between`."""
    # From the end that has fallen: near a crossing the last step of the search has ended just behind it.
    time = high
    step = high - low
    tolerance = ROOT_TOLERANCE * high
    for _ in range(ROOT_STEPS):
        gap, rate = seen_gap(time, edge, seen)
        value = gap - floor
        if value > 0.0:
            low = time
        else:
            high = time
        following = newton_step(time, value, rate, low, high, step)
        step = following - time
        time = following
        if fabs(step) <= tolerance:
            break
    return time
