"""Circles: bumpers and arenas."""

from __future__ import annotations

from math import atan2
from typing import Unpack

from carom.checks import flag, pair, positive
from carom.constants import TWO_PI
from carom.geometry.angle import normalize_angle
from carom.geometry.circle import closest_on_circle
from carom.rows.shape import CIRCLE
from carom.shapes.round import RoundShape
from carom.shapes.shape import ShapeOptions
from carom.spelling import spelled
from carom.turns import setting
from carom.typing import Pair, Vector


@spelled
class Circle(RoundShape):
    """A round wall, which balls meet from either side, or with `solid=True` a disc; takes the options of every `Shape`.

    A ball inside a circle that is not solid bounces off its inside (an arena); from a solid one it is pushed out (a
    bumper). Raises `InvalidArgument` for a radius that is not positive.

    >>> Circle((0, 0), 2).closest_point((0, -5))
    (0.0, -2.0)
    """

    __slots__ = ()

    _KIND = CIRCLE

    def __init__(self, center: Pair, radius: float, solid: bool = False, **options: Unpack[ShapeOptions]) -> None:
        x, y = pair("center", center)
        size, is_solid = positive("radius", radius), flag("solid", solid)
        self._create("radius", radius, options, cx=x, cy=y, radius=size, solid=is_solid)

    def __repr__(self) -> str:
        return f"Circle({self.center}, {self.radius}{', solid=True' if self.solid else ''})"

    @property
    def solid(self) -> bool:
        """Whether the inside is solid too."""
        return bool(self._row["solid"])

    @solid.setter
    @setting
    def solid(self, value: bool) -> None:
        self._put("solid", flag("solid", value))

    @property
    def length(self) -> float:
        """How far it is around it."""
        return TWO_PI * self.radius

    def parameter(self, point: Pair) -> float:
        """How far along it, counterclockwise from angle 0, the place is that is nearest to `point`.

        From 0 to less than its length; 0 where `point` is the centre.
        """
        x, y = pair("point", point)
        cx, cy = self.center
        return self.radius * normalize_angle(atan2(y - cy, x - cx))

    def closest_point(self, p: Pair) -> Vector:
        """The point of the perimeter that is nearest to `p`; the one at angle 0 where `p` is the centre."""
        x, y = pair("p", p)
        return closest_on_circle(*self.center, self.radius, x, y)
