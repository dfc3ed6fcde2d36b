"""Galperin's blocks count the digits of pi; Newton's cradle passes on what it is given.

Source: G. Galperin, Playing pool with π, Regular and Chaotic Dynamics 8 (2003) 375-394.
"""

import pytest

import carom
from tests.physics.continuous.rooms import exact_world

DIGITS = "3141592"


def blocks(ratio: float) -> carom.World:
    """A wall, a light ball at rest, and a heavy one that comes towards both, on a line."""
    world = exact_world(carom.Segment((0.0, -1.0), (0.0, 1.0)))
    world.add(carom.Ball((1.0, 0.0), 0.25))
    world.add(carom.Ball((2.0, 0.0), 0.25, velocity=(-1.0, 0.0), mass=ratio))
    return world


@pytest.mark.parametrize(
    "digits", [1, 2, 3, pytest.param(4, marks=pytest.mark.compiled), pytest.param(5, marks=pytest.mark.compiled)]
)
@pytest.mark.parametrize("substeps", [1, 3])
def test_impacts_of_blocks_are_the_digits_of_pi(digits: int, substeps: int) -> None:
    world = blocks(100.0 ** (digits - 1))
    world.substeps = substeps
    hits = world.step(100.0)
    assert len(hits) == int(DIGITS[:digits])
    assert len(world.step(100.0)) == 0
    light, heavy = world.balls
    assert 0.0 <= light.velocity[0] <= heavy.velocity[0]
    assert world.balls.position[:, 1] == pytest.approx([0.0, 0.0], abs=1e-9)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("digits", [6, 7])
def test_impacts_of_blocks_are_more_digits_of_pi(digits: int) -> None:
    world = carom.World(detection="continuous")
    world.add(carom.Segment((0, -1), (0, 1)), carom.Ball((3, 0), 0.2))
    world.add(carom.Ball((6, 0), 1.0, velocity=(-1, 0), mass=100.0 ** (digits - 1)))
    assert len(world.step(16.0)) == int(DIGITS[:digits])
    assert world.statistics.held == 0


@pytest.mark.parametrize("moving", [1, 2, 3, 4])
def test_newtons_cradle(moving: int) -> None:
    world = exact_world()
    for k in range(5):
        gap = 1.0 if k < moving else 0.0
        world.add(carom.Ball((k - gap, 0.0), 0.5, velocity=(2.0 if k < moving else 0.0, 0.0)))
    world.step(1.0)
    still, gone = 5 - moving, moving
    assert world.balls.velocity[:, 0] == pytest.approx([0.0] * still + [2.0] * gone, abs=1e-12)
    assert (world.balls.velocity[:, 1] == 0.0).all()
