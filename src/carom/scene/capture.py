"""Descriptors of what exists: the way back from shapes, balls and worlds to the descriptors that would make them."""

from __future__ import annotations

from collections.abc import Iterable
from copy import copy
from typing import TYPE_CHECKING, Any, get_args

from carom.rows.shape import Motion
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.shape_descriptors import (
    PART_IS_SILENT_ON,
    CompoundDescriptor,
    GroupDescriptor,
    MovingDescriptor,
    Part,
)
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape

if TYPE_CHECKING:
    from carom.world.world import World

#: The descriptors of shapes, by the names of their kinds.
_DESCRIPTORS: dict[str, type[Part]] = {one.model_fields["kind"].default: one for one in get_args(get_args(Part)[0])}


def described(thing: Any) -> Any:
    """The descriptor of a shape, compound, group or ball as it stands now; anything else as it is."""
    if isinstance(thing, Ball):
        return BallDescriptor(**_fields(thing, BallDescriptor.model_fields))
    if isinstance(thing, Compound):
        return _described_compound(thing)
    if isinstance(thing, Group):
        return _described_group(thing)
    return _described_shape(thing) if isinstance(thing, Shape) else thing


def described_all(things: Any) -> Any:
    """A list or tuple with the descriptors of the shapes, compounds, groups and balls in it; anything else as it is."""
    return tuple(described(thing) for thing in things) if isinstance(things, (list, tuple)) else things


def described_world(world: World) -> WorldDescriptor:
    """The descriptor of a world's settings."""
    return WorldDescriptor(**_fields(world, WorldDescriptor.model_fields))


def _described_shape(shape: Shape) -> Part:
    """The descriptor of a shape."""
    names = _DESCRIPTORS[shape.kind].model_fields
    return _DESCRIPTORS[shape.kind](**_fields(_unturned(shape), names) | {"orientation": shape.orientation})


def _described_part(shape: Shape) -> Part:
    """The descriptor of a shape in a compound, which says nothing of how it moves."""
    names = [name for name in _DESCRIPTORS[shape.kind].model_fields if name not in PART_IS_SILENT_ON]
    return _DESCRIPTORS[shape.kind](**_fields(_unturned(shape), names))


def _described_compound(compound: Compound) -> CompoundDescriptor:
    """The descriptor of a compound with all of its parts, each with its own surface."""
    names = ("name", "pivot", *MovingDescriptor.model_fields)
    parts = tuple(_described_part(part) for part in compound.shapes)
    values = _fields(compound, names)
    if compound.center_point._row["time_left"] > 0.0:
        values |= {"velocity": (0.0, 0.0), "angular_velocity": 0.0}  # as a shape that was sent somewhere rests here
    return CompoundDescriptor(shapes=parts, **values)


def _described_group(group: Group) -> GroupDescriptor:
    """The descriptor of a group with all of its parts, each with its own surface, and whether they drop together."""
    parts = tuple(_described_shape(part) for part in group.shapes)
    together = group.once and all(part.once for part in group.shapes)
    return GroupDescriptor(shapes=parts, name=group.name, once=True if together else None)


def _unturned(shape: Shape) -> Shape:
    """A lone copy of `shape` before it turned, which stands where the pivot is now."""
    lone = copy(shape)
    lone._write(lone._turned("orientation", 0.0, *lone.pivot, 0.0))
    return lone


def _fields(thing: Any, names: Iterable[str]) -> dict[str, Any]:
    """The attributes `names` of `thing`, as descriptors want them."""
    values = {name: getattr(thing, name) for name in names}
    return {name: value.name.lower() if isinstance(value, Motion) else value for name, value in values.items()}
