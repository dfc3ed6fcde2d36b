"""Galton's board: balls that fall through rows of pegs into bins, where they pile up to a bell.

One unit of length is a centimetre, and lies between two pegs and so between two walls of bins. The board leans back by
5 degrees, so that of gravity's 981 cm/s² 85 act down the board.
"""

from __future__ import annotations

from math import ceil, pi, sqrt
from typing import Any

import numpy as np

from carom.checks import whole
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import CircleDescriptor
from carom.scene.shipped.outline import walls
from carom.spelling import spelled
from carom.typing import Vector

ROW_HEIGHT = 0.9
PEG_RADIUS = 0.36  # two diameters of a ball between two pegs: with more, balls run sideways and the bell gets flat
RADIUS = 0.075
LEAST_DEPTH = 3.0  # of bins
BIN_FILL = 0.7  # of the fullest bin, when all balls are down
PACKING = 0.8  # of a full bin's area that balls cover
THROAT = 0.6  # width of the hopper's opening: with less than four diameters of a ball, balls jam
SPACING = 2.2 * RADIUS  # of the balls in the hopper
JITTER = 0.03  # of the spacing, by which each ball is moved at random
GRAVITY = 85.0
REST_SPEED = 1.0  # no rebounds below it: so balls that are down lie still, and give no hits

BALL_ELASTICITY = 0.5
PEG_ELASTICITY = 0.4
WALL_ELASTICITY = 0.6


@spelled
def galton(rows: int = 12, balls: int = 1000, seed: int = 0) -> Scene:
    """Galton's board: balls fall through rows of pegs into bins, where they pile up to a bell.

    `rows` rows of pegs (1 to 100), one bin more than that, and `balls` (1 to 100,000) in the hopper. The bins are so
    deep that the balls fill the fullest one to `BIN_FILL`. The balls start on a lattice, each moved by a little at
    random, drawn by NumPy from `seed`.
    """
    lines = whole("rows", rows, 1, 100)
    count = whole("balls", balls, 1, 100_000)
    jitter = np.random.default_rng(whole("seed", seed)).uniform(-JITTER, JITTER, (count, 2))
    depth = _depth(lines, count)
    half_width = 0.5 * (lines + 1)
    throat = depth + ROW_HEIGHT * lines + 1.0  # y of the hopper's opening
    places = _lattice(count, half_width, throat)
    top = max(throat + half_width, places[-1][1]) + 1.0
    return Scene(
        name="galton",
        world=WorldDescriptor(
            detection="discrete",  # a thousand balls on each other cost the continuous mode hundreds of times more
            gravity=(0.0, -GRAVITY),
            substeps=_substeps(depth),
            rest_speed=REST_SPEED,
            bounds=(-half_width - 1.0, -1.0, half_width + 1.0, top + 1.0),
        ),
        guard=True,
        shapes=[*_board(half_width, throat, top), *_pegs(lines, depth), *_bins(lines, depth)],
        balls=[
            BallDescriptor(
                position=(x + SPACING * move_x, y + SPACING * move_y), radius=RADIUS, elasticity=BALL_ELASTICITY
            )
            for (x, y), (move_x, move_y) in zip(places, jitter.tolist(), strict=True)
        ],
    )


def _depth(lines: int, count: int) -> float:
    """The depth of the bins.

    The fullest one gets the part sqrt(2 / (π·rows)) of all balls: the middle of a binomial distribution.
    """
    fullest = count * min(1.0, sqrt(2.0 / (pi * lines)))
    return max(LEAST_DEPTH, fullest * pi * RADIUS * RADIUS / (PACKING * BIN_FILL))


def _substeps(depth: float) -> int:
    """So many that a ball which fell through a bin moves by less than its radius in one, with 60 steps a second."""
    fastest = 1.2 * sqrt(2.0 * GRAVITY * depth)
    return ceil(fastest / (60.0 * 0.9 * RADIUS))


def _lattice(count: int, half_width: float, throat: float) -> list[Vector]:
    """Places for `count` balls in the hopper, row by row from its opening up; the hopper's walls rise by 45 degrees."""
    places: list[Vector] = []
    y = throat + SPACING
    while len(places) < count:
        half = min(half_width, 0.5 * THROAT + (y - throat)) - SPACING
        fit = 1 + int(2.0 * half / SPACING)
        left = -0.5 * SPACING * (fit - 1)
        places += [(left + SPACING * place, y) for place in range(min(fit, count - len(places)))]
        y += SPACING
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


def _pegs(lines: int, depth: float) -> list[Any]:
    """Rows of pegs from the left side to the right one, each half a unit beside the next, the last over the bins."""
    pegs: list[Any] = []
    for row in range(lines):
        y = depth + ROW_HEIGHT * (lines - row)
        # Balls come down half a unit to the left or right for each row above, so the last row is over the bins' walls.
        places = lines if (lines - 1 - row) % 2 == 0 else lines + 1
        pegs += [
            CircleDescriptor(
                center=(place - 0.5 * (places - 1), y),
                radius=PEG_RADIUS,
                solid=True,
                elasticity=PEG_ELASTICITY,
                name="peg",
            )
            for place in range(places)
        ]
    return pegs


def _bins(lines: int, depth: float) -> list[Any]:
    """The walls between the bins."""
    places = [place - 0.5 * (lines - 1) for place in range(lines)]
    looks = {"elasticity": WALL_ELASTICITY}
    return [wall for x in places for wall in walls([(x, 0.0), (x, depth)], name="bin", **looks)]
