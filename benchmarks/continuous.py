"""The continuous mode: impacts a second of a billiard ball, long flights, the first example of python-billiards."""

import importlib.util
from dataclasses import replace
from functools import partial
from math import pi
from statistics import median
from time import process_time

import carom
from benchmarks.common import Figure, race
from benchmarks.engines import CONTINUOUS, continuous
from benchmarks.gas import gas

TITLE = "Continuous mode: impacts inside run, long flights, and the first example of python-billiards"
STEP = 120.0  # seconds: the ball meets a wall about 114 times in it


def run(quick: bool) -> list[Figure]:
    """Microseconds an impact, a step of balls that fly far, and seconds of Galperin's billiard."""
    thin = [in_thin_gas(500 if quick else 10_000, filled) for filled in (1e-2, 1e-4, 1e-6)]
    return [in_the_stadium(20 if quick else 100), *thin, far_away(1e7), far_away(1e12), *galperin(3 if quick else 5)]


def in_the_stadium(steps: int) -> Figure:
    """Microseconds an impact of one ball in the stadium, in steps with a hundred impacts and more."""
    scene = carom.scenes.stadium()
    world = scene.model_copy(update={"balls": scene.balls[:1]}).build()
    world.run(STEP, dt=STEP)
    times, counts = [], []
    for _ in range(9 if steps < 100 else 99):
        began = process_time()
        counts.append(len(world.run(steps * STEP, dt=STEP)))
        times.append((process_time() - began) / counts[-1])
    each = median(times)
    remarks = {"impacts a second": f"{1.0 / each:,.0f}", "impacts a step": f"{median(counts) / steps:.0f}"}
    return Figure("stadium, one ball, inside run", CONTINUOUS, 1e6 * each, "µs an impact", None, remarks)


def in_thin_gas(balls: int, filled: float) -> Figure:
    """Milliseconds of a step, in which a ball flies ten radii, once the cells are fitted to the gas."""
    setup = gas(balls, filled)
    step = continuous(replace(setup, velocity=40.0 * setup.velocity)).step
    race({"": step}, rounds=1, calls_each=200)
    return race({"": step}, rounds=100)[""].figure(f"{balls:,} balls, {filled:g} filled", CONTINUOUS, 1e3, "ms a step")


def far_away(speed: float) -> Figure:
    """Microseconds of a step of 1/60 s of a ball that flies off from seven others at so many radii a second."""
    world = carom.World()
    world.add(carom.Ball((-3, 0), 1, velocity=(-speed, 0)), *[carom.Ball((3 * k, 0), 1) for k in range(7)])
    seconds = race({"": partial(world.step, 1 / 60)}, rounds=100)[""]
    return seconds.figure(f"one of eight balls at {speed:g} radii a second", CONTINUOUS, 1e6, "µs a step")


def galperin(digits: int) -> list[Figure]:
    """Seconds until a ball of 100^digits times the other's mass has driven it against a wall π·10^digits times."""
    takes = {"carom": by_carom, "python-billiards": by_billiards}
    if not importlib.util.find_spec("billiards"):
        del takes["python-billiards"]
    expected = int(pi * 10**digits)
    figures = []
    for name, count in takes.items():
        began = process_time()
        counted = count(digits)
        seconds = process_time() - began
        remarks = {"impacts a second": f"{counted / seconds:,.0f}", "counted": f"{counted:,} of {expected:,}"}
        figures.append(Figure(f"{expected:,} impacts of two balls and a wall", name, seconds, "s", None, remarks))
    return figures


def by_carom(digits: int) -> int:
    """The impacts that carom counts, in 16 steps of a second."""
    world = carom.World(detection="continuous", substeps=1, max_impacts=1_000_000)
    world.add(carom.Segment((0, -1), (0, 1)))
    world.add(carom.Ball((3, 0), radius=0.2))
    world.add(carom.Ball((6, 0), radius=1.0, velocity=(-1, 0), mass=100.0**digits))
    return len(world.run(16.0, dt=1.0))


def by_billiards(digits: int) -> int:
    """The impacts that python-billiards counts."""
    import billiards

    billiard = billiards.Billiard([billiards.InfiniteWall((0, -1), (0, 1), inside="right")])
    billiard.add_ball((3, 0), (0, 0), radius=0.2, mass=1)
    billiard.add_ball((6, 0), (-1, 0), radius=1, mass=100**digits)
    return len(billiard.evolve(16))
