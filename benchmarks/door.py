"""The door from Python: a step of one ball, with a hit and without one, and reading and setting what is in a world."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

import carom
from benchmarks.common import Figure, race
from benchmarks.engines import engines
from benchmarks.setup import Setup

TITLE = "The door from Python: one ball and two walls, one substep"
TIME_STEP = 1.0 / 60.0
RADIUS = 0.5


def corridor(width: float, speed: float) -> Setup:
    """One ball between two walls, across which it flies."""
    walls = [(-5.0, 0.0, 5.0, 0.0), (5.0, width, -5.0, width)]
    return Setup(
        position=np.array([[0.0, 0.5 * width]]),
        velocity=np.array([[0.0, speed]]),
        radius=RADIUS,
        time_step=TIME_STEP,
        segments=np.array(walls),
    )


#: A corridor in which nothing is met for as long as anybody measures, and one in which every step has a hit.
WIDE, NARROW = corridor(1e6, 1.0), corridor(2.0 * RADIUS + 0.2, 0.2 / TIME_STEP)


def stepped(world: Any) -> Callable[[], object]:
    """The engine's own call that makes a step, without what the benchmarks wrap around it."""
    if hasattr(world, "space"):
        return partial(world.space.step, TIME_STEP)
    arguments = (TIME_STEP,) if isinstance(world.world, carom.World) else (TIME_STEP, 1)
    return partial(world.world.step, *arguments)


def read(world: Any) -> Callable[[], object]:
    """Reading the ball's position, as a user would."""
    return partial(type(world).first_ball, world)


def run(quick: bool) -> list[Figure]:
    """Microseconds of a step without and with a hit, and of reading the position; then what only carom is asked for."""
    rounds, calls = (3, 20) if quick else (400, 200)
    wide = {name: make(WIDE) for name, make in engines(with_continuous=True).items()}
    narrow = {name: make(NARROW) for name, make in engines(with_continuous=True).items()}
    works = {
        "a step, no hit": {name: stepped(world) for name, world in wide.items()},
        "a step with a hit": {name: stepped(world) for name, world in narrow.items()},
        "a ball's position": {name: read(world) for name, world in wide.items()},
    }
    figures = []
    for workload, calls_of in works.items():
        race(calls_of, rounds=1, calls_each=10)
        seconds = race(calls_of, rounds, calls)
        figures += [timing.figure(workload, name, 1e6, "µs") for name, timing in seconds.items()]
    return [*figures, *own_figures(rounds, calls)]


def own_figures(rounds: int, calls: int) -> list[Figure]:
    """Microseconds of setting, looking up and going back, in the pinball scene."""
    world = carom.scenes.pinball().build()
    ball = world.balls[0]
    flipper = next(shape for shape in world.shapes if isinstance(shape, carom.Compound))
    world.step(TIME_STEP)
    state = world.snapshot()
    works: dict[str, Callable[[], object]] = {
        "set a ball's velocity": lambda: setattr(ball, "velocity", (0.0, 1.0)),
        "set a flipper's turning": lambda: setattr(flipper, "angular_velocity", 0.0),
        "a shape by its place": lambda: world.shapes[7],
        "restore": lambda: world.restore(state),
    }
    return [
        timing.figure(workload, name, 1e6, "µs")
        for workload, work in works.items()
        for name, timing in race({"carom": work}, max(rounds // 10, 1), calls).items()
    ]
