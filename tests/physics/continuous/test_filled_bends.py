"""Balls in rings and cups as large as they are themselves: they stay, go along, and fall out where nothing is below."""

from math import cos, hypot, pi, sin
from random import Random

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Compound, Point, Segment, World
from carom.constants import SHORT_GAP
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import continuous_world


def run_in_time(world: World, steps: int) -> None:
    """Step a world at 60 steps a second; a step that does not end fails."""
    for _ in range(steps):
        with within(5):
            world.step(1 / 60)


def cup_with_lips(middle: float, half: float, radius: float, elasticity: float) -> list[Shape]:
    """An arc about the origin, so far to either side of its middle, and the points of its ends."""
    cup = Arc((0, 0), radius, middle - half, middle + half, elasticity=elasticity)
    ends = (middle - half, middle + half)
    return [cup, *(Point((radius * cos(end), radius * sin(end)), elasticity=elasticity) for end in ends)]


def some_room(random: Random) -> float:
    """How much larger than a ball of radius 1 a bend is: nothing, rounding, or a part of a hundred-thousandth."""
    return random.choice((0.0, 2.0**-52, 10 ** random.uniform(-15, -5.1)))


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_ball_in_a_ring_of_its_own_size_goes_along_with_it(seed: int) -> None:
    random = Random(seed)
    # With less, rounding makes a ring that travels smaller than the ball.
    radius, room = 10 ** random.uniform(-3, 3), 10 ** random.uniform(-12, -5.1)
    ring = Circle((0, 0), radius * (1.0 + room), motion="kinematic", elasticity=random.choice((0.0, 0.5, 0.9)))
    ring.velocity = random.choice(((0, 0), (radius * random.gauss(0, 5), radius)))
    ring.angular_velocity = random.choice((0.0, random.gauss(0, 10)))
    ring.pivot = random.choice(((0, 0), (radius * random.gauss(0, 3), radius)))
    world = continuous_world(ring, gravity=(0, random.choice((0, -10 * radius))))
    speed, angle = radius * 10 ** random.uniform(-1, 3), random.uniform(0, 2 * pi)
    away = 0.7 * room * radius
    ball = world.add(Ball((away, 0), radius, velocity=(speed * cos(angle), speed * sin(angle))))
    for _ in range(6):
        run_in_time(world, 5)
        off = np.subtract(ball.position, ring.center)
        # Rounding counts where it has travelled far.
        assert hypot(*off) <= 2 * SHORT_GAP * radius + 1e-13 * hypot(*ring.center)
    assert world.statistics.squeezed == 0


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_ball_stays_in_a_cup_of_its_own_size_as_long_as_some_of_that_is_below_it(seed: int) -> None:
    random = Random(seed)
    half, tilt = random.uniform(0.3, pi / 2), random.uniform(-pi, pi)
    cup = cup_with_lips(tilt - pi / 2, half, 1.0 + some_room(random), random.choice((0.0, 0.5, 0.9)))
    world = continuous_world(*cup, Segment((-9, -5), (9, -5)), gravity=(0, -10))
    ball = world.add(Ball((0, 0), 1.0))
    run_in_time(world, 120)
    assert np.isfinite(ball.velocity).all()
    if abs(tilt) < half - 0.05:
        assert hypot(*ball.position) <= 2 * SHORT_GAP
        assert ball.velocity == (0, 0)
    elif abs(tilt) > half + 0.05:
        assert hypot(*ball.position) > 0.1


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("room", [0.0, 1e-12, 1e-7])
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
def test_a_ball_that_falls_into_a_cup_of_its_own_size_lies_in_it(room: float, elasticity: float) -> None:
    world = continuous_world(*cup_with_lips(-pi / 2, 1.3, 1.0 + room, elasticity), gravity=(0, -10))
    ball = world.add(Ball((0, 1), 1.0, elasticity=elasticity))
    run_in_time(world, 600)
    assert ball.velocity == (0, 0)
    assert ball.position == pytest.approx((0, 0), abs=2 * SHORT_GAP)


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("spin", [-2.0, 0.5, 8.0])
def test_a_cup_that_turns_over_drops_what_it_held(spin: float) -> None:
    cup = Compound(cup_with_lips(-pi / 2, pi / 2 - 0.3, 1.0 + 1e-9, 0.5), (0, 0))
    cup.angular_velocity = spin
    world = continuous_world(cup, gravity=(0, -10))
    ball = world.add(Ball((0, 0), 1.0, elasticity=0.5))
    held = (pi / 2 - 0.3) / abs(spin)
    world.run(0.9 * held, dt=0.01)
    assert ball.position == pytest.approx((0, 0), abs=2 * SHORT_GAP)
    with within(10):
        world.run(1.5, dt=0.01)
    assert hypot(*ball.position) > 0.5


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
def test_other_steps_show_the_same_ball_in_its_ring() -> None:
    ends = []
    for dt in (1 / 64, 1 / 256, 0.5):
        ring = Circle((0, 0), 1.0 + 1e-9, motion="kinematic", angular_velocity=3.0, pivot=(3, 4))
        world = continuous_world(ring, gravity=(0, -10))
        ball = world.add(Ball((0, 0), 1.0, velocity=(3, 1), elasticity=0.5))
        world.run(1.0, dt=dt)
        ends.append((ball.position, ball.velocity))
    assert ends[0] == ends[1] == ends[2]
