"""Gates in the continuous mode: open one way, walls the other, at any speed, at rest or turning."""

from math import sqrt

import pytest

from carom import Ball, Gate, Segment
from tests.worlds import continuous_world


@pytest.mark.parametrize("speed", [0.5, 10.0, 1e3, 1e5])
def test_a_gate_opens_from_one_side_alone(speed: float) -> None:
    for way in (1, -1):
        world = continuous_world(Gate((0, -2), (0, 2), direction=(1, 0)))
        ball = world.add(Ball((-5 * way, 0.3), 0.25, velocity=(speed * way, 0)))
        hits = world.run(10 / speed, dt=1 / speed)
        assert len(hits) == (0 if way == 1 else 1)
        assert ball.position[0] == pytest.approx(5 if way == 1 else 5.5, rel=1e-9)
        assert ball.velocity == (speed, 0)


def test_a_ball_that_turns_back_within_a_gate_comes_out_as_it_came() -> None:
    world = continuous_world(Gate((-2, 0), (2, 0), direction=(0, 1)), gravity=(0, -10))
    ball = world.add(Ball((0, -1), 0.25, velocity=(0, sqrt(2 * 10 * 1.1))))
    assert len(world.run(2 * sqrt(2 * 1.1 / 10), dt=1 / 50)) == 0
    assert ball.position[1] < -0.9


def test_a_ball_that_rose_through_a_gate_lands_on_it() -> None:
    world = continuous_world(Gate((-2, 0), (2, 0), direction=(0, 1)), gravity=(0, -10))
    ball = world.add(Ball((0, -1), 0.25, velocity=(0, sqrt(2 * 10 * 1.5)), elasticity=0.5))
    assert len(world.run(5)) > 0
    assert ball.position == pytest.approx((0, 0.25), abs=1e-9)


@pytest.mark.parametrize("kind", [Gate, Segment])
def test_a_ball_that_slides_off_a_gate_falls_as_off_any_other_wall(kind: type[Segment]) -> None:
    ways = {"direction": (0, 1)} if kind is Gate else {}
    world = continuous_world(kind((-2, 0), (2, 0), **ways), gravity=(0, -10))
    ball = world.add(Ball((0, 0.25), 0.25, velocity=(1, 0), elasticity=0.0))
    world.run(3.0)
    assert ball.position == pytest.approx((3.0, 0.25 - 5.0))


@pytest.mark.parametrize("spin", [3.0, 100.0])
def test_a_turning_gate_sweeps_what_is_on_its_closed_side(spin: float) -> None:
    # It opens for balls that come along +y. Turning counterclockwise its right half goes up, to balls above it, which
    # are on its closed side; clockwise it goes down, through balls below it.
    for way in (1, -1):
        gate = Gate((-3, 0), (3, 0), direction=(0, 1), motion="kinematic", pivot=(0, 0), angular_velocity=way * spin)
        world = continuous_world(gate)
        ball = world.add(Ball((2, way * 0.6), 0.25))
        hits = world.step(0.6 / spin)
        assert len(hits) == (1 if way == 1 else 0)
        assert (ball.velocity == (0, 0)) == (way == -1)


@pytest.mark.parametrize("speed", [1.0, 1e4])
def test_a_gate_that_travels_opens_as_one_at_rest(speed: float) -> None:
    for way in (1, -1):
        gate = Gate((0, -2), (0, 2), direction=(1, 0), motion="kinematic", velocity=(-way * speed, 0))
        world = continuous_world(gate)
        ball = world.add(Ball((-3 * way, 0), 0.25))
        world.run(6 / speed, dt=1 / speed)
        assert (ball.velocity[0] != 0) == (way == -1)
