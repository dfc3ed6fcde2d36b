"""Regions of kinematic shapes: they hold what they promise, and those near a place are found, in their order."""

from copy import copy
from itertools import pairwise
from math import cos, inf, pi, sin
from random import Random

import hypothesis.strategies as st
import pytest
from hypothesis import given

from carom import Ball, Circle, Point, Segment, World
from carom.constants import FEW_BALLS, REGION_SUBSTEPS
from carom.world.kernels.broad_phase.regions import (
    is_any_near,
    is_wide,
    next_near,
    region_of,
    travels,
)
from carom.world.kernels.broad_phase.shape_index import MOVING
from carom.world.kernels.continuous.movers import show_movers, take_back
from tests.kernel_calls import RADIUS, fleet, found_moving, look_at, roomy
from tests.worlds import continuous_world


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
            assert row in found_moving(arrays, x + 0.99 * RADIUS * cos(angle), y + 0.99 * RADIUS * sin(angle))
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
        assert [row for row in found_moving(arrays, x, y) if row >= 100] == [101, 100]  # points come first
        assert len(found_moving(arrays, x, y)) <= 2 + 4
    assert entry["longest"] <= 2 + 4
    assert [travels(shapes[row]) for row in (0, 100, 101)] == [True, False, True]


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_by_brute_force_all_are_found_everywhere_and_for_ever(phase: str) -> None:
    shapes = [Point((k, 0), motion="kinematic", velocity=(1, 0)) for k in range(30)]
    arrays = roomy(continuous_world(*shapes, Ball((0, 0), RADIUS), broad_phase=phase))
    assert found_moving(arrays, 1e6, -3.0) == (list(range(30)) if phase == "brute" else [])
    assert len(found_moving(arrays, 15.0, 0.1)) in ((30,) if phase == "brute" else range(1, 10))
    assert (arrays.states[0]["valid"] == inf) == (phase == "brute")


def test_few_shapes_and_such_as_no_grid_can_hold_are_found_everywhere() -> None:
    few = [Point((k, 0), motion="kinematic", velocity=(1, 0)) for k in range(3)]
    vast = [Point((k * 5e307, 0), motion="kinematic", angular_velocity=1.0) for k in range(-3, 4) for _ in range(9)]
    for shapes in (few, vast):
        arrays = roomy(continuous_world(*shapes, Ball((0, 5), RADIUS)))
        assert found_moving(arrays, 1e6, -3.0) == list(range(len(shapes)))
        assert arrays.states[0]["valid"] == inf


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


def test_in_substeps_a_shape_stays_in_its_region_until_regions_are_made_anew() -> None:
    world = World(detection="discrete", substeps=2)
    world.add(*drifting(Random(1), 17), Ball((30, 30), RADIUS))
    arrays, made = world._arrays, 0
    regions: list[tuple[float, float, float, float]] = []
    for _ in range(7):
        spans = float(arrays.index[MOVING]["span"])
        world.step(0.4)
        state, entry, shapes = arrays.states[0], arrays.index[MOVING], arrays.shapes.rows
        if not regions or entry["span"] > spans:
            made += 1
            regions = [region_of(state, entry, shapes[row]) for row in range(17)]
        for row, (left, bottom, right, top) in enumerate(regions):
            box = shapes[row]
            assert left - 1e-12 <= box["left"] <= box["right"] <= right + 1e-12
            assert bottom - 1e-12 <= box["bottom"] <= box["top"] <= top + 1e-12
            assert row in found_moving(arrays, float(box["right"]), float(box["top"]))
    assert 1 < made < 7


def drifting(random: Random, count: int) -> list[Segment]:
    """Segments that turn or travel, or both, all over a place."""
    made = []
    for k in range(count):
        x, y = random.uniform(-20, 20), random.uniform(-20, 20)
        drift = random.uniform(-4, 4), random.uniform(-4, 4)
        options = ({"angular_velocity": 2.0}, {"velocity": drift}, {"angular_velocity": -3.0, "velocity": drift})
        made.append(Segment((x, y), (x + 1, y + 1), motion="kinematic", **options[k % 3]))
    return made


def spans_of(world: World, steps: int) -> list[float]:
    """For how long the regions of a world's kinematic shapes hold yet after each of some steps."""
    spans = []
    for _ in range(steps):
        world.step(0.01)
        spans.append(float(world._arrays.index[MOVING]["span"]))
    return spans


