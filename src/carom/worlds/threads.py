"""The threads on which copies are stepped: each has a stage and a share of the copies."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from itertools import pairwise
from threading import Event

from carom.worlds.stage import Stage

#: Copies for which it is worth it to wake one more thread.
SHARE = 16


class Crew:
    """Threads that are started when they are first needed, at most so many.

    A process that is forked has none of the threads of the one that it was forked from: there they are started anew.
    """

    def __init__(self, most: int) -> None:
        self.most = most
        self._pool: ThreadPoolExecutor | None = None
        self._process = 0
        self._stop = Event()

    def shares(self, count: int) -> list[tuple[int, int]]:
        """The copies of each thread, from the first to before the last."""
        threads = max(1, min(self.most, count // SHARE))
        ends = [count * k // threads for k in range(threads + 1)]
        return list(pairwise(ends))

    def _threads(self) -> ThreadPoolExecutor:
        """The threads of this process beside the one that asks."""
        if self._pool is None or self._process != os.getpid():
            self._pool = ThreadPoolExecutor(self.most - 1, thread_name_prefix="carom-worlds")
            self._process = os.getpid()
        return self._pool

    def work(self, stages: Sequence[Stage]) -> bool:
        """True if all stages have done their jobs; False where the memory lacks room for one."""
        stop = self._stop
        if len(stages) == 1:
            return stages[0].work(stop)
        others = [self._threads().submit(stage.work, stop) for stage in stages[1:]]
        try:
            done = stages[0].work(stop)
            return all([done, *(other.result() for other in others)])
        except BaseException:
            # Nobody may write to the memory any more when this is left.
            stop.set()
            wait(others)
            self._stop = Event()
            raise


def cores() -> int:
    """How many threads there are unless a user says: one a core, and one in a process that another one has started."""
    if multiprocessing.parent_process() is not None:
        return 1
    available = getattr(os, "sched_getaffinity", None)
    return len(available(0)) if available is not None else os.cpu_count() or 1
