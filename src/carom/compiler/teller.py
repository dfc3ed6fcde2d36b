"""What a user is told while kernels are compiled, on stderr: that it goes on, how far it is, how long it took."""

from __future__ import annotations

import sys
import threading
import time
from typing import Any, Self

#: Seconds between two lines about compiling where stderr is no terminal.
INTERVAL = 5.0


class Teller:
    """While entered, counts the functions that Numba compiles and tells of it, if it has to compile at all.

    On a terminal one line says how far it is. Anywhere else that would be nothing but control characters, so there a
    line of its own says it every `INTERVAL` seconds: a log that stands still looks like a program that does.
    """

    def __init__(self, name: str, about: int) -> None:
        self._name = name.replace("_", " ")
        self._about = about
        self._seen: set[str] = set()
        self._over = threading.Event()
        self._terminal = sys.stderr is not None and sys.stderr.isatty()

    def __enter__(self) -> Self:
        self._began = time.perf_counter()
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        self._over.set()
        if not self._seen:
            return
        if kind is None:
            seconds = time.perf_counter() - self._began
            self._say(f"{self._start}carom: compiled {self._name} in {seconds:.1f} s")
        elif self._terminal:
            self._say("")

    @property
    def _start(self) -> str:
        """What a line begins with that takes the place of the one before, where it can."""
        return "\r" if self._terminal else ""

    def _far(self) -> str:
        """How far it is."""
        return f"{len(self._seen)} of about {self._about} functions"

    def _say(self, text: str, end: str = "\n") -> None:
        """Write to stderr, which a program without a console has not."""
        if sys.stderr is not None:
            print(text, end=end, file=sys.stderr, flush=True)

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
        first = not self._seen
        self._seen.add(function)
        if first:
            self._say(f"carom: compiling {self._name}, once on this machine ...")
        if self._terminal:
            self._say(f"\rcarom: {self._far()}", end="")
        elif first:
            # A thread of its own: the last and longest part of the work is a single call.
            threading.Thread(target=self._tell_on, name="carom-compiling", daemon=True).start()

    def _tell_on(self) -> None:
        """Say that it goes on, every few seconds until it is over."""
        while not self._over.wait(INTERVAL):
            seconds = time.perf_counter() - self._began
            self._say(f"carom: compiling {self._name}: {self._far()}, {seconds:.0f} s")
