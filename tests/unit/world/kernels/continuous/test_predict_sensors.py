"""Sensors: when a ball comes onto one past its end, leaves it, or comes off what it passed."""

from copy import copy
from math import cos, floor, inf, nextafter, pi, sin, sqrt
from random import Random
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, World
from carom.constants import SEPARATION_SLACK
from carom.geometry.path import Path
from carom.rows.flight import CLEAR, EXIT_BALL, EXIT_SHAPE, HIT_SHAPE, LOOK, NOTHING
from carom.rows.relation import INSIDE_SHAPE, PASSING
from carom.world.kernels.continuous.flight import event_age, place_after
from carom.world.kernels.continuous.predict_sensors import (
    ON_IT,
    OVERLAPS,
    answer,
    comes_near,
    is_apart,
    looks_clear,
    predict_clear,
    predict_entry,
    predict_exit,
    predict_parting,
    sight_speed,
    top_surface_speed,
)
from carom.world.kernels.step.relations import add_relation
from carom.world.tables import Arrays
from tests.kernel_calls import foresee_own, in_flight, look_at
from tests.worlds import continuous_world

TURNS: dict[str, Any] = {"motion": "kinematic", "pivot": (0, 0), "angular_velocity": 1.3, "velocity": (0.2, -0.1)}


def with_ball(shape: Any, ball: Ball, **settings: Any) -> Arrays:
    """The tables of a world of a sensor and a ball in flight."""
    return in_flight(continuous_world(shape, ball, **settings))


def found(arrays: Arrays, predict: Any, age: float) -> tuple[int, float]:
    """The event that is foreseen from an age on, and its age, however many looks that takes."""
    ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    for _ in range(999):
        flight["event"] = NOTHING
        predict(ball, flight, shape, 0, age)
        if flight["event"] != LOOK:
            break
        if event_age(flight) > 1e3:
            return NOTHING, inf
        assert event_age(flight) > age
        age = event_age(flight)
    return int(flight["event"]), event_age(flight)


SENSORS = {
    "segment": Segment((-2, 0), (2, 0.3), sensor=True),
    "arc": Arc((0, 0), 1.5, 0.4, 4.0, sensor=True),
    "turning segment": Segment((-2, 0), (2, 0.3), sensor=True, **TURNS),
    "turning arc": Arc((0, 0), 1.5, 0.4, 4.0, sensor=True, **TURNS),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SENSORS)
@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.3, -2.0)])
def test_a_ball_is_on_a_sensor_first_where_its_entry_is_foreseen(name: str, gravity: tuple[float, float]) -> None:
    seen = 0
    for angle in np.linspace(0, 2 * pi, 24, endpoint=False):
        ball = Ball((6 * cos(angle), 6 * sin(angle)), 0.4, velocity=(-3 * cos(angle + 0.2), -3 * sin(angle + 0.2)))
        arrays = with_ball(copy(SENSORS[name]), ball, gravity=gravity)
        row, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
        _event, age = found(arrays, predict_entry, 0.0)
        for time in np.linspace(0, min(age, 8.0), 400, endpoint=False):
            assert not answer(row, flight, shape, ON_IT, float(time), -1e-6)
        if age < inf:
            seen += 1
            assert answer(row, flight, shape, ON_IT, age, 0.0)
            assert not answer(row, flight, shape, ON_IT, age - 1e-6, 0.0)
    assert seen >= 4


@pytest.mark.parametrize("name", SENSORS)
@pytest.mark.parametrize("predict", [predict_entry, predict_exit, predict_clear])
def test_from_any_age_of_a_flight_the_same_change_is_foreseen_to_the_bit(name: str, predict: Any) -> None:
    start = (5.0, 0.5) if predict is predict_entry else (1.0, 0.4)
    arrays = with_ball(copy(SENSORS[name]), Ball(start, 0.4, velocity=(-1.5, -0.2)), gravity=(0, 0.02))
    if predict is not predict_entry:
        # Such as are on it, from where that is so.
        question = ON_IT if predict is predict_exit else OVERLAPS
        rows = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
        while not answer(*rows, question, 0.0, 0.0):
            rows[0]["x"] -= 0.1
    expected = found(arrays, predict, 0.0)
    assert 0.0 < expected[1] < inf
    for share in (0.01, 0.2, 0.5, 0.77, 0.999, 1 - 1e-9):
        assert found(arrays, predict, share * expected[1]) == expected


