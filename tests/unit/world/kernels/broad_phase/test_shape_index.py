"""The index of shapes: which cell a place is in, what is in it, and when it is made anew."""

from math import inf, nan
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, World
from carom.rows.index import CELL
from carom.world.kernels.broad_phase.shape_index import (
    CLEAR_MOST,
    FIXED,
    MOVING,
    QUARTERS,
    Front,
    cell_near,
    cell_side,
    cell_span,
    clear_towards,
    front_of,
    is_free,
    locate,
    measure_clear,
    quarter_of,
    rest_of_cell,
    set_clear,
)
from carom.world.kernels.step.narrow import boxes_apart
from tests.kernel_calls import ball_rows, found_shapes, prepare_index


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_world_without_shapes_has_no_cells(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase)
    world.add(Ball((0, 0), radius=1))
    prepare_index(world, 1.0)
    for which in (FIXED, MOVING):
        assert found_shapes(world, which, 0.0, 0.0) == []


def test_a_grid_has_no_cell_outside_of_its_shapes_reach() -> None:
    world = World(detection="discrete")
    world.add(Segment((0, 0), (10, 0)))
    prepare_index(world, 1.0)
    arrays = world._arrays
    places = ((5.0, 1.5), (11.2, 0.0), (1e300, 0.0), (0.0, -inf), (nan, 0.0), (0.0, nan))
    cells = [locate(arrays.index[FIXED], arrays.cells, x, y) for x, y in places]
    assert [cell for cell in cells[2:] if cell != -1] == []
    assert found_shapes(world, FIXED, 5.0, 0.5) == [0]


