"""Sleep and friction in the continuous mode."""

from functools import partial
from math import sqrt

import pytest

from carom import Ball, Segment, World
from carom.world.kernels.continuous.movers import take_up_changed
from tests.worlds import continuous_world

#: Worlds in which slow balls fall asleep.
sleepy_world = partial(continuous_world, sleep_speed=0.1, sleep_time=0.3)


def asleep(world: World) -> int:
    """How many balls sleep."""
    return world.statistics.sleeping


def turn_quietly(world: World, spin: float) -> None:
    """Let the first shape turn from now on, without waking anybody as a setter does."""
    arrays, state = world._arrays, world._arrays.states[0]
    arrays.shapes.rows[0]["angular_velocity"] = spin
    state["now"], state["now_low"] = state["time"], state["time_low"]
    take_up_changed(state, arrays.shapes.rows, arrays.order)
    state["foreseen"] = 0


def test_a_ball_that_rests_falls_asleep_and_stays() -> None:
    world = sleepy_world(Segment((-5, 0), (5, 0)), gravity=(0, -10))
    ball = world.add(Ball((0, 2), 0.5, elasticity=0.4))
    world.run(5)
    assert asleep(world) == 1
    place = ball.position
    tests = world.statistics.full_tests
    world.run(5)
    assert ball.position == place
    assert world.statistics.full_tests == tests


@pytest.mark.parametrize("spin", [1.0, 100.0])
def test_a_flipper_wakes_what_sleeps_on_it_before_it_goes_through(spin: float) -> None:
    flipper = Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), turn_limits=(0, 0.5))
    world = sleepy_world(flipper, gravity=(0, -10))
    ball = world.add(Ball((2, 0.5), 0.5, elasticity=0.5))
    world.run(1)
    assert asleep(world) == 1
    flipper.angular_velocity = spin
    hits = world.step(1 / 60)
    assert asleep(world) == 0
    assert len(hits) >= 1
    assert ball.velocity[1] > spin


@pytest.mark.parametrize("spin", [1.0, 100.0])
def test_a_bar_meets_a_sleeping_ball_in_its_way(spin: float) -> None:
    bar = Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), turn_limits=(0, 2))
    world = sleepy_world(bar)
    ball = world.add(Ball((0, 2), 0.25))
    world.run(1)
    assert asleep(world) == 1
    # No setter wakes it: the bar's own way does.
    turn_quietly(world, spin)
    assert len(world.run(2 / spin, dt=0.1 / spin)) == 1
    assert ball.velocity[0] < 0


def test_a_ball_wakes_another_that_it_hits() -> None:
    world = sleepy_world()
    still = world.add(Ball((0, 0), 0.5))
    world.run(1)
    assert asleep(world) == 1
    world._arrays.balls.rows[0]["asleep"] = 1
    runner = world.add(Ball((-20, 0), 0.5, velocity=(10, 0)))
    assert len(world.run(3)) == 1
    assert still.velocity == (10, 0)
    assert runner.velocity == (0, 0)


@pytest.mark.parametrize("substeps", [1, 4])
def test_friction_stops_a_ball_where_it_has_used_up_its_speed(substeps: int) -> None:
    world = sleepy_world(friction=2.0, sleep_speed=0.0, substeps=substeps)
    ball = world.add(Ball((0, 0), 0.5, velocity=(4, 0)))
    world.run(1, dt=1 / 1000)
    assert ball.velocity == pytest.approx((2, 0))
    world.run(2, dt=1 / 1000)
    assert ball.velocity == (0, 0)
    assert ball.position[0] == pytest.approx(4, rel=1e-2)


def test_friction_slows_a_ball_that_rolls_on_a_floor() -> None:
    world = sleepy_world(Segment((-50, 0), (50, 0)), friction=1.0, gravity=(0, -10))
    ball = world.add(Ball((0, 0.5), 0.5, velocity=(3, 0), elasticity=0.5))
    assert len(world.run(5)) == 0
    assert ball.velocity == (0, 0)
    assert ball.position[1] == pytest.approx(0.5, abs=1e-9)
    assert asleep(world) == 1


@pytest.mark.parametrize("others", [0, 10])
@pytest.mark.parametrize("first", [True, False])
def test_a_sleeping_ball_is_met_when_a_falling_one_touches_it(others: int, first: bool) -> None:
    world = sleepy_world(Segment((-50, 0), (50, 0), elasticity=0.0), gravity=(0, -10), substeps=1)
    sleeper, faller = Ball((0, 1), 1.0, elasticity=0.5), Ball((0, 20), 1.0)
    for ball in (sleeper, faller) if first else (faller, sleeper):
        world.add(ball)
    for k in range(others):
        world.add(Ball((10 + 3 * k, 1), 1.0, elasticity=0.5))
    world.run(1.5)
    assert asleep(world) == 1 + others
    hits = world.run(0.4)
    assert hits["time"][0] == pytest.approx(sqrt(2 * 17 / 10), rel=1e-12)


def test_a_sleeping_ball_that_is_hit_flies_on_in_the_same_step() -> None:
    world = sleepy_world(substeps=1)
    still = world.add(Ball((0, 0), 0.5))
    world.add(Ball((-21, 0), 0.5, velocity=(10, 0)))
    world.run(1)
    assert asleep(world) == 1
    world.step(2.0)
    assert still.position == pytest.approx((10, 0), rel=1e-12)


def test_a_sleeping_ball_that_is_pushed_softly_moves() -> None:
    world = sleepy_world(sleep_speed=0.01, rest_speed=1.0)
    still = world.add(Ball((0, 0), 0.5))
    world.add(Ball((-1.1, 0), 0.5, velocity=(0.05, 0), elasticity=0.0))
    world.run(1)
    assert asleep(world) == 1
    assert len(world.run(3)) == 1
    assert asleep(world) == 0
    assert still.velocity == pytest.approx((0.025, 0))
    assert still.position == pytest.approx((0.05, 0), rel=1e-6)
