"""Points: posts without extent, and the guards of bare ends."""

from __future__ import annotations

from typing import Unpack

from carom.checks import pair
from carom.rows.shape import POINT
from carom.shapes.shape import Shape, ShapeOptions
from carom.spelling import spelled
from carom.typing import Pair, Vector


@spelled
class Point(Shape):
    """A place that a ball bounces off; takes the options of every `Shape` too.

    >>> Point((3, 4)).distance((0, 0))
    5.0
    """

    __slots__ = ()

    _KIND = POINT

    def __init__(self, position: Pair, **options: Unpack[ShapeOptions]) -> None:
        x, y = pair("position", position)
        self._create("position", position, options, cx=x, cy=y)

    def __repr__(self) -> str:
        return f"Point({self.position})"

    def closest_point(self, p: Pair) -> Vector:
        """The point itself, whatever `p` is."""
        pair("p", p)
        return self.position
