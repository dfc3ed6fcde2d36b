"""Measure every workload, or some, and print a table of each; nothing is asserted.

Times are the processor's, so other processes on the machine count little; those of start-up are the clock's.
"""

import argparse
import json
import os
import platform
import sys
from dataclasses import asdict
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
    heaps,
    memory,
    movers,
    pinball,
    play,
    rooms,
    scaling,
    startup,
    sweep,
)
from benchmarks.common import Figure, show

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
    "drawing": drawing,
    "play": play,
    "startup": startup,
    "memory": memory,
    "sweep": sweep,
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
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there too")
    parser.add_argument("--plot", type=Path, metavar="FILE", help="draw what a true arc is worth, as SVG (rooms)")
    asked = parser.parse_args(arguments)
    console = Console() if sys.stdout.isatty() else Console(width=WIDTH)
    console.print(", ".join(f"{name} {value}" for name, value in machine().items()), highlight=False)
    measured: dict[str, list[Figure]] = {}
    for name in asked.only or WORKLOADS:
        measured[name] = WORKLOADS[name].run(asked.quick)
        show(WORKLOADS[name].TITLE, measured[name], console)
    if asked.plot:
        asked.plot.write_text(rooms.plot(asked.quick), encoding="utf-8")
    if asked.json:
        figures = {name: [asdict(figure) for figure in found] for name, found in measured.items()}
        asked.json.write_text(json.dumps({"on": machine(), "figures": figures}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
