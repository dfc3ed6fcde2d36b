"""Shapes that move: their first touch with a ball, in slices of time that follow from the two motions alone."""

from math import cos, floor, hypot, inf, pi, sin
from random import Random
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment
from carom.geometry.path import Path
from carom.rows.flight import HIT_SHAPE, LOOK, NOTHING
from carom.rows.pose import pose, reach_of
from carom.world.kernels.continuous.flight import event_age, path_of, place_after
from carom.world.kernels.continuous.predict_movers import (
    predict_mover,
    predict_movers,
    seen_from_pivot,
    slice_length,
    time_until_near,
)
from carom.world.kernels.continuous.surfaces import gap_to_shape
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world


def mover(kind: int, **motion: Any) -> Any:
    """A shape of a kind that moves."""
    options: dict[str, Any] = {"motion": "kinematic", "pivot": (0, 0)} | motion
    return (
        Point((2, 0), **options),
        Segment((-1, 0.2), (2, 0), **options),
        Circle((1, 0.5), 0.7, **options),
        Arc((0.5, 0), 1.2, 0.3, 4.0, **options),
    )[kind]


KINDS = pytest.mark.parametrize("kind", range(4))


def foreseen(arrays: Arrays, age: float) -> tuple[int, float, float]:
    """The touch that is foreseen from an age on, however many looks that takes: event and instant."""
    state, ball, flight, shape = arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    for _ in range(200):
        flight["event"] = NOTHING
        predict_mover(state, ball, flight, shape, 0, age, inf)
        if flight["event"] != LOOK:
            break
        assert event_age(flight) > age
        age = event_age(flight)
    return int(flight["event"]), float(flight["event_time"]), float(flight["event_low"])


def launched(kind: int, seed: int, **settings: Any) -> Arrays:
    """A shape that turns and travels, and a ball that comes towards it."""
    random = Random(seed)
    angle = random.uniform(0, 2 * pi)
    motion = {"angular_velocity": random.choice((-3.0, 0.4, 0.0)), "velocity": (random.uniform(-1, 1), 0.3)}
    velocity = -4 * cos(angle) + random.uniform(-0.5, 0.5), -4 * sin(angle) + random.uniform(-0.5, 0.5)
    ball = Ball((7 * cos(angle), 7 * sin(angle)), random.uniform(0.1, 0.5), velocity=velocity)
    return in_flight(continuous_world(mover(kind, **motion), ball, **settings))


def past_an_end(arrays: Arrays, age: float) -> bool:
    """True if the ball was deep in the shape already when that slice of time began, so it came past an end of it."""
    ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    radius = float(ball["radius"])
    length = slice_length(shape, path_of(ball, flight), reach_of(shape) + radius, radius)
    begin = floor(age / length + 1e-9) * length
    x, y, vx, vy = place_after(ball, flight, begin)
    gap = gap_to_shape(shape, begin, x, y, radius, vx, vy)
    return gap is not None and gap[0] < -1e-3 * radius


@pytest.mark.slow
@KINDS
@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.2, -1.5)])
def test_what_is_foreseen_is_the_first_touch(kind: int, gravity: tuple[float, float]) -> None:
    seen = 0
    for seed in range(40):
        arrays = launched(kind, seed, gravity=gravity)
        ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
        event, time, low = foreseen(arrays, 0.0)
        end = time + low if event == HIT_SHAPE else 6.0
        for age in [*np.linspace(0, end, 300, endpoint=False), end]:
            x, y, vx, vy = place_after(ball, flight, float(age))
            gap = gap_to_shape(shape, float(age), x, y, float(ball["radius"]), vx, vy)
            # What has come past an end overlaps without a touch; nothing comes through a side.
            if gap is not None and age == end and event == HIT_SHAPE:
                seen += 1
                assert gap[0] == pytest.approx(0.0, abs=1e-9) or (kind in (1, 3) and past_an_end(arrays, end))
            elif kind in (0, 2) and gap is not None:
                assert gap[0] > -1e-9
    assert seen >= 4


@KINDS
@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.2, -1.5)])
def test_from_any_age_of_a_flight_the_same_touch_is_foreseen_to_the_bit(
    kind: int, gravity: tuple[float, float]
) -> None:
    seen = 0
    for seed in range(30):
        arrays = launched(kind, seed, gravity=gravity)
        expected = foreseen(arrays, 0.0)
        if expected[0] != HIT_SHAPE:
            continue
        seen += 1
        for share in (1e-9, 0.3, 0.5, 0.9, 0.999, 1 - 1e-9):
            assert foreseen(arrays, share * expected[1]) == expected
    assert seen >= 2


@KINDS
def test_a_touch_is_the_same_whether_shape_or_ball_began_first(kind: int) -> None:
    for shape_first in (True, False):
        arrays = launched(kind, 3, gravity=(0, -1))
        ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
        expected = foreseen(arrays, 0.0)
        if expected[0] != HIT_SHAPE:
            continue
        # The same motions, told from another beginning of one of them.
        if shape_first:
            shape["since"] = -0.25
            shape["pivot_x"] -= 0.25 * shape["velocity_x"]
            shape["pivot_y"] -= 0.25 * shape["velocity_y"]
            shape["orientation_before"] = shape["orientation"] = -0.25 * shape["spin"]
            pose(shape)
        else:
            x, y, vx, vy = place_after(ball, flight, -0.25)
            ball["x"], ball["y"], ball["vx"], ball["vy"], flight["time"] = x, y, vx, vy, -0.25
        event, time, low = foreseen(arrays, 0.0 if shape_first else 0.25)
        assert event == HIT_SHAPE
        assert time + low == pytest.approx(expected[1] + expected[2], rel=1e-12)


