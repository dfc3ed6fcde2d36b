"""What the player sees of a shot before it: the line of `World.aim`, the ghost ball, and where both balls go then."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

from carom.play.pool.game import SHAPES, Pool, Vector, speed_of

if TYPE_CHECKING:
    from carom import Aim, Ball

#: cm: farther than any two places of the table.
FAR = 400.0


@dataclass(frozen=True, slots=True)
class Leg:
    """A ball's straight way to its next impact, and the pocket that it falls into or the ball that it meets."""

    start: Vector
    end: Vector
    pocket: str | None
    ball: str | None = None


@dataclass(frozen=True, slots=True)
class Preview:
    """The shot along one direction.

    Attributes:
        aim: The cue ball's line up to its first impact.
        pocket: The pocket that the cue ball falls into before that, if it does.
        cue: Its way on from there, or None where it stands still or is potted.
        struck: The way of the ball that the cue ball meets first, or None where it meets none.
    """

    aim: Aim
    pocket: str | None
    cue: Leg | None
    struck: Leg | None


def preview(pool: Pool, direction: Vector) -> Preview | None:
    """What a shot in a direction would do, or None if it would meet nothing."""
    length = hypot(*direction)
    direction = direction[0] / length, direction[1] / length
    aim = pool.world.aim(pool.cue, direction)
    if aim is None:
        return None
    met = next((ball for ball in pool.targets if aim.shape is ball), None)
    pocket = leg(pool, aim.start, direction, 0).pocket if met is None else None
    cue = struck = None
    others = layers_of(pool, met)
    if aim.direction is not None and pocket is None:
        cue = leg(pool, aim.ghost, aim.direction, others)
    if met is not None and aim.other_direction is not None:
        struck = leg(pool, met.position, aim.other_direction, others)
    return Preview(aim, pocket, cue, struck)


def layers_of(pool: Pool, without: Ball | None) -> int:
    """The layers of the balls that are still to be potted, without one of them."""
    return sum(ball.layer for ball in pool.targets if ball is not without)


def leg(pool: Pool, start: Vector, direction: Vector, balls: int) -> Leg:
    """The way of a ball from `start` to what it meets first: a pocket, a cushion, or a ball on the layers `balls`."""
    target = (start[0] + FAR * direction[0], start[1] + FAR * direction[1])
    radius = pool.cue.radius
    hit = pool.world.circle_cast(start, radius, target, collides_with=SHAPES | balls, sensors=True)
    if hit is None:
        return Leg(start, target, None)
    way = FAR * hit.fraction
    end = (start[0] + way * direction[0], start[1] + way * direction[1])
    if any(hit.shape is ball for ball in pool.targets):
        return Leg(start, end, None, hit.shape.name)
    return Leg(start, end, pocket_at(pool, end) if hit.shape.sensor or hit.shape.name == "pocket" else None)


def reaches(pool: Pool, shown: Preview, way: Leg, share: float, power: float) -> bool:
    """Whether a ball gets to the end of its way after the impact, which leaves it a `share` of the cue ball's speed."""
    return range_after(pool, shown, share, power) > hypot(way.end[0] - way.start[0], way.end[1] - way.start[1])


def range_of(pool: Pool, power: float) -> float:
    """How many cm the cue ball rolls after a shot if it meets nothing."""
    # Friction takes the same from the square of a speed on every centimetre.
    speed = speed_of(power)
    return 0.5 * speed * speed / pool.world.friction


def range_after(pool: Pool, shown: Preview, share: float, power: float) -> float:
    """How many cm a ball rolls after the impact, which leaves it a `share` of the cue ball's speed."""
    return max(range_of(pool, power) - shown.aim.distance, 0.0) * share * share


def until_rest(pool: Pool, shown: Preview, way: Leg, share: float, power: float) -> Leg:
    """A ball's way after the impact as far as it rolls, which may be no farther than to where it stops."""
    if reaches(pool, shown, way, share, power):
        return way
    return Leg(way.start, along(way.start, way.end, range_after(pool, shown, share, power)), None)


def rest_before_impact(pool: Pool, shown: Preview, power: float) -> Vector | None:
    """Where the cue ball comes to rest if it does not get to its first impact, or None if it gets there."""
    distance = range_of(pool, power)
    return along(shown.aim.start, shown.aim.ghost, distance) if distance < shown.aim.distance else None


def along(start: Vector, end: Vector, distance: float) -> Vector:
    """The place at a distance from `start` towards `end`; `start` itself where the two are one."""
    way = hypot(end[0] - start[0], end[1] - start[1])
    share = distance / way if way > 0.0 else 0.0
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])


def scratch(pool: Pool, shown: Preview, power: float) -> str | None:
    """The pocket that the cue ball falls into, at once or after its first impact, if it does."""
    if rest_before_impact(pool, shown, power) is not None:
        return None
    if shown.pocket is None and shown.cue is not None and shown.cue.pocket is not None:
        return shown.cue.pocket if reaches(pool, shown, shown.cue, shown.aim.speed, power) else None
    return shown.pocket


def pocket_at(pool: Pool, place: Vector) -> str:
    """The name of the pocket that is nearest to a place."""
    sensors = [shape for shape in pool.world.shapes if shape.sensor]
    x, y = place
    return min(sensors, key=lambda shape: hypot(shape.position[0] - x, shape.position[1] - y)).name or ""
