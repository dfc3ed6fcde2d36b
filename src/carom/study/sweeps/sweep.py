"""`study.sweep`: many runs of one scene, each counted once, whatever happens to the processes that make them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import carom
from carom import checks
from carom.errors import CompileError, InvalidArgument, SweepError
from carom.spelling import spelled
from carom.study import measures
from carom.study.sweeps.chunks import Chunks
from carom.study.sweeps.grid import runs_of
from carom.study.sweeps.job import Job
from carom.study.sweeps.ledger import Ledger
from carom.study.sweeps.progress import Meter
from carom.study.sweeps.references import reference_of, refuse_while_importing
from carom.study.sweeps.sources import Source, source_of
from carom.study.sweeps.store import store_of
from carom.study.sweeps.tables import arrow, failure_table, read_table, result_table, table_bytes
from carom.study.sweeps.workers import SERIAL, Answer, Sent, check_cluster, cluster_of, serial_answers

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Iterable

    import pyarrow
    from distributed import Client

    from carom.scene import Scene

#: The kernels of the two detections.
KERNELS = {"discrete": "step_discrete", "continuous": "step_continuous"}


@spelled
def sweep(
    scene: Scene | str | os.PathLike[str] | Callable[[dict[str, Any]], Scene],
    parameters: Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]],
    *,
    measure: Callable[..., Mapping[str, Any]] | str,
    seconds: float,
    out: str | os.PathLike[str],
    dt: float = 1 / 60,
    cluster: str | Client | None = None,
    resume: bool = True,
    progress: bool = True,
) -> pyarrow.Table:
    """The table of many runs of a scene, one row a run, in the order of `parameters`; kept in the folder `out`.

    Its columns are the id of the run, the parameters, the seed, what was measured, the world's digest and the seconds
    of work. Runs that raised, or killed their worker three times, are in `out`/failures.parquet instead. A sweep that
    was interrupted goes on where it was when it is called again; what is in the folder's ledger is not done twice.

    Args:
        scene: A scene, a scene file, the name of a shipped scene, or a function of the parameters that returns a scene
            and can be imported by other processes (or its name, `module:function`).
        parameters: A grid (a list of values for each name, all with all), a list of dictionaries, or a DataFrame. Names
            are paths, `"shapes.left bumper.kick"`, `"balls[0].velocity"`, `"world.gravity"`; arguments of the scene's
            function; and `"seed"`. A seed is handed to a function that takes one; in all other scenes it moves the
            start of every ball by up to a thousandth of its radius along each axis.
        measure: A function of the world at the end of a run, its hits and the parameters, that returns a dictionary of
            numbers, strings and small arrays; it can be imported by other processes. `study.measures` has some.
        seconds: How long each run is, in seconds of the world's time.
        out: The folder that the sweep is kept in, or an address that fsspec knows.
        dt: The length of a step.
        cluster: None for as many processes as this machine has cores, `"serial"` for this process, the address of a
            Dask scheduler, or a `dask.distributed.Client`.
        resume: Whether to go on with what is in `out`; False refuses a folder in which some runs are done.
        progress: Whether to tell on stderr how far it is.

    Raises:
        InvalidArgument: An argument is not as it must be, or `out` holds another sweep; nothing was run.
        SceneError: The scene file is not good.
        SweepError: Another process is at work in `out`, no scheduler answers, or the disk is full; all done is kept.
        MissingExtra: A package is missing; `pip install "carom[sweep]"` brings it.
    """
    refuse_while_importing()
    check_cluster(cluster)
    arrow()
    source = source_of(scene)
    named = measures.by_name(measure) if isinstance(measure, str) else measure
    job = Job(
        source,
        reference_of("measure", named),
        checks.non_negative("seconds", seconds),
        checks.positive("dt", dt),
        carom.__version__,
    )
    resumes, shown = checks.flag("resume", resume), checks.flag("progress", progress)
    store, runs = store_of(out), runs_of(parameters)
    source.check(runs)
    sent = Sent(job, runs, job.ids(runs))
    with _told(store.name), store.claimed():
        ledger = Ledger(store, job.plain(list(sent.ids)), sent.ids)
        ledger.open()
        if ledger.done and not resumes:
            done = f"{len(ledger.done):,} of its {len(runs):,} runs are done"
            raise InvalidArgument(f"out {store.name}: holds this sweep already, {done}; resume goes on with it")
        _work(sent, ledger, cluster, shown)
        rows = ledger.rows()
        table = table_bytes(result_table(runs, sent.ids, rows))
        ledger.finish(table, table_bytes(failure_table(runs, sent.ids, rows)))
    return read_table(table)


@contextmanager
def _told(name: str) -> Iterator[None]:
    """Tell of a place that cannot be read or written in one line."""
    try:
        yield
    except OSError as error:
        if isinstance(error, carom.CaromError):
            raise
        raise SweepError(f"{name}: cannot be written: {error.strerror or error}") from None


def _work(sent: Sent, ledger: Ledger, cluster: Any, shown: bool) -> None:
    """Do what is not done, and write it down."""
    chunks = Chunks(place for place, name in enumerate(sent.ids) if name not in ledger.done)
    if not chunks:
        return
    if cluster is None or cluster == SERIAL:
        _compile(sent.job.source, sent)
    with Meter(len(sent.ids), len(ledger.done), shown) as meter:
        if cluster == SERIAL:
            _write(serial_answers(sent, chunks), ledger, meter)
        else:
            with cluster_of(cluster, len(sent.ids) - len(ledger.done)) as workers:
                _write(workers.answers(sent, chunks), ledger, meter)


def _write(answers: Iterator[Answer], ledger: Ledger, meter: Meter) -> None:
    """Write answers down as they come; refuse a measure whose first answers no table can hold."""
    for answer in answers:
        wrong = [row.error for row in answer.rows if row.nonsense]
        if wrong and len(ledger.done) == ledger.failed:
            raise InvalidArgument(str(wrong[0]).partition(": ")[2])
        ledger.add(answer.rows, answer.attempt, answer.worker)
        meter.tell(len(ledger.done), ledger.failed, answer.workers)


def _compile(source: Source, sent: Sent) -> None:
    """Compile what the runs need and keep it, before processes start that would each do so."""
    from carom.world.ahead import compile_kernels

    wanted: set[str] = {
        str(run.parameters["world.detection"]) for run in sent.runs if "world.detection" in run.parameters
    }
    if not wanted:
        try:
            wanted = {source.of(sent.runs[0]).world.detection}
        except Exception:  # noqa: BLE001  # whatever a user's function may raise is told as that run's failure
            wanted = set()
    try:
        compile_kernels({KERNELS[detection] for detection in wanted if detection in KERNELS})
    except CompileError:
        return  # there is no compiler, or nothing can be kept: workers do as they can
