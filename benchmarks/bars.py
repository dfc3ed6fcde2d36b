"""Bars of a few engines at a few works, their lengths by powers of ten, drawn by carom's own painter.

It is narrow, so that it can be read on a telephone.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import floor, log10

import numpy as np

from benchmarks.engines import CONTINUOUS
from carom import Aabb
from carom.draw.paint.painter import Lettering, Style
from carom.draw.paint.svg import SvgPainter
from carom.draw.parts.frame import Frame

WIDTH = 520.0
LEFT, RIGHT = 148.0, 452.0  # of the bars, in pixels
#: How thick a bar is, from one to the next, above the first of a work, and around all.
BAR, BETWEEN, HEADING, EDGE = 13.0, 20.0, 34.0, 44.0
#: So many powers of ten are written each, and of more every second.
MANY = 5.0
#: How the bars of engines look.
STYLES = {
    "carom": Style(fill="ball-3"),
    CONTINUOUS: Style(fill="ball-1"),
    "pymunk": Style(fill="ball-4"),
    "Box2D": Style(fill="ball-2"),
}


@dataclass(frozen=True)
class Bar:
    """One engine's figure, how it is written, and how the bar looks."""

    engine: str
    value: float
    words: str
    style: Style


@dataclass(frozen=True)
class Work:
    """What was measured, with a bar for each engine that can do it."""

    name: str
    bars: Sequence[Bar]


def draw(title: str, unit: str, works: Sequence[Work], written: Callable[[float], str] = "{:g}".format) -> str:
    """The chart as SVG: each work under the last one, its bars from a power of ten below the least value to the most.

    `written` says how the powers of ten are written.
    """
    powers = [log10(bar.value) for work in works for bar in work.bars]
    first, last = floor(min(powers) - 0.1), max(powers)
    height = 2.0 * EDGE + sum(HEADING + BETWEEN * len(work.bars) for work in works)
    frame = Frame(WIDTH, height, Aabb(0.0, 0.0, WIDTH, height), scale=1.0, stage_left=0.0, stage_top=0.0)
    painter = SvgPainter(frame, title=title)
    painter.layer("axis")
    _box(painter, (0.0, 0.0), (WIDTH, height), Style(fill="stage"))
    painter.text((16.0, height - 28.0), title, Lettering("text", 14.0, bold=True))

    def along(power: float) -> float:
        return LEFT + (RIGHT - LEFT) * (power - first) / (last - first)

    lines = range(first, floor(last) + 1, 1 if last - first < MANY else 2)
    for power in lines:
        painter.text((along(power), EDGE - 20.0), written(10.0**power), Lettering("muted", 12.0, anchor="middle"))
    painter.text((16.0, EDGE - 20.0), unit, Lettering("muted", 12.0))
    painter.layer("bars")
    y = height - EDGE
    for work in works:
        painter.text((16.0, y - 22.0), work.name, Lettering("text", 13.0, bold=True))
        y -= HEADING
        for power in lines:
            bottom = y + BETWEEN - BAR - BETWEEN * len(work.bars)
            painter.segment((along(power), bottom - 4.0), (along(power), y + 4.0), Style("rule"))
        for bar in work.bars:
            painter.text((16.0, y - 12.0), bar.engine, Lettering("text", 13.0))
            _box(painter, (LEFT, y - BAR), (along(log10(bar.value)), y), bar.style)
            painter.text((along(log10(bar.value)) + 6.0, y - 12.0), bar.words, Lettering("text", 13.0))
            y -= BETWEEN
    return painter.finish()


def _box(painter: SvgPainter, low: tuple[float, float], high: tuple[float, float], style: Style) -> None:
    """Draw an upright rectangle with an area."""
    painter.polyline(np.array([low, (high[0], low[1]), high, (low[0], high[1])]), style)
