"""Groups: shapes that turn and travel as one, told so in one place."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from carom.checks import number, pair, positive
from carom.rows.shape import Motion, ShapeRow
from carom.shapes.named import Named
from carom.shapes.rails import (
    target_orientation,
    target_pivot,
    write_angular_velocity,
    write_rotating,
    write_turn_limits,
    write_velocity,
)
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.turns import changing
from carom.typing import Pair, Vector


class Group(Named):
    """Kinematic shapes of one pivot, orientation and motion; what every `Compound` is.

    The first of them, the `center_point`, is the one that is asked how all of them move.
    """

    __slots__ = ("_parts",)

    _parts: list[Shape]

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
        self._write([part._moved("position", value, p, pivot) for part, p in zip(self._parts, places, strict=True)])

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
        self._write(rows)

    @property
    def orientation(self) -> float:
        """How far it has turned since its initial pose, in radians. Setting it turns it about its pivot."""
        return self.center_point.orientation

    @orientation.setter
    @changing
    def orientation(self, value: float) -> None:
        self._turn("orientation", value, *self.pivot)

    @changing
    def rotate(self, pivot: Pair, angle: float) -> None:
        """Turn all parts from their initial geometry by `angle` radians about `pivot`, which becomes the pivot.

        What has travelled is turned where it is. Raises `InvalidArgument` for an angle beyond the turn limits.
        """
        self._turn("angle", angle, *pair("pivot", pivot))

    def _turn(self, name: str, value: float, x: float, y: float) -> None:
        """Turn all parts by the angle `value` about (x, y)."""
        angle = number(name, value)
        self._write([part._turned(name, value, x, y, angle) for part in self._parts])

    @spelled
    @changing
    def move_to(self, position: Pair, dt: float, orientation: float | None = None) -> None:
        """Set the velocity and spin that bring it to a place in `dt` seconds, after which it rests there, exactly.

        Whatever else is set of its place or motion before it arrives lets it rest where it is.

        Args:
            position: Where its `position`, the `center_point`, is to be; its pivot travels there straight.
            dt: Seconds until then, from now; positive. The length of a step for what follows the mouse.
            orientation: What its `orientation` is to be, in radians; None keeps the one that it has.

        Raises:
            InvalidArgument: `dt` is not positive or too short for finite speeds, or the orientation is beyond the turn
                limits or not to be reached because `rotating` is off.
        """
        x, y = pair("position", position)
        duration = positive("dt", dt)
        row = self.center_point._row
        turn = target_orientation(row, orientation)
        pivot = target_pivot(row, x, y, turn)
        rows = [part._sent(part._row.copy(), position, pivot, turn, duration) for part in self._parts]
        rows[0]["target_x"], rows[0]["target_y"] = x, y
        self._write(rows)

    @changing
    def reset(self) -> None:
        """Restore the initial geometry of all parts, and the initial pivot, bit for bit, and with them their place."""
        self._write([part._restored() for part in self._parts])

    def _write(self, rows: list[ShapeRow]) -> None:
        """Write the checked rows of all parts."""
        for part, row in zip(self._parts, rows, strict=True):
            part._write(row)

    def _forward(self, write: Callable[[ShapeRow, Any], None], value: Any) -> None:
        """Have `write` set `value` on all parts; the first one refuses before anything has changed."""
        for part in self._parts:
            write(part._row, value)
            part._change()

    @property
    def angular_velocity(self) -> float:
        """How fast it turns about its pivot, in rad/s; becomes 0 at a stop."""
        return self.center_point.angular_velocity

    @angular_velocity.setter
    @changing
    def angular_velocity(self, value: float) -> None:
        self._forward(write_angular_velocity, value)

    @property
    def rotating(self) -> bool:
        """Whether the angular velocity acts."""
        return self.center_point.rotating

    @rotating.setter
    @changing
    def rotating(self, value: bool) -> None:
        self._forward(write_rotating, value)

    @property
    def turn_limits(self) -> tuple[float, float] | None:
        """The stops `(low, high)` of its orientation, in radians, or None."""
        return self.center_point.turn_limits

    @turn_limits.setter
    @changing
    def turn_limits(self, value: Pair | None) -> None:
        self._forward(write_turn_limits, value)

    @property
    def velocity(self) -> Vector:
        """How fast its pivot, and it with that, travels, in length/s."""
        return self.center_point.velocity

    @velocity.setter
    @changing
    def velocity(self, value: Pair) -> None:
        self._forward(write_velocity, value)

    def surface_velocity(self, p: Pair) -> Vector:
        """The velocity of the compound's matter at `p`, in length/s."""
        return self.center_point.surface_velocity(p)
