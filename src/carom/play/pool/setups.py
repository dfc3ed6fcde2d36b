"""Positions to begin with: random ones, each with a shot that has been tried, and wins or pots a ball."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from math import cos, dist, hypot, radians

import numpy as np

import carom
from carom.play.pool.game import FIRST, SHAPES, Phase, Pool, Setup, Vector
from carom.play.pool.preview import Preview, layers_of, preview, reaches, scratch

#: cm: balls of a random position lie at least so far from the cushions; the cue ball from the others, and they from
#: each other.
FROM_CUSHIONS, APART, AMONG = 14.0, 35.0, 14.0

#: The thinnest cut that a position asks for.
THINNEST = cos(radians(50.0))

#: Powers that are tried for each line.
POWERS = (0.5, 0.65, 0.4, 0.8)

#: Steps after which a trial is given up; balls lie still long before.
TRIAL_STEPS = 6_000


@dataclass(frozen=True, slots=True)
class Shot:
    """A shot that would pot a ball: its direction, the pocket, and the cosine of the angle at which the ball is cut."""

    direction: Vector
    pocket: str
    fullness: float


def lines(pool: Pool) -> list[Shot]:
    """The straight shots that send a ball into a pocket from where the balls lie, the fullest first."""
    pockets = [shape for shape in pool.world.shapes if shape.sensor and isinstance(shape, carom.Circle)]
    found = [_line(pool, ball, pocket) for ball in pool.targets for pocket in pockets]
    return sorted((shot for shot in found if shot is not None), key=lambda shot: -shot.fullness)


def _line(pool: Pool, ball: carom.Ball, pocket: carom.Circle) -> Shot | None:
    """The straight shot that sends a ball into a pocket, or None if something is in the way, or it is too thin."""
    (cue_x, cue_y), (x, y), reach = pool.cue.position, ball.position, pool.cue.radius + ball.radius
    way_x, way_y = _unit(pocket.center[0] - x, pocket.center[1] - y)
    blocking = SHAPES | layers_of(pool, ball)
    free = pool.world.circle_cast((x, y), ball.radius, pocket.center, collides_with=blocking, sensors=True)
    direction = (x - reach * way_x - cue_x, y - reach * way_y - cue_y)
    along = _unit(*direction)
    fullness = along[0] * way_x + along[1] * way_y
    if free is None or free.shape is not pocket or fullness < THINNEST:
        return None
    aim = pool.world.aim(pool.cue, direction)
    return Shot(along, pocket.name or "", fullness) if aim is not None and aim.shape is ball else None


def wins(pool: Pool, direction: Vector, power: float) -> bool:
    """Whether a shot would win at once, or, where there are more balls, pot one without a foul.

    It is tried in the game's own world, which is as before afterwards.
    """
    left, fouls = len(pool.targets), pool.fouls
    with pool.trial():
        pool.shoot(direction, power)
        for _ in range(TRIAL_STEPS):
            pool.step()
            if not pool.moving or pool.over:
                break
        if pool.limit is None:
            return pool.phase is Phase.WON
        return len(pool.targets) < left and pool.fouls == fouls


def winning(pool: Pool) -> tuple[Shot, float] | None:
    """A shot and a power that win from where the balls lie, or None if none of those tried does."""
    for shot in lines(pool):
        shown = preview(pool, shot.direction)
        for power in POWERS:
            if shown is not None and is_promising(pool, shown, power) and wins(pool, shot.direction, power):
                return shot, power
    return None


def is_promising(pool: Pool, shown: Preview, power: float) -> bool:
    """Whether the ball that is struck gets to a pocket, and the cue ball to none before its second impact."""
    struck = shown.struck
    if struck is None or struck.pocket is None or scratch(pool, shown, power) is not None:
        return False
    return reaches(pool, shown, struck, shown.aim.other_speed, power)


def setup(pool: Pool, number: int, seed: int = 0) -> Setup:
    """Where the balls lie in position `number`: a random one that has a shot which `wins`.

    For the eight alone, position 0 is `FIRST`. The game is left with the balls in that position.
    """
    if number == 0 and pool.limit is None:
        pool.place(FIRST)
        return FIRST
    random = np.random.default_rng((seed, number))
    width, height = pool.cloth
    while True:
        cue, eight, *more = (_place(random, width, height) for _ in pool.balls)
        if any(dist(cue, place) < APART for place in (eight, *more)):
            continue
        if any(dist(one, other) < AMONG for one, other in combinations((eight, *more), 2)):
            continue
        pool.place(Setup(cue, eight, tuple(more)))
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
