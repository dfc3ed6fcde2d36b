"""Measure every workload, or some, and print a table of each; nothing is asserted.

Times are the processor's, so other processes on the machine count little; those of start-up are the clock's. A value is
a median; its spread is half of what the middle half of all measurements spans.
"""

import argparse
import os
import platform
import sys
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from types import ModuleType

from rich.console import Console

from benchmarks import (
    aiming,
    continuous,
    door,
    drawing,
    galton,
    gas,
    halves,
    heaps,
    importing,
    memory,
    movers,
    pinball,
    play,
    rl,
    rooms,
    scaling,
    startup,
    studies,
    sweep,
    worlds,
)
from benchmarks.common import Figure, show
from benchmarks.saved import Run, load, save

WORKLOADS: dict[str, ModuleType] = {
    "gas": gas,
    "galton": galton,
    "door": door,
    "pinball": pinball,
    "aiming": aiming,
    "continuous": continuous,
    "heaps": heaps,
    "movers": movers,
    "rooms": rooms,
    "scaling": scaling,
    "halves": halves,
    "drawing": drawing,
    "play": play,
    "startup": startup,
    "memory": memory,
    "studies": studies,
    "importing": importing,
    "sweep": sweep,
    "worlds": worlds,
    "rl": rl,
}

#: What is drawn by --chart, the first that was asked for.
CHARTED: dict[str, Callable[[list[Figure]], str]] = {
    "scaling": scaling.chart,
    "startup": startup.chart,
    "door": door.chart,
}

#: Columns of what is printed to a file or a pipe.
WIDTH = 128


def machine() -> dict[str, str]:
    """What the figures depend on: the machine, and the versions of what was measured."""
    versions = {}
    for package in ("carom", "numba", "numpy", "pymunk", "pyb2d3", "billiards"):
        try:
            versions[package] = version(package)
        except PackageNotFoundError:
            versions[package] = "not installed"
    cores = str(os.cpu_count())
    return {"machine": platform.platform(), "cores": cores, "python": platform.python_version(), **versions}


def main(arguments: list[str]) -> None:
    """Run what the command line asks for."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--quick", action="store_true", help="small and short, to see that it runs; its figures mean little"
    )
    parser.add_argument("--only", choices=WORKLOADS, action="append", metavar="NAME", help=", ".join(WORKLOADS))
    parser.add_argument("--json", type=Path, metavar="FILE", help="save the figures there too")
    parser.add_argument("--compare", type=Path, metavar="FILE", help="print beside them those that were saved there")
    parser.add_argument("--plot", type=Path, metavar="FILE", help="draw what a true arc is worth, as SVG (rooms)")
    parser.add_argument(
        "--chart", type=Path, metavar="FILE", help=f"draw what is measured, as SVG ({', '.join(CHARTED)})"
    )
    asked = parser.parse_args(arguments)
    names = list(dict.fromkeys(asked.only or WORKLOADS))
    charted = [name for name in CHARTED if name in names]
    if asked.chart and (not charted or (asked.only and len(charted) > 1)):
        parser.error("--chart draws what --only scaling measures, or --only startup, or --only door")
    before = None
    if asked.compare:
        try:
            before = load(asked.compare)
        except (OSError, ValueError) as error:
            parser.error(f"--compare: {error}")
    console = Console() if sys.stdout.isatty() else Console(width=WIDTH)
    here = machine()
    console.print(", ".join(f"{name} {value}" for name, value in here.items()), highlight=False)
    if before:
        other = ", ".join(f"{name} {value}" for name, value in before.on.items() if here.get(name) != value)
        console.print(f"compared with: {other or 'the same machine and versions'}", highlight=False)
    measured: dict[str, list[Figure]] = {}
    for name in names:
        measured[name] = WORKLOADS[name].run(asked.quick)
        show(WORKLOADS[name].TITLE, measured[name], console, before.of(name) if before else None)
    if asked.plot:
        asked.plot.write_text(rooms.plot(asked.quick), encoding="utf-8")
    if asked.chart:
        asked.chart.write_text(CHARTED[charted[0]](measured[charted[0]]), encoding="utf-8")
    if asked.json:
        save(asked.json, Run(here, measured))


if __name__ == "__main__":
    main(sys.argv[1:])
