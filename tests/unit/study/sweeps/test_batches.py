"""Runs that are copies of one world: who they are, and that each comes to what it would come to alone."""

from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np
import pytest

import carom
from carom.study.measures import by_name
from carom.study.sweeps.batches import MOST_TOGETHER, batches, ends
from carom.study.sweeps.grid import Run, runs_of
from carom.study.sweeps.job import Job, Row
from carom.study.sweeps.sources import Source, source_of
from tests import sweeping

#: A ball between two walls, one that rests, and a way out.
ROOM = carom.Scene(
    world={"bounds": (-2.0, -2.0, 2.0, 2.0), "remove_strays": True, "substeps": 1},
    shapes=[carom.Segment((x, -1), (x, 1), name=name) for x, name in ((-1, "left"), (1, "right"))],
    balls=[carom.Ball((0, 0), 0.1, velocity=(3, 0), name="cue"), carom.Ball((0, 0.9), 0.1)],
)


def together(given: Any, parameters: Any) -> list[list[int]]:
    return batches(source_of(given), runs_of(parameters))


def test_only_what_differs_in_places_and_velocities_is_together() -> None:
    assert together(ROOM, {"seed": range(4)}) == [[0, 1, 2, 3]]
    assert together(ROOM, {"balls[0].velocity": [(1, 0), (2, 0)], "balls.cue.position[1]": [0, 0.1]}) == [[0, 1, 2, 3]]
    assert together(ROOM, {"balls[1].radius": [0.1, 0.2], "seed": range(2)}) == [[0, 1], [2, 3]]
    assert together(ROOM, {"seed": range(2), "world.gravity": [(0, -1), (0.0, -0.0)]}) == [[0, 2], [1, 3]]
    assert together("newtons_cradle", {"balls": [3, 4], "seed": [1, 2]}) == [[0, 1], [2, 3]]


def test_what_a_function_makes_of_its_arguments_is_alone() -> None:
    assert together(sweeping.drop, {"number": [1, 2]}) == [[0], [1]]
    assert together("gas", {"balls": [5], "seed": [1, 2]}) == [[0], [1]]  # this one takes the seed


def test_what_is_wrong_is_alone_and_says_so() -> None:
    assert batches(Source(ROOM, ""), [Run({"balls.cu.velocity": (1, 0)}, None)] * 2) == [[0], [1]]
    assert batches(source_of("newtons_cradle"), [Run({"balls": -1}, 1), Run({"balls": 3}, 1)]) == [[0], [1]]


def test_batches_are_bounded() -> None:
    found = together(ROOM, {"seed": range(2 * MOST_TOGETHER + 3)})
    assert [len(batch) for batch in found] == [MOST_TOGETHER, MOST_TOGETHER, 3]
    assert list(chain.from_iterable(found)) == list(range(2 * MOST_TOGETHER + 3))


def as_alone(given: Any, parameters: Any, seconds: float, measure: str = "hits-by-shape") -> list[Row]:
    """The rows of runs together, which are those that each gives alone."""
    job = Job(source_of(given), by_name(measure), seconds, 1 / 60, carom.__version__)
    named = [(str(place), run) for place, run in enumerate(runs_of(parameters))]
    rows = job.rows(named)
    assert [replace(row, seconds=0.0) for row in rows] == [replace(job.row(*one), seconds=0.0) for one in named]
    assert all(row.seconds > 0.0 for row in rows)
    return rows


@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("measure", ["hits-by-shape", "statistics", "last-state"])
@pytest.mark.parametrize("name", ["toy", "pool", "newtons_cradle", "stadium"])
def test_rows_are_those_of_each_run_alone(name: str, measure: str, detection: str) -> None:
    as_alone(name, {"world.detection": [detection], "seed": range(3)}, 1.0, measure)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_one_that_loses_a_ball_is_as_it_is_alone(detection: str) -> None:
    ways = {"world.detection": [detection], "balls[0].velocity": [(3, 0), (0, 3), (3, 0.1), (0, -9)]}
    as_alone(ROOM, ways, 1.0, "last-state")
    as_alone(ROOM, ways, 1.0, "tests.sweeping:met")


def test_one_that_fails_fails_for_itself() -> None:
    worlds = {"world.detection": ["continuous"], "world.max_impacts": [40]}
    rows = as_alone(ROOM, {**worlds, "balls[0].velocity": [(3.0, 0.0), (4e4, 0.0), (2.0, 0.0)]}, 0.5)
    assert [row.error is None for row in rows] == [True, False, True]
    assert str(rows[1].error).startswith("ImpactLimit")


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_ends_have_the_hits_of_the_world_alone(detection: str) -> None:
    world = ROOM.world.model_copy(update={"detection": detection})
    scenes = [
        ROOM.model_copy(update={"world": world, "balls": (ROOM.balls[0].model_copy(update={"velocity": velocity}),)})
        for velocity in ((3.0, 0.0), (-5.0, 0.01), (0.0, 0.0))
    ]
    count = 0
    for scene, end in zip(scenes, ends(scenes, 1.0, 1 / 60), strict=True):
        alone = scene.build()
        hits = alone.run(1.0)
        assert end is not None
        assert end[0].digest() == alone.digest()
        assert np.array_equal(end[1].view(np.ndarray), hits.view(np.ndarray))
        assert [(hit.ball.name, hit.shape.name) for hit in end[1]] == [(hit.ball.name, hit.shape.name) for hit in hits]
        count += len(hits)
    assert count >= 5


def test_scenes_without_balls_have_an_end_too() -> None:
    empty = ROOM.model_copy(update={"balls": ()})
    for end in ends([empty, empty], 0.1, 1 / 60):
        assert end is not None
        assert (end[0].time, len(end[1])) == (pytest.approx(0.1), 0)
