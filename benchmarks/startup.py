"""From nothing to the first step, in fresh processes: importing, then stepping with an empty cache and a filled one."""

import os
import subprocess
import sys
from statistics import median
from tempfile import TemporaryDirectory

from benchmarks.common import Figure
from benchmarks.engines import CONTINUOUS, engines

TITLE = "Start-up, in fresh processes that wait for the compiler"
MODULES = {"carom": "carom", "pymunk": "pymunk", "Box2D": "pyb2d3"}
CLOCK = "from time import perf_counter; began = perf_counter(); {work}; print(perf_counter() - began)"
FIRST_STEP = "engine = engines(True)[{name!r}](gas(100)); began = perf_counter(); engine.step()"


def seconds(work: str, cache: str) -> float:
    """Seconds that `work` takes in a fresh interpreter whose compiled code is kept in the folder `cache`."""
    environment = {**os.environ, "CAROM_CACHE_DIR": cache, "CAROM_COMPILE": "wait"}
    command = [sys.executable, "-c", CLOCK.format(work=work)]
    finished = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return float(finished.stdout)


def run(quick: bool) -> list[Figure]:
    """Milliseconds of `import`, and seconds of the first step."""
    times = 1 if quick else 7
    names = list(engines())
    ours = ["carom"] if quick else ["carom", CONTINUOUS]  # compiling the continuous mode takes the longest of all
    with TemporaryDirectory() as cache:
        imports = {name: f"import {MODULES[name]}" for name in names} | {"NumPy alone": "import numpy"}
        figures = [
            Figure("import", name, 1e3 * median(seconds(work, cache) for _ in range(times)), "ms")
            for name, work in imports.items()
        ]
        for workload in ("first step ever", "first step of a process"):
            for name in ours if workload == "first step ever" else [*ours, *names[1:]]:
                step = "from benchmarks.engines import engines; from benchmarks.gas import gas; " + FIRST_STEP.format(
                    name=name
                )
                figures.append(Figure(workload, name, seconds(step, cache), "s"))
    return figures
