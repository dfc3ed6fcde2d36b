"""Vectors in the plane, as pairs of floats that are passed and returned one by one."""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import GREATEST_SQUARE, LEAST_SQUARE


def dot(ax: float, ay: float, bx: float, by: float) -> float:
    """The dot product of a and b."""
    return ax * bx + ay * by


def cross(ax: float, ay: float, bx: float, by: float) -> float:
    """The cross product of a and b: positive where b is counterclockwise of a."""
    return ax * by - ay * bx


def length_squared(x: float, y: float) -> float:
    """The squared length of a vector; 0 below 1e-162, infinity above 1e154, where `length` still holds."""
    return x * x + y * y


def length(x: float, y: float) -> float:
    """The length of a vector, to the last digit or two at any magnitude; 0 for the zero vector alone."""
    size_squared = x * x + y * y
    if LEAST_SQUARE < size_squared < GREATEST_SQUARE:
        return sqrt(size_squared)
    # Outside of that a square has lost digits or overflowed; scaled, the larger coordinate is 1.
    scale = larger(fabs(x), fabs(y))
    if scale == 0.0:
        return 0.0
    x = x / scale
    y = y / scale
    return scale * sqrt(x * x + y * y)


def unit(x: float, y: float) -> tuple[float, float] | None:
    """The vector of length 1 in the direction of (x, y), to the last digit or two; None for the zero vector."""
    # As in `length`: a square that is lost or overflows would leave a vector that is not of length 1, or none.
    size_squared = x * x + y * y
    if not LEAST_SQUARE < size_squared < GREATEST_SQUARE:
        scale = larger(fabs(x), fabs(y))
        if scale == 0.0:
            return None
        x = x / scale
        y = y / scale
        size_squared = x * x + y * y
    size = sqrt(size_squared)
    return x / size, y / size


def rotated(x: float, y: float, cos: float, sin: float) -> tuple[float, float]:
    """The vector turned counterclockwise by the angle whose cosine and sine are given."""
    return x * cos - y * sin, x * sin + y * cos


def rotated_about(px: float, py: float, cx: float, cy: float, cos: float, sin: float) -> tuple[float, float]:
    """The point p turned counterclockwise about c by the angle whose cosine and sine are given."""
    x, y = rotated(px - cx, py - cy, cos, sin)
    return cx + x, cy + y


def parallel_component(vx: float, vy: float, wx: float, wy: float) -> tuple[float, float] | None:
    """The part of v along w, `(v·ŵ)ŵ`; None where w is zero and has no direction."""
    direction = unit(wx, wy)
    if direction is None:
        return None
    ux, uy = direction
    along = dot(vx, vy, ux, uy)
    return along * ux, along * uy


def larger(a: float, b: float) -> float:
    """The larger of two numbers; the first of equals, 0 and -0 among them, where `max` and its compiled twin differ."""
    return b if b > a else a


def smaller(a: float, b: float) -> float:
    """The smaller of two numbers; the first of equals."""
    return b if b < a else a
