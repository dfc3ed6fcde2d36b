"""Nobody leaves a closed room: at any elasticity of balls and walls, any masses, alone and in company, in any steps."""

from random import Random

import numpy as np
import pytest

import carom
from tests.clock import within
from tests.physics.continuous.rooms import Floats, Room, add_loners, exact_world, launches, random_room

#: Launches in a room, of which half are alone.
SHOTS = 1000

#: Companies in a world: a layer each, and one for the shapes.
COMPANIES = 30

#: Seconds in which a step returns, by far.
SOON = 60.0


def elasticity(random: Random) -> float:
    """One of those that matter."""
    return random.choice((0.0, random.random(), random.random(), 1.0, random.uniform(1.0, 1.5)))


def world_in(room: Room, random: Random, radius: float) -> carom.World:
    """A world of a room whose walls bounce differently, with gravity or without, maybe with friction."""
    gravity = (random.gauss(0.0, 1.0), 10.0 ** random.uniform(-3.0, 1.0)) if random.random() < 0.5 else (0.0, 0.0)
    friction = random.choice((0.0, 0.0, 10.0 ** random.uniform(-2.0, 1.0)))
    rebound = elasticity(random)
    for shape in room.shapes:
        shape.elasticity = random.choice((1.0, rebound))
    return exact_world(*room.shapes, gravity=gravity, friction=friction, max_speed=2000.0 * radius)


def add_companies(world: carom.World, random: Random, radius: float, size: int, free: float) -> None:
    """Add companies of balls of many masses and some radii, whose members meet shapes and each other."""
    places, velocities, radii = [], [], []
    for _ in range(COMPANIES):
        company: list[tuple[Floats, float]] = []
        while len(company) < size:
            r = radius * random.uniform(0.3, 1.0)
            place, velocity = launches(random, 1, free, radius, 0.01, 1000.0)
            if all(np.hypot(*(place[0] - other)) > 1.01 * (r + s) for other, s in company):
                company.append((place[0], r))
                velocities.append(velocity[0])
        places += [place for place, _r in company]
        radii += [r for _place, r in company]
    masses = [10.0 ** random.uniform(-3.0, 3.0) if random.random() < 0.5 else 1.0 for _ in radii]
    world.add_balls(places, velocities, radius=radii, mass=masses, elasticity=elasticity(random))
    rows = world._arrays.balls.used
    layer = 2 << (np.arange(len(rows)) // size)
    rows["layer"], rows["collides_with"] = layer, layer | 1


def runs_inside(world: carom.World, room: Room, steps: list[float]) -> None:
    """Step a world in which nobody leaves the room, whose shapes are free again then."""
    for dt in steps:
        with within(SOON):
            world.step(dt)
        x, y = world.balls.position.T
        assert room.holds(x, y).all(), np.flatnonzero(~room.holds(x, y))
        assert np.isfinite(world.balls.velocity).all()
    world.remove(*room.shapes)


def some_steps(random: Random) -> list[float]:
    """Steps of three seconds in all."""
    if random.random() < 0.5:
        return [1.0] * 3
    parts = [10.0 ** random.uniform(-3.0, 0.0) for _ in range(8)]
    return [3.0 * part / sum(parts) for part in parts]


@pytest.mark.slow
@pytest.mark.compiled
def test_no_launch_leaves_its_room_at_any_elasticity_alone_or_in_company(launch_count: int) -> None:
    exact_world(carom.Ball((0.0, 0.0), 1.0)).step(1.0)  # compiled before any clock runs
    for seed in range(launch_count // SHOTS):
        random = Random(seed)
        room = random_room(random)
        radius = 10.0 ** random.uniform(-1.5, -0.1)
        alone = world_in(room, random, radius)
        add_loners(alone, *launches(random, SHOTS // 2, room.free, radius, 0.01, 1000.0), radius)
        alone.balls.elasticity[:] = elasticity(random)
        runs_inside(alone, room, some_steps(random))
        launched = SHOTS // 2
        while launched < SHOTS:
            size = random.choice((2, 3, 5, 8))
            radius = min(radius, 0.25 * room.free / size**0.5)
            company = world_in(room, random, radius)
            add_companies(company, random, radius, size, room.free)
            runs_inside(company, room, some_steps(random))
            launched += len(company.balls)
