"""A sweep to which everything happens: its table is that of a sweep to which nothing does.

`--campaign` makes it large: 10,000 runs, 200 workers and 5 coordinators killed, 20 failed or torn writes, 10 runs that
always kill their worker, a full disk.
"""

import json
import random
import sys
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from carom.study.sweeps.chunks import MOST_DEATHS
from tests.dask_cluster import CommandCluster, Coordinators, command_cluster
from tests.sweeping import NAP, QUIET, runs, swept, without_seconds


@dataclass
class Plan:
    """What is to happen in a campaign; how much of it is left."""

    runs: int
    worker_kills: int
    coordinator_kills: int
    faults: list[str]
    deadly: int
    nap: float


def plan(large: bool) -> Plan:
    """The plan of a campaign."""
    kinds = ["failed", "torn"]
    if large:
        return Plan(10_000, 200, 5, [*kinds * 10, "full"], 10, 0.03)
    return Plan(20, 1, 10, [*kinds, "full"], 1, 0.5)


def lines(out: Path) -> list[dict[str, Any]]:
    """The whole lines of a sweep's ledger."""
    ledger = out / "ledger.jsonl"
    text = ledger.read_text() if ledger.exists() else ""
    return [json.loads(line) for line in text.splitlines(keepends=True) if line.endswith("\n")]


def runs_done(out: Path) -> int:
    """The runs of a sweep that its ledger counts."""
    return sum(line["runs"] for line in lines(out))


class Campaign:
    """A campaign against a sweep in the folder `out`, and what has happened in it."""

    def __init__(self, out: Path, cluster: CommandCluster, coordinators: Coordinators, asked: Plan) -> None:
        self.out, self.cluster, self.coordinators, self.plan = out, cluster, coordinators, asked
        self.chance = random.Random(20)
        self.happened: Counter[str] = Counter()
        self._worker_marks = self._marks(asked.worker_kills)
        self._coordinator_marks = self._marks(asked.coordinator_kills)
        self._fault_marks = list(zip(self._marks(len(asked.faults)), asked.faults, strict=True))

    def _marks(self, count: int) -> list[float]:
        """At how many runs done something happens for the last, …, the first time."""
        return sorted((self.chance.uniform(0.0, 0.95) * self.plan.runs for _ in range(count)), reverse=True)

    def run(self) -> None:
        """Call the sweep until it comes to its end."""
        while self._attempt() != 0:
            self.happened["resumes"] += 1
            assert self.happened["resumes"] < 100

    def _attempt(self) -> int:
        """The exit status of one coordinator, with what happens to it and to the workers meanwhile."""
        asked = {"runs": self.plan.runs, "deadly": self.plan.deadly, "cluster": self.cluster.address}
        fault = bool(self._fault_marks) and self._fault_marks[-1][0] <= runs_done(self.out)
        if fault:
            kind = self._fault_marks.pop()[1]
            self.happened[kind] += 1
            asked["fault"] = [kind, self.chance.randrange(1, 4)]
        self.coordinators.start(asked | {"out": str(self.out)})
        while (status := self.coordinators.status(self.chance.uniform(0.0, 0.1))) is None:
            self._strike(runs_done(self.out), fault)
        if status == 1:
            assert "SweepError" in self.coordinators.told()
            assert len(self.coordinators.told().splitlines()) == 1
        return status

    def _strike(self, done: int, fault: bool) -> None:
        """Kill who is due; the coordinator too so that the next one is made with its fault."""
        if self._worker_marks and self._worker_marks[-1] <= done and self.cluster.kill_worker(self.chance):
            self._worker_marks.pop()
            self.happened["workers killed"] += 1
        if self._coordinator_marks and self._coordinator_marks[-1] <= done:
            # One that has just ended was not killed: the next one is.
            if self.coordinators.kill():
                self._coordinator_marks.pop()
                self.happened["coordinators killed"] += 1
        elif self._fault_marks and self._fault_marks[-1][0] <= done and not fault:
            self.happened["coordinators killed for a fault"] += self.coordinators.kill()


@pytest.mark.slow
def test_a_sweep_to_which_everything_happens_is_a_quiet_one_s(
    tmp_path: Path, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = plan(bool(request.config.getoption("--campaign")))
    began = time.monotonic()
    with command_cluster(tmp_path, **{NAP: str(asked.nap)}) as cluster:
        coordinators = Coordinators(tmp_path / "coordinators.log")
        try:
            campaign = Campaign(tmp_path / "out", cluster, coordinators, asked)
            campaign.run()
        finally:
            coordinators.close()
    happened, took = campaign.happened, time.monotonic() - began
    sys.stderr.write(f"\ncampaign of {asked.runs:,} runs in {took:,.0f} s: {dict(happened)}\n")
    monkeypatch.setenv(QUIET, "1")
    quiet = swept(tmp_path / "quiet", runs(asked.runs, asked.deadly))
    table = pq.read_table(tmp_path / "out" / "table.parquet")
    failures = pq.read_table(tmp_path / "out" / "failures.parquet")
    assert without_seconds(table) == without_seconds(quiet)
    assert table.num_rows == asked.runs - asked.deadly
    assert failures["number"].to_pylist() == [row["number"] for row in runs(asked.runs, asked.deadly) if row["deadly"]]
    assert set(failures["error"].to_pylist()) == {f"killed its worker {MOST_DEATHS} times"}
    assert runs_done(tmp_path / "out") == asked.runs
    assert happened["workers killed"] == asked.worker_kills
    assert happened["coordinators killed"] == asked.coordinator_kills
    assert sum(happened[kind] for kind in ("failed", "torn", "full")) == len(asked.faults)
