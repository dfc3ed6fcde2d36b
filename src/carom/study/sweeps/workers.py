"""Who does the work: this process, process workers on this machine, or a Dask cluster."""

from __future__ import annotations

import logging
import pickle
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import resource_tracker
from typing import Any

from carom.checks import refuse
from carom.errors import SweepError
from carom.extras import needed
from carom.study.sweeps.chunks import MOST_DEATHS, Chunk, Chunks
from carom.study.sweeps.grid import Run
from carom.study.sweeps.job import Job, Row, run_chunk

SERIAL = "serial"
#: Chunks of a worker that are out at the same time.
PER_WORKER = 2
#: Seconds between two looks at the workers.
POLL = 0.5
#: Seconds that a scheduler has to answer.
PATIENCE = 10.0
#: What processes that share a machine must not do: start threads for each of its cores.
ONE_THREAD = {"NUMBA_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


@dataclass(frozen=True, slots=True)
class Answer:
    """What came back of a chunk; no rows where there is nothing new but the time that passed."""

    rows: Sequence[Row] = ()
    attempt: int = 0
    worker: str = ""
    workers: int = 1


@dataclass(frozen=True)
class Sent:
    """The job and the runs of a sweep, by their places, with their ids."""

    job: Job
    runs: Sequence[Run]
    ids: Sequence[str]

    def of(self, chunk: Chunk) -> list[tuple[str, Run]]:
        """The runs of a chunk with their ids."""
        return [(self.ids[place], self.runs[place]) for place in chunk.places]


def serial_answers(sent: Sent, chunks: Chunks) -> Iterator[Answer]:
    """The answers of this process, chunk by chunk."""
    while chunk := chunks.next(0):
        rows = sent.job.rows(sent.of(chunk))
        chunks.done(len(rows), sum(row.seconds for row in rows))
        yield Answer(rows, chunk.attempt, "this process")


class Cluster:
    """The workers of a Dask client."""

    def __init__(self, client: Any, name: str) -> None:
        self._client = client
        self._name = name
        self._distributed = distributed()

    def answers(self, sent: Sent, chunks: Chunks) -> Iterator[Answer]:
        """The answers of the workers as they come.

        Raises:
            SweepError: The scheduler is gone, or workers cannot do what they are asked.
        """
        packed = pickle.dumps(sent.job)
        flying: dict[Any, Chunk] = {}
        try:
            while chunks or flying:
                workers = len(self._client.nthreads())
                self._send(packed, sent, chunks, flying, workers)
                yield Answer(workers=workers)
                for future in self._landed(flying):
                    yield self._answer(future, flying.pop(future), sent, chunks)
        except (OSError, self._distributed.CancelledError, self._distributed.client.FutureCancelledError) as error:
            raise SweepError(f"{self._name}: the Dask scheduler is gone ({error})") from None
        finally:
            for future in flying:
                future.release()

    def _send(self, packed: bytes, sent: Sent, chunks: Chunks, flying: dict[Any, Chunk], workers: int) -> None:
        """Send chunks until each worker has as many as it may have."""
        while len(flying) < PER_WORKER * workers:
            chunk = chunks.next(len(flying))
            if chunk is None:
                break
            flying[self._client.submit(run_chunk, packed, sent.of(chunk), pure=False)] = chunk

    def _landed(self, flying: dict[Any, Chunk]) -> list[Any]:
        """The futures that are done; none after a while in which none is."""
        if not flying:
            time.sleep(POLL)
            return []
        try:
            with self._client.as_current():
                done, _ = self._distributed.wait(list(flying), timeout=POLL, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return []
        return list(done)

    def _answer(self, future: Any, chunk: Chunk, sent: Sent, chunks: Chunks) -> Answer:
        """What came back of a chunk: its rows, or those of runs that killed their worker too often."""
        try:
            rows, worker = future.result()
        except self._distributed.KilledWorker as death:
            given_up = chunks.died(chunk, death.args[2] + 1 if len(death.args) > 2 else 1)
            why = f"killed its worker {MOST_DEATHS} times"
            rows = [Row(sent.ids[place], None, None, why, 0.0) for place in given_up]
            return Answer(rows, chunk.attempt, "none")
        except SweepError as error:
            raise SweepError(f"{self._name}: {error}") from None
        except (OSError, self._distributed.CancelledError, self._distributed.client.FutureCancelledError):
            raise
        except Exception as error:
            raise SweepError(f"{self._name}: a worker cannot do this: {type(error).__name__}: {error}") from error
        chunks.done(len(rows), sum(row.seconds for row in rows))
        return Answer(rows, chunk.attempt, worker)


def distributed() -> Any:
    """Dask's package for clusters; raises `MissingExtra` where it is not installed."""
    return needed("distributed", "dask[distributed]", "sweep", "sweeps by several processes")


@contextmanager
def cluster_of(given: Any, runs: int) -> Iterator[Cluster]:
    """The cluster that the argument `cluster` of a sweep means; what is started for it ends with it.

    Raises:
        SweepError: No scheduler answers, or no process can be started.
        InvalidArgument: It is no address, client or None.
    """
    if given is None:
        with _silent_client(), _local(runs) as client:
            yield Cluster(client, "this machine")
    elif isinstance(given, str):
        with _silent_client(), _connected(given) as client:
            yield Cluster(client, given)
    else:
        yield Cluster(given, str(given.scheduler_info()["address"]))


def check_cluster(given: Any) -> None:
    """Raise unless `given` is what the argument `cluster` may be, and its package is there."""
    if given is not None and not isinstance(given, str):
        known = sys.modules.get("distributed")
        if known is None or not isinstance(given, known.Client) or given.asynchronous:
            raise refuse("cluster", "must be None, 'serial', the address of a Dask scheduler, or a Client", given)
    if given != SERIAL:
        distributed()


@contextmanager
def _silent_client() -> Iterator[None]:
    """Let Dask's client keep to itself that workers die, which a sweep expects."""
    log = logging.getLogger("distributed.client")
    before = log.level
    log.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        log.setLevel(before)


@contextmanager
def _connected(address: str) -> Iterator[Any]:
    """A client of the scheduler at an address."""
    module = distributed()
    try:
        # A client that cannot read its address takes long to go, and not in silence.
        module.comm.resolve_address(address)
        client = module.Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise SweepError(f"cluster {address}: no Dask scheduler answers there ({error})") from None
    try:
        yield client
    finally:
        client.close()


@contextmanager
def _local(runs: int) -> Iterator[Any]:
    """A client of as many processes as this machine has cores, or as there are runs."""
    dask, module = needed("dask", "dask[distributed]", "sweep", "sweeps by several processes"), distributed()
    system = needed("dask.system", "dask[distributed]", "sweep", "sweeps by several processes")
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}), _no_program():
        try:
            with _deaf_to_ctrl_c():
                cluster = module.LocalCluster(
                    n_workers=min(system.CPU_COUNT, runs),
                    threads_per_worker=1,
                    processes=True,
                    dashboard_address="localhost:0",
                    silence_logs=logging.CRITICAL,
                    env=ONE_THREAD,
                )
        except (OSError, RuntimeError) as error:
            raise SweepError(f"no worker processes can be started: {error}") from None
        try:
            with module.Client(cluster, set_as_default=False) as client:
                yield client
        finally:
            cluster.close()


@contextmanager
def _deaf_to_ctrl_c() -> Iterator[None]:
    """Let Ctrl-C, which a terminal sends to all processes of a command, pass by those that Dask starts.

    Its thread, which begins meanwhile and starts workers anew when they die, inherits what this one blocks; so do they.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # When it is started later, multiprocessing's tracker lets the signal through to the thread that starts it.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _no_program() -> Iterator[None]:
    """Hide from new processes which program this is, so that they do not run it again to import what is in it."""
    main = sys.modules["__main__"]
    hidden = {name: vars(main)[name] for name in ("__file__", "__spec__") if vars(main).get(name) is not None}
    for name in hidden:
        setattr(main, name, None)
    try:
        yield
    finally:
        for name, value in hidden.items():
            setattr(main, name, value)
