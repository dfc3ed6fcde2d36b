"""The gas as a loop that can do nothing else: no shapes, no hits, no rest; compiled by Numba, and the same in C.

What a world costs more is the price of being a world. Balls are put into cells as wide as a ball, in the order of the
cells, and each is tried against those that come after it in its own cell and in the four cells that come after.
"""

import ctypes
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache, partial
from math import floor, sqrt
from os import environ
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.engines import Engine
from benchmarks.setup import Floats, Setup

SOURCE = Path(__file__).with_name("bare.c")
#: One number after the other, and every operation rounded, so that C computes what Numba does.
OPTIONS = ("-O2", "-fno-tree-vectorize", "-ffp-contract=off", "-shared", "-fPIC")

Loop = Callable[..., None]


def step_gas(
    count: int,
    columns: int,
    rows: int,
    dt: float,
    radius: float,
    width: float,
    height: float,
    balls: Any,
    cells: Any,
    starts: Any,
    members: Any,
) -> None:
    """Move the balls (count, 4), of x, y, vx and vy, through a step, and let those that touch bounce."""
    across, up = columns / width, rows / height
    starts[:] = 0
    for i in range(count):
        for axis in range(2):
            end = (width if axis == 0 else height) - radius
            place = balls[i, axis] + dt * balls[i, axis + 2]
            if place < radius:
                place, balls[i, axis + 2] = radius, abs(balls[i, axis + 2])
            elif place > end:
                place, balls[i, axis + 2] = end, -abs(balls[i, axis + 2])
            balls[i, axis] = place
        cells[i] = min(int(balls[i, 0] * across), columns - 1) + columns * min(int(balls[i, 1] * up), rows - 1)
        starts[cells[i] + 1] += 1
    for cell in range(columns * rows):
        starts[cell + 1] += starts[cell]
    for i in range(count - 1, -1, -1):
        # The end of the ball's cell, which is its beginning when all of its balls are in: see `bounce_all`.
        starts[cells[i] + 1] -= 1
        members[starts[cells[i] + 1]] = i
    starts[columns * rows + 1] = count
    for a in range(count):
        i = members[a]
        cell = cells[i]
        left, right = cell % columns > 0, (cell + 1) % columns > 0
        bounce_all(balls, members, i, a + 1, starts[cell + 2 + right], radius)
        above = cell + columns
        if above < columns * rows:
            bounce_all(balls, members, i, starts[above + 1 - left], starts[above + 2 + right], radius)


def bounce_all(balls: Any, members: Any, i: int, begin: int, end: int, radius: float) -> None:
    """Let a ball bounce off some of the others, in the order of cells."""
    for b in range(begin, end):
        j = members[b]
        x, y = balls[j, 0] - balls[i, 0], balls[j, 1] - balls[i, 1]
        squared = x * x + y * y
        if squared < 4.0 * radius * radius and squared > 0.0:
            distance = sqrt(squared)
            x, y = x / distance, y / distance
            push = 0.5 * (2.0 * radius - distance)
            balls[i, 0] -= push * x
            balls[i, 1] -= push * y
            balls[j, 0] += push * x
            balls[j, 1] += push * y
            closing = (balls[j, 2] - balls[i, 2]) * x + (balls[j, 3] - balls[i, 3]) * y
            if closing < 0.0:
                balls[i, 2] += closing * x
                balls[i, 3] += closing * y
                balls[j, 2] -= closing * x
                balls[j, 3] -= closing * y


class Bare:
    """A gas that a loop steps: the setup's walls must be a box that begins at (0, 0), and nothing else is looked at."""

    def __init__(self, setup: Setup, loop: Loop, by_address: bool = False) -> None:
        width, height = setup.segments[:, [0, 1]].max(axis=0).tolist()
        columns, rows = (max(floor(side / (2.0 * setup.radius)), 1) for side in (width, height))
        self.balls = np.column_stack((setup.position, setup.velocity))
        count = len(self.balls)
        # Two more than there are cells: each begins where the next entry says, and the last one ends at the last.
        self.tables = np.zeros(count, "u4"), np.zeros(columns * rows + 2, "u4"), np.zeros(count, "u4")
        numbers = setup.time_step, setup.radius, width, height
        given = [table.ctypes.data if by_address else table for table in (self.balls, *self.tables)]
        self.loop = partial(loop, count, columns, rows, *numbers, *given)

    def step(self) -> None:
        """One step."""
        self.loop()

    def state(self) -> tuple[Floats, Floats]:
        """Copies of the two halves of the array."""
        return self.balls[:, :2].copy(), self.balls[:, 2:].copy()

    def first_ball(self) -> tuple[float, float]:
        """The ball's position."""
        return float(self.balls[0, 0]), float(self.balls[0, 1])


@cache
def numba_loop() -> Loop:
    """The loop, compiled by Numba."""
    import numba

    numba.extending.register_jitable(error_model="numpy")(bounce_all)
    compiled: Loop = numba.njit(error_model="numpy")(step_gas)
    return compiled


@cache
def c_loop() -> Loop | None:
    """The loop in C, which takes addresses of tables, made by `CC` or `cc`; None where there is no such compiler."""
    compiler = shlex.split(environ.get("CC") or "cc")
    if shutil.which(compiler[0]) is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "bare.so"
        subprocess.run([*compiler, *OPTIONS, str(SOURCE), "-o", str(made), "-lm"], check=True)
        function = ctypes.CDLL(str(made)).step_gas
    function.argtypes = (*[ctypes.c_uint32] * 3, *[ctypes.c_double] * 4, *[ctypes.c_void_p] * 4)
    function.restype = None
    loop: Loop = function
    return loop


def bare_engines() -> dict[str, Callable[[Setup], Engine]]:
    """The bare loops that can be run here."""
    in_c = c_loop()
    found: dict[str, Callable[[Setup], Engine]] = {"bare loop, Numba": lambda setup: Bare(setup, numba_loop())}
    if in_c is not None:
        found["bare loop, C"] = lambda setup: Bare(setup, in_c, by_address=True)
    return found
