"""Infinite lines, for reckoning alone: they collide with nothing."""

from __future__ import annotations

from math import inf, isinf
from typing import TYPE_CHECKING, Any, Self

from carom.checks import number, pair, refuse
from carom.errors import UnknownName
from carom.geometry.line import closest_on_line, intersect_lines
from carom.geometry.vector import unit
from carom.shapes.copies import add_attributes
from carom.spelling import spelled
from carom.typing import Pair, Vector


@spelled
class Line:
    """An immutable line through a point: y = gradient·x + y_intercept, or a vertical line where the gradient is inf.

    Its arithmetic is that of a point and a direction; the four numbers are derived from those. Raises
    `InvalidArgument` for a point that is not finite and a gradient that is NaN.

    >>> Line((0, 1), 2.0).intersection(Line.through((3, 0), (3, 5)))
    (3.0, 7.0)
    """

    __slots__ = ("_dx", "_dy", "_x", "_y")

    _x: float
    _y: float
    _dx: float
    _dy: float

    def __init__(self, point: Pair, gradient: float) -> None:
        x, y = pair("point", point)
        self._lay(x, y, *_direction(gradient))

    @classmethod
    def through(cls, first: Pair, second: Pair) -> Self:
        """The line through two points, which must differ."""
        x, y = pair("first", first)
        to_x, to_y = pair("second", second)
        # Halves: the difference of two large numbers may overflow.
        direction = unit(0.5 * to_x - 0.5 * x, 0.5 * to_y - 0.5 * y)
        if direction is None:
            raise refuse("second", "must differ from first", second)
        line = cls.__new__(cls)
        line._lay(x, y, *direction)
        return line

    def _lay(self, x: float, y: float, dx: float, dy: float) -> None:
        """Fix the line through (x, y) along (dx, dy)."""
        for slot, value in (("_x", x), ("_y", y), ("_dx", dx), ("_dy", dy)):
            object.__setattr__(self, slot, value)

    if not TYPE_CHECKING:  # type checkers let any attribute be set where they see this

        def __setattr__(self, name: str, value: Any) -> None:
            raise UnknownName(f"{name} cannot be set: a Line cannot be changed")

    def __setstate__(self, state: Any) -> None:
        """Take what a copy or a pickle kept, past the refusal to be changed."""
        for attributes in state:
            add_attributes(self, attributes or {})

    def __repr__(self) -> str:
        return f"Line({(self._x, self._y)}, {self.gradient})"

    @property
    def gradient(self) -> float:
        """dy/dx: 0 for a horizontal line, inf for a vertical one."""
        return self._dy / self._dx if self._dx != 0.0 else inf

    @property
    def inverse_gradient(self) -> float:
        """dx/dy: 0 for a vertical line, inf for a horizontal one."""
        return self._dx / self._dy if self._dy != 0.0 else inf

    @property
    def x_intercept(self) -> float:
        """The x at which y is 0; inf for a horizontal line."""
        return self._x - self._y * self.inverse_gradient if self._dy != 0.0 else inf

    @property
    def y_intercept(self) -> float:
        """The y at which x is 0; inf for a vertical line."""
        return self._y - self._x * self.gradient if self._dx != 0.0 else inf

    def intersection(self, other: Line) -> Vector | None:
        """The point where two lines meet; None for parallel lines, and for a line with itself."""
        if not isinstance(other, Line):
            raise refuse("other", "must be a Line", other)
        return intersect_lines(self._x, self._y, self._dx, self._dy, other._x, other._y, other._dx, other._dy)

    def closest_point(self, p: Pair) -> Vector:
        """The point of the line that is nearest to `p`."""
        x, y = pair("p", p)
        return closest_on_line(self._x, self._y, self._dx, self._dy, x, y)


def _direction(gradient: Any) -> Vector:
    """The direction of lines with a gradient, which may be infinite but not NaN."""
    if isinstance(gradient, float) and isinf(gradient):
        return 0.0, 1.0
    return 1.0, number("gradient", gradient)
