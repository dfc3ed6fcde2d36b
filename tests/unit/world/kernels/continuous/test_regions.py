"""Regions of kinematic shapes: they hold what they promise, and those near a place are found, in their order."""

from math import cos, inf, pi, sin
from random import Random

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from carom import Ball, Circle, Point, Segment, World
from carom.rows.index import CELL
from carom.world.kernels.broad_phase.shape_index import MOVING, locate
from carom.world.kernels.continuous.movers import show_movers, take_back
from carom.world.kernels.continuous.regions import (
    is_any_near,
    is_wide,
    kinematic_near,
    next_near,
    rebuild_regions,
    region_of,
    travels,
)
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, look_at, prepare_regions, shape_index
from tests.worlds import continuous_world

RADIUS = 0.3


def fleet(seed: int, count: int = 40, speed: float = 1.0) -> Arrays:
    """Shapes that rest, turn and travel, and a ball; a little after their motion began."""
    random = Random(seed)
    shapes = []
    for k in range(count):
        x, y = random.uniform(-20, 20), random.uniform(-20, 20)
        drift = random.uniform(-speed, speed), random.uniform(-speed, speed)
        options = ({}, {"angular_velocity": 2.0}, {"velocity": drift}, {"angular_velocity": -3.0, "velocity": drift})
        kind = random.randrange(3)
        if kind == 0:
            shapes.append(Point((x, y), motion="kinematic", pivot=(x + 1, y), **options[k % 4]))
        elif kind == 1:
            shapes.append(Segment((x, y), (x + 1, y + 1), motion="kinematic", pivot=(x, y), **options[k % 4]))
        else:
            shapes.append(Circle((x, y), 0.7, motion="kinematic", pivot=(x + 2, y), **options[k % 4]))
    arrays = roomy(continuous_world(*shapes, Ball((0, 0), RADIUS)))
    look_at(arrays, 0.37)
    prepare_regions(arrays)
    return arrays


def roomy(world: World) -> Arrays:
    """The tables of a world in flight."""
    world._arrays.cells, world._arrays.members = np.zeros(4096, CELL), np.zeros(8192, "i4")
    return in_flight(world)


def found(arrays: Arrays, x: float, y: float) -> list[int]:
    """The kinematic shapes that a ball at a place may overlap, in their order."""
    near, wide = kinematic_near(arrays.states[0], arrays.index, arrays.cells, x, y)
    rows = []
    while is_any_near(near, wide):
        row, near, wide = next_near(arrays.shapes.rows, arrays.members, near, wide)
        rows.append(row)
    return rows


@pytest.mark.parametrize("seed", range(6))
def test_a_shape_stays_in_its_region_and_is_found_there_as_long_as_regions_hold(seed: int) -> None:
    arrays = fleet(seed)
    state, entry, shapes, order = arrays.states[0], arrays.index[MOVING], arrays.shapes.rows, arrays.order
    count = arrays.shapes.count
    regions = [region_of(state, entry, shapes[row]) for row in range(count)]
    assert 0.37 < state["valid"] < inf
    random = Random(seed)
    for share in (0.0, 0.2, 0.7, 1.0):
        look_at(arrays, 0.37 + share * (float(state["valid"]) - 0.37))
        show_movers(state, shapes, order)
        for row, (left, bottom, right, top) in enumerate(regions):
            box = shapes[row]
            assert left - 1e-9 <= box["left"]
            assert box["right"] <= right + 1e-9
            assert bottom - 1e-9 <= box["bottom"]
            assert box["top"] <= top + 1e-9
            # As far from a place of it as a ball's centre can be that touches it.
            x, y = float(box["cx"]) + float(box["radius"]), float(box["cy"])
            angle = random.uniform(0, 2 * pi)
            assert row in found(arrays, x + 0.99 * RADIUS * cos(angle), y + 0.99 * RADIUS * sin(angle))
        take_back(state, shapes, order)


