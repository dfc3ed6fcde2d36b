"""Sweeps: what a run costs besides its work, and what a second worker is worth."""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any

import carom
from benchmarks.common import Figure
from carom import study
from carom.study.measures import by_name
from carom.study.sweeps.chunks import CHUNK_SECONDS
from carom.study.sweeps.grid import Run
from carom.study.sweeps.job import Job
from carom.study.sweeps.sources import source_of

TITLE = f"Sweeps: the clock's time a run, in chunks of {CHUNK_SECONDS:g} s of work"


def swept(folder: Path, runs: int, seconds: float, cluster: Any) -> tuple[float, float]:
    """Seconds that a sweep of a cradle takes by the clock, and the sum of those of its runs."""
    began = perf_counter()
    table = study.sweep(
        "newtons_cradle",
        {"seed": range(runs)},
        measure=study.measures.energy,
        seconds=seconds,
        out=folder,
        cluster=cluster,
        progress=False,
    )
    return perf_counter() - began, sum(table["seconds"].to_pylist())


def together(name: str, runs: int, seconds: float) -> list[Figure]:
    """Milliseconds of the processor for a run of a shipped scene, measure and all: alone, and as one copy of many."""
    job = Job(source_of(name), by_name("hits-by-shape"), seconds, 1 / 60, carom.__version__)
    named = [(str(seed), Run({}, seed)) for seed in range(runs)]
    ways = {"one by one": lambda: [job.row(*one) for one in named], "together": lambda: job.rows(named)}
    job.rows(named[:2])
    job.row(*named[0])
    figures = []
    for engine, work in ways.items():
        began = process_time()
        work()
        each = 1e3 * (process_time() - began) / runs
        figures.append(Figure(f"a run of {name}, {seconds:g} s", engine, each, "ms"))
    return figures


def run(quick: bool) -> list[Figure]:
    """Milliseconds a run beyond its work, in this process and by one worker; runs a second of one worker and two."""
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        sys.stderr.write('sweeps need dask[distributed]: pip install "carom[sweep]"\n')
        return []
    runs, seconds = (20, 0.5) if quick else (3000, 20.0)
    figures = [*together("pool", max(runs // 20, 5), seconds), *together("pinball", max(runs // 20, 5), seconds)]
    rates = {}
    with TemporaryDirectory() as name:
        folder = Path(name)
        swept(folder / "warm", 2, seconds, "serial")
        took, worked = swept(folder / "serial", runs, seconds, "serial")
        figures.append(Figure("besides the work of a run", "this process", 1e3 * (took - worked) / runs, "ms"))
        for workers in (1, 2):
            # Workers read what is compiled from the disk at their first run.
            with (
                LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address="localhost:0") as cluster,
                Client(cluster) as client,
            ):
                swept(folder / f"warm {workers}", 8, seconds, client)
                took, worked = swept(folder / str(workers), runs, seconds, client)
            rates[workers] = runs / took
            if workers == 1:
                figures.append(Figure("besides the work of a run", "one worker", 1e3 * (took - worked) / runs, "ms"))
            remarks = {"of one worker's": f"{rates[workers] / rates[1]:.2f}"}
            figures.append(Figure("runs a second", f"workers: {workers}", rates[workers], "1/s", remarks=remarks))
    return figures
