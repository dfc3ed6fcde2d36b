"""What a user is told while kernels are compiled, on stderr: that it goes on, how far it is, how long it took."""

from __future__ import annotations

import sys
import threading
import time
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    from carom.compiler.lock import Far

#: Seconds between two lines about compiling where stderr is no terminal.
INTERVAL = 5.0


def say(text: str, end: str = "\n") -> None:
    """Write to stderr, which a program without a console has not."""
    if sys.stderr is not None:
        print(text, end=end, file=sys.stderr, flush=True)


def spoken(function: str) -> str:
    """The name of a kernel in words."""
    return function.replace("_", " ")


class Teller:
    """While entered, counts the functions that Numba compiles and tells of it, if there is anything to compile at all.

    On a terminal one line says how far it is. Anywhere else that would be nothing but control characters, so there a
    line of its own says it every `INTERVAL` seconds: a log that stands still looks like a program that does.

    Attributes:
        far: Where the count is written for other processes, if they can be waiting for it.
    """

    def __init__(self, name: str, about: int) -> None:
        self._name = spoken(name)
        self._about = about
        self._seen: set[str] = set()
        self._count = -1
        self._over = threading.Event()
        self._terminal = sys.stderr is not None and sys.stderr.isatty()
        self.far: Far | None = None

    def __enter__(self) -> Self:
        self._began = time.perf_counter()
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        self._over.set()
        if self._count < 0:
            return
        if kind is None:
            say(f"{self._start}carom: compiled {self._name} in {self.seconds:.1f} s")
        elif self._terminal:
            say("")

    @property
    def seconds(self) -> float:
        """Seconds since it was entered."""
        return time.perf_counter() - self._began

    @property
    def compiles(self) -> bool:
        """Whether this process has begun to compile something."""
        return bool(self._seen)

    @property
    def _start(self) -> str:
        """What a line begins with that takes the place of the one before, where it can."""
        return "\r" if self._terminal else ""

    def _far(self) -> str:
        """How far it is."""
        return f"{self._count} of about {self._about} functions"

    def listener(self, numba: Any) -> Any:
        """A Numba listener that reports to this teller."""
        teller = self

        class Listener(numba.core.event.Listener):  # type: ignore[misc]
            def on_start(self, event: Any) -> None:
                teller.see(str(getattr(event.data.get("dispatcher"), "__name__", "")))

            def on_end(self, event: Any) -> None:
                pass

        return Listener()

    def see(self, function: str) -> None:
        """Take note of one more function being compiled."""
        self._seen.add(function)
        self._tell(len(self._seen), "once on this machine")
        if self.far is not None:
            self.far.write(len(self._seen))

    def waits(self, count: int) -> None:
        """Take note that another process compiles, and how many functions it has come to."""
        self._tell(count, "by another process")

    def _tell(self, count: int, how: str) -> None:
        """Say that it has begun, and how far it is."""
        first = self._count < 0
        self._count = count
        if first:
            say(f"carom: compiling {self._name}, {how} ...")
        if self._terminal:
            say(f"\rcarom: {self._far()}", end="")
        elif first:
            # A thread of its own: the last and longest part of the work is a single call.
            threading.Thread(target=self._tell_on, name="carom-compiling", daemon=True).start()

    def _tell_on(self) -> None:
        """Say that it goes on, every few seconds until it is over."""
        while not self._over.wait(INTERVAL):
            say(f"carom: compiling {self._name}: {self._far()}, {self.seconds:.0f} s")
