"""Drawing: frames of a recorded run as pixels, 100 balls among 150 shapes, and what a recording costs."""

from math import cos, pi, sin
from random import Random
from statistics import median
from time import process_time

import carom
from benchmarks.common import Figure
from carom import draw
from carom.draw import Layer

TITLE = "Drawing: 100 balls and 150 shapes to pixels, a picture of 1204 by 960"
SIDE = 40.0
PEGS, PADDLES, BALLS = 134, 12, 100


def room() -> carom.World:
    """A room of 150 shapes, 12 of them turning, and 100 elastic balls that go in all directions."""
    random = Random(1)
    world = carom.World(detection="discrete", substeps=2, iterations=2)
    corners = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)]
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        world.add(carom.Segment(start, end, name="wall"))
    places = [(2.5 + 3.2 * (k % 12), 2.5 + 3.2 * (k // 12)) for k in range(144)]
    random.shuffle(places)
    for number in range(PEGS):
        x, y = places[number]
        if number % 3:
            world.add(carom.Circle((x, y), 0.5, solid=True, elasticity=1.0 + 0.2 * (number % 2)))
        else:
            world.add(carom.Arc((x, y), 0.8, 0.3 * number, 0.3 * number + 2.0))
    for number in range(PADDLES):
        x, y = 5.0 + 2.6 * number, 20.9
        world.add(carom.Segment((x, y), (x + 1.2, y), motion="kinematic", pivot=(x, y), angular_velocity=2.0))
    for number in range(BALLS):
        angle = 2.0 * pi * number / BALLS
        place = 0.9 + 3.2 * (number % 12), 0.9 + 3.2 * (number // 12)
        world.add(carom.Ball(place, 0.3, velocity=(8.0 * cos(angle), 8.0 * sin(angle))))
    return world


def milliseconds(film: draw.Film) -> float:
    """Median milliseconds of the processor for a frame, after all frames have been drawn once."""
    spent = []
    for take in range(2):
        for frame in range(len(film.recording)):
            began = process_time()
            film.frame(frame)
            if take:
                spent.append(process_time() - began)
    return 1e3 * median(spent)


def steps(recorded: bool, count: int) -> float:
    """Median microseconds of the processor for a step, with or without noting it."""
    world = room()
    recorder = carom.Recorder(world)
    world.step(1 / 60)
    spent = []
    for _ in range(count):
        began = process_time()
        hits = world.step(1 / 60)
        if recorded:
            recorder.note(hits)
        spent.append(process_time() - began)
    return 1e6 * median(spent)


def thrown() -> carom.Recording:
    """The four seconds of a lesson: a ball that is thrown into a room."""
    world = carom.World(gravity=(0, -9.8), detection="continuous")
    world.add(*carom.outlines.rectangle(0, 0, 14, 7, elasticity=0.8))
    world.add(carom.Ball((0.2, 0.2), radius=0.2, velocity=(7.0, 7.0)))
    return carom.Recording.of(world, 4.0)


def lesson(count: int) -> tuple[float, float]:
    """Median milliseconds of the processor to throw a ball anew and draw its way, and to draw another frame as text."""
    thrown()
    anew, another = [], []
    for frame in range(count):
        began = process_time()
        recording = thrown()
        draw.svg(draw.picture_at(recording))
        recorded = process_time()
        draw.svg(draw.picture_at(recording, frame))
        anew.append(recorded - began)
        another.append(process_time() - recorded)
    return 1e3 * median(anew), 1e3 * median(another)


def run(quick: bool) -> list[Figure]:
    """Milliseconds of a frame by what it shows, and microseconds of a step with and without recording it."""
    recording = carom.Recording.of(room(), 0.5 if quick else 5.0, name="Room")
    shown = {
        "shapes and balls": {Layer.SHAPES, Layer.BALLS},
        "as by default: tracks and hits too": draw.DEFAULT_LAYERS,
        "all layers": set(Layer),
    }
    figures = [
        Figure(f"a frame, {name}", "carom", milliseconds(draw.Film(recording, layers=layers)), "ms")
        for name, layers in shown.items()
    ]
    count = 30 if quick else 300
    figures += [Figure("a step", "carom", steps(False, count), "µs")]
    figures += [Figure("a step, and noting it for a recording", "carom", steps(True, count), "µs")]
    anew, another = lesson(10 if quick else 100)
    figures += [Figure("a lesson: a ball thrown anew for 4 s, and its way drawn", "carom", anew, "ms")]
    return [*figures, Figure("a lesson: another frame of it drawn", "carom", another, "ms")]
