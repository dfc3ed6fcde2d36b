"""Forked processes, for what must hold in them too."""

import os
import signal
import time
import traceback
import warnings
from collections.abc import Callable

#: Seconds after which a forked process is taken to hang.
PATIENCE = 30.0


def forked(do: Callable[[], object]) -> int:
    """The exit status of a process that is forked from this one and does something: 0, or 1 where that raised.

    Fails where it does not end.
    """
    with warnings.catch_warnings():
        # That this process has threads is what the tests are about.
        warnings.simplefilter("ignore", DeprecationWarning)
        child = os.fork()
    if child == 0:
        status = 1
        try:
            do()
            status = 0
        except BaseException:  # noqa: BLE001  # nothing may come out of here: it would run the rest of the tests
            traceback.print_exc()
        finally:
            os._exit(status)
    last = time.perf_counter() + PATIENCE
    while True:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status)
        if time.perf_counter() > last:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            raise TimeoutError("a forked process hangs")
        time.sleep(0.01)
