"""In flight, what is changed of one ball or shape changes no bit of what goes on where it is not."""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from tests.clock import within

#: How often a world is stepped, and changed before each step.
STEPS = 40


@dataclass
class Place:
    """A world in which all goes on near the origin, but for a ball, a post and a hand that are far from it."""

    world: carom.World
    ball: carom.Ball
    post: carom.Point
    hand: carom.Segment
    count: int
    guest: Any = None

    def bits(self) -> list[bytes]:
        """All that is seen of the balls and shapes near the origin."""
        balls = self.world.balls
        shapes = [shape._row.tobytes() for shape in self.world.shapes if abs(shape.position[0]) < 100.0]
        return [balls.position[: self.count].tobytes(), balls.velocity[: self.count].tobytes(), *shapes]


def placed(world: carom.World) -> Place:
    """A world with what is far from it."""
    count = len(world.balls)
    ball = world.add(carom.Ball((1000.0, 1000.0), 0.5))
    post = world.add(carom.Point((2000.0, 2000.0)))
    hand = world.add(carom.Segment((3000.0, 3000.0), (3001.0, 3000.0), motion="kinematic"))
    return Place(world, ball, post, hand, count)


def shape_near(random: Random) -> carom.Shape:
    """A shape of any kind, at rest or moving, which balls bounce off, roll on, pass or come into."""
    x, y, e = random.uniform(-8, 8), random.uniform(-8, 8), random.choice((1.0, 0.5))
    end = x + random.uniform(0.5, 3), y + random.uniform(-2, 2)
    moving: dict[str, Any] = {"motion": "kinematic", "elasticity": e}
    return random.choice(
        (
            lambda: carom.Point((x, y), elasticity=e),
            lambda: carom.Circle((x, y), random.uniform(0.3, 2), elasticity=e, sensor=random.random() < 0.4),
            lambda: carom.Arc((x, y), random.uniform(1, 4), random.uniform(0, 3), random.uniform(3, 6), elasticity=e),
            lambda: carom.Arc((x, y), random.uniform(1, 3), 0, pi, sensor=True),
            lambda: carom.Segment((x, y), end, elasticity=e),
            lambda: carom.Gate((x, y), end, direction=(0, 1), elasticity=e),
            lambda: carom.Segment((x, y), end, angular_velocity=random.uniform(-3, 3), **moving),
            lambda: carom.Segment((x, y), end, angular_velocity=2.0, turn_limits=(0.0, 0.7), **moving),
            lambda: carom.Segment((x, y), end, velocity=(random.uniform(-2, 2), 0.3), **moving),
        )
    )()


def room(seed: int) -> Place:
    """Balls among shapes of all kinds in a box, with or without gravity and friction."""
    random = Random(seed)
    gravity = random.choice(((0, 0), (0, -10), (1, -7)))
    world = carom.World(gravity=gravity, friction=random.choice((0, 0, 0.3)))
    corners = (-10, -10), (10, -10), (10, 10), (-10, 10)
    for corner, following in zip(corners, (*corners[1:], corners[0]), strict=True):
        world.add(carom.Segment(corner, following, elasticity=random.choice((1, 0.5, 0.8))))
    world.add(*(shape_near(random) for _ in range(random.randint(1, 5))))
    for _ in range(random.randint(1, 9)):
        place, way = ((random.uniform(-reach, reach), random.uniform(-reach, reach)) for reach in (9, 5))
        options: dict[str, Any] = {"mass": random.uniform(0.5, 2), "elasticity": random.choice((1, 0.7))}
        options["friction"] = random.choice((None, 0.5))
        world.add(carom.Ball(place, random.choice((0.2, 0.3, 0.6)), way, **options))
    return placed(world)


