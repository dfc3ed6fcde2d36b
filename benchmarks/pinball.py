"""A pinball table of 150 shapes with one ball, stepped from Python and read back; and stepped inside `run`."""

from functools import partial

import numpy as np

from benchmarks.common import Figure, energy, race
from benchmarks.engines import CONTINUOUS, Carom, Engine, engines
from benchmarks.setup import Floats, Setup

TITLE = "Pinball: 150 shapes, one ball, one substep, stepped and read back"
WIDTH, HEIGHT, DOME_PIECES = 20.0, 42.0, 40
POST_COLUMNS, POST_ROWS = 6, 10
DEFLECTORS = 47
TIME_STEP = 1.0 / 480.0


def outline() -> Floats:
    """A floor, two sides, and a dome of short segments: 43 of them."""
    half = 0.5 * WIDTH
    angle = np.linspace(0.0, np.pi, DOME_PIECES + 1)
    dome = np.column_stack((half + half * np.cos(angle), HEIGHT - half + half * np.sin(angle)))
    corners = np.vstack(((0.0, 0.0), (WIDTH, 0.0), dome, (0.0, 0.0)))
    return np.hstack((corners[:-1], corners[1:]))


def pinball() -> Setup:
    """An outline, 60 posts, 47 deflectors, and a ball thrown up between them."""
    x, y = np.meshgrid(np.arange(POST_COLUMNS), np.arange(POST_ROWS))
    posts = np.column_stack((x.ravel() * 3.0 + 2.0 + y.ravel() % 2, y.ravel() * 3.0 + 4.0, np.full(x.size, 0.3)))
    random = np.random.default_rng(4)
    middle = posts[:DEFLECTORS, :2] + np.array((0.0, 1.5))
    angle = random.uniform(0.0, np.pi, DEFLECTORS)
    along = 0.4 * np.column_stack((np.cos(angle), np.sin(angle)))
    deflectors = np.hstack((middle - along, middle + along))
    return Setup(
        position=np.array([[10.0, 37.0]]),
        velocity=np.array([[21.0, 4.0]]),
        radius=0.5,
        time_step=TIME_STEP,
        segments=np.vstack((outline(), deflectors)),
        circles=posts,
        gravity=(0.0, -10.0),
    )


def run(quick: bool) -> list[Figure]:
    """Microseconds of a step and of reading the ball's position, then of a substep inside `run`."""
    setup = pinball()
    rounds, calls = (5, 20) if quick else (200, 200)
    worlds = {name: make(setup) for name, make in engines(with_continuous=True).items()}
    before = {name: energy(world, setup) for name, world in worlds.items()}
    seconds = race({name: partial(step_and_read, world) for name, world in worlds.items()}, rounds, calls)
    figures = [
        seconds[name].figure("stepped and read", name, 1e6, "µs a step", energy(world, setup) / before[name])
        for name, world in worlds.items()
    ]
    return [*figures, *inside_run(setup, 200 if quick else 20_000)]


def step_and_read(engine: Engine) -> None:
    """Make one step and read where the ball is."""
    engine.step()
    engine.first_ball()


def inside_run(setup: Setup, steps: int) -> list[Figure]:
    """Microseconds of a substep when `run` makes all steps without returning to Python."""
    worlds = {"carom": Carom(setup), CONTINUOUS: Carom(setup, "continuous")}
    before = {name: energy(engine, setup) for name, engine in worlds.items()}

    def run_all(engine: Carom) -> None:
        engine.world.run(steps * setup.time_step, dt=setup.time_step)

    calls = {name: partial(run_all, engine) for name, engine in worlds.items()}
    race(calls, rounds=1)
    seconds = race(calls, rounds=7)
    return [
        seconds[name].figure("inside run", name, 1e6 / steps, "µs a substep", energy(engine, setup) / before[name])
        for name, engine in worlds.items()
    ]
