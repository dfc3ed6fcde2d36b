"""How the cost of a ball grows with their number, in the gas."""

from benchmarks.bare import bare_engines
from benchmarks.chart import Chart, Curve
from benchmarks.common import TURN, Figure, race
from benchmarks.engines import engines
from benchmarks.gas import gas
from carom.draw.paint.painter import Style

TITLE = "Scaling: the gas, cost of a step per ball"
#: The peers' balls are made one by one in Python.
MOST = {"pymunk": 100_000, "Box2D": 100_000}
#: Rounds of a crowd, and of few balls, which are soon done.
FEWEST_ROUNDS, MOST_ROUNDS = 3, 300

STYLES = {
    "carom": Style("ball-3", width=2.4),
    "pymunk": Style("ball-4", width=1.8),
    "Box2D": Style("ball-2", width=1.8),
    "bare loop, Numba": Style("ball-1", width=1.8, dash=(6.0, 4.0)),
    "bare loop, C": Style("muted", width=1.8, dash=(2.0, 4.0)),
}


def run(quick: bool) -> list[Figure]:
    """Nanoseconds of a step per ball, for more and more balls."""
    powers = range(0, 4, 3) if quick else range(7)
    return [figure for power in powers for figure in _of(10**power, quick)]


def _of(count: int, quick: bool) -> list[Figure]:
    """The figures of one number of balls."""
    setup = gas(count)
    makers = {name: make for name, make in (engines() | bare_engines()).items() if count <= MOST.get(name, count)}
    calls = {name: make(setup).step for name, make in makers.items()}
    race(calls, rounds=1, calls_each=3)
    rounds = 1 if quick else min(max(FEWEST_ROUNDS, 30_000 // count), MOST_ROUNDS)
    timings = race(calls, rounds, calls_each=TURN)
    return [timing.figure(_case(count), name, 1e9 / count, "ns a ball") for name, timing in timings.items()]


def _case(count: int) -> str:
    """The name of so many balls in the table."""
    return f"{count:,} balls" if count > 1 else "1 ball"


def chart(figures: list[Figure]) -> str:
    """The figures as a chart, SVG: both axes by powers of ten."""
    places = {_case(10**power): float(10**power) for power in range(7)}
    curves = [
        Curve(name, style, [(places[figure.workload], figure.value) for figure in figures if figure.engine == name])
        for name, style in STYLES.items()
    ]
    drawn = [curve for curve in curves if curve.points]
    title = "What a step of the gas costs for each ball"
    return Chart(title, "balls", "nanoseconds a ball", across=(0, 6), up=(1, 5, 1)).draw(drawn)
