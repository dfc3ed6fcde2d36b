"""Runs: many steps, one after the other, and what is kept of their hits."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from threading import get_ident
from typing import TYPE_CHECKING, Any

import numpy as np

from carom import checks
from carom.errors import ImpactLimit, InvalidArgument, NonFiniteState
from carom.rows.tables import Rows
from carom.typing import Keep
from carom.world.counts import Counter, Counts
from carom.world.hits import NO_ROWS, Hits
from carom.world.tables import joined

if TYPE_CHECKING:
    from carom.world.endings import Ending
    from carom.world.world import World

#: Seconds of work between two calls of `progress`, and the least that Ctrl-C has to wait.
SLICE_SECONDS = 0.1

#: What may be asked to be kept.
KEEP: tuple[Keep, ...] = ("all", "none", "counts")


class KeepNone:
    """Keeps no hits, but the rows of balls that were removed: the last run's are the world's strays."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._gone: list[Rows] = []
        self._told = False

    def begin(self) -> None:
        """Take the hits that a run before this one has made and not returned: they are of no step of this one."""
        self._add_rows(self._world._arrays.owed_hits())

    def add(self, hits: Hits) -> None:
        """Take the hits of some steps."""
        if hits._gone is not None:
            self._gone.append(hits._gone)
        if len(hits):
            self._add_rows(hits.view(np.ndarray))

    def result(self) -> Hits | Counts:
        """What is kept of all hits so far."""
        return Hits.of(self._world, NO_ROWS)

    def finish(self) -> Hits | Counts:
        """The same at the end of a run, whose strays the world is told."""
        gone = self._left()
        if gone is not None:
            self._world._left = gone
        return self.result()

    def tell(self, error: InvalidArgument | NonFiniteState | ImpactLimit) -> None:
        """Put what is kept into the error of a step."""
        self._add_rows(NO_ROWS if error.hits is None else error.hits)
        error.hits = self.result()
        self._told = True

    def leave(self) -> None:
        """Leave what is kept to the next step or run, unless an error of a step tells it."""
        if self._told:
            return
        self._give_back()
        self._world._arrays.owe_hits()
        self._world._forget_block()
        for rows in self._gone:
            self._world._departed.keep_balls(rows)

    def _left(self) -> Rows | None:
        """The rows of the balls that were removed, or None."""
        return _joined(self._gone) if self._gone else None

    def _add_rows(self, rows: Rows) -> None:
        """Keep of the hits what is to be kept: nothing."""

    def _give_back(self) -> None:
        """Leave what is kept to the next step or run: nothing."""


class KeepAll(KeepNone):
    """Keeps every hit."""

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self._parts: list[Rows] = []

    def result(self) -> Hits:
        """All hits."""
        return Hits.of(self._world, _joined(self._parts), self._left())

    def _add_rows(self, rows: Rows) -> None:
        self._parts.append(rows)

    def _give_back(self) -> None:
        self._world._arrays.give_back(_joined(self._parts))


class KeepCounts(KeepNone):
    """Keeps how many hits there were, by what was hit."""

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self._counter = Counter()

    def result(self) -> Counts:
        """The counts."""
        return Counts.of(self._world, self._counter.rows(), self._left())

    def _add_rows(self, rows: Rows) -> None:
        self._counter.add(rows)


def keeper(world: World, keep: Any) -> KeepNone:
    """What keeps of a run's hits what a user asks for; raises `InvalidArgument`."""
    kinds = {"all": KeepAll, "none": KeepNone, "counts": KeepCounts}
    return kinds[checks.one_of("keep", keep, KEEP)](world)


def run_steps(
    world: World,
    steps: int,
    length: float,
    progress: Callable[[float, float], Any] | None,
    ending: Ending | None,
    kept: KeepNone,
) -> Hits | Counts:
    """What is kept of the hits of a number of steps, or of those until a condition comes true.

    How many steps are made between two looks at the clock changes nothing of what they bring: steps that wait for hits
    end by themselves with the first one that has them, and where every step is to be looked at, each is made alone.
    """
    world._departed.forget_oldest()
    done, size, over = 0, 1, False
    if ending is not None:
        kept.begin()
    try:
        while done < steps and not over:
            began = clock.perf_counter()
            made, over = _slice(world, min(size, steps - done), length, ending, kept)
            took = clock.perf_counter() - began
            done += made
            if progress is not None:
                _watched(world, progress, done * length, steps * length)
            if took < SLICE_SECONDS:
                size = 2 * size
            elif took > 2.0 * SLICE_SECONDS:
                size = max(size // 2, 1)
        return kept.finish()
    except BaseException:
        kept.leave()
        raise


def _slice(world: World, count: int, length: float, ending: Ending | None, kept: KeepNone) -> tuple[int, bool]:
    """How many of a number of steps have been made, and whether the run is over by its condition."""
    if ending is None:
        kept.add(_made(world, count, length, kept))
        return count, False
    state = world._states[0]
    made = 0
    while made < count:
        state["steps_made"], state["stop_hits"] = 0, ending.hits_to_wait_for
        try:
            hits = _made(world, count - made if ending.hits_to_wait_for else 1, length, kept)
        finally:
            state["stop_hits"] = 0
        made += int(state["steps_made"])
        kept.add(hits)
        if ending.is_over(hits):
            return made, True
    return count, False


def _made(world: World, steps: int, length: float, kept: KeepNone) -> Hits:
    """The hits of some steps; the error of one that fails tells what is kept, that of a user's function does not."""
    try:
        return world._advance(steps, length)
    except (InvalidArgument, NonFiniteState, ImpactLimit) as error:
        kept.tell(error)
        raise


def _watched(world: World, progress: Callable[[float, float], Any], done: float, total: float) -> None:
    """Call the `progress` of a run, which may use the world."""
    world._watcher = get_ident()
    try:
        progress(done, total)
    finally:
        world._watcher = None


def _joined(parts: list[Rows]) -> Rows:
    """Tables of hits or of balls as one."""
    if not parts:
        return NO_ROWS
    return parts[0] if len(parts) == 1 else joined(parts, parts[0].dtype)
