"""One process at a time compiles a kernel; the others wait for what it keeps, and see how far it is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

#: Seconds between two looks at how far another process is.
LOOK = 0.2


class Far:
    """How many functions the process that compiles a kernel has come to, in a file that the others read."""

    def __init__(self, folder: Path, name: str) -> None:
        self._file = folder / f"{name}.far"

    def write(self, count: int) -> None:
        """Let the others know; a disk that is full keeps nobody from compiling."""
        try:
            self._file.write_text(str(count), encoding="ascii")
        except OSError:
            return

    def read(self) -> int:
        """The functions so far; 0 where nothing is known of it."""
        try:
            return int(self._file.read_text(encoding="ascii"))
        except (OSError, ValueError):
            return 0

    def forget(self) -> None:
        """Take the file away."""
        try:
            self._file.unlink(missing_ok=True)
        except OSError:
            return


@contextmanager
def claimed(folder: Path, name: str, waits: Callable[[int], None]) -> Iterator[Far]:
    """Have the making of a kernel to oneself; who waits for it is called `waits` with how far the other one is.

    The system holds the lock for as long as its process lives, so one that was killed leaves none behind. Where the
    folder's file system knows no locks, everybody compiles.
    """
    from filelock import FileLock, Timeout

    far = Far(folder, name)
    lock = FileLock(folder / f"{name}.lock")
    while True:
        try:
            lock.acquire(timeout=LOOK, poll_interval=LOOK / 4)
        except Timeout:
            waits(far.read())
        except (OSError, NotImplementedError):
            break
        else:
            break
    try:
        yield far
    finally:
        far.forget()
        lock.release()
