"""Gates: walls that balls pass one way."""

from __future__ import annotations

from math import fabs
from typing import Unpack

from carom.checks import pair, refuse
from carom.constants import ROUNDING
from carom.geometry.vector import cross, unit
from carom.rows.shape import GATE, ShapeRow
from carom.shapes.segment import Segment, two_ends
from carom.shapes.shape import ShapeOptions
from carom.spelling import spelled
from carom.turns import setting
from carom.typing import Pair, Vector


@spelled
class Gate(Segment):
    """A segment that lets balls pass along `direction` and stops those that come against it; takes all options too.

    Its ends are sorted as a segment's are. The direction is kept as a unit vector; by default it is the normal of the
    ends as they were first sorted. It turns with the gate and never flips. Raises `InvalidArgument` where it is zero or
    parallel to the gate.

    >>> trap = Gate((0, 0), (4, 0), direction=(0, -2))
    >>> trap.direction, trap.normal
    ((0.0, -1.0), (0.0, 1.0))
    """

    __slots__ = ()

    _KIND = GATE

    def __init__(self, start: Pair, end: Pair, direction: Pair | None = None, **options: Unpack[ShapeOptions]) -> None:
        (ax, ay), (bx, by) = two_ends(start, end)
        if direction is None:
            tx, ty = unit(bx - ax, by - ay) or (0.0, 0.0)  # the ends differ, but their difference may overflow
            dx, dy = 0.0 - ty, tx
        else:
            dx, dy = _unit_direction(direction)
        blame, value = ("end", end) if direction is None else ("direction", direction)
        self._create(blame, value, options, ax=ax, ay=ay, bx=bx, by=by, dx=dx, dy=dy)

    def __repr__(self) -> str:
        return f"Gate({self.p0}, {self.p1}, direction={self.direction})"

    def _check(self, row: ShapeRow, name: str, value: object) -> None:
        super()._check(row, name, value)
        if fabs(cross(float(row["tx"]), float(row["ty"]), float(row["dx"]), float(row["dy"]))) <= ROUNDING:
            raise refuse(name, "must leave the gate's direction across the gate", value)

    @property
    def direction(self) -> Vector:
        """The unit vector along which balls pass. It may be set to a vector of any length."""
        row = self._row
        return float(row["dx"]) + 0.0, float(row["dy"]) + 0.0  # -0 + 0 is 0

    @direction.setter
    @setting
    def direction(self, value: Pair) -> None:
        dx, dy = _unit_direction(value)
        self._set_geometry("direction", value, dx=dx, dy=dy)


def _unit_direction(value: Pair) -> Vector:
    """The unit vector along a direction that a user gave."""
    direction = unit(*pair("direction", value))
    if direction is None:
        raise refuse("direction", "must not be zero", value)
    return direction
