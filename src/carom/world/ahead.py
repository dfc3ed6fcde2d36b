"""Compiling ahead: every kernel, for the arguments that worlds call it with, into the cache on disk.

As a program, `python -m carom.world.ahead NAME...`, it compiles the kernels of those names: the child process that is
started where a world needs a kernel which is not there.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from carom.compiler import door
from carom.compiler.block import Block
from carom.compiler.cache import cache_folder
from carom.compiler.kernels import Kernel
from carom.errors import CompileError
from carom.rows.copies import JOB, LAYOUT
from carom.rows.hit import HIT_ROW
from carom.rows.index import INDEX
from carom.rows.query import AIM, CAST_HIT, CONTACT, IN_BOX, NEIGHBOR, QUERY, SEARCH_GRID
from carom.rows.shape import SHAPE
from carom.rows.state import CONTINUOUS, STATE
from carom.world.kernels.continuous.film import step_continuous
from carom.world.kernels.copies.stepping import step_copies
from carom.world.kernels.queries.aiming import aim_many
from carom.world.kernels.queries.casting import cast_many
from carom.world.kernels.queries.nearest import nearest_many
from carom.world.kernels.queries.overlapping import overlapping_many, overlaps_of_balls
from carom.world.kernels.queries.search_grid import build_search_grid, width_of_all
from carom.world.kernels.step.discrete import step_discrete
from carom.world.search import list_of
from carom.world.tables import Arrays

#: How nice the child is where the system has niceness: what the user does gets the processor first, but not all of it.
NICENESS = 5


@dataclass(frozen=True, slots=True)
class Compiled:
    """What `carom.compile` did.

    Attributes:
        folder: Where compiled code is kept.
        seconds: The kernels that were compiled now, by name, with the seconds each of them took.
        kept: The names of those that were there already.
        prebuilt: The names of those that came compiled with carom, and need no folder.
    """

    folder: Path
    seconds: dict[str, float]
    kept: tuple[str, ...]
    prebuilt: tuple[str, ...]


def compile() -> Compiled:
    """What was compiled, and where it is kept: all that worlds will need, so that none waits or is interpreted.

    It takes some minutes, once on a machine for each version of carom, of Numba and of Python; progress is told on
    stderr. What another process is compiling is waited for. `carom compile` does the same.

    Raises:
        CompileError: There is no compiler or it is switched off, or the folder cannot be written to.
        InvalidArgument: The variable `CAROM_COMPILE` is none of its words.
    """
    return compile_kernels({function.__name__ for function in examples()})


def compile_kernels(names: Collection[str]) -> Compiled:
    """What was compiled of the kernels of some names; raises as `compile`."""
    seconds: dict[str, float] = {}
    kept: list[str] = []
    prebuilt: list[str] = []
    for function, arguments in examples().items():
        name = function.__name__
        if name not in names:
            continue
        if door.ready_made(function) is not None:
            prebuilt.append(name)
            continue
        took = door.keep(function, arguments)
        if took is None:
            kept.append(name)
        else:
            seconds[name] = took
    return Compiled(cache_folder(), seconds, tuple(kept), tuple(prebuilt))


def prebuild(folder: str, *names: str) -> None:
    """Make the library of compiled kernels that a wheel brings along, of all kernels unless some are named.

    Raises:
        CompileError: There is no kernel of a name.
        RuntimeError: Numba has compiled in this process already.
    """
    kernels = {function.__name__: (function, arguments) for function, arguments in examples().items()}
    strangers = set(names) - set(kernels)
    if strangers:
        raise CompileError(f"there are no kernels called {sorted(strangers)}; there are {list(kernels)}")
    from carom.compiler.building import build

    build(dict(kernels[name] for name in names or kernels), Path(folder))


def examples() -> dict[Kernel, tuple[Any, ...]]:
    """Every kernel that worlds call, with arguments of the types that it calls it with."""
    discrete, continuous = Arrays(), Arrays()
    continuous.states[0]["detection"] = CONTINUOUS
    tables = discrete.shapes.used, discrete.balls.used
    numbers = np.zeros(0, "i4")
    queries = np.zeros(0, QUERY)
    casts = np.zeros(0, CAST_HIT), numbers

    def asked(*answers: Any) -> tuple[Any, ...]:
        return (queries, *tables, *list_of(numbers), *list_of(numbers), numbers, *answers)

    return {
        step_discrete: (discrete.block(),),
        cast_many: asked(*casts),
        nearest_many: asked(np.zeros(0, NEIGHBOR)),
        overlapping_many: asked(np.zeros(0, IN_BOX)),
        overlaps_of_balls: asked(np.zeros(0, CONTACT)),
        width_of_all: tables,
        build_search_grid: (np.zeros(1, SEARCH_GRID), *tables, numbers, numbers, numbers),
        aim_many: (queries, *casts, np.zeros(0, np.int64), np.zeros((0, 2)), *tables, False, np.zeros(0, AIM)),
        step_copies: (_copies_block(),),
        step_continuous: (continuous.block(),),
    }


def _copies_block() -> Block:
    """What the kernel that steps many copies is called with."""
    states, shapes, index = np.zeros(2, STATE), np.zeros(0, SHAPE), np.zeros(2, INDEX)
    words, rows, hits = np.zeros(0, np.int64), np.zeros(0, "i4"), np.zeros(0, HIT_ROW)
    jobs, layouts = np.zeros(1, JOB), np.zeros(1, LAYOUT)
    memory = words, words.view(np.uint8), words
    tables = states, (words,) * 6, shapes, rows, index, words, (rows, rows, rows), hits
    return Block((jobs, layouts, *memory, *tables, (hits, words), (words, words)))


def main(names: Sequence[str]) -> int:
    """The exit status of a child that compiles kernels behind: 0 if all are there."""
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    try:
        compile_kernels(names)
    except CompileError as error:
        sys.exit(str(error))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
