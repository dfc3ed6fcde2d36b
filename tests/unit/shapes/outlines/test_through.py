"""Biarcs through places: through each that they must, past all others within the tolerance."""

import itertools
from cmath import exp, phase
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.shapes.outlines.through import between, through

ways = st.floats(-pi, pi).map(lambda angle: exp(1j * angle))


@given(ways, ways)
def test_there_is_a_way_between_any_two_directions(out: complex, into: complex) -> None:
    bows = between(0j, out, 1 + 0j, into)
    assert (bows[0].start, bows[0].out, bows[-1].end, bows[-1].into) == (0j, out, 1 + 0j, into)
    assert all((a.end, a.into) == (b.start, b.out) for a, b in itertools.pairwise(bows))
    for bow in bows:
        assert abs(bow.end) < 25.0
        chord = bow.end - bow.start
        assert abs(chord) < 1e-9 or abs(phase(bow.out * bow.into / (chord * chord))) < 1e-6


def test_places_on_one_circle_are_passed_by_one_biarc() -> None:
    spots = [exp(0.01j * index) for index in range(200)]
    bows = through(spots, [1j * spot for spot in spots], 1e-12)
    assert len(bows) == 2
    assert [bow.curvature for bow in bows] == pytest.approx([1.0, 1.0])


def test_without_a_tolerance_every_place_is_a_joint() -> None:
    spots = [complex(x, x**3) for x in (-2.0, -1.0, 0.5, 1.0, 2.0)]
    bows = through(
        spots, [complex(1.0, 3.0 * spot.real**2) / abs(complex(1.0, 3.0 * spot.real**2)) for spot in spots], 0.0
    )
    assert {spots[0], *(bow.end for bow in bows)} >= set(spots)
