"""Kinematic shapes are found by an index of where they may be; the twin, by brute force, asks all of them for all."""

from random import Random
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import example, given, settings

import carom
from carom.world.kernels.broad_phase.shape_index import MOVING
from carom.world.views import Balls
from tests.clock import within
from tests.worlds import bits, box, continuous_world, world_of

SIDE = 9.0
SHAPES = 28
STEPS = (1 / 60, 0.11, 0.3)


def motion(random: Random) -> dict[str, Any]:
    """Options of a shape that rests, turns, travels, or does both."""
    spin = {"angular_velocity": random.uniform(-5, 5)}
    speed = random.choice((0.2, 1.0, 6.0))
    drift = {"velocity": (random.uniform(-speed, speed), random.uniform(-speed, speed))}
    return random.choice(({}, spin, spin, drift, spin | drift))


def shape(random: Random) -> carom.Shape:
    """A kinematic shape of any kind, small or large."""
    x, y = random.uniform(1, SIDE - 1), random.uniform(1, SIDE - 1)
    size = random.choice((0.1, 0.3, 0.8))
    options = {"motion": "kinematic", "sensor": random.random() < 0.2, "elasticity": random.choice((1.0, 0.7))}
    options |= motion(random)
    made: carom.Shape = random.choice(
        (
            lambda: carom.Point((x, y), pivot=(x + size, y), **options),
            lambda: carom.Segment((x, y), (x + size, y + 0.1), pivot=(x, y), **options),
            lambda: carom.Gate((x, y), (x + size, y + size), direction=(-1, 1), **options),
            lambda: carom.Circle((x, y), 0.5 * size, solid=random.random() < 0.5, **options),
            lambda: carom.Arc((x, y), size, random.uniform(0, 3), random.uniform(3.2, 6), **options),
        )
    )()
    if random.random() < 0.3:
        made.turn_limits = -random.uniform(0.1, 2), random.uniform(0.1, 2)
    return made


