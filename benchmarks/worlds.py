"""Many copies of a pinball table in one call, beside worlds that are stepped in turn from Python."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import ceil, sqrt
from typing import Any

import numpy as np

import carom
from benchmarks.common import Figure, race
from benchmarks.engines import Carom, engines
from benchmarks.pinball import HEIGHT, WIDTH, pinball
from benchmarks.setup import Floats, Setup

TITLE = "Many worlds: pinball tables of 150 shapes and one ball, 8 substeps a step, one thread"
SUBSTEPS = 8
TIME_STEP = 1.0 / 60.0
#: Worlds that are stepped in turn.
IN_TURN = 64
#: Copies that are stepped between two looks at the clock, at least.
CALLS = 4096
UNIT = "µs a table-substep"


def run(quick: bool) -> list[Figure]:
    """Microseconds of the processor of a substep of one table: copies, worlds in turn, and copies with flippers."""
    rounds, sizes = (2, (1, 4)) if quick else (20, (1, 64, 1024, 16_384, 65_536))
    figures = []
    for detection in ("discrete", "continuous"):
        tables = {size: copies_of(table(detection), size) for size in sizes}
        calls = {f"{size:,} copies": partial(worlds.step, TIME_STEP) for size, worlds in tables.items()}
        figures += figures_of(f"{detection}, in one call", calls, list(sizes), rounds, list(tables.values()))
    figures += in_turn(rounds, 2 if quick else IN_TURN)
    for detection in ("discrete", "continuous"):
        figures += with_flippers(detection, rounds, sizes[-2])
    return figures


def table(detection: str) -> carom.World:
    """The table of the benchmark of one ball, with as many substeps as the games have."""
    world = Carom(pinball(), detection).world
    world.substeps = SUBSTEPS
    return world


def copies_of(world: carom.World, size: int) -> Any:
    """So many copies, whose balls fly in different directions and have done so for a while."""
    worlds = carom.Worlds(world, size, threads=1, keep_hits=False)
    angle = np.random.default_rng(1).uniform(0.0, 2.0 * np.pi, size)
    worlds.balls.velocity[:, 0] = 21.0 * np.column_stack((np.cos(angle), np.sin(angle)))
    worlds.run(1.0, TIME_STEP)
    return worlds


def figures_of(
    workload: str, calls: dict[str, Callable[[], object]], sizes: list[int], rounds: int, tables: list[Any]
) -> list[Figure]:
    """Times of calls that step so many tables each, and what a copy takes in memory."""
    # A small batch is stepped again and again, as its users do: else the large ones have emptied the caches before it.
    timings = {
        name: race({name: call}, rounds, max(1, CALLS // size))[name]
        for (name, call), size in zip(calls.items(), sizes, strict=True)
    }
    return [
        replace(
            timings[name].figure(workload, name, 1e6 / size / SUBSTEPS, UNIT),
            remarks={"bytes a copy": str(bytes_of(many))},
        )
        for name, size, many in zip(calls, sizes, tables, strict=True)
    ]


def bytes_of(worlds: Any) -> int:
    """What one more copy takes."""
    return int(worlds._common.memory.words.shape[1]) * 8


def in_turn(rounds: int, count: int) -> list[Figure]:
    """Worlds stepped one after the other from Python, carom's and the peers'; and Box2D's with all tables in one."""

    def step_all(worlds: list[Any], steps: int) -> None:
        for world in worlds:
            for _ in range(steps):
                world.step()

    calls: dict[str, Callable[[], object]] = {}
    for name, make in engines(with_continuous=True).items():
        worlds = [make(pinball()) for _ in range(count)]
        if name.startswith("carom"):
            for engine in worlds:
                engine.world.substeps, engine.time_step = SUBSTEPS, TIME_STEP  # type: ignore[attr-defined]
        calls[name] = partial(step_all, worlds, 1 if name.startswith("carom") else SUBSTEPS)
    race(calls, rounds=1)
    timings = race(calls, max(2, rounds // 4))
    figures = [
        timing.figure(f"{count} worlds in turn", name, 1e6 / count / SUBSTEPS, UNIT) for name, timing in timings.items()
    ]
    box2d = engines().get("Box2D")
    if box2d is None:
        return figures
    merged = box2d(merge(pinball(), count))
    (timing,) = race({"Box2D": partial(step_all, [merged], SUBSTEPS)}, max(2, rounds // 4)).values()
    return [*figures, timing.figure(f"{count} tables in one world", "Box2D", 1e6 / count / SUBSTEPS, UNIT)]


def merge(setup: Setup, count: int) -> Setup:
    """Many of the same table side by side in one world, as who has but a few worlds does."""
    columns = ceil(sqrt(count))
    places = np.array([(k % columns, k // columns) for k in range(count)]) * (2.0 * WIDTH, 2.0 * HEIGHT)

    def beside(rows: Floats, corners: int) -> Floats:
        """Rows that begin with so many corners, for each table."""
        way = np.zeros((count, 1, rows.shape[1]))
        way[:, 0, : 2 * corners] = np.tile(places, corners)
        return (rows + way).reshape(-1, rows.shape[1])

    return replace(
        setup,
        position=beside(setup.position, 1),
        velocity=np.tile(setup.velocity, (count, 1)),
        segments=beside(setup.segments, 2),
        circles=beside(setup.circles, 1),
    )


def with_flippers(detection: str, rounds: int, size: int) -> list[Figure]:
    """The shipped pinball table with one ball, all flippers commanded anew in every step; and what `reset` takes."""
    world = carom.scenes.pinball().build()
    world.detection = detection
    world.remove(*list(world.balls)[1:])
    worlds = copies_of(world, size)
    random = np.random.default_rng(2)
    flippers = [worlds.shapes[name] for name in ("left flipper", "right flipper")]

    def step() -> None:
        for flipper in flippers:
            flipper.angular_velocity = random.choice((-20.0, 20.0), size)
        worlds.step(TIME_STEP)

    half = np.arange(size) % 2 == 0
    calls: dict[str, Callable[[], object]] = {"a step": step, "reset of half": partial(worlds.reset, half)}
    return figures_of(f"shipped table, flippers moving, {detection}", calls, [size, size], rounds, [worlds, worlds])
