"""From nothing to the first step and the first picture, in fresh processes: with an empty cache and a filled one."""

import os
import subprocess
import sys
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks import bars
from benchmarks.common import Figure
from benchmarks.engines import CONTINUOUS, engines

TITLE = "Start-up, in fresh processes; those of a first step wait for the compiler"
MODULES = {"carom": "carom", "pymunk": "pymunk", "Box2D": "pyb2d3"}
CLOCK = "from time import perf_counter; began = perf_counter(); {work}; print(perf_counter() - began)"
FIRST_STEP = "engine = engines(True)[{name!r}](gas(100)); began = perf_counter(); engine.step()"

#: What makes a picture, as `carom` does on the command line.
PICTURE = "import sys; from carom.cli import main; sys.argv = ['carom', *sys.argv[1:]]; main()"
#: What the works of the table are called in the chart.
CALLED = {
    "import": "import",
    "first step of a process": "the first step, where kernels were compiled before",
    "first step ever": "the first step ever, which waits for the compiler",
    "first picture": "a picture of 20 s of pinball, where kernels were compiled before",
    "first picture ever": "the first picture ever, which waits for no compiler",
}


def surroundings(cache: str, compile_how: str) -> dict[str, str]:
    """The environment of a process whose compiled code is kept in the folder `cache`, and Python's where it belongs."""
    return {
        **{name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"},
        "CAROM_CACHE_DIR": cache,
        "CAROM_COMPILE": compile_how,
    }


def seconds(work: str, cache: str) -> float:
    """Seconds that `work` takes in a fresh interpreter whose compiled code is kept in the folder `cache`."""
    command = [sys.executable, "-c", CLOCK.format(work=work)]
    finished = subprocess.run(command, env=surroundings(cache, "wait"), capture_output=True, text=True, check=True)
    return float(finished.stdout)


def seconds_of_picture(cache: str) -> float:
    """Seconds from nothing to a picture of a run, by the command line, which does not wait for the compiler."""
    environment = surroundings(cache, "background")
    with TemporaryDirectory() as folder:
        command = [sys.executable, "-c", PICTURE, "run", "pinball", "--seconds", "20", "--out", f"{folder}/pinball.svg"]
        began = perf_counter()
        subprocess.run(command, env=environment, capture_output=True, check=True)
        return perf_counter() - began


def run(quick: bool) -> list[Figure]:
    """Milliseconds of `import`, and seconds of the first step and the first picture."""
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
        if not quick:
            figures.append(Figure("first picture", "carom", seconds_of_picture(cache), "s"))
    with TemporaryDirectory(ignore_cleanup_errors=True) as empty:  # the compiler may be at work there yet
        return [*figures, Figure("first picture ever", "carom", seconds_of_picture(empty), "s")]


def chart(figures: list[Figure]) -> str:
    """How long nothing is there as a chart, SVG."""
    works = []
    for workload, name in CALLED.items():
        found = [figure for figure in figures if figure.workload == workload and figure.engine in bars.STYLES]
        told = [(figure, figure.value * (1e-3 if figure.unit == "ms" else 1.0)) for figure in found]
        works.append(
            bars.Work(
                name, [bars.Bar(one.engine, value, in_words(value), bars.STYLES[one.engine]) for one, value in told]
            )
        )
    return bars.draw("From nothing, in fresh processes", "time", [work for work in works if work.bars], in_words)


def in_words(seconds: float) -> str:
    """A time in seconds or milliseconds, two digits of it."""
    if seconds >= 100.0:
        return f"{seconds:.0f} s"
    return f"{seconds:.2g} s" if seconds >= 0.1 else f"{1e3 * seconds:.2g} ms"
