"""The child process that compiles kernels into the cache on disk while this one goes on: one at a time.

It belongs to no terminal, so that Ctrl-C does not end it, and goes on if this process ends before it does: the next one
finds what it has made.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from pathlib import Path

from carom.compiler.kernels import Kernel
from carom.compiler.teller import say, spoken

#: The module that the child runs, with names of kernels as its arguments.
MODULE = "carom.world.ahead"


class Work:
    """What a child has been given to compile.

    Attributes:
        functions: The kernels.
        status: The child's exit status; None while it is at work.
        seconds: How long it took.
    """

    def __init__(self, functions: list[Kernel]) -> None:
        self.functions = functions
        self.status: int | None = None
        self.seconds = 0.0
        self._began = time.perf_counter()
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-m", MODULE, *(function.__name__ for function in functions)],
            env=os.environ | {"PYTHONPATH": os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            creationflags=_quiet_and_low(),
        )
        # A thread waits for it, so that it is no zombie when it has ended and nobody looks.
        threading.Thread(target=self._wait, name="carom-child", daemon=True).start()

    def _wait(self) -> None:
        """Note how the child ends."""
        status = self._process.wait()
        self.seconds = time.perf_counter() - self._began
        try:
            if status == 0:
                # What it has made is read by Numba, and to import that takes as long as many frames of a game.
                from carom.compiler.door import warm

                warm()
        finally:
            self.status = status

    def names(self) -> str:
        """The kernels in words."""
        return ", ".join(spoken(function.__name__) for function in self.functions)


def _quiet_and_low() -> int:
    """What Windows is told when a child is made: no console, low priority. Elsewhere the child makes itself nice."""
    if sys.platform == "win32":
        return subprocess.CREATE_NO_WINDOW | subprocess.BELOW_NORMAL_PRIORITY_CLASS
    return 0


_work: Work | None = None
_waiting: list[Kernel] = []
_asked: set[Kernel] = set()
_failed = False
_lock = threading.RLock()


def possible() -> bool:
    """Whether there is a Python to run as a child: a program that was packed into one file is none."""
    return bool(sys.executable) and not getattr(sys, "frozen", False)


def ask(function: Kernel) -> bool:
    """True if a kernel will be compiled, after those asked for before; False if it was already, or a child failed."""
    with _lock:
        if _failed or function in _asked:
            return False
        _asked.add(function)
        _waiting.append(function)
        look()
        return not _failed


def busy_with(function: Kernel) -> bool:
    """Whether a kernel is being compiled, or waits for its turn."""
    work = _work
    return function in _waiting or (work is not None and work.status is None and function in work.functions)


def look() -> None:
    """See whether the child is done, tell the user, and start the next one if there is more to do."""
    global _work
    if not _waiting and (_work is None or _work.status is None):
        return
    with _lock:
        if _work is not None and _work.status is not None:
            _tell_end(_work, _work.status)
            _work = None
        if _work is None and _waiting:
            functions = _waiting[:]
            try:
                _work = Work(functions)
            except OSError as error:
                _give_up(f"no process can be started to compile ({error.strerror})")
                return
            say(f"carom: compiling {_work.names()}, once on this machine; until then it runs interpreted")
            _waiting.clear()


def _tell_end(work: Work, status: int) -> None:
    """Tell the user how the child has ended."""
    if status == 0:
        say(f"carom: compiled {work.names()} in {work.seconds:.1f} s")
    else:
        _give_up(f"compiling {work.names()} has failed (status {status})")


def _give_up(reason: str) -> None:
    """Tell the user, once, that there will be no more children, and why."""
    global _failed
    _failed = True
    _waiting.clear()
    say(f"carom: {reason}; it stays interpreted. `carom compile` compiles, or says what is wrong")


def compiling() -> bool:
    """True while kernels are compiled in the background."""
    look()
    return _work is not None


def _forget() -> None:
    """Forget the child, in a process that was forked: it is not the child's parent, and sees nothing of its end."""
    global _work, _lock
    _work, _lock = None, threading.RLock()
    _waiting.clear()
    _asked.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)
