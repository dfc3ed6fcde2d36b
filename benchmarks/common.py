"""What every benchmark uses: engines that take turns, medians, and a table."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from statistics import median
from time import process_time

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.engines import Engine, engines
from benchmarks.setup import Setup

#: Steps that an engine makes before it is another's turn: enough for its data to come back into the caches.
TURN = 10


@dataclass(frozen=True)
class Figure:
    """One measured number of one engine at one workload."""

    workload: str
    engine: str
    value: float
    unit: str
    energy_kept: float | None = None  # energy at the end, as a fraction of that at the start
    remarks: dict[str, str] = field(default_factory=dict)  # more columns of the table, by heading


def race(calls: Mapping[str, Callable[[], object]], rounds: int, calls_each: int = 1) -> dict[str, float]:
    """Median seconds of the processor per call of each, so that what else runs on the machine counts little.

    They take turns, so that a slow moment of the machine slows all alike.
    """
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        for name, call in calls.items():
            began = process_time()
            for _ in range(calls_each):
                call()
            seconds[name].append((process_time() - began) / calls_each)
    return {name: median(values) for name, values in seconds.items()}


def energy(engine: Engine, setup: Setup) -> float:
    """Kinetic and potential energy of the balls, per unit of mass."""
    position, velocity = engine.state()
    return float(0.5 * np.sum(velocity * velocity) - np.sum(position @ np.asarray(setup.gravity)))


def race_steps(workload: str, setup: Setup, steps: int, with_continuous: bool = False) -> list[Figure]:
    """Median milliseconds of a step of `setup`, by every engine, and the energy each has kept."""
    worlds = {name: make(setup) for name, make in engines(with_continuous).items()}
    before = {name: energy(world, setup) for name, world in worlds.items()}
    calls = {name: world.step for name, world in worlds.items()}
    race(calls, rounds=1, calls_each=TURN)
    seconds = race(calls, rounds=steps // TURN, calls_each=TURN)
    return [
        Figure(workload, name, 1e3 * seconds[name], "ms a step", energy(world, setup) / before[name])
        for name, world in worlds.items()
    ]


def show(title: str, figures: list[Figure], console: Console) -> None:
    """Print figures as a table; a ratio tells how many times carom's value of the same workload it is."""
    table = Table("workload", "engine", title=title, title_justify="left")
    table.add_column("median", justify="right")
    table.add_column("times carom", justify="right")
    with_energy = any(figure.energy_kept is not None for figure in figures)
    if with_energy:
        table.add_column("energy kept", justify="right")
    headings = list(dict.fromkeys(heading for figure in figures for heading in figure.remarks))
    for heading in headings:
        table.add_column(heading, justify="right")
    ours = {figure.workload: figure.value for figure in figures if figure.engine == "carom"}
    for figure in figures:
        is_ours = figure.engine == "carom" or figure.workload not in ours
        ratio = "" if is_ours else f"{figure.value / ours[figure.workload]:.2g}"
        kept = [f"{figure.energy_kept:.6f}" if figure.energy_kept is not None else ""] if with_energy else []
        told = [figure.remarks.get(heading, "") for heading in headings]
        table.add_row(figure.workload, figure.engine, f"{figure.value:.4g} {figure.unit}", ratio, *kept, *told)
    console.print(table)
