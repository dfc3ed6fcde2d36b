"""Axis-aligned bounding boxes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from carom.checks import number, pair, refuse
from carom.geometry.aabb import box_contains, boxes_overlap
from carom.spelling import spelled
from carom.typing import Pair, Vector


@spelled
@dataclass(frozen=True, slots=True)
class Aabb:
    """An immutable box with sides parallel to the axes; y points up, so `bottom <= top`.

    A box may have no width or no height. Raises `InvalidArgument` where a side is not a finite number, left exceeds
    right or bottom exceeds top.

    >>> box = Aabb.at((1, 2)).including((4, 6))
    >>> box.width, box.height, (3, 6) in box
    (3.0, 4.0, True)
    """

    left: float
    bottom: float
    right: float
    top: float

    def __post_init__(self) -> None:
        for side in ("left", "bottom", "right", "top"):
            object.__setattr__(self, side, number(side, getattr(self, side)))
        if self.left > self.right:
            raise refuse("left", f"must not exceed right={self.right!r}", self.left)
        if self.bottom > self.top:
            raise refuse("bottom", f"must not exceed top={self.top!r}", self.bottom)

    @classmethod
    def at(cls, point: Pair) -> Aabb:
        """The box that is the one point."""
        x, y = pair("point", point)
        return cls(x, y, x, y)

    def including(self, point: Pair) -> Aabb:
        """The smallest box around this one and a point."""
        x, y = pair("point", point)
        return Aabb(min(self.left, x), min(self.bottom, y), max(self.right, x), max(self.top, y))

    def translated(self, v: Pair) -> Aabb:
        """This box moved by the vector `v`."""
        x, y = pair("v", v)
        return Aabb(self.left + x, self.bottom + y, self.right + x, self.top + y)

    @property
    def width(self) -> float:
        """How far it reaches in x."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """How far it reaches in y."""
        return self.top - self.bottom

    @property
    def top_left(self) -> Vector:
        """The corner with the smallest x and the greatest y."""
        return self.left, self.top

    @property
    def bottom_right(self) -> Vector:
        """The corner with the greatest x and the smallest y."""
        return self.right, self.bottom

    def overlaps(self, other: Aabb) -> bool:
        """Whether the two boxes have a point in common; touching counts."""
        if not isinstance(other, Aabb):
            raise refuse("other", "must be an Aabb", other)
        return boxes_overlap(self.left, self.bottom, self.right, self.top, *other)

    def __contains__(self, point: Pair) -> bool:
        x, y = pair("point", point)
        return box_contains(self.left, self.bottom, self.right, self.top, x, y)

    def __iter__(self) -> Iterator[float]:
        """The sides in the constructor's order, so that a box can be unpacked."""
        yield self.left
        yield self.bottom
        yield self.right
        yield self.top
