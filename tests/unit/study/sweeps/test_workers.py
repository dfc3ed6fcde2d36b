"""Who does the work: this process, processes on this machine, or a cluster by its address, with the same answers."""

import os
import signal
import subprocess
import sys
import time
from multiprocessing import spawn
from pathlib import Path
from typing import Any

import psutil
import pytest

import carom
from carom.study.sweeps.chunks import Chunks
from carom.study.sweeps.grid import runs_of
from carom.study.sweeps.job import Job
from carom.study.sweeps.sources import source_of
from carom.study.sweeps.workers import Sent, _no_program, check_cluster, cluster_of, serial_answers
from tests import sweeping
from tests.clock import within
from tests.dask_cluster import environment, workers_of


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


@pytest.mark.parametrize("address", ["nowhere", "tcp://", "nothing://here"])
def test_what_is_no_address_is_one_line_at_once(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("distributed.Client", None)
    with pytest.raises(carom.SweepError, match=f"^cluster {address}: no Dask scheduler"), cluster_of(address, 1):
        pytest.fail("there is none")


def test_new_processes_do_not_run_the_program_again(monkeypatch: pytest.MonkeyPatch) -> None:
    main = sys.modules["__main__"]
    monkeypatch.setattr(main, "__file__", "program.py", raising=False)
    monkeypatch.setattr(main, "__spec__", None)
    assert "init_main_from_path" in spawn.get_preparation_data("worker")
    with _no_program():
        assert not {"init_main_from_path", "init_main_from_name"} & set(spawn.get_preparation_data("worker"))
    assert main.__file__ == "program.py"


COMMAND = "from carom.cli import main; main()"


@pytest.mark.slow
def test_processes_of_this_machine_outlive_a_death_and_end_with_ctrl_c_and_the_rest_is_done_elsewhere(
    tmp_path: Path,
) -> None:
    out = tmp_path / "out"
    asked = ["sweep", "tests.sweeping:drop", "--vary", "number=0:40", "--measure", "tests.sweeping:told"]
    process = subprocess.Popen(
        [sys.executable, "-c", COMMAND, *asked, "--seconds", str(sweeping.SECONDS), "--out", str(out)],
        env=environment({sweeping.NAP: "0.5"}),
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        wait_for(out, 1)
        family = psutil.Process(process.pid).children(recursive=True)
        workers_of(process.pid)[0].kill()
        wait_for(out, 2 + len((out / "ledger.jsonl").read_text().splitlines()))
        os.killpg(process.pid, signal.SIGINT)
        told = process.communicate(timeout=60)[1]
    finally:
        process.kill()
    # A library's threads may have a last word of their own when their process ends.
    lines = [line for line in told.splitlines() if line.startswith("carom: ")]
    assert lines == [f"carom: interrupted; {out} keeps what is done, --resume goes on with it"]
    assert "Traceback" not in told
    assert process.returncode == 130
    assert not psutil.wait_procs(family, timeout=10)[1]
    assert (out / "ledger.jsonl").read_bytes().endswith(b"\n")
    rows = [{"number": number} for number in range(40)]
    again = sweeping.swept(out, rows)
    assert sweeping.without_seconds(again) == sweeping.without_seconds(sweeping.swept(tmp_path / "quiet", rows))


def wait_for(out: Path, lines: int) -> None:
    """Wait until a sweep's ledger has so many lines."""
    with within(120):
        while not (out / "ledger.jsonl").exists() or len((out / "ledger.jsonl").read_text().splitlines()) < lines:
            time.sleep(0.02)
