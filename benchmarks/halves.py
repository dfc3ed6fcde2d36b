"""What a second thread could give a crowd: the bare loop of the gas in parts, each by halves in two threads.

One thread moves and counts the balls of one half of the rows, the other those of the other half; then each sorts its
half, and each looks for pairs in its half of the lines of cells, but for the last line between, which is left to the
end. What threads take to wait for each other is not counted, so this is the most that can be hoped for.
"""

from collections.abc import Callable, Sequence
from functools import cache
from threading import Thread
from time import thread_time
from typing import Any

import numpy as np

from benchmarks.bare import Bare, bounce_all, numba_loop, step_gas
from benchmarks.common import Figure, Timing
from benchmarks.gas import gas

TITLE = "Halves: a step of the bare loop in one thread, and its parts by halves in two, without what they wait"

Part = Callable[..., None]


def move_half(half: int, balls: Any, cells: Any, starts: Any, numbers: Any, box: Any) -> None:
    """Move the balls of one half of the rows, and count them by cells in the half's own table."""
    columns, rows, dt, radius = numbers
    across, up = columns / box[0], rows / box[1]
    starts[half][:] = 0
    for i in range(half * len(balls) // 2, (half + 1) * len(balls) // 2):
        for axis in range(2):
            end = box[axis] - radius
            place = balls[i, axis] + dt * balls[i, axis + 2]
            if place < radius:
                place, balls[i, axis + 2] = radius, abs(balls[i, axis + 2])
            elif place > end:
                place, balls[i, axis + 2] = end, -abs(balls[i, axis + 2])
            balls[i, axis] = place
        cells[i] = min(int(balls[i, 0] * across), columns - 1) + columns * min(int(balls[i, 1] * up), rows - 1)
        starts[half][cells[i]] += 1


def share_cells(starts: Any, begins: Any, count: int) -> None:
    """Turn counts into where each half puts its first ball of each cell; `begins` says where cells begin."""
    total = 0
    for cell in range(len(begins) - 1):
        first, second = starts[0][cell], starts[1][cell]
        begins[cell] = total
        starts[0][cell], starts[1][cell] = total, total + first
        total += first + second
    begins[len(begins) - 1] = count


def sort_half(half: int, cells: Any, starts: Any, members: Any) -> None:
    """Put the balls of one half of the rows into their cells."""
    for i in range(half * len(cells) // 2, (half + 1) * len(cells) // 2):
        place = starts[half][cells[i]]
        members[place] = i
        starts[half][cells[i]] = place + 1


def bounce_lines(first: int, last: int, balls: Any, cells: Any, begins: Any, members: Any, numbers: Any) -> None:
    """Let the balls of some lines of cells bounce off those that come after them, as the bare loop does."""
    columns, rows, _dt, radius = numbers
    for a in range(begins[first * columns], begins[last * columns]):
        i = members[a]
        cell = cells[i]
        left, right = cell % columns > 0, (cell + 1) % columns > 0
        bounce_all(balls, members, i, a + 1, begins[cell + 1 + right], radius)
        above = cell + columns
        if above < columns * rows:
            bounce_all(balls, members, i, begins[above - left], begins[above + 1 + right], radius)


@cache
def compiled() -> dict[str, Part]:
    """The parts, compiled by Numba, which other threads may run meanwhile."""
    import numba

    numba_loop()  # which tells Numba of what lets a ball bounce
    parts = (move_half, share_cells, sort_half, bounce_lines)
    return {part.__name__: numba.njit(error_model="numpy", nogil=True)(part) for part in parts}


def seconds(calls: Sequence[Callable[[], object]]) -> float:
    """Seconds of the processor of the slower of some calls, each in a thread of its own."""
    spent: list[float] = []

    def timed(call: Callable[[], object]) -> None:
        began = thread_time()
        call()
        spent.append(thread_time() - began)

    threads = [Thread(target=timed, args=(call,)) for call in calls]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return max(spent)


class Halves:
    """A gas whose steps are made in parts."""

    def __init__(self, count: int) -> None:
        setup = gas(count)
        columns, rows = Bare(setup, step_gas).loop.args[1:3]
        self.balls = np.column_stack((setup.position, setup.velocity))
        self.numbers = columns, rows, setup.time_step, setup.radius
        self.box = tuple(setup.segments[:, [0, 1]].max(axis=0).tolist())
        self.cells, self.members = np.zeros(count, "u4"), np.zeros(count, "u4")
        self.starts = tuple(np.zeros(columns * rows, "u4") for _ in range(2))
        self.begins = np.zeros(columns * rows + 1, "u4")

    def step(self) -> float:
        """Seconds of a step: of each part those of its slower half, and those of what one thread does alone."""
        part, (_columns, rows, *_) = compiled(), self.numbers
        lists = self.balls, self.cells, self.begins, self.members, self.numbers
        middle = rows // 2
        return (
            seconds([lambda half=h: part["move_half"](half, self.balls, self.cells, self.starts, self.numbers, self.box)
                     for h in range(2)])
            + seconds([lambda: part["share_cells"](self.starts, self.begins, len(self.balls))])
            + seconds([lambda half=h: part["sort_half"](half, self.cells, self.starts, self.members) for h in range(2)])
            + seconds([lambda: part["bounce_lines"](0, middle - 1, *lists),
                       lambda: part["bounce_lines"](middle, rows, *lists)])
            + seconds([lambda: part["bounce_lines"](middle - 1, middle, *lists)])
        )  # fmt: skip


def run(quick: bool) -> list[Figure]:
    """Milliseconds of a step of a bare gas."""
    figures = []
    for count in (1_000,) if quick else (50_000, 100_000, 1_000_000):
        bare, halves = Bare(gas(count), numba_loop()), Halves(count)
        bare.step()
        halves.step()
        rounds = 2 if quick else max(5_000_000 // count, 8)
        turns = [(seconds([bare.step]), halves.step()) for _ in range(rounds)]
        for name, spent in zip(("one thread", "two threads"), zip(*turns, strict=True), strict=True):
            figures.append(Timing.of(spent).figure(f"{count:,} balls", name, 1e3, "ms a step"))
    return figures
