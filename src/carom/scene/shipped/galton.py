"""Galton's board: balls that fall through rows of pegs into bins, where they pile up to a binomial distribution."""

from __future__ import annotations

from math import ceil, pi, sqrt
from typing import Any

import numpy as np

from carom.checks import Vector, whole
from carom.scene.descriptors import BallDescriptor, CircleDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shipped.outline import walls

# One unit of length lies between two pegs, and so between two walls of bins.
ROW_HEIGHT = 0.9
PEG_RADIUS = 0.12
BIN_DEPTH = 7.0
BIN_FILL = 0.7  # of the fullest bin, when all balls are down
PACKING = 0.8  # of a full bin's area that balls cover
LARGEST_RADIUS = 0.15  # so that a ball fits between two pegs with room to spare
THROAT = 1.6  # width of the hopper's opening
LATTICE = 2.2  # radii between the balls in the hopper
JITTER = 0.03  # of that distance, by which each ball is moved at random
GRAVITY = 9.81

BALL_ELASTICITY = 0.5
WALL_ELASTICITY = 0.6


def galton(rows: int = 12, balls: int = 1000, seed: int = 0) -> Scene:
    """A board with `rows` rows of pegs (1 to 100), one bin more than that, and `balls` (1 to 100,000) in its hopper.

    The balls are of a size to fill the fullest bin to `BIN_FILL`. They lie on a lattice, each moved by a little at
    random, drawn by NumPy from `seed`.
    """
    lines = whole("rows", rows, 1, 100)
    count = whole("balls", balls, 1, 100_000)
    jitter = np.random.default_rng(whole("seed", seed)).uniform(-JITTER, JITTER, (count, 2))
    radius = _radius(lines, count)
    half_width = 0.5 * (lines + 1)
    throat = BIN_DEPTH + ROW_HEIGHT * lines + 1.0  # y of the hopper's opening
    places = _lattice(count, LATTICE * radius, half_width, throat)
    top = max(throat + half_width, places[-1][1]) + 1.0
    return Scene(
        name="galton",
        world=WorldDescriptor(
            gravity=(0.0, -GRAVITY),
            substeps=_substeps(radius),
            bounds=(-half_width - 1.0, -1.0, half_width + 1.0, top + 1.0),
        ),
        guard=True,
        shapes=[*_board(half_width, throat, top), *_pegs(lines), *_bins(lines)],
        balls=[
            BallDescriptor(
                position=(x + LATTICE * radius * move_x, y + LATTICE * radius * move_y),
                radius=radius,
                elasticity=BALL_ELASTICITY,
            )
            for (x, y), (move_x, move_y) in zip(places, jitter.tolist(), strict=True)
        ],
    )


def _radius(lines: int, count: int) -> float:
    """The radius with which the balls of the fullest bin fill as much of it as they should.

    That bin gets the part sqrt(2 / (π·rows)) of all balls: the middle of a binomial distribution.
    """
    fullest = count * min(1.0, sqrt(2.0 / (pi * lines)))
    return min(LARGEST_RADIUS, sqrt(BIN_FILL * BIN_DEPTH * PACKING / (pi * fullest)))


def _substeps(radius: float) -> int:
    """So many that a ball which fell through a bin moves by at most 0.7 of its radius, with 60 steps a second."""
    fastest = 1.2 * sqrt(2.0 * GRAVITY * BIN_DEPTH)
    return max(4, ceil(fastest / (60.0 * 0.7 * radius)))


def _lattice(count: int, spacing: float, half_width: float, throat: float) -> list[Vector]:
    """Places for `count` balls in the hopper, row by row from its opening up; the hopper's walls rise by 45 degrees."""
    places: list[Vector] = []
    y = throat + spacing
    while len(places) < count:
        half = min(half_width, 0.5 * THROAT + (y - throat)) - spacing
        fit = max(1, 1 + int(2.0 * half / spacing))
        left = -0.5 * spacing * (fit - 1)
        places += [(left + spacing * place, y) for place in range(min(fit, count - len(places)))]
        y += spacing
    return places


def _board(half_width: float, throat: float, top: float) -> list[Any]:
    """Floor and sides, and the hopper's two slopes."""
    opening = 0.5 * THROAT
    shoulder = throat + half_width - opening
    looks = {"elasticity": WALL_ELASTICITY}
    return [
        *walls([(-half_width, top), (-half_width, 0.0), (half_width, 0.0), (half_width, top)], name="board", **looks),
        *walls([(-half_width, shoulder), (-opening, throat)], name="hopper", **looks),
        *walls([(opening, throat), (half_width, shoulder)], name="hopper", **looks),
    ]


def _pegs(lines: int) -> list[Any]:
    """Rows of pegs from the left side to the right one, each half a unit beside the next, the last over the bins."""
    pegs: list[Any] = []
    for row in range(lines):
        y = BIN_DEPTH + ROW_HEIGHT * (lines - row)
        # Balls come down half a unit to the left or right for each row above, so the last row is over the bins' walls.
        places = lines if (lines - 1 - row) % 2 == 0 else lines + 1
        pegs += [
            CircleDescriptor(center=(place - 0.5 * (places - 1), y), radius=PEG_RADIUS, solid=True, name="peg")
            for place in range(places)
        ]
    return pegs


def _bins(lines: int) -> list[Any]:
    """The walls between the bins."""
    places = [place - 0.5 * (lines - 1) for place in range(lines)]
    looks = {"elasticity": WALL_ELASTICITY}
    return [wall for x in places for wall in walls([(x, 0.0), (x, BIN_DEPTH)], name="bin", **looks)]
