"""Studies of billiards: what a hit costs in each, beside the run of the same orbits alone."""

from collections.abc import Callable

import numpy as np

import carom
from benchmarks.common import Figure, race
from carom import study
from carom.study.billiards.ensembles import batches
from carom.study.billiards.tables import Table

TITLE = "Studies: orbits of a table, the processor's time for each hit"


def alone(table: Table, orbits: int, hits: int) -> None:
    """Fly the orbits of a study, and look at no hit."""
    for batch in batches(table, table.random_starts(orbits), 1.0):
        batch.run(hits * batch.free_time)


def crowd() -> carom.World:
    """A square room of twenty balls that meet."""
    generator, world = np.random.default_rng(1), carom.World(detection="continuous")
    world.add(*carom.outlines.rectangle(-2.0, -2.0, 2.0, 2.0))
    for place in range(20):
        x, y = 0.75 * (place % 5) - 1.5, 0.75 * (place // 5) - 1.5
        world.add(carom.Ball((x, y), 0.15, velocity=generator.normal(size=2)))
    return world


def calls_of(table: Table, orbits: int, hits: int) -> dict[str, Callable[[], object]]:
    """The studies of a table, and the run alone."""
    across = ((0.0, 0.0), (0.5 * table.size, 0.5 * table.size))
    return {
        "run": lambda: alone(table, orbits, hits),
        "boundary_map": lambda: study.boundary_map(table, orbits, hits, boundary=False),
        "section": lambda: study.section(table, across, orbits, hits),
        "lyapunov": lambda: study.lyapunov(table, orbits, hits),
    }


def run(quick: bool) -> list[Figure]:
    """Microseconds a hit of each study, and how many times that of the run alone it is."""
    orbits, hits, rounds, seconds = (20, 20, 1, 10.0) if quick else (1000, 200, 5, 4000.0)
    figures = []
    for name in ("stadium", "sinai", "lorentz", "ellipse"):
        figures += _of(name, calls_of(study.table(name), orbits, hits), orbits * hits, rounds)
    alone_in, together = study.table("lorentz").ensemble(1), crowd()
    for name, world, lasting in (("one ball", alone_in, 20.0 * seconds), ("twenty balls", together, seconds)):
        calls: dict[str, Callable[[], object]] = {
            "run": lambda world=world, lasting=lasting: world.run(lasting, lasting),
            "lyapunov_of": lambda world=world, lasting=lasting: study.lyapunov_of(world, lasting),
        }
        figures += _of(name, calls, len(world.run(lasting, lasting)), rounds)
    return figures


def _of(workload: str, calls: dict[str, Callable[[], object]], hits: int, rounds: int) -> list[Figure]:
    """The figures of one workload."""
    race(calls, rounds=1)
    timings = race(calls, rounds)
    figures = [timing.figure(workload, name, 1e6 / hits, "µs a hit") for name, timing in timings.items()]
    for figure in figures:
        figure.remarks["times the run"] = f"{figure.value / figures[0].value:.2f}"
    return figures
