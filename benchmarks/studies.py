"""Studies of billiards: what a hit costs in each, beside the run of the same orbits alone."""

from collections.abc import Callable

from benchmarks.common import Figure, race
from carom import study
from carom.study.billiards.ensembles import batches
from carom.study.billiards.tables import Table

TITLE = "Studies: orbits of a table, the processor's time for each hit"


def alone(table: Table, orbits: int, hits: int) -> None:
    """Fly the orbits of a study, and look at no hit."""
    for batch in batches(table, table.random_starts(orbits), 1.0):
        batch.run(hits * batch.free_time)


def run(quick: bool) -> list[Figure]:
    """Microseconds a hit of each study, and how many times that of the run alone it is."""
    orbits, hits, rounds = (20, 20, 1) if quick else (1000, 200, 5)
    figures = []
    for name in ("stadium", "sinai", "lorentz"):
        table = study.table(name)
        across = ((0.0, 0.0), (0.5 * table.size, 0.5 * table.size))
        calls: dict[str, Callable[[], object]] = {
            "run": lambda table=table: alone(table, orbits, hits),
            "boundary_map": lambda table=table: study.boundary_map(table, orbits, hits, boundary=False),
            "section": lambda table=table, across=across: study.section(table, across, orbits, hits),
            "lyapunov": lambda table=table: study.lyapunov(table, orbits, hits),
        }
        race(calls, rounds=1)
        timings = race(calls, rounds)
        for called, timing in timings.items():
            figure = timing.figure(name, called, 1e6 / (orbits * hits), "µs a hit")
            figure.remarks["times the run"] = f"{timing.median / timings['run'].median:.2f}"
            figures.append(figure)
    return figures
