"""Sums and products of doubles with what rounding takes from them: fractions say what is exact."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from carom.geometry.exact import exact_cross, exact_length_squared, exact_product, exact_sum

#: Of either sign, from far below 1 to far above it, and 0.
NUMBERS = st.floats(1e-60, 1e60) | st.floats(-1e60, -1e-60) | st.just(0.0)
#: As far as products neither overflow nor can be told from 0.
EXTREMES = st.floats(-1e150, 1e150)
#: What is left of two products, as a part of the larger of them.
LEFT = Fraction(2) ** -100


def whole(parts: tuple[float, float]) -> Fraction:
    """A sum of two doubles without rounding."""
    return Fraction(parts[0]) + Fraction(parts[1])


@given(NUMBERS, NUMBERS)
def test_a_sum_and_a_product_are_exact(a: float, b: float) -> None:
    assert whole(exact_sum(a, b)) == Fraction(a) + Fraction(b)
    assert exact_sum(a, b)[0] == a + b
    assert whole(exact_product(a, b)) == Fraction(a) * Fraction(b)
    assert exact_product(a, b)[0] == a * b


@given(EXTREMES, EXTREMES)
def test_at_any_magnitude_a_sum_is_exact_and_a_product_but_for_what_is_too_small_to_hold(a: float, b: float) -> None:
    assert whole(exact_sum(a, b)) == Fraction(a) + Fraction(b)
    assert abs(whole(exact_product(a, b)) - Fraction(a) * Fraction(b)) <= Fraction(5e-324) * 4


@given(NUMBERS, NUMBERS, NUMBERS, NUMBERS)
def test_a_cross_product_holds_twice_the_digits(ax: float, ay: float, bx: float, by: float) -> None:
    first, second = Fraction(ax) * Fraction(by), Fraction(ay) * Fraction(bx)
    assert abs(whole(exact_cross(ax, ay, bx, by)) - (first - second)) <= LEFT * max(abs(first), abs(second))


@given(NUMBERS, NUMBERS)
def test_a_square_holds_twice_the_digits(x: float, y: float) -> None:
    square = Fraction(x) ** 2 + Fraction(y) ** 2
    assert abs(whole(exact_length_squared(x, y)) - square) <= LEFT * square
