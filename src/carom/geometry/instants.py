"""Instants: times of the world as normalised sums of two doubles, `time` and `low`.

A double that counts seconds since the world was made loses digits as it grows: after a year its last digit is 4e-9 s.
The sum of two holds twice as many, so an impact is as exact at any age, whatever the steps that led to it.
Source: Dekker, A floating-point technique for extending the available precision (1971), add2.
"""

from __future__ import annotations

from math import fabs

from carom.geometry.exact import exact_sum

#: Relative to an instant: two units in the last place of the second double, which is half a unit of the first at most.
RESOLUTION = 5e-32


def later(time: float, low: float, seconds: float) -> tuple[float, float]:
    """The instant so many seconds after another."""
    total, lost = exact_sum(time, seconds)
    lost += low
    high = total + lost
    return high, lost - (high - total)


def resolution(time: float) -> float:
    """Seconds that tell any instant at a time from the one that is so much later; fewer may not."""
    return RESOLUTION * fabs(time)


def seconds_since(time: float, low: float, from_time: float, from_low: float) -> float:
    """The seconds from one instant to another; negative if it comes before."""
    return (time - from_time) + (low - from_low)


def is_before(time: float, low: float, other_time: float, other_low: float) -> bool:
    """True if an instant comes before another."""
    return time < other_time or (time == other_time and low < other_low)
