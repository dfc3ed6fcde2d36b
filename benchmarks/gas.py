"""A gas: elastic balls in a box, a fifth of the area filled, a quarter of a radius a step; and a loop for it alone."""

from math import ceil, pi, sqrt

from benchmarks.bare import bare_engines
from benchmarks.common import Figure, race_steps
from benchmarks.setup import Setup, all_directions, box, scattered

TITLE = "Gas: elastic balls in a box, area fraction 0.20, a quarter radius a step"
RADIUS = 0.5
AREA_FRACTION = 0.20
TIME_STEP = 1.0 / 60.0


def gas(balls: int, filled: float = AREA_FRACTION) -> Setup:
    """A gas of `balls` balls in a square box, so much of which is filled."""
    side = RADIUS * sqrt(pi * balls / filled)
    columns = ceil(sqrt(balls))
    position = scattered(columns, columns, side / columns, RADIUS, seed=1)[:balls]
    velocity = all_directions(balls, 0.25 * RADIUS / TIME_STEP, seed=2)
    return Setup(position, velocity, RADIUS, TIME_STEP, segments=box(0.0, 0.0, side, side))


def run(quick: bool) -> list[Figure]:
    """Milliseconds of one step."""
    balls, steps = (1_000, 20) if quick else (10_000, 400)
    return race_steps(f"{balls:,} balls", gas(balls), steps, with_continuous=True, beside=bare_engines())
