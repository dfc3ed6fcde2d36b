"""Many curves followed at once: the very arcs that each is followed by alone."""

import random

import pytest

from carom.shapes.outlines.abreast import FEW, follow_abreast
from carom.shapes.outlines.bow import Bow
from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.following import follow
from carom.shapes.outlines.track import Track, tracks


def some_tracks(count: int) -> list[Track]:
    """Curves of all sorts, parted at their cusps: wild ones, gentle ones, short ones, some with legs of no length."""
    source, found = random.Random(3), []
    for number in range(count):
        size = 1.0 if number % 4 else 1e-3
        places = [size * complex(source.uniform(-1, 1), source.uniform(-1, 1)) for _ in range(4)]
        if number % 3 == 0:
            places = [complex(step + source.uniform(-0.1, 0.1), source.uniform(-0.1, 0.1)) / 3.0 for step in range(4)]
        if number % 11 == 0:
            places[1] = places[0]
        found += tracks([Cubic(*places)])
    return found


def bits(bows: list[Bow]) -> list[tuple[complex, ...]]:
    """The numbers of arcs, to be compared to the last bit."""
    return [tuple(bow) for bow in bows]


@pytest.mark.parametrize("tolerance", [0.3, 1e-2, 1e-4])
def test_curves_abreast_become_the_arcs_that_they_become_alone(tolerance: float) -> None:
    given = some_tracks(120)
    tolerances = [tolerance * (1.0 + 0.1 * (number % 5)) for number in range(len(given))]
    found = follow_abreast(given, tolerances)
    alone = [follow(track, within) for track, within in zip(given, tolerances, strict=True)]
    known = [(bows, expected) for bows, expected in zip(found, alone, strict=True) if bows is not None]
    assert len(known) >= len(given) - FEW
    assert all(bits(bows) == bits(expected) for bows, expected in known)


def test_few_curves_and_rare_ones_are_left_to_be_followed_alone() -> None:
    few = some_tracks(5)
    assert follow_abreast(few, [0.1] * len(few)) == [None] * len(few)
    assert follow_abreast([], []) == []
    tiny = Track([Cubic(0j, 1e-150 + 0j, 2e-150 + 1e-150j, 3e-150 + 0j)], 1 + 0j, (1 - 1j) / abs(1 - 1j))
    many = [tiny, *some_tracks(2 * FEW)]
    found = follow_abreast(many, [0.1] * len(many))
    assert found[0] is None
    assert any(found)
