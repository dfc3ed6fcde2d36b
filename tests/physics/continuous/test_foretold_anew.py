"""When, how often, and among how many neighbours what comes next is foretold changes no bit of it."""

from math import pi
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, Shape, World
from carom.constants import FEW_FLIGHTS
from tests.clock import within
from tests.worlds import box

#: Widths of the cells of balls, and how many cells a ball has come to with nothing happening to it, as if by then.
WIDTHS = (0.0, 0.3, 3.0, 50.0, 1e300)
FILINGS = 40


def worlds_end(seed: int, *, jolted: bool) -> str:
    """The digest of a random world after two seconds; where `jolted`, all is foretold anew now and then on its way."""
    world, random = random_world(seed), np.random.default_rng(seed)
    states, flights = world._arrays.states, world._arrays.flights
    for step in range(64):
        if step == 32:
            # All begin new flights at once.
            world.friction = 0.75
        if jolted:
            states[0]["bin_least"] = random.choice(WIDTHS)
            if random.random() < 0.5:
                states[0]["foreseen"] = 0
            flights["filings"] = random.integers(0, FILINGS, len(flights))
        world.step(1 / 32)
    assert np.isfinite(world.balls.position).all()
    return world.digest()


def random_world(seed: int) -> World:
    """Balls of some sizes, sensors among them, in a room with shapes at rest and moving; they fall, slide and lie."""
    random = np.random.default_rng(seed)
    gravity = [(0.0, 0.0), (0.0, -2.0), (0.5, 0.0)][seed % 3]
    world = World(gravity=gravity, friction=0.5 * (seed % 2), max_speed=400.0)
    e = float(random.choice([0.0, 0.5, 0.9]))
    for shape in (*box(8.0, 6.0), *furniture(random)):
        shape.elasticity = e
        world.add(shape)
    for _ in range(int(random.integers(3, 16))):
        radius = float(random.choice([0.25, 0.5, 0.5, 0.05]))
        speed = float(10.0 ** random.uniform(0.0, 2.0)) if random.random() < 0.1 else float(random.integers(0, 3))
        velocity = speed * float(random.choice([-1.0, 1.0])), float(random.integers(-2, 3))
        sensor = bool(random.random() < 0.2)
        place = tuple(random.uniform([0.6, 0.6], [7.4, 5.4]).tolist())
        world.add(Ball(place, radius, velocity=velocity, elasticity=e, sensor=sensor))
    world.step(0.0625)
    return world


def furniture(random: np.random.Generator) -> list[Shape]:
    """Some shapes in the middle of a room."""
    turning: dict[str, Any] = {
        "motion": "kinematic",
        "angular_velocity": float(random.choice([-2.0, 1.0])),
        "pivot": (4.0, 3.0),
    }
    shapes: list[Shape] = [
        Circle((2.0, 2.0), 0.5, sensor=bool(random.random() < 0.5)),
        Arc((6.0, 3.0), 1.0, 0.0, pi),
        Segment((3.5, 3.0), (4.5, 3.0), **turning),
        Segment((4.0, 2.5), (4.0, 3.5), **turning),
        Point((5.0, 1.0)),
        Segment((1.0, 4.0), (3.0, 4.0), motion="kinematic", velocity=(0.5, 0.0)),
    ]
    return [shape for shape in shapes if random.random() < 0.6]


def heaps_end(seed: int, *, anew: bool) -> str:
    """The digest of a world of heaps, in which something is changed at each step; what follows is foretold twice."""
    world, random = World(gravity=(0.0, -4.0) if seed % 2 else (0.5, 0.0), friction=0.25), np.random.default_rng(seed)
    for wall in box(10.0, 8.0):
        wall.elasticity = 0.5
        world.add(wall)
    for x in (1.5, 4.5, 7.5):
        world.add(*[Ball(place, 0.5, elasticity=0.5) for place in ((x, 0.5), (x + 0.5, 1.366), (x + 1.0, 0.5))])
    for _ in range(8):
        place, velocity = random.uniform([1, 3], [9, 7]).tolist(), random.uniform(-6, 6, 2).tolist()
        world.add(Ball(place, 0.3, velocity=velocity, elasticity=0.9, sensor=bool(random.random() < 0.3)))
    for step in range(48):
        world.friction = 0.25 + 0.25 * (step % 2)
        world.step(2.0**-30)
        if anew:
            world._arrays.states[0]["foreseen"] = 0
        world.step(2.0**-5 - 2.0**-30)
    return world.digest()


@pytest.mark.compiled
@pytest.mark.parametrize("first", range(0, 100, 20))
def test_what_was_foretold_with_a_heap_that_is_solved_in_the_same_instant_counts_no_more(first: int) -> None:
    for seed in range(first, first + 20):
        with within(60.0):
            assert heaps_end(seed, anew=True) == heaps_end(seed, anew=False), seed


@pytest.mark.compiled
@pytest.mark.parametrize("first", range(0, 120, 12))
def test_foretelling_anew_changes_no_bit(first: int) -> None:
    crowds = 0
    for seed in range(first, first + 12):
        with within(60.0):
            assert worlds_end(seed, jolted=True) == worlds_end(seed, jolted=False), seed
        crowds += len(random_world(seed).balls) > FEW_FLIGHTS
    assert crowds > 3
