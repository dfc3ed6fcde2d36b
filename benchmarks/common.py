"""What every benchmark uses: engines that take turns, medians, and a table."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median
from time import perf_counter

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.engines import Engine, engines
from benchmarks.setup import Setup


@dataclass(frozen=True)
class Figure:
    """One measured number of one engine at one workload."""

    workload: str
    engine: str
    value: float
    unit: str
    energy_kept: float | None = None  # energy at the end, as a fraction of that at the start


def race(calls: Mapping[str, Callable[[], object]], rounds: int, calls_each: int = 1) -> dict[str, float]:
    """Median seconds per call of each, taking turns, so that a slow moment of the machine slows all alike."""
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        for name, call in calls.items():
            began = perf_counter()
            for _ in range(calls_each):
                call()
            seconds[name].append((perf_counter() - began) / calls_each)
    return {name: median(values) for name, values in seconds.items()}


def energy(engine: Engine, setup: Setup) -> float:
    """Kinetic and potential energy of the balls, per unit of mass."""
    position, velocity = engine.state()
    return float(0.5 * np.sum(velocity * velocity) - np.sum(position @ np.asarray(setup.gravity)))


def race_steps(workload: str, setup: Setup, warm_up: int, steps: int) -> list[Figure]:
    """Median milliseconds of a step of `setup`, by every engine, and the energy each has kept."""
    worlds = {name: make(setup) for name, make in engines().items()}
    before = {name: energy(world, setup) for name, world in worlds.items()}
    race({name: world.step for name, world in worlds.items()}, warm_up)
    seconds = race({name: world.step for name, world in worlds.items()}, steps)
    return [
        Figure(workload, name, 1e3 * seconds[name], "ms a step", energy(world, setup) / before[name])
        for name, world in worlds.items()
    ]


def show(title: str, figures: list[Figure], console: Console) -> None:
    """Print figures as a table; a ratio tells how many times carom's value of the same workload it is."""
    table = Table(title=title, title_justify="left")
    table.add_column("workload")
    table.add_column("engine")
    for heading in ("median", "times carom", "energy kept"):
        table.add_column(heading, justify="right")
    ours = {figure.workload: figure.value for figure in figures if figure.engine == "carom"}
    for figure in figures:
        kept = "" if figure.energy_kept is None else f"{figure.energy_kept:.6f}"
        ratio = "" if figure.engine == "carom" else f"{figure.value / ours[figure.workload]:.1f}"
        table.add_row(figure.workload, figure.engine, f"{figure.value:.3g} {figure.unit}", ratio, kept)
    console.print(table)
