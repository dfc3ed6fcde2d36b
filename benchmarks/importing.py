"""Drawings as scenes: how long 100,000 elements take and how much memory, in a process of their own for each."""

import random
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from benchmarks.common import Figure, Timing

TITLE = "Importing: drawings of many elements, the processor's time and the most memory of a process that loads one"

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="2900" height="2900" fill="none" stroke="black">'
KINDS = (
    '<line id="a{0}" x1="{1}" y1="{2}" x2="{3}" y2="{2}"/>',
    '<circle id="a{0}" cx="{1}" cy="{2}" r="2"/>',
    '<path id="a{0}" d="M {1} {2} H {3} "/>',
    '<polyline id="a{0}" points="{1},{2} {3},{2}"/>',
)
LOADING = """
import sys, time
from pathlib import Path
import carom
began = time.process_time()
scene = carom.Scene.load(sys.argv[1])
seconds = time.process_time() - began
status = Path("/proc/self/status")
words = status.read_text().split() if status.exists() else ["VmHWM:", "0"]
print(len(scene.shapes), seconds, int(words[words.index("VmHWM:") + 1]) / 1000)
"""


def plain(number: int, x: int, y: int, _: random.Random) -> str:
    """A line, a circle, a path or a polyline in turn."""
    return KINDS[number % 4].format(number, x, y, x + 5)


def gentle(number: int, x: int, y: int, source: random.Random) -> str:
    """A Bézier curve that goes on to the right, as those of a program that smooths do."""
    a, b, c = (round(source.uniform(-1.5, 1.5), 2) for _ in range(3))
    return f'<path id="a{number}" d="M {x} {y} c {1.5 + a / 3:.2f} {a} {3.5 + b / 3:.2f} {b} 5 {c}"/>'


def wild(number: int, x: int, y: int, source: random.Random) -> str:
    """A Bézier curve whose points are anywhere in a square."""
    places = " ".join(f"{x + source.uniform(0, 8):.2f} {y + source.uniform(0, 8):.2f}" for _ in range(3))
    return f'<path id="a{number}" d="M {x} {y} C {places}"/>'


def optioned(number: int, x: int, y: int, source: random.Random) -> str:
    """A rectangle, which is four walls, with an option that no other has."""
    own = f'data-carom-elasticity="{source.random():.6f}"'
    return f'<rect id="a{number}" x="{x}" y="{y}" width="5" height="{3 + number % 3}" {own}/>'


def a_fifth(number: int, x: int, y: int, source: random.Random) -> str:
    """A plain element, or each fifth time a wild curve."""
    return (wild if number % 5 == 0 else plain)(number, x, y, source)


def drawing(kind: Callable[[int, int, int, random.Random], str], count: int) -> str:
    """The text of a drawing of many elements of a kind."""
    source = random.Random(1)
    elements = [kind(number, 9 * (number % 317), 9 * (number // 317), source) for number in range(count)]
    return "\n".join([HEAD, *elements, "</svg>"])


def run(quick: bool) -> list[Figure]:
    """Seconds of each drawing, with how many shapes there are in the end and the megabytes of the process."""
    count, rounds = (500, 1) if quick else (100_000, 3)
    figures = []
    for kind in (plain, a_fifth, gentle, wild, optioned):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "drawing.svg"
            path.write_text(drawing(kind, count), encoding="utf-8")
            told = [_loaded(path) for _ in range(rounds)]
        workload = f"{count} elements, {kind.__name__.replace('_', ' ')}"
        figure = Timing.of([seconds for _, seconds, _ in told]).figure(workload, "carom", 1.0, "s")
        figure.remarks["shapes"] = f"{told[0][0]:.0f}"
        figure.remarks["MB"] = f"{max(megabytes for _, _, megabytes in told):.0f}"
        figures.append(figure)
    return figures


def _loaded(path: Path) -> tuple[float, float, float]:
    """How many shapes a drawing has, in how many seconds it was read, and the megabytes that the process had."""
    told = subprocess.run([sys.executable, "-c", LOADING, path], capture_output=True, text=True, check=True).stdout
    shapes, seconds, megabytes = map(float, told.split())
    return shapes, seconds, megabytes
