"""Kinematic shapes: a paddle in each of many rooms, shapes far away, shapes that come and go, and the pinball table."""

from math import sqrt
from statistics import median
from time import process_time

import numpy as np

import carom
from benchmarks.common import TURN, Figure
from benchmarks.engines import CONTINUOUS

TITLE = (
    "Kinematic shapes: a paddle in each room, shapes far away, shapes that come and go, and the shipped pinball table"
)
STEP = 1.0 / 60.0
SIDE = 3.0  # of a room
ROOMS = 2048
FAR = (1, 100, 10_000)
#: How many shapes of one motion there are where one of another comes and goes.
MAPS = {"static": 100_000, "turning": 3000}
ENGINES = {"carom": "discrete", CONTINUOUS: "continuous"}
#: What kinematic shapes do, as options of a segment.
MOTIONS = {
    "static": {},
    "at rest": {"motion": "kinematic"},
    "turning": {"motion": "kinematic", "angular_velocity": 2.0},
    "travelling": {"motion": "kinematic", "velocity": (0.02, 0.01)},
}


def run(quick: bool) -> list[Figure]:
    """Microseconds of a ball's step in its room, and of a step of twenty balls, by what the other shapes do."""
    rooms = 64 if quick else ROOMS
    figures = []
    for engine, detection in ENGINES.items():
        for motion in MOTIONS:
            each = 1e6 * seconds_a_step(rooms_of(motion, rooms, detection), quick) / rooms
            figures.append(Figure(f"{rooms:,} rooms, paddles {motion}", engine, each, "µs a ball and step"))
        for motion in MOTIONS:
            for count in FAR[:2] if quick else FAR:
                each = 1e6 * seconds_a_step(with_far(motion, count, detection), quick)
                figures.append(Figure(f"{count:,} shapes far away, {motion}", engine, each, "µs a step"))
        for motion, others in MAPS.items():
            count = others // 50 if quick else others
            for come in MAPS:
                each = 1e6 * seconds_a_change(map_of(motion, count, detection), come, quick)
                name = f"one {come} comes or goes among {count:,} {motion}"
                figures.append(Figure(name, engine, each, "µs with a step"))
        figures.append(Figure("pinball, one ball, 8 substeps", engine, 1e6 * of_pinball(detection, quick), "µs a step"))
    return figures


def seconds_a_step(world: carom.World, quick: bool) -> float:
    """The processor's seconds of a step, the median of some turns."""
    world.run(2 * STEP, dt=STEP)
    times = []
    for _ in range(2 if quick else 5):
        began = process_time()
        for _ in range(TURN):
            world.step(STEP)
        times.append((process_time() - began) / TURN)
    return median(times)


def seconds_a_change(world: carom.World, motion: str, quick: bool) -> float:
    """The processor's seconds in which a shape comes into a map, or goes, and a step is made, the median of some."""
    times = []
    for _ in range(4 if quick else 30):
        came = paddle(100.0, 100.4, motion)
        for change in (world.add, world.remove):
            began = process_time()
            change(came)
            world.step(STEP)
            times.append(process_time() - began)
    return median(times)


def map_of(motion: str, count: int, detection: str) -> carom.World:
    """A square full of shapes, and a ball that rests."""
    world = carom.World(detection=detection, gravity=(0.0, 0.0))
    across = round(sqrt(count))
    world.add(*(paddle(3.0 * (k % across), 3.0 * (k // across), motion) for k in range(count)))
    world.add(carom.Ball((1.5, 1.5), 0.1))
    world.step(STEP)
    return world


def of_pinball(detection: str, quick: bool) -> float:
    """The processor's seconds of a step of the shipped table inside `run`: a wheel turns, the flippers rest."""
    world = carom.scenes.pinball().build()
    world.detection = detection
    world.remove(*list(world.balls)[1:])
    times = []
    for _ in range(2 if quick else 9):
        began = process_time()
        world.run(200 * STEP, dt=STEP)
        times.append((process_time() - began) / 200)
    return median(times)


def rooms_of(motion: str, rooms: int, detection: str) -> carom.World:
    """Square rooms beside each other, with a paddle and a ball in each."""
    world = carom.World(detection=detection)
    across = round(sqrt(rooms))
    lines = -(-rooms // across)
    width, height = SIDE * across, SIDE * lines
    world.add(*(carom.Segment((SIDE * k, 0.0), (SIDE * k, height)) for k in range(across + 1)))
    world.add(*(carom.Segment((0.0, SIDE * k), (width, SIDE * k)) for k in range(lines + 1)))
    corners = SIDE * np.array([(k % across, k // across) for k in range(rooms)])
    world.add(*(paddle(x + 1.5, y + 1.5, motion) for x, y in corners.tolist()))
    angle = np.random.default_rng(1).uniform(0.0, 2.0 * np.pi, rooms)
    velocity = 2.0 * np.column_stack((np.cos(angle), np.sin(angle)))
    world.add_balls(corners + 0.4, velocity, radius=0.2)
    return world


def with_far(motion: str, count: int, detection: str) -> carom.World:
    """A room with twenty balls, and shapes far from it."""
    world = carom.World(detection=detection)
    corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]
    world.add(*(carom.Segment(corners[k - 1], corners[k]) for k in range(4)))
    world.add(*(paddle(100.0 + 3.0 * (k % 100), 100.0 + 3.0 * (k // 100), motion) for k in range(count)))
    places = [(1.0 + 2.0 * (k % 5), 1.0 + 2.0 * (k // 5)) for k in range(20)]
    angle = np.random.default_rng(1).uniform(0.0, 2.0 * np.pi, 20)
    world.add_balls(places, 3.0 * np.column_stack((np.cos(angle), np.sin(angle))), radius=0.3)
    return world


def paddle(x: float, y: float, motion: str) -> carom.Segment:
    """A segment about (x, y)."""
    return carom.Segment((x - 0.5, y), (x + 0.5, y), **MOTIONS[motion])
