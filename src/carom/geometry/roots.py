"""Real roots of polynomials within a stretch of time, none lost and none made up.

A quadratic is solved in closed form, without cancellation. The roots of higher ones are enclosed between those of their
derivatives: between two neighbouring roots of the derivative a polynomial is monotone, so its sign at the two ends
tells whether there is a root, and safeguarded Newton finds it. Coefficients come highest first.
Source: Press et al., Numerical Recipes, 3rd ed., 5.6 (quadratics) and 9.4 (rtsafe).
"""

from math import copysign, fabs, inf, sqrt
from typing import NamedTuple

from carom.constants import ROOT_STEPS, ROOT_TOLERANCE
from carom.geometry.vector import larger, smaller


class Quartic(NamedTuple):
    """The polynomial c4·t⁴ + c3·t³ + c2·t² + c1·t + c0."""

    c4: float
    c3: float
    c2: float
    c1: float
    c0: float


def time_within(time: float, duration: float) -> float | None:
    """The time, if it is no later than `duration`, which may be infinite; None for one later, infinite or NaN."""
    if time <= duration and time < inf:
        return time
    return None


def falling_time(height: float, rate: float, acceleration: float) -> float | None:
    """The first time, from 0 on, at which height + rate·t + acceleration·t²/2 falls through zero; None if never.

    From a height of zero or less it has to rise above zero first. A height that only grazes zero does not fall
    through it. Neither of the two forms of the root adds numbers of opposite signs.
    """
    # The square of the rate where the height is zero, as by the conservation of energy.
    rate_squared = rate * rate - 2.0 * acceleration * height
    if not rate_squared > 0.0:
        return None
    root = sqrt(rate_squared)
    # It falls through the zero where the rate is -root.
    if rate > 0.0:
        if acceleration >= 0.0:
            return None
        return (rate + root) / (0.0 - acceleration)
    if height <= 0.0:
        return None
    # The same time, multiplied above and below by root - rate: in this form it holds without acceleration too.
    return 2.0 * height / (root - rate)


def quadratic_roots(c2: float, c1: float, c0: float, end: float) -> tuple[float, float]:
    """The two real roots of c2·t² + c1·t + c0 in ascending order, each brought into [0, end].

    Both are `end` where it has none, or a double one, where its sign does not change. The second root of a line
    counts as infinitely early or late.
    """
    discriminant = c1 * c1 - 4.0 * c2 * c0
    if not discriminant > 0.0:
        return end, end
    # The sum of two numbers of one sign loses no digits; the other root follows from the product of both, c0/c2.
    half_sum = -0.5 * (c1 + copysign(sqrt(discriminant), c1))
    first = clipped_ratio(half_sum, c2, end)
    second = clipped_ratio(c0, half_sum, end)
    if first <= second:
        return first, second
    return second, first


def clipped_ratio(numerator: float, denominator: float, limit: float) -> float:
    """numerator/denominator brought into [0, limit]; `limit` for a positive number over zero."""
    if denominator < 0.0:
        numerator, denominator = -numerator, -denominator
    if not numerator > 0.0:
        return 0.0
    if numerator >= denominator * limit:
        return limit
    return numerator / denominator


def root_between(quartic: Quartic, low: float, high: float, rising: bool, guess: float) -> float:
    """The root of a quartic that changes sign once between `low` and `high`, from below if `rising`.

    Steps from `guess` by `newton_step`. The error is that of evaluating the polynomial at the root.
    """
    c4, c3, c2, c1, c0 = quartic
    # A guess from a part of the polynomial may be anywhere.
    time = guess
    if not low < time < high:
        time = low + 0.5 * (high - low)
    step = high - low
    for _ in range(ROOT_STEPS):
        value = (((c4 * time + c3) * time + c2) * time + c1) * time + c0
        slope = ((4.0 * c4 * time + 3.0 * c3) * time + 2.0 * c2) * time + c1
        # The enclosure shrinks to where the sign still changes.
        if (value < 0.0) == rising:
            low = time
        else:
            high = time
        following = newton_step(time, value, slope, low, high, step)
        step = following - time
        time = following
        if fabs(step) <= ROOT_TOLERANCE * fabs(time):
            break
    return time


def newton_step(time: float, value: float, slope: float, low: float, high: float, step: float) -> float:
    """Where to look next for the root between `low` and `high` of what has a value and a slope at `time`.

    Newton's step, which ends at the enclosure's ends. One that is not half as long as the last `step`, or that leads
    out of the enclosure from its end, gives way to halving the enclosure, so the search always ends, and at a root.
    """
    if 2.0 * fabs(value) < fabs(slope * step):
        way = value / slope
        following = smaller(larger(time - way, low), high)
        if following != time or fabs(way) <= ROOT_TOLERANCE * fabs(time):
            return following
    return low + 0.5 * (high - low)
