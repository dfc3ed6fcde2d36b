"""What a user tells of motion on rails, to a single shape and to a compound alike."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from carom.checks import number, pair, positive, refuse
from carom.rows.pose import acting_spin, surface_velocity
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.shapes.named import Named
from carom.shapes.rails import (
    ANGULAR_VELOCITY,
    MOTION,
    TIME_LEFT,
    VELOCITY_X,
    VELOCITY_Y,
    not_kinematic,
    target_orientation,
    target_pivot,
    write_rotating,
    write_turn_limits,
)
from carom.spelling import spelled
from carom.turns import changing, setting
from carom.typing import Pair, Vector

if TYPE_CHECKING:
    from carom.shapes.mover import Mover


class OnRails(Named):
    """What turns about a pivot and travels with it: one shape, or several that do so as one.

    What changes more than one field does so on copies of the rows, which are all checked before one is written.
    """

    __slots__ = ()

    @property
    @abstractmethod
    def _carried(self) -> Sequence[Mover]:
        """The shapes that move; the first one is asked how."""

    def _refuse_part(self, name: str, value: object) -> None:
        """Raise where something else says how this moves: nothing does, but for parts of compounds."""

    def _put_rows(self, rows: Sequence[ShapeRow]) -> None:
        """Write the checked rows of all shapes."""
        for shape, row in zip(self._carried, rows, strict=True):
            shape._write(row)

    # -- place -------------------------------------------------------------------------------------------------------

    @property
    def orientation(self) -> float:
        """How far it has turned since its initial geometry, in radians; not brought to any range."""
        return float(self._carried[0]._row["orientation"])

    @changing
    def rotate(self, pivot: Pair, angle: float) -> None:
        """Turn the initial geometry by `angle` radians about `pivot`, which becomes the pivot.

        Always from the initial geometry, so a million small turns accumulate no drift; what has travelled is turned
        where it is. Raises `InvalidArgument` for a static shape, a part of a compound, and an angle beyond the turn
        limits.

        >>> import carom
        >>> hand = carom.Segment((0, 0), (2, 0), motion="kinematic")
        >>> hand.rotate((0, 0), 3.141592653589793 / 2)
        >>> hand.orientation, hand.length
        (1.5707963267948966, 2.0)
        """
        self._turn("angle", angle, *pair("pivot", pivot))

    def _turn(self, name: str, value: float, x: float, y: float) -> None:
        """Turn all shapes by the angle `value` about (x, y)."""
        angle = number(name, value)
        self._refuse_part(name, value)
        self._refuse_static("turn")
        self._put_rows([shape._turned(name, value, x, y, angle) for shape in self._carried])

    def _refuse_static(self, what: str) -> None:
        """Raise for a static shape, of which it was asked what only a kinematic one does."""
        if self._carried[0]._row["motion"] != KINEMATIC:
            raise refuse("motion", f"must be 'kinematic' for a shape that is to {what}", "static")

    @changing
    def reset(self) -> None:
        """Restore the initial geometry and pivot, bit for bit, and with them its place. What moves it stays set."""
        self._refuse_part("reset", self)
        self._put_rows([shape._restored() for shape in self._carried])

    # -- motion ------------------------------------------------------------------------------------------------------

    @spelled
    @changing
    def move_to(self, position: Pair, dt: float, orientation: float | None = None) -> None:
        """Set the velocity and spin that bring it to a place in `dt` seconds, after which it rests there.

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
        >>> world = carom.World()
        >>> paddle = world.add(carom.Segment((-1, 0), (1, 0), motion="kinematic"))
        >>> paddle.move_to((3, 0.5), dt=0.1)
        >>> hits = world.run(0.2)
        >>> paddle.position, paddle.velocity
        ((3.0, 0.5), (0.0, 0.0))
        """
        x, y = pair("position", position)
        duration = positive("dt", dt)
        self._refuse_part("position", position)
        self._refuse_static("move")
        row = self._carried[0]._row
        turn = target_orientation(row, orientation)
        pivot = target_pivot(row, x, y, turn)
        rows = [shape._sent(shape._table.copied(shape), position, pivot, turn, duration) for shape in self._carried]
        rows[0]["target_x"], rows[0]["target_y"] = x, y
        self._put_rows(rows)

    def _set_motion(self, name: str, write: Callable[[ShapeRow, Any], None], value: Any) -> None:
        """Have `write` check and write what was set of the motion; it refuses the first row before any has changed."""
        self._refuse_part(name, value)
        movers = self._carried
        before = [mover._table.copied(mover) for mover in movers]
        for mover in movers:
            write(mover._row, value)
        if any(mover._row != row for mover, row in zip(movers, before, strict=True)):
            self._set_going(movers)

    def _set_going(self, movers: Sequence[Mover]) -> None:
        """Tell the world, if there is one, that shapes were set to move otherwise."""
        world = movers[0]._world
        if world is not None:
            world._set_going()

    @property
    def angular_velocity(self) -> float:
        """How fast it turns about its pivot, in rad/s; becomes 0 at a stop."""
        mover = self._carried[0]
        at = mover._table.at(mover)
        return mover._table.floats[at + ANGULAR_VELOCITY]

    @angular_velocity.setter
    @setting
    def angular_velocity(self, value: float) -> None:
        self._refuse_part("angular_velocity", value)
        angular_velocity = number("angular_velocity", value)
        movers = self._carried
        first = movers[0]
        table = first._table
        begin, width, floats = table.at(first), table.width, table.floats
        if angular_velocity != 0.0 and table.octets[8 * begin + MOTION] != KINEMATIC:
            raise not_kinematic("angular_velocity", value)
        world, member = first._world, first._id or 0
        sent = floats[begin + TIME_LEFT] > 0.0
        if floats[begin + ANGULAR_VELOCITY] == angular_velocity and not sent:
            return
        together = world is not None and not sent
        if together:
            # In a world rows with ids that follow each other do so too, as those of most compounds; and what is sent
            # somewhere is sent as a whole. This is asked of flippers all the time.
            at = begin + ANGULAR_VELOCITY
            for mover in movers:
                if mover._id != member:
                    together = False
                    break
                floats[at] = angular_velocity
                at += width
                member += 1
        if not together:
            for mover in movers:
                at = mover._halted()
                mover._table.floats[at + ANGULAR_VELOCITY] = angular_velocity
        if world is not None:
            world._set_going()

    @property
    def rotating(self) -> bool:
        """Whether the angular velocity acts."""
        return bool(self._carried[0]._row["rotating"])

    @rotating.setter
    @setting
    def rotating(self, value: bool) -> None:
        self._set_motion("rotating", write_rotating, value)

    @property
    def turn_limits(self) -> tuple[float, float] | None:
        """The stops `(low, high)` of its orientation, in radians, or None. They hold 0 and the orientation."""
        row = self._carried[0]._row
        return (float(row["turn_low"]), float(row["turn_high"])) if row["turn_limited"] else None

    @turn_limits.setter
    @setting
    def turn_limits(self, value: Pair | None) -> None:
        self._set_motion("turn_limits", write_turn_limits, value)

    @property
    def velocity(self) -> Vector:
        """How fast its pivot, and it with that, travels, in length/s."""
        mover = self._carried[0]
        at = mover._table.at(mover)
        floats = mover._table.floats
        return floats[at + VELOCITY_X], floats[at + VELOCITY_Y]

    @velocity.setter
    @setting
    def velocity(self, value: Pair) -> None:
        self._refuse_part("velocity", value)
        x, y = pair("velocity", value)
        movers = self._carried
        if (x != 0.0 or y != 0.0) and not movers[0]._is_kinematic():
            raise not_kinematic("velocity", value)
        at = movers[0]._table.at(movers[0])
        floats = movers[0]._table.floats
        same = floats[at + VELOCITY_X] == x and floats[at + VELOCITY_Y] == y
        if same and not floats[at + TIME_LEFT] > 0.0:
            return
        for mover in movers:
            at = mover._halted()
            floats = mover._table.floats
            floats[at + VELOCITY_X], floats[at + VELOCITY_Y] = x, y
        self._set_going(movers)

    def surface_velocity(self, p: Pair) -> Vector:
        """The velocity of its matter at `p`, in length/s: velocity + ω·perp(p - pivot); (0, 0) if static."""
        x, y = pair("p", p)
        row = self._carried[0]._row
        return surface_velocity(row, acting_spin(row), x, y, 0.0)
