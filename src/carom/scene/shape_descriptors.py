"""Descriptors of shapes, compounds and groups, as pydantic models: what a scene file may say, and what it makes.

What takes several fields to see (equal ends, a gate that points along itself) is left to the constructors: a descriptor
makes its shape once when it is made, so that none exists that cannot be built.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated, Any, ClassVar, Literal, Self, cast

from pydantic import BeforeValidator, Field, field_validator, model_validator

from carom.errors import InvalidArgument
from carom.scene.descriptor import Descriptor
from carom.scene.descriptors import CollidingDescriptor
from carom.scene.faults import fault_below, refused_below
from carom.scene.fields import Layers, NonNegative, Positive, Text, Vector, as_tuple
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.compound import Compound
from carom.shapes.gate import Gate
from carom.shapes.group import Group
from carom.shapes.point import Point
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape


class BuiltDescriptor(Descriptor):
    """What shapes, compounds and groups share: that they can be built."""

    @model_validator(mode="after")
    def _can_be_built(self) -> Self:
        """The descriptor itself, unless what it describes cannot be made."""
        try:
            self.build()
        except InvalidArgument as error:
            raise refused_below(error, type(self).model_fields) from None
        return self

    @abstractmethod
    def build(self) -> Shape | Compound | Group:
        """What is described, in no world."""


class MovingDescriptor(BuiltDescriptor):
    """What shapes and compounds share: how they turn and travel."""

    orientation: float = 0.0
    """How far it has turned from the geometry given here, in radians."""
    angular_velocity: float = 0.0
    """How fast it turns about its pivot, in rad/s."""
    rotating: bool = True
    """Whether the angular velocity acts."""
    turn_limits: Vector | None = None
    """Its stops: the least and the greatest orientation, in radians, with 0 between them."""
    velocity: Vector = (0.0, 0.0)
    """How fast its pivot, and it with that, travels, in length/s."""

    def build(self) -> Shape | Compound:
        """What is described, in no world."""
        made = self.unturned()
        if self.orientation != 0.0:
            made.rotate(made.pivot, self.orientation)
        return made

    @abstractmethod
    def unturned(self) -> Shape | Compound:
        """What is described, before it turned."""

    def _arguments(self) -> dict[str, Any]:
        """The fields that are arguments of a constructor."""
        return {name: value for name, value in self if name not in {"kind", "orientation"}}


class ShapeDescriptor(MovingDescriptor, CollidingDescriptor):
    """What all shapes share."""

    maker: ClassVar[type[Shape]]

    once: bool = False
    """Whether it switches itself off at its first bounce."""
    kick: NonNegative = 0.0
    """A speed that it adds along the normal at every approach that bounces, in length/s."""
    motion: Literal["static", "kinematic"] = "static"
    """Whether it can turn and travel."""
    pivot: Vector | None = None
    """The place about which it turns; by default its position."""

    def unturned(self) -> Shape:
        """The shape before it turned, in no world."""
        return self.maker(**self._arguments())


class PointDescriptor(ShapeDescriptor):
    """A point."""

    maker = Point
    kind: Literal["point"] = "point"
    position: Vector
    """Where it is."""


class SegmentDescriptor(ShapeDescriptor):
    """A segment; its ends are bare."""

    maker = Segment
    kind: Literal["segment"] = "segment"
    start: Vector
    """One end."""
    end: Vector
    """The other end."""


class CircleDescriptor(ShapeDescriptor):
    """A circle."""

    maker = Circle
    kind: Literal["circle"] = "circle"
    center: Vector
    """Its centre."""
    radius: Positive
    """Its radius."""
    solid: bool = False
    """Whether its inside is solid too."""


class ArcDescriptor(ShapeDescriptor):
    """The part of a circle counterclockwise from its start to its end."""

    maker = Arc
    kind: Literal["arc"] = "arc"
    center: Vector
    """The circle's centre."""
    radius: Positive
    """The circle's radius."""
    start_angle: float
    """Where it starts, in radians counterclockwise from +x."""
    end_angle: float
    """Where it ends, likewise."""


class GateDescriptor(ShapeDescriptor):
    """A segment that lets balls pass one way."""

    maker = Gate
    kind: Literal["gate"] = "gate"
    start: Vector
    """One end."""
    end: Vector
    """The other end."""
    direction: Vector | None = None
    """The way that it opens; by default its normal."""


Part = Annotated[
    PointDescriptor | SegmentDescriptor | CircleDescriptor | ArcDescriptor | GateDescriptor, Field(discriminator="kind")
]

PartList = Annotated[tuple[Part, ...], BeforeValidator(as_tuple)]

#: What a part of a compound does not say for itself.
PART_IS_SILENT_ON = (*MovingDescriptor.model_fields, "motion", "pivot")


class AssemblyDescriptor(Descriptor):
    """What compounds and groups share: what is set here of their surfaces is set on all of their parts."""

    name: Text | None = None
    """What it is called."""
    elasticity: NonNegative | None = None
    """The elasticity of all parts."""
    kick: NonNegative | None = None
    """The kick of all parts."""
    sensor: bool | None = None
    """Whether all parts are sensors."""
    can_collide: bool | None = None
    """Whether the parts meet anything at all."""
    once: bool | None = None
    """Whether each part switches itself off at its first bounce; of a group, all of it at the first bounce off any."""
    layer: Layers | None = None
    """The layers that all parts are on."""
    collides_with: Layers | None = None
    """The layers that all parts meet."""


class CompoundDescriptor(AssemblyDescriptor, MovingDescriptor):
    """Shapes that turn and travel as one."""

    kind: Literal["compound"] = "compound"
    pivot: Vector
    """The place about which it turns."""
    shapes: PartList
    """Its parts, as they lie before it turns; how they move is the compound's to say."""

    @field_validator("shapes")
    @classmethod
    def _parts_do_not_move_alone(cls, parts: tuple[Part, ...]) -> tuple[Part, ...]:
        """The parts, unless one of them says how it moves."""
        for place, part in enumerate(parts):
            for name in PART_IS_SILENT_ON:
                if getattr(part, name) != type(part).model_fields[name].default:
                    raise fault_below(f"[{place}].{name}", "is for the compound to set, not for its parts")
        return parts

    def unturned(self) -> Compound:
        """The compound before it turned, in no world."""
        return Compound(**self._arguments() | {"shapes": [part.unturned() for part in self.shapes]})


class GroupDescriptor(AssemblyDescriptor, BuiltDescriptor):
    """Static shapes that are one thing, such as a brick."""

    kind: Literal["group"] = "group"
    shapes: PartList
    """Its parts."""

    @field_validator("shapes")
    @classmethod
    def _parts_are_static(cls, parts: tuple[Part, ...]) -> tuple[Part, ...]:
        """The parts, unless there are none or one of them moves."""
        if not parts:
            raise fault_below("", "must hold at least one shape")
        for place, part in enumerate(parts):
            if part.motion != "static":
                raise fault_below(f"[{place}].motion", "must be static (a compound is what turns and travels)")
        return parts

    def build(self) -> Group:
        """The group, in no world."""
        options = {name: value for name, value in self if name not in {"kind", "shapes"}}
        return Group([cast("Shape", part.build()) for part in self.shapes], **options)
