"""What circles, arcs and balls have in common: a centre, a radius and tangents."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any

from carom.checks import pair, positive, refuse
from carom.geometry.circle import circle_contains, common_tangents, tangent_points
from carom.rows.shape import ShapeRow
from carom.shapes.member import Member
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape
from carom.shapes.table import R
from carom.turns import setting
from carom.typing import Pair, Vector


class Round(Member[R]):
    """A member with a centre and a radius."""

    __slots__ = ()

    @property
    def center(self) -> Vector:
        """The centre; the same as `position`."""
        return self.position

    @center.setter
    @setting
    def center(self, value: Pair) -> None:
        self._put_at("center", value)

    @abstractmethod
    def _put_at(self, name: str, value: Pair) -> None:
        """Move it so that its position is `value`, the argument `name`."""

    @property
    @abstractmethod
    def radius(self) -> float:
        """The radius; positive."""

    def contains(self, p: Pair) -> bool:
        """Whether `p` lies strictly inside the circle, compared as squares."""
        x, y = pair("p", p)
        return circle_contains(*self.center, self.radius, x, y)

    def tangent_points(self, p: Pair) -> tuple[Vector, Vector] | None:
        """The two points where tangents through `p` touch the circle, or None where `p` lies inside.

        The first is the one counterclockwise of the direction from `p` to the centre. For `p` on the circle both are
        `p`. Of an arc, the points of its whole circle.
        """
        x, y = pair("p", p)
        found = tangent_points(*self.center, self.radius, x, y)
        if found is None:
            return None
        x0, y0, x1, y1 = found
        return (x0, y0), (x1, y1)

    def common_tangents(self, circle: Round[Any]) -> tuple[Segment, Segment] | None:
        """The two outer tangents in common with another circle, from touching point to touching point.

        The first is the one counterclockwise of the direction from this centre to the other's. None where one of the
        circles lies inside the other.
        """
        if not isinstance(circle, Round):
            raise refuse("circle", "must be a Circle, an Arc or a Ball", circle)
        found = common_tangents(*self.center, self.radius, *circle.center, circle.radius)
        if found is None:
            return None
        ax, ay, bx, by, cx, cy, dx, dy = found
        return Segment((ax, ay), (bx, by)), Segment((cx, cy), (dx, dy))

    def common_tangent(self, circle: Round[Any]) -> Segment | None:
        """The first of the `common_tangents`: the one counterclockwise of the direction to the other's centre."""
        found = self.common_tangents(circle)
        return None if found is None else found[0]


class RoundShape(Shape, Round[ShapeRow]):
    """A round member on rails: what circles and arcs share."""

    __slots__ = ()

    @property
    def radius(self) -> float:
        """The radius; positive."""
        return float(self._row["radius"])

    @radius.setter
    @setting
    def radius(self, value: float) -> None:
        self._set_geometry("radius", value, radius=positive("radius", value))
