"""What moves and what happens, as columns of a page."""

from math import pi

import numpy as np
import pytest

from carom.draw.page.columns import (
    ABSENT,
    ASLEEP,
    AWAKE,
    MOST_HITS,
    Units,
    ball_columns,
    filled,
    hit_columns,
    kept_hits,
    numbers_of,
    pose_columns,
)
from carom.rows.hit import HIT
from carom.shapes.aabb import Aabb
from carom.world.hits import HitKind
from tests.pages.runs import bare_runs, changing_run, furnished_run, sleepy_run
from tests.unit.draw.page.unpacking import unpacked


def hits_of(count: int) -> np.ndarray:
    """So many bounces, each stronger than the one before, and an entry into a sensor first of all."""
    hits = np.zeros(count + 1, HIT)
    hits["time"] = hits["impulse"] = np.arange(count + 1)
    hits["kind"][1:] = HitKind.BOUNCE
    hits["kind"][0] = HitKind.ENTER
    return hits


def test_of_too_many_hits_the_strongest_are_kept_in_order_of_time_and_what_sensors_saw() -> None:
    hits = hits_of(MOST_HITS + 10)
    kept = kept_hits(hits)
    assert len(kept) == MOST_HITS
    assert kept["kind"][0] == HitKind.ENTER
    assert np.array_equal(kept["time"][1:], np.arange(12, MOST_HITS + 11))
    assert len(kept_hits(hits[:MOST_HITS])) == MOST_HITS


def test_places_and_states_of_balls_come_back() -> None:
    run = changing_run()
    units = Units.of(run, Aabb(0.0, 0.0, 4.0, 2.0))
    columns = ball_columns(run, units)
    states = unpacked(columns["states"])
    assert states.shape == (len(run.ids), len(run))
    there = ~np.isnan(run.positions[:, :, 0].T)
    assert ((states != ABSENT) == there).all()
    for axis, name in enumerate("xy"):
        column = columns[name]
        places = column["first"] + column["unit"] * unpacked(column)
        assert places[there] == pytest.approx(run.positions[:, :, axis].T[there], abs=4.0 / 2**20)


def test_a_ball_that_sleeps_and_one_that_is_lost_are_told_apart_from_one_that_is_there() -> None:
    sleepy = unpacked(ball_columns(sleepy_run(), Units.of(sleepy_run(), Aabb(0, 0, 9, 1)))["states"])
    assert set(sleepy[0].tolist()) == {AWAKE, ASLEEP}
    assert sleepy[0].tolist() == sorted(sleepy[0].tolist())
    lost = bare_runs()["a ball that is lost"]
    states = unpacked(ball_columns(lost, Units.of(lost, Aabb(0, 0, 1, 1)))["states"])[0]
    assert (states[0], states[-1]) == (AWAKE, ABSENT)


def test_what_is_not_there_is_filled_with_what_was() -> None:
    values = np.array([[1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 8.0]])
    there = np.array([[True, False, False, True], [False, False, True, False]])
    assert filled(values, there, 9.0).tolist() == [[1, 1, 1, 4], [9, 9, 7, 7]]
    assert filled(values[:, :0], there[:, :0], 9.0).size == 0


def test_the_poses_of_moving_shapes_come_back() -> None:
    run = furnished_run()
    columns = pose_columns(run, Units.of(run, Aabb(0.0, 0.0, 12.0, 8.0)))
    for place, name in enumerate(("x", "y", "turns")):
        column = columns[name]
        found = column["first"] + column["unit"] * unpacked(column)
        assert found == pytest.approx(run.poses[:, :, place].T % (2 * pi if name == "turns" else 1e9), abs=1e-4)


def test_hits_come_back_with_the_numbers_of_whom_they_are() -> None:
    run = furnished_run()
    columns, hits = hit_columns(run, Units.of(run, Aabb(0.0, 0.0, 12.0, 8.0))), run.hits
    assert columns["total"] == len(hits) > 5
    assert run.ids[unpacked(columns["ball"])[0]].tolist() == hits["ball"].tolist()
    everyone = np.concatenate([run.shape_ids, run.ids])
    assert everyone[unpacked(columns["thing"])[0]].tolist() == hits["shape"].tolist()
    time = columns["time"]
    assert time["first"] + time["unit"] * unpacked(time)[0] == pytest.approx(hits["time"], abs=1e-8)
    angle = columns["normal"]["unit"] * unpacked(columns["normal"])[0]
    bounced = hits["kind"] == HitKind.BOUNCE
    assert np.cos(angle)[bounced] == pytest.approx(hits["normal"][bounced, 0], abs=1e-3)


def test_who_is_not_among_the_ids_has_the_number_after_the_last() -> None:
    assert numbers_of(np.array([7, 3, 9, 4]), np.array([4, 9, 7])).tolist() == [2, 3, 1, 0]
    assert numbers_of(np.array([7]), np.array([], int)).tolist() == [0]
