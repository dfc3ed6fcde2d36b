"""What shapes and balls have in common: each is a view of one row, of its own or of the world that it is in."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Self

import numpy as np

from carom.checks import flag, layers, non_negative
from carom.rows.shape import KIND_NAMES, Motion
from carom.shapes.aabb import Aabb
from carom.shapes.copies import add_attributes, added_attributes
from carom.shapes.named import Named
from carom.shapes.table import Home, R, RowTable
from carom.turns import setting
from carom.typing import Vector

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.detection import Contact


_set = object.__setattr__


class Member(Named, ABC, Generic[R]):
    """A shape or ball: a view of the row `_row`, which is the only place where its state is.

    A world takes a member in with `_enter`, gives it back with `_leave`, and makes the object for a row that it
    already has with `_of_row`. Every setter checks, then writes, and where that is a change tells the world, with
    `_change`.
    """

    __slots__ = ("__weakref__", "_id", "_index", "_table", "_world", "user")

    _KIND: ClassVar[int]
    _OWN: ClassVar[tuple[str, ...]] = (*Named.__slots__, *__slots__)
    _DTYPE: ClassVar[np.dtype[Any]]

    _id: int | None
    _index: int
    _table: RowTable[R]
    _world: Home | None
    user: Any

    def _begin(self, row: R, name: str | None, user: Any) -> None:
        """Make this a lone member with a copy of `row`. The last thing that a constructor does."""
        self._stand_alone(row)
        self._name = name
        self.user = user

    def _stand_alone(self, row: R) -> None:
        """Give the member a table of its own, with a copy of `row` in it."""
        self._table = RowTable.of_row(row)
        self._index = 0
        self._id = None
        self._world = None

    # -- what a world calls ------------------------------------------------------------------------------------------

    def _enter(self, world: Home, table: RowTable[R], index: int, member_id: int) -> None:
        """Be a view of `table.rows[index]`, where the world has put a copy of the row and an id.

        From here on `_change` calls `world._changed`. The caller has made sure that the member is in no world.
        """
        # Past the look at their names, for thousands may come at once.
        _set(self, "_table", table)
        _set(self, "_index", index)
        _set(self, "_id", member_id)
        _set(self, "_world", world)

    def _leave(self) -> None:
        """Copy the row back to a table of its own, so that the object keeps its last values.

        To be called while `table.rows[index]` still holds them. What only a world can know (id, sleep) is cleared.
        """
        self._stand_alone(self._lone_row())

    @classmethod
    def _of_row(cls, world: Home, table: RowTable[R], member_id: int, index: int = -1) -> Self:
        """The object for a row that is in `table` already; nothing is checked and the row is not touched.

        `index` may be left out where `table.index` finds rows by `_id`.
        """
        member = cls.__new__(cls)
        member._table, member._index, member._id, member._world = table, index, member_id, world
        member._name = member.user = None
        return member

    @property
    def _row(self) -> R:
        """The row, as a view that can be written to."""
        return self._table.row(self)

    def _lone_row(self) -> R:
        """A copy of the row as it would be outside of any world."""
        row = self._table.copied(self)
        row["id"] = 0
        return row

    def _change(self) -> None:
        """Tell the world that the row was changed from outside."""
        if self._world is not None:
            self._world._changed(self)

    def _write(self, row: R) -> None:
        """Make `row`, which was checked, the member's row, and tell the world."""
        if self._table.write(self, row):
            self._change()

    def _put(self, field: str, value: Any) -> None:
        """Write one field, whose value was checked, and tell the world."""
        row: Any = self._row
        if row[field] != value:
            row[field] = value
            self._change()

    # -- copies: lone, whatever the original is in; the copy of a world takes in those that were copied with it ------

    def __getstate__(self) -> Any:
        """The row (an array of shape (1,)), the name, the user's own data, and what a subclass of the user's adds."""
        added = added_attributes(self, self._OWN)
        return np.array([self._lone_row()], self._DTYPE), self._name, self.user, added

    def __setstate__(self, state: Any) -> None:
        """Make this a member with the state that `__getstate__` gave: a lone one, unless a world has it already.

        The copy of a world takes the copies of its members in before they have a state, where their own data leads to
        the world.
        """
        rows, name, user, *added = state
        if getattr(self, "_world", None) is None:
            self._begin(rows[0], name, user)
        self.user = user
        for attributes in added:
            add_attributes(self, attributes)

    def _rejoin(self, world: Home, table: RowTable[R], member_id: int) -> None:
        """Make this, which need not have a state yet, the object of the row with that id, where its original was."""
        self._table, self._index, self._id, self._world = table, -1, member_id, world

    # -- what every shape and ball has -------------------------------------------------------------------------------

    @property
    def kind(self) -> str:
        """What it is: "point", "segment", "gate", "circle", "arc" or "ball"."""
        return KIND_NAMES[self._KIND]

    @property
    def id(self) -> int | None:
        """The number that its world gave it, never used twice there; None outside of a world."""
        return self._id

    @property
    def world(self) -> Any:
        """The `World` that it is in, or None."""
        return self._world

    @property
    def elasticity(self) -> float:
        """Its factor in the ratio of speeds after and before an impact; 0 or more, and above 1 adds speed."""
        return float(self._row["elasticity"])

    @elasticity.setter
    @setting
    def elasticity(self, value: float) -> None:
        self._put("elasticity", non_negative("elasticity", value))

    @property
    def sensor(self) -> bool:
        """Whether it only reports what overlaps it, and moves nothing."""
        return bool(self._row["sensor"])

    @sensor.setter
    @setting
    def sensor(self, value: bool) -> None:
        self._put("sensor", flag("sensor", value))

    @property
    def can_collide(self) -> bool:
        """Whether it meets anything at all."""
        return bool(self._row["can_collide"])

    @can_collide.setter
    @setting
    def can_collide(self, value: bool) -> None:
        self._put("can_collide", flag("can_collide", value))

    @property
    def layer(self) -> int:
        """The layers that it is on, as a mask of 32 bits."""
        return int(self._row["layer"])

    @layer.setter
    @setting
    def layer(self, value: int) -> None:
        self._put("layer", layers("layer", value))

    @property
    def collides_with(self) -> int:
        """The layers that it meets, as a mask of 32 bits; two meet iff each is on a layer that the other meets."""
        return int(self._row["collides_with"])

    @collides_with.setter
    @setting
    def collides_with(self, value: int) -> None:
        self._put("collides_with", layers("collides_with", value))

    @property
    @abstractmethod
    def motion(self) -> Motion:
        """How it moves."""

    @property
    @abstractmethod
    def aabb(self) -> Aabb:
        """The smallest box around it."""

    @property
    @abstractmethod
    def position(self) -> Vector:
        """Where it is: a point's own place, a segment's midpoint, the centre of a circle, an arc or a ball."""

    @abstractmethod
    def detect(self, ball: Ball) -> Contact | None:
        """The contact with `ball`, or None."""
