"""Pieces stay what they are under linear transforms."""

from math import hypot, isclose

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.scene.drawings.curves import fitted
from carom.scene.drawings.pieces import (
    Conic,
    Course,
    Cubic,
    Matrix,
    Piece,
    Straight,
    arcs_of,
    is_bare,
    is_nothing,
    moved,
)

NUMBERS = st.floats(-10.0, 10.0)
PLACES = st.tuples(NUMBERS, NUMBERS)
MATRICES = st.builds(Matrix, NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS)


def near(a: tuple[float, float], b: tuple[float, float]) -> bool:
    """Whether two places are one but for rounding."""
    return hypot(a[0] - b[0], a[1] - b[1]) <= 1e-11 * (1.0 + hypot(*a))


@given(MATRICES, MATRICES, PLACES)
def test_a_transform_after_another_does_both(first: Matrix, then: Matrix, place: tuple[float, float]) -> None:
    assert near(then.after(first).place(place), then.place(first.place(place)))


@given(st.builds(Conic, PLACES, PLACES, PLACES, NUMBERS, NUMBERS), MATRICES, st.floats(0.0, 1.0))
def test_a_place_of_an_ellipse_moves_with_it(piece: Conic, matrix: Matrix, share: float) -> None:
    t = piece.begin + share * piece.sweep
    assert near(piece.moved(matrix).at(t), matrix.place(piece.at(t)))


@given(MATRICES, st.floats(0.0, 1.0))
def test_a_place_of_a_course_moves_with_it(matrix: Matrix, t: float) -> None:
    piece = Course(lambda s: (s, s * s))
    assert near(piece.moved(matrix).moved(matrix).at(t), matrix.place(matrix.place((t, t * t))))


def test_what_is_turned_and_mirrored_is_round_and_what_is_stretched_is_not() -> None:
    circle = Conic((1.0, 2.0), (3.0, 0.0), (0.0, 3.0))
    assert circle.round
    assert circle.moved(Matrix(0.6, 0.8, 0.8, -0.6)).round
    assert isclose(circle.moved(Matrix(1.2, 1.6, 1.6, -1.2)).radius, 6.0)
    assert not circle.moved(Matrix(1.0, 0.0, 0.0, 1.001)).round
    assert not circle.moved(Matrix(1.0, 0.0, 0.01, 1.0)).round


def test_an_outline_is_transformed_piece_by_piece_and_its_joints_are_one_place() -> None:
    a, b, c, d = (0.0, 0.0), (2.0, 1.0), (3.0, 3.0), (1.0, 5.0)
    circle = Conic((1.0, 5.0), (1.0, 0.0), (0.0, 1.0))
    outline: list[Piece] = [Straight(a, b), Cubic(b, (3.0, 0.0), (4.0, 1.0), c), circle, Straight(c, d), Straight(b, a)]
    turned = moved(outline, Matrix(0.6, 0.8, -0.8, 0.6, 1.0, 2.0))
    assert turned == [piece.moved(Matrix(0.6, 0.8, -0.8, 0.6, 1.0, 2.0)) for piece in outline]
    assert turned[0].end is turned[1].start
    assert turned[1].end is turned[3].start


@pytest.mark.parametrize(
    "piece",
    [
        Straight((1.0, 2.0), (1.5, 2.5)),
        Cubic((1.0, 2.0), (1.0, 3.0), (2.0, 2.0), (1.5, 2.5)),
        Conic((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), 0.0, 1.0),
        Course(lambda t: (t, t)),
    ],
)
def test_only_what_is_no_more_than_a_place_is_bare(piece: Piece) -> None:
    assert not is_bare(piece, 1e-3)
    assert is_bare(piece.moved(Matrix(1e-6, 0.0, 0.0, 1e-6)), 1e-3)


@pytest.mark.parametrize("tolerance", [1.0, 1e-2, 1e-4, 1e-6])
def test_arcs_of_curves_are_estimated(tolerance: float) -> None:
    curves = [
        Cubic((0.0, 0.0), (4.0, 1.0), (6.0, -2.0), (9.0, 3.0)),
        Cubic((0.0, 0.0), (9.0, 9.0), (-3.0, 9.0), (7.0, -2.0)),
        Conic((0.0, 0.0), (8.0, 0.0), (0.0, 3.0), 0.0, 3.0),
        Conic((0.0, 0.0), (8.0, 0.0), (0.0, 3.0)),
    ]
    for curve in curves:
        assert 0.3 < arcs_of(curve, tolerance) / len(fitted(curve, tolerance)) < 3.0
    assert arcs_of(Conic((0.0, 0.0), (8.0, 0.0), (0.0, 8.0)), tolerance) == 0.0
    assert arcs_of(Straight((0.0, 0.0), (8.0, 0.0)), tolerance) == 0.0


def test_a_whole_ellipse_is_bare_without_an_area_alone() -> None:
    circle = Conic((1.0, 2.0), (3.0, 0.0), (0.0, 3.0))
    assert not is_bare(circle.moved(Matrix(1e-9, 0.0, 0.0, 1e-9)), 1.0)
    assert is_bare(circle.moved(Matrix(1.0, 0.0, 0.0, 0.0)), 0.0)
    assert is_nothing([[], [circle.moved(Matrix(0.0, 0.0, 0.0, 0.0))]])
    assert not is_nothing([[Straight((1.0, 1.0), (1.0, 1.0)), circle]])


def test_the_points_of_a_whole_ellipse_are_the_corners_of_its_box() -> None:
    turned = Conic((1.0, 1.0), (3.0, 0.0), (0.0, 1.0)).moved(Matrix(0.6, 0.8, -0.8, 0.6))
    (left, low), (right, high) = turned.points()
    places = [turned.at(0.001 * k) for k in range(6284)]
    assert isclose(left, min(x for x, _ in places), abs_tol=1e-5)
    assert isclose(right, max(x for x, _ in places), abs_tol=1e-5)
    assert isclose(low, min(y for _, y in places), abs_tol=1e-5)
    assert isclose(high, max(y for _, y in places), abs_tol=1e-5)
