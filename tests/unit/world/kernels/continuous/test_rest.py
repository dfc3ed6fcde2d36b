"""When a ball comes to rest: at v/μ to the last digit, or asleep when it has been slow for long enough."""

from math import hypot, inf, sqrt
from typing import Any

import numpy as np
import pytest

from carom import Ball, Segment
from carom.rows.flight import NOTHING, SLEEP, STOP, TICK
from carom.world.kernels.continuous.flight import add_friction, event_age
from carom.world.kernels.continuous.rest import friction_least, predict_rest, slow_since, slow_stretch
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world


def flying(velocity: tuple[float, float], **settings: Any) -> Arrays:
    """The tables of a world of a ball in flight."""
    return in_flight(continuous_world(Ball((0, 0), 0.5, velocity=velocity), **settings))


def rest(arrays: Arrays) -> tuple[int, float]:
    """How and at which age a ball comes to rest."""
    flight = arrays.flights[0]
    flight["event"] = NOTHING
    predict_rest(arrays.states[0], arrays.balls.rows[0], flight)
    return int(flight["event"]), event_age(flight)


@pytest.mark.parametrize("velocity", [(3.0, 4.0), (-1e-9, 0.0), (1e5, 2e5), (0.1, -0.7)])
@pytest.mark.parametrize("friction", [0.3, 2.0, 1e4])
def test_friction_stops_a_ball_at_the_time_and_place_of_the_textbook(
    velocity: tuple[float, float], friction: float
) -> None:
    speed = hypot(*velocity)
    assert rest(flying(velocity, friction=friction)) == (STOP, pytest.approx(speed / friction, rel=4e-16))
    world = continuous_world(friction=friction)
    ball = world.add(Ball((0, 0), 0.5, velocity=velocity))
    world.step(0.5 * speed / friction)
    assert ball.velocity == pytest.approx((0.5 * velocity[0], 0.5 * velocity[1]), rel=1e-14)
    world.step(speed / friction)
    assert ball.velocity == (0, 0)
    way = 0.5 * speed / friction
    assert ball.position == pytest.approx((way * velocity[0], way * velocity[1]), rel=1e-14)


def test_uphill_a_ball_stops_sooner_and_where_friction_holds_it_stays() -> None:
    world = continuous_world(gravity=(0, -2), friction=3.0)
    ball = world.add(Ball((0, 0), 0.5, velocity=(0, 5)))
    world.step(1.0)
    assert ball.velocity == (0, 0)
    assert ball.position == pytest.approx((0, 2.5), rel=1e-15)
    world.step(5.0)
    assert ball.position == pytest.approx((0, 2.5), rel=1e-15)


def test_where_gravity_pulls_across_friction_acts_in_ticks() -> None:
    arrays = flying((3.0, 0.0), gravity=(0, -2), friction=1.0)
    event, age = rest(arrays)
    assert event == TICK
    pull = hypot(1.0, 2.0)
    assert age == pytest.approx(0.02 * 3 / pull + friction_least(arrays.balls.rows[0], pull))
    assert rest(flying((0.0, -3.0), gravity=(0, -2), friction=1.0))[0] == NOTHING


def test_without_friction_or_sleep_nothing_comes_to_rest() -> None:
    assert rest(flying((3.0, 0.0), gravity=(0, -2))) == (NOTHING, inf)
    assert rest(flying((0.0, 0.0))) == (NOTHING, inf)


SLEEPY: dict[str, Any] = {"sleep_speed": 0.5, "sleep_time": 0.75}


def test_a_slow_ball_sleeps_after_its_time_and_a_fast_one_never() -> None:
    assert rest(flying((0.3, 0.3), **SLEEPY)) == (SLEEP, 0.75)
    assert rest(flying((0.0, 0.0), **SLEEPY)) == (SLEEP, 0.75)
    assert rest(flying((0.3, 0.5), **SLEEPY)) == (NOTHING, inf)
    assert rest(flying((0.3, 0.3), gravity=(0, -2), **SLEEPY)) == (NOTHING, inf)
    arrays = flying((0.3, 0.3), **SLEEPY)
    arrays.flights[0]["slow_for"] = 0.5
    assert rest(arrays) == (SLEEP, 0.25)


def test_a_ball_that_turns_back_slowly_sleeps_while_it_is_slow() -> None:
    # Slower than 0.5 from 0.5/0.1 before its turn until as long after it: ten seconds, of which it needs 0.75.
    event, age = rest(flying((0.0, 1.0), gravity=(0, -0.1), **SLEEPY))
    assert (event, age) == (SLEEP, pytest.approx(5.0 + 0.75))
    assert rest(flying((0.0, 1.0), gravity=(0, -2.0), **SLEEPY)) == (NOTHING, inf)


@pytest.mark.parametrize("case", range(20))
def test_the_slow_stretch_is_where_the_speed_is_below_the_least(case: int) -> None:
    random = np.random.default_rng(case)
    (vx, vy), (ax, ay) = random.normal(0, 3, 2), random.normal(0, 1, 2)
    least = random.uniform(0.1, 0.99) * hypot(vx, vy)
    begin, end = slow_stretch(vx, vy, ax, ay, least)
    times = np.linspace(0, 20, 4001)
    slow = np.hypot(vx + ax * times, vy + ay * times) < least
    expected = (times > begin) & (times < end)
    assert (slow != expected).sum() <= 2


def test_how_long_a_ball_has_been_slow_is_known_at_any_age() -> None:
    arrays = flying((0.0, 1.0), gravity=(0, -0.1), **SLEEPY)
    state, ball, flight = arrays.states[0], arrays.balls.rows[0], arrays.flights[0]
    assert slow_since(state, ball, flight, 3.0) == 3.0
    assert slow_since(state, ball, flight, 7.0) == pytest.approx(5.0)
    assert slow_since(state, ball, flight, 16.0) == 16.0
    ball["vy"], flight["slow_for"] = 0.1, 0.4
    assert slow_since(state, ball, flight, 1.0) == -0.4


def test_a_ball_that_lies_falls_asleep_at_its_time_whatever_the_steps() -> None:
    for steps in (1, 16, 64):
        world = continuous_world(Segment((-5, 0), (5, 0)), gravity=(0, -10), **SLEEPY)
        world.add(Ball((0, 0.5), 0.5))
        times = []
        for step in range(steps):
            world.step(1.0 / steps)
            if world.statistics.sleeping:
                times.append(step / steps)
        assert times[0] == pytest.approx(0.75, abs=1 / steps)
        assert sqrt(times[0]) < 1


@pytest.mark.parametrize("friction", [5e-324, 1e-300, 1e-170])
def test_friction_whose_square_is_0_stops_nothing(friction: float) -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, velocity=(3, 4), friction=friction)))
    add_friction(arrays.states[0], arrays.balls.rows[0], arrays.flights[0])
    arrays.flights["event"][0] = NOTHING
    predict_rest(arrays.states[0], arrays.balls.rows[0], arrays.flights[0])
    assert arrays.flights["event"][0] == NOTHING
