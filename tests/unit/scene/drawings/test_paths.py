"""Path data, against svgelements where that understands it."""

from math import hypot

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from svgelements import Path

from carom.scene.drawings.paths import numbers, points, subpaths
from carom.scene.drawings.pieces import Conic, Cubic, Straight
from tests.clock import soon

WRITTEN = st.floats(-50.0, 50.0).map(lambda x: f"{x:.3f}") | st.integers(-9, 9).map(str) | st.just("1e1")
FLAG = st.sampled_from("01")


def command(letter: str, *takes: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """A command with its numbers."""
    letters = st.sampled_from([letter.upper(), letter.lower()])
    return st.tuples(letters, st.sampled_from([" ", ","]), st.tuples(*takes)).map(lambda it: it[0] + it[1].join(it[2]))


RADIUS = st.sampled_from(["1", "3.5", "20"])
COMMANDS = st.one_of(
    command("l", WRITTEN, WRITTEN),
    command("h", WRITTEN),
    command("v", WRITTEN),
    command("c", *[WRITTEN] * 6),
    command("s", *[WRITTEN] * 4),
    command("q", *[WRITTEN] * 4),
    command("t", *[WRITTEN] * 2),
    command("a", RADIUS, RADIUS, WRITTEN, FLAG, FLAG, WRITTEN, WRITTEN),
    command("m", WRITTEN, WRITTEN),
    st.sampled_from("zZ"),
)


@settings(max_examples=40)
@given(st.lists(COMMANDS, min_size=1, max_size=5))
def test_every_path_is_read_as_svgelements_reads_it(commands: list[str]) -> None:
    # svgelements mirrors the handle of the other kind of curve, where SVG 2, 9.3.6, has the place of the pen.
    kinds = "m" + "".join(one[0].lower() for one in commands)
    assume(not any(pair in kinds for pair in ("qs", "ts", "ct", "st")))
    data = "M 1 2 " + " ".join(commands)
    ours = [piece for outline in subpaths(data) for piece in outline]
    ours = [piece for piece in ours if piece.start != piece.end or isinstance(piece, Cubic)]
    theirs = [piece for piece in Path(data) if type(piece).__name__ != "Move"]
    theirs = [piece for piece in theirs if piece.start != piece.end or "Bezier" in type(piece).__name__]
    assert len(ours) == len(theirs)
    for our, their in zip(ours, theirs, strict=True):
        for t in (0.0, 0.3, 0.5, 1.0):
            x, y = place_on(our, t)
            # Half a turn and the like it knows to half of the digits.
            assert hypot(x - float(their.point(t).x), y - float(their.point(t).y)) < 1e-4


def place_on(piece: Straight | Cubic | Conic, t: float) -> tuple[float, float]:
    """The place on a piece at a share of its parameter."""
    if isinstance(piece, Conic):
        return piece.at(piece.begin + t * piece.sweep)
    ends = piece.points()
    weights = [1.0 - t, t] if len(ends) == 2 else [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
    return sum(w * x for w, (x, _) in zip(weights, ends, strict=True)), sum(
        w * y for w, (_, y) in zip(weights, ends, strict=True)
    )


def test_numbers_and_flags_need_nothing_between_them() -> None:
    assert subpaths("M.5.5-1-1") == [[Straight((0.5, 0.5), (-1.0, -1.0))]]
    (arc,) = subpaths("M0 0a1 1 0 011 1")[0]
    assert isinstance(arc, Conic)
    assert hypot(arc.end[0] - 1.0, arc.end[1] - 1.0) < 1e-15


def test_a_closed_subpath_goes_on_where_it_began() -> None:
    assert subpaths("M1 1h2v2zl5 5") == [
        [Straight((1.0, 1.0), (3.0, 1.0)), Straight((3.0, 1.0), (3.0, 3.0)), Straight((3.0, 3.0), (1.0, 1.0))],
        [Straight((1.0, 1.0), (6.0, 6.0))],
    ]


def test_a_path_of_nothing_is_nothing() -> None:
    assert subpaths("") == subpaths(" none ") == subpaths("M 1 1") == []


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ("L 1 1", "must begin with M, not 'L 1 1'"),
        ("M 0 0 L 3", "L takes 2 numbers at a time, not 1"),
        ("M 0 0 L", "L takes 2 numbers at a time, not 0"),
        (" M 0 0 H 1 L 1 zero", "L takes 2 numbers at a time, not 1, in the command at character 12"),
        ("M 0 0 L 1 2 u,3 w", "must hold numbers alone, not 'u'"),
        ("M 0 0 X 3", "must hold numbers alone, not 'X'"),
        ("M 0 0 L 1 nan", "must hold numbers alone, not 'n"),
        ("M 0 0 L 1 1e999", "must be finite"),
        ("M 0 0 Z 3", "Z takes no numbers, not '3'"),
        ("M 0 0 A 1 1 0 2 0 3 3", "A takes 7 numbers at a time, of which the fourth and fifth are 0 or 1"),
    ],
)
def test_what_is_wrong_with_a_path_is_said(data: str, said: str) -> None:
    with pytest.raises(ValueError) as caught:
        subpaths(data)
    assert said in str(caught.value)


@pytest.mark.parametrize("data", ["M0 0a" + "1" * 200_000, "M" + "1" * 300_000 + "x", "M0 0L" + "1e" * 100_000])
def test_hostile_paths_take_no_time(data: str) -> None:
    with soon(), pytest.raises(ValueError):
        subpaths(data)


@pytest.mark.parametrize("text", ["1 1_0", "nan", "1 infinity", "1\u00a02", "1 1e999", "1 2e", "0x1"])
def test_what_only_python_takes_for_a_number_is_none(text: str) -> None:
    with pytest.raises(ValueError, match=r"must hold numbers alone|must be finite"):
        numbers(text)


def test_lists_of_points_are_pairs() -> None:
    assert points("0,0 1-1 2.5.5") == [(0.0, 0.0), (1.0, -1.0), (2.5, 0.5)]
    assert numbers(" 1,\n2 ") == [1.0, 2.0]
    assert numbers("+1.5e1,-.5\t2.E-1") == numbers("+1.5e1-.5,2.E-1") == [15.0, -0.5, 0.2]
    with pytest.raises(ValueError, match="must be pairs of numbers"):
        points("1 2 3")
