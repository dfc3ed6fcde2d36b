"""What lies under the mouse, and its numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import atan2, degrees, hypot
from typing import Any, TypeAlias

import carom

Vector: TypeAlias = tuple[float, float]
Pairs: TypeAlias = tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Reading:
    """The numbers of a shape or ball.

    Attributes:
        title: What it is: name, kind, how it moves.
        pairs: What each number is, and the number.
    """

    title: str
    pairs: Pairs


def shape_at(world: carom.World, place: Vector, reach: float) -> carom.Shape | carom.Ball | None:
    """The shape or ball under the mouse or not farther than `reach` from it, balls first; None where there is none."""
    x, y = place
    around = carom.Aabb(x - reach, y - reach, x + reach, y + reach)
    ball = ball_at(world, place, reach)
    if ball is not None:
        return ball
    near: list[Any] = [shape for shape in world.overlapping(around, sensors=True) if not isinstance(shape, carom.Ball)]
    # Ends of segments are points too, and a point says less than what ends there.
    return min(near, key=lambda shape: (round(shape.distance(place), 3), shape.kind == "point"), default=None)


def ball_at(world: carom.World, place: Vector, reach: float) -> carom.Ball | None:
    """The ball that a place is in, or nearest to, if not farther than `reach`; None where there is none."""
    x, y = place
    around = carom.Aabb(x - reach, y - reach, x + reach, y + reach)
    balls = [ball for ball in world.overlapping(around, sensors=True) if isinstance(ball, carom.Ball)]
    return min(balls, key=lambda ball: hypot(ball.position[0] - x, ball.position[1] - y) - ball.radius, default=None)


def read(shape: carom.Shape | carom.Ball, gravity: float) -> Reading:
    """The numbers of a shape or ball."""
    if isinstance(shape, carom.Ball):
        return Reading(f"{shape.name or 'ball'} {shape.id}", _of_ball(shape, gravity))
    own = OWN.get(shape.kind, _of_point)(shape)
    compound = shape.compound
    name = shape.name or (compound.name if compound is not None else None)
    title = ", ".join(words for words in (name, shape.kind, shape.motion.name.lower()) if words)
    turning: Pairs = ()
    if compound is not None:
        turning = (("pivot", _pair(compound.pivot)), ("turned", _angle(compound.orientation)))
        turning += (("turns", f"{compound.angular_velocity if compound.rotating else 0.0:g} rad/s"),)
    return Reading(title, own + _surface(shape) + turning)


def _of_ball(ball: carom.Ball, gravity: float) -> Pairs:
    """The numbers of a ball."""
    speed = hypot(*ball.velocity)
    energy = ball.mass * (0.5 * speed * speed + gravity * ball.position[1])
    return (
        ("position", _pair(ball.position)),
        ("velocity", _pair(ball.velocity)),
        ("speed", f"{speed:.2f}"),
        ("energy", f"{energy:.2f}"),
        ("radius", f"{ball.radius:.2f}"),
        ("mass", f"{ball.mass:.2f}"),
        ("elasticity", f"{ball.elasticity:g}"),
        ("asleep", "yes" if ball.asleep else "no"),
        ("box", _box(ball.aabb)),
    )


def _of_point(shape: Any) -> Pairs:
    """Where a point is."""
    return (("position", _pair(shape.position)),)


def _of_segment(shape: Any) -> Pairs:
    """A segment's own numbers."""
    (x0, y0), (x1, y1) = shape.p0, shape.p1
    return (
        ("from", _pair(shape.p0)),
        ("to", _pair(shape.p1)),
        ("length", f"{shape.length:.2f}"),
        ("angle", _angle(atan2(y1 - y0, x1 - x0))),
        ("normal", _pair(shape.normal)),
    )


def _of_gate(shape: Any) -> Pairs:
    """A gate's own numbers."""
    return (*_of_segment(shape), ("lets pass", _pair(shape.direction)))


def _of_circle(shape: Any) -> Pairs:
    """A circle's own numbers."""
    return (
        ("center", _pair(shape.center)),
        ("radius", f"{shape.radius:.2f}"),
        ("solid", "yes" if shape.solid else "no"),
    )


def _of_arc(shape: Any) -> Pairs:
    """An arc's own numbers."""
    return (
        ("center", _pair(shape.center)),
        ("radius", f"{shape.radius:.2f}"),
        ("from", _angle(shape.start_angle)),
        ("to", _angle(shape.end_angle)),
        ("length", f"{shape.length:.2f}"),
    )


OWN: Mapping[str, Callable[[Any], Pairs]] = {
    "segment": _of_segment,
    "gate": _of_gate,
    "circle": _of_circle,
    "arc": _of_arc,
}


def _surface(shape: Any) -> Pairs:
    """The numbers that every shape has."""
    return (("elasticity", f"{shape.elasticity:g}"), ("kick", f"{shape.kick:g}"), ("box", _box(shape.aabb)))


def _pair(pair: Vector) -> str:
    """A pair in words."""
    # Adding 0 makes a zero of what is rounded to a negative one.
    x, y = (round(number, 2) + 0.0 for number in pair)
    return f"({x:.2f}, {y:.2f})"


def _angle(radians: float) -> str:
    """An angle in words."""
    return f"{round(degrees(radians), 1) + 0.0:.1f}°"


def _box(box: carom.Aabb) -> str:
    """A box in words: its lower left and upper right corners."""
    return f"{_pair((box.left, box.bottom))} to {_pair((box.right, box.top))}"
