"""Work that every engine is given alike: fixed shapes, balls, gravity, one elasticity for all."""

from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Setup:
    """What is to be stepped, in arrays; lengths in any unit, `time_step` in seconds."""

    position: Floats  # (n, 2)
    velocity: Floats  # (n, 2)
    radius: float
    time_step: float
    segments: Floats = field(default_factory=partial(np.empty, (0, 4)))  # start x, y, end x, y
    circles: Floats = field(default_factory=partial(np.empty, (0, 3)))  # centre x, y, radius; solid
    rings: Floats = field(default_factory=partial(np.empty, (0, 3)))  # centre x, y, radius; hollow: for carom alone
    chained: bool = False  # the segments are one closed convex line, counterclockwise round the balls; engines know it
    gravity: tuple[float, float] = (0.0, 0.0)
    elasticity: float = 1.0  # of every pair that meets
    iterations: int = 1  # at most, of a step of carom's discrete mode

    @property
    def balls(self) -> int:
        """How many balls there are."""
        return len(self.position)


def box(left: float, bottom: float, right: float, top: float) -> Floats:
    """The four walls of a box, as segments."""
    corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
    return np.array([(*corners[i - 1], *corners[i]) for i in range(4)])


def scattered(columns: int, rows: int, spacing: float, radius: float, seed: int) -> Floats:
    """Centres of balls that do not overlap: a lattice, each shaken within its cell, in a random order."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    lattice = spacing * np.column_stack((x.ravel(), y.ravel()))
    free = 0.5 * spacing - radius
    shaken: Floats = lattice + random.uniform(-free, free, lattice.shape)
    return random.permutation(shaken)


def all_directions(count: int, speed: float, seed: int) -> Floats:
    """Velocities of one speed in random directions."""
    angle = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, count)
    return speed * np.column_stack((np.cos(angle), np.sin(angle)))
