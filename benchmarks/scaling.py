"""How the cost of a ball grows with their number, in the gas."""

from benchmarks.common import TURN, Figure, race
from benchmarks.engines import engines
from benchmarks.gas import gas

TITLE = "Scaling: the gas, cost of a step per ball"
MOST = {"carom": 1_000_000, "pymunk": 100_000, "Box2D": 100_000}  # the peers' balls are made one by one in Python


def run(quick: bool) -> list[Figure]:
    """Nanoseconds of a step per ball, for more and more balls."""
    counts = (100, 1_000) if quick else (1_000, 10_000, 100_000, 1_000_000)
    return [figure for count in counts for figure in _of(count, turns=1 if quick else max(3, 30_000 // count))]


def _of(count: int, turns: int) -> list[Figure]:
    """The figures of one number of balls."""
    setup = gas(count)
    worlds = {name: make(setup) for name, make in engines().items() if count <= MOST[name]}
    calls = {name: world.step for name, world in worlds.items()}
    race(calls, rounds=1, calls_each=3)
    seconds = race(calls, turns, calls_each=TURN)
    return [Figure(f"{count:,} balls", name, 1e9 * seconds[name] / count, "ns a ball") for name in worlds]
