"""Balls that slide along bent and turning shapes: their energy, their clock, and the same bits in any steps."""

from copy import deepcopy
from math import cos, hypot, inf, pi, sin, sqrt
from random import Random
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Segment, World
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import continuous_world, energy

#: Seconds for which a world of one ball may take for a minute; a step that does not end takes for ever.
CLOCK = 5.0


def run_within_clock(world: World, seconds: float, steps: int) -> None:
    """Step a world, and fail where that takes too long."""
    with within(CLOCK):
        for _ in range(steps):
            world.step(seconds / steps)


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("spin", [0.0, 1e-3, 1.0, 30.0])
@pytest.mark.parametrize("scale", [1.0, *(pytest.param(scale, marks=pytest.mark.slow) for scale in (1e-3, 1e3))])
@pytest.mark.parametrize("gap", [0.0, 0.01])
def test_a_ball_in_a_ring_that_turns_keeps_its_energy(
    scale: float, spin: float, elasticity: float, gap: float
) -> None:  # fmt: skip
    world = continuous_world(gravity=(0, 0))
    motion = {"motion": "kinematic", "angular_velocity": spin} if spin else {}
    world.add(Circle((0, 0), 3 * scale, elasticity=elasticity, **motion))
    ball = world.add(Ball(((2.7 - gap) * scale, 0), 0.3 * scale, velocity=(0, 40 * scale)))
    run_within_clock(world, 1.0, 10)
    before = energy(world)
    run_within_clock(world, 60.0, 240)
    assert energy(world) == pytest.approx(before, rel=1e-9)
    assert hypot(*ball.position) <= (2.7 + 1e-3 * 0.3) * scale


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("spin", [0.0, 1.0, -30.0])
@pytest.mark.parametrize("scale", [1.0, *(pytest.param(scale, marks=pytest.mark.slow) for scale in (1e-3, 1e3))])
@pytest.mark.parametrize("share", [0.05, 0.25, 0.9])
def test_a_ball_that_is_let_go_where_gravity_is_tangent_rolls_down(
    scale: float, spin: float, elasticity: float, share: float
) -> None:  # fmt: skip
    world = continuous_world(gravity=(0, -10 * scale))
    motion = {"motion": "kinematic", "angular_velocity": spin} if spin else {}
    world.add(Circle((0, 0), scale, elasticity=elasticity, **motion))
    away = (1 - share) * scale
    ball = world.add(Ball((away, 0), share * scale))
    before = energy(world)
    low = 0.0
    with within(CLOCK):
        for _ in range(600):
            world.step(1 / 60)
            low = min(low, ball.position[1])
            assert hypot(*ball.position) <= away + 1e-3 * share * scale
            assert energy(world) <= before + 1e-9 * 10 * scale * scale
    assert low == pytest.approx(-away, rel=0.05)


#: Along which a ball slides, and where it begins: still and moving, concave and convex, bent and straight.
TRACKS: dict[str, tuple[Shape, tuple[float, float], tuple[float, float]]] = {
    "bowl": (Arc((0, 0), 2, pi, 0), (1.7 * sin(1), -1.7 * cos(1)), (0, 0)),
    "loop": (Circle((0, 0), 2), (0, -1.7), (9.5, 0)),
    "loop that is left": (Circle((0, 0), 2), (0, -1.7), (7, 0)),
    "dome": (Circle((0, 0), 2, solid=True), (0.2, sqrt(2.3**2 - 0.04)), (0, 0)),
    "ring that turns": (Circle((0, 0), 2, motion="kinematic", angular_velocity=2.0), (0, -1.7), (3, 0)),
    "ring that swings": (
        Circle((0, 0), 2, motion="kinematic", pivot=(0, 1), angular_velocity=0.7), (0, -1.7), (1, 0)
    ),
    "ring that travels": (Circle((0, 0), 2, motion="kinematic", velocity=(1, 0.5)), (0, -1.7), (3, 0)),
    "bar that turns": (
        Segment((-4, 0), (4, 0), motion="kinematic", pivot=(0, 0), angular_velocity=0.2), (1, 0.3), (-1, 0)
    ),
}  # fmt: skip
PATTERNS = ([16] * 64, [1, 700, 3, 64, 5, 200, 17, 33, 1], [1024])


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("track", TRACKS)
def test_a_sliding_ball_is_the_same_in_any_steps(track: str, elasticity: float) -> None:
    shape, place, velocity = TRACKS[track]
    seen = []
    for steps in PATTERNS:
        world = continuous_world(deepcopy(shape), gravity=(0, -10))
        ball = world.add(Ball(place, 0.3, velocity=velocity, elasticity=elasticity))
        for _ in range(3):
            for step in steps:
                world.step(step / 1024)
        seen.append((ball.position, ball.velocity))
    assert seen[0] == seen[1] == seen[2]


