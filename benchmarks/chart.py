"""A chart with powers of ten along both axes, drawn by carom's own painter."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

import numpy as np

from carom import Aabb
from carom.draw.paint.painter import Lettering, Style
from carom.draw.paint.svg import SvgPainter
from carom.draw.parts.frame import Frame

WIDTH, HEIGHT = 900.0, 420.0
LEFT, BOTTOM, RIGHT, TOP = 70.0, 56.0, 560.0, 380.0  # of the axes, in pixels from the lower left


@dataclass(frozen=True)
class Curve:
    """Places that are joined, each a positive number across and one up; with a line of the legend."""

    name: str
    style: Style
    points: Sequence[tuple[float, float]]


@dataclass(frozen=True)
class Chart:
    """The axes of a chart, in powers of ten: first and last across; lowest, highest, and every how many one up."""

    title: str
    along: str
    what: str
    across: tuple[float, float]
    up: tuple[int, int, int]

    def draw(self, curves: Sequence[Curve]) -> str:
        """The chart as SVG."""
        frame = Frame(WIDTH, HEIGHT, Aabb(0.0, 0.0, WIDTH, HEIGHT), scale=1.0, stage_left=0.0, stage_top=0.0)
        painter = SvgPainter(frame, title=self.title)
        painter.layer("axes")
        corners = np.array([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])
        painter.polyline(corners, Style(fill="stage"))
        self._draw_axes(painter)
        painter.layer("curves")
        for place, curve in enumerate(curves):
            points = [(self._x(log10(x)), self._y(log10(y))) for x, y in curve.points]
            if len(points) > 1:
                painter.polyline(np.array(points), curve.style)
            y = TOP - 14.0 - 24.0 * place
            painter.segment((RIGHT + 24.0, y + 4.0), (RIGHT + 64.0, y + 4.0), curve.style)
            painter.text((RIGHT + 74.0, y), curve.name, Lettering())
        return painter.finish()

    def _x(self, power: float) -> float:
        """The pixel of a power of ten across."""
        first, last = self.across
        return LEFT + (RIGHT - LEFT) * (power - first) / (last - first)

    def _y(self, power: float) -> float:
        """The pixel of a power of ten up."""
        least, most, _ = self.up
        return BOTTOM + (TOP - BOTTOM) * (power - least) / (most - least)

    def _draw_axes(self, painter: SvgPainter) -> None:
        """Draw a line and a number for each power of ten, and what the axes are."""
        rule, small = Style("rule"), Lettering("muted", 12.0, anchor="middle")
        least, most, each = self.up
        for power in range(least, most + 1, each):
            painter.segment((LEFT, self._y(power)), (RIGHT, self._y(power)), rule)
            number = f"{10**power:,}" if power >= 0 and least >= 0 else f"1e{power}"
            painter.text((LEFT - (24.0 if least < 0 else 34.0), self._y(power) - 4.0), number, small)
        for power in range(ceil(self.across[0]), floor(self.across[1]) + 1):
            painter.segment((self._x(power), BOTTOM), (self._x(power), TOP), rule)
            painter.text((self._x(power), BOTTOM - 18.0), f"{10**power:,}", small)
        painter.text((0.5 * (LEFT + RIGHT), BOTTOM - 40.0), self.along, small)
        painter.text((LEFT, TOP + 16.0), self.what, Lettering("text", 13.0, bold=True))
