"""Motion on rails: where a shape is, how it turns about a pivot and travels, and who may change that."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypedDict, Unpack

import numpy as np

from carom.checks import number, pair, positive, refuse
from carom.rows.pose import acting_spin, derive, pose, set_before, set_initial, surface_velocity
from carom.rows.shape import KINEMATIC, SHAPE, Motion, ShapeRow
from carom.shapes.member import Member
from carom.shapes.rails import (
    halt,
    send,
    target_orientation,
    target_pivot,
    write_angular_velocity,
    write_motion,
    write_rotating,
    write_turn_limits,
    write_velocity,
)
from carom.shapes.table import Home, RowTable, put_fields
from carom.spelling import spelled
from carom.turns import changing
from carom.typing import MotionName, Pair, Vector

if TYPE_CHECKING:
    from carom.shapes.compound import Compound


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


class Mover(Member[ShapeRow]):
    """A member whose pose follows from its initial geometry, an orientation and a pivot; the rails of every `Shape`.

    What changes more than one field does so on a copy of the row, which is checked as a whole before it is written.
    """

    __slots__ = ("_compound",)

    _OWN: ClassVar[tuple[str, ...]] = (*Member._OWN, *__slots__)
    _DTYPE: ClassVar[np.dtype[Any]] = SHAPE

    _compound: Compound | None

    def _begin(self, row: ShapeRow, name: str | None, user: Any) -> None:
        super()._begin(row, name, user)
        # The copy of a compound claims the copies of its parts, maybe before they have a state.
        self._compound = getattr(self, "_compound", None)

    @classmethod
    def _of_row(cls, world: Home, table: RowTable[ShapeRow], member_id: int, index: int = -1) -> Self:
        member = super()._of_row(world, table, member_id, index)
        member._compound = None
        return member

    def _rejoin(self, world: Home, table: RowTable[ShapeRow], member_id: int) -> None:
        super()._rejoin(world, table, member_id)
        self._compound = getattr(self, "_compound", None)

    # -- changes -----------------------------------------------------------------------------------------------------

    def _check(self, row: ShapeRow, name: str, value: object) -> None:
        """Raise where the geometry of a row is no shape, with argument `name` and its `value` to blame."""
        box = row["left"], row["bottom"], row["right"], row["top"]
        ends = row["ax"], row["ay"], row["bx"], row["by"], row["length"]
        if not all(map(isfinite, (*box, *ends, row["cx"], row["cy"], row["pivot_x"], row["pivot_y"]))):
            raise refuse(name, "must leave the shape's place and box finite", value)

    def _refuse_part(self, name: str, value: object) -> None:
        """Raise where the shape is part of a compound, which alone says where its parts are."""
        if self._compound is not None:
            raise refuse(name, "must be left to the compound that the shape is part of", value)

    def _still_row(self) -> ShapeRow:
        """A copy of the row, at rest where it is if `move_to` has sent it somewhere."""
        row = self._row.copy()
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
    @changing
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
    @changing
    def pivot(self, value: Pair) -> None:
        x, y = pair("pivot", value)
        self._refuse_part("pivot", value)
        self._write(self._hung("pivot", value, x, y))

    @property
    def orientation(self) -> float:
        """How far it has turned since its initial geometry, in radians; not brought to any range."""
        return float(self._row["orientation"])

    @changing
    def rotate(self, pivot: Pair, angle: float) -> None:
        """Turn the initial geometry by `angle` radians about `pivot`, which becomes the shape's pivot.

        Always from the initial geometry, so a million small turns accumulate no drift; a shape that has travelled is
        turned where it is. Raises `InvalidArgument` for a static shape, a part of a compound, and an angle beyond the
        turn limits.

        >>> import carom
        >>> hand = carom.Segment((0, 0), (2, 0), motion="kinematic")
        >>> hand.rotate((0, 0), 3.141592653589793 / 2)
        >>> hand.orientation, hand.length
        (1.5707963267948966, 2.0)
        """
        x, y = pair("pivot", pivot)
        turn = number("angle", angle)
        self._refuse_part("angle", angle)
        if self._row["motion"] != KINEMATIC:
            raise refuse("motion", "must be 'kinematic' for a shape that is to turn", "static")
        self._write(self._turned("angle", angle, x, y, turn))

    @changing
    def reset(self) -> None:
        """Restore the initial geometry and pivot, bit for bit, and with them its place. What moves it stays set."""
        self._refuse_part("reset", self)
        self._write(self._restored())

    def _restored(self) -> ShapeRow:
        """A copy of the row at its initial geometry and pivot."""
        row = self._still_row()
        row["hinge_x"], row["hinge_y"] = row["initial_pivot_x"], row["initial_pivot_y"]
        row["pivot_x"], row["pivot_y"] = row["initial_pivot_x"], row["initial_pivot_y"]
        row["orientation"] = 0.0
        return self._posed(row, "reset", None)

    # -- motion ------------------------------------------------------------------------------------------------------

    def _set_motion(self, name: str, write: Callable[[ShapeRow, Any], None], value: Any) -> None:
        """Have `write` check and write what was set of the shape's motion; parts of compounds refuse it."""
        self._refuse_part(name, value)
        write(self._row, value)
        self._change()

    @spelled
    @changing
    def move_to(self, position: Pair, dt: float, orientation: float | None = None) -> None:
        """Set the velocity and spin that bring the shape to a place in `dt` seconds, after which it rests there.

        It comes there exactly, whatever the steps, and pushes balls as anything does that moves; `position =` puts it
        there at once, onto whatever is there. Called again, it goes on from where it is. Whatever else is set of its
        place or motion before it arrives lets it rest where it is.

        Args:
            position: Where its `position` is to be; its pivot travels there straight.
            dt: Seconds until then, from now; positive. The length of a step for what follows the mouse.
            orientation: What its `orientation` is to be, in radians; None keeps the one that it has.

        Raises:
            InvalidArgument: The shape is static or part of a compound, `dt` is not positive or too short for finite
                speeds, or the orientation is beyond the turn limits or not to be reached because `rotating` is off.

        >>> import carom
        >>> world = carom.World(detection="continuous")
        >>> paddle = world.add(carom.Segment((-1, 0), (1, 0), motion="kinematic"))
        >>> paddle.move_to((3, 0.5), dt=0.1)
        >>> hits = world.run(0.2)
        >>> paddle.position, paddle.velocity
        ((3.0, 0.5), (0.0, 0.0))
        """
        x, y = pair("position", position)
        duration = positive("dt", dt)
        self._refuse_part("position", position)
        row = self._row
        if row["motion"] != KINEMATIC:
            raise refuse("motion", "must be 'kinematic' for a shape that is to move", "static")
        turn = target_orientation(row, orientation)
        sent = self._sent(row.copy(), position, target_pivot(row, x, y, turn), turn, duration)
        sent["target_x"], sent["target_y"] = x, y
        self._write(sent)

    @property
    def motion(self) -> Motion:
        """How it moves: STATIC or KINEMATIC. Takes their names too."""
        return Motion(int(self._row["motion"]))

    @motion.setter
    @changing
    def motion(self, value: MotionName | Motion) -> None:
        self._set_motion("motion", write_motion, value)

    @property
    def angular_velocity(self) -> float:
        """How fast it turns about its pivot, in rad/s; becomes 0 at a stop."""
        return float(self._row["angular_velocity"])

    @angular_velocity.setter
    @changing
    def angular_velocity(self, value: float) -> None:
        self._set_motion("angular_velocity", write_angular_velocity, value)

    @property
    def rotating(self) -> bool:
        """Whether the angular velocity acts."""
        return bool(self._row["rotating"])

    @rotating.setter
    @changing
    def rotating(self, value: bool) -> None:
        self._set_motion("rotating", write_rotating, value)

    @property
    def turn_limits(self) -> tuple[float, float] | None:
        """The stops `(low, high)` of its orientation, in radians, or None. They hold 0 and the orientation."""
        row = self._row
        return (float(row["turn_low"]), float(row["turn_high"])) if row["turn_limited"] else None

    @turn_limits.setter
    @changing
    def turn_limits(self, value: Pair | None) -> None:
        self._set_motion("turn_limits", write_turn_limits, value)

    @property
    def velocity(self) -> Vector:
        """How fast its pivot, and it with that, travels, in length/s."""
        row = self._row
        return float(row["velocity_x"]), float(row["velocity_y"])

    @velocity.setter
    @changing
    def velocity(self, value: Pair) -> None:
        self._set_motion("velocity", write_velocity, value)

    def surface_velocity(self, p: Pair) -> Vector:
        """The velocity of the shape's matter at `p`, in length/s: velocity + ω·perp(p - pivot); (0, 0) if static."""
        x, y = pair("p", p)
        row = self._row
        return surface_velocity(row, acting_spin(row), x, y, 0.0)

    @property
    def compound(self) -> Compound | None:
        """The compound that it is part of, or None."""
        return self._compound