def rubbed(
    away: float, velocity: tuple[float, float], loss: float, gravity: float, speed: float
) -> tuple[float, float, float]:
    """Where about the middle of a ring, and how fast along it, a ball is after a second, by the method of Runge-Kutta.

    The ring travels with a velocity; friction, which acts against the ball's own, and gravity are all that pulls.
    """

    def rate(state: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        angle, along = state
        tangent = np.array([-sin(angle), cos(angle)])
        moving = velocity + along * tangent
        return np.array([along / away, tangent @ (-loss * moving / np.hypot(*moving)) + gravity * tangent[1]])

    state, step = np.array([-pi / 2, speed]), 1.0 / 1000
    for _ in range(1000):
        one = rate(state)
        two = rate(state + step / 2 * one)
        three = rate(state + step / 2 * two)
        state = state + step / 6 * (one + 2 * two + 2 * three + rate(state + step * three))
    return away * cos(state[0]), away * sin(state[0]), float(state[1])


@pytest.mark.compiled
@pytest.mark.parametrize("velocity", [(0.0, 0.0), (0.5, 0.2)])
@pytest.mark.parametrize("loss", [0.01, 0.3])
@pytest.mark.parametrize("gravity", [0.0, -1.0])
@pytest.mark.parametrize("room", [0.12, 0.2])
def test_friction_takes_from_a_ball_in_a_ring_what_its_equations_say(
    velocity: tuple[float, float], loss: float, gravity: float, room: float
) -> None:
    motion: dict[str, Any] = {"motion": "kinematic", "velocity": velocity} if any(velocity) else {}
    world = continuous_world(Circle((0, 0), 0.18 + room, **motion), gravity=(0, gravity), friction=loss)
    ball = world.add(Ball((0, -room), 0.18, velocity=(velocity[0] + 1.5, velocity[1]), elasticity=0.5))
    world.run(1.0, 1 / 50)
    x, y, along = rubbed(room, velocity, loss, gravity, 1.5)
    px, py = ball.position[0] - velocity[0], ball.position[1] - velocity[1]
    vx, vy = ball.velocity[0] - velocity[0], ball.velocity[1] - velocity[1]
    near = 1e-9 if not any(velocity) else 3e-4
    assert (px, py) == pytest.approx((x, y), abs=near)
    assert (px * vy - py * vx) / room == pytest.approx(along, abs=near)


@pytest.mark.compiled
@pytest.mark.parametrize("radius", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("share", [0.1, 0.66, 0.95])
@pytest.mark.parametrize("loss", [1e-3, 0.1, 3.0])
def test_friction_stops_a_ball_in_a_round_room_when_and_where_it_has_used_up_its_speed(
    radius: float, share: float, loss: float
) -> None:
    # The speed falls evenly, however often the ball goes round.
    speed, room = radius, radius * (1.0 - share)
    world = continuous_world(Circle((0, 0), radius, elasticity=0.5), friction=loss * radius)
    ball = world.add(Ball((0, -room), share * radius, velocity=(speed, 0), elasticity=0.5))
    seconds = min(1.0 / loss, 4.0)
    world.run(seconds, seconds / 64)
    left = speed - loss * radius * seconds
    assert hypot(*ball.velocity) == pytest.approx(left, abs=1e-9 * speed)
    angle = (speed * seconds - 0.5 * loss * radius * seconds * seconds) / room - pi / 2
    assert ball.position == pytest.approx((room * cos(angle), room * sin(angle)), abs=1e-7 * radius)


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(10))
def test_friction_lets_no_ball_win_energy_in_a_bowl(seed: int) -> None:
    random = Random(seed)
    loss, gravity = random.choice((0.02, 0.3, 2.0)), random.choice((-1.0, -10.0))
    radius, angle = random.uniform(0.05, 0.6), random.uniform(-1.2, 1.2)
    bowl = Circle((0, 0), 1.0, elasticity=0.4)
    world = continuous_world(bowl, gravity=(0, gravity), friction=loss)
    away = 1.0 - radius
    ball = world.add(Ball((away * sin(angle), -away * cos(angle)), radius))
    before = inf
    for _ in range(60):
        world.run(0.05, 0.05)
        left = 0.5 * hypot(*ball.velocity) ** 2 - gravity * ball.position[1]
        assert left <= before + 1e-9 * abs(gravity)
        before = left


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(40))
def test_a_ball_that_friction_presses_onto_what_turns_and_travels_holds_no_step_up(seed: int) -> None:
    random = Random(seed)
    motion: dict[str, Any] = {"motion": "kinematic", "angular_velocity": random.uniform(0.5, 1.5)}
    motion |= {"velocity": (0, random.uniform(0.5, 2)), "pivot": (-1.5, random.uniform(-2, 0))}
    world = continuous_world(
        Segment((-4, -3), (2, -3), **motion), gravity=(0, -1), friction=random.uniform(0.2, 1)
    )  # fmt: skip
    world.add(Ball((-1, -0.5), 0.5, velocity=(random.uniform(1, 3), -1), elasticity=random.choice((0.0, 0.3))))
    run_within_clock(world, 2.0, 120)
    assert np.isfinite(world.balls.position).all()
    # It is not held and let go at every instant.
    assert world.statistics.full_tests < 20_000
