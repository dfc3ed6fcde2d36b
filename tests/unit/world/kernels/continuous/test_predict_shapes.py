"""The first impact with a shape at rest: of the whole flight, however its way is cut, and what comes first of two."""

from itertools import pairwise
from math import cos, inf, pi, sin

import numpy as np
import pytest

from carom import Ball, Circle, Point, Segment, World
from carom.geometry.path import Path, place_on
from carom.rows.flight import HIT_SHAPE, LOOK, NOTHING
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, LYING, PASSING
from carom.world.kernels.continuous.flight import event_age
from carom.world.kernels.continuous.predict_shapes import (
    consider_shape,
    crossings,
    is_entered_past_ends,
    predict_members,
    predict_on_line,
    predict_on_way,
    predict_shapes,
    time_into_box,
)
from carom.world.kernels.step.relations import add_relation, is_related
from carom.world.tables import Arrays
from tests.kernel_calls import film_tables, foreseen, in_flight
from tests.worlds import continuous_world


def forest(ball: Ball, gravity: tuple[float, float] = (0, 0)) -> Arrays:
    """A lattice of posts, more than are asked one by one, and a ball."""
    world = World(detection="continuous", gravity=gravity)
    world.add(*(Circle((3.0 * k, 3.0 * j), 0.5) for k in range(8) for j in range(8)))
    world.add(ball)
    return in_flight(world)


def on_way(arrays: Arrays, age: float) -> tuple[int, float, float, int]:
    """What is found on the way of the ball from an age on, cell by cell, looks included."""
    _order, *index = film_tables(arrays)[1:]
    flight = arrays.flights[0]
    for _ in range(500):
        flight["event"] = NOTHING
        rows = arrays.balls.rows[0], flight, arrays.shapes.rows, index[0][0], index[1], index[2], arrays.relations
        predict_on_way(arrays.states[0], *rows, age, False)
        if flight["event"] != LOOK:
            break
        assert event_age(flight) > age
        age = event_age(flight)
    return foreseen(arrays)


def of_all(arrays: Arrays) -> tuple[int, float, float, int]:
    """What asking all shapes for the whole way finds."""
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    rows = arrays.balls.rows[0], flight, arrays.shapes.rows, arrays.order, arrays.relations
    predict_members(arrays.states[0], *rows, 0, arrays.shapes.count, 0.0, inf)
    return foreseen(arrays)


def test_an_empty_hall_is_crossed_in_a_few_looks_however_fine_its_walls_are() -> None:
    corners = [(50.0 * cos(angle), 30.0 * sin(angle)) for angle in np.linspace(0.0, 2.0 * pi, 601)]
    world = World(detection="continuous")
    world.add(*(Segment(a, b) for a, b in pairwise(corners)))
    world.add(Ball((-48, 3), 0.01, velocity=(1.0, -0.03)))
    for place, velocity in (((-48, 3), (1, -0.03)), ((0, -28), (0.2, 1)), ((40, -17), (-0.8, 0.1)), ((3, 3), (1, 1))):
        world.balls.position[0], world.balls.velocity[0] = place, velocity
        arrays = in_flight(world)
        assert arrays.index[0]["columns"] > 100
        expected = of_all(arrays)
        assert boxes_asked(arrays) < 40
        assert foreseen(arrays) == expected


def boxes_asked(arrays: Arrays) -> int:
    """The tests of boxes that one call makes which looks along the way of the ball."""
    before = int(arrays.states[0]["box_tests"])
    _order, *index = film_tables(arrays)[1:]
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    rows = arrays.balls.rows[0], flight, arrays.shapes.rows, index[0][0], index[1], index[2], arrays.relations
    predict_on_way(arrays.states[0], *rows, 0.0, False)
    assert flight["event"] != LOOK
    return int(arrays.states[0]["box_tests"]) - before


@pytest.mark.slow
@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.4, -3.0)])
@pytest.mark.parametrize("speed", [0.1, 5.0, 1e6])
def test_cell_by_cell_is_found_what_asking_all_finds_to_the_bit(gravity: tuple[float, float], speed: float) -> None:
    seen = 0
    for angle in np.linspace(0, 2 * pi, 8, endpoint=False):
        for place in ((10.6, 10.4), (10.5 - 60 * cos(angle), 10.5 - 60 * sin(angle))):
            ball = Ball(place, 0.2, velocity=(speed * cos(angle), speed * sin(angle)))
            arrays = forest(ball, gravity)
            expected = of_all(arrays)
            assert on_way(arrays, 0.0) == expected
            if expected[0] == HIT_SHAPE:
                seen += 1
                for share in (0.2, 0.7, 0.999):
                    assert on_way(arrays, share * expected[1]) == expected
    assert seen > 5


