"""Where outlines meet."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.scene.drawings.joints import SMOOTH, joined, size_of, smoothed
from carom.scene.drawings.pieces import Conic, Cubic, Straight

JITTER = st.floats(-0.3, 0.3)


@settings(max_examples=50)
@given(st.lists(st.tuples(JITTER, JITTER), min_size=12, max_size=12))
def test_ends_nearer_than_the_tolerance_come_together(shifts: list[tuple[float, float]]) -> None:
    corners = [(20.0 * cos(k), 20.0 * sin(k)) for k in range(6)]
    lines = [
        [Straight((a[0] + s[0], a[1] + s[1]), (b[0] + t[0], b[1] + t[1]))]
        for (a, b), s, t in zip(pairwise([*corners, corners[0]]), shifts[::2], shifts[1::2], strict=True)
    ]
    found = [outline[0] for outline in joined(lines, 1.0)]
    for before, after in pairwise([*found, found[0]]):
        assert before.end == after.start
    for piece, (line,) in zip(found, lines, strict=True):
        assert hypot(piece.start[0] - line.start[0], piece.start[1] - line.start[1]) <= 1.0


def test_ends_farther_apart_and_short_pieces_stay_as_they_are() -> None:
    apart = [[Straight((0.0, 0.0), (10.0, 0.0))], [Straight((11.1, 0.0), (20.0, 0.0))]]
    assert joined(apart, 1.0) == apart
    short = [[Straight((0.0, 0.0), (1.0, 0.0)), Straight((1.0, 0.0), (1.0, 1.0))]]
    assert joined(short, 1.0) == short


def test_straight_pieces_go_to_the_ends_of_curves() -> None:
    arc = Conic((0.0, 0.0), (5.0, 0.0), (0.0, 5.0), 0.0, 0.5 * pi)
    ((line,), (same,)) = joined([[Straight((5.01, -9.0), (5.01, 0.01))], [arc]], 0.1)
    assert same == arc
    assert line == Straight((5.01, -9.0), arc.start)


def test_two_arcs_meet_and_keep_their_angles() -> None:
    one = Conic((0.0, 0.0), (5.0, 0.0), (0.0, 5.0), 0.0, 0.5 * pi)
    other = Conic((0.0, 10.01), (5.0, 0.0), (0.0, 5.0), -0.5 * pi, -0.5 * pi)
    ((a,), (b,)) = joined([[one], [other]], 0.1)
    assert a == one
    assert hypot(b.start[0] - a.end[0], b.start[1] - a.end[1]) < 1e-14
    assert hypot(b.end[0] - other.end[0], b.end[1] - other.end[1]) < 1e-14
    assert b.sweep == pytest.approx(other.sweep)


@pytest.mark.parametrize("off", [1e-4, -5e-3])
def test_curves_that_nearly_go_on_into_each_other_do(off: float) -> None:
    first = Cubic((0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 0.0))
    second = Cubic((3.0, 0.0), (3.0 + cos(off - pi / 4), sin(off - pi / 4)), (5.0, -1.0), (6.0, 0.0))
    ((a, b),) = smoothed([[first, second]], 0.1)
    into, out = atan2(a.end[1] - a.second[1], a.end[0] - a.second[0]), atan2(b.first[1], b.first[0] - 3.0)
    assert into == pytest.approx(out, abs=1e-15)
    assert into == pytest.approx(-pi / 4 + off / 2)


def test_a_curve_goes_on_from_a_line_or_an_arc_as_that_ends() -> None:
    curve = Cubic((3.0, 0.0), (4.0, 0.004), (5.0, 1.0), (6.0, 1.0))
    for before in (
        Straight((0.0, 0.0), (3.0, 0.0)),
        Straight((3.0, 0.0), (0.0, 0.0)),
        Conic((3.0, 5.0), (5.0, 0.0), (0.0, 5.0), -pi, 0.5 * pi),
        Conic((3.0, 5.0), (5.0, 0.0), (0.0, -5.0), 0.5 * pi, 0.5 * pi),
    ):
        if isinstance(before, Conic):
            curve = Cubic((before.end if before.begin < 0.0 else before.start), *curve.points()[1:])
        ((same, after),) = smoothed([[before, curve]], 0.1)
        assert same == before
        assert after.first[1] == pytest.approx(0.0, abs=1e-15)


def test_corners_stay_corners() -> None:
    first = Cubic((0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 0.0))
    turned = Cubic((3.0, 0.0), (3.0 + cos(2 * SMOOTH - pi / 4), sin(2 * SMOOTH - pi / 4)), (5.0, -1.0), (6.0, 0.0))
    for outline in ([first, turned], [first, Cubic((3.0, 0.0), (3.0, 0.0), (5.0, -1.0), (6.0, 0.0))]):
        assert smoothed([outline], 1.0) == [outline]
    long = Cubic((3.0, 0.0), (3.0 + 100.0, -100.5), (5.0, -1.0), (6.0, 0.0))
    assert smoothed([[first, long]], 0.1) == [[first, long]]


def test_the_size_is_the_longer_side() -> None:
    assert size_of([[Straight((0.0, 0.0), (3.0, 1.0))], [Conic((0.0, 0.0), (2.0, 0.0), (0.0, 2.0))]]) == 5.0
    assert size_of([]) == 0.0
