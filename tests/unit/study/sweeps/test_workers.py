"""Who does the work: this process, processes on this machine, or a cluster by its address, with the same answers."""

from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

import carom
from carom.study.sweeps.chunks import Chunks
from carom.study.sweeps.grid import runs_of
from carom.study.sweeps.job import Job
from carom.study.sweeps.sources import source_of
from carom.study.sweeps.workers import Sent, check_cluster, cluster_of, serial_answers
from tests import sweeping
from tests.dask_cluster import ROOT
from tests.fresh import run


def test_this_process_answers_all_runs() -> None:
    job = Job(source_of(sweeping.drop), "tests.sweeping:told", 0.1, 1 / 60, carom.__version__)
    runs = runs_of(sweeping.runs(7, raises=1))
    answers = list(serial_answers(Sent(job, runs, job.ids(runs)), Chunks(range(7))))
    assert [row.run for answer in answers for row in answer.rows] == job.ids(runs)
    assert sum(row.error is not None for answer in answers for row in answer.rows) == 1


@pytest.mark.parametrize("given", [3, object(), ["tcp://a"], True])
def test_what_is_no_cluster_is_refused(given: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match="cluster must be None, 'serial', the address of a Dask scheduler"):
        check_cluster(given)


def test_a_scheduler_that_is_not_there_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.study.sweeps.workers.PATIENCE", 0.2)
    for address in ("tcp://127.0.0.1:9", "nothing://here"):
        told = f"cluster {address}: no Dask scheduler answers there"
        with pytest.raises(carom.SweepError, match=told), cluster_of(address, 1):
            pytest.fail("there is none")


PROGRAM = """
import sys, threading
from tests.dask_cluster import workers_of
from tests.sweeping import runs, swept
import os
stop = threading.Event()

def kill():
    while not stop.wait(0.02):
        for worker in workers_of(os.getpid())[:1]:
            if os.path.exists(os.path.join(sys.argv[1], "ledger.jsonl")):
                worker.kill()
                return

threading.Thread(target=kill, daemon=True).start()
table = swept(sys.argv[1], runs(12, raises=1), cluster=None)
stop.set()
"""


@pytest.mark.slow
def test_processes_of_this_machine_give_the_table_of_this_process(tmp_path: Path) -> None:
    """A program without a guard; one of its workers is killed as soon as the first part is written."""
    done = run(PROGRAM, str(tmp_path / "out"), CAROM_COMPILE="off", CAROM_TEST_NAP="0.2", PYTHONPATH=str(ROOT / "src"))
    assert done.stderr.decode() == ""
    assert done.returncode == 0
    quiet = sweeping.swept(tmp_path / "quiet", sweeping.runs(12, raises=1))
    found = pq.read_table(tmp_path / "out" / "table.parquet")
    assert sweeping.without_seconds(found) == sweeping.without_seconds(quiet)
    assert pq.read_table(tmp_path / "out" / "failures.parquet")["error"].to_pylist() == ["RuntimeError: as it was told"]
