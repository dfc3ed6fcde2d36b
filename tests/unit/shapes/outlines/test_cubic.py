"""Cubics: values, parts, and where they are slowest."""

from hypothesis import given
from hypothesis import strategies as st

from carom.shapes.outlines.cubic import Cubic, slowest

complexes = st.complex_numbers(max_magnitude=10.0, allow_nan=False, allow_subnormal=False)
cubics = st.builds(Cubic, complexes, complexes, complexes, complexes)
shares = st.floats(0.0, 1.0)


@given(cubics, shares)
def test_slopes_are_those_of_the_polynomial(cubic: Cubic, t: float) -> None:
    a, b, c, d = cubic
    powers = (a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c))
    assert abs(cubic.point(t) - sum(p * t**n for n, p in enumerate(powers))) < 1e-12
    assert abs(cubic.slope(t) - sum(n * p * t ** (n - 1) for n, p in enumerate(powers) if n)) < 1e-12
    assert abs(cubic.second(t) - (2 * powers[2] + 6 * powers[3] * t)) < 1e-12
    assert cubic.third() == 6 * powers[3]


@given(cubics, shares, shares, shares)
def test_a_part_and_the_halves_are_the_same_curve(cubic: Cubic, start: float, end: float, t: float) -> None:
    assert abs(cubic.part(start, end).point(t) - cubic.point(start + t * (end - start))) < 1e-12
    first, last = cubic.halves()
    assert abs(first.point(t) - cubic.point(0.5 * t)) < 1e-12
    assert abs(last.point(t) - cubic.point(0.5 + 0.5 * t)) < 1e-12


@given(cubics)
def test_no_place_is_slower_than_the_slowest(cubic: Cubic) -> None:
    least = min(abs(cubic.slope(t)) for t in slowest(cubic))
    assert all(abs(cubic.slope(index / 200)) >= least - 1e-9 for index in range(201))


def test_a_cusp_is_found_to_rounding() -> None:
    cusp = Cubic(0j, 1 + 1j, 0 + 1j, 1 + 0j)
    assert min(abs(cusp.slope(t)) for t in slowest(cusp)) < 1e-15
    assert slowest(Cubic(0j, 1 + 0j, 2 + 0j, 3 + 0j)) == [0.0, 1.0]
