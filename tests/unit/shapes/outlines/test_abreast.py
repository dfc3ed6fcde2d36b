"""Many curves followed at once: the very arcs that each is followed by alone."""

import random

import pytest

from carom.shapes.outlines.abreast import FEW, are_brisk, follow_abreast
from carom.shapes.outlines.bow import Bow
from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.following import follow
from carom.shapes.outlines.track import STILL, Track, _is_brisk, _tips, brisk_track, tracks


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


def test_what_is_sure_to_have_no_tip_has_none_and_is_one_track() -> None:
    source = random.Random(5)
    cubics = [Cubic(*(complex(source.gauss(0, 1), source.gauss(0, 1)) for _ in range(4))) for _ in range(400)]
    cubics += [
        Cubic(0j, 1 + 1j, 0 + 1j, 1 + 0j),
        Cubic(0j, 0j, 1 + 1j, 2 + 0j),
        Cubic(1j, 1j, 1j, 1j),
        Cubic(0j, 3j, 1j, 2j),
    ]
    sure = are_brisk(cubics)
    assert sure == [_is_brisk(cubic, STILL * cubic.size()) and cubic.size() > 0.0 for cubic in cubics]
    assert sum(sure) > 350
    assert sure[400:] == [False] * 4
    for cubic in (cubic for cubic, is_sure in zip(cubics, sure, strict=True) if is_sure):
        assert _tips(cubic) == []
        (expected,) = tracks([cubic])
        found = brisk_track(cubic)
        assert (found.cubics, found.out, found.into) == (expected.cubics, expected.out, expected.into)
    assert are_brisk([]) == []
