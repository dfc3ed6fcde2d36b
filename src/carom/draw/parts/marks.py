"""The marks that a picture is made of besides shapes: arrows, pivots, balls, hits, tracks."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from math import cos, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.tracks import BANDS
from carom.draw.paint.painter import Style

if TYPE_CHECKING:
    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.frame import Frame
    from carom.shapes.aabb import Aabb

#: Pixels: half the width and the length of an arrow's head, the length of its shaft, the radius of a pivot's ring.
ARROW_HALF, ARROW_HEAD, ARROW_SHAFT, PIVOT_RING = 4.5, 7.0, 9.0, 3.2
#: Pixels: the dots of the weakest and of the strongest hits, in how many sizes.
SMALLEST_HIT, LARGEST_HIT, HIT_SIZES = 1.2, 4.8, 6
#: Pixels: the width of a track. Opacity of its youngest and of its oldest band.
TRACK_WIDTH, YOUNGEST, OLDEST = 1.5, 0.9, 0.1
#: Pixels: the radius of a reticle, and how far its four ticks reach in and out.
RETICLE, RETICLE_TICK = 9.0, 4.0

HIT = Style(fill="hit", opacity=0.55)
BOX = Style("box", width=1.0, dash=(3.0, 3.0))
VELOCITY = Style("velocity", width=1.4)
TANGENT = Style("tangent", width=1.6, dash=(5.0, 3.5))
NORMAL = Style("normal", width=1.6)


def arrow_mark(painter: Painter, frame: Frame, position: Vector, direction: Vector, style: Style) -> None:
    """Draw an arrow from `position` along the unit vector `direction`, of one size in every picture."""
    long_arrow_mark(painter, frame, position, direction, ARROW_SHAFT + ARROW_HEAD, style)


def long_arrow_mark(
    painter: Painter, frame: Frame, position: Vector, direction: Vector, pixels: float, style: Style
) -> None:
    """Draw an arrow of some pixels from `position` along the unit vector `direction`."""
    head = min(ARROW_HEAD, 0.6 * pixels)
    half, shaft = frame.units(ARROW_HALF * head / ARROW_HEAD), frame.units(pixels - head)
    (x, y), (dx, dy) = position, direction
    neck_x, neck_y = x + shaft * dx, y + shaft * dy
    painter.segment(position, (neck_x, neck_y), style)
    head = frame.units(head)
    corners = [
        (neck_x - half * dy, neck_y + half * dx),
        (neck_x + head * dx, neck_y + head * dy),
        (neck_x + half * dy, neck_y - half * dx),
    ]
    painter.polyline(np.array(corners), head_style(style.stroke, style.opacity))


@lru_cache(maxsize=256)
def head_style(ink: str | None, opacity: float) -> Style:
    """The style of an arrow's head."""
    return Style(fill=ink, opacity=opacity)


def pivot_mark(painter: Painter, frame: Frame, position: Vector) -> None:
    """Draw the ring around the point that a moving part turns about."""
    painter.circle(position, frame.units(PIVOT_RING), Style("moving", fill="stage", width=1.6))


def ball_mark(painter: Painter, frame: Frame, center: Vector, radius: float, ink: str) -> None:
    """Draw a ball, with a rim that keeps it apart from its neighbours while it is large enough for one."""
    style = ball_style(ink, radius * frame.scale)
    painter.circle(center, radius - (0.5 * frame.units(style.width) if style.stroke else 0.0), style)


@lru_cache(maxsize=1024)
def ball_style(ink: str, pixels: float) -> Style:
    """The style of a ball whose radius is some pixels."""
    rim = min(1.5, 0.2 * pixels)
    return Style("stage", fill=ink, width=rim) if rim >= 0.3 else Style(fill=ink)


def hit_mark(painter: Painter, frame: Frame, center: Vector, strength: float, weight: float) -> None:
    """Draw a hit point of a `strength` from 0 to 1; the dot's area grows with it, in `HIT_SIZES` sizes."""
    size = round(min(1.0, max(0.0, strength)) ** 0.5 * (HIT_SIZES - 1)) / (HIT_SIZES - 1)
    radius = (SMALLEST_HIT + (LARGEST_HIT - SMALLEST_HIT) * size) * weight
    painter.circle(center, frame.units(radius), HIT)


@lru_cache(maxsize=1024)
def track_style(ink: str, band: int, count: int = BANDS) -> Style:
    """The style of a track in one of its bands of age, 0 the oldest."""
    share = band / (count - 1)
    return Style(ink, width=TRACK_WIDTH, opacity=OLDEST + (YOUNGEST - OLDEST) * share * share)


def reticle_mark(painter: Painter, frame: Frame, center: Vector, angle: float, opacity: float) -> None:
    """Draw a ring with four ticks, turned by `angle`."""
    style = Style("reticle", width=1.5, opacity=opacity)
    painter.circle(center, frame.units(RETICLE), style)
    inner, outer = frame.units(RETICLE - RETICLE_TICK), frame.units(RETICLE + RETICLE_TICK)
    for quarter in range(4):
        c, s = cos(angle + 0.5 * pi * quarter), sin(angle + 0.5 * pi * quarter)
        start, end = (center[0] + inner * c, center[1] + inner * s), (center[0] + outer * c, center[1] + outer * s)
        painter.segment(start, end, style)


def box_mark(painter: Painter, box: Aabb, style: Style = BOX) -> None:
    """Draw a box: four lines, or the area where the style has a fill alone."""
    if style.stroke is None:
        corners = ((box.left, box.bottom), (box.right, box.bottom), (box.right, box.top), (box.left, box.top))
        painter.polyline(np.array(corners), style)
    else:
        painter.box((box.left, box.bottom), (box.right, box.top), style)


def faded(style: Style, opacity: float) -> Style:
    """A style, fainter."""
    return replace(style, opacity=style.opacity * opacity)
