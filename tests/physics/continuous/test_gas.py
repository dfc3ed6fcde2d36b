"""A gas of hard discs has the pressure of the textbook, and its speeds turn Maxwellian.

Source of the equation of state: D. Henderson, A simple equation of state for hard discs, Molecular Physics 30 (1975)
971-972: PV/NkT = (1 + η²/8)/(1 - η)², within 1 % of simulations up to η = 0.6.
"""

from math import pi, sqrt

import numpy as np
import pytest

import carom
from tests.physics.continuous.rooms import Floats, exact_world
from tests.worlds import box

DISCS = 2000
RADIUS = 0.5

#: Largest distance between the distribution of n numbers and the one they are from, times √n, once in 1000 times.
KOLMOGOROV = 1.95


def gas(filled: float) -> tuple[carom.World, float]:
    """A gas of discs of one speed in a square box, and the box's side."""
    side = RADIUS * sqrt(pi * DISCS / filled)
    columns = 45
    spacing = side / columns
    random = np.random.default_rng(7)
    x, y = np.meshgrid(np.arange(columns) + 0.5, np.arange(columns) + 0.5)
    lattice = spacing * np.column_stack((x.ravel(), y.ravel()))
    free = 0.5 * spacing - RADIUS
    position = random.permutation(lattice + random.uniform(-free, free, lattice.shape))[:DISCS]
    angle = random.uniform(0.0, 2.0 * pi, DISCS)
    world = exact_world(*box(side, side))
    world.add_balls(position, np.column_stack((np.cos(angle), np.sin(angle))), radius=RADIUS)
    return world, side


def distance_from_maxwell(velocity: Floats) -> float:
    """How far the distribution of speeds is from Maxwell's in the plane, times √n: Kolmogorov's statistic."""
    squared = np.sort((velocity**2).sum(axis=1))
    expected = 1.0 - np.exp(-squared / squared.mean())
    steps = np.arange(len(squared) + 1) / len(squared)
    apart = np.maximum(np.abs(expected - steps[:-1]), np.abs(expected - steps[1:]))
    return float(apart.max() * sqrt(len(squared)))


@pytest.mark.compiled
@pytest.mark.parametrize("filled", [0.15, *[pytest.param(filled, marks=pytest.mark.slow) for filled in (0.35, 0.55)]])
def test_pressure_of_discs(filled: float) -> None:
    world, side = gas(filled)
    low, high = 0.25 * side, 0.75 * side
    area = (high - low) ** 2
    step = 2.0 * RADIUS
    for _ in range(60):
        world.step(step)
    virial, number, steps = 0.0, 0, 200
    for _ in range(steps):
        hits = np.asarray(world.step(step))
        point = hits["point"]
        # Walls are not in the middle half; all impacts there are those of discs.
        middle = ((point > low) & (point < high)).all(axis=1)
        virial += 2.0 * RADIUS * float(hits["impulse"][middle].sum())
        position = world.balls.position
        number += int(((position > low) & (position < high)).all(axis=1).sum())
    density = number / steps / area
    warmth = 0.5 * float((world.balls.velocity**2).sum(axis=1).mean())
    pressure = density * warmth + virial / (2.0 * area * steps * step)
    eta = density * pi * RADIUS * RADIUS
    expected = density * warmth * (1.0 + eta * eta / 8.0) / (1.0 - eta) ** 2
    assert pressure == pytest.approx(expected, rel=0.03)


@pytest.mark.slow
@pytest.mark.compiled
def test_speeds_turn_maxwellian() -> None:
    world, _ = gas(0.35)
    assert distance_from_maxwell(world.balls.velocity) > 10.0
    for _ in range(60):
        world.step(2.0 * RADIUS)
    assert distance_from_maxwell(world.balls.velocity) < KOLMOGOROV