def test_regions_of_what_turns_hold_for_ever_and_those_of_what_travels_for_a_while() -> None:
    turning, travelling = World(detection="discrete", substeps=1), World(detection="discrete", substeps=1)
    for k in range(20):
        turning.add(Segment((3 * k, 0), (3 * k + 1, 0), motion="kinematic", angular_velocity=1.0))
        travelling.add(Segment((3 * k, 0), (3 * k + 1, 0), motion="kinematic", velocity=(0, 40.0)))
    for world in (turning, travelling):
        world.add(Ball((0, 9), RADIUS))
    assert spans_of(turning, 3) == [inf] * 3
    spans = spans_of(travelling, 40)
    assert spans[:3] == pytest.approx([0.16, 0.15, 0.14])
    assert sum(after > before for before, after in pairwise(spans)) == 2
    assert max(spans) == pytest.approx(0.16)


def test_regions_do_not_hold_for_more_substeps_than_their_margin_is_for() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(*(Point((k, 0), motion="kinematic", velocity=(1e-9, 0)) for k in range(20)), Ball((0, 9), RADIUS))
    assert spans_of(world, 2) == pytest.approx([REGION_SUBSTEPS * 0.01, (REGION_SUBSTEPS - 1) * 0.01])


def test_where_regions_lie_over_each_other_among_many_balls_places_are_filed_anew() -> None:
    angles = [2 * pi * k / 20 for k in range(20)]
    drum = [Point((10 * cos(a), 10 * sin(a)), motion="kinematic", pivot=(0, 0), angular_velocity=1.0) for a in angles]
    few, many = World(detection="discrete", substeps=1), World(detection="discrete", substeps=1)
    for world, side in ((few, 2), (many, 24)):
        world.add(*drum) if world is few else world.add(*(copy(point) for point in drum))
        world.add_balls([(0.2 * (k % side), 0.2 * (k // side)) for k in range(side * side)], radius=0.1)
    assert spans_of(few, 2) == [inf, inf]
    assert spans_of(many, 2) == [0.0, 0.0]
    for world in (few, many):
        for row in range(20):
            shape = world._arrays.shapes.rows[row]
            assert row in found_moving(world._arrays, float(shape["cx"]), float(shape["cy"]))
    assert len(found_moving(few._arrays, 10.0, 0.0)) == 20
    assert len(found_moving(many._arrays, 10 * cos(0.01), 10 * sin(0.01))) < 20


def test_few_shapes_among_few_balls_are_in_one_cell_around_their_places() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(*(Point((k, 0), motion="kinematic", velocity=(0, 1)) for k in range(3)), Ball((0, 9), RADIUS))
    assert spans_of(world, 1) == [0.0]
    assert found_moving(world._arrays, 1.0, 0.2) == found_moving(world._arrays, -0.2, 0.01 + RADIUS) == [0, 1, 2]
    assert found_moving(world._arrays, -0.4, 0.0) == found_moving(world._arrays, 1.0, 3.0) == []


def test_a_shape_that_arrives_is_found_wherever_its_way_was() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(*(Point((k, 0), motion="kinematic") for k in range(20)), Ball((0, 9), RADIUS))
    world.shapes[0].move_to((0, 1), dt=0.03)
    world.step(0.01)
    world._arrays.shapes.rows[0]["target_pivot_y"] = world._arrays.shapes.rows[0]["target_y"] = 50.0
    world.run(0.05, dt=0.01)
    assert found_moving(world._arrays, 0.0, 50.0) == [0]


def test_regions_stand_when_static_shapes_are_changed_until_these_need_their_room() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(*(Segment((3 * k, 0), (3 * k + 1, 0), motion="kinematic", velocity=(0, 0.1)) for k in range(20)))
    posts = [Point((3 * k + 2, 5 * (k % 2))) for k in range(20)]
    world.add(*posts, Ball((0, 9), RADIUS))
    first = spans_of(world, 1)[0]
    posts[7].position = (23, 2)
    world.remove(posts[9])
    assert spans_of(world, 1)[0] < first
    world.add(Point((8, 3)))
    assert spans_of(world, 1)[0] < first - 0.015
    world.add(*(Point((8 + 0.1 * k, 3)) for k in range(90)))
    assert spans_of(world, 1)[0] == first
    assert [row for row in range(20) if row in found_moving(world._arrays, 3.0 * row, 0.0)] == list(range(20))


def test_cells_are_made_when_there_are_no_more_few_balls() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((3, 0), (4, 0), motion="kinematic", angular_velocity=1.0), Ball((0, 9), RADIUS))
    assert spans_of(world, 1) == [0.0]
    world.add_balls([(0.3 * k, 20.0) for k in range(FEW_BALLS)], radius=0.1)
    assert spans_of(world, 1) == [inf]
    assert world._arrays.index[MOVING]["swept"] == 1
    world.remove(world.balls[0])
    assert spans_of(world, 1) == [0.0]
    assert world._arrays.index[MOVING]["swept"] == 0