@pytest.mark.parametrize("measured", [0, 1])
@pytest.mark.parametrize("velocity", [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1), (3, 1e-9)])
def test_straight_ways_along_the_cells_and_across_their_corners_leave_out_nothing(
    velocity: tuple[float, float], measured: int
) -> None:
    arrays = forest(Ball((0, 0), 0.02, velocity=velocity))
    entry = arrays.index[0]
    side, left, bottom = float(entry["side"]), float(entry["left"]), float(entry["bottom"])
    assert entry["measured"]
    entry["measured"] = measured
    met = 0
    for column in range(-2, int(entry["columns"]) + 3, 3):
        for line in range(-2, int(entry["lines"]) + 3, 3):
            for share in (0.0, 0.5):
                arrays.balls.rows[0]["x"] = left + side * (column + share)
                arrays.balls.rows[0]["y"] = bottom + side * (line + share)
                expected = of_all(arrays)
                assert on_way(arrays, 0.0) == expected
                met += expected[0] == HIT_SHAPE
    assert met > 100


def test_a_way_that_rounding_holds_in_one_place_ends() -> None:
    arrays = forest(Ball((-1e30, 10.0), 0.2, velocity=(1.0, 0.0)))
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    arrays.index[0]["measured"], arrays.states[0]["binned"] = 0, 1
    _order, *index = film_tables(arrays)[1:]
    rows = arrays.balls.rows[0], flight, arrays.shapes.rows, index[0][0], index[1], index[2], arrays.relations
    predict_on_line(arrays.states[0], *rows, 1e30, False)
    assert flight["event"] != LOOK


def test_a_shape_that_is_met_after_a_slice_is_left_for_a_later_one() -> None:
    arrays = forest(Ball((1.5, 0.55), 0.2, velocity=(1.0, 0.0)))
    flight = arrays.flights[0]
    rows = arrays.balls.rows[0], flight, arrays.shapes.rows, arrays.order, arrays.relations
    for end, event in ((0.9, NOTHING), (1.1, HIT_SHAPE)):
        flight["event"] = NOTHING
        predict_members(arrays.states[0], *rows, 0, arrays.shapes.count, 0.0, end)
        assert flight["event"] == event


@pytest.mark.parametrize("pull", [3.0, -0.7])
def test_no_cell_is_left_out_where_a_ball_falls_through_it(pull: float) -> None:
    world = continuous_world(gravity=(0, pull))
    world.add(*(Point((3.0 * k, 3.0 * j)) for k in range(8) for j in range(8)))
    ball = Ball((9.0, 0.0), 0.02)
    world.add(ball)
    for offset in np.linspace(0, 3, 40, endpoint=False):
        ball.position = (9.0, 9.1 + offset)
        arrays = in_flight(world)
        expected = of_all(arrays)
        assert expected[0] == HIT_SHAPE
        assert on_way(arrays, 0.0) == expected


def test_a_ball_outside_of_all_cells_is_followed_from_where_it_comes_in() -> None:
    path = Path(-10.0, 1.0, 2.0, 0.1, 0.0, 0.0)
    assert time_into_box(path, 0.0, 0.0, 0.0, 4.0, 4.0) == 5.0
    assert time_into_box(path, 6.0, 0.0, 0.0, 4.0, 4.0) == 7.0
    assert time_into_box(path, 8.0, 0.0, 0.0, 4.0, 4.0) == inf
    assert time_into_box(Path(-10.0, 9.0, 2.0, 0.1, 0.0, 0.0), 0.0, 0.0, 0.0, 4.0, 4.0) == inf
    assert time_into_box(Path(-10.0, 9.0, 2.0, 0.1, 0.0, -0.5), 0.0, 0.0, 0.0, 4.0, 4.0) < inf


@pytest.mark.parametrize("case", range(30))
def test_a_path_comes_into_a_box_first_where_that_is_found(case: int) -> None:
    random = np.random.default_rng(case)
    path = Path(*random.uniform(-9, 9, 2), *random.normal(0, 3, 2), *random.normal(0, 1, 2))
    if -2 <= path.x <= 2 and -3 <= path.y <= 3:
        return
    time = time_into_box(path, 0.0, -2.0, -3.0, 2.0, 3.0)
    for before in np.linspace(0, min(time, 20.0), 400, endpoint=False):
        x, y = place_on(path, float(before))
        assert not (-2 + 1e-5 < x < 2 - 1e-5 and -3 + 1e-5 < y < 3 - 1e-5)
    if time < inf:
        x, y = place_on(path, time)
        assert abs(x) <= 2 + 1e-5
        assert abs(y) <= 3 + 1e-5


