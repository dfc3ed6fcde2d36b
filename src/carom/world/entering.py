"""What may come into a world, and what may be taken out of it: looked at before anything has changed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom import checks
from carom.shapes.assembly import Assembly
from carom.shapes.ball import Ball
from carom.shapes.shape import Shape

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.errors import InvalidArgument
    from carom.world.members import Members


def members_of(shape: Shape | Ball | Assembly) -> Sequence[Shape | Ball]:
    """What has a row of its own: `shape`, or the parts of a compound or group, a `center_point` first."""
    return shape._parts if isinstance(shape, Assembly) else [shape]


def entering(world: Members, shapes: Sequence[Any]) -> list[Sequence[Shape | Ball]]:
    """The members of each of `shapes`, which may all come in; raises `InvalidArgument` for the first that may not."""
    found = []
    given: set[int] = set()
    for index, shape in enumerate(shapes):
        if not isinstance(shape, (Shape, Ball, Assembly)):
            listed = isinstance(shape, (list, tuple))
            must = "must be a shape, a compound, a group or a ball"
            must += " (a list of them is added by add(*shapes))" * listed
            raise _refuse(shapes, index, must)
        members = members_of(shape)
        if any(member.world is not None for member in members):
            raise _refuse(shapes, index, "must not be in a world already (copy.copy(shape) makes one that is in none)")
        whole = shape._whole if isinstance(shape, Shape) else None
        if whole is not None and whole.world is not world:
            kind = whole.kind
            raise _refuse(shapes, index, f"must not be part of a {kind} that is not in the world: add the {kind}")
        if id(shape) in given:
            raise _refuse(shapes, index, "must not be given twice")
        given.add(id(shape))
        found.append(members)
    return found


def leaving(world: Members, shapes: Sequence[Any]) -> list[Sequence[Shape | Ball]]:
    """The members of each of `shapes`, which may all leave; raises `InvalidArgument` for the first that may not.

    What hits that are at hand may name, and has left already, is passed over: it is where it is wanted.
    """
    staying = []
    for index, shape in enumerate(shapes):
        gone = getattr(shape, "world", world) is None and any(map(world._departed.has_just_left, members_of(shape)[:1]))
        if not gone and getattr(shape, "world", None) is not world:
            listed = isinstance(shape, (list, tuple))
            raise _refuse(
                shapes, index, "must be in this world" + (" (a list is taken out by remove(*shapes))" * listed)
            )
        if isinstance(shape, Shape) and shape._whole is not None:
            kind = shape._whole.kind
            raise _refuse(shapes, index, f"must not be part of a {kind}: remove the {kind}")
        if not gone:
            staying.append(shape)
    return [members_of(shape) for shape in staying]


def _refuse(shapes: Sequence[Any], index: int, must: str) -> InvalidArgument:
    """The error to raise for one of several arguments, which it names by its index where it is not the only one."""
    return checks.refuse("shape" if len(shapes) == 1 else f"shapes[{index}]", must, shapes[index])
