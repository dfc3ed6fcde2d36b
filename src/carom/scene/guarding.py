"""Guard points for a scene's shapes: in the world beside them, or as parts of what they belong to."""

from __future__ import annotations

from collections.abc import Sequence

from carom.shapes.assembly import Assembly
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.guard import guard_points
from carom.shapes.shape import Shape

#: The name of the points beside the shapes; those in a compound or group go by its name.
GUARD_NAME = "guard point"


def guarded(shapes: Sequence[Shape | Compound | Group]) -> list[Shape | Compound | Group]:
    """`shapes`, compounds and groups with the points for their own ends among their parts; then points for the rest.

    A point beside a shape that turns moves as the shape is set to now; what is set on the shape later does not concern
    the point. So a shape that is to be told to turn is best put into a compound.
    """
    for shape in shapes:
        if isinstance(shape, Compound):
            _guard_parts(shape)
        elif isinstance(shape, Group):
            for point in guard_points(shape.shapes):
                shape.add(point)
    points = guard_points(shape for shape in shapes if not isinstance(shape, Assembly))
    for point in points:
        point.name = GUARD_NAME
    return [*shapes, *points]


def _guard_parts(compound: Compound) -> None:
    """Add the points that the parts of a compound need to it."""
    orientation = compound.orientation
    compound.reset()  # parts are added as they lie at orientation 0
    for point in guard_points(compound.shapes):
        compound.add(point)
    compound.rotate(compound.pivot, orientation)
