"""What a run says of itself: the bar while it goes on, and the tables at its end."""

from __future__ import annotations

from time import perf_counter
from typing import TYPE_CHECKING

from rich import box
from rich.console import Console, Group
from rich.progress import BarColumn, Progress, ProgressColumn, TextColumn, TimeRemainingColumn
from rich.table import Table
from rich.text import Text

if TYPE_CHECKING:
    from typing import Self

    from carom.cli.running import Outcome
    from carom.cli.tally import Tallied
    from carom.world.world import World

#: How many shapes the table lists.
MOST_ROWS = 16
#: Seconds between two updates of the bar.
PAUSE = 0.05


class AnyBar:
    """A progress bar on stderr, where that is a terminal."""

    def __init__(self, *columns: ProgressColumn) -> None:
        console = Console(stderr=True)
        self._updated = 0.0
        self._progress = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=None),
            *columns,
            TimeRemainingColumn(),
            console=console,
            transient=True,
            expand=True,
            disable=not console.is_terminal,
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if not self._progress.disable:  # before rich 14.3 a bar that was never shown ends with an empty line
            self._progress.stop()

    def _is_due(self) -> bool:
        """Whether it is time for an update, which is made then."""
        now = perf_counter()
        due = now - self._updated >= PAUSE
        if due:
            self._updated = now
        return due


class Bar(AnyBar):
    """The bar of a run: simulated time, speed against real time, time left."""

    def __init__(self, name: str, steps: int, dt: float) -> None:
        super().__init__(TextColumn("{task.fields[time]}"), TextColumn("{task.fields[speed]}", style="cyan"))
        self._dt = dt
        self._task = self._progress.add_task(name, total=steps, time="", speed="")
        self._total = steps * dt

    def tell(self, steps: int, took: float) -> None:
        """Show that `steps` steps are made, in `took` seconds after the first."""
        if not self._is_due():
            return
        # Begun late, so that what the first step says of compiling does not mix with the bar.
        self._progress.start()
        self._progress.update(
            self._task,
            completed=steps,
            time=f"{steps * self._dt:,.1f} of {self._total:,.6g} s",
            speed=pace(steps - 1, self._dt, took),
        )


class FilmBar(AnyBar):
    """The bar of the frames of a film that are encoded."""

    def __init__(self, name: str) -> None:
        super().__init__(TextColumn("{task.completed:,} of {task.total:,} frames"))
        self._task = self._progress.add_task(name, total=1)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def tell(self, done: int, total: int) -> None:
        """Show that `done` of `total` frames are encoded."""
        if self._is_due() or done == total:
            self._progress.update(self._task, completed=done, total=total)


def pace(steps: int, dt: float, took: float) -> str:
    """How fast `steps` steps in `took` seconds are against real time, in words; empty where that cannot be told."""
    if steps < 1 or took <= 0.0:
        return ""
    factor = steps * dt / took
    return f"{factor:,.0f}x real time" if factor >= 10.0 else f"{factor:.2g}x real time"


def summary(name: str, world: World, outcome: Outcome, dt: float) -> Group:
    """The end of a run: what it was, touches by shape, statistics, digest."""
    told = [f"{world.time:,.6g} s simulated in {counted(outcome.steps, 'step')}", counted(len(world.balls), "ball")]
    speed = pace(outcome.steps - 1, dt, outcome.took)
    if speed:
        told.insert(1, speed)
    lines = [Text.assemble((name, "bold"), "  ", "  ·  ".join(told))]
    if outcome.stopped:
        lines.append(Text(f"stopped before the end: {outcome.asked * dt:,.6g} s were asked for", style="yellow"))
    counts = outcome.tally.counts()
    tables = [hits_table(counts)] if counts else [Text("no hits")]
    return Group(*lines, *tables, statistics_table(world), Text.assemble(("digest  ", "dim"), str(world.digest())))


def counted(number: int, thing: str) -> str:
    """A number of things, in words."""
    return f"{number:,} {thing}" if number == 1 else f"{number:,} {thing}s"


def hits_table(counts: list[Tallied]) -> Table:
    """The touches and hits by shape, what was touched most often first."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("shape")
    for heading in ("touches", "hits", "fastest", "strongest"):
        table.add_column(heading, justify="right")
    for count in counts[:MOST_ROWS]:
        numbers = f"{count.touches:,}", f"{count.hits:,}", f"{count.fastest:.3g}", f"{count.strongest:.3g}"
        table.add_row(Text(count.label), *numbers)
    rest = counts[MOST_ROWS:]
    if rest:
        sums = f"{sum(count.touches for count in rest):,}", f"{sum(count.hits for count in rest):,}"
        table.add_row(Text(f"{len(rest)} more", style="dim"), *sums, "", "")
    return table


def statistics_table(world: World) -> Table:
    """The world's counters, side by side; those that are 0 and matter only when they are not are left out."""
    shown = {name: count for name, count in world.statistics.as_dict().items() if count or name in ALWAYS}
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for name in shown:
        table.add_column(name.replace("_", " "), justify="right")
    table.add_row(*(f"{count:,}" for count in shown.values()))
    return table


#: Counters that are shown even when they are 0.
ALWAYS = ("box_tests", "full_tests", "collisions", "strays")