def test_short_lists_are_what_a_grid_is_for() -> None:
    world = World(detection="discrete")
    for k in range(400):
        world.add(Point((k % 20, k // 20)))
    prepare_index(world, 0.1)
    assert len(found_shapes(world, FIXED, 7.05, 9.0)) <= 4
    assert world._arrays.index[FIXED]["longest"] <= 6


def test_each_cell_knows_how_wide_squares_without_members_are_towards_each_quarter() -> None:
    world = World(detection="discrete")
    world.add(Segment((0, 0), (30, 0)), Circle((22, 14), 2.5), Point((3, 19)), *(Point((k, 1)) for k in range(16)))
    prepare_index(world, 0.5)
    entry, cells = world._arrays.index[FIXED], world._arrays.cells
    columns, lines = int(entry["columns"]), int(entry["lines"])
    assert not entry["measured"]
    measure_clear(entry, cells)
    assert entry["measured"]
    mine = cells[: columns * lines].reshape(lines, columns)
    full = mine["end"] > mine["begin"]
    assert min(columns, lines) > 5
    for quarter, (right, up) in enumerate(((1, 1), (-1, 1), (1, -1), (-1, -1))):
        assert quarter_of(right > 0, up > 0) == quarter
        # As seen from the lower left always: beyond the edges there is nothing.
        seen = full[::up, ::right]
        found = np.array([[clear_towards(cell, quarter) for cell in row] for row in mine])[::up, ::right]
        widest = 0
        for line in range(lines):
            for column in range(columns):
                y, x = np.nonzero(seen[line:, column:])
                expected = np.maximum(y, x).min() if len(y) else CLEAR_MOST
                assert found[line, column] == expected or found[line, column] > columns + lines < expected
                widest = max(widest, expected % CLEAR_MOST)
        assert widest > 4


@pytest.mark.parametrize("quarter", range(QUARTERS))
def test_what_is_kept_for_a_quarter_leaves_the_others_alone(quarter: int) -> None:
    cells = np.zeros(1, CELL)
    for wide, other in ((CLEAR_MOST, 7), (0, CLEAR_MOST), (5, 0)):
        for each in range(QUARTERS):
            set_clear(cells[0], each, wide if each == quarter else other)
        assert [clear_towards(cells[0], each) for each in range(QUARTERS)] == [
            wide if each == quarter else other for each in range(QUARTERS)
        ]


def test_static_and_kinematic_shapes_stand_apart() -> None:
    world = World(detection="discrete")
    world.add(Point((0, 0), motion="kinematic"))
    world.add(Point((0, 0)))
    prepare_index(world, 1.0)
    assert found_shapes(world, FIXED, 0.0, 0.0) == [1]
    assert found_shapes(world, MOVING, 0.0, 0.0) == [0]


def test_the_rest_of_a_cell_is_what_is_met_after_a_shape() -> None:
    world = World(detection="discrete", broad_phase="brute")
    for shape in (Circle((0, 0), 1), Point((0, 0)), Segment((0, 0), (1, 0)), Point((1, 1)), Circle((1, 0), 1)):
        world.add(shape)
    prepare_index(world, 1.0)
    arrays = world._arrays
    order = found_shapes(world, FIXED, 0.0, 0.0)
    assert order == [1, 3, 2, 0, 4]
    for place, row in enumerate(order):
        begin, end = rest_of_cell(arrays.shapes.rows, arrays.cells, arrays.members, 0, row)
        assert arrays.members[begin:end].tolist() == order[place + 1 :]


@pytest.mark.parametrize(("detection", "most"), [("discrete", 640), ("continuous", 160)])
def test_cells_are_no_smaller_than_a_ball_and_not_too_many(detection: Any, most: int) -> None:
    state = World(detection=detection)._arrays.states[0]
    assert cell_side(state, 10.0, 10.0, 1000, 3.0) == 6
    for width, height in ((100.0, 100.0), (1e6, 1e-3), (1e-3, 1e6), (0.0, 5.0)):
        side = cell_side(state, width, height, 10, 0.0)
        assert most / 2 < (width / side + 1) * (height / side + 1) < 4 * most
    assert cell_side(state, 0.0, 0.0, 1, 0.0) == 1


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_shape_that_is_moved_from_outside_is_found_where_it_is(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase, substeps=1)
    post = world.add(Point((0, 0)))
    hand = world.add(Point((9, 0), motion="kinematic"))
    ball = world.add(Ball((50, 50), radius=1))
    for shape in (post, hand, post):
        world.step(0.1)
        shape.position = (50, 49.1)
        ball.velocity, ball.position = (0, -1), (50, 50)
        assert [hit.shape for hit in world.step(0.01)] == [shape]
        shape.position = (0, 0)


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_larger_ball_is_served_when_it_comes(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase, substeps=1)
    post = world.add(Point((0, 0)))
    world.add(Ball((-50, 50), radius=1e-3))
    world.step(0.1)
    world.add(Ball((70, 0), radius=71, velocity=(-1, 0)))
    assert [hit.shape for hit in world.step(0.01)][:1] == [post]
    world.balls.radius[1] = 72
    world.balls.velocity[1] = (-1, 0)
    assert [hit.shape for hit in world.step(0.01)][:1] == [post]


def front(world: World) -> Front:
    """What is asked first of a world's index."""
    return front_of(world._arrays.states[0], world._arrays.index)


@pytest.mark.parametrize("count", [1, 4, 20, 70])
@pytest.mark.parametrize("far", [0.0, 1e9])
def test_no_ball_is_passed_over_whose_box_meets_that_of_a_shape(count: int, far: float) -> None:
    rng = np.random.default_rng(count)
    world = World(detection="discrete")
    for k in range(count):
        x, y, wide, high = rng.uniform(-9, 9, 4)
        x, y = x + far, y - far
        made = (
            Point((x, y)),
            Segment((x, y), (x + wide, y + high)),
            Circle((x, y), abs(wide)),
            Arc((x, y), 2, wide, 9),
        )
        world.add(made[k % 4])
    prepare_index(world, 0.5)
    arrays, seen = world._arrays, front(world)
    shapes, radius = arrays.shapes.rows, 0.5
    places = (rng.uniform(-20, 20, (40, 2)) + np.array((far, -far))).tolist()
    for row in shapes[:count]:
        places += [
            (float(row["left"]) - radius, float(row["bottom"])),
            (float(row["right"]) + radius, float(row["top"])),
        ]
    met = passed = 0
    for x, y in places:
        ball = ball_rows([(x, y, radius)])[0]
        cell = cell_near(arrays.cells, seen, x, y)
        if not all(boxes_apart(ball, shapes[row]) for row in found_shapes(world, FIXED, x, y)):
            met += 1
            assert not is_free(seen, x, y)
            begin, end = cell_span(arrays.cells, cell)
            assert not all(boxes_apart(ball, shapes[row]) for row in arrays.members[begin:end])
        passed += is_free(seen, x, y) or cell < 0
    assert met > 0
    assert passed > 0


def test_most_of_a_room_is_free() -> None:
    world = World(detection="discrete")
    corners = ((0, 0), (100, 0), (100, 80), (0, 80))
    for k, corner in enumerate(corners):
        world.add(Segment(corner, corners[k - 1]), Point(corner))
    prepare_index(world, 0.5)
    seen = front(world)
    assert all(is_free(seen, x, y) for x in (0.51, 50, 99.49) for y in (0.51, 40, 79.49))
    assert not any(is_free(seen, x, y) for x, y in ((0.49, 40), (99.51, 40), (50, 0.49), (50, 79.51), (nan, 40)))
    # And of a cell that has a wall in it only what is near that wall is looked at more closely.
    assert cell_near(world._arrays.cells, seen, 0.49, 40.0) >= 0
    assert cell_near(world._arrays.cells, seen, 2.5, 40.0) == -1
    assert found_shapes(world, FIXED, 2.5, 40.0) != []


def test_where_shapes_move_or_there_is_no_grid_nothing_is_free() -> None:
    moving = World(detection="discrete")
    moving.add(Segment((0, 0), (10, 0)), Point((5, 5), motion="kinematic", velocity=(1, 0)))
    prepare_index(moving, 0.5)
    tree = World(detection="discrete", broad_phase="quadtree")
    tree.add(Segment((0, 0), (10, 0)))
    prepare_index(tree, 0.5)
    empty = World(detection="discrete")
    prepare_index(empty, 0.5)
    assert [is_free(front(world), 5.0, 3.0) for world in (moving, tree, empty)] == [False, False, True]
    assert [front(world)[0] for world in (moving, tree, empty)] == [False, False, True]
