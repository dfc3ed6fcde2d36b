"""Worlds of many kinematic shapes (continuous): an index finds those that a ball may meet."""

from math import pi
from random import Random

import numpy as np
import pytest

import carom
from carom.constants import FEW_SHAPES

SIDE = 16.0


def crowd_of_movers(seed: int, broad_phase: str) -> carom.World:
    """A room with walls, dozens of kinematic shapes of every kind, and fast and slow balls of several sizes."""
    random = Random(seed)
    world = carom.World(detection="continuous", broad_phase=broad_phase, gravity=(0.0, -3.0), max_impacts=200)
    corners = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)]
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        world.add(carom.Segment(start, end))
    for number in range(random.randint(FEW_SHAPES + 1, 40)):
        x, y = random.uniform(1.0, SIDE - 1.0), random.uniform(1.0, SIDE - 1.0)
        size = random.uniform(0.2, 1.2)
        kind = number % 5
        if kind == 0:
            shape: carom.Shape = carom.Segment((x - size, y), (x + size, y + 0.1))
        elif kind == 1:
            shape = carom.Arc((x, y), size, random.uniform(0.0, pi), random.uniform(pi, 2.0 * pi))
        elif kind == 2:
            shape = carom.Circle((x, y), size, solid=True)
        elif kind == 3:
            shape = carom.Gate((x, y), (x + size, y), direction=(0.0, 1.0))
        else:
            shape = carom.Point((x, y))
        shape.motion = "kinematic"
        shape.sensor = random.random() < 0.2
        if random.random() < 0.7:
            shape.pivot = (x + random.uniform(-1.0, 1.0), y)
            shape.angular_velocity = random.uniform(-6.0, 6.0)
            shape.rotating = True
        if random.random() < 0.5:
            shape.velocity = (random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0))
        world.add(shape)
    for _ in range(8):
        speed = random.choice((1.0, 10.0, 200.0))
        place = (random.uniform(1.0, SIDE - 1.0), random.uniform(1.0, SIDE - 1.0))
        velocity = (random.uniform(-speed, speed), random.uniform(-speed, speed))
        world.add(carom.Ball(place, radius=random.choice((0.05, 0.2, 0.4)), velocity=velocity, elasticity=0.9))
    return world


def outcome(world: carom.World) -> tuple[list[tuple[int, int, int]], np.ndarray]:
    """What a world's balls hit in some steps, and where they come to."""
    hits = [hit for length in (1 / 60, 1 / 30, 0.2) * 2 for hit in world.step(length)]
    return [(int(hit.kind), hit.ball.id, hit.shape.id) for hit in hits], world.balls.position.copy()


@pytest.mark.compiled
@pytest.mark.parametrize("broad_phase", ["grid", "quadtree"])
def test_an_index_of_movers_finds_what_brute_force_finds(broad_phase: str) -> None:
    for seed in range(60):
        hits, places = outcome(crowd_of_movers(seed, broad_phase))
        wanted_hits, wanted_places = outcome(crowd_of_movers(seed, "brute"))
        assert hits == wanted_hits, seed
        assert places == pytest.approx(wanted_places, abs=1e-6), seed


@pytest.mark.parametrize("broad_phase", ["grid", "brute"])
def test_a_ball_meets_one_of_many_movers_where_it_comes_to(broad_phase: str) -> None:
    world = carom.World(detection="continuous", broad_phase=broad_phase)
    for number in range(2 * FEW_SHAPES):
        wall = carom.Segment((50.0 + 4.0 * number, -1.0), (50.0 + 4.0 * number, 1.0), motion="kinematic")
        wall.velocity = (-500.0, 0.0)
        world.add(wall)
    ball = carom.Ball((0.0, 0.0), radius=1.0, velocity=(-10.0, 0.0))
    world.add(ball)
    # The first wall is 49 away from the ball's edge and comes nearer by 490 in a second: 0.1 s.
    hits = world.step(0.12)
    assert list(hits["time"]) == [pytest.approx(0.1)]
    assert ball.velocity == (-990.0, 0.0)
    assert ball.position == pytest.approx((-1.0 - 990.0 * 0.02, 0.0))
