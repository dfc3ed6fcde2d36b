"""`Hits`: structured arrays that iterate to the very objects that met."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import crowded, named, quiet

FIELDS = ("time", "kind", "ball", "shape", "point", "normal", "setback", "speed", "impulse", "velocity", "position")


def some_hits() -> tuple[carom.World, carom.Hits]:
    """A world and what happened in it: bounces, and a sensor entered and left."""
    world = crowded()
    return world, world.run(3.0)


def test_hits_iterate_to_the_very_objects_that_were_added() -> None:
    world = quiet()
    wall, eye = world.shapes
    down, up = world.balls
    hits = world.run(2.0)
    told = [(hit.kind, hit.ball, hit.shape) for hit in hits]
    kinds = carom.HitKind
    assert told.count((kinds.BOUNCE, down, wall)) == 1
    assert told.count((kinds.ENTER, up, eye)) == told.count((kinds.EXIT, up, eye)) == 1
    (bounce,) = [hit for hit in hits if hit.shape is wall]
    assert bounce.point == (-2.0, 0.0)
    assert bounce.normal == (0.0, 1.0)
    assert bounce.speed == 3.0
    assert bounce.impulse == 6.0
    assert 0.0 < bounce.setback < 3 / 240
    assert type(bounce.time) is type(bounce.speed) is float


def test_of_two_balls_the_shape_is_the_one_that_was_added_first() -> None:
    world = carom.World()
    first, second = world.add(carom.Ball((0, 0), 1)), world.add(carom.Ball((-3, 0), 1, (5, 0)))
    (hit,) = world.step(0.5)
    assert (hit.shape, hit.ball) == (first, second)
    assert hit.normal == (-1, 0)


def test_the_balls_of_hits_need_not_have_been_asked_for() -> None:
    world = carom.World()
    world.add(carom.Segment((-5, 0), (5, 0)))
    world.add_balls([(0, 1)], (0, -1), 0.5)
    (hit,) = world.run(1.0)
    assert hit.ball is world.balls[0] is world.object(hit.ball.id)


def test_hits_stand_in_the_order_of_time_within_the_run() -> None:
    world, hits = some_hits()
    assert len(hits) > 20
    assert (np.diff(hits["time"]) >= 0.0).all()
    assert hits["time"][0] > 0.0
    assert hits["time"][-1] <= world.time
    again = world.run(1.0)
    assert again["time"][0] > 3.0


def test_hits_are_an_array_of_their_fields() -> None:
    _, hits = some_hits()
    assert isinstance(hits, np.ndarray)
    assert hits.dtype.names == FIELDS
    assert hits["point"].shape == hits["normal"].shape == (len(hits), 2)
    assert type(hits["speed"]) is np.ndarray
    assert [hit.speed for hit in hits] == hits["speed"].tolist()
    assert [hit.point for hit in hits] == [tuple(point) for point in hits["point"]]
    assert [hit.ball.id for hit in hits] == hits["ball"].tolist()
    assert [hit.shape.id for hit in hits] == hits["shape"].tolist()


def test_parts_of_hits_are_hits() -> None:
    _, hits = some_hits()
    fast = hits[hits["speed"] > np.median(hits["speed"])]
    for part in (fast, hits[2:5], hits[[1, 3]], np.sort(hits, order="speed"), hits.copy()):
        assert isinstance(part, carom.Hits)
        assert [hit.ball.id for hit in part] == part["ball"].tolist()
    assert hits[0] == hits[np.int64(0)] == next(iter(hits)) == hits[:1][0]
    assert hits[-1].time == hits["time"][-1]
    assert max(hits, key=lambda hit: hit.speed).speed == hits["speed"].max()
    with pytest.raises(IndexError):
        hits[len(hits)]


def test_hits_as_a_condition_say_whether_there_are_any() -> None:
    world, hits = some_hits()
    assert hits
    assert hits[:1]
    assert not hits[:0]
    assert not carom.World().step(0.1)
    assert repr(hits) == f"<{len(hits)} hits>"
    assert world.run(0.0).dtype == hits.dtype


def test_later_steps_leave_earlier_hits_alone() -> None:
    world, hits = some_hits()
    before = np.asarray(hits).copy()
    world.run(2.0)
    assert hits.tobytes() == before.tobytes()


def test_sensors_say_enter_and_exit_once_each_with_where_the_ball_is() -> None:
    world = quiet()
    up, eye = named(world, "up"), named(world, "eye")
    hits = [hit for hit in world.run(3.0) if hit.shape is eye]
    assert [(hit.kind, hit.ball) for hit in hits] == [(carom.HitKind.ENTER, up), (carom.HitKind.EXIT, up)]
    for hit in hits:
        assert (hit.setback, hit.impulse) == (0, 0)
        assert hit.velocity == up.velocity == (0.0, 3.0)
    enter, leave = hits
    assert leave.position[1] - enter.position[1] == pytest.approx(3.0 * (leave.time - enter.time))
    assert (enter.normal, enter.speed) == ((0.0, -1.0), 3.0)
    assert eye.distance(enter.point) == 0.0
    assert (leave.point, leave.normal, leave.speed) == ((0, 0), (0, 0), 0)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_a_ball_leaves_each_hit_as_it_comes_to_the_next(detection: Any) -> None:
    world = carom.World(detection=detection, substeps=8)
    ball = world.add(carom.Ball((0.3, 0.1), 0.1, (1.7, 2.3), mass=2.0))
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        world.add(carom.Segment(a, b))
    world.add(carom.Circle((0, 0), 0.2))
    hits = world.run(3.0)
    assert len(hits) > 5
    velocity, normal = hits["velocity"], hits["normal"]
    assert hits["speed"] == pytest.approx(np.linalg.norm(velocity, axis=1))
    after = velocity + (hits["impulse"] / ball.mass)[:, None] * normal
    assert after[:-1] == pytest.approx(velocity[1:])
    assert after[-1] == pytest.approx(ball.velocity)
    # At each hit the ball touches, where it has been put.
    assert hits["position"] - hits["point"] == pytest.approx((0.1 * normal), abs=0.05)
    assert [hit.shape.distance(hit.position) for hit in hits] == (pytest.approx([0.1] * len(hits), abs=1e-12))
    if detection == "continuous":
        flown = after[:-1] * np.diff(hits["time"])[:, None]
        assert hits["position"][1:] == pytest.approx(hits["position"][:-1] + flown, abs=1e-12)


def test_of_two_balls_velocity_and_position_are_those_of_the_one_that_was_added_last() -> None:
    for detection in ("discrete", "continuous"):
        world = carom.World(detection=detection)
        world.add(carom.Ball((0, 0), 1, (0.5, 0.0)))
        last = world.add(carom.Ball((3, 0), 1, (-1.5, 0.0)))
        (hit,) = world.run(1.0)
        assert (hit.ball, hit.velocity) == (last, (-1.5, 0.0))
        assert hit.speed == 2.0
        assert hit.position[0] == pytest.approx(2.25, abs=0.01 if detection == "discrete" else 1e-12)


def test_a_sensor_that_a_ball_starts_in_is_entered_by_the_first_step() -> None:
    world = carom.World()
    world.add(carom.Circle((0, 0), 2, sensor=True, solid=True))
    world.add(carom.Ball((0, 0), 1))
    assert [hit.kind for hit in world.run(1.0)] == [carom.HitKind.ENTER]


def test_copies_know_their_objects_and_pickled_hits_are_arrays() -> None:
    _, hits = some_hits()
    for twin in (copy.copy(hits), copy.deepcopy(hits)):
        assert twin[0].ball is hits[0].ball
    lost = pickle.loads(pickle.dumps(hits))
    assert lost["speed"].tolist() == hits["speed"].tolist()
    with pytest.raises(carom.LostObject, match="do not know their world"):
        lost[0]


def test_a_hit_cannot_be_changed() -> None:
    _, hits = some_hits()
    with pytest.raises(AttributeError):
        hits[0].speed = 0.0


def test_the_table_holds_the_same_columns() -> None:
    pytest.importorskip("pyarrow")
    _, hits = some_hits()
    table = hits.table()
    names = ["time", "kind", "ball", "shape", "point_x", "point_y", "normal_x", "normal_y"]
    assert table.column_names == [
        *names,
        "setback",
        "speed",
        "impulse",
        *(f"{name}_{axis}" for name in ("velocity", "position") for axis in "xy"),
    ]
    for name in ("time", "kind", "ball", "shape", "setback", "speed", "impulse"):
        assert table[name].to_numpy().tobytes() == hits[name].tobytes()
    for place, axis in enumerate("xy"):
        for name in ("point", "normal", "velocity", "position"):
            assert table[f"{name}_{axis}"].to_pylist() == hits[name][:, place].tolist()
    assert [str(field.type) for field in table.schema][:4] == ["double", "int64", "int64", "int64"]


def test_the_table_of_no_hits_has_all_columns() -> None:
    pytest.importorskip("pyarrow")
    _, hits = some_hits()
    assert hits[:0].table().schema == hits.table().schema
    assert hits[hits["kind"] == carom.HitKind.ENTER].table().num_rows == (hits["kind"] == 1).sum()


def test_the_table_asks_for_pyarrow_where_it_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    _, hits = some_hits()
    monkeypatch.setitem(__import__("sys").modules, "pyarrow", None)
    with pytest.raises(ImportError, match=r"carom\[study\]"):
        hits.table()
