"""Small helpers on vectors, as pairs of numbers, and on angles, in radians."""

from __future__ import annotations

from math import cos, sin

from carom.checks import number, pair, refuse
from carom.geometry import angle as angles
from carom.geometry import vector as vectors
from carom.typing import Pair, Vector


def normalize_angle(a: float) -> float:
    """The angle `a` brought to [0, 2π); never 2π itself: an angle below 0 by less than its rounding gives 0.

    >>> normalize_angle(-1e-17)
    0.0
    """
    return angles.normalize_angle(number("a", a))


def normalize(v: Pair) -> Vector:
    """The unit vector in the direction of `v`. Raises `InvalidArgument` for a zero vector.

    >>> normalize((0, -5))
    (0.0, -1.0)
    """
    result = vectors.unit(*pair("v", v))
    if result is None:
        raise refuse("v", "must not be zero", v)
    return result


def perp(v: Pair) -> Vector:
    """The vector `v` turned counterclockwise by a right angle: `(-y, x)`.

    >>> perp((3, 4))
    (-4.0, 3.0)
    """
    x, y = pair("v", v)
    return 0.0 - y, x  # not -y, which would make -0 of 0


def angle_to_vector(a: float) -> Vector:
    """The unit vector `(cos a, sin a)`."""
    return angles.direction(number("a", a))


def rotate_point(p: Pair, center: Pair, a: float) -> Vector:
    """The point `p` turned counterclockwise by `a` radians about `center`."""
    turn = number("a", a)
    return vectors.rotated_about(*pair("p", p), *pair("center", center), cos(turn), sin(turn))


def parallel_component(v: Pair, w: Pair) -> Vector:
    """The part of `v` along `w`: `(v·ŵ)ŵ`. Raises `InvalidArgument` where `w` is zero.

    >>> parallel_component((3, 4), (0, 2))
    (0.0, 4.0)
    """
    result = vectors.parallel_component(*pair("v", v), *pair("w", w))
    if result is None:
        raise refuse("w", "must not be zero", w)
    return result
