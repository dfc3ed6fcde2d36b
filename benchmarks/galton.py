"""A Galton board: balls fall through staggered pins into bins."""

import numpy as np

from benchmarks.common import Figure, race_steps
from benchmarks.setup import Floats, Setup, box, scattered

TITLE = "Galton board: balls fall through staggered pins into bins"
BALL_RADIUS = 0.1
PIN_RADIUS = 0.15
PIN_SPACING = 1.0
BIN_HEIGHT = 6.0
BALL_SPACING = 0.25
TIME_STEP = 1.0 / 240.0


def pins(columns: int, rows: int) -> Floats:
    """Centres and radii of staggered pins above the bins."""
    staggered = [
        ((column + 0.5 * (row % 2)) * PIN_SPACING, BIN_HEIGHT + (row + 1) * PIN_SPACING, PIN_RADIUS)
        for row in range(rows)
        for column in range(1 - row % 2, columns)
    ]
    return np.array(staggered)


def galton(balls: int, columns: int, rows: int) -> Setup:
    """A board with `balls` balls at rest in a block above its pins."""
    width = columns * PIN_SPACING
    across = int(width / BALL_SPACING)
    deep = -(-balls // across)
    start = BIN_HEIGHT + (rows + 1) * PIN_SPACING
    block = scattered(across, deep, BALL_SPACING, BALL_RADIUS, seed=3)[:balls]
    position = block + np.array((0.0, start))
    walls = [(x, 0.0, x, BIN_HEIGHT) for x in np.arange(1, columns) * PIN_SPACING]
    segments = np.vstack((box(0.0, 0.0, width, start + (deep + 1) * BALL_SPACING), walls))
    return Setup(
        position,
        np.zeros_like(position),
        BALL_RADIUS,
        TIME_STEP,
        segments,
        pins(columns, rows),
        gravity=(0.0, -9.8),
        elasticity=0.5,
    )


def run(quick: bool) -> list[Figure]:
    """Milliseconds of one step, over the time in which the balls come down."""
    balls, columns, rows, steps = (500, 20, 10, 20) if quick else (10_000, 60, 40, 1_200)
    return race_steps(f"{balls:,} balls, {rows} rows", galton(balls, columns, rows), steps)
