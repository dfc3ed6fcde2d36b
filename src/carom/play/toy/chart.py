"""The chart of box tests against balls: brute force, quadtree and grid, measured here and now."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from types import MappingProxyType
from typing import Any

import carom
from carom.typing import BroadPhase

#: How many balls: few of them, each number, and many.
FEW = tuple(range(2, 33))
MANY = (10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000)
#: Balls that no more of are tested by brute force: 50 million pairs a step.
MOST_BRUTE = 10_000
#: Steps before one that is measured, so that the balls no longer stand on a lattice, and steps that are measured.
BEFORE, MEASURED = 30, 4
#: Levels of the quadtree: enough that no leaf is crowded, for as many balls.
LEVELS = 10
#: The broad phases, their names and colours; the colours can be told apart without colour sight.
LOOKS: Mapping[BroadPhase, tuple[str, str]] = MappingProxyType(
    {"brute": ("brute force", "#d9480f"), "quadtree": ("quadtree", "#1f8aa8"), "grid": ("grid", "#5c940d")}
)
#: Numbers of balls that the table of figures is about.
TOLD = (2, 10, 32, 100, 1000, 10_000)


@dataclass(frozen=True, slots=True)
class Count:
    """The box tests of one iteration in a gas.

    Attributes:
        broad_phase: How pairs were found.
        balls: How many balls there were.
        tests: Box tests, those with the walls and their corners among them.
        pairs: Box tests of two balls.
    """

    broad_phase: BroadPhase
    balls: int
    tests: float
    pairs: float

    @property
    def tests_a_ball(self) -> float:
        """Box tests a ball."""
        return self.tests / self.balls


def count(balls: int, broad_phase: BroadPhase, before: int = BEFORE, measured: int = MEASURED) -> Count:
    """The box tests of an iteration among `balls` discs of a gas, the mean of some steps after the first ones."""
    world = carom.scenes.gas(balls=balls).build()
    world.detection, world.levels = "discrete", LEVELS
    if before:
        world.run(before / 60, dt=1 / 60)
    world.substeps = world.iterations = 1
    world.broad_phase = broad_phase
    alone = carom.World(detection="discrete", substeps=1, iterations=1, broad_phase=broad_phase, levels=LEVELS)
    alone.add_balls(world.balls.position, radius=world.balls.radius)
    tests = pairs = 0
    for _ in range(measured):
        world.statistics.reset()
        world.step(1 / 60)
        tests += world.statistics.box_tests
        # The same places in a room without walls, where all that is tested is pairs.
        alone.balls.position[:] = world.balls.position
        alone.balls.velocity[:] = 0.0
        alone.statistics.reset()
        alone.step(1 / 60)
        pairs += alone.statistics.box_tests
    return Count(broad_phase, balls, tests / measured, pairs / measured)


def counts(numbers: Sequence[int]) -> list[Count]:
    """The counts of all broad phases for each number of balls."""
    return [count(balls, name, measured=measured_of(balls)) for name in LOOKS for balls in numbers]


def measured_of(balls: int) -> int:
    """How many steps are measured: one of very many balls says enough."""
    return 1 if balls >= MOST_BRUTE // 2 else MEASURED


def write_chart(path: str | os.PathLike[str], tell: Callable[[str], None]) -> None:
    """Measure, write the chart to `path` (.svg, .png or .pdf), and tell the figures line by line.

    Raises:
        MissingExtra: matplotlib is not installed; `pip install "carom[study]"` brings it.
    """
    figure = empty_figure()
    found = counts(sorted({*FEW, *MANY}))
    for line in table(found):
        tell(line)
    draw_chart(figure, found)
    figure.savefig(os.fspath(path))


def table(found: Sequence[Count]) -> list[str]:
    """The counts as lines of words: box tests a ball, and of two balls alone."""
    by_key = {(one.broad_phase, one.balls): one for one in found}
    numbers = sorted({one.balls for one in found} & set(TOLD))
    lines = ["box tests of an iteration, a ball (of two balls alone):"]
    lines.append(f"{'balls':>8}" + "".join(f"{words:>22}" for words, _ in LOOKS.values()))
    for balls in numbers:
        cells = [by_key[name, balls] for name in LOOKS]
        lines.append(
            f"{balls:>8,}" + "".join(f"{one.tests_a_ball:>12,.1f}{f'({one.pairs / balls:,.1f})':>10}" for one in cells)
        )
    return lines


def empty_figure() -> Any:
    """A figure with room for two charts; raises `MissingExtra` without matplotlib."""
    try:
        module = import_module("matplotlib.figure")
    except ImportError:
        raise carom.MissingExtra('charts need matplotlib: pip install "carom[study]"') from None
    return module.Figure(figsize=(10.0, 4.8), layout="constrained")


def draw_chart(figure: Any, found: Sequence[Count]) -> None:
    """Draw the counts of few balls on plain axes, and those of many on logarithmic ones."""
    few, many = figure.subplots(1, 2)
    for axes, numbers in ((few, FEW), (many, MANY)):
        for name, (words, colour) in LOOKS.items():
            points = sorted((one.balls, one.tests) for one in found if one.broad_phase == name and one.balls in numbers)
            axes.plot(*zip(*points, strict=True), color=colour, marker="o", markersize=3.5, linewidth=1.6, label=words)
        axes.set_xlabel("balls")
        axes.set_ylabel("box tests an iteration")
        axes.grid(color="#d9d5cb", linewidth=0.6)
        axes.spines[["top", "right"]].set_visible(False)
        axes.set_axisbelow(True)
    few.set_title(f"{FEW[0]} to {FEW[-1]} balls", loc="left")
    few.set_xlim(0, FEW[-1] + 1)
    few.set_ylim(0, None)
    few.legend(frameon=False)
    many.set_title(f"{MANY[0]} to {MANY[-1]:,} balls", loc="left")
    many.set_xscale("log")
    many.set_yscale("log")
    many.set_xlim(MANY[0] * 0.7, MANY[-1] * 12)  # room for words at the right
    many.set_xticks([balls for balls in MANY if f"{balls}".strip("0") == "1"])
    for name, (_, colour) in LOOKS.items():
        last = max((one for one in found if one.broad_phase == name and one.balls in MANY), key=lambda one: one.balls)
        many.annotate(
            f"{last.tests_a_ball:,.1f} a ball",
            (last.balls, last.tests),
            xytext=(8, 0),
            textcoords="offset points",
            va="center",
            color=colour,
        )
    figure.suptitle(
        "Box tests of a gas in a box by broad phase, those with walls and corners among them",
        x=0.01,
        ha="left",
        fontweight="bold",
    )
