"""What each shape looks like, by what it does: chosen once, for every painter."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from carom.draw.paint.painter import Style
from carom.rows.shape import Motion
from carom.shapes.gate import Gate
from carom.shapes.point import Point

if TYPE_CHECKING:
    from carom.draw.paint.painter import Vector
    from carom.shapes.shape import Shape


@dataclass(frozen=True, slots=True)
class Look:
    """A material as it is drawn: the legend's words for it, how its lines look, and the pixels of a point's dot."""

    label: str
    style: Style
    fill_opacity: float = 0.0  # of the inside of a solid circle
    dot: float = 2.4

    def line(self, weight: float) -> Style:
        """The style of lines, their width times `weight`."""
        return replace(self.style, width=self.style.width * weight)

    def area(self, weight: float) -> Style:
        """The style of a solid circle: the line, around a tinted inside."""
        return replace(self.line(weight), fill=self.style.stroke, fill_opacity=self.fill_opacity)

    def spot(self) -> Style:
        """The style of a dot."""
        return Style(fill=self.style.stroke, opacity=self.style.opacity)


WALL = Look("wall", Style("wall", width=2.2), fill_opacity=0.14)
POST = Look("post", Style("post"), dot=3.2)
GUARD = Look("guard point", Style("post"), dot=1.7)
BUMPER = Look("bumper: adds speed", Style("bumper", width=3.0), fill_opacity=0.2, dot=3.6)
MOVING = Look("moving part, its pivot", Style("moving", width=3.0), fill_opacity=0.2, dot=3.2)
GATE = Look("gate, its open way", Style("gate", width=2.2))
SENSOR = Look("sensor", Style("sensor", width=1.6, dash=(5.0, 4.0)), fill_opacity=0.12, dot=3.2)
OFF = Look("switched off", Style("off", width=1.4, dash=(1.0, 4.0)), fill_opacity=0.06, dot=2.4)

#: In the order of the legend; what stands later lies over what stands earlier.
LOOKS = (OFF, SENSOR, WALL, GUARD, POST, GATE, MOVING, BUMPER)


def look_of(shape: Shape, ends: frozenset[Vector]) -> Look:
    """The look of `shape`; a point at one of `ends`, the rounded ends of lines, is a guard point."""
    return look_now(shape, material_of(shape, ends))


def look_now(shape: Shape, material: Look) -> Look:
    """The look of `shape` as it is switched now, when `material` is the one it has while it is switched on."""
    return material if shape.sensor or shape.can_collide else OFF


def material_of(shape: Shape, ends: frozenset[Vector]) -> Look:
    """The look of `shape` while it is switched on."""
    if shape.sensor:
        return SENSOR
    if isinstance(shape, Gate):
        return GATE
    if isinstance(shape, Point) and rounded(shape.position) in ends:
        return GUARD
    if shape.motion == Motion.KINEMATIC:
        return MOVING
    if shape.kick > 0.0 or shape.elasticity > 1.0:
        return BUMPER
    return POST if isinstance(shape, Point) else WALL


def rounded(position: Vector) -> Vector:
    """`position`, so that places that differ by rounding alone compare equal, but for a rare step across a digit."""
    return float(f"{position[0]:.6g}"), float(f"{position[1]:.6g}")
