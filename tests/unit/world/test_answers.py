"""Answers to queries: an object or None for one, rows with objects behind them for many."""

import pickle

import pytest

import carom
from carom import Segment
from tests.worlds import world_of


def test_an_array_of_rays_gives_a_row_for_each() -> None:
    wall = Segment((5, -1), (5, 1))
    world = world_of(wall)
    hits = world.ray_cast((0, 0), [(10, 0), (0, 10), (10, 1)])
    assert hits.found.tolist() == [True, False, True]
    assert hits["shape"].tolist() == [wall.id, 0, wall.id]
    assert hits["fraction"].tolist() == [0.5, 1.0, 0.5]
    assert hits["point"].tolist() == [[5, 0], [0, 10], [5, 0.5]]
    assert hits["normal"].tolist() == [[-1, 0], [0, 0], [-1, 0]]
    assert hits[1] is None
    assert list(hits) == [world.ray_cast((0, 0), target) for target in ((10, 0), (0, 10), (10, 1))]
    assert repr(hits) == "<CastHits: 2 of 3 found something>"
    assert list(hits[hits.found])[1].point == (5, 0.5)
    assert world.ray_cast([(0, 0), (9, 0)], (5, 0))["normal"].tolist() == [[-1, 0], [1, 0]]


def test_answers_outlive_what_they_name_and_lose_their_world_in_a_pickle() -> None:
    wall = Segment((5, -1), (5, 1))
    world = world_of(wall)
    hits = world.ray_cast((0, 0), [(10, 0)])
    world.remove(wall)
    assert hits[0].shape is wall
    before = world.snapshot()
    world.add_balls([(5, 0)], radius=1)
    rows = world.ray_cast((0, 0), [(10, 0)])
    world.restore(before)
    with pytest.raises(carom.LostObject, match="has left the world"):
        rows[0]
    copied = pickle.loads(pickle.dumps(hits))
    assert copied["fraction"].tolist() == [0.5]
    with pytest.raises(carom.LostObject):
        copied[0]
