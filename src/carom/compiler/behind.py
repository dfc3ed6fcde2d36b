"""A kernel that is interpreted while it is compiled elsewhere, as long as that is quick enough."""

from __future__ import annotations

import time
from collections.abc import Callable
from threading import RLock
from typing import Any, Protocol

from carom.compiler import child
from carom.compiler.kernels import Kernel

#: Seconds that a step, or a call that answers queries, may take in the interpreter; for longer ones the caller waits.
LONGEST = 0.1
#: Seconds that a unit of work takes in the interpreter, roughly, before any was measured.
UNIT = 1e-4

#: How much work a call is, by its arguments: how many steps it makes, and how many units of work each of them is.
Size = Callable[..., tuple[int, float]]


class NotKept(Exception):
    """The kernel is not in the cache on disk."""


class Source(Protocol):
    """Where a compiled kernel comes from."""

    def kept(self, arguments: tuple[Any, ...]) -> Kernel:
        """The kernel for some arguments as it is kept on disk; raises `NotKept`."""

    def made(self, arguments: tuple[Any, ...]) -> tuple[Kernel, float]:
        """The kernel, compiled now, and the seconds that took."""


class Behind:
    """A kernel that is called while a child process compiles it, and changes over once that is done.

    What a call will take is foretold by the calls so far: their seconds over their units of work. All of them count, so
    that one which was held up by something else does not make the caller wait.
    """

    def __init__(self, function: Kernel, interpreted: Kernel, size: Size, source: Source, compiling: RLock) -> None:
        self._function = function
        self._interpreted = interpreted
        self._size = size
        self._source = source
        self._compiling = compiling
        self._compiled: Kernel | None = None
        self._lost = False
        # What is known before the first call counts as much as one call of the longest kind.
        self._seconds, self._units = LONGEST, LONGEST / UNIT

    def __call__(self, *arguments: Any) -> Any:
        """What the kernel returns."""
        child.look()
        steps, units = self._size(*arguments)
        small = units * self._seconds < LONGEST * self._units
        kernel = self._compiled
        if kernel is None and not (small and child.busy_with(self._function)):
            with self._compiling:
                kernel = self._compiled = self._compiled or self._changed_over(arguments, small)
        if kernel is not None:
            return kernel(*arguments)
        began = time.perf_counter()
        result = self._interpreted(*arguments)
        self._seconds += time.perf_counter() - began
        self._units += units * max(1, steps - self._size(*arguments)[0])
        return result

    def _changed_over(self, arguments: tuple[Any, ...], small: bool) -> Kernel | None:
        """The compiled kernel; None where it is to be interpreted for now."""
        if small and self._lost:
            return None
        try:
            return self._source.kept(arguments)
        except NotKept:
            pass
        if small:
            self._lost = not child.ask(self._function)
            return None
        # Where the child is at it, this waits for the child.
        return self._source.made(arguments)[0]
