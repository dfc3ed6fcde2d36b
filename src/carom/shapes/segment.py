"""Segments: straight walls with bare ends."""

from __future__ import annotations

from typing import Unpack

from carom.checks import pair, refuse
from carom.geometry.line import closest_on_segment
from carom.geometry.vector import dot
from carom.rows.shape import SEGMENT, ShapeRow
from carom.shapes.line import Line
from carom.shapes.shape import Shape, ShapeOptions
from carom.spelling import spelled
from carom.turns import changing, setting
from carom.typing import Pair, Vector


@spelled
class Segment(Shape):
    """A straight wall, whose ends are sorted: `start` (or `p0`) is the one with the smaller x, whichever came first.

    Of equal x, it is the one with the smaller y; `end` (or `p1`) is the other. They stay sorted when the segment turns.
    The ends are bare: a ball whose centre lies past an end misses it, so corners need points (see `guard_points`).
    Takes the options of every `Shape` too. Raises `InvalidArgument` where the ends are equal.

    >>> wall = Segment((4, 0), (0, 0))
    >>> wall.start, wall.t0, wall.normal
    ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
    """

    __slots__ = ()

    _KIND = SEGMENT

    def __init__(self, start: Pair, end: Pair, **options: Unpack[ShapeOptions]) -> None:
        (ax, ay), (bx, by) = two_ends(start, end)
        self._create("end", end, options, ax=ax, ay=ay, bx=bx, by=by)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.p0}, {self.p1})"

    def _check(self, row: ShapeRow, name: str, value: object) -> None:
        super()._check(row, name, value)
        if row["length"] == 0.0:
            raise refuse(name, "must leave the two ends apart", value)

    # -- ends --------------------------------------------------------------------------------------------------------

    @property
    def p0(self) -> Vector:
        """The end with the smaller x; of equal ones, with the smaller y. Setting it may swap the ends' order."""
        row = self._row
        return float(row["ax"]), float(row["ay"])

    @p0.setter
    @setting
    def p0(self, value: Pair) -> None:
        self._put_p0("p0", value)

    def _put_p0(self, name: str, value: Pair) -> None:
        """Move the end `p0`."""
        x, y = pair(name, value)
        self._set_geometry(name, value, ax=x, ay=y)

    @property
    def p1(self) -> Vector:
        """The other end. Setting it may swap the ends' order."""
        row = self._row
        return float(row["bx"]), float(row["by"])

    @p1.setter
    @setting
    def p1(self, value: Pair) -> None:
        self._put_p1("p1", value)

    def _put_p1(self, name: str, value: Pair) -> None:
        """Move the end `p1`."""
        x, y = pair(name, value)
        self._set_geometry(name, value, bx=x, by=y)

    @property
    def start(self) -> Vector:
        """The end with the smaller x; the same as `p0`. The order that was given is not kept."""
        return self.p0

    @start.setter
    @setting
    def start(self, value: Pair) -> None:
        self._put_p0("start", value)

    @property
    def end(self) -> Vector:
        """The end with the greater x; the same as `p1`."""
        return self.p1

    @end.setter
    @setting
    def end(self, value: Pair) -> None:
        self._put_p1("end", value)

    @changing
    def set_ends(self, start: Pair, end: Pair) -> None:
        """Move both ends at once. Raises `InvalidArgument` where they are equal."""
        (ax, ay), (bx, by) = two_ends(start, end)
        self._set_geometry("end", end, ax=ax, ay=ay, bx=bx, by=by)

    # -- what follows from them --------------------------------------------------------------------------------------

    @property
    def t0(self) -> Vector:
        """The unit tangent at `p0`, which points into the segment."""
        row = self._row
        return float(row["tx"]), float(row["ty"])

    @property
    def t1(self) -> Vector:
        """The unit tangent at `p1`, which points into the segment: the opposite of `t0`."""
        x, y = self.t0
        return 0.0 - x, 0.0 - y

    @property
    def normal(self) -> Vector:
        """The unit normal perp(t0), counterclockwise of the way from `p0` to `p1`."""
        x, y = self.t0
        return 0.0 - y, x

    @property
    def length(self) -> float:
        """How far it is from end to end."""
        return float(self._row["length"])

    @property
    def line(self) -> Line:
        """The infinite line that it is a part of."""
        return Line.through(self.p0, self.p1)

    @property
    def gradient(self) -> float:
        """dy/dx: 0 where it is horizontal, inf where vertical."""
        return self.line.gradient

    @property
    def inverse_gradient(self) -> float:
        """dx/dy: 0 where it is vertical, inf where horizontal."""
        return self.line.inverse_gradient

    @property
    def x_intercept(self) -> float:
        """The x at which its line has y = 0; inf where it is horizontal."""
        return self.line.x_intercept

    @property
    def y_intercept(self) -> float:
        """The y at which its line has x = 0; inf where it is vertical."""
        return self.line.y_intercept

    def closest_point(self, p: Pair) -> Vector:
        """The point of it that is nearest to `p`; an end, where `p` lies past that."""
        x, y = pair("p", p)
        return closest_on_segment(*self.p0, *self.p1, x, y)

    def parameter(self, point: Pair) -> float:
        """How far along it from `p0` the place is that is nearest to `point`; from 0 to its length."""
        x, y = pair("point", point)
        (ax, ay), (tx, ty) = self.p0, self.t0
        return min(max(dot(x - ax, y - ay, tx, ty), 0.0), self.length)


def two_ends(start: Pair, end: Pair) -> tuple[Vector, Vector]:
    """The two ends that a user gave, the smaller x first (of equal ones, the smaller y); raises for equal ones."""
    ends = pair("start", start), pair("end", end)
    if ends[0] == ends[1]:
        raise refuse("end", "must differ from start", end)
    return min(ends), max(ends)
