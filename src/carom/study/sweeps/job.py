"""What workers do: the runs of a chunk, each with its answer or its error."""

from __future__ import annotations

import os
import pickle
import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from time import perf_counter
from typing import TYPE_CHECKING, Any

import carom
from carom.checks import refuse
from carom.errors import InvalidArgument, SweepError
from carom.study.sweeps.batches import batches, ends
from carom.study.sweeps.grid import SEED, Run
from carom.study.sweeps.references import function_of, source_text
from carom.study.sweeps.sources import Source
from carom.study.sweeps.values import NotPlain, name_of, plain, text_of

if TYPE_CHECKING:
    from carom.world import Hits, World

#: Columns of a table that a measure cannot be called.
COLUMNS = ("run", SEED, "digest", "seconds")


class Nonsense(InvalidArgument):
    """A measure returned what no table can hold."""


@dataclass(frozen=True, slots=True)
class Row:
    """What came of one run.

    Attributes:
        run: Its id.
        measures: What was measured, as JSON in the measure's own order; None where it failed.
        digest: That of the world at its end, likewise.
        error: Why it failed, or None.
        seconds: How long the work took.
        nonsense: Whether it failed for what the measure returned.
    """

    run: str
    measures: str | None
    digest: str | None
    error: str | None
    seconds: float
    nonsense: bool = False


@dataclass(frozen=True)
class Job:
    """What is done in every run of a sweep."""

    source: Source
    measure: str
    seconds: float
    dt: float
    version: str

    def ids(self, runs: list[Run]) -> list[str]:
        """The ids of runs: a hash of scene, parameters, seed and version."""
        scene = name_of(self.source.identity)
        return [name_of(scene, run.parameters, run.seed, self.version) for run in runs]

    def plain(self, ids: list[str]) -> dict[str, Any]:
        """What tells this sweep from any other, in words."""
        return {
            "scene": name_of(self.source.identity),
            "measure": self.measure,
            "measure's source": name_of(source_text(self.measure)),
            "seconds": self.seconds,
            "dt": self.dt,
            "version": self.version,
            "runs": len(ids),
            "parameters": name_of(ids),
        }

    def rows(self, named: Sequence[tuple[str, Run]]) -> list[Row]:
        """What comes of runs with their ids, in their order."""
        rows: dict[int, Row] = {}
        for places in batches(self.source, [run for _, run in named]):
            rows.update(zip(places, self._batch([named[place] for place in places]), strict=True))
        return [rows[place] for place in range(len(named))]

    def row(self, name: str, run: Run) -> Row:
        """What comes of the run of id `name`; whatever it raises is told in the row."""
        began = perf_counter()
        try:
            world = self.source.of(run).build()
            hits = world.run(self.seconds, dt=self.dt)
        except (Exception, SystemExit) as error:  # noqa: BLE001  # whatever a user's function may raise
            return _failed(name, error, began)
        return self._measured(name, run, world, hits, began)

    def _batch(self, named: Sequence[tuple[str, Run]]) -> list[Row]:
        """What comes of runs that may be copies of one world."""
        if len(named) == 1:
            return [self.row(*named[0])]
        began, rows = perf_counter(), list[Row]()
        try:
            ended = ends([self.source.of(run) for _, run in named], self.seconds, self.dt)
            for (name, run), end in zip(named, ended, strict=True):
                rows.append(self.row(name, run) if end is None else self._measured(name, run, *end, perf_counter()))
        except Exception:  # noqa: BLE001  # one of them fails: each for itself tells which, and how
            return [self.row(name, run) for name, run in named]
        # The work that was done for all.
        shared = (perf_counter() - began - sum(row.seconds for row in rows)) / len(rows)
        return [replace(row, seconds=row.seconds + shared) for row in rows]

    def _measured(self, name: str, run: Run, world: World, hits: Hits, began: float) -> Row:
        """What is measured of a world at its end; whatever that raises is told in the row."""
        try:
            digest = world.digest()
            measured = checked(function_of(self.measure)(world, hits, dict(run.given)), run)
        except (Exception, SystemExit) as error:  # noqa: BLE001  # whatever a user's function may raise
            return _failed(name, error, began)
        return Row(name, measured, digest, None, perf_counter() - began)


def _failed(name: str, error: BaseException, began: float) -> Row:
    """The row of a run that raised."""
    told = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    told = told.encode("utf-8", "replace").decode()
    return Row(name, None, None, told, perf_counter() - began, isinstance(error, Nonsense))


def checked(measured: Any, run: Run) -> str:
    """What a measure returned, as JSON; raises `Nonsense` where a table cannot hold it."""
    if not isinstance(measured, Mapping):
        raise _nonsense("measure", "must return a dictionary of numbers, strings and small arrays", measured)
    clean: dict[str, Any] = {}
    for name, value in measured.items():
        if not isinstance(name, str) or not name:
            raise _nonsense("measure", "must return names that are strings", name)
        if name in COLUMNS or name in run.parameters:
            raise _nonsense("measure", "must not return the name of another column", name)
        try:
            clean[name] = plain(value)
        except NotPlain as must:
            raise _nonsense(f"measure's {name!r}", f"must be {must}", value) from None
    return text_of(clean, in_order=False)


def _nonsense(name: str, must: str, value: object) -> Nonsense:
    """The error to raise for what a measure returned."""
    return Nonsense(str(refuse(name, must, value)))


@lru_cache(maxsize=4)
def _loaded(packed: bytes) -> Job:
    """The job that was packed, once in a process."""
    job: Job = pickle.loads(packed)
    if job.version != carom.__version__:
        raise SweepError(f"the sweep is carom {job.version}'s, the worker has {carom.__version__}")
    for reference in filter(None, (job.measure, job.source.function)):
        try:
            function_of(reference)
        except Exception as error:  # noqa: BLE001  # whatever a user's module may raise
            raise SweepError(f"the worker cannot import {reference}: {type(error).__name__}: {error}") from None
    return job


def run_chunk(packed: bytes, chunk: list[tuple[str, Run]]) -> tuple[list[Row], str]:
    """The rows of some runs, made in a worker process, and the process: its machine and its number.

    Raises:
        SweepError: The worker is another version's, or cannot import what it is to call.
    """
    # Nobody watches a worker: it waits for the compiler, once on its machine.
    os.environ.setdefault("CAROM_COMPILE", "wait")
    job = _loaded(packed)
    return job.rows(chunk), f"{platform.node()}:{os.getpid()}"
