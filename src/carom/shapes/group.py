"""Groups: static shapes that are one thing, such as a brick."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from carom.checks import flag, pair, refuse, text_or_none
from carom.rows.shape import STATIC, Motion, ShapeRow
from carom.shapes.assembly import Assembly, listed
from carom.shapes.shape import Shape, Surface
from carom.spelling import spelled
from carom.turns import setting
from carom.typing import Pair, Vector


@spelled
class Group(Assembly):
    """Static shapes that are added, removed, named, masked and switched together.

    `elasticity`, `kick`, `sensor`, `layer` and `collides_with` are each part's own, unless they are set here, which
    sets them on every part and on those that are added later. So it is with `can_collide`, which tells whether any part
    meets anything, and with `once`: of a group that has it the whole switches itself off at the first bounce off any of
    its parts, as a brick does.

    A hit's shape is the part that was hit, and `part.group` leads back. Setting `position` moves all parts, and each
    may be moved by itself; what turns or travels is a `Compound`.

    Raises `InvalidArgument` for no shape at all, for what is no static shape, and for a shape that is a part already or
    in another world.

    >>> import carom
    >>> world = carom.World()
    >>> brick = world.add(carom.Group(carom.outlines.rectangle(0, 0, 2, 1), name="brick", once=True))
    >>> ball = world.add(carom.Ball((1, -1), radius=0.25, velocity=(0, 4)))
    >>> hits = world.run(1.0)
    >>> hits[0].shape.group is brick, brick.can_collide
    (True, False)
    """

    __slots__ = ()

    def __init__(
        self,
        shapes: Iterable[Shape],
        *,
        elasticity: float | None = None,
        kick: float | None = None,
        sensor: bool | None = None,
        can_collide: bool | None = None,
        once: bool | None = None,
        layer: int | None = None,
        collides_with: int | None = None,
        name: str | None = None,
        user: Any = None,
    ) -> None:
        self._parts = []
        self._surface = {}
        self.elasticity, self.kick, self.sensor, self.once = elasticity, kick, sensor, once
        self.layer, self.collides_with = layer, collides_with
        if can_collide is not None:
            self.can_collide = can_collide
        self._name = text_or_none("name", name)
        self.user = user
        parts = listed(shapes)
        if not parts:
            raise refuse("shapes", "must hold at least one shape", shapes)
        self._take("shapes[{}]", parts)

    def __repr__(self) -> str:
        return f"Group({len(self.shapes)} shapes)"

    @property
    def kind(self) -> str:
        """Always "group"; each part has its own kind."""
        return "group"

    @property
    def motion(self) -> Motion:
        """Always STATIC."""
        return Motion.STATIC

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """The parts, in the order in which they were added."""
        return tuple(self._parts)

    @property
    def position(self) -> Vector:
        """The middle of its box. Setting it moves all parts."""
        box = self.aabb
        return 0.5 * (box.left + box.right), 0.5 * (box.bottom + box.top)

    @position.setter
    @setting
    def position(self, value: Pair) -> None:
        x, y = pair("position", value)
        from_x, from_y = self.position
        places = [(part.position[0] + (x - from_x), part.position[1] + (y - from_y)) for part in self._parts]
        rows = [part._moved("position", value, p, None) for part, p in zip(self._parts, places, strict=True)]
        for part, row in zip(self._parts, rows, strict=True):
            part._write(row)

    @property
    def can_collide(self) -> bool:
        """Whether any part meets anything; set, it holds for all parts, also for those that are added later."""
        return any(part.can_collide for part in self._parts)

    @can_collide.setter
    @setting
    def can_collide(self, value: bool) -> None:
        self._set_surface("can_collide", flag("can_collide", value))

    def _part_row(self, name: str, shape: Shape) -> ShapeRow:
        row = shape._row
        if row["motion"] != STATIC:
            raise refuse(name, "must be static (a Compound is what turns and travels)", shape)
        return row

    def _set_surface(self, name: Surface, value: Any) -> None:
        super()._set_surface(name, value)
        if name == "once":
            self._tie()

    def _tie(self) -> None:
        """Let the parts switch themselves off together where that was set, each by itself where it was not.

        To be called whenever that, or the parts in the world, have changed.
        """
        ids = [part.id or 0 for part in self._parts]
        together = bool(self._surface.get("once"))
        for part, following in zip(self._parts, ids[1:] + ids[:1], strict=True):
            part._row["drops_with"] = following if together else 0
