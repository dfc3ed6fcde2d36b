"""A gas of discs in a box: area fraction 0.20, elastic, with the velocities of an equilibrium."""

from __future__ import annotations

from math import ceil, pi, sqrt

import numpy as np

from carom.checks import whole
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shipped.outline import walls
from carom.spelling import spelled

RADIUS = 0.5
AREA_FRACTION = 0.20
SPEED = 7.5  # root mean square: a quarter of a radius in a sixtieth of a second


@spelled
def gas(balls: int = 10_000, seed: int = 0) -> Scene:
    """A gas of elastic discs in a box, with the velocities of an equilibrium.

    `balls` discs (1 to 1,000,000) on a square lattice, their velocities normal, drawn by NumPy from `seed`; no momentum
    as a whole, where there are two discs or more, and a mean square speed that is `SPEED` squared.
    """
    count = whole("balls", balls, 1, 1_000_000)
    side = sqrt(count * pi * RADIUS * RADIUS / AREA_FRACTION)
    columns = ceil(sqrt(count))
    spacing = side / columns
    velocities = _thermal(count, whole("seed", seed))
    discs = [
        BallDescriptor(
            position=(spacing * (place % columns + 0.5), spacing * (place // columns + 0.5)),
            velocity=(x, y),
            radius=RADIUS,
        )
        for place, (x, y) in enumerate(velocities.tolist())
    ]
    corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side), (0.0, 0.0)]
    return Scene(
        name="gas",
        world=WorldDescriptor(bounds=(-1.0, -1.0, side + 1.0, side + 1.0)),
        guard=True,
        shapes=walls(corners, name="wall"),
        balls=discs,
    )


def _thermal(count: int, seed: int) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Velocities of shape (count, 2)."""
    velocities = np.random.default_rng(seed).normal(size=(count, 2))
    if count > 1:
        velocities -= velocities.mean(axis=0)
    return velocities * (SPEED / sqrt(float(np.mean(np.sum(velocities * velocities, axis=1)))))
