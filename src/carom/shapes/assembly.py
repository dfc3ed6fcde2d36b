"""What compounds and groups have in common: parts, a surface that is set on all of them, and a name."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable
from copy import copy
from typing import Any, ClassVar, Self

from carom.checks import flag, layers, non_negative, pair, refuse
from carom.geometry.vector import length
from carom.rows.shape import ShapeRow
from carom.shapes.aabb import Aabb
from carom.shapes.ball import Ball
from carom.shapes.copies import add_attributes, added_attributes
from carom.shapes.detection import Contact
from carom.shapes.named import Named
from carom.shapes.shape import Shape, Surface
from carom.shapes.table import Home
from carom.turns import changing, setting
from carom.typing import Pair, Vector


def _common(name: Surface, check: Callable[[str, Any], Any]) -> property:
    """The property of an assembly that sets `name`, once `check` has passed its value, on all of its parts."""

    def read(whole: Assembly) -> Any:
        return whole._surface.get(name)

    @setting
    def write(whole: Assembly, value: Any) -> None:
        whole._set_surface(name, value if value is None else check(name, value))

    return property(
        read, write, doc=f"The {name} that was set for all parts, also those added later; None leaves it to each part."
    )


class Assembly(Named):
    """Shapes that are one thing, each of them a part of no other.

    What it says of a surface is set on every part and on those that are added later; None leaves it to each part.
    """

    __slots__ = ("__weakref__", "_parts", "_surface", "user")

    #: The attributes that are no user's.
    _OWN: ClassVar[tuple[str, ...]] = (*Named.__slots__, "_parts", "_surface", "user")

    _parts: list[Shape]
    _surface: dict[Surface, Any]
    user: Any

    elasticity = _common("elasticity", non_negative)
    kick = _common("kick", non_negative)
    sensor = _common("sensor", flag)
    can_collide = _common("can_collide", flag)
    once = _common("once", flag)
    layer = _common("layer", layers)
    collides_with = _common("collides_with", layers)

    def _set_surface(self, name: Surface, value: Any) -> None:
        """Set `name` to a value that was checked on all parts, also those added later; None leaves it to each part."""
        if value is None:
            self._surface.pop(name, None)
            return
        self._surface[name] = value
        for shape in self.shapes:
            shape._put(name, value)

    # -- parts -------------------------------------------------------------------------------------------------------

    @property
    @abstractmethod
    def kind(self) -> str:
        """What it is; each part has its own kind."""

    @property
    @abstractmethod
    def shapes(self) -> tuple[Shape, ...]:
        """The parts, in the order in which they were added."""

    @abstractmethod
    def _part_row(self, name: str, shape: Shape) -> ShapeRow:
        """The row that a shape, which is a part of nothing yet, has as a part of this; raises where it cannot be one.

        `name` is what to call the shape in errors.
        """

    def __contains__(self, shape: object) -> bool:
        return isinstance(shape, Shape) and shape._whole is self

    @changing
    def add(self, shape: Shape) -> Shape:
        """`shape`, now a part: what was set on the whole holds for it too, and it is in the world that this is in.

        Raises `InvalidArgument` for what is no shape, and for a shape that is a part already or in another world.
        """
        self._take("shape", [shape])
        if self.world is not None:
            self.world._take_part(shape)
        return shape

    def _take(self, name: str, shapes: list[Shape]) -> None:
        """Make parts of shapes, all or none; `name` is what to call the one at a place in errors."""
        rows = [self._joining_row(name.format(place), shape) for place, shape in enumerate(shapes)]
        if len({id(shape) for shape in shapes}) < len(shapes):
            raise refuse("shapes", "must not hold a shape twice", shapes)
        for shape, row in zip(shapes, rows, strict=True):
            shape._write(row)
            shape._whole = self
            self._parts.append(shape)
            for field, value in self._surface.items():
                shape._put(field, value)

    def _joining_row(self, name: str, shape: Shape) -> ShapeRow:
        """The row that `shape` has as a part of this; raises where it cannot be one."""
        if not isinstance(shape, Shape):
            raise refuse(name, "must be a Point, a Segment, a Gate, a Circle or an Arc", shape)
        if shape._whole is not None:
            raise refuse(name, f"must not be part of a {shape._whole.kind} already", shape)
        if shape.world is not None and shape.world is not self.world:
            raise refuse(name, f"must not be in another world than the {self.kind}", shape)
        return self._part_row(name, shape)

    # -- who it is ---------------------------------------------------------------------------------------------------

    @property
    def id(self) -> int | None:
        """The number that its world gave its first part; None outside of a world."""
        return self._parts[0].id if self._parts else None

    @property
    def world(self) -> Any:
        """The `World` that it is in, or None."""
        return self._world

    @property
    def _world(self) -> Home | None:
        # One has no parts where another world was restored over it.
        return self._parts[0]._world if self._parts else None

    # -- what it meets -----------------------------------------------------------------------------------------------

    @property
    def aabb(self) -> Aabb:
        """The smallest box around its parts."""
        boxes = [shape.aabb for shape in self.shapes or self._parts]
        return Aabb(
            min(box.left for box in boxes),
            min(box.bottom for box in boxes),
            max(box.right for box in boxes),
            max(box.top for box in boxes),
        )

    def closest_point(self, p: Pair) -> Vector:
        """The point of its parts that is nearest to `p`."""
        x, y = pair("p", p)
        points = [shape.closest_point((x, y)) for shape in self.shapes or self._parts]
        return min(points, key=lambda q: length(x - q[0], y - q[1]))

    def detect(self, ball: Ball) -> Contact | None:
        """The contact of `ball` with the first part that it overlaps, points before all others; None where none."""
        for shape in sorted(self._parts, key=lambda part: part._KIND):
            contact = shape.detect(ball)
            if contact is not None:
                return contact
        return None

    # -- copies: lone, with copies of the parts ----------------------------------------------------------------------

    def __getstate__(self) -> Any:
        """The parts, what was set on all of them, the name, the user's own data, and what a subclass of his adds."""
        return self._parts, self._surface, self._name, self.user, added_attributes(self, self._OWN)

    def __setstate__(self, state: Any) -> None:
        """Make this a whole with the state that `__getstate__` gave."""
        parts, surface, self._name, self.user, added = state
        self._parts, self._surface = list(parts), dict(surface)
        for part in self._parts:
            part._whole = self
        add_attributes(self, added)

    def __copy__(self) -> Self:
        return self._like([copy(part) for part in self._parts])

    def _like(self, parts: list[Shape]) -> Self:
        """A whole of other parts that is this one in all else."""
        twin = type(self).__new__(type(self))
        _, *others = self.__getstate__()
        twin.__setstate__((parts, *others))
        return twin


def listed(shapes: Iterable[Shape]) -> list[Shape]:
    """`shapes` as a list; raises where they cannot be listed."""
    try:
        return list(shapes)
    except TypeError:
        raise refuse("shapes", "must be a list of shapes", shapes) from None
