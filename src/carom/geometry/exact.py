"""Sums and products of doubles as two doubles each: the rounded one, and exactly what rounding has taken from it.

Sources: Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B (sums); Dekker, A floating-point technique
for extending the available precision, Numer. Math. 18 (1971) 224-242 (products).
"""

from __future__ import annotations

from carom.constants import SPLITTER


def exact_sum(a: float, b: float) -> tuple[float, float]:
    """The rounded `a + b`, and what the exact sum is more than that."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def exact_product(a: float, b: float) -> tuple[float, float]:
    """The rounded `a·b`, and what the exact product is more than that: for factors below 1e300, if not below 1e-308."""
    product = a * b
    wide = SPLITTER * a
    a_high = wide - (wide - a)
    a_low = a - a_high
    wide = SPLITTER * b
    b_high = wide - (wide - b)
    b_low = b - b_high
    return product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def exact_cross(ax: float, ay: float, bx: float, by: float) -> tuple[float, float]:
    """The cross product of two vectors and what rounding has taken from it, to 1e-32 of the larger product."""
    first, first_low = exact_product(ax, by)
    second, second_low = exact_product(ay, bx)
    total, low = exact_sum(first, -second)
    return total, low + (first_low - second_low)


def exact_length_squared(x: float, y: float) -> tuple[float, float]:
    """The square of a vector's length and what rounding has taken from it, to 1e-32 of it."""
    first, first_low = exact_product(x, x)
    second, second_low = exact_product(y, y)
    total, low = exact_sum(first, second)
    return total, low + (first_low + second_low)
