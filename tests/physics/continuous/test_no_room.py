"""Balls that have hardly any room to fly hold no step up, whatever throws them back: kicks, limits, ends of walls."""

from typing import Any

import numpy as np
import pytest

from carom import Ball, Circle, Point, Segment, World
from carom.constants import LIFT
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import continuous_world

G = 10.0


def kicked_crowd(seed: int) -> World:
    """More balls than there is room for in a ring that kicks them."""
    random = np.random.default_rng(seed)
    ring = Circle((0, 0), random.choice([2.0, 3.0]), kick=random.choice([0.5, 1.0, 5.0]), elasticity=random.random())
    gravity = [(0.0, 0.0), (0.0, -1.0), (3.0, -4.0)][seed % 3]
    world = continuous_world(ring, Circle((0, 0), 6.0, elasticity=0.5), gravity=gravity, max_speed=20.0)
    elasticity = float(random.choice([0.0, 0.5, 0.9]))
    for _ in range(int(random.integers(12, 20))):
        place, velocity = random.uniform(-2, 2, 2).tolist(), random.uniform(-2, 2, 2).tolist()
        world.add(Ball(place, 1.0, velocity, mass=float(random.choice([1, 2, 100])), elasticity=elasticity))
    return world


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(12))
def test_kicks_end_where_balls_have_no_room(seed: int) -> None:
    world = kicked_crowd(seed)
    for _ in range(64):
        with within(20):
            world.step(1 / 64)
    assert world.statistics.collisions > 1000
    assert world.statistics.held < 2000
    assert np.isfinite(world.balls.velocity).all()


@pytest.mark.parametrize("radius", [0.01, 0.5, 30.0])
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("kick", [0.1, 5.0, 300.0])
@pytest.mark.parametrize(
    "floor", [Segment((-9, 0), (9, 0)), Circle((0, -200), 200, solid=True), Circle((0, 200), 200)], ids=lambda s: s.kind
)
def test_what_is_held_on_a_shape_with_a_kick_is_thrown_off_when_there_is_room(
    floor: Shape, kick: float, elasticity: float, radius: float
) -> None:
    options: dict[str, Any] = {"kick": kick, "elasticity": 0.8}
    bumper = Segment((-9, 0), (9, 0), **options)
    if isinstance(floor, Circle):
        bumper = Circle(floor.center, floor.radius, solid=floor.solid, **options)
    lid = Segment((-9, 2 * radius * (1 + 1e-8)), (9, 2 * radius * (1 + 1e-8)))
    world = continuous_world(bumper, lid, gravity=(0, -G), max_impacts=100)
    ball = world.add(Ball((0, radius * (1 + 1e-9)), radius, elasticity=elasticity))
    for _ in range(10):
        world.step(1 / 64)
    assert world.statistics.held > 0
    assert ball.velocity == (0.0, 0.0)
    assert ball.position[1] == pytest.approx(radius, rel=1e-6)
    # It stays so, however long, and through a snapshot.
    copy = World()
    copy.restore(world.snapshot())
    assert not world.run(1.0)
    copy.run(1.0)
    assert copy.digest() == world.digest()
    world.remove(lid)
    (hit,) = world.step(1e-4 * kick / G)
    assert hit.shape is bumper
    assert ball.velocity[1] == pytest.approx(kick, rel=2e-4)


def pushed_column(seed: int) -> World:
    """Touching balls in a column that a floor lifts faster than the world allows them to be."""
    random = np.random.default_rng(seed)
    lift: dict[str, Any] = {"motion": "kinematic", "velocity": (0, float(random.choice([5, 30, 100])))}
    world = continuous_world(
        Segment((-1e3, 0), (1e3, 0), elasticity=random.random(), **lift), max_speed=random.uniform(0.3, 5)
    )
    elasticity, height = float(random.choice([0.0, 0.5, 0.9])), 0.5
    for _ in range(int(random.integers(3, 9))):
        place = float(random.uniform(-0.4, 0.4)), height
        world.add(Ball(place, 0.5, mass=float(random.choice([1, 1, 2, 100])), elasticity=elasticity))
        height += float(random.choice([1.0, 0.99, 0.95]))
    return world


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("first", range(0, 60, 20))
def test_a_limit_of_speed_does_not_hold_balls_back_between_those_that_push(first: int) -> None:
    for seed in range(first, first + 20):
        world = pushed_column(seed)
        for _ in range(32):
            with within(20):
                world.step(1 / 64)
        # None has to be gone over, which comes after a thousand impacts too close to be told apart.
        assert world.statistics.squeezed == 0, seed
        assert world.statistics.held < 500, seed
        # Those that the floor pushes are no slower than it is.
        floor = world.shapes[0]
        lowest = min(world.balls, key=lambda ball: ball.position[1])
        assert lowest.position[1] >= floor.start[1] + 0.5 * (1 - LIFT)


def seesaw(seed: int) -> World:
    """A wall with points at its ends that turns and travels among balls, which lie on it and on each other."""
    random = np.random.default_rng(seed)
    spin, half = float(random.choice([0.5, 1, -2, 5, 10])), float(random.choice([1.0, 2.0, 3.0]))
    velocity = [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)][int(random.integers(4))]
    options: dict[str, Any] = {"motion": "kinematic", "pivot": (0, 0), "angular_velocity": spin, "velocity": velocity}
    wall = Segment((-half, 0), (half, 0), elasticity=0.5, **options)
    ends = [Point((x, 0), elasticity=0.5, **options) for x in (-half, half)]
    gravity = [(0.0, -10.0), (0.0, 0.0), (3.0, -4.0)][int(random.integers(3))]
    world = continuous_world(wall, *ends, Circle((0, 0), 7.0, elasticity=0.5), gravity=gravity)
    for _ in range(int(random.choice([4, 8, 14]))):
        place, velocity = random.uniform(-3, 3, 2).tolist(), random.uniform(-2, 2, 2).tolist()
        world.add(Ball(place, float(random.choice([0.5, 0.25])), velocity, mass=float(random.choice([1, 1, 100]))))
    world.balls.elasticity[:] = float(random.choice([0, 0, 0.5]))
    return world


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", [0, 1, 2, 613, 1076, 1959, 2845, 3150, 3225, 3876])
def test_balls_of_a_heap_go_over_the_end_of_what_carries_them(seed: int) -> None:
    world = seesaw(seed)
    for _ in range(64):
        with within(20):
            world.step(1 / 32)
    assert world.statistics.held < 200
    assert np.hypot(*world.balls.position.T).max() < 7.0