def test_lists_are_short_and_what_is_much_wider_than_others_is_in_all_of_them() -> None:
    tiny = [Point((3 * (k % 10), 3 * (k // 10)), motion="kinematic", velocity=(0.1, 0)) for k in range(100)]
    mill = Segment((0, 0), (200, 0), motion="kinematic", pivot=(0, 0), angular_velocity=1.0)
    fast = Point((1, 1), motion="kinematic", velocity=(1e4, 0))
    arrays = roomy(continuous_world(*tiny, mill, fast, Ball((0, 0), RADIUS)))
    state, entry, shapes = arrays.states[0], arrays.index[MOVING], arrays.shapes.rows
    wide = [row for row in range(102) if is_wide(state, entry, shapes[row])]
    assert wide == [100, 101]
    for x, y in ((-50, 70), (1e9, 0), (12.1, 12.1)):
        assert [row for row in found(arrays, x, y) if row >= 100] == [101, 100]  # points come first
        assert len(found(arrays, x, y)) <= 2 + 4
    assert entry["longest"] <= 2 + 4
    assert [travels(shapes[row]) for row in (0, 100, 101)] == [True, False, True]


@pytest.mark.parametrize("phase", ["brute", "quadtree"])
def test_without_a_grid_all_are_found_everywhere_and_for_ever(phase: str) -> None:
    shapes = [Point((k, 0), motion="kinematic", velocity=(1, 0)) for k in range(30)]
    arrays = roomy(continuous_world(*shapes, Ball((0, 0), RADIUS), broad_phase=phase))
    assert found(arrays, 1e6, -3.0) == list(range(30))
    assert arrays.states[0]["valid"] == inf


def test_few_shapes_and_such_as_no_grid_can_hold_are_found_everywhere() -> None:
    few = [Point((k, 0), motion="kinematic", velocity=(1, 0)) for k in range(3)]
    vast = [Point((k * 5e307, 0), motion="kinematic", angular_velocity=1.0) for k in range(-3, 4) for _ in range(9)]
    for shapes in (few, vast):
        arrays = roomy(continuous_world(*shapes, Ball((0, 5), RADIUS)))
        assert found(arrays, 1e6, -3.0) == list(range(len(shapes)))
        assert arrays.states[0]["valid"] == inf


def test_regions_hold_longer_after_each_renewal_without_an_event() -> None:
    arrays = fleet(0)
    state = arrays.states[0]
    spans = []
    for renewals in range(4):
        state["renewals"] = renewals
        prepare_regions(arrays)
        spans.append(float(state["valid"]) - 0.37)
    assert spans == pytest.approx([spans[0], 2 * spans[0], 4 * spans[0], 8 * spans[0]])
    state["renewals"] = 5000
    prepare_regions(arrays)
    assert state["valid"] == inf


def test_an_index_without_room_says_how_much_it_wants() -> None:
    arrays = fleet(1)
    everywhere = [found(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)]
    arrays.cells, arrays.members = arrays.cells[:1].copy(), arrays.members[:1].copy()
    tables = arrays.balls.rows, arrays.shapes.rows, arrays.order
    assert not rebuild_regions(arrays.states[0], *tables, shape_index(arrays))
    assert arrays.states[0]["wanted_cells"] > 1
    prepare_regions(arrays)
    assert [found(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)] == everywhere


def test_static_cells_are_measured_for_flights_and_again_where_a_shape_has_come() -> None:
    world = continuous_world(*(Circle((3.0 * k, 3.0 * j), 0.5) for k in (0, 1, 2, 3, 9, 10, 11) for j in range(12)))
    arrays = world._arrays
    arrays.prepare()
    prepare_regions(arrays)
    entry = arrays.index[0]
    assert entry["measured"]
    x, y = 18.0, 15.0
    cell = locate(arrays.states[0], entry, arrays.cells, x, y)
    assert arrays.cells[cell]["clear"] > 1
    world.add(Point((x, y)))
    arrays.prepare()
    prepare_regions(arrays)
    cell = locate(arrays.states[0], entry, arrays.cells, x, y)
    assert arrays.cells[cell]["clear"] == 0
    assert arrays.cells[cell + 1]["clear"] == 1


@given(kinds=st.lists(st.tuples(st.booleans(), st.booleans()), max_size=8))
def test_two_lists_are_read_as_one_in_members_order(kinds: list[tuple[bool, bool]]) -> None:
    world = continuous_world(*(Point((0, 0)) if point else Circle((0, 0), 1) for point, _ in kinds))
    order = sorted(range(len(kinds)), key=lambda row: (not kinds[row][0], row))
    first = [row for row in order if kinds[row][1]]
    second = [row for row in order if not kinds[row][1]]
    near, wide, read = (0, len(first)), (len(first), len(order)), []
    while is_any_near(near, wide):
        row, near, wide = next_near(world._arrays.shapes.rows, [*first, *second], near, wide)
        read.append(row)
    assert read == order
