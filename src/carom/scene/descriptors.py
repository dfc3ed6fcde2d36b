"""Descriptors: what a scene file holds, as pydantic models, and what each of them makes.

A descriptor is strict (no text for a number), frozen, and refuses what it does not know. Fields bear the names of the
constructors' arguments and have their defaults. What takes several fields to see (equal ends, a gate that points along
itself) is left to the constructors: a descriptor makes its shape once when it is made, so that none exists that cannot
be built.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, field_validator, model_validator

from carom.errors import InvalidArgument
from carom.rows import ALL_LAYERS
from carom.scene.faults import fault_below, refused_below
from carom.scene.fields import Count, Few, Layers, Many, NonNegative, Positive, Sides, Text, Vector, as_tuple
from carom.shapes.aabb import Aabb
from carom.shapes.arc import Arc
from carom.shapes.ball import Ball
from carom.shapes.circle import Circle
from carom.shapes.compound import Compound
from carom.shapes.gate import Gate
from carom.shapes.point import Point
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape


class Descriptor(BaseModel):
    """What all descriptors share: how strictly they read."""

    model_config = ConfigDict(strict=True, frozen=True, extra="forbid", allow_inf_nan=False)

    def plain(self) -> dict[str, Any]:
        """The descriptor as a file holds it: plain tables, without what is as it would be anyway."""
        fields = type(self).model_fields
        table = {}
        for name in sorted(fields, key=_rank):
            value, field = getattr(self, name), fields[name]
            # By repr, for -0.0 equals 0.0 and is not the same.
            if name == "kind" or repr(value) != repr(field.default):
                table[name] = _plain(value)
        return table


class WorldDescriptor(Descriptor):
    """The settings of a world; what is None is left to the world."""

    gravity: Vector = (0.0, 0.0)
    detection: Literal["discrete", "continuous"] = "discrete"
    substeps: Many = 4
    iterations: Many = 6
    broad_phase: Literal["grid", "quadtree", "brute"] = "grid"
    levels: Few = 6
    restitution: Literal["normal", "total"] = "normal"
    friction: NonNegative = 0.0
    sleep_speed: NonNegative = 0.0
    sleep_time: NonNegative = 0.5
    rest_speed: NonNegative | None = None
    max_speed: Positive | None = None
    max_impacts: Count = 100_000
    bounds: Sides | None = None
    remove_strays: bool = False

    def settings(self) -> dict[str, Any]:
        """The arguments for `World`."""
        settings = {name: value for name, value in self if value is not None}
        if self.bounds is not None:
            settings["bounds"] = Aabb(*self.bounds)
        return settings


class CollidingDescriptor(Descriptor):
    """What shapes and balls share."""

    name: Text | None = None
    elasticity: NonNegative = 1.0
    sensor: bool = False
    can_collide: bool = True
    layer: Layers = 1
    collides_with: Layers = ALL_LAYERS


class BallDescriptor(CollidingDescriptor):
    """A ball."""

    position: Vector
    radius: Positive
    velocity: Vector = (0.0, 0.0)
    mass: Positive = 1.0

    def build(self) -> Ball:
        """The ball, in no world."""
        return Ball(**dict(self))


class MovableDescriptor(CollidingDescriptor):
    """What all shapes share; `orientation` is how far a kinematic shape has turned from the geometry given."""

    kick: NonNegative = 0.0
    motion: Literal["static", "kinematic"] = "static"
    pivot: Vector | None = None
    orientation: float = 0.0
    angular_velocity: float = 0.0
    rotating: bool = True
    turn_limits: Vector | None = None
    velocity: Vector = (0.0, 0.0)


class ShapeDescriptor(MovableDescriptor):
    """A shape that is made by one constructor."""

    maker: ClassVar[type[Shape]]

    @model_validator(mode="after")
    def _can_be_built(self) -> Self:
        """The descriptor itself, unless its shape cannot be made."""
        try:
            self.build()
        except InvalidArgument as error:
            raise refused_below(error, type(self).model_fields) from None
        return self

    def build(self) -> Shape:
        """The shape, in no world."""
        shape = self.maker(**{name: value for name, value in self if name not in {"kind", "orientation"}})
        turn(shape, self.orientation)
        return shape


def turn(shape: Shape | Compound, orientation: float) -> None:
    """Nothing; turns `shape` about its pivot."""
    if orientation != 0.0:
        shape.rotate(shape.pivot, orientation)


class PointDescriptor(ShapeDescriptor):
    """A point."""

    maker = Point
    kind: Literal["point"] = "point"
    position: Vector


class SegmentDescriptor(ShapeDescriptor):
    """A segment."""

    maker = Segment
    kind: Literal["segment"] = "segment"
    start: Vector
    end: Vector


class CircleDescriptor(ShapeDescriptor):
    """A circle."""

    maker = Circle
    kind: Literal["circle"] = "circle"
    center: Vector
    radius: Positive
    solid: bool = False


class ArcDescriptor(ShapeDescriptor):
    """An arc, counterclockwise from its start to its end."""

    maker = Arc
    kind: Literal["arc"] = "arc"
    center: Vector
    radius: Positive
    start_angle: float
    end_angle: float


class GateDescriptor(ShapeDescriptor):
    """A gate; without a direction it opens along its normal."""

    maker = Gate
    kind: Literal["gate"] = "gate"
    start: Vector
    end: Vector
    direction: Vector | None = None


Part = Annotated[
    PointDescriptor | SegmentDescriptor | CircleDescriptor | ArcDescriptor | GateDescriptor, Field(discriminator="kind")
]


class CompoundDescriptor(Descriptor):
    """Shapes that turn and move as one; what is set here of their surfaces is set on all of them."""

    kind: Literal["compound"] = "compound"
    name: Text | None = None
    shapes: Annotated[tuple[Part, ...], BeforeValidator(as_tuple)]
    pivot: Vector
    orientation: float = 0.0
    angular_velocity: float = 0.0
    rotating: bool = True
    turn_limits: Vector | None = None
    velocity: Vector = (0.0, 0.0)
    elasticity: NonNegative | None = None
    kick: NonNegative | None = None
    sensor: bool | None = None
    can_collide: bool | None = None
    layer: Layers | None = None
    collides_with: Layers | None = None

    @field_validator("shapes")
    @classmethod
    def _parts_do_not_move_alone(cls, parts: tuple[Part, ...]) -> tuple[Part, ...]:
        """The parts, none of which says how it moves: that is the compound's to say."""
        for place, part in enumerate(parts):
            for name in MOTION_FIELDS:
                if getattr(part, name) != type(part).model_fields[name].default:
                    raise fault_below(f"[{place}].{name}", "is for the compound to set, not for its parts")
        return parts

    @model_validator(mode="after")
    def _can_be_built(self) -> Self:
        """The descriptor itself, unless its compound cannot be made."""
        try:
            self.build()
        except InvalidArgument as error:
            raise refused_below(error, type(self).model_fields) from None
        return self

    def build(self) -> Compound:
        """The compound and its parts, in no world."""
        arguments = {name: value for name, value in self if name not in {"kind", "orientation", "shapes"}}
        compound = Compound([part.build() for part in self.shapes], **arguments)
        turn(compound, self.orientation)
        return compound


#: What a part of a compound does not say for itself.
MOTION_FIELDS = ("motion", "pivot", "orientation", "angular_velocity", "rotating", "turn_limits", "velocity")


_FIRST = ("version", "kind", "name")


def _rank(field: str) -> int:
    """Where a field stands in a table: version, kind and name, then what few have, and last what all shapes have."""
    if field in _FIRST:
        return _FIRST.index(field)
    return len(_FIRST) + (field in MovableDescriptor.model_fields)


def _plain(value: Any) -> Any:
    """A field's value as a file holds it."""
    if isinstance(value, Descriptor):
        return value.plain()
    return [_plain(item) for item in value] if isinstance(value, tuple) else value
