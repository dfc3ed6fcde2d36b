"""What shapes, balls and compounds have in common: a name, and how far away they are."""

from __future__ import annotations

from abc import abstractmethod

from carom.checks import pair, text_or_none
from carom.geometry.vector import length
from carom.pictured import Pictured
from carom.spelling import Spelled
from carom.turns import setting
from carom.typing import Pair, Vector


class Named(Spelled, Pictured):
    """What has a name and a nearest point."""

    __slots__ = ("_name",)

    _name: str | None

    @property
    def name(self) -> str | None:
        """What the user calls it, or None."""
        return self._name

    @name.setter
    @setting
    def name(self, value: str | None) -> None:
        self._name = text_or_none("name", value)

    @abstractmethod
    def closest_point(self, p: Pair) -> Vector:
        """The point of it that is nearest to `p`; of its perimeter, where it is round."""

    def distance(self, p: Pair) -> float:
        """How far `p` is from its `closest_point`; never negative."""
        x, y = pair("p", p)
        near_x, near_y = self.closest_point((x, y))
        return length(x - near_x, y - near_y)
