"""Heaps: balls that fall into a V, a bin or a hopper, and come to lie on each other."""

from statistics import median
from time import process_time

import numpy as np

from benchmarks.common import Figure, energy
from benchmarks.engines import CONTINUOUS, Engine, engines
from benchmarks.setup import Floats, Setup, scattered

TITLE = "Heaps: three simulated seconds in which balls fall in and settle"
SECONDS = 3.0
#: A step is one of the four substeps that carom's discrete mode makes of a frame of 1/60 s by itself.
TIME_STEP = 1.0 / 240.0
ITERATIONS = 6  # its default; with fewer, balls of a heap are pressed into each other
RADIUS = 0.15
SPACING = 0.4
COLUMNS = 5

#: The rooms, as segments: start x, y, end x, y.
ROOMS: dict[str, list[tuple[float, float, float, float]]] = {
    "V": [(-9.0, 9.0, 0.0, 0.0), (0.0, 0.0, 9.0, 9.0)],
    "bin": [(-1.0, 20.0, -1.0, 0.0), (-1.0, 0.0, 1.0, 0.0), (1.0, 0.0, 1.0, 20.0)],
    "hopper": [(-1.0, 20.0, -1.0, 1.0), (-1.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 1.0), (1.0, 1.0, 1.0, 20.0)],
}


def heap(room: str, balls: int) -> Setup:
    """So many balls at rest in a block above a room."""
    lattice = scattered(COLUMNS, -(-balls // COLUMNS), SPACING, RADIUS, seed=7)[:balls]
    position: Floats = lattice + np.array((-0.5 * COLUMNS * SPACING, 1.5))
    walls = np.array(ROOMS[room])
    still = np.zeros_like(position)
    return Setup(position, still, RADIUS, TIME_STEP, walls, gravity=(0.0, -9.8), elasticity=0.5, iterations=ITERATIONS)


def run(quick: bool) -> list[Figure]:
    """Milliseconds of the processor for the whole fall, in each engine."""
    found = []
    for balls in (5,) if quick else (5, 30, 100):
        for room in ROOMS:
            found += fall(f"{balls} balls into a {room}", heap(room, balls), 1 if quick else 3)
    return found


def fall(workload: str, setup: Setup, rounds: int) -> list[Figure]:
    """The median of some falls, the engines taking turns, the energy left of that at the start, and overlaps."""
    seconds: dict[str, list[float]] = {}
    kept: dict[str, float] = {}
    deepest: dict[str, str] = {}
    makers = engines(with_continuous=True)
    for make in (makers["carom"], makers[CONTINUOUS]):
        make(setup).step()  # compiled before any clock runs
    for _ in range(rounds):
        for name, make in makers.items():
            world = make(setup)
            before = energy(world, setup)
            seconds.setdefault(name, []).append(timed(world))
            kept[name] = energy(world, setup) / before
            deepest[name] = f"{deepest_overlap(world, setup):.1e}"
    return [
        Figure(workload, name, 1e3 * median(seconds[name]), "ms in all", kept[name], {"overlap, radii": deepest[name]})
        for name in makers
    ]


def deepest_overlap(world: Engine, setup: Setup) -> float:
    """How deep two balls lie in each other at most, in radii."""
    position, _velocity = world.state()
    between = position[:, np.newaxis] - position
    away = np.hypot(between[..., 0], between[..., 1])
    np.fill_diagonal(away, np.inf)
    return max(0.0, float(2.0 * setup.radius - away.min()) / setup.radius)


def timed(world: Engine) -> float:
    """Seconds of the processor for all steps."""
    began = process_time()
    for _ in range(round(SECONDS / TIME_STEP)):
        world.step()
    return process_time() - began
