"""The door from Python: a step of one ball, with a hit and without one, and reading and setting what is in a world."""

from collections.abc import Callable
from functools import partial
from time import process_time
from typing import Any

import numpy as np

import carom
from benchmarks import bars
from benchmarks.common import Figure, race
from benchmarks.engines import engines
from benchmarks.setup import Setup
from carom import outlines

TITLE = "The door from Python: one ball and two walls, one substep"
TIME_STEP = 1.0 / 60.0
RADIUS = 0.5


#: The works of which there is a chart: those that the peers can do too.
SHARED = ("a step, no hit", "a step with a hit", "a ball's position")


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
    return [*figures, *own_figures(rounds, calls), *map_figures(quick)]


def map_figures(quick: bool) -> list[Figure]:
    """Microseconds of changing a map of 16,000 pieces, four sides and four corners a brick, with the next step."""
    world = carom.World(detection="discrete")
    world.add(*outlines.rectangle(-10, -10, 170, 100))
    world.add(carom.Ball((-5, -5), 0.2, velocity=(3, 1)))
    corners = [(3.0 * (k % 50), 2.0 * (k // 50)) for k in range(100 if quick else 2000)]
    bricks = [carom.Group(outlines.rectangle(x, y, x + 2, y + 1)) for x, y in corners]
    began = process_time()
    world.add(*bricks)
    figures = [Figure("a brick of many is added", "carom", 1e6 * (process_time() - began) / len(bricks), "µs")]
    world.step(TIME_STEP)
    turns = iter(range(1, 10**9))

    def changed(change: Callable[[carom.Group, int], object]) -> Callable[[], object]:
        def work() -> None:
            turn = next(turns)
            change(bricks[7 * turn % len(bricks)], turn)
            world.step(TIME_STEP)

        return work

    def come_or_go(brick: carom.Group, _turn: int) -> None:
        (world.remove if brick.world is world else world.add)(brick)

    works = {
        "a step in a map": changed(lambda _brick, _turn: None),
        "a brick is removed, or added, and a step": changed(come_or_go),
        "a wall is switched, and a step": changed(
            lambda brick, turn: setattr(brick.shapes[1], "can_collide", turn % 2 == 0)
        ),
        "a wall is moved, and a step": changed(
            lambda brick, turn: setattr(brick.shapes[1], "position", (1.0 + turn % 90, 2.0 + turn % 70))
        ),
    }
    for workload, work in works.items():
        timings = race({"carom": work}, 3 if quick else 60)
        figures += [timing.figure(workload, name, 1e6, "µs") for name, timing in timings.items()]
    return figures


def own_figures(rounds: int, calls: int) -> list[Figure]:
    """Microseconds of setting, looking up and going back, in the pinball scene."""
    world = carom.scenes.pinball().build()
    world.detection = "discrete"
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


def chart(figures: list[Figure]) -> str:
    """What one ball costs from Python as a chart, SVG."""
    works = [
        bars.Work(
            name,
            [
                bars.Bar(figure.engine, figure.value, f"{figure.value:.2f}", bars.STYLES[figure.engine])
                for figure in figures
                if figure.workload == name and figure.engine in bars.STYLES
            ],
        )
        for name in SHARED
    ]
    return bars.draw("One ball and two walls, from Python", "microseconds", works)
