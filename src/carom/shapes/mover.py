"""Motion on rails: where a shape is, how it turns about a pivot and travels, and who may change that."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypedDict, Unpack, cast

import numpy as np

from carom.checks import pair, refuse
from carom.rows.pose import derive, pose, set_before, set_initial
from carom.rows.shape import KINEMATIC, SHAPE, STATIC, Motion, ShapeRow
from carom.shapes.member import Member
from carom.shapes.on_rails import OnRails
from carom.shapes.rails import (
    MOTION,
    TIME_LEFT,
    halt,
    motion_value,
    send,
    write_motion,
)
from carom.shapes.table import Home, RowTable, put_fields
from carom.turns import setting
from carom.typing import MotionName, Pair, Vector

if TYPE_CHECKING:
    from carom.shapes.assembly import Assembly
    from carom.shapes.compound import Compound
    from carom.shapes.group import Group


class Geometry(TypedDict, total=False):
    """The fields of a row that make out its geometry, some of them for each kind."""

    cx: float
    cy: float
    radius: float
    solid: bool
    ax: float
    ay: float
    bx: float
    by: float
    dx: float
    dy: float
    start_angle: float
    end_angle: float


class Mover(OnRails, Member[ShapeRow]):
    """A member whose pose follows from its initial geometry, an orientation and a pivot; the rails of every `Shape`."""

    __slots__ = ("_whole",)

    _OWN: ClassVar[tuple[str, ...]] = (*Member._OWN, *__slots__)
    _DTYPE: ClassVar[np.dtype[Any]] = SHAPE

    _whole: Assembly | None

    def _begin(self, row: ShapeRow, name: str | None, user: Any) -> None:
        super()._begin(row, name, user)
        # The copy of a whole claims the copies of its parts, maybe before they have a state.
        self._whole = getattr(self, "_whole", None)

    @classmethod
    def _of_row(cls, world: Home, table: RowTable[ShapeRow], member_id: int, index: int = -1) -> Self:
        member = super()._of_row(world, table, member_id, index)
        member._whole = None
        return member

    def _rejoin(self, world: Home, table: RowTable[ShapeRow], member_id: int) -> None:
        super()._rejoin(world, table, member_id)
        self._whole = getattr(self, "_whole", None)

    # -- changes -----------------------------------------------------------------------------------------------------

    def _lone_row(self) -> ShapeRow:
        row = super()._lone_row()
        row["drops_with"] = 0
        return row

    def _write(self, row: ShapeRow) -> None:
        before = self._table.copied(self)
        if self._table.write(self, row) and self._world is not None:
            self._world._moved(self, before)

    def _check(self, row: ShapeRow, name: str, value: object) -> None:
        """Raise where the geometry of a row is no shape, with argument `name` and its `value` to blame."""
        box = row["left"], row["bottom"], row["right"], row["top"]
        ends = row["ax"], row["ay"], row["bx"], row["by"], row["length"]
        if not all(map(isfinite, (*box, *ends, row["cx"], row["cy"], row["pivot_x"], row["pivot_y"]))):
            raise refuse(name, "must leave the shape's place and box finite", value)

    @property
    def _carried(self) -> Sequence[Mover]:
        return [self]

    def _is_kinematic(self) -> bool:
        """Whether it moves on rails."""
        at = self._table.at(self)
        return self._table.octets[8 * at + MOTION] == KINEMATIC

    def _halted(self) -> int:
        """The word at which the row begins, which is let rest where it is if `move_to` has sent it somewhere."""
        at = self._table.at(self)
        if self._table.floats[at + TIME_LEFT] > 0.0:
            halt(self._row)
        return at

    def _refuse_part(self, name: str, value: object) -> None:
        """Raise where the shape is part of a compound, which alone says where its parts are."""
        whole = self._whole
        if whole is not None and whole.kind == "compound":
            raise refuse(name, "must be left to the compound that the shape is part of", value)

    def _still_row(self) -> ShapeRow:
        """A copy of the row, at rest where it is if `move_to` has sent it somewhere."""
        row = self._table.copied(self)
        halt(row)
        return row

    def _sent(self, row: ShapeRow, position: object, pivot: Vector, orientation: float, dt: float) -> ShapeRow:
        """The row, set going to a pivot and an orientation; raises, `position` to blame, where it cannot be there."""
        send(row, pivot, orientation, dt)
        there = row.copy()
        there["pivot_x"], there["pivot_y"] = pivot
        there["orientation"] = orientation
        self._posed(there, "position", position)
        row["target_x"], row["target_y"] = there["cx"], there["cy"]
        return row

    def _set_geometry(self, name: str, value: object, **fields: Unpack[Geometry]) -> None:
        """Write fields of the current geometry, which becomes the initial one, or raise.

        A pivot that is the shape's position stays so.
        """
        self._refuse_part(name, value)
        row = self._still_row()
        centred = row["pivot_x"] == row["cx"] and row["pivot_y"] == row["cy"]
        put_fields(row, fields)
        derive(row)
        if centred:
            row["pivot_x"], row["pivot_y"] = row["cx"], row["cy"]
        self._check(row, name, value)
        set_initial(row)
        self._write(row)

    def _moved(self, name: str, value: object, place: Vector, pivot: Vector | None) -> ShapeRow:
        """A copy of the row moved to `place`, initial there, with its pivot at `pivot`, or at its position for None.

        Raises where that fails.
        """
        row = self._still_row()
        from_x, from_y = self.position
        x, y = place
        row["cx"], row["cy"] = x, y
        row["ax"], row["bx"] = float(row["ax"]) + (x - from_x), float(row["bx"]) + (x - from_x)
        row["ay"], row["by"] = float(row["ay"]) + (y - from_y), float(row["by"]) + (y - from_y)
        derive(row)
        row["pivot_x"], row["pivot_y"] = (row["cx"], row["cy"]) if pivot is None else pivot
        self._check(row, name, value)
        set_initial(row)
        return row

    def _hung(self, name: str, value: object, x: float, y: float) -> ShapeRow:
        """A copy of the row with its pivot at (x, y), and the shape as it stands initial; raises where that fails."""
        row = self._still_row()
        row["pivot_x"], row["pivot_y"] = x, y
        self._check(row, name, value)
        set_initial(row)
        return row

    def _turned(self, name: str, value: object, x: float, y: float, angle: float) -> ShapeRow:
        """A copy of the row with its initial geometry turned by `angle` about (x, y); raises where that fails.

        What has travelled since takes its initial geometry along, and its pivot has the same place in that until
        another pivot is given: so to turn it to where it is turned already changes nothing.
        """
        row = self._still_row()
        low, high = float(row["turn_low"]), float(row["turn_high"])
        if row["turn_limited"] and not low <= angle <= high:
            raise refuse(name, f"must be within turn_limits={(low, high)}", value)
        if (row["pivot_x"], row["pivot_y"]) != (x, y):
            row["hinge_x"] = x - (float(row["pivot_x"]) - float(row["hinge_x"]))
            row["hinge_y"] = y - (float(row["pivot_y"]) - float(row["hinge_y"]))
            row["pivot_x"], row["pivot_y"] = x, y
        row["orientation"] = angle
        return self._posed(row, name, value)

    def _posed(self, row: ShapeRow, name: str, value: object) -> ShapeRow:
        """The row, put where its orientation and pivot say and as if at rest there; raises where that fails."""
        pose(row)
        self._check(row, name, value)
        set_before(row)
        row["spin"] = 0.0
        return row

    # -- place -------------------------------------------------------------------------------------------------------

    @property
    def position(self) -> Vector:
        """Where it is: a point's own place, a segment's midpoint, a circle's or an arc's centre. Setting it moves it.

        The pivot moves along.
        """
        row = self._row
        return float(row["cx"]), float(row["cy"])

    @position.setter
    @setting
    def position(self, value: Pair) -> None:
        self._put_at("position", value)

    def _put_at(self, name: str, value: Pair) -> None:
        """Move the shape so that its position is `value`, and its pivot with it."""
        x, y = pair(name, value)
        self._refuse_part(name, value)
        from_x, from_y = self.position
        pivot_x, pivot_y = self.pivot
        # A pivot that is the position is to stay so to the bit, although rounding may put a segment's beside `value`.
        centred = (pivot_x, pivot_y) == (from_x, from_y)
        pivot = None if centred else (pivot_x + (x - from_x), pivot_y + (y - from_y))
        self._write(self._moved(name, value, (x, y), pivot))

    @property
    def pivot(self) -> Vector:
        """The place about which it turns; it travels with the shape."""
        row = self._row
        return float(row["pivot_x"]), float(row["pivot_y"])

    @pivot.setter
    @setting
    def pivot(self, value: Pair) -> None:
        x, y = pair("pivot", value)
        self._refuse_part("pivot", value)
        self._write(self._hung("pivot", value, x, y))

    def _restored(self) -> ShapeRow:
        """A copy of the row at its initial geometry and pivot."""
        row = self._still_row()
        row["hinge_x"], row["hinge_y"] = row["initial_pivot_x"], row["initial_pivot_y"]
        row["pivot_x"], row["pivot_y"] = row["initial_pivot_x"], row["initial_pivot_y"]
        row["orientation"] = 0.0
        return self._posed(row, "reset", None)

    # -- motion ------------------------------------------------------------------------------------------------------

    @property
    def motion(self) -> Motion:
        """How it moves: STATIC or KINEMATIC. Takes their names too."""
        return Motion(int(self._row["motion"]))

    @motion.setter
    @setting
    def motion(self, value: MotionName | Motion) -> None:
        if self.group is not None and motion_value(value) != STATIC:
            raise refuse("motion", "must stay 'static' for a part of a group", value)
        self._refuse_part("motion", value)
        row = self._table.copied(self)
        write_motion(row, value)
        self._write(row)

    @property
    def compound(self) -> Compound | None:
        """The compound that it is part of, or None."""
        return cast("Compound", self._whole) if self._whole is not None and self._whole.kind == "compound" else None

    @property
    def group(self) -> Group | None:
        """The group that it is part of, or None."""
        return cast("Group", self._whole) if self._whole is not None and self._whole.kind == "group" else None
