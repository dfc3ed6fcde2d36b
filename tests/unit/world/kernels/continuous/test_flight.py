"""A ball's flight: along the parabola of its acceleration, from when it began; what comes next is the soonest."""

from itertools import permutations
from math import hypot, inf

import numpy as np
import pytest

from carom import Ball
from carom.constants import MOST_AT_ONCE, SHORT_ELASTIC_FLIGHTS, SHORT_FLIGHT, SHORT_FLIGHTS
from carom.geometry.path import Path
from carom.rows.flight import ASLEEP, CLEAR, EXIT_SHAPE, FLYING, HIT_BALL, HIT_SHAPE, LEAVE, LOOK, NO_BALL, NOTHING
from carom.world.kernels.continuous.flight import (
    add_friction,
    age_at,
    age_now,
    consider,
    count_impact,
    event_age,
    fall_freely,
    friction_of,
    is_tired,
    is_worn,
    path_at,
    path_box,
    path_of,
    place_after,
    time_to_go,
)
from tests.kernel_calls import in_flight, look_at
from tests.worlds import continuous_world

RANDOM = np.random.default_rng(4)


def test_a_ball_flies_along_its_parabola_and_its_row_stays_where_the_flight_began() -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0.5, -10)), 2.0)
    ball, flight = room.balls.rows[0], room.flights[0]
    for time in (0.0, 0.3, 0.7, 2.0, -0.4):
        expected = 1 + 3 * time + 0.25 * time**2, 2 + 4 * time - 5 * time**2, 3 + 0.5 * time, 4 - 10 * time
        assert place_after(ball, flight, time) == pytest.approx(expected)
        look_at(room, time)
        assert age_now(room.states[0], flight) == age_at(flight, time, 0.0) == time
    assert tuple(ball[name] for name in ("x", "y", "vx", "vy")) == (1, 2, 3, 4)
    assert place_after(ball, flight, 0.0) == (1, 2, 3, 4)


@pytest.mark.parametrize("kind", [FLYING, ASLEEP])
@pytest.mark.parametrize("age", [0.0, 0.7])
def test_a_path_from_an_age_on_is_the_rest_of_the_flight(kind: int, age: float) -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0.5, -10)))
    ball, flight = room.balls.rows[0], room.flights[0]
    flight["kind"] = kind
    pull = (0.5, -10.0) if kind == FLYING else (0.0, 0.0)
    assert path_at(ball, flight, age) == Path(*place_after(ball, flight, age), *pull)
    assert path_at(ball, flight, 0.0) == path_of(ball, flight)


def test_who_sleeps_stays_where_it_is() -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0, -10)))
    ball, flight = room.balls.rows[0], room.flights[0]
    flight["kind"] = ASLEEP
    fall_freely(room.states[0], ball, flight)
    assert (flight["ax"], flight["ay"]) == (0, 0)
    assert place_after(ball, flight, 2.0) == (1, 2, 0, 0)


@pytest.mark.parametrize("own", [None, 0.0, 5.0])
def test_friction_pulls_against_the_velocity_and_holds_what_stands(own: float | None) -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4), friction=own), gravity=(0, -4), friction=2.0))
    state, ball, flight = room.states[0], room.balls.rows[0], room.flights[0]
    loss = 2.0 if own is None else own
    assert friction_of(state, ball) == loss
    fall_freely(state, ball, flight)
    assert (flight["ax"], flight["ay"]) == pytest.approx((-0.6 * loss, -4 - 0.8 * loss))
    ball["vx"] = ball["vy"] = 0.0
    fall_freely(state, ball, flight)
    assert (flight["ax"], flight["ay"]) == (0, min(0.0, loss - 4))
    flight["kind"], flight["ay"] = ASLEEP, 7.0
    add_friction(state, ball, flight)
    assert flight["ay"] == 7.0


@pytest.mark.parametrize("case", range(20))
def test_a_box_holds_a_way(case: int) -> None:
    x, y, vx, vy, ax, ay = RANDOM.uniform(-9, 9, 6)
    begin, end = sorted(RANDOM.uniform(0, 3, 2))
    left, bottom, right, top = path_box(Path(x, y, vx, vy, ax, ay), begin, end)
    times = np.linspace(begin, end, 200)
    xs, ys = x + vx * times + ax * times**2 / 2, y + vy * times + ay * times**2 / 2
    slack = 1e-9
    assert left - slack <= xs.min() <= xs.max() <= right + slack
    assert bottom - slack <= ys.min() <= ys.max() <= top + slack
    # It is no wider than need be, so no wider than the way is long, but for what the samples miss.
    between = (end - begin) ** 2 / 200**2
    assert right - left <= xs.max() - xs.min() + abs(ax) * between + slack
    assert top - bottom <= ys.max() - ys.min() + abs(ay) * between + slack


@pytest.mark.parametrize("case", range(20))
def test_no_way_is_gone_sooner_than_with_all_of_the_pull_along_it(case: int) -> None:
    vx, vy, ax, ay = RANDOM.normal(0, 3, 4)
    way = RANDOM.uniform(0.1, 5)
    soonest = time_to_go(hypot(vx, vy), hypot(ax, ay), way)
    for time in np.linspace(0, soonest, 20):
        assert hypot(vx * time + ax * time**2 / 2, vy * time + ay * time**2 / 2) <= way * (1 + 1e-12)
    assert hypot(vx, vy) * soonest + hypot(ax, ay) * soonest**2 / 2 == pytest.approx(way)


