"""Angles in radians, counterclockwise from +x."""

from __future__ import annotations

from math import cos, sin

from carom.constants import TWO_PI


def normalize_angle(angle: float) -> float:
    """The same direction's angle in [0, 2π), never 2π itself: an angle below 0 by less than its rounding gives 0.

    Angles already in the range come back unchanged. Others are reduced exactly by the double nearest to 2π.
    """
    result = angle % TWO_PI
    if result >= TWO_PI or result == 0.0:
        return 0.0
    return result


def sweep(start_angle: float, end_angle: float) -> float:
    """The angle in (0, 2π] from one normalized angle counterclockwise to another; a full turn for equal ones."""
    turn = end_angle - start_angle
    if turn <= 0.0:
        return turn + TWO_PI
    return turn


def direction(angle: float) -> tuple[float, float]:
    """The unit vector `(cos, sin)` of an angle."""
    return cos(angle), sin(angle)