@pytest.mark.parametrize("wall", [None, 2.1, 2.5])
def test_a_ball_enters_a_moving_sensor_past_its_end_whatever_else_comes(wall: float | None) -> None:
    world = continuous_world(Segment((0, 0), (3, 0), sensor=True, motion="kinematic", velocity=(1, 0)))
    world.add(Ball((5, 0.1), 0.25))
    if wall is not None:
        x = 5.25 + 2 * wall
        world.add(Segment((x, -5), (x, 5), motion="kinematic", velocity=(-2, 0)))
    hits = world.step(3.0)
    assert hits[0].time == pytest.approx(2.0, abs=1e-8)
    assert len(hits) == (1 if wall is None else 3 if wall < 2.2 else 2)


@pytest.mark.parametrize("place", [2.9, 3.05, 3.2])
def test_a_bar_that_turns_senses_a_ball_near_its_tip_as_often_as_the_ball_is_beside_it(place: float) -> None:
    world = continuous_world(Segment((0, 0), (3, 0), sensor=True, pivot=(0, 0), motion="kinematic", angular_velocity=1))
    world.add(Ball((0, place), 0.5, velocity=(0, -0.1)))
    times = np.linspace(0, 20, 200_001)
    y = place - 0.1 * times
    along, off = y * np.sin(times), np.abs(y * np.cos(times))
    on = (along >= 0) & (along <= 3) & (off <= 0.5)
    changes = times[1:][on[1:] != on[:-1]]
    assert [hit.time for hit in world.step(20.0)] == pytest.approx(changes, abs=2e-4)


def test_what_is_far_off_costs_few_looks_and_what_never_comes_none() -> None:
    sensor = Segment((0, 0), (3, 0), sensor=True)
    for speed in (-1.0, -1e4, -1e7):
        arrays = with_ball(copy(sensor), Ball((1e5, 0.1), 0.1, velocity=(speed, 0)))
        predict_entry(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], 0, 0.0)
        assert arrays.flights[0]["event"] == HIT_SHAPE
        # As exact as the place is there, 1e5 away.
        assert event_age(arrays.flights[0]) * -speed == pytest.approx(1e5 - 3, abs=1e-8)
    for velocity in ((1.0, 0.0), (-1.0, 1.0), (0.0, -1.0)):
        arrays = with_ball(copy(sensor), Ball((1e3, 0.1), 0.1, velocity=velocity))
        assert not comes_near(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0])
        assert foresee_own(arrays)[0] == NOTHING


@pytest.mark.parametrize("name", SENSORS)
def test_looks_that_are_left_out_would_have_found_nothing(name: str) -> None:
    arrays = with_ball(copy(SENSORS[name]), Ball((9, 2), 0.3, velocity=(-2, -0.4)), gravity=(0, -0.2))
    ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    speed, pull = sight_speed(ball, flight, shape)
    way, left_out = 0.25 * 0.3, 0.0
    for age in np.linspace(0, 6, 60):
        clear = looks_clear(ball, flight, shape, float(age), way)
        left_out += clear
        # From here it goes at most at its speed then, which the pull adds to.
        fastest = speed + pull * 12
        for later in np.linspace(0, clear * way / fastest, 10) if clear > 0.0 else ():
            assert not answer(ball, flight, shape, ON_IT, float(age + later), 0.0)
    assert left_out > 100


