"""Closed rooms of any make, many balls in them that do not meet each other, and worlds of a few shapes."""

from dataclasses import dataclass, field
from functools import partial
from math import atan2, cos, hypot, pi, sin, sqrt
from random import Random
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import carom
from tests.worlds import continuous_world, guarded

Floats = NDArray[np.float64]
Pair = tuple[float, float]

#: Worlds of one substep a step, without a rest speed.
exact_world = partial(continuous_world, substeps=1, rest_speed=0.0)


def add_loners(world: carom.World, position: ArrayLike, velocity: ArrayLike, radius: ArrayLike) -> None:
    """Add balls that meet shapes but not each other."""
    world.add_balls(position, velocity, radius=radius)
    rows = world._arrays.balls.used
    rows["layer"], rows["collides_with"] = 2, 1


def stadium(half: float, radius: float) -> list[carom.Shape]:
    """Two walls of length 2·half, tangent to two half circles."""
    return [
        carom.Segment((-half, -radius), (half, -radius)),
        carom.Segment((-half, radius), (half, radius)),
        carom.Arc((half, 0.0), radius, 1.5 * pi, 0.5 * pi),
        carom.Arc((-half, 0.0), radius, 0.5 * pi, 1.5 * pi),
    ]


def ring(center: Pair, radius: float, pieces: int) -> list[carom.Shape]:
    """A circle in pieces of equal length."""
    angles = [2.0 * pi * k / pieces for k in range(pieces)]
    return [carom.Arc(center, radius, angles[k - 1], angles[k]) for k in range(pieces)]


