"""How much memory a ball takes: growth of a fresh process as a gas is made and stepped once."""

import subprocess
import sys
from pathlib import Path

from benchmarks.common import Figure
from benchmarks.engines import engines

TITLE = "Memory: growth of a fresh process, gas at rest stepped once"
MEASURE = """
from dataclasses import replace
from pathlib import Path
from benchmarks.engines import engines
from benchmarks.gas import gas
def resident():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096
make = engines()[{name!r}]
small, large = (replace(setup, velocity=0.0 * setup.velocity) for setup in (gas(100), gas({balls})))
make(small).step()
before = resident()
engine = make(large)
engine.step()
print(resident() - before)
"""


def run(quick: bool) -> list[Figure]:
    """Bytes a ball; nothing where the system does not tell a process its size."""
    if not Path("/proc/self/statm").exists():
        return []
    figures = []
    for name in engines():
        balls = 50_000 if quick else 1_000_000 if name == "carom" else 50_000
        program = MEASURE.format(name=name, balls=balls)
        grown = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
        figures.append(Figure("gas at rest", name, int(grown) / balls, "bytes a ball"))
    return figures
