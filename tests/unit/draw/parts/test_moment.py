"""A moment of a run: which bounces are shown of it, and what sizes are relative to."""

import numpy as np
import pytest

from carom import Ball
from carom.draw.parts.moment import LATEST, MOST_LATEST, Balls, Measures, bounces_of, latest_of, strong, strongest
from carom.rows.hit import HIT
from carom.rows.tables import Rows
from carom.world.hits import HitKind
from tests.worlds import world_of


@pytest.mark.parametrize(("values", "few"), [([], 1.0), ([0.0, 0.0], 1.0), ([1.0, 2.0, 3.0], 2.9)])
def test_sizes_are_relative_to_what_few_exceed(values: list[float], few: float) -> None:
    assert strong(np.array(values)) == pytest.approx(few)


def bounces(*rows: tuple[float, float]) -> Rows:
    """Bounces at times, of impulses."""
    hits = np.zeros(len(rows), HIT)
    hits["time"], hits["impulse"] = np.array(rows).reshape(-1, 2).T
    return hits


def test_the_strongest_come_first_and_of_equal_ones_the_earliest() -> None:
    hits = bounces((0.0, 1.0), (1.0, 5.0), (2.0, 3.0), (3.0, 5.0), (4.0, 2.0))
    assert strongest(hits, 3)["time"].tolist() == [1.0, 3.0, 2.0]
    assert len(strongest(hits, 99)) == 5


def test_the_latest_are_those_of_the_last_second_and_not_too_many() -> None:
    hits = bounces(*[(0.1 * k, 1.0) for k in range(21)])
    assert latest_of(hits, 2.0)["time"].tolist() == hits["time"][11:].tolist()
    assert latest_of(hits, 2.0 + LATEST).tolist() == []
    crowd = bounces(*[(0.001 * k, 1.0) for k in range(200)])
    assert latest_of(crowd, 0.2)["time"].tolist() == crowd["time"][-MOST_LATEST:].tolist()


def test_what_sensors_saw_is_no_bounce() -> None:
    hits = bounces((0.0, 1.0), (1.0, 2.0), (2.0, 3.0))
    hits["kind"] = HitKind.BOUNCE, HitKind.ENTER, HitKind.EXIT
    assert bounces_of(hits)["time"].tolist() == [0.0]


def test_measures_leave_out_what_rests_or_is_not_there() -> None:
    velocities = np.array([[3.0, 4.0], [0.0, 0.0], [np.nan, 1.0]])
    assert Measures.of(bounces((0.0, 2.0)), velocities) == Measures(2.0, 1.0, 5.0)


def test_balls_are_copies_of_what_they_are_now_and_wake_nobody() -> None:
    world = world_of(Ball((1, 2), 0.5, velocity=(3, 4)), sleep_speed=9.0)
    world.run(2.0)
    balls = Balls.of(world)
    assert (balls.ids.tolist(), balls.radii.tolist()) == ([1], [0.5])
    assert world.statistics.sleeping == 1
    world.step(0.1)
    assert world.statistics.sleeping == 1
    before = balls.centers.tolist()
    world.balls[0].position = (9, 9)
    assert balls.centers.tolist() == before