def test_what_neither_moves_nor_is_pulled_goes_no_way() -> None:
    assert time_to_go(0.0, 0.0, 1.0) == inf
    assert time_to_go(2.0, 0.0, 1.0) == 0.5
    assert time_to_go(0.0, 2.0, 1.0) == 1.0


EVENTS = [(0.5, HIT_SHAPE, 3), (0.75, HIT_BALL, 4), (0.25, LEAVE, 2), (0.25, HIT_BALL, 6), (0.25, HIT_BALL, 5)]


@pytest.mark.parametrize("order", list(permutations(range(5)))[::7])
def test_the_soonest_event_is_kept_in_whatever_order_they_are_found(order: tuple[int, ...]) -> None:
    room = in_flight(continuous_world(*(Ball((3 * k, 0), 1) for k in range(8))))
    flight = room.flights[7]
    flight["time"], flight["event"] = 1e9, NOTHING
    assert event_age(flight) == inf
    for k in order:
        consider(flight, *EVENTS[k])
    assert (event_age(flight), flight["event"], flight["partner"]) == (0.25, HIT_BALL, 5)
    # The key of an impact of two is the same in either's row.
    key = int(flight["event_key"])
    other = room.flights[5]
    assert consider(other, 0.25, HIT_BALL, 7)
    assert other["event_key"] == key


@pytest.mark.parametrize("ball", [0, 1])
@pytest.mark.parametrize("turned", [False, True])
def test_of_what_comes_at_one_instant_the_same_is_first_in_either_row_of_two(ball: int, turned: bool) -> None:
    flights = in_flight(continuous_world(Ball((0, 0), 1), Ball((3, 0), 1))).flights
    events = [(1.0, HIT_SHAPE, 7), (1.0, HIT_BALL, 1 - ball)]
    flights[ball]["event"] = NOTHING
    for event in reversed(events) if turned else events:
        consider(flights[ball], *event)
    # In the queue what the lower row does alone comes first, then the impact, then what the other does.
    assert flights[ball]["event"] == (HIT_SHAPE, HIT_BALL)[ball]


def test_consider_tells_whether_an_event_is_what_comes_next() -> None:
    flight = in_flight(continuous_world(Ball((0, 0), 1))).flights[0]
    assert consider(flight, 1.0, LOOK, NO_BALL)
    assert not consider(flight, 1.5, HIT_SHAPE, 0)
    assert consider(flight, 1.0, CLEAR, 3)
    assert not consider(flight, 1.0, CLEAR, 4)
    assert consider(flight, 1.0, CLEAR, 2)
    assert consider(flight, 1.0, EXIT_SHAPE, 9)
    assert (flight["event"], flight["partner"]) == (EXIT_SHAPE, 9)


def test_events_of_a_flight_count_from_its_beginning_to_twice_the_digits() -> None:
    flight = in_flight(continuous_world(Ball((0, 0), 1))).flights[0]
    flight["time"], flight["low"] = 1e9, 1e-9
    consider(flight, 1e-12, LOOK, NO_BALL)
    assert event_age(flight) == pytest.approx(1e-12, rel=1e-9)


@pytest.mark.parametrize(("elasticity", "most"), [(0.5, SHORT_FLIGHTS), (1.0, SHORT_ELASTIC_FLIGHTS)])
def test_impacts_too_close_to_be_told_apart_end_as_ones_without_elasticity(elasticity: float, most: int) -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1)))
    ball, flight = arrays.balls.rows[0], arrays.flights[0]
    for count in range(most + 3):
        flight["time"] = 1.0 + 1e-14 * count
        count_impact(ball, flight, elasticity, 1.0, 0.0)
        assert flight["impacts"] == count + 1
        assert (flight["short"], flight["at_once"]) == (count, count)
        assert is_tired(flight, elasticity, False) == (count > most)
        # What lies behind a ball of a heap throws it back at once; elastic ones hand on as long as they do elsewhere.
        assert is_tired(flight, elasticity, True) == (count > (0 if elasticity < 1 else most))
    # A flight that is long enough, at its speed, ends the count.
    flight["time"] = 1.1
    count_impact(ball, flight, elasticity, 1.0, 0.0)
    assert (flight["short"], flight["at_once"]) == (0, 0)
    flight["time"] = 1.2
    count_impact(ball, flight, elasticity, 1e-13, 0.0)
    assert (flight["short"], flight["at_once"]) == (1, 1)
    # A ball that goes along what it meets gets on.
    flight["time"], ball["vx"] = 1.3, 1.0
    count_impact(ball, flight, elasticity, 1e-13, 0.0)
    assert (flight["short"], flight["at_once"]) == (2, 0)


def test_a_ball_found_deep_in_what_moves_did_not_fly_there_and_is_worn_by_a_thousand_such() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1)))
    ball, flight = arrays.balls.rows[0], arrays.flights[0]
    for count in range(MOST_AT_ONCE):
        flight["time"] = 1.0 + count
        count_impact(ball, flight, 0.5, 1.0, 2.0 * SHORT_FLIGHT)
        assert flight["short"] == count + 1
        assert is_worn(flight) == (count + 1 == MOST_AT_ONCE)
    flight["time"] += 1.0
    count_impact(ball, flight, 0.5, 1.0, 0.5 * SHORT_FLIGHT)
    assert not is_worn(flight)
