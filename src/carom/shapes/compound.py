"""Compounds: shapes that turn and travel as one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from carom.checks import pair, text_or_none
from carom.rows.pose import set_initial
from carom.rows.shape import KINEMATIC, Motion, ShapeRow
from carom.shapes.assembly import Assembly, listed
from carom.shapes.on_rails import OnRails
from carom.shapes.point import Point
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.turns import setting
from carom.typing import Pair, Vector


@spelled
class Compound(Assembly, OnRails):
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

    __slots__ = ()

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
        self._surface = {}
        self.elasticity, self.kick, self.sensor, self.can_collide = elasticity, kick, sensor, can_collide
        self.once, self.layer, self.collides_with = once, layer, collides_with
        self._name = text_or_none("name", name)
        self.user = user
        self._take("shapes[{}]", listed(shapes))
        center_point._whole = self

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
    @setting
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
    @setting
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
    @setting
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

    def _part_row(self, name: str, shape: Shape) -> ShapeRow:
        row, center = shape._table.copied(shape), self.center_point._row
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
