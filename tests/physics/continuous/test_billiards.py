"""Mean free paths of ergodic tables."""

from math import pi
from random import Random

import numpy as np
import pytest

import carom
from tests.physics.continuous.rooms import Floats, add_loners, exact_world, stadium
from tests.worlds import box

IMPACTS = 1_000_000
BALLS = 50
RADIUS = 0.1


def mean_free_path(shapes: list[carom.Shape], position: Floats, expected: float, seed: int) -> float:
    """The length of way per impact, over a million of them, of balls of speed 1."""
    angle = np.random.default_rng(seed).uniform(0.0, 2.0 * pi, len(position))
    world = exact_world(*shapes)
    add_loners(world, position, np.column_stack((np.cos(angle), np.sin(angle))), RADIUS)
    steps = 20
    length = IMPACTS * expected / (len(position) * steps)
    impacts = sum(len(world.step(length)) for _ in range(steps))
    # A little less than a million where paths are longer than expected.
    assert impacts > 0.99 * IMPACTS
    return steps * length * len(position) / impacts


@pytest.mark.slow
@pytest.mark.compiled
def test_mean_free_path_in_a_stadium() -> None:
    half, radius = 1.5, 1.0
    room = radius - RADIUS
    area, perimeter = 4.0 * half * room + pi * room * room, 4.0 * half + 2.0 * pi * room
    expected = pi * area / perimeter
    random = Random(1)
    position = np.array([(random.uniform(-half, half), random.uniform(-room, room)) for _ in range(BALLS)])
    assert mean_free_path(stadium(half, radius), position, expected, 1) == pytest.approx(expected, rel=0.005)


@pytest.mark.slow
@pytest.mark.compiled
def test_mean_free_path_in_a_sinai_table() -> None:
    side, disc = 4.0, 1.0
    room, reach = side - 2.0 * RADIUS, disc + RADIUS
    area, perimeter = room * room - pi * reach * reach, 4.0 * room + 2.0 * pi * reach
    expected = pi * area / perimeter
    shapes = [*box(side, side), carom.Circle((0.5 * side, 0.5 * side), disc, solid=True)]
    random = Random(2)
    position = np.array([(random.uniform(0.1, 0.6), random.uniform(0.1, 3.9)) for _ in range(BALLS)])
    assert mean_free_path(shapes, position, expected, 2) == pytest.approx(expected, rel=0.005)
