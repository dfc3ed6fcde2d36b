"""Loops are found whatever the order of the walls, and measured as the figures of the textbooks are."""

from math import pi
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import study
from carom.shapes.segment import Segment
from carom.study.billiards.outline import Loop, Piece, loops_of

#: Three quarters of a circle.
CUT = carom.Arc((0, 0), 1.0, 0.3, 0.3 + 1.5 * pi)


def loops(*shapes: carom.Shape) -> tuple[Loop, ...]:
    """The loops of some shapes."""
    return loops_of(carom.Scene(name="trial", shapes=list(shapes)), list(enumerate(shapes)))  # type: ignore[arg-type]


def square(side: float = 2.0, x: float = 0.0, y: float = 0.0) -> list[carom.Shape]:
    """The sides of a square about a place."""
    half = 0.5 * side
    return carom.outlines.rectangle(x - half, y - half, x + half, y + half, guard=False)


@settings(max_examples=20)
@given(st.integers(0, 10**6))
def test_a_table_is_the_same_whatever_the_order_of_its_walls(seed: int) -> None:
    random = Random(seed)
    walls = [*carom.outlines.stadium((1, 2), 3.0, 1.0, guard=False), *square(0.5, 1.0, 2.0)]
    walls.append(carom.Circle((2.2, 2.0), 0.4, solid=True))
    random.shuffle(walls)
    found = loops(*walls)
    assert [len(loop.pieces) for loop in found] == [4, 1, 4]
    assert [loop.area for loop in found] == pytest.approx([6.0 + pi, 0.16 * pi, 0.25], rel=1e-12)
    assert [loop.length for loop in found] == pytest.approx([6.0 + 2.0 * pi, 0.8 * pi, 2.0], rel=1e-12)
    for loop in found:
        for piece, following in zip(loop.pieces, (*loop.pieces[1:], loop.pieces[0]), strict=True):
            assert piece.ends[1] == pytest.approx(following.ends[0], abs=1e-12)


def test_a_piece_is_gone_along_from_its_beginning_to_its_end() -> None:
    half = carom.Arc((1.0, 0.0), 2.0, 0.0, pi)
    for piece in (Piece(0, half, True), Piece(0, half, False), Piece(0, Segment((0, 0), (3, 4)), False)):
        places, tangents = piece.at(np.array([0.0, 1e-7, piece.wall.length]))
        assert places[0] == pytest.approx(piece.ends[0], abs=1e-12)
        assert places[2] == pytest.approx(piece.ends[1], abs=1e-12)
        assert (places[1] - places[0]) / 1e-7 == pytest.approx(tangents[0], abs=1e-6)


@pytest.mark.parametrize(
    "shapes",
    [
        square(),
        carom.outlines.stadium((0, 0), 1.0, 0.7, guard=False),
        [CUT, carom.Segment(CUT.p0, CUT.p1)],
        [carom.Arc((0, 0), 1.0, pi, 2.0 * pi), carom.Arc((0, 1.0), 2.0**0.5, 1.25 * pi, 1.75 * pi)],
        [carom.Circle((0.1, 0.2), 1.1)],
    ],
    ids=["square", "stadium", "cut disc", "crescent", "circle"],
)
def test_what_a_loop_contains_has_its_area(shapes: list[carom.Shape]) -> None:
    (loop,) = loops(*shapes)
    side = np.linspace(-2.0, 2.0, 801) + 1e-4
    x, y = (places.ravel() for places in np.meshgrid(side, side))
    cells = float(loop.contains(x, y).sum()) * (side[1] - side[0]) ** 2
    # Cells that the edge cuts are right on average; all of them together are its length times a cell.
    assert loop.area == pytest.approx(cells, abs=0.1 * loop.length * (side[1] - side[0]))
    assert loop.area > 0.0


@pytest.mark.parametrize(
    ("shapes", "told"),
    [
        ([], "have walls that close a table"),
        (square()[:3], r"shapes\[0\] ends at .*, at no other wall"),
        ([*square(), carom.Segment((1, 1), (2, 2), name="fin")], r"ends at \(1.0, 1.0\), at 2 other walls"),
        ([carom.Circle((0, 0), 1, solid=True, name="disc")], r"shapes\[0\] \('disc'\) is solid"),
        ([*square(), carom.Circle((1, 0), 0.3)], r"shapes\[4\] crosses another wall"),
        ([*square(), carom.Circle((3, 0), 0.3)], r"shapes\[4\] crosses another wall"),
        ([*square(), carom.Circle((0, 0), 0.3), carom.Circle((0.4, 0), 0.3)], "crosses another wall"),
        ([*square(), *square(1.0), carom.Circle((0, 0), 0.3)], "crosses another wall"),
    ],
)
def test_what_is_no_table_is_refused_by_name(shapes: list[carom.Shape], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=rf"scene must .*{told}.*not 'trial'"):
        loops(*shapes)


def test_a_scene_without_a_name_is_refused_without_one() -> None:
    for made in (carom.Scene(), carom.Scene(world={"friction": 1.0}), carom.Scene(shapes=square()[:3])):
        with pytest.raises(carom.InvalidArgument, match=r"^scene must ") as caught:
            study.table(made)
        assert "None" not in str(caught.value)


def test_two_walls_are_gone_along_as_hits_see_them() -> None:
    bow = carom.Arc((0, 0), 1.0, 0.0, pi)
    for walls in ([carom.Segment((-1, 0), (1, 0)), bow], [bow, carom.Segment((-1, 0), (1, 0))]):
        (loop,) = loops(*walls)
        assert loop.pieces[0].forward
        assert loop.area == pytest.approx(0.5 * pi)


def test_many_walls_are_one_loop() -> None:
    shapes = carom.outlines.regular_polygon((0, 0), 1.0, 100, guard=False)
    (loop,) = loops(*shapes)
    assert len(loop.pieces) == 100
    assert loop.area == pytest.approx(50.0 * np.sin(2.0 * pi / 100), rel=1e-12)
