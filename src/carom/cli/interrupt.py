"""Ctrl-C as a question that is answered between two steps, never in the middle of one."""

from __future__ import annotations

import signal
from typing import Self


class Interrupt:
    """While entered, the first Ctrl-C sets `asked`; a second one interrupts at once, as it always does."""

    def __init__(self) -> None:
        self.asked = False

    def __enter__(self) -> Self:
        self._before = signal.getsignal(signal.SIGINT)
        # A program that was started to ignore Ctrl-C (in the background of a script) goes on ignoring it.
        if self._before != signal.SIG_IGN:
            signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_: object) -> None:
        signal.signal(signal.SIGINT, self._before)

    def _note(self, *_: object) -> None:
        """Raise `KeyboardInterrupt`, once; called by Python on Ctrl-C."""
        self.asked = True
        signal.signal(signal.SIGINT, self._before)
