"""Quadtrees: where they are split, where they are not, and in which leaf a place is."""

from math import inf

import numpy as np
import pytest

from carom import World
from carom.constants import LEAF_MEMBERS
from carom.rows.index import CELL, NO_CHILD
from carom.rows.shape import SHAPE
from carom.world.kernels.broad_phase.pairs import plant_ball_tree
from carom.world.kernels.broad_phase.quadtree import build_tree, locate_node, plant_root
from tests.kernel_calls import Ball, ball_rows, state_row


def planted(balls: list[Ball], levels: int, arrays: int = 4096) -> tuple[np.ndarray, np.ndarray, int]:
    """The nodes and members of a tree of balls, and how many nodes there are."""
    rows = ball_rows(balls)
    cells, members = np.zeros(arrays, CELL), np.zeros(8 * arrays, "i4")
    end = plant_ball_tree(state_row(rows, "quadtree", levels), rows, np.zeros(0, SHAPE), cells, members, 0, 0)
    return cells, members, end


SPREAD = [(float(x), float(y), 0.1) for x in range(8) for y in range(8)]


def test_a_tree_of_one_level_is_its_root() -> None:
    cells, members, end = planted(SPREAD, 1)
    assert end == 1
    assert cells[0]["child"] == NO_CHILD
    assert members[: cells[0]["end"]].tolist() == list(range(64))


@pytest.mark.parametrize("levels", [2, 3, 4, 9])
def test_no_leaf_is_deeper_than_the_levels_or_fuller_than_need_be(levels: int) -> None:
    cells, _, end = planted(SPREAD, levels)
    leaves = cells[:end][cells[:end]["child"] == NO_CHILD]
    assert leaves["depth"].max() <= levels - 1
    full = leaves[leaves["end"] - leaves["begin"] > LEAF_MEMBERS]
    assert (full["depth"] == levels - 1).all()
    assert len(leaves) == min(4 ** (levels - 1), 16)


def test_every_ball_is_in_the_leaf_of_its_centre() -> None:
    cells, members, _ = planted(SPREAD, 6)
    for k, (x, y, _) in enumerate(SPREAD):
        leaf = cells[locate_node(cells, 0, x, y)]
        assert k in members[leaf["begin"] : leaf["end"]]


def test_a_place_outside_belongs_to_the_nearest_leaf() -> None:
    cells, _, _ = planted(SPREAD, 6)
    assert locate_node(cells, 0, -1e300, -1e300) == locate_node(cells, 0, 0.0, 0.0)
    assert locate_node(cells, 0, 1e300, 3.1) == locate_node(cells, 0, 7.0, 3.1)


def test_a_node_that_all_boxes_cover_is_not_split() -> None:
    cells, _, end = planted([(0.01 * k, 0.0, 1.0) for k in range(50)], 16)
    assert end == 1
    assert cells[0]["child"] == NO_CHILD
    cells, _, end = planted([(0.01 * k, 0.0, 1.0) for k in range(50)] + [(100.0, 100.0, 0.1)], 16)
    assert 1 < end < 50


def test_a_tree_of_a_crowd_has_no_more_nodes_than_there_are_pairs() -> None:
    places = np.random.default_rng(1).uniform(-4, 4, (60, 2)).tolist()
    _, _, end = planted([(x, y, 1.0) for x, y in places], 16)
    assert end < 60 * 59 / 2


def test_a_world_of_crowded_balls_and_many_levels_stays_small() -> None:
    world = World(detection="discrete", broad_phase="quadtree", levels=16, substeps=1, iterations=1)
    world.add_balls(np.random.default_rng(0).uniform(-9, 9, (60, 2)), radius=2.0)
    world.step(0.0)
    assert len(world._arrays.cells) < 10_000


def test_a_tree_that_runs_out_of_room_says_how_much_it_wants() -> None:
    rows = ball_rows(SPREAD)
    state = state_row(rows, "quadtree", 6)
    shapes = np.zeros(0, SHAPE)
    assert plant_ball_tree(state, rows, shapes, np.zeros(0, CELL), np.zeros(9, "i4"), 0, 0) == -1
    assert (state["wanted_cells"], state["wanted_members"]) == (1, 64)
    assert plant_ball_tree(state, rows, shapes, np.zeros(3, CELL), np.zeros(999, "i4"), 0, 0) == -1
    assert state["wanted_cells"] == 5
    assert plant_ball_tree(state, rows, shapes, np.zeros(999, CELL), np.zeros(70, "i4"), 0, 0) == -1
    assert state["wanted_members"] > 70


def test_a_tree_as_wide_as_numbers_reach_is_a_leaf() -> None:
    rows = ball_rows(SPREAD)
    cells = np.zeros(9, CELL)
    plant_root(cells[0], 0.0, 0.0, 0, 64)
    state = state_row(rows, "quadtree", 6)
    end = build_tree(state, rows, np.zeros(0, SHAPE), True, 0.0, cells, np.arange(64, dtype="i4"), 0, inf, 1.0)
    assert end == 1
