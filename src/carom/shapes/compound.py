"""Compounds: shapes that turn and travel as one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from copy import copy
from typing import Any, Self

from carom.checks import flag, layers, non_negative, pair, refuse, text_or_none
from carom.geometry.vector import length
from carom.rows.pose import set_initial
from carom.rows.shape import KINEMATIC, Motion, ShapeRow
from carom.shapes.aabb import Aabb
from carom.shapes.ball import Ball
from carom.shapes.copies import add_attributes, added_attributes
from carom.shapes.detection import Contact
from carom.shapes.on_rails import OnRails
from carom.shapes.point import Point
from carom.shapes.shape import Shape, Surface
from carom.spelling import spelled
from carom.turns import changing
from carom.typing import Pair, Vector

#: The attributes of a compound that are no user's.
_OWN = ("_name", "_parts", "_surface", "user")


def _surface(name: Surface, check: Callable[[str, Any], Any]) -> property:
    """The property of a compound that sets `name`, once `check` has passed its value, on all of its parts."""

    def read(compound: Compound) -> Any:
        return compound._surface.get(name)

    @changing
    def write(compound: Compound, value: Any) -> None:
        if value is None:
            compound._surface.pop(name, None)
            return
        compound._surface[name] = check(name, value)
        for shape in compound.shapes:
            shape._put(name, compound._surface[name])

    return property(
        read, write, doc=f"The {name} that was set for all parts, also those added later; None leaves it to each part."
    )


@spelled
class Compound(OnRails):
    """A list of shapes that turn and travel as one about a pivot.

    Its parts become kinematic, and move as the compound says: `pivot`, `orientation`, `angular_velocity` (rad/s),
    `rotating`, `turn_limits` (radians) and `velocity` (length/s) are set here, not on the parts. A part is given as it
    lies at orientation 0: one that is added to a compound that has turned or travelled goes the same way, as if it had
    been there from the start. `elasticity`, `kick`, `sensor`, `can_collide`, `once`, `layer` and `collides_with` are
    each part's own, unless they are set here, which sets them on every part and on those that are added later.

    A hit's shape is the part that was hit, and `part.compound` leads back. `center_point` is a part too: a point that
    starts at the pivot and collides with nothing. Raises `InvalidArgument` for what is no shape, and for a shape that
    is a part already or in another world.

    >>> import carom
    >>> vane = carom.Compound([carom.Segment((1, 0), (3, 0)), carom.Point((3, 0))], pivot=(0, 0), angular_velocity=2.0)
    >>> vane.rotate((0, 0), 3.141592653589793 / 2)
    >>> [round(x, 9) for x in vane.shapes[1].position]
    [0.0, 3.0]
    """

    __slots__ = ("__weakref__", "_parts", "_surface", "user")

    _parts: list[Shape]

    elasticity = _surface("elasticity", non_negative)
    kick = _surface("kick", non_negative)
    sensor = _surface("sensor", flag)
    can_collide = _surface("can_collide", flag)
    once = _surface("once", flag)
    layer = _surface("layer", layers)
    collides_with = _surface("collides_with", layers)

    def __init__(
        self,
        shapes: Iterable[Shape],
        pivot: Pair,
        *,
        elasticity: float | None = None,
        kick: float | None = None,
        sensor: bool | None = None,
        can_collide: bool | None = None,
        once: bool | None = None,
        layer: int | None = None,
        collides_with: int | None = None,
        angular_velocity: float = 0.0,
        rotating: bool = True,
        turn_limits: Pair | None = None,
        velocity: Pair = (0.0, 0.0),
        name: str | None = None,
        user: Any = None,
    ) -> None:
        center_point = Point(
            pair("pivot", pivot),
            motion=Motion.KINEMATIC,
            can_collide=False,
            angular_velocity=angular_velocity,
            rotating=rotating,
            turn_limits=turn_limits,
            velocity=velocity,
        )
        self._parts = [center_point]
        self._surface: dict[Surface, Any] = {}
        self.elasticity, self.kick, self.sensor, self.can_collide = elasticity, kick, sensor, can_collide
        self.once, self.layer, self.collides_with = once, layer, collides_with
        self._name = text_or_none("name", name)
        self.user = user
        self._take("shapes[{}]", _listed(shapes))
        center_point._compound = self

    def __repr__(self) -> str:
        return f"Compound({len(self.shapes)} shapes, pivot={self.pivot})"

    # -- how it moves ------------------------------------------------------------------------------------------------

    @property
    def _carried(self) -> Sequence[Shape]:
        return self._parts

    @property
    def center_point(self) -> Shape:
        """The point that starts at the pivot, moves with the compound and collides with nothing."""
        return self._parts[0]

    @property
    def motion(self) -> Motion:
        """Always KINEMATIC."""
        return Motion.KINEMATIC

    @property
    def position(self) -> Vector:
        """Where its `center_point` is. Setting it moves all parts and the pivot, and makes that their initial place."""
        return self.center_point.position

    @position.setter
    @changing
    def position(self, value: Pair) -> None:
        x, y = pair("position", value)
        from_x, from_y = self.position
        pivot_x, pivot_y = self.pivot
        pivot = pivot_x + (x - from_x), pivot_y + (y - from_y)
        places = [(part.position[0] + (x - from_x), part.position[1] + (y - from_y)) for part in self._parts]
        self._put_rows([part._moved("position", value, p, pivot) for part, p in zip(self._parts, places, strict=True)])

    @property
    def pivot(self) -> Vector:
        """The place about which it turns. Setting it makes the compound as it stands the initial one."""
        return self.center_point.pivot

    @pivot.setter
    @changing
    def pivot(self, value: Pair) -> None:
        x, y = pair("pivot", value)
        rows = [part._hung("pivot", value, x, y) for part in self._parts]
        if (x, y) != self.pivot:
            rows[0] = self.center_point._moved("pivot", value, (x, y), (x, y))
        self._put_rows(rows)

    @property
    def orientation(self) -> float:
        """How far it has turned since its initial pose, in radians. Setting it turns it about its pivot."""
        return self.center_point.orientation

    @orientation.setter
    @changing
    def orientation(self, value: float) -> None:
        self._turn("orientation", value, *self.pivot)

    # -- parts -------------------------------------------------------------------------------------------------------

    @property
    def kind(self) -> str:
        """Always "compound"; each part has its own kind."""
        return "compound"

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """The parts in the order in which they were added, without the `center_point`."""
        return tuple(self._parts[1:])

    def __contains__(self, shape: object) -> bool:
        return isinstance(shape, Shape) and shape.compound is self

    @changing
    def add(self, shape: Shape) -> Shape:
        """`shape`, now a part: what was set on the compound holds for it too, and it is in the compound's world.

        Raises `InvalidArgument` for what is no shape, and for a shape that is a part already or in another world.
        """
        self._take("shape", [shape])
        if self.world is not None:
            self.world._take_part(shape)
        return shape

    def _take(self, name: str, shapes: list[Shape]) -> None:
        """Make parts of shapes, all or none; `name` is what to call the one at a place in errors."""
        rows = [self._part_row(name.format(place), shape) for place, shape in enumerate(shapes)]
        if len({id(shape) for shape in shapes}) < len(shapes):
            raise refuse("shapes", "must not hold a shape twice", shapes)
        for shape, row in zip(shapes, rows, strict=True):
            shape._write(row)
            shape._compound = self
            self._parts.append(shape)
            for name, value in self._surface.items():
                shape._put(name, value)

    def _part_row(self, name: str, shape: Shape) -> ShapeRow:
        """The row that `shape` has as a part of this compound; raises where it cannot be one."""
        if not isinstance(shape, Shape):
            raise refuse(name, "must be a Point, a Segment, a Gate, a Circle or an Arc", shape)
        if shape.compound is not None:
            raise refuse(name, "must not be part of a compound already", shape)
        if shape.world is not None and shape.world is not self.world:
            raise refuse(name, "must not be in another world than the compound", shape)
        row, center = shape._row.copy(), self.center_point._row
        row["motion"] = KINEMATIC
        row["pivot_x"], row["pivot_y"] = center["initial_pivot_x"], center["initial_pivot_y"]
        set_initial(row)
        row["orientation"] = center["orientation"]
        row["hinge_x"], row["hinge_y"] = center["hinge_x"], center["hinge_y"]
        row["pivot_x"], row["pivot_y"] = center["pivot_x"], center["pivot_y"]
        if center["time_left"] > 0.0:
            pivot = float(center["target_pivot_x"]), float(center["target_pivot_y"])
            shape._sent(row, shape, pivot, float(center["target_orientation"]), float(center["time_left"]))
        for field in ("angular_velocity", "velocity_x", "velocity_y", "turn_low", "turn_high", "time_left"):
            row[field] = center[field]
        row["rotating"], row["turn_limited"] = center["rotating"], center["turn_limited"]
        return shape._posed(row, name, shape)

    # -- who it is ---------------------------------------------------------------------------------------------------

    @property
    def id(self) -> int | None:
        """The number that its world gave its `center_point`; None outside of a world."""
        return self.center_point.id

    @property
    def world(self) -> Any:
        """The `World` that it is in, or None."""
        return self.center_point.world

    # -- what it meets -----------------------------------------------------------------------------------------------

    @property
    def aabb(self) -> Aabb:
        """The smallest box around its parts; around its `center_point`, where it has none."""
        boxes = [shape.aabb for shape in self.shapes] or [self.center_point.aabb]
        return Aabb(
            min(box.left for box in boxes),
            min(box.bottom for box in boxes),
            max(box.right for box in boxes),
            max(box.top for box in boxes),
        )

    def closest_point(self, p: Pair) -> Vector:
        """The point of its parts that is nearest to `p`; its position, where it has none."""
        x, y = pair("p", p)
        points = [shape.closest_point((x, y)) for shape in self.shapes] or [self.position]
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
        return self._parts, self._surface, self._name, self.user, added_attributes(self, _OWN)

    def __setstate__(self, state: Any) -> None:
        """Make this a compound with the state that `__getstate__` gave."""
        parts, surface, self._name, self.user, added = state
        self._parts, self._surface = list(parts), dict(surface)
        for part in self._parts:
            part._compound = self
        add_attributes(self, added)

    def __copy__(self) -> Self:
        return self._like([copy(part) for part in self._parts])

    def _like(self, parts: list[Shape]) -> Self:
        """A compound of other parts that is this one in all else."""
        twin = type(self).__new__(type(self))
        _, *others = self.__getstate__()
        twin.__setstate__((parts, *others))
        return twin


def _listed(shapes: Iterable[Shape]) -> list[Shape]:
    """`shapes` as a list; raises where they cannot be listed."""
    try:
        return list(shapes)
    except TypeError:
        raise refuse("shapes", "must be a list of shapes", shapes) from None