@dataclass(frozen=True)
class Bulge:
    """The part of a disc beyond the chord from `start` to `end`, on its right hand where `outward`."""

    start: Pair
    end: Pair
    outward: bool
    center: Pair
    radius: float

    def contains(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Which points lie between chord and arc."""
        (ax, ay), (bx, by) = self.start, self.end
        right = (bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0.0
        inside = (x - self.center[0]) ** 2 + (y - self.center[1]) ** 2 < self.radius**2
        found: NDArray[np.bool_] = inside & (right == self.outward)
        return found

    def arc(self) -> carom.Arc:
        """The wall along it."""
        first, last = (self.start, self.end) if self.outward else (self.end, self.start)
        angles = [atan2(p[1] - self.center[1], p[0] - self.center[0]) for p in (first, last)]
        return carom.Arc(self.center, self.radius, *angles)


@dataclass
class Room:
    """A closed room around the origin, of walls, arcs bent either way, and furniture; `free` is empty around it."""

    corners: list[Pair]
    bulges: list[Bulge]
    shapes: list[carom.Shape]
    free: float
    discs: list[tuple[Pair, float]] = field(default_factory=list)  # into which no ball gets
    bowl: tuple[Pair, float] | None = None  # a hollow circle in the middle of the furniture, with balls inside

    def holds(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Which centres lie inside, and in nothing that they are to stay out of."""
        inside = np.zeros(x.shape, np.bool_)
        for k in range(len(self.corners)):
            (ax, ay), (bx, by) = self.corners[k - 1], self.corners[k]
            spans = (ay > y) != (by > y)
            with np.errstate(divide="ignore", invalid="ignore"):
                inside ^= spans & (x < ax + (bx - ax) * (y - ay) / (by - ay))
        for bulge in self.bulges:
            inside = inside | bulge.contains(x, y) if bulge.outward else inside & ~bulge.contains(x, y)
        for (cx, cy), radius in self.discs:
            inside &= np.hypot(x - cx, y - cy) >= radius
        return inside


def random_room(random: Random, walls: int = 7) -> Room:
    """A room of about 20 across; all its parts are farther than 4 from the origin."""
    step = 2.0 * pi / walls
    angles = [step * (k + random.uniform(-0.25, 0.25)) for k in range(walls)]
    corners = [(r * cos(a), r * sin(a)) for r, a in ((random.uniform(9.0, 14.0), a) for a in angles)]
    shapes: list[carom.Shape] = []
    bulges = []
    for k in range(walls):
        start, end = corners[k - 1], corners[k]
        bend = random.choice(("none", "in", "out", "far out"))
        if bend == "none":
            shapes.append(carom.Segment(start, end))
            continue
        bulges.append(bulge_on(start, end, bend, random))
        shapes.append(bulges[-1].arc())
    room = Room(corners, bulges, shapes, 3.0)
    furnish(room, random)
    room.shapes = guarded(room.shapes)
    return room


def bulge_on(start: Pair, end: Pair, bend: str, random: Random) -> Bulge:
    """An arc over a chord of a room that goes counterclockwise."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    chord = hypot(dx, dy)
    radius = chord * random.uniform(0.51, 0.6) if bend == "far out" else chord * random.uniform(1.2, 3.0)
    height = sqrt(radius * radius - 0.25 * chord * chord)
    # To the right of the chord is out of the room. A far bulge has its centre out there too.
    to_right = height if bend in ("in", "far out") else -height
    center = (
        0.5 * (start[0] + end[0]) + to_right * dy / chord,
        0.5 * (start[1] + end[1]) - to_right * dx / chord,
    )
    return Bulge(start, end, bend != "in", center, radius)


def furnish(room: Room, random: Random) -> None:
    """Put a solid circle, a hollow one that is met from outside, and points around the middle of a room."""
    turn = random.uniform(0.0, 2.0 * pi)
    for number, solid in enumerate((True, False)):
        angle, radius = turn + number * 2.0, random.uniform(0.5, 1.0)
        center = (4.8 * cos(angle), 4.8 * sin(angle))
        room.shapes.append(carom.Circle(center, radius, solid=solid))
        room.discs.append((center, radius))
    room.shapes.append(carom.Point((4.5 * cos(turn + 4.0), 4.5 * sin(turn + 4.0))))


def mixers(random: Random, reach: float, fastest: float) -> list[carom.Shape | carom.Compound]:
    """A paddle, a cup, a cam and a post that turn within `reach` of the origin at up to `fastest` radians a second."""

    def turning() -> dict[str, Any]:
        spin = random.choice((-1.0, 1.0)) * fastest ** random.uniform(0.0, 1.0)
        return {"motion": "kinematic", "pivot": (0.0, 0.0), "angular_velocity": spin}

    bar = guarded([carom.Segment((-0.6 * reach, 0.0), (reach, 0.0))])
    start = random.uniform(0.0, 2.0 * pi)
    cup = guarded([carom.Arc((0.4 * reach, 0.0), 0.6 * reach, start, start + random.uniform(0.5, 5.5))])
    cam = carom.Circle((0.5 * reach, 0.0), 0.5 * reach, solid=True, **turning())
    post = carom.Point((reach, 0.0), **turning())
    chosen = random.choice((0, 1, 2, 3))
    compounds = [carom.Compound(parts, (0.0, 0.0)) for parts in (bar, cup)]
    for compound in compounds:
        compound.angular_velocity = turning()["angular_velocity"]
    return [compounds[0], compounds[1], cam, post][chosen : chosen + 1]


def around(position: Floats, inner: float, outer: float) -> Floats:
    """Places between two distances from the origin in the directions of `position`, for which outer is 1."""
    away = np.hypot(*position.T)[:, None]
    moved: Floats = position / away * (inner + (outer - inner) * away)
    return moved


def launches(
    random: Random, count: int, free: float, radius: float, slowest: float, fastest: float
) -> tuple[Floats, Floats]:
    """Places within `free` of the origin and velocities in all directions, log-uniform, in radii a second."""
    generator = np.random.default_rng(random.getrandbits(64))
    away, angle, heading = (generator.random(count) for _ in range(3))
    place = free * np.sqrt(away)
    speed = radius * np.exp(generator.uniform(np.log(slowest), np.log(fastest), count))
    position = np.column_stack((place * np.cos(2 * pi * angle), place * np.sin(2 * pi * angle)))
    velocity = np.column_stack((speed * np.cos(2 * pi * heading), speed * np.sin(2 * pi * heading)))
    return position, velocity


def steps_apart(value: float, steps: int) -> float:
    """The double so many doubles above, or below, a value."""
    towards = np.inf if steps > 0 else -np.inf
    for _ in range(abs(steps)):
        value = float(np.nextafter(value, towards))
    return value