def room(random: Random, phase: str, **settings: Any) -> carom.World:
    """Walls, shapes that move, some of them far away, and balls, few or many, that meet each other in flight alone."""
    settings = {"detection": "continuous", "broad_phase": phase, **settings}
    world = world_of(
        *box(SIDE, SIDE), gravity=(0, random.choice((0, -3))), friction=random.choice((0, 0, 0.3)), **settings
    )
    # In the discrete mode the broad phase decides which of two pairs is parted first.
    layers = {"layer": 2, "collides_with": 1} if settings["detection"] == "discrete" else {}
    world.add(*(shape(random) for _ in range(SHAPES)))
    # Apart from each other: where balls overlap, the broad phase decides which pair is parted first.
    for k in range(random.choice((3, 9))):
        place = 1.5 + 3.0 * (k % 3) + random.uniform(-1, 1), 1.5 + 3.0 * (k // 3) + random.uniform(-1, 1)
        velocity = random.uniform(-4, 4), random.uniform(-4, 4)
        elasticity, sensor = random.choice((1, 0.8)), random.random() < 0.1
        world.add(
            carom.Ball(place, random.choice((0.1, 0.2, 0.3)), velocity, elasticity=elasticity, sensor=sensor, **layers)
        )
    return world


def change(random: Random, moved: carom.Shape, balls: Balls) -> None:
    """Set what a user may set of a kinematic shape between two steps; it is not put onto balls."""
    which = random.randrange(6)
    if which == 0:
        moved.velocity = random.uniform(-2, 2), random.uniform(-2, 2)
    elif which == 1:
        moved.velocity = (0, 0)
        moved.angular_velocity = 0.0
    elif which == 2:
        moved.angular_velocity = random.uniform(-4, 4)
    elif which == 3:
        moved.can_collide = not moved.can_collide and is_free(moved.position, balls)
    elif which == 4:
        place = random.uniform(1, SIDE - 1), random.uniform(1, SIDE - 1)
        moved.position = place if is_free(place, balls) else moved.position
    else:
        moved.move_to((random.uniform(1, SIDE - 1), random.uniform(1, SIDE - 1)), dt=0.4)


def is_free(place: tuple[float, float], balls: Balls) -> bool:
    """True if no ball is near a place."""
    return bool((np.hypot(*(balls.position - place).T) > 2.0).all())


def film(seed: int, phase: str, steps: int) -> list[Any]:
    """All that is told of a world which is stepped and changed."""
    world = room(Random(seed), phase)
    random = Random(seed + 1)
    kinematic = [shape for shape in world.shapes if shape.motion == carom.Motion.KINEMATIC]
    told: list[Any] = []
    for _ in range(steps):
        with within(10):
            told.append(bits(world.step(random.choice(STEPS))))
        if random.random() < 0.4:
            change(random, random.choice(kinematic), world.balls)
    told += [bits(world.balls.position), bits(world.balls.velocity)]
    told.append([(shape.orientation, shape.position, shape.velocity) for shape in kinematic])
    world.broad_phase = "quadtree"
    return [*told, world.digest()]


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@settings(max_examples=12)
@given(seed=st.integers(0, 2**32))
@example(seed=3)
def test_what_is_found_by_regions_is_what_asking_all_finds(seed: int) -> None:
    assert film(seed, "grid", 8) == film(seed, "brute", 8)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@settings(max_examples=150)
@given(seed=st.integers(0, 2**32))
@example(seed=2366)
@example(seed=2456)
@example(seed=3101)
def test_what_is_found_by_regions_is_what_asking_all_finds_for_long(seed: int) -> None:
    assert film(seed, "grid", 24) == film(seed, "brute", 24)


def substeps(seed: int, phase: str, resumed: bool) -> tuple[list[Any], str]:
    """All that is told of a world in the discrete mode, and its digest; where `resumed`, of a copy after each step."""
    world = room(Random(seed), phase, detection="discrete", substeps=Random(seed).choice((1, 3)))
    random = Random(seed + 1)
    told: list[Any] = []
    for _ in range(30):
        told.append(bits(world.step(random.choice((0.01, 0.03)))))
        kinematic = [shape for shape in world.shapes if shape.motion == carom.Motion.KINEMATIC]
        if random.random() < 0.3:
            change(random, random.choice(kinematic), world.balls)
        if resumed:
            snapshot, world = world.snapshot(), carom.World()
            world.restore(snapshot)
    kinematic = [shape for shape in world.shapes if shape.motion == carom.Motion.KINEMATIC]
    told += [bits(world.balls.position), bits(world.balls.velocity)]
    told.append([(shape.orientation, shape.position, shape.velocity) for shape in kinematic])
    return told, world.digest()


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@settings(max_examples=25)
@given(seed=st.integers(0, 2**32))
def test_in_substeps_regions_find_what_asking_all_finds_and_nothing_shows_when_they_were_made(seed: int) -> None:
    told, digest = substeps(seed, "grid", False)
    assert substeps(seed, "grid", True) == (told, digest)
    for phase in ("brute", "quadtree"):
        assert substeps(seed, phase, False)[0] == told


@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("options", [{}, {"angular_velocity": 2.0}, {"velocity": (0.02, 0.01)}])
def test_a_step_costs_no_more_for_shapes_that_are_far_away(options: dict[str, Any], detection: str) -> None:
    costs = []
    for count in (20, 400):
        world = world_of(*box(10, 10), detection=detection)
        places = [(100.0 + 3.0 * (k % 20), 100.0 + 3.0 * (k // 20)) for k in range(count)]
        world.add(*(carom.Segment((x, y), (x + 1, y), motion="kinematic", **options) for x, y in places))
        for k in range(9):
            world.add(carom.Ball((1.0 + k, 5.0), 0.3, velocity=(k - 4.1, 3.0)))
        world.run(1.0)
        costs.append((world.statistics.box_tests, world.statistics.full_tests, len(world.run(1.0))))
        # They are not filed anew.
        assert world._arrays.index[MOVING]["span"] > 1.0
    assert costs[0] == costs[1]
    assert costs[0][2] > 5


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
def test_a_long_step_ends_whatever_has_left_for_good() -> None:
    world = continuous_world(carom.Ball((0, 0), 1, velocity=(0, -1)))
    world.add(*(carom.Point((k, 5), motion="kinematic", velocity=(0.1 * k, 1.0)) for k in range(20)))
    with within(5.0):
        world.step(1e12)
        assert world.aim(world.balls[0]) is None
    assert world.balls[0].position[1] == -1e12
