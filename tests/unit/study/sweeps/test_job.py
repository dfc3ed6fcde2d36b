"""What a worker does: rows of measures and digests, errors as rows."""

import json
import pickle
from dataclasses import replace
from typing import Any

import pytest

import carom
from carom.study.sweeps import job as job_module
from carom.study.sweeps.grid import Run
from carom.study.sweeps.job import Job, Nonsense, checked, run_chunk
from carom.study.sweeps.sources import source_of
from tests import sweeping

JOB = Job(source_of(sweeping.drop), "tests.sweeping:told", 0.1, 1 / 60, carom.__version__)


def test_a_row_is_what_the_world_alone_gives() -> None:
    row = JOB.row("a", Run({"number": 3}, None))
    world = sweeping.drop({"number": 3}).build()
    hits = world.run(0.1)
    assert row.measures == json.dumps(sweeping.told(world, hits, {}), default=list, separators=(",", ":"))
    assert (row.run, row.digest, row.error, row.nonsense) == ("a", world.digest(), None, False)
    assert len(hits) > 0
    assert row.seconds > 0.0


def test_whatever_is_raised_is_told_in_the_row() -> None:
    row = JOB.row("a", Run({"raises": True}, None))
    assert (row.error, row.measures, row.digest) == ("RuntimeError: as it was told", None, None)
    assert "friction: must not be negative" in str(JOB.row("a", Run({"world.friction": -1.0}, None)).error)
    leaving = replace(JOB, measure="sys:exit")
    assert str(leaving.row("a", Run({}, None)).error).startswith("TypeError")


def test_what_no_table_can_hold_is_nonsense() -> None:
    row = replace(JOB, measure="tests.sweeping:nonsense").row("a", Run({}, None))
    assert row.nonsense
    assert str(row.error).startswith("Nonsense: measure's 'world' must be a number, a string")


@pytest.mark.parametrize(
    ("measured", "words"),
    [
        (None, "measure must return a dictionary of numbers, strings and small arrays, not None"),
        ([1], "must return a dictionary"),
        ({1: 2}, "must return names that are strings, not 1"),
        ({"": 2}, "must return names that are strings"),
        ({"seed": 2}, "must not return the name of another column, not 'seed'"),
        ({"number": 2}, "must not return the name of another column, not 'number'"),
        ({"a": {}}, "measure's 'a' must be a number, a string"),
        ({"a": 2**70}, "measure's 'a' must be a whole number that 64 bits can hold"),
    ],
)
def test_measures_are_checked(measured: Any, words: str) -> None:
    with pytest.raises(Nonsense, match=words):
        checked(measured, Run({"number": 1}, 2))


def test_the_order_of_names_is_the_measure_s() -> None:
    assert checked({"b": 1, "a": 2}, Run({}, None)) == '{"b":1,"a":2}'


def test_ids_tell_runs_apart_by_all_that_matters() -> None:
    runs = [Run({"number": 1}, None), Run({"number": 1}, 0), Run({"number": 2}, 0), Run({"number": 1.0}, 0)]
    found = JOB.ids(runs)
    other_scene = replace(JOB, source=source_of("gas")).ids(runs)
    other_version = replace(JOB, version="0").ids(runs)
    assert len({*found, *other_scene, *other_version}) == 12
    assert JOB.ids(runs) == found


def test_sweeps_differ_in_all_that_matters() -> None:
    others = [replace(JOB, seconds=0.2), replace(JOB, dt=0.1), replace(JOB, measure="tests.sweeping:nonsense")]
    assert len({str(job.plain(["a"])) for job in (JOB, *others)}) == 4
    assert JOB.plain(["a"]) != JOB.plain(["b"])


def test_a_chunk_is_run_by_whoever_has_the_packed_job() -> None:
    rows, worker = run_chunk(pickle.dumps(JOB), [("a", Run({}, None)), ("b", Run({"raises": True}, None))])
    assert [row.run for row in rows] == ["a", "b"]
    assert [row.error is None for row in rows] == [True, False]
    assert ":" in worker


@pytest.mark.parametrize(
    ("job", "words"),
    [
        (replace(JOB, version="0.0"), "the sweep is carom 0.0's, the worker has"),
        (replace(JOB, measure="no.such:f"), "the worker cannot import no.such:f: ModuleNotFoundError"),
    ],
)
def test_a_worker_that_cannot_says_so(job: Job, words: str) -> None:
    job_module._loaded.cache_clear()
    with pytest.raises(carom.SweepError, match=words):
        run_chunk(pickle.dumps(job), [("a", Run({}, None))])