@pytest.mark.parametrize("name", SENSORS)
def test_no_place_of_a_shape_moves_faster_than_its_top_speed(name: str) -> None:
    arrays = with_ball(copy(SENSORS[name]), Ball((9, 2), 0.3, velocity=(3, 4)))
    shape = arrays.shapes.rows[0]
    top = top_surface_speed(shape)
    for x, y in ((shape["ax"], shape["ay"]), (shape["bx"], shape["by"]), (shape["left"], shape["top"])):
        spin = float(shape["spin"])
        assert sqrt((shape["velocity_x"] - spin * y) ** 2 + (shape["velocity_y"] + spin * x) ** 2) <= top
    expected = 5 + top if name.startswith("turning") else 5
    assert sight_speed(arrays.balls.rows[0], arrays.flights[0], shape) == (expected, 0)


def test_who_was_put_off_a_sensor_has_left_it_at_once() -> None:
    arrays = with_ball(Circle((0, 0), 1, sensor=True, solid=True), Ball((5, 0), 1, velocity=(1, 0)))
    assert found(arrays, predict_exit, 0.0) == (EXIT_SHAPE, 0.0)
    arrays = with_ball(Point((0, 0)), Ball((5, 0), 1))
    assert found(arrays, predict_clear, 0.0) == (CLEAR, 0.0)


def test_a_ball_that_stands_on_a_sensor_at_rest_stays() -> None:
    arrays = with_ball(Circle((0, 0), 3, sensor=True, solid=True), Ball((0, 0), 1))
    assert found(arrays, predict_exit, 0.0) == (NOTHING, inf)


@pytest.mark.parametrize("kind", [PASSING, INSIDE_SHAPE])
@pytest.mark.parametrize("speed", [1.0, 1e5])
def test_a_relation_ends_at_the_time_of_the_formula(kind: int, speed: float) -> None:
    shape = Circle((0, 0), 3, sensor=kind == INSIDE_SHAPE, solid=True)
    arrays = with_ball(shape, Ball((0, 0), 1, velocity=(speed, 0)))
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, kind, 0)
    for _ in range(99):
        event = foresee_own(arrays)
        if event[0] != LOOK:
            break
        look_at(arrays, event[1])
    assert event[0] == (EXIT_SHAPE if kind == INSIDE_SHAPE else CLEAR)
    # What it passes it is clear of where rounding does not bring it back.
    way = 4.0 if kind == INSIDE_SHAPE else 4.0 + SEPARATION_SLACK
    assert event[1] == pytest.approx(way / speed, rel=1e-12)


@pytest.mark.parametrize("age", [0.0, 0.2, 1.1])
def test_balls_of_which_one_senses_part_when_they_no_longer_overlap(age: float) -> None:
    world = World(detection="continuous", gravity=(0, -1))
    world.add(Ball((0, 0), 1, velocity=(-1, 0), sensor=True), Ball((0.5, 0), 1.5, velocity=(0.5, 0.1)))
    arrays = in_flight(world)
    rows = [(arrays.balls.rows[k], arrays.flights[k]) for k in range(2)]
    (ball, flight), (other, partner) = rows
    assert predict_parting(ball, flight, other, partner, 1, age, 0.0)
    time = event_age(flight)
    assert flight["event"] == EXIT_BALL
    assert is_apart(Path(-0.5, 0, -1.5, 0.1, 0, 0), time, 2.5)
    assert not is_apart(Path(-0.5, 0, -1.5, 0.1, 0, 0), time - 1e-9, 2.5)
    # (0.5 + 1.5t)² + (0.1t)² = 2.5²
    assert time == pytest.approx(max(np.roots([2.26, 1.5, 0.25 - 6.25])), abs=1e-12)
    # Seen from the other, and from any time, it is the same to the bit.
    assert predict_parting(other, partner, ball, flight, 0, 0.37, 0.0)
    assert event_age(partner) == time


def test_balls_that_go_together_do_not_part() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, velocity=(3, 4), sensor=True), Ball((1, 0), 1, (3, 4))))
    rows = arrays.balls.rows[0], arrays.flights[0], arrays.balls.rows[1], arrays.flights[1]
    assert not predict_parting(*rows, 1, 0.0, 0.0)
    assert place_after(rows[0], rows[1], 2.0) == (6, 8, 3, 4)


