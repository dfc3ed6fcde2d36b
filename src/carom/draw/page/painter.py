"""The painter of the replay page: it keeps what it is told to draw, for the page's canvas to draw at any zoom."""

from __future__ import annotations

from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any, TypeAlias

from carom.draw.paint.painter import sides

if TYPE_CHECKING:
    from collections.abc import Callable

    from carom.draw.paint.painter import Lettering, Painter, Points, Style, Vector
    from carom.draw.parts.frame import Frame

#: A call of a painter as JSON holds it: its name, the number of its style, its numbers in units of the world, the
#: pixels that come on top of these (None where there are none), and the words of a text.
Call: TypeAlias = list[Any]

#: Digits of the world's numbers that are kept: enough to zoom in far on a small scene that is far from the origin.
DIGITS = 12
#: Pixels this small are rounding.
NO_PIXEL = 1e-4


class PagePainter:
    """Keeps all calls, by layer; styles are listed once and named by their number."""

    def __init__(self) -> None:
        self.layers: dict[str, list[Call]] = {}
        self.styles: list[Style | Lettering] = []
        self._numbers: dict[Style | Lettering, int] = {}
        self._layer = ""

    def layer(self, name: str) -> None:
        """Begin the layer `name`, or go on with it; one without marks is not kept."""
        self._layer = name

    def segment(self, start: Vector, end: Vector, style: Style) -> None:
        """Keep a straight line."""
        self._keep("segment", style, [*start, *end])

    def circle(self, center: Vector, radius: float, style: Style) -> None:
        """Keep a circle."""
        self._keep("circle", style, [*center, radius])

    def arc(self, center: Vector, radius: float, start_angle: float, end_angle: float, style: Style) -> None:
        """Keep an arc."""
        self._keep("arc", style, [*center, radius, start_angle, end_angle])

    def box(self, low: Vector, high: Vector, style: Style) -> None:
        """Keep the sides of a box."""
        for start, end in sides(low, high):
            self.segment(start, end, style)

    def polyline(self, points: Points, style: Style) -> None:
        """Keep a line through points, or an area."""
        self._keep("polyline", style, points.ravel().tolist())

    def text(self, position: Vector, words: str, lettering: Lettering) -> None:
        """Keep a line of words."""
        self._keep("text", lettering, [*position], words)

    def _keep(self, name: str, style: Style | Lettering, numbers: list[float], *more: str) -> None:
        """Keep one call."""
        if style not in self._numbers:
            self._numbers[style] = len(self.styles)
            self.styles.append(style)
        call = [name, self._numbers[style], [float(number) for number in numbers], None, *more]
        self.layers.setdefault(self._layer, []).append(call)


def record_into(painter: PagePainter, frame: Frame, draw: Callable[[Painter, Frame], None]) -> None:
    """Give `painter` new layers, of what `draw` draws at any zoom: numbers are of the world, and in pixels.

    Marks are as large in every picture: a dot has a radius of `frame.units(pixels)`. So `draw` is asked twice, for
    scales s and 2s: a number w + p / s that is w + p / 2s at the other scale has a part w of the world and p pixels.
    Whatever `draw` decides by the scale must be the same at both, but for numbers.
    """
    before = set(painter.layers)
    closer = PagePainter()
    draw(painter, frame)
    draw(closer, replace(frame, scale=2.0 * frame.scale))
    for name in painter.layers.keys() - before:
        for call, close in zip(painter.layers[name], closer.layers[name], strict=True):
            call[2], call[3] = parted(call[2], close[2], frame.scale)


def parted(numbers: list[float], closer: list[float], scale: float) -> tuple[list[float], list[float] | None]:
    """The world's parts of numbers and their pixels, from their values at `scale` and at twice that."""
    pairs = list(zip(numbers, closer, strict=True))
    pixels = [2.0 * scale * (number - close) for number, close in pairs]
    if all(abs(pixel) < NO_PIXEL for pixel in pixels):
        return [trimmed(number) for number in numbers], None
    return [trimmed(2.0 * close - number) for number, close in pairs], [round(pixel, 3) + 0.0 for pixel in pixels]


def trimmed(number: float) -> float:
    """`number` with as many digits as can be seen."""
    return float(f"{number:.{DIGITS}g}") + 0.0


def plain_style(style: Style | Lettering) -> dict[str, Any]:
    """A style or lettering as JSON holds it."""
    return asdict(style)
