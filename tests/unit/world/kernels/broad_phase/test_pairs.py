"""Pairs of balls: room that runs out, numbers of cells, levels, and the order of what is found."""

from math import nextafter

import numpy as np
import pytest

from carom import Ball, World
from carom.rows.index import CELL, SLOT
from carom.rows.shape import SHAPE
from carom.world.kernels.broad_phase.grid import pairs_by_grid
from carom.world.kernels.broad_phase.pairs import (
    may_touch,
    measure_balls,
    pairs_by_brute_force,
    pairs_by_quadtree,
    plant_ball_tree,
)
from tests.kernel_calls import ball_rows, found_pairs, state_row

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
    slots = np.zeros(2 * len(rows) + 2, SLOT)
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
    world = World(detection="discrete", broad_phase=phase, substeps=1, iterations=1)
    world.add_balls(np.zeros((150, 2)) + np.arange(150)[:, None] * 1e-3, radius=5.0)
    before = world.balls.position.copy()
    world.step(0.0)
    assert world.statistics.full_tests == 150 * 149 // 2
    assert (before != world.balls.position).any()


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_the_order_of_pairs_depends_on_the_state_alone(phase: str) -> None:
    rng = np.random.default_rng(5)
    balls = [(*rng.uniform(-9, 9, 2), rng.uniform(0.1, 3)) for _ in range(40)]
    assert found_pairs(ball_rows(balls), phase) == found_pairs(ball_rows(balls), phase, room=9999)


@pytest.mark.parametrize("phase", ["grid", "quadtree"])
def test_far_fewer_boxes_are_compared_than_there_are_pairs(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase, levels=8, substeps=1, iterations=1)
    grid = np.stack(np.meshgrid(np.arange(40.0), np.arange(40.0)), -1).reshape(-1, 2)
    world.add_balls(3 * grid, radius=1.0)
    world.step(0.0)
    assert world.statistics.box_tests < 40 * len(world.balls)


def test_pairs_of_a_world_without_or_with_one_ball_are_none() -> None:
    for phase in ("brute", "grid", "quadtree"):
        world = World(detection="discrete", broad_phase=phase)
        assert len(world.step(0.1)) == 0
        world.add(Ball((0, 0), radius=1))
        assert len(world.step(0.1)) == 0
        assert world.statistics.box_tests == 0
