"""How near a shape is, and whether a box or a way meets it, for every kind."""

from math import inf, pi

import numpy as np
import pytest

from carom import Arc, Circle, Point, Segment
from carom.rows import kinds_near
from carom.rows.kinds import has_side
from carom.rows.kinds_near import distance_to_shape
from carom.shapes.shape import Shape
from tests.unit.rows.samples import BOXES, ENDED, KINDS, NEAR, PLACES, SAMPLES, is_inside, nearest, outline, row_of


@pytest.mark.parametrize(
    ("shape", "place", "distance"),
    [
        (Point((1, 1)), (4, 5), 5),
        (Segment((0, 0), (4, 0)), (2, -3), 3),
        (Segment((0, 0), (4, 0)), (7, 4), 5),
        (Circle((0, 0), 2), (0.5, 0), 1.5),
        (Circle((0, 0), 2, solid=True), (0.5, 0), 0),
        (Circle((0, 0), 2, solid=True), (5, 0), 3),
        (Arc((0, 0), 5, 0, pi / 2), (6, 8), 5),
        (Arc((0, 0), 5, 0, pi / 2), (1, 0), 4),
        (Arc((0, 0), 5, 0, pi / 2), (0, -12), 13),
    ],
)
def test_the_distance_to_a_shape_counts_its_ends(shape: Shape, place: tuple[float, float], distance: float) -> None:
    assert distance_to_shape(shape._row, *map(float, place)) == pytest.approx(distance)


@KINDS
def test_the_nearest_point_and_its_distance(kind: str) -> None:
    row = row_of(kind)
    for x, y in PLACES:
        away, point, _, inside = nearest(kind, x, y)
        assert kinds_near.distance_to_shape(row, x, y) == pytest.approx(0.0 if inside else away, abs=NEAR)
        px, py, within = kinds_near.closest_on_shape(row, x, y)
        assert (np.hypot(x - px, y - py), within) == (pytest.approx(away, abs=NEAR), inside)
        assert np.hypot(*(point - (px, py))) < 0.1 or away > 0.3


@KINDS
def test_what_is_in_a_box(kind: str) -> None:
    points, shape = outline(SAMPLES[kind][0]), SAMPLES[kind][0]
    for left, bottom, right, top in BOXES:
        (x, y) = points.T
        meets = bool(((left <= x) & (x <= right) & (bottom <= y) & (y <= top)).any())
        meets = meets or is_inside(shape, left, bottom)
        assert kinds_near.box_meets_shape(row_of(kind), left, bottom, right, top) == meets


@KINDS
def test_a_place_stands_out_of_a_shape_on_the_side_of_the_ball_as_far_as_it_is_from_it(kind: str) -> None:
    _, (px, py), (nx, ny) = SAMPLES[kind]
    for height in (0.3, 0.0, -0.3):
        place = px + height * nx, py + height * ny
        found = kinds_near.height_over(row_of(kind), px + nx, py + ny, *place)
        assert found == (inf if kind == "point" else pytest.approx(height))
        if kind in ENDED:
            assert kinds_near.height_over(row_of(kind), px - 0.1 * nx, py - 0.1 * ny, *place) == pytest.approx(-height)


@KINDS
def test_a_way_crosses_the_side_of_a_shape_that_has_one_between_its_ends(kind: str) -> None:
    shape, (px, py), (nx, ny) = SAMPLES[kind]
    assert has_side(int(row_of(kind)["kind"])) == (kind != "point")
    for towards in (1.0, -1.0):
        x, y, dx, dy = px + 0.2 * towards * nx, py + 0.2 * towards * ny, -0.4 * towards * nx, -0.4 * towards * ny
        enters = kind == "circle" and towards < 0.0  # who is inside of what is solid leaves it freely
        assert kinds_near.crosses_side(row_of(kind), x, y, dx, dy, 0.0) == (kind != "point" and not enters)
        assert not kinds_near.crosses_side(row_of(kind), x, y, 0.4 * dx, 0.4 * dy, 0.0)
    if kind in ENDED:
        (ax, ay), (bx, by) = outline(shape)[[0, 1]]
        past_x, past_y = ax - 100.0 * (bx - ax), ay - 100.0 * (by - ay)
        across = -200.0 * (by - ay), 200.0 * (bx - ax)
        given = past_x - 0.5 * across[0], past_y - 0.5 * across[1], *across
        assert not kinds_near.crosses_side(row_of(kind), *given, 0.0)
        assert kinds_near.crosses_side(row_of(kind), *given, 0.1)
