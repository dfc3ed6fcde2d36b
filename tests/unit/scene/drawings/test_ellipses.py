"""Pieces of ellipses from their ends, against their equations."""

from math import cos, hypot, pi, radians, sin, tan

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.scene.drawings.ellipses import between, bulged
from carom.scene.drawings.pieces import Conic, Straight, Vector

PLACES = st.tuples(st.floats(-10.0, 10.0), st.floats(-10.0, 10.0))
RADII = st.tuples(st.floats(0.5, 20.0), st.floats(0.5, 20.0))


def apart(a: Vector, b: Vector) -> float:
    """The distance of two places."""
    return hypot(a[0] - b[0], a[1] - b[1])


@given(PLACES, PLACES, RADII, st.floats(-360.0, 360.0), st.booleans(), st.booleans())
def test_an_arc_goes_from_end_to_end_on_an_ellipse_as_it_is_told(
    start: Vector, end: Vector, radii: Vector, turn: float, large: bool, onward: bool
) -> None:
    assume(apart(start, end) > 1e-3)
    piece = between(start, end, radii, turn, large=large, onward=onward)
    assert isinstance(piece, Conic)
    size = max(1.0, hypot(*piece.u), hypot(*piece.v))
    # A chord that nearly is a diameter fixes the centre to half of the digits, but the ends to all.
    assert apart(piece.start, start) <= 1e-13 * size * 100.0
    assert apart(piece.end, end) <= 1e-13 * size * 100.0
    assert (piece.sweep > 0.0) == onward
    grown = hypot(*piece.u) / radii[0]
    assert grown >= 1.0 - 1e-12
    assert abs(hypot(*piece.v) / radii[1] - grown) <= 1e-9 * grown
    if grown <= 1.0 + 1e-12:
        assert (abs(piece.sweep) >= pi - 1e-6) if large else (abs(piece.sweep) <= pi + 1e-6)
    assert abs(piece.u[0] * sin(radians(turn)) - piece.u[1] * cos(radians(turn))) <= 1e-9 * size


def test_half_a_turn_ends_where_it_must_to_the_last_digits() -> None:
    piece = between((1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), 0.0, large=False, onward=True)
    assert isinstance(piece, Conic)
    assert piece.sweep == pi
    assert apart(piece.at(piece.begin + 0.5 * piece.sweep), (0.0, 1.0)) < 1e-15


def test_without_a_radius_it_is_straight_and_without_a_way_nothing() -> None:
    assert between((0.0, 0.0), (1.0, 0.0), (0.0, 2.0), 0.0, large=True, onward=True) == Straight((0.0, 0.0), (1.0, 0.0))
    assert between((1.0, 0.0), (1.0, 0.0), (1.0, 2.0), 0.0, large=True, onward=True) is None


@given(PLACES, PLACES, st.floats(-5.0, 5.0))
def test_a_bulge_is_the_tangent_of_a_quarter_of_the_angle(start: Vector, end: Vector, bulge: float) -> None:
    assume(apart(start, end) > 1e-3 and abs(bulge) > 1e-3)
    piece = bulged(start, end, bulge)
    assert isinstance(piece, Conic)
    assert apart(piece.start, start) <= 1e-11 * piece.radius
    assert apart(piece.end, end) <= 1e-11 * piece.radius
    assert tan(0.25 * piece.sweep) == pytest.approx(bulge, rel=1e-12)
    # DXF reference: the height of the arc over its chord is bulge times half the chord, on its right.
    middle = piece.at(piece.begin + 0.5 * piece.sweep)
    dx, dy = end[0] - start[0], end[1] - start[1]
    right = 0.5 * (start[0] + end[0]) + 0.5 * bulge * dy, 0.5 * (start[1] + end[1]) - 0.5 * bulge * dx
    assert apart(middle, right) <= 1e-10 * piece.radius


def test_a_bulge_of_nothing_is_straight() -> None:
    assert bulged((0.0, 0.0), (1.0, 0.0), 0.0) == Straight((0.0, 0.0), (1.0, 0.0))
    assert bulged((1.0, 0.0), (1.0, 0.0), 0.5) is None
