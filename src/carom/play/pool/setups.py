"""Positions to begin with: random ones, each with a shot that has been tried and wins."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, radians

import numpy as np

import carom
from carom.play.pool.game import FIRST, SHAPES, Phase, Pool, Setup, Vector
from carom.play.pool.preview import Preview, preview, reaches, scratch

#: cm: balls of a random position lie at least so far from the cushions, and from each other.
FROM_CUSHIONS, APART = 14.0, 35.0

#: The thinnest cut that a position asks for.
THINNEST = cos(radians(50.0))

#: Powers that are tried for each line.
POWERS = (0.5, 0.65, 0.4, 0.8)

#: Steps after which a trial is given up; balls lie still long before.
TRIAL_STEPS = 6_000


@dataclass(frozen=True, slots=True)
class Shot:
    """A shot that would pot the eight: its direction, the pocket, and the cosine of the angle at which it is cut."""

    direction: Vector
    pocket: str
    fullness: float


def lines(pool: Pool) -> list[Shot]:
    """The straight shots that send the eight into a pocket from where the balls lie, the fullest first."""
    found = []
    (cue_x, cue_y), (x, y), reach = pool.cue.position, pool.eight.position, pool.cue.radius + pool.eight.radius
    for sensor in pool.world.shapes:
        if not (sensor.sensor and isinstance(sensor, carom.Circle)):
            continue
        way_x, way_y = _unit(sensor.center[0] - x, sensor.center[1] - y)
        free = pool.world.circle_cast((x, y), pool.eight.radius, sensor.center, collides_with=SHAPES, sensors=True)
        direction = (x - reach * way_x - cue_x, y - reach * way_y - cue_y)
        along = _unit(*direction)
        fullness = along[0] * way_x + along[1] * way_y
        if free is None or free.shape is not sensor or fullness < THINNEST:
            continue
        aim = pool.world.aim(pool.cue, direction)
        if aim is not None and aim.shape is pool.eight:
            found.append(Shot(along, sensor.name or "", fullness))
    return sorted(found, key=lambda shot: -shot.fullness)


def wins(pool: Pool, direction: Vector, power: float) -> bool:
    """Whether a shot would win at once. It is tried in the game's own world, which is as before afterwards."""
    with pool.trial():
        pool.shoot(direction, power)
        for _ in range(TRIAL_STEPS):
            pool.step()
            if not pool.moving or pool.over:
                break
        return pool.phase is Phase.WON


def winning(pool: Pool) -> tuple[Shot, float] | None:
    """A shot and a power that win from where the balls lie, or None if none of those tried does."""
    for shot in lines(pool):
        shown = preview(pool, shot.direction)
        for power in POWERS:
            if shown is not None and is_promising(pool, shown, power) and wins(pool, shot.direction, power):
                return shot, power
    return None


def is_promising(pool: Pool, shown: Preview, power: float) -> bool:
    """Whether the eight gets to a pocket, and the cue ball to none before its second impact."""
    eight = shown.eight
    if eight is None or eight.pocket is None or scratch(pool, shown, power) is not None:
        return False
    return reaches(pool, shown, eight, shown.aim.other_speed, power)


def setup(pool: Pool, number: int, seed: int = 0) -> Setup:
    """Where the balls lie in position `number`: the first one for 0, else a random one that has a winning shot.

    The game is left with the balls in that position.
    """
    if number == 0:
        pool.place(FIRST)
        return FIRST
    random = np.random.default_rng((seed, number))
    width, height = pool.cloth
    while True:
        cue, eight = (_place(random, width, height) for _ in range(2))
        if hypot(cue[0] - eight[0], cue[1] - eight[1]) < APART:
            continue
        pool.place(Setup(cue, eight))
        if winning(pool) is not None:
            return pool.setup


def _place(random: np.random.Generator, width: float, height: float) -> Vector:
    """A random place on the cloth, on a grid of millimetres."""
    x = random.uniform(FROM_CUSHIONS, width - FROM_CUSHIONS)
    y = random.uniform(FROM_CUSHIONS, height - FROM_CUSHIONS)
    return round(float(x), 1), round(float(y), 1)


def _unit(x: float, y: float) -> Vector:
    """(x, y) with length 1."""
    length = hypot(x, y)
    return x / length, y / length
