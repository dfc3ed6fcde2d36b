"""Pairs of balls: room that runs out, numbers of cells, levels, and the order of what is found."""

from math import inf, nan, nextafter

import numpy as np
import pytest

from carom import Ball, World
from carom.constants import CELL_CLAMP, CELL_SIDE, FINEST_LEVEL
from carom.rows.index import CELL, SLOT
from carom.rows.shape import SHAPE
from carom.world.kernels.broad_phase.grid import cell_of, grid_size, level_of, pairs_by_grid, wrapped_size
from carom.world.kernels.broad_phase.pairs import (
    may_touch,
    measure_balls,
    pairs_by_brute_force,
    pairs_by_quadtree,
    plant_ball_tree,
)
from tests.physics.kernel_calls import ball_rows, found_pairs, state_row

CLUSTER = [(0.1 * k, 0.0, 1.0) for k in range(9)]


def test_boxes_that_touch_may_touch() -> None:
    assert may_touch(2.0, -2.0, 2.0)
    assert not may_touch(nextafter(2.0, 3.0), 0.0, 2.0)
    assert not may_touch(0.0, -nextafter(2.0, 3.0), 2.0)


def test_what_is_measured_is_the_box_of_the_centres_and_both_radii() -> None:
    rows = ball_rows([(1, 2, 0.5), (-3, 4, 2.0), (0, -6, 1.0)])
    assert measure_balls(state_row(rows, "grid", 6), rows) == (-3, -6, 1, 4, 0.5, 2)


@pytest.mark.parametrize("room", [0, 1, 7])
def test_a_search_that_runs_out_of_room_says_how_much_it_wants(room: int) -> None:
    rows = ball_rows(CLUSTER)
    pairs = np.zeros((room, 2), "i4")
    state = state_row(rows, "brute", 6)
    assert pairs_by_brute_force(state, rows, pairs) == -1
    assert state["wanted_pairs"] > room
    state = state_row(rows, "grid", 6)
    slots = np.zeros(len(rows), SLOT)
    assert pairs_by_grid(state, rows, (slots, np.zeros(1, "i4"), pairs), 0.0) == -1
    assert state["wanted_starts"] > 1
    assert pairs_by_grid(state, rows, (slots, np.zeros(int(state["wanted_starts"]), "i4"), pairs), 0.0) == -1
    assert state["wanted_pairs"] > room
    state = state_row(rows, "quadtree", 6)
    cells, members = np.zeros(64, CELL), np.zeros(64, "i4")
    end = plant_ball_tree(state, rows, np.zeros(0, SHAPE), cells, members, 0, 0)
    assert pairs_by_quadtree(state, rows, cells, members, 0, end, pairs) == -1
    assert state["wanted_pairs"] > room


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_world_grows_its_room_until_all_pairs_fit(phase: str) -> None:
    world = World(broad_phase=phase, substeps=1, iterations=1)
    world.add_balls(np.zeros((150, 2)) + np.arange(150)[:, None] * 1e-3, radius=5.0)
    before = world.balls.position.copy()
    world.step(0.0)
    assert world.statistics.full_tests == 150 * 149 // 2
    assert (before != world.balls.position).any()


def test_a_cell_holds_its_lower_border() -> None:
    assert [cell_of(offset, 0.5) for offset in (0.0, 1.999, 2.0, -0.001, -2.0)] == [0, 0, 1, -1, -1]


def test_cells_are_clamped_in_order() -> None:
    most = int(CELL_CLAMP)
    assert [cell_of(offset, 1.0) for offset in (-inf, -1e300, 1e300, inf)] == [-most, -most, most, most]
    assert cell_of(nan, 1.0) == -most


def test_a_level_s_cells_are_as_wide_as_its_balls() -> None:
    side = 2.0 * CELL_SIDE
    assert level_of(2.0, side) == 0
    assert level_of(1.001, side) == 0
    assert [level_of(2.0 * 0.5**k, side) for k in range(5)] == [0, 1, 2, 3, 4]
    assert level_of(1e-300, side) == FINEST_LEVEL


def test_a_small_box_is_numbered_densely_and_a_large_one_wraps() -> None:
    size, stride, mask = grid_size(10.0, 6.0, 2.0, 100)
    assert (size, stride, mask) == (8 * 7, 8, -1)
    for width, height in ((1e9, 6.0), (6.0, 1e9), (inf, inf), (nan, nan)):
        size, stride, mask = grid_size(width, height, 2.0, 100)
        assert size == mask + 1 == 256
        assert 3 <= stride < size - 3
    assert wrapped_size(1_000_000)[0] <= 64 + 4_000_000


def test_nine_cells_around_one_have_nine_numbers_however_they_wrap() -> None:
    for count in (2, 50, 1000):
        size, stride, mask = wrapped_size(count)
        for centre in range(0, size, 7):
            around = [(x + stride * y) & mask for x in (-1, 0, 1) for y in (-1, 0, 1)]
            assert len({(centre + step) & mask for step in around}) == 9
            # None of the four that follow is one of the four before, or a pair would be found twice.
            assert len({(-step) & mask for step in around[5:]} & set(around[5:])) == 0


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_the_order_of_pairs_depends_on_the_state_alone(phase: str) -> None:
    rng = np.random.default_rng(5)
    balls = [(*rng.uniform(-9, 9, 2), rng.uniform(0.1, 3)) for _ in range(40)]
    assert found_pairs(ball_rows(balls), phase) == found_pairs(ball_rows(balls), phase, room=9999)


@pytest.mark.parametrize("phase", ["grid", "quadtree"])
def test_far_fewer_boxes_are_compared_than_there_are_pairs(phase: str) -> None:
    world = World(broad_phase=phase, levels=8, substeps=1, iterations=1)
    grid = np.stack(np.meshgrid(np.arange(40.0), np.arange(40.0)), -1).reshape(-1, 2)
    world.add_balls(3 * grid, radius=1.0)
    world.step(0.0)
    assert world.statistics.box_tests < 40 * len(world.balls)


def test_pairs_of_a_world_without_or_with_one_ball_are_none() -> None:
    for phase in ("brute", "grid", "quadtree"):
        world = World(broad_phase=phase)
        assert len(world.step(0.1)) == 0
        world.add(Ball((0, 0), radius=1))
        assert len(world.step(0.1)) == 0
        assert world.statistics.box_tests == 0
