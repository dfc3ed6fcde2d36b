"""`worlds.shapes`: the shapes, compounds and groups of all copies, read and set for all at once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import checks
from carom.rows.state import MOTIONS_CHANGED
from carom.rows.tables import Rows
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.turns import having
from carom.world.entering import members_of
from carom.world.waking import note_changed

if TYPE_CHECKING:
    from carom.world.world import World
    from carom.worlds.worlds import Worlds


class CopiesOfShapes:
    """The shapes, compounds and groups of the world that was copied, in the order in which they were added there."""

    __slots__ = ("_worlds",)

    def __init__(self, worlds: Worlds) -> None:
        self._worlds = worlds

    def __len__(self) -> int:
        return len(self._worlds._base.shapes)

    def __iter__(self) -> Iterator[CopiesOfShape]:
        return (self[index] for index in range(len(self)))

    def __repr__(self) -> str:
        return f"<{len(self)} shapes in each of {len(self._worlds)} worlds>"

    def __getitem__(self, key: int | str) -> CopiesOfShape:
        """The one that `World.shapes` gives for an index or a name, in all copies; raises as that does."""
        return CopiesOfShape(self._worlds, self._worlds._base.shapes[key])


class CopiesOfShape:
    """One shape, compound or group in all copies: what is read of it has the copies as its first axis.

    What is set is a number or pair for all, or one for each copy. As with a single world, all is checked before
    anything has changed.
    """

    __slots__ = ("_columns", "_rows", "_shape", "_worlds")

    def __init__(self, worlds: Worlds, shape: Shape | Compound | Group) -> None:
        self._worlds = worlds
        self._shape = shape
        table = worlds._base._arrays.shapes
        self._rows = np.array([table.index(part) for part in members_of(shape)])
        #: Where its rows are among those of the kinematic shapes; -1 where it is static.
        moving = worlds._common.moving
        places = np.searchsorted(moving, self._rows)
        places[places == len(moving)] = 0
        self._columns = np.where(moving[places] == self._rows, places, -1) if len(moving) else np.full(len(places), -1)

    def __repr__(self) -> str:
        return f"<{self._shape!r} in each of {len(self._worlds)} worlds>"

    @property
    def name(self) -> str | None:
        """Its name."""
        return self._shape.name

    @property
    def kind(self) -> str:
        """What it is: "segment", "compound", ..."""
        return self._shape.kind

    @property
    def _first(self) -> Rows:
        """The row that says how it moves, in each copy."""
        if self._columns[0] < 0:
            row = self._worlds._base._arrays.shapes.rows[self._rows[:1]]
            return np.broadcast_to(row, (len(self._worlds),))
        return self._worlds._common.memory.moving[:, self._columns[0]]

    # -- motion ------------------------------------------------------------------------------------------------------

    @property
    def position(self) -> NDArray[np.float64]:
        """Where it is, of shape (copies, 2); a copy. To set it takes some tenths of a millisecond for each copy."""
        if self._columns[0] < 0:
            return np.tile(self._shape.position, (len(self._worlds), 1))
        return np.stack([self._first["cx"], self._first["cy"]], axis=1)

    @position.setter
    def position(self, value: ArrayLike) -> None:
        self._set_each("position", checks.array("position", value, (len(self._worlds), 2)))

    @property
    def orientation(self) -> NDArray[np.float64]:
        """How far it has turned, in radians, of shape (copies,); a copy. To set it takes as long as `position`."""
        return self._first["orientation"].copy()

    @orientation.setter
    def orientation(self, value: ArrayLike) -> None:
        self._set_each("orientation", checks.array("orientation", value, (len(self._worlds),)))

    @property
    def angular_velocity(self) -> NDArray[np.float64]:
        """How fast it turns about its pivot, in rad/s, of shape (copies,); a copy."""
        return self._first["angular_velocity"].copy()

    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None:
        given = checks.array("angular_velocity", value, (len(self._worlds),))
        self._command("angular_velocity", value, {"angular_velocity": given})

    @property
    def velocity(self) -> NDArray[np.float64]:
        """How fast it travels, in length/s, of shape (copies, 2); a copy."""
        return np.stack([self._first["velocity_x"], self._first["velocity_y"]], axis=1)

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        x, y = checks.array("velocity", value, (len(self._worlds), 2)).T
        self._command("velocity", value, {"velocity_x": x, "velocity_y": y})

    def _refuse_static(self, name: str, value: object) -> None:
        """Raise where all copies share it, as it stands."""
        if self._columns[0] < 0:
            raise checks.refuse(name, "must be that of a kinematic shape; a static one is shared by all copies", value)

    def _command(self, name: str, value: object, fields: dict[str, NDArray[np.float64]]) -> None:
        """Write speeds into the rows of all parts; what was sent somewhere rests first, as in a single world."""
        self._refuse_static(name, value)
        having(self._worlds, self._write_speeds, fields)

    def _write_speeds(self, fields: dict[str, NDArray[np.float64]]) -> None:
        common = self._worlds._common
        memory = common.memory
        changed = np.zeros(len(memory.state), np.bool_)
        # What leads a compound is enough: the others follow it as a copy is taken out.
        for column in self._columns.tolist() if common.sent else self._columns[:1].tolist():
            row = memory.moving[:, column]
            if common.sent:
                sent = row["time_left"] > 0.0
                changed |= sent
                for field in ("time_left", "velocity_x", "velocity_y", "angular_velocity"):
                    row[field][sent] = 0.0
            for field, values in fields.items():
                changed |= row[field] != values
                row[field] = values
        memory.state["wake"][changed] = MOTIONS_CHANGED

    def _set_each(self, name: str, values: NDArray[np.float64]) -> None:
        """Set what a single shape checks and works out by itself, copy by copy; nothing has changed if one refuses."""
        self._refuse_static(name, values)
        having(self._worlds, self._write_each, name, values)

    def _write_each(self, name: str, values: NDArray[np.float64]) -> None:
        memory = self._worlds._common.memory
        scratch = self._worlds._scratch()
        table = scratch._arrays.shapes
        shape: Any = scratch.object(members_of(self._shape)[0].id or 0)
        shape = shape.compound if isinstance(self._shape, Compound) else shape
        rows = memory.moving[:, self._columns].copy()
        for copy, value in enumerate(values):
            table.rows[self._rows] = rows[copy]
            setattr(shape, name, value if np.ndim(value) else float(value))
            rows[copy] = table.rows[self._rows]
        changed = (memory.moving[:, self._columns] != rows).any(axis=1)
        memory.moving[:, self._columns] = rows
        memory.state["wake"][changed] = MOTIONS_CHANGED

    # -- whether it is there -----------------------------------------------------------------------------------------

    @property
    def can_collide(self) -> NDArray[np.bool_]:
        """Whether it meets anything at all, of shape (copies,); of a compound or group, any part. A copy."""
        values = [self._switch_of(row, column) for row, column in self._parts()]
        return np.logical_or.reduce(values) if values else np.zeros(len(self._worlds), np.bool_)

    @can_collide.setter
    def can_collide(self, value: ArrayLike) -> None:
        given = checks.flags("can_collide", value, len(self._worlds))
        having(self._worlds, self._write_switches, given)

    def _parts(self) -> list[tuple[int, int]]:
        """The rows of what can be met, each with its place among the kinematic ones or -1."""
        parts = list(zip(self._rows.tolist(), self._columns.tolist(), strict=True))
        return parts[1:] if isinstance(self._shape, Compound) else parts

    def _switch_of(self, row: int, column: int) -> NDArray[np.bool_]:
        """Whether a part can be met, in each copy."""
        common = self._worlds._common
        if column >= 0:
            return np.asarray(common.memory.moving[:, column]["can_collide"] != 0)
        own = np.flatnonzero(common.switched == row)
        if len(own):
            return np.asarray(common.memory.switches[:, own[0], 0] != 0)
        return np.full(len(self._worlds), bool(self._worlds._base._arrays.shapes.rows[row]["can_collide"]))

    def _write_switches(self, values: NDArray[np.bool_]) -> None:
        """Switch all parts on or off."""
        common = self._worlds._common
        for row, column in self._parts():
            if column < 0 and row not in common.switched:
                self._worlds._switch(np.array([row], np.int32))
        changed = np.zeros(len(values), np.bool_)
        for row, column in self._parts():
            changed |= self._switch_of(row, column) != values
            if column >= 0:
                common.memory.moving[:, column]["can_collide"] = values
            else:
                common.memory.switches[:, np.flatnonzero(common.switched == row)[0], 0] = values
        note_changed(common.memory.state, changed)

    # -- what has happened -------------------------------------------------------------------------------------------

    @property
    def bounces(self) -> NDArray[np.int64]:
        """How often balls have bounced off it since the start or the last `reset`, of shape (copies,); a copy."""
        return self._counted(0)

    @property
    def entries(self) -> NDArray[np.int64]:
        """How often balls have come into it, likewise."""
        return self._counted(1)

    def _counted(self, which: int) -> NDArray[np.int64]:
        """One of the counts."""
        common = self._worlds._common
        column = int(common.columns[members_of(self._shape)[0].id or 0])
        return common.counts[:, column, which].copy()


def leaders_of(world: World, moving: NDArray[np.intp]) -> NDArray[np.int32]:
    """For each kinematic shape, given the rows of all, which of them is the first part of its compound: or itself."""
    leaders = np.arange(len(moving), dtype=np.int32)
    for shape in world.shapes:
        if isinstance(shape, Compound):
            columns = np.searchsorted(moving, [world._arrays.shapes.index(part) for part in members_of(shape)])
            leaders[columns] = columns[0]
    return leaders


def columns_of(world: World) -> NDArray[np.int64]:
    """How many shapes, compounds and groups a world has; then, by id, which of them a shape is or is part of, or -1."""
    columns = np.full(int(world._states[0]["next_id"]), -1, np.int64)
    for column, shape in enumerate(world.shapes):
        for part in members_of(shape):
            columns[part.id or 0] = column
    columns[0] = len(world.shapes)
    return columns
