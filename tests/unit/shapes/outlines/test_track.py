"""Smooth runs of cubics: they end at cusps and corners, and nowhere else."""

import random
from cmath import phase
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.track import STILL, _is_brisk, _tips, tracks

BOW = Cubic(0j, 1 + 1j, 2 + 1j, 3 + 0j)


def is_brisk(cubic: Cubic) -> bool:
    """Whether a cubic is sure to have no tip."""
    return _is_brisk(cubic, STILL * cubic.size())


def test_a_cubic_without_a_cusp_is_one_run_in_its_own_directions() -> None:
    (run,) = tracks([BOW])
    assert run.end == 1.0
    assert phase(run.heading(0.0, 0.5)) == pytest.approx(pi / 4)
    assert phase(run.heading(1.0, 0.5)) == pytest.approx(-pi / 4)


def test_a_cusp_ends_a_run_and_the_next_turns_back() -> None:
    first, last = tracks([Cubic(0j, 1 + 1j, 0 + 1j, 1 + 0j)])
    assert first.point(first.end) == last.point(0.0)
    assert first.heading(first.end, 0.0) == -last.heading(0.0, 0.0)


def test_a_corner_ends_a_run_and_a_smooth_joint_does_not() -> None:
    after = Cubic(3 + 0j, 4 - 1j, 5 + 0j, 6 + 0j)
    (run,) = tracks([BOW, after])
    assert run.end == 2.0
    assert [run.point(u) for u in (0.0, 1.0, 2.0)] == [0j, 3 + 0j, 6 + 0j]
    assert len(tracks([BOW, after._replace(b=4 + 1j)])) == 2


@pytest.mark.parametrize("cubic", [Cubic(0j, 0j, 1 + 1j, 2 + 0j), Cubic(0j, 1j, 2 + 0j, 2 + 0j), Cubic(0j, 0j, 2j, 2j)])
def test_ends_that_stand_still_have_a_direction(cubic: Cubic) -> None:
    (run,) = tracks([cubic])
    for u, near in ((0.0, 1e-4), (1.0, 1.0 - 1e-4)):
        assert abs(phase(run.heading(u, 0.0) / (cubic.slope(near) / abs(cubic.slope(near))))) < 1e-3


@given(st.lists(st.complex_numbers(max_magnitude=1.0), min_size=4, max_size=4), st.sampled_from(["any", "b", "c", "x"]))
def test_what_is_brisk_has_no_tip(places: list[complex], kind: str) -> None:
    a, b, c, d = places
    cubic = {"any": Cubic(a, b, c, d), "b": Cubic(a, a, c, d), "c": Cubic(a, b, b, d), "x": Cubic(a, d, a + b, d)}[kind]
    assert not (is_brisk(cubic) and _tips(cubic))


def test_most_curves_are_brisk_and_none_with_a_cusp() -> None:
    source = random.Random(3)
    some = [Cubic(*(complex(source.uniform(-1, 1), source.uniform(-1, 1)) for _ in range(4))) for _ in range(400)]
    assert sum(map(is_brisk, some)) > 180
    assert is_brisk(BOW)
    assert not is_brisk(Cubic(0j, 1 + 1j, 0 + 1j, 1 + 0j))
    assert not is_brisk(Cubic(0j, 1 + 0j, 2 + 0j, 1 + 0j))
    for short in (0.0, 1e-10, 1e-13):  # it hardly moves at its start, or turns there within no radius to speak of
        assert not is_brisk(Cubic(0j, short + 0j, 1 + 0.1j, 2 + 0j))
        assert not is_brisk(Cubic(0j, -1 + 0j, 1 + 1j, 1 + 1j + short))


def test_a_point_is_no_run() -> None:
    assert tracks([Cubic(1j, 1j, 1j, 1j)]) == []


@given(st.floats(0.05, 0.95), st.floats(0.0, 0.5))
def test_arcs_are_slanted_against_the_growth_of_curvature(u: float, arc: float) -> None:
    (run,) = tracks([Cubic(0j, 1 + 0j, 2 + 0.5j, 2.5 + 2j)])  # bends to the left, first more and then less
    straight, slanted = run.heading(u, 0.0), run.heading(u, arc)

    def bend(at: float) -> float:
        step = 1e-4
        turn = phase(run.slope(at + step) / run.slope(at - step))
        return turn / abs(run.point(at + step) - run.point(at - step))

    growth = (bend(u + 1e-2) - bend(u - 1e-2)) / abs(run.point(u + 1e-2) - run.point(u - 1e-2))
    expected = -growth * arc * arc / 12.0
    if abs(growth) > 0.1 and abs(expected) < 0.15:
        assert phase(slanted / straight) == pytest.approx(expected, rel=0.05, abs=1e-4)


@given(st.floats(0.1, 1.9))
def test_a_crossing_is_where_the_track_crosses_the_line(u: float) -> None:
    (run,) = tracks([BOW, Cubic(3 + 0j, 4 - 1j, 5 + 0j, 6 + 0j)])
    along = run.slope(u) / abs(run.slope(u))
    found = run.crossing(u - 0.1, u + 0.07, run.point(u) + 0.01j * along, along)
    assert found == pytest.approx(u, abs=1e-9)


def test_parts_are_cut_where_asked() -> None:
    (run,) = tracks([BOW, Cubic(3 + 0j, 4 - 1j, 5 + 0j, 6 + 0j)])
    assert [(part.a, part.d) for part in run.parts(0.25, 1.5)] == [(run.point(0.25), 3 + 0j), (3 + 0j, run.point(1.5))]
    assert list(run.parts(0.0, 1.0)) == [BOW]