@pytest.mark.parametrize(("predict", "seeds"), [(predict_exit, range(240, 270)), (predict_entry, range(2650, 2680))])
def test_from_the_very_time_at_which_a_ball_comes_or_leaves_the_same_is_foreseen(predict: Any, seeds: range) -> None:
    # Of round numbers, that may be the time of a look.
    seen = 0
    for seed in seeds:
        random = Random(seed)
        place, velocity = (
            [random.randrange(-8, 9) / 16.0 for _ in range(2)],
            [random.randrange(-3, 4) for _ in range(2)],
        )
        gravity = random.choice([(0.0, 0.0), (0.0, -4.0), (3.0, -4.0)])
        sensors = (
            Segment((-0.5, 0), (0.5, 0), sensor=True),
            Circle((0, 0), 0.5, sensor=True),
            Circle((0, 0), 0.5, sensor=True, solid=True),
            Point((0, 0), sensor=True),
        )
        arrays = with_ball(sensors[random.randrange(4)], Ball(place, 0.25, velocity=velocity), gravity=gravity)
        expected = found(arrays, predict, 0.0)
        if not 0.0 < expected[1] < inf:
            continue
        seen += 1
        for age in (expected[1], nextafter(expected[1], 0.0), floor(16.0 * expected[1]) / 16.0):
            assert found(arrays, predict, age) == expected, (seed, age)
    assert seen > 5


@pytest.mark.parametrize("first", range(0, 600, 200))
def test_from_the_very_time_at_which_balls_part_the_same_is_foreseen(first: int) -> None:
    for seed in range(first, first + 200):
        random = Random(seed)
        place, velocity = (
            [random.randrange(-4, 5) / 16.0 for _ in range(2)],
            [random.randrange(-3, 4) for _ in range(2)],
        )
        world = continuous_world(gravity=random.choice([(0.0, 0.0), (0.0, -4.0), (3.0, -4.0)]))
        world.add(Ball((0, 0), 0.25, sensor=True, velocity=(random.randrange(-3, 4), 0)))
        world.add(Ball(place, random.choice([0.25, 0.5]), velocity=velocity))
        arrays = in_flight(world)
        rows = arrays.balls.rows[0], arrays.flights[0], arrays.balls.rows[1], arrays.flights[1]
        if not predict_parting(*rows, 1, 0.0, 0.0):
            continue
        time, low = float(rows[1]["event_time"]), float(rows[1]["event_low"])
        for age in (time, nextafter(time, 0.0), floor(16.0 * time) / 16.0):
            rows[1]["event"] = NOTHING
            assert predict_parting(*rows, 1, age, 0.0)
            assert (rows[1]["event_time"], rows[1]["event_low"]) == (time, low), (seed, age)


@pytest.mark.parametrize("age", [3.05, 3.3, 3.5, 5.0, 9.0, 13.9])
@pytest.mark.parametrize("motion", ["static", "kinematic"])
def test_who_came_onto_a_shape_on_its_way_comes_off_it_later(motion: Any, age: float) -> None:
    # Its centre is left of the bar's end, over which it comes, when the flight begins, and where looks were before.
    arrays = with_ball(Segment((0, 0), (9, 0), motion=motion), Ball((-4, 0.3), 1, velocity=(1, 0)))
    event, clear = found(arrays, predict_clear, age)
    assert (event, clear) == (CLEAR, pytest.approx(13 + sqrt(1 - 0.09), abs=1e-8))


def test_who_is_on_a_shape_that_came_otherwise_comes_off_it_as_it_moves_now() -> None:
    # Before it was set going so the bar was elsewhere than its motion, followed back, would have it.
    bar = Segment((0, 0), (9, 0), motion="kinematic", velocity=(0, 40))
    arrays = with_ball(bar, Ball((4, 0), 1))
    arrays.shapes.rows[0]["since"] = 2.0
    assert found(arrays, predict_clear, 2.0) == (CLEAR, pytest.approx(2.025, abs=1e-9))
