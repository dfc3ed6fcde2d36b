"""SVG path data: what each command draws, in all its spellings, and where it is wrong."""

import pytest

from carom import InvalidArgument
from carom.shapes.outlines.path_data import Bezier, Ellipse, Line, Piece, pieces_of
from tests.clock import within


def one(data: str) -> list[Piece]:
    """The pieces of data with one subpath."""
    (pieces,) = pieces_of(data)
    return pieces


@pytest.mark.parametrize(
    ("small", "large"),
    [
        ("m 1 2 l 3 4 5 6", "M 1 2 L 4 6 L 9 12"),
        ("m1,2 3,4", "M1 2L4 6"),
        ("M1 2h3v-4H0V0", "M1 2L4 2 4-2 0-2 0 0"),
        ("M1 2c1 1 2 1 3 0s2-1 3 0", "M1 2C2 3 3 3 4 2S6 1 7 2"),
        ("M1 2c1 1 2 1 3 0s2-1 3 0", "M1 2C2 3 3 3 4 2C5 1 6 1 7 2"),
        ("M1 2q1 1 2 0t2 0", "M1 2Q2 3 3 2T5 2"),
        ("M1 2q1 1 2 0t2 0", "M1 2Q2 3 3 2Q4 1 5 2"),
        ("M1 2t2 0", "M1 2Q1 2 3 2"),
        ("M1 2s1 1 2 0", "M1 2C1 2 2 3 3 2"),
        ("M1 2a3 4 5 0 1 6 7", "M1 2A3 4 5 0 1 7 9"),
        ("M1 2a3 4 5 016 7", "M1 2A3,4,5,0,1,7,9"),
        ("M.5.5L1e1-1E-1", "M 0.5 0.5 L 10 -0.1"),
        ("M0 0h2v2z", "M0 0L2 0 2 2 0 0"),
        ("M1 1a0 4 0 0 1 2 2", "M1 1L3 3"),
    ],
)
def test_all_spellings_say_the_same(small: str, large: str) -> None:
    assert one(small) == one(large)


def test_pieces_are_what_the_commands_say() -> None:
    assert one("M0 0L4 0C5 0 6 1 6 2A1 2 30 1 0 0 0") == [
        Line(0j, 4 + 0j),
        Bezier(4 + 0j, 5 + 0j, 6 + 1j, 6 + 2j),
        Ellipse(6 + 2j, 0j, 1.0, 2.0, 30.0, True, False),
    ]
    assert one("M0 0Q3 3 6 0") == [Bezier(0j, 2 + 2j, 4 + 2j, 6 + 0j)]


def test_subpaths_begin_at_moves_and_where_the_last_was_closed() -> None:
    assert pieces_of("M0 0H1M5 5H6z m1 1h1zh-1") == [
        [Line(0j, 1 + 0j)],
        [Line(5 + 5j, 6 + 5j), Line(6 + 5j, 5 + 5j)],
        [Line(6 + 6j, 7 + 6j), Line(7 + 6j, 6 + 6j)],
        [Line(6 + 6j, 5 + 6j)],
    ]


def test_what_has_no_length_is_left_out_and_a_loop_is_not() -> None:
    assert pieces_of("M1 1L1 1H1a2 2 0 0 1 0 0z") == []
    assert len(one("M1 1C2 2 0 2 1 1")) == 1


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ("L 1 1", "data must have M first at character 0, not 'L 1 1'"),
        ("7 7", "data must have a command, .* at character 0, not '7 7'"),
        ("M 0", "data must have a number at character 3, not ''"),
        ("M 0 0 L x", "data must have a number at character 8, not 'x'"),
        ("M0 0 A 1 1 0 2 0 1 1", "data must have a flag, 0 or 1, at character 13, not '2 0 1 1'"),
        ("M 0 0 Z 4", "data must have a command, .* at character 8, not '4'"),
        ("M 0 0 L 1 1 foo", "data must have a number at character 12, not 'foo'"),
        ("M 1e400 0", r"data\[2:7\] must be finite"),
    ],
)
def test_mistakes_are_named_with_their_place(data: str, message: str) -> None:
    with pytest.raises(InvalidArgument, match=message):
        pieces_of(data)


@pytest.mark.slow
def test_long_data_takes_no_longer_than_it_is_long() -> None:
    with within(20.0):
        assert len(one("M0 0" + "l1 1" * 20_000)) == 20_000
        with pytest.raises(InvalidArgument):
            pieces_of("M0 0" + " " * 100_000 + "?")
        with pytest.raises(InvalidArgument):
            pieces_of("M0 0L" + "1" * 100_000)
