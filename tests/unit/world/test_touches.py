"""Touches: hits of a ball that has not left what it hit are one."""

from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.rows.hit import BOUNCE, ENTER, EXIT, HIT
from carom.world.touches import LOWEST_HOP, TOUCH, Touching, touches_of
from tests.worlds import crowded

SPEEDS = st.sampled_from([0.0, 0.25, 1.0, 4.0])


@st.composite
def streams(draw: Any) -> np.ndarray:
    """Hits of a few balls at a few shapes: slow and fast ones, and comings and goings, in order of time."""
    rows = draw(st.lists(st.tuples(st.sampled_from([BOUNCE, BOUNCE, ENTER, EXIT]), *[st.integers(1, 2)] * 2, SPEEDS)))
    hits = np.zeros(len(rows), HIT)
    for place, (hit, (kind, ball, shape, speed)) in enumerate(zip(hits, rows, strict=True)):
        hit["time"], hit["kind"], hit["ball"], hit["shape"] = 0.1 * place, kind, ball, shape
        hit["normal"], hit["velocity"], hit["speed"] = (0.6, 0.8), (-0.6 * speed, -0.8 * speed), 1.0 + place % 3
        hit["impulse"], hit["point"], hit["position"] = float(place % 5), (place, 1), (place + 0.6, 1.8)
    return hits


def naive(hits: np.ndarray) -> list[dict[str, Any]]:
    """The touches of hits, one hit after the other."""
    touches: list[dict[str, Any]] = []
    open_touch: dict[tuple[int, int], dict[str, Any]] = {}
    last: dict[tuple[int, int], np.void] = {}
    for hit in hits:
        pair = (int(hit["ball"]), int(hit["shape"]))
        before = last.get(pair)
        same = False
        if before is not None and hit["kind"] == before["kind"] == BOUNCE:
            rise = min(abs(float(hit["velocity"] @ hit["normal"])), hit["speed"]) * (hit["time"] - before["time"]) / 4
            same = rise <= LOWEST_HOP * np.linalg.norm(hit["position"] - hit["point"])
        elif before is not None and hit["kind"] == EXIT:
            same = before["kind"] == ENTER
        last[pair] = hit
        if same:
            touch = open_touch[pair]
            touch["end"], touch["count"] = hit["time"], touch["count"] + 1
            touch["speed"] = max(touch["speed"], hit["speed"])
            touch["impulse"] = max(touch["impulse"], hit["impulse"])
        elif hit["kind"] != EXIT:
            names = ("time", "kind", "ball", "shape", "point", "normal", "speed", "impulse")
            touches.append({name: hit[name] for name in names} | {"end": hit["time"], "count": 1})
            open_touch[pair] = touches[-1]
    return touches


@given(hits=streams())
def test_touches_are_those_that_a_slow_look_at_each_hit_finds(hits: np.ndarray) -> None:
    found, expected = touches_of(hits), naive(hits)
    assert len(found) == len(expected)
    for touch, other in zip(found, expected, strict=True):
        for name in TOUCH.names or ():
            assert np.array_equal(touch[name], other[name]), name


@given(hits=streams(), cuts=st.lists(st.integers(0, 40), max_size=3))
def test_which_hits_begin_a_touch_does_not_depend_on_the_parts_they_come_in(hits: np.ndarray, cuts: list[int]) -> None:
    touching = Touching()
    told = [touching.begins(part) for part in np.split(hits, sorted(min(cut, len(hits)) for cut in cuts))]
    assert np.concatenate(told).tolist() == Touching().begins(hits).tolist()
    assert np.count_nonzero(np.concatenate(told)) == len(naive(hits))


def bowl(detection: Any, elasticity: float) -> tuple[carom.World, carom.Hits]:
    """A ball that is let go at the rim of a bowl of radius 5, for a second."""
    world = carom.World(gravity=(0, -10), detection=detection)
    world.add(carom.Arc((0, 0), 5, pi, 2 * pi, elasticity=elasticity))
    world.add(carom.Ball((-4.5, -0.01), 0.49))
    return world, world.run(1.0)


def test_a_ball_that_rolls_along_an_arc_touches_it_once() -> None:
    world, hits = bowl("discrete", 0.2)
    assert len(hits) > 5
    (touch,) = hits.touches()
    assert touch.count == len(hits)
    assert (touch.time, touch.end) == (hits["time"][0], hits["time"][-1])
    assert (touch.impulse, touch.speed) == (hits["impulse"].max(), hits["speed"].max())
    assert (touch.shape, touch.ball) == (world.shapes[0], world.balls[0])
    assert touch.point == hits[0].point


def test_a_ball_that_whispers_round_a_room_touches_it_once_and_one_that_crosses_it_each_time() -> None:
    for angle, many in ((0.002, False), (0.5, True)):
        world = carom.World(detection="continuous")
        world.add(carom.Circle((0, 0), 1.0))
        world.add(carom.Ball((0.9 - 1e-9, 0), 0.1, velocity=(np.sin(angle), np.cos(angle))))
        hits = world.run(2.0)
        assert len(hits) > 1
        assert len(hits.touches()) == (len(hits) if many else 1)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_each_bounce_that_can_be_seen_is_a_touch(detection: Any) -> None:
    world = carom.World(gravity=(0, -10), detection=detection)
    world.add(carom.Segment((-1, 0), (1, 0)))
    world.add(carom.Ball((0, 0.3 + 0.1), 0.1))
    hits = world.run(2.0)
    assert len(hits) > 2
    assert hits.touches()["count"].tolist() == [1] * len(hits)


def test_a_stay_in_a_sensor_is_a_touch() -> None:
    world = carom.World(detection="continuous")
    eye = world.add(carom.Circle((0, 0), 1, solid=True, sensor=True))
    world.add(carom.Ball((-3, 0), 0.5, velocity=(2, 0)))
    hits = world.run(4.0)
    (touch,) = hits.touches()
    assert (touch.kind, touch.shape, touch.count) == (carom.HitKind.ENTER, eye, 2)
    assert (touch.time, touch.end) == (hits["time"][0], hits["time"][1])
    assert len(hits[1:].touches()) == 0
    assert len(hits[:0].touches()) == 0


def test_touches_are_rows_and_objects_in_order_of_their_first_times() -> None:
    hits = crowded().run(1.0)
    touches = hits.touches()
    assert 0 < len(touches) <= len(hits)
    assert (np.diff(touches["time"]) >= 0).all()
    assert touches["count"].sum() <= len(hits)
    assert [touch.ball.id for touch in touches] == touches["ball"].tolist()
    assert touches[touches["count"] > 1].dtype == touches.dtype
    assert repr(touches) == f"<{len(touches)} touches>"
