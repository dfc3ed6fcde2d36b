"""A clock for tests: what does not return in time fails."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter, process_time
from types import FrameType

#: Seconds that the loop of `pace` takes on the machine whose seconds are meant.
LOOP_SECONDS = 0.007

#: How many times longer than its seconds a block may take that does not get the processor, or waits for something.
PATIENCE = 5.0
#: So few seconds more or less are none.
SHORTEST = 0.01


def pace() -> float:
    """How many times slower than such a machine this one is now, on which others may work too; 1 at least."""
    longest = 0.0
    for _ in range(10):
        began, total = perf_counter(), 0
        for number in range(200_000):
            total += number
        longest = max(longest, perf_counter() - began)
    return max(1.0, longest / LOOP_SECONDS)


@contextmanager
def soon() -> Iterator[None]:
    """Raise where what ought to take a second takes two; on a slower machine, as much longer as that is slower."""
    with within(2.0 * pace()):
        yield


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raise where the block takes longer; a compiled step hears it between events, as it hears Ctrl-C.

    Seconds in which others have the processor do not count, up to `PATIENCE` times as many.
    """
    began, last = process_time(), perf_counter() + PATIENCE * seconds

    def ring(_signal: int, _frame: FrameType | None) -> None:
        left = min(began + seconds - process_time(), last - perf_counter())
        if left <= SHORTEST:
            raise TimeoutError(f"no end within {seconds:g} s")
        signal.setitimer(signal.ITIMER_REAL, left)

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