def heap(seed: int) -> Place:
    """Balls that fall into a bowl, a wedge, or a box in which something turns and something travels."""
    random = Random(seed)
    world = carom.World(gravity=(0, -10), friction=random.choice((0, 0, 0.2)))
    which = random.randrange(3)
    if which == 0:
        world.add(carom.Arc((0, 5), 5, pi, 2 * pi, elasticity=0.6))
    elif which == 1:
        world.add(*(carom.Segment((side * 6, 4), (0, 0), elasticity=0.4) for side in (-1, 1)))
    else:
        world.add(carom.Segment((-4, 0), (4, 0), elasticity=0.5))
        world.add(*(carom.Segment((side * 4, 0), (side * 4, 9)) for side in (-1, 1)))
        moving: dict[str, Any] = {"motion": "kinematic", "elasticity": 0.5}
        spin = random.choice((2.0, -2.0, 0.5))
        world.add(carom.Segment((-2, 1), (1, 1.2), turn_limits=(-0.5, 1), angular_velocity=spin, **moving))
        world.add(carom.Segment((1.5, 0.53), (3.5, 0.53), velocity=(-0.2, 0), **moving))
    for k in range(random.randint(1, 14)):
        options: dict[str, Any] = {"mass": random.uniform(0.5, 2), "elasticity": random.choice((0.3, 0.7, 1.0))}
        world.add(carom.Ball((random.uniform(-3, 3), 1.6 + 0.8 * k), random.choice((0.2, 0.3, 0.4)), **options))
    return placed(world)


def written(place: Place, column: str, value: Any) -> None:
    """Write into a column of the ball that is far off."""
    getattr(place.world.balls, column)[place.count] = value


def come_and_gone(place: Place, k: int, member: Callable[[], Any]) -> None:
    """Add something far off before one step, and take it out before the next."""
    if k % 2 == 1:
        place.guest = place.world.add(member())
    else:
        place.world.remove(place.guest)


CHANGES: dict[str, Callable[[Place, int], Any]] = {
    "the same velocity": lambda place, k: setattr(place.ball, "velocity", place.ball.velocity),
    "a velocity": lambda place, k: setattr(place.ball, "velocity", (k, 0)),
    "a position": lambda place, k: setattr(place.ball, "position", (1000 + k, 1000)),
    "a mass": lambda place, k: setattr(place.ball, "mass", 1 + k),
    "a radius": lambda place, k: setattr(place.ball, "radius", 0.5 + 0.01 * (k % 3)),
    "a layer": lambda place, k: setattr(place.ball, "layer", 1 + k),
    "a friction": lambda place, k: setattr(place.ball, "friction", k),
    "a column of velocities": lambda place, k: written(place, "velocity", (k, 0)),
    "a column of masses": lambda place, k: written(place, "mass", 1 + k),
    "an elasticity": lambda place, k: setattr(place.post, "elasticity", 0.01 * k),
    "a kick": lambda place, k: setattr(place.post, "kick", k),
    "a switch": lambda place, k: setattr(place.post, "can_collide", k % 2 == 0),
    "a post's position": lambda place, k: setattr(place.post, "position", (2000 + k, 2000)),
    "a hand's speed": lambda place, k: setattr(place.hand, "angular_velocity", k),
    "a hand's goal": lambda place, k: place.hand.move_to((3000 + k, 3000), dt=1 / 90),
    "a post that comes and goes": lambda place, k: come_and_gone(place, k, lambda: carom.Point((5000, k))),
    "a ball that comes and goes": lambda place, k: come_and_gone(place, k, lambda: carom.Ball((5000, 9 * k), 0.5)),
    "a broad phase": lambda place, k: setattr(place.world, "broad_phase", ("grid", "brute", "quadtree")[k % 3]),
    "a limit of impacts": lambda place, k: setattr(place.world, "max_impacts", 10**5 + k),
    "the same gravity": lambda place, k: setattr(place.world, "gravity", place.world.gravity),
}


def unchanged(make: Callable[[int], Place], seed: int, change: Callable[[Place, int], Any]) -> None:
    """Check that a world which is changed far off before every step has the bits of one that is not."""
    changed, left = make(seed), make(seed)
    for k in range(STEPS):
        if left.world.statistics.sleeping:
            # Any change wakes those that sleep, which begin new flights then.
            return
        with within(10):
            if k > 0:
                change(changed, k)
            told, expected = changed.world.step(1 / 60), left.world.step(1 / 60)
        near = told[np.isin(told["ball"], left.world.balls.id[: left.count])]
        assert near.tobytes() == expected[np.isin(expected["ball"], left.world.balls.id[: left.count])].tobytes()
        assert changed.bits() == left.bits()


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("what", CHANGES)
@settings(max_examples=8)
@given(seed=st.integers(0, 2**32))
def test_what_is_changed_far_off_changes_no_bit_here(what: str, seed: int) -> None:
    unchanged(room, seed, CHANGES[what])
    unchanged(heap, seed, CHANGES[what])
