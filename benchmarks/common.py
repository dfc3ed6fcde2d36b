"""What every benchmark uses: engines that take turns, medians with their spread, and a table."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from time import process_time
from typing import Self, TypeAlias

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.engines import Engine, engines
from benchmarks.setup import Setup

#: Steps that an engine makes before it is another's turn: enough for its data to come back into the caches.
TURN = 10


#: What makes engines, by their names.
Makers: TypeAlias = Mapping[str, Callable[[Setup], Engine]]


@dataclass(frozen=True)
class Figure:
    """One measured number of one engine at one workload."""

    workload: str
    engine: str
    value: float
    unit: str
    energy_kept: float | None = None  # energy at the end, as a fraction of that at the start
    remarks: dict[str, str] = field(default_factory=dict)  # more columns of the table, by heading
    spread: float | None = None  # of what the value is the median of: see `Timing`


#: The figures of one workload in an earlier run, by their cases and engines.
Before: TypeAlias = Mapping[tuple[str, str], Figure]


@dataclass(frozen=True)
class Timing:
    """How long something took, many times over: the median, and half of what the middle half of all spans; seconds."""

    median: float
    spread: float

    @classmethod
    def of(cls, seconds: Sequence[float]) -> Self:
        """The timing of some measurements."""
        lower, middle, upper = np.percentile(seconds, (25, 50, 75)).tolist()
        return cls(middle, 0.5 * (upper - lower))

    def figure(self, workload: str, engine: str, factor: float, unit: str, energy_kept: float | None = None) -> Figure:
        """The figure that is so many times the seconds."""
        return Figure(workload, engine, factor * self.median, unit, energy_kept, spread=factor * self.spread)


def race(calls: Mapping[str, Callable[[], object]], rounds: int, calls_each: int = 1) -> dict[str, Timing]:
    """Seconds of the processor per call of each, so that what else runs on the machine counts little.

    They take turns, so that a slow moment of the machine slows all alike.
    """
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        for name, call in calls.items():
            began = process_time()
            for _ in range(calls_each):
                call()
            seconds[name].append((process_time() - began) / calls_each)
    return {name: Timing.of(values) for name, values in seconds.items()}


def energy(engine: Engine, setup: Setup) -> float:
    """Kinetic and potential energy of the balls, per unit of mass."""
    position, velocity = engine.state()
    return float(0.5 * np.sum(velocity * velocity) - np.sum(position @ np.asarray(setup.gravity)))


def race_steps(
    workload: str, setup: Setup, steps: int, with_continuous: bool = False, beside: Makers | None = None
) -> list[Figure]:
    """Milliseconds of a step of `setup`, by every engine and what is to be run beside, and the energy each has kept."""
    worlds = {name: make(setup) for name, make in (engines(with_continuous) | dict(beside or {})).items()}
    before = {name: energy(world, setup) for name, world in worlds.items()}
    calls = {name: world.step for name, world in worlds.items()}
    race(calls, rounds=1, calls_each=TURN)
    seconds = race(calls, rounds=steps // TURN, calls_each=TURN)
    return [
        seconds[name].figure(workload, name, 1e3, "ms a step", energy(world, setup) / before[name])
        for name, world in worlds.items()
    ]


def show(title: str, figures: list[Figure], console: Console, before: Before | None = None) -> None:
    """Print figures as a table; a ratio tells how many times carom's value of the same workload it is.

    Where there are figures of an earlier run, another tells how many times its value then it is, behind a ~ where the
    two are no further apart than what the two spreads are together.
    """
    table = Table("workload", "engine", title=title, title_justify="left")
    table.add_column("median ± spread", justify="right")
    table.add_column("times carom", justify="right")
    if before is not None:
        table.add_column("then", justify="right")
        table.add_column("times then", justify="right")
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
        then = compared(figure, before) if before is not None else ()
        kept = [f"{figure.energy_kept:.6f}" if figure.energy_kept is not None else ""] if with_energy else []
        told = [figure.remarks.get(heading, "") for heading in headings]
        table.add_row(figure.workload, figure.engine, in_words(figure), ratio, *then, *kept, *told)
    console.print(table)


def in_words(figure: Figure) -> str:
    """A figure's value, with its spread where that is known, and its unit."""
    spread = "" if figure.spread is None else f" ± {figure.spread:.2g}"
    return f"{figure.value:.4g}{spread} {figure.unit}"


def compared(figure: Figure, before: Before) -> tuple[str, str]:
    """What a figure was in an earlier run, and how many times that it is now; nothing where it was not measured."""
    then = before.get((figure.workload, figure.engine))
    if then is None or then.unit != figure.unit or then.value == 0.0:
        return "", ""
    alike = abs(figure.value - then.value) <= (figure.spread or 0.0) + (then.spread or 0.0)
    return in_words(then), f"{'~' if alike else ''}{figure.value / then.value:.3g}"
