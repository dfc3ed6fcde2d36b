"""Under gravity apexes and energy hold: motion between impacts is the exact parabola."""

from math import pi, sqrt

import numpy as np
import pytest

import carom
from tests.physics.continuous.rooms import exact_world

GRAVITY = 9.81


def energies(world: carom.World) -> float:
    """The energy per mass of a world's only ball."""
    (_, y), (vx, vy) = world.balls[0].position, world.balls[0].velocity
    return 0.5 * (vx * vx + vy * vy) + GRAVITY * y


@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.compiled
def test_apex_of_a_ball_on_a_floor(substeps: int) -> None:
    world = exact_world(carom.Segment((-1.0, 0.0), (1.0, 0.0)), gravity=(0.0, -GRAVITY), substeps=substeps)
    radius, height = 0.25, 2.0
    ball = world.add(carom.Ball((0.0, radius + height), radius))
    bounces = 0
    while bounces < 1000:
        bounces += len(world.step(1.0))
        apex = ball.position[1] - radius + ball.velocity[1] ** 2 / (2.0 * GRAVITY)
        assert apex == pytest.approx(height, rel=1e-9)
    # 1000 bounces take a fall, and twice that for each but the first.
    fall = sqrt(2.0 * height / GRAVITY)
    assert world.time == pytest.approx((2 * bounces) * fall, abs=1.0 + fall)


def shaft(width: float) -> list[carom.Shape]:
    """Two high walls, `width` apart."""
    return [carom.Segment((x, -10.0), (x, 1000.0)) for x in (-0.5 * width, 0.5 * width)]


#: What a ball of radius 0.25 that is thrown about above it cannot get past.
FLOORS = {
    "point": lambda: [*shaft(0.9), carom.Point((0.0, 0.0))],
    "solid circle": lambda: [*shaft(1.5), carom.Circle((0.0, 0.0), 0.5, solid=True)],
    "hollow circle": lambda: [carom.Circle((0.0, 1.0), 2.0)],
    "arc": lambda: [carom.Arc((0.0, 1.0), 2.0, pi, 2.0 * pi)],
    "hill of an arc": lambda: [*shaft(1.5), carom.Arc((0.0, 0.0), 0.5, 0.0, pi)],
}


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("floor", FLOORS)
def test_energy_on_a(floor: str) -> None:
    shapes = FLOORS[floor]()
    world = exact_world(*shapes, gravity=(0.0, -GRAVITY))
    world.add(carom.Ball((0.01, 0.8), 0.25, velocity=(0.3, 0.0)))
    before, impacts = energies(world), 0
    while impacts < 100_000:
        hits = np.asarray(world.step(100.0))
        assert 0 < len(hits) < 20_000
        # Impacts with the floor, which was added last.
        impacts += int((hits["shape"] == shapes[-1].id).sum())
        assert energies(world) == pytest.approx(before, rel=1e-9)
    assert world.statistics.stalled == 0


def test_a_kick_is_limited_at_once() -> None:
    world = exact_world(max_speed=5.0)
    world.add(carom.Circle((0, 0), 1.0, solid=True, kick=100.0))
    ball = world.add(carom.Ball((4, 0), 0.5, velocity=(-5, 0)))
    world.step(1.0)
    assert ball.velocity == pytest.approx((5, 0))
    assert ball.position == pytest.approx((4, 0))
    assert world.statistics.slowed == 1
