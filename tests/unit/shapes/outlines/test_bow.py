"""Arcs on their way: distances, and whether a cubic keeps to one."""

from cmath import exp, phase
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.shapes.outlines.bow import Bow, biarc, largest_radius
from carom.shapes.outlines.cubic import Cubic


def arc(radius: float, turn: float) -> Bow:
    """An arc from the origin that leaves along +x."""
    side = 1j if turn > 0.0 else -1j
    end = radius * side * (1.0 - exp(1j * turn))
    return Bow(0j, 1 + 0j, (1.0 if turn > 0.0 else -1.0) / radius, end, exp(1j * turn))


radii = st.floats(0.1, 100.0)
turns = st.floats(0.01, 3.0) | st.floats(-3.0, -0.01)


@given(radii, turns, st.floats(0.0, 1.0), st.floats(-0.9, 2.0))
def test_the_distance_of_what_lies_off_to_a_side_is_how_far(
    radius: float, turn: float, share: float, off: float
) -> None:
    bow = arc(radius, turn)
    side = 1j if turn > 0.0 else -1j
    place = side * radius * (1.0 - (1.0 + off) * exp(1j * turn * share))
    assert bow.distance(place) == pytest.approx(abs(off) * radius, rel=1e-9, abs=1e-12 * radius)
    assert bow.side(place) * (1.0 if turn > 0.0 else -1.0) == pytest.approx(-off * radius, rel=1e-9, abs=1e-12 * radius)


def test_past_an_end_the_distance_is_that_of_the_end() -> None:
    assert arc(2.0, 1.0).distance(-3 - 4j) == 5.0
    wide = Bow(0j, 1 + 0j, 1.0, 1j * (1.0 - exp(5j)), exp(5j))
    assert wide.distance(1j * (1.0 - 1.5 * exp(4j))) == pytest.approx(0.5)


@given(radii, st.floats(0.01, 1.2), st.floats(0.5, 2.0))
def test_a_cubic_follows_iff_it_is_within_the_room(radius: float, turn: float, factor: float) -> None:
    bow = arc(radius, turn)
    leg = factor * radius * 4.0 / 3.0 * abs(complex(turn / 4.0))
    cubic = Cubic(0j, leg + 0j, bow.end - leg * bow.into, bow.end)
    worst = max(abs(bow.side(cubic.point(index / 400))) for index in range(401))
    assert bow.follows(cubic, 1.02 * worst + 1e-12)
    assert worst < 1e-9 or not bow.follows(cubic, 0.98 * worst)


def test_a_cubic_that_goes_past_the_ends_or_the_other_way_round_does_not_follow() -> None:
    bow = Bow(0j, 1 + 0j, 0.0, 1 + 0j, 1 + 0j)
    assert bow.follows(Cubic(0j, 0.3 + 0j, 0.6 + 0j, 1 + 0j), 1e-3)
    assert not bow.follows(Cubic(0j, -0.5 + 0j, 0.6 + 0j, 1 + 0j), 1e-3)
    assert not bow.follows(Cubic(0j, 0.3 + 0j, 1.5 + 0j, 1 + 0j), 1e-3)


def test_what_is_built_in_place_of_an_enormous_arc_takes_room() -> None:
    assert arc(1.0, 0.5).room(1e-6) == pytest.approx(1e-6, rel=1e-6)
    flat = Bow(0j, 1 + 0j, 1e-7, 1 + 5e-8j, exp(1e-7j))
    assert flat.room(1e-6) < 1e-6 - 1e-8
    assert largest_radius(1e-9) * 1e-15 <= 1e-10


@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
def test_a_biarc_goes_from_end_to_end_without_a_bend(out: float, into: float) -> None:
    bows = biarc(1 + 1j, exp(1j * out), 3 + 1j, exp(1j * into))
    assert bows is not None
    first, last = bows
    assert (first.start, last.end, first.end, first.into) == (1 + 1j, 3 + 1j, last.start, last.out)
    for bow in bows:
        chord = bow.end - bow.start
        assert abs(phase(bow.out * bow.into / (chord * chord))) < 1e-9
        assert bow.side(bow.end) == pytest.approx(0.0, abs=1e-12)
        assert -pi < bow.turn < pi


def test_the_reach_of_more_than_half_a_turn_is_across_it() -> None:
    assert arc(1.0, 1.0).reach() == pytest.approx(abs(1.0 - exp(1j)))
    assert Bow(0j, 1 + 0j, 1.0, 1j * (1.0 - exp(5j)), exp(5j)).reach() == 2.0
