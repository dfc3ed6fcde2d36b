"""A run in slices short enough to tell how far it is and to answer Ctrl-C."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from carom.cli.interrupt import Interrupt
from carom.cli.tally import Tally
from carom.draw import Trace
from carom.rows.hit import HIT
from carom.world.tables import joined

if TYPE_CHECKING:
    from collections.abc import Callable

    from carom.record import Recorder, Recording
    from carom.rows.tables import Rows
    from carom.world.world import World

#: Seconds of real time that a slice should take: between these, the number of its steps stays.
SHORTEST_SLICE, LONGEST_SLICE = 0.05, 0.2


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run has brought: steps made of those asked for, real seconds without the first step, and its hits."""

    steps: int
    asked: int
    took: float
    tally: Tally
    hits: Rows  # none where they were not to be kept
    trace: Trace | None
    recording: Recording | None

    @property
    def stopped(self) -> bool:
        """Whether the run was stopped before its end."""
        return self.steps < self.asked


def run(
    world: World,
    steps: int,
    dt: float,
    *,
    tell: Callable[[int, float], None],
    keep_hits: bool = False,
    follow: bool = False,
    recorder: Recorder | None = None,
) -> Outcome:
    """What `steps` steps of length `dt` bring, or those made before Ctrl-C.

    `tell` is called with the steps made and the real seconds taken after each slice. The first slice is one step, and
    its time is not counted: it may have to compile. Where balls are followed or all is recorded, every slice is one
    step. The world's states and hits are the same however the steps are sliced.
    """
    trace = Trace(world) if follow else None
    tally = Tally.of(world)
    kept: list[Rows] = []
    done, took, size = 0, 0.0, 1
    with Interrupt() as interrupt:
        while done < steps and not interrupt.asked:
            count = min(size, steps - done)
            began = perf_counter()
            hits = world.run(count * dt, dt=dt).view(np.ndarray)
            spent = perf_counter() - began
            tally.add(hits)
            if keep_hits:
                kept.append(hits)
            if trace is not None:
                trace.note(hits)
            if recorder is not None:
                recorder.note(hits)
            elif trace is None and done > 0:
                size = next_size(count, spent)
            took += spent if done > 0 else 0.0
            done += count
            tell(done, took)
    recording = recorder.finish() if recorder is not None else None
    return Outcome(done, steps, took, tally, joined(kept, HIT), trace, recording)


def next_size(count: int, spent: float) -> int:
    """How many steps the next slice has, after one of `count` steps that took `spent` seconds."""
    if spent < SHORTEST_SLICE:
        return 2 * count
    return max(1, count // 2) if spent > LONGEST_SLICE else count
