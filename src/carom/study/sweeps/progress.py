"""How far a sweep is, on stderr: a bar where that is a terminal, else a line now and then."""

from __future__ import annotations

import sys
from time import perf_counter
from typing import Self

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

#: Seconds between two lines where there is no terminal.
PAUSE = 10.0


class Meter:
    """What is told of `total` runs, of which `done` were there at the beginning; nothing unless `shown`."""

    def __init__(self, total: int, done: int, shown: bool) -> None:
        console = Console(stderr=True)
        self._total, self._first, self._shown = total, done, shown
        self._began = self._told = perf_counter()
        self._bar = Progress(
            TextColumn("sweep"),
            BarColumn(bar_width=None),
            TextColumn("{task.completed:,} of {task.total:,} runs"),
            TextColumn("{task.fields[rest]}", style="cyan"),
            TimeRemainingColumn(),
            console=console,
            transient=True,
            expand=True,
            disable=not (shown and console.is_terminal),
        )
        self._task = self._bar.add_task("sweep", total=total, completed=done, rest="")

    def __enter__(self) -> Self:
        if not self._bar.disable:
            self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if not self._bar.disable:
            self._bar.stop()

    def tell(self, done: int, failed: int, workers: int) -> None:
        """Say how many runs are done and how many of them failed, and how many workers there are now."""
        rate = (done - self._first) / max(perf_counter() - self._began, 1e-9)
        there = "" if workers else ", waiting for workers"
        told = f"{failed:,} failed, {rate:,.3g} a second{there}"
        if not self._bar.disable:
            self._bar.update(self._task, completed=done, rest=told)
        elif self._shown and perf_counter() - self._told >= PAUSE:
            self._told = perf_counter()
            left = f", {(self._total - done) / rate:,.0f} s left" if rate > 0.0 else ""
            sys.stderr.write(f"sweep: {done:,} of {self._total:,} runs, {told}{left}\n")
