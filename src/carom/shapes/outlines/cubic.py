"""Cubic Bézier curves in the plane, their places as complex numbers: values, slopes, parts and cusps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Cubic(NamedTuple):
    """A cubic by its four control points; t goes from 0 to 1."""

    a: complex
    b: complex
    c: complex
    d: complex

    def point(self, t: float) -> complex:
        """The place at t."""
        s = 1.0 - t
        return s * s * (s * self.a + 3.0 * t * self.b) + t * t * (3.0 * s * self.c + t * self.d)

    def slope(self, t: float) -> complex:
        """The derivative by t."""
        s = 1.0 - t
        return 3.0 * (s * s * (self.b - self.a) + 2.0 * s * t * (self.c - self.b) + t * t * (self.d - self.c))

    def second(self, t: float) -> complex:
        """The second derivative by t."""
        return 6.0 * ((1.0 - t) * (self.a - 2.0 * self.b + self.c) + t * (self.b - 2.0 * self.c + self.d))

    def third(self) -> complex:
        """The third derivative."""
        return 6.0 * (self.d - self.a + 3.0 * (self.b - self.c))

    def halves(self) -> tuple[Cubic, Cubic]:
        """The parts before and after t = 1/2. Source: de Casteljau."""
        ab, bc, cd = 0.5 * (self.a + self.b), 0.5 * (self.b + self.c), 0.5 * (self.c + self.d)
        abc, bcd = 0.5 * (ab + bc), 0.5 * (bc + cd)
        middle = 0.5 * (abc + bcd)
        return Cubic(self.a, ab, abc, middle), Cubic(middle, bcd, cd, self.d)

    def part(self, start: float, end: float) -> Cubic:
        """The part from one t to a later one, as a cubic of its own."""
        third = (end - start) / 3.0
        first, last = self.point(start), self.point(end)
        return Cubic(first, first + third * self.slope(start), last - third * self.slope(end), last)

    def size(self) -> float:
        """How long its control polygon is: the curve is no longer."""
        return abs(self.b - self.a) + abs(self.c - self.b) + abs(self.d - self.c)


def slowest(cubic: Cubic) -> list[float]:
    """The places t where its speed is least or most, ascending, the ends among them; more than there are do no harm.

    There the slope and the second derivative are at right angles: a root of a polynomial of degree 3.
    """
    first = (3.0 * (cubic.b - cubic.a), 6.0 * (cubic.a - 2.0 * cubic.b + cubic.c), 0.5 * cubic.third())
    second = (first[1], 2.0 * first[2])
    products = [0.0, 0.0, 0.0, 0.0]
    for i, slope in enumerate(first):
        for j, bend in enumerate(second):
            products[3 - i - j] += slope.real * bend.real + slope.imag * bend.imag
    most = max(map(abs, products))
    if most == 0.0:
        return [0.0, 1.0]
    roots = np.roots([value if abs(value) > 1e-14 * most else 0.0 for value in products])
    found = {0.0, 1.0}
    for root in roots.real.tolist():
        t = min(max(root, 0.0), 1.0)
        for _ in range(3):
            t = _nearer(cubic, t)
        found.add(t)
    return sorted(found)


def _nearer(cubic: Cubic, t: float) -> float:
    """One step of Newton's method from t to where the slope and the second derivative are at right angles."""
    slope, second = cubic.slope(t), cubic.second(t)
    value = dot(slope, second)
    rate = dot(second, second) + dot(slope, cubic.third())
    return min(max(t - value / rate, 0.0), 1.0) if rate > 0.0 else t


def dot(a: complex, b: complex) -> float:
    """The dot product of two vectors."""
    return a.real * b.real + a.imag * b.imag


def cross(a: complex, b: complex) -> float:
    """The cross product of two vectors: positive where b is counterclockwise of a."""
    return a.real * b.imag - a.imag * b.real
