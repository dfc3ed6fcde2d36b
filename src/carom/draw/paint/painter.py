"""The few calls that every picture is made of, and what a mark looks like.

What is drawn is decided once, above the painters (`carom.draw.picture`); a painter only knows how its own medium draws
a line, a circle and a word. Coordinates are the world's, y up; widths and sizes of letters are pixels; colours are
the names of a theme's inks.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.spelling import spelled

Vector: TypeAlias = tuple[float, float]
Points: TypeAlias = NDArray[np.float64]
Anchor: TypeAlias = Literal["start", "middle", "end"]


@spelled
@dataclass(frozen=True, slots=True)
class Style:
    """How a line or an area looks: inks by name (None: not drawn), width and dashes in pixels, opacities 0 to 1."""

    stroke: str | None = None
    fill: str | None = None
    width: float = 1.0
    dash: tuple[float, ...] = ()
    opacity: float = 1.0
    fill_opacity: float = 1.0


@spelled
@dataclass(frozen=True, slots=True)
class Lettering:
    """How words look: ink by name, height in pixels, weight, and which part of them stands at their position."""

    ink: str = "text"
    size: float = 13.0
    bold: bool = False
    anchor: Anchor = "start"


class Lines(Protocol):
    """What outlines of shapes can be drawn on."""

    def segment(self, start: Vector, end: Vector, style: Style) -> None:
        """Draw a straight line."""

    def circle(self, center: Vector, radius: float, style: Style) -> None:
        """Draw a circle."""

    def arc(self, center: Vector, radius: float, start_angle: float, end_angle: float, style: Style) -> None:
        """Draw the part of a circle counterclockwise from `start_angle` to `end_angle` (radians)."""


class Painter(Lines, Protocol):
    """What can be drawn on. Later marks lie over earlier ones."""

    def layer(self, name: str) -> None:
        """Begin the layer `name`: all marks up to the next call belong to it."""

    def box(self, low: Vector, high: Vector, style: Style) -> None:
        """Draw the four sides of an upright box between its lower left corner and its upper right one."""

    def polyline(self, points: Points, style: Style) -> None:
        """Draw a line through `points`, (n, 2); with a fill, the closed area that they bound."""

    def text(self, position: Vector, words: str, lettering: Lettering) -> None:
        """Write one line of `words` on the baseline through `position`."""


def sides(low: Vector, high: Vector) -> tuple[tuple[Vector, Vector], ...]:
    """The sides of an upright box, each from its start to its end, counterclockwise from the lower left corner."""
    (left, bottom), (right, top) = low, high
    corners = ((left, bottom), (right, bottom), (right, top), (left, top))
    return tuple(zip(corners, (*corners[1:], corners[0]), strict=True))
