"""A Dask scheduler and its workers on this machine, each started by its command, as on a cluster."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from select import select
from typing import Any

import psutil

ROOT = Path(__file__).parents[1]


def environment(more: Mapping[str, str]) -> dict[str, str]:
    """The environment of processes that can import the tests, and interpret kernels, which is quickest for a few."""
    path = os.pathsep.join([str(ROOT), str(ROOT / "src")])
    return {**os.environ, "PYTHONPATH": path, "CAROM_COMPILE": "off", **more}


class CommandCluster:
    """A scheduler and workers.

    Attributes:
        address: That of the scheduler.
        nannies: The processes that start a worker anew when it dies.
    """

    def __init__(self, address: str, nannies: list[subprocess.Popen[bytes]]) -> None:
        self.address = address
        self.nannies = nannies

    def kill_worker(self, chance: random.Random) -> bool:
        """Whether there was a worker to end by SIGKILL; one of them is."""
        workers = [child for nanny in self.nannies for child in workers_of(nanny.pid)]
        if not workers:
            return False
        with suppress(psutil.NoSuchProcess):
            chance.choice(workers).send_signal(signal.SIGKILL)
        return True


def workers_of(parent: int) -> list[psutil.Process]:
    """The worker processes that a process has started."""
    with suppress(psutil.Error):
        children = psutil.Process(parent).children()
        forked = [one for child in children if "forkserver" in " ".join(child.cmdline()) for one in child.children()]
        return forked + [child for child in children if "spawn_main" in " ".join(child.cmdline())]
    return []


class Coordinators:
    """Processes that run a sweep, one after the other."""

    def __init__(self, log: Path) -> None:
        self._log = log
        with log.open("wb") as errors:
            self._maker = subprocess.Popen(
                [sys.executable, "-m", "tests.sweeping"],
                env=environment({}),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
            )

    def start(self, asked: Mapping[str, Any]) -> None:
        """Start the sweep that is asked for."""
        assert self._maker.stdin
        self._log.write_bytes(b"")
        self._maker.stdin.write(json.dumps(asked).encode() + b"\n")
        self._maker.stdin.flush()
        self._number = int(self._line())

    def kill(self) -> bool:
        """Whether there was still one to end by SIGKILL; it is."""
        with suppress(ProcessLookupError):
            os.kill(self._number, signal.SIGKILL)
            return True
        return False

    def status(self, seconds: float) -> int | None:
        """The exit status of the one that ran; None where it still runs after some seconds."""
        assert self._maker.stdout
        return int(self._line()) if select([self._maker.stdout], [], [], seconds)[0] else None

    def told(self) -> str:
        """What the last one wrote to stderr."""
        return self._log.read_text().replace("\0", "")

    def close(self) -> None:
        """End them all."""
        self._maker.kill()
        self._maker.communicate()

    def _line(self) -> bytes:
        """The next line of the process that makes them."""
        assert self._maker.stdout
        return self._maker.stdout.readline()


@contextmanager
def command_cluster(folder: Path, workers: int = 2, **more: str) -> Iterator[CommandCluster]:
    """A scheduler with some workers, which end with the context."""
    file, started = folder / "scheduler.json", []
    given = environment({"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0", **more})

    def start(module: str, *arguments: str) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", module, "--scheduler-file", str(file), *arguments]
        log = (folder / f"{module}{len(started)}.log").open("wb")
        started.append(subprocess.Popen(command, env=given, cwd=folder, stdout=log, stderr=log))
        log.close()
        return started[-1]

    try:
        start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
        while not file.exists() or not file.stat().st_size:
            time.sleep(0.05)
        nannies = [start("tests.dask_nanny", "--nthreads", "1", "--no-dashboard") for _ in range(workers)]
        yield CommandCluster(json.loads(file.read_text())["address"], nannies)
    finally:
        for process in reversed(started):
            process.terminate()
        for process in reversed(started):
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
