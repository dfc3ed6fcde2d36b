"""Islands where anything is changed: who lies on whom is known to both, and whoever lies on nobody is free."""

from random import Random

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Circle, Segment, World
from carom.rows.flight import NO_TICK
from tests.heaps import is_symmetric, pairs_of
from tests.worlds import continuous_world


def pit(random: Random) -> World:
    """Balls of any mass, size and elasticity that fall into a pit, in which something may lift or stir them."""
    elasticity = random.choice([0.0, 0.3, 0.5, 1.0])
    walls = [((-2, 6), (-2, 0)), ((-2, 0), (2, 0)), ((2, 0), (2, 6))]
    world = continuous_world(*[Segment(*ends, elasticity=elasticity) for ends in walls], gravity=(0, -10))
    what = random.randrange(4)
    if what == 1:
        world.add(Segment((-2, 0.5), (2, 0.5), motion="kinematic", velocity=(0, 0.5), elasticity=elasticity))
    elif what == 2:
        stick = Segment((-1.5, 1), (1.5, 1), motion="kinematic", pivot=(0, 1), angular_velocity=-3)
        world.add(stick)
    elif what == 3:
        world.add(Circle((0, 2), 2, elasticity=elasticity))
    for k in range(random.randrange(2, 7)):
        place, velocity = (random.uniform(-1, 1), 1.2 + 0.8 * k), (random.uniform(-2, 2), random.uniform(-2, 2))
        mass, radius = 10 ** random.uniform(-2, 2), random.choice([0.2, 0.3, 0.4])
        world.add(Ball(place, radius, velocity, mass, elasticity=random.choice([0.0, 0.5, 1.0])))
    return world


def change(world: World, random: Random) -> None:
    """Change something from outside."""
    ball = random.randrange(len(world.balls))
    what = random.randrange(6)
    if what == 0:
        world.balls.position[ball] = (random.uniform(-1.5, 1.5), 4)
    elif what == 1 and len(world.balls) > 1:
        world.remove(world.balls[ball])
    elif what == 2:
        world.balls[ball].layer = 3 - world.balls[ball].layer
    elif what == 3:
        world.balls.velocity[ball] = (random.uniform(-3, 3), random.uniform(-3, 3))
    elif what == 4:
        world.restore(world.snapshot())
    else:
        world.gravity = random.choice([(0, -10), (0, 0), (5, -5)])


@given(st.integers(0, 10**6))
def test_whatever_is_changed_both_balls_know_that_they_lie_on_each_other(seed: int) -> None:
    random = Random(seed)
    world = pit(random)
    for _ in range(40):
        world.step(1 / 30)
        arrays = world._arrays
        pairs, flights = pairs_of(arrays), arrays.flights[: arrays.balls.count]
        assert is_symmetric(pairs)
        in_islands = {i for i, _ in pairs}
        assert all(i in in_islands for i in np.flatnonzero(flights["tick_time"] < NO_TICK))
        assert (flights["body"] == 0).all()
        assert np.isfinite(world.balls.position).all()
        if random.random() < 0.1:
            change(world, random)