@pytest.mark.parametrize("case", range(20))
def test_crossings_are_the_roots(case: int) -> None:
    c2, c1, c0 = np.random.default_rng(case).normal(0, 1, 3)
    expected = [root.real for root in np.roots([c2, c1, c0]) if abs(root.imag) < 1e-12]
    found = crossings(c2, c1, c0)
    assert sorted(found) == pytest.approx(sorted(expected) if expected else [-1, -1])
    assert crossings(0.0, 2.0, -3.0) == (1.5, -1.0)
    assert crossings(0.0, 0.0, 1.0) == (-1.0, -1.0)


def test_where_two_shapes_are_met_at_once_points_come_first_and_then_the_lower_row() -> None:
    for order in ((0, 1, 2), (2, 1, 0), (1, 2, 0)):
        shapes = [Segment((0, 0), (5, 0)), Segment((-5, 0), (0, 0)), Point((0, 0))]
        arrays = in_flight(continuous_world(*shapes, Ball((0, 3), 1, velocity=(0, -1))))
        flight = arrays.flights[0]
        flight["event"] = NOTHING
        for row in order:
            consider_shape(flight, arrays.shapes.rows, 2.0, row)
        assert foreseen(arrays) == (HIT_SHAPE, 2.0, 0.0, 2)
        flight["event"] = NOTHING
        for row in order:
            if row != 2:
                consider_shape(flight, arrays.shapes.rows, 2.0, row)
        assert foreseen(arrays) == (HIT_SHAPE, 2.0, 0.0, 0)


@pytest.mark.parametrize(("kind", "related"), [(PASSING, 1), (INSIDE_SHAPE, 1), (LASTING, 1), (INSIDE_BALL, 0)])
def test_what_a_ball_passes_senses_or_lies_on_is_not_met(kind: int, related: int) -> None:
    arrays = in_flight(continuous_world(Segment((-5, 0), (5, 0)), Ball((0, 3), 1, velocity=(0, -1))))
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, kind, 0)
    assert is_related(arrays.relations, arrays.balls.rows[0], 0) == bool(related)
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    predict_shapes(arrays.states[0], arrays.balls.rows[0], flight, *film_tables(arrays), arrays.relations, 0.0)
    assert flight["event"] == (NOTHING if related else HIT_SHAPE)


@pytest.mark.parametrize(("holders", "met"), [((), True), ((LASTING,), False), ((LASTING, LYING), True)])
def test_a_point_on_the_wall_that_holds_a_ball_is_in_its_way_when_the_wall_has_ended(
    holders: tuple[int, ...], met: bool
) -> None:
    # It is a little too near, by rounding say, so it touches the point before its foot has come to the end. Balls that
    # lie on others keep to a wall less closely, and are to meet its end.
    wall, end, ball = Segment((-5, 0), (0, 0)), Point((0, 0)), Ball((-1, 0.5 - 1e-13), 0.5, (1, 0))
    arrays = in_flight(continuous_world(wall, end, ball, Ball((-1, 1.5), 0.5, (1, 0)), gravity=(0, -1)))
    for kind in holders:
        add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, kind, int(kind == LYING))
    arrays.flights["ay"][0] = 0.0
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    predict_shapes(arrays.states[0], arrays.balls.rows[0], flight, *film_tables(arrays), arrays.relations, 0.0)
    assert (flight["event"] == HIT_SHAPE and flight["partner"] == 1) == met


def test_sensors_with_ends_alone_are_entered_past_them() -> None:
    for shape, ball, entered in (
        (Segment((0, 0), (1, 0)), Ball((0, 3), 1), False),
        (Segment((0, 0), (1, 0), sensor=True), Ball((0, 3), 1), True),
        (Segment((0, 0), (1, 0)), Ball((0, 3), 1, sensor=True), True),
        (Circle((0, 0), 1, sensor=True), Ball((0, 3), 1), False),
    ):
        assert is_entered_past_ends(ball._row, shape._row) == entered


def test_a_ball_that_sleeps_or_stands_meets_nothing_that_stands() -> None:
    arrays = in_flight(continuous_world(Segment((-5, 0), (5, 0)), Ball((0, 0.5), 1)))
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    predict_shapes(arrays.states[0], arrays.balls.rows[0], flight, *film_tables(arrays), arrays.relations, 0.0)
    assert flight["event"] == NOTHING