@KINDS
def test_a_shape_stays_within_its_reach_and_a_ball_within_its_part_in_a_slice(kind: int) -> None:
    arrays = launched(kind, 2, gravity=(0.5, -3))
    shape, path = arrays.shapes.rows[0], path_of(arrays.balls.rows[0], arrays.flights[0])
    reach = reach_of(shape)
    for x, y in ((shape["left"], shape["bottom"]), (shape["right"], shape["top"]), (shape["left"], shape["top"])):
        assert hypot(x - shape["pivot_x"], y - shape["pivot_y"]) <= reach * (1 + 1e-12)
    length = slice_length(shape, path, reach, 0.1)
    x0, y0 = seen_from_pivot(shape, path, 0.0, 0.0)[:2]
    x1, y1 = seen_from_pivot(shape, path, 0.0, length)[:2]
    assert 0.0 < hypot(x1 - x0, y1 - y0) <= max(0.25 * reach, 0.1) * (1 + 1e-12)
    assert abs(float(shape["spin"])) * length <= 0.5


def test_a_ball_that_stands_still_by_a_shape_that_does_has_endless_slices() -> None:
    arrays = in_flight(continuous_world(mover(1), Ball((1, 3), 0.5)))
    shape, path = arrays.shapes.rows[0], path_of(arrays.balls.rows[0], arrays.flights[0])
    assert slice_length(shape, path, 2.0, 0.5) == inf
    assert foreseen(arrays, 0.0)[0] == NOTHING


def test_a_ball_is_near_when_it_comes_within_reach() -> None:
    still = Path(0.0, 5.0, 0.0, 0.0, 0.0, 0.0)
    assert time_until_near(still, 2.0, 0.1) == inf
    assert time_until_near(still, 6.0, 0.1) == 0.0
    comes = time_until_near(Path(0.0, 5.0, 0.0, -1.0, 0.0, 0.0), 2.0, 0.1)
    assert comes == pytest.approx(3.0, rel=1e-3)
    assert comes <= 3.0
    assert time_until_near(Path(0.0, 5.0, 0.0, 1.0, 0.0, 0.0), 2.0, 0.1) == inf
    assert time_until_near(Path(0.0, 5.0, 0.0, 1.0, 0.0, -1.0), 2.0, 0.1) < inf


def test_a_ball_far_from_a_mill_is_not_looked_at_again_and_again() -> None:
    arrays = in_flight(continuous_world(mover(1, angular_velocity=30.0), Ball((1e6, 0), 0.5, velocity=(-10, 0))))
    event, time, _low = foreseen(arrays, 0.0)
    assert event == HIT_SHAPE
    assert time == pytest.approx(1e5, rel=1e-4)
    assert arrays.states[0]["full_tests"] < 100
    arrays = in_flight(continuous_world(mover(1, angular_velocity=30.0), Ball((1e6, 0), 0.5, velocity=(10, 0))))
    assert foreseen(arrays, 0.0)[0] == NOTHING


@pytest.mark.parametrize("seed", range(60))
def test_a_shape_that_travels_is_met_or_passed_past_its_ends_as_one_at_rest(seed: int) -> None:
    random, hits = Random(seed), []
    place, velocity, drift = ([random.uniform(-size, size) for _ in range(2)] for size in (5.0, 3.0, 1.0))
    for moves in (True, False):
        world = continuous_world(Segment((-1, 0.2), (2, 0), motion="kinematic", velocity=drift if moves else (0, 0)))
        seen = velocity if moves else np.subtract(velocity, drift)
        world.add(Ball((place[0] + 7, place[1]), 0.4, velocity=(float(seen[0]) - 3, float(seen[1]))))
        hits.append(world.step(8.0)["time"].tolist())
    assert hits[0] == pytest.approx(hits[1], abs=1e-9)


def test_of_shapes_that_touch_a_ball_at_one_time_the_first_is_foreseen_however_they_are_listed() -> None:
    turning = {"motion": "kinematic", "pivot": (0.0, 0.0), "angular_velocity": 1.0}
    walls = [
        Segment((-2, 0.0), (2, 0.0), **turning),
        Segment((2, 0.1), (-2, 0.1), **turning),
        Circle((0, 0), 3, **turning),
    ]
    arrays = in_flight(continuous_world(*walls, Ball((1.0, 0.3), 0.5, velocity=(0.0, -1.0))))
    ball, flight, shapes = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows
    for members in ([0, 1, 2], [1, 0, 2], [2, 1, 0]):
        flight["event"] = NOTHING
        predict_movers(
            arrays.states[0], ball, flight, shapes, np.array(members, "i4"), arrays.relations, 0, 3, 0.0, inf
        )
        assert (flight["event"], flight["partner"], event_age(flight)) == (HIT_SHAPE, 0, 0.0)
