"""The hand that changes the table itself: it moves, turns, adds and takes away things, on every table alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import cos, pi, sin
from typing import Any, TypeAlias

import carom
from carom.play.toy.table import USUAL_RADIUS, Table

Vector: TypeAlias = tuple[float, float]

#: The elasticity of what is added: that of the scene's own walls.
WALL = 0.97
#: Units: half a new wall's length, the radius of a new arc, of a new disc.
HALF_WALL, ARC, DISC = 2.0, 2.0, 1.0


def made(kind: str, place: Vector, size: float) -> Any:
    """A new thing at a place: a `segment`, `arc`, `circle` or `point`, or a `ball` of the radius `size`."""
    x, y = place
    makers: Mapping[str, Callable[[], Any]] = {
        "segment": lambda: carom.Segment((x - HALF_WALL, y), (x + HALF_WALL, y), elasticity=WALL, name="new wall"),
        "arc": lambda: carom.Arc(place, ARC, 0.0, pi, elasticity=WALL, name="new arc"),
        "circle": lambda: carom.Circle(place, DISC, solid=True, elasticity=WALL, name="new disc"),
        "point": lambda: carom.Point(place, elasticity=WALL, name="new post"),
        "ball": lambda: carom.Ball(place, radius=size, mass=(size / USUAL_RADIUS) ** 2),
    }
    return makers[kind]()


class Editor:
    """Changes the things of all tables, which have the same ids.

    Attributes:
        held: The id of what is dragged, or None.
    """

    def __init__(self) -> None:
        self.held: int | None = None
        self._offset: Vector = (0.0, 0.0)

    def take(self, thing: Any, place: Vector) -> None:
        """Take hold of a shape or ball at a place; of a part, of the compound that it belongs to."""
        thing = whole(thing)
        self.held = thing.id
        self._offset = (thing.position[0] - place[0], thing.position[1] - place[1])

    def move(self, tables: Sequence[Table], place: Vector) -> None:
        """Move what is held, as far as the bounds of the table."""
        for thing in found(tables, self.held):
            left, bottom, right, top = thing.world.bounds
            x, y = place[0] + self._offset[0], place[1] + self._offset[1]
            thing.position = (min(max(x, left), right), min(max(y, bottom), top))

    def drop(self, tables: Sequence[Table]) -> None:
        """Let go of what is held."""
        self.held = None
        guard(tables)

    def turn(self, tables: Sequence[Table], thing: Any, angle: float) -> None:
        """Turn a shape about its own position by an angle in radians; a ball has nothing to turn."""
        for one in found(tables, whole(thing).id):
            turn(one, angle)
        guard(tables)

    def add(self, tables: Sequence[Table], kind: str, place: Vector, size: float) -> None:
        """Add a thing of a kind; a ball has the radius `size`."""
        for table in tables:
            table.world.add(made(kind, place, size))
            table.launched += kind == "ball"
        guard(tables)

    def remove(self, tables: Sequence[Table], thing: Any) -> None:
        """Take a shape or ball away."""
        for one in found(tables, whole(thing).id):
            one.world.remove(one)
        guard(tables)


def turn(thing: Any, angle: float) -> None:
    """Turn a shape about its own position by an angle in radians; what is round looks the same then."""
    if isinstance(thing, carom.Compound):
        thing.rotate(thing.position, angle)
    elif isinstance(thing, carom.Arc):
        thing.set_angles(thing.start_angle + angle, thing.end_angle + angle)
    elif isinstance(thing, carom.Segment):
        (x, y), c, s = thing.position, cos(angle), sin(angle)
        start, end = (
            (x + c * (a - x) - s * (b - y), y + s * (a - x) + c * (b - y)) for a, b in (thing.start, thing.end)
        )
        thing.set_ends(start, end)
        if isinstance(thing, carom.Gate):
            a, b = thing.direction
            thing.direction = (c * a - s * b, s * a + c * b)


def whole(thing: Any) -> Any:
    """A shape or ball itself, or the compound that it is a part of."""
    return getattr(thing, "compound", None) or thing


def found(tables: Sequence[Table], number: int | None) -> list[Any]:
    """What has an id, on each table that has it; a compound goes by the id of its own centre."""
    if number is None:
        return []
    worlds = [table.world for table in tables]
    return [
        whole(world.object(number))
        for world in worlds
        if number in world.balls.id or any(shape.id == number for shape in world.shapes)
    ]


def guard(tables: Sequence[Table]) -> None:
    """Put points at the bare ends of the shapes as they stand now, in place of those that were there."""
    for table in tables:
        world = table.world
        points = [shape for shape in world.shapes if shape.name == GUARD]
        world.remove(*points)
        bare = carom.guard_points(shape for shape in world.shapes if not isinstance(shape, carom.Compound))
        for point in bare:
            point.name = GUARD
        world.add(*bare)


#: The name of the points that scenes put at bare ends.
GUARD = "guard point"
