"""The marks that a picture is made of: shapes, arrows, pivots, balls, hits, tracks, on the stage and in the legend."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from math import cos, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.tracks import BANDS
from carom.draw.paint.painter import Style
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.point import Point
from carom.shapes.segment import Segment

if TYPE_CHECKING:
    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.looks import Look
    from carom.shapes.aabb import Aabb
    from carom.shapes.shape import Shape

#: Pixels: half the width and the length of an arrow's head, the length of its shaft, the radius of a pivot's ring.
ARROW_HALF, ARROW_HEAD, ARROW_SHAFT, PIVOT_RING = 4.5, 7.0, 9.0, 3.2
#: Pixels: the dots of the weakest and of the strongest hits, in how many sizes.
SMALLEST_HIT, LARGEST_HIT, HIT_SIZES = 1.2, 4.8, 6
#: Pixels: the width of a track. Opacity of its youngest and of its oldest band.
TRACK_WIDTH, YOUNGEST, OLDEST = 1.5, 0.9, 0.1
#: Pixels: the radius of a reticle, and how far its four ticks reach in and out.
RETICLE, RETICLE_TICK = 9.0, 4.0
#: A glow's strokes, the widest first: pixels of width, and opacity where it is brightest.
GLOW = ((16.0, 0.22), (9.0, 0.4), (4.0, 0.9))
#: Radians between two points of a sector's edge.
SECTOR_STEP = pi / 45.0

HIT = Style(fill="hit", opacity=0.55)
BOX = Style("box", width=1.0, dash=(3.0, 3.0))
SECTOR = Style("sector", width=1.0, dash=(4.0, 4.0), opacity=0.7)
SECTOR_AREA = Style(fill="sector", fill_opacity=0.12)
VELOCITY = Style("velocity", width=1.4)
TANGENT = Style("tangent", width=1.6, dash=(5.0, 3.5))
NORMAL = Style("normal", width=1.6)


def shape_mark(painter: Painter, frame: Frame, shape: Shape, look: Look, weight: float) -> None:
    """Draw one shape, as it stands, its lines' width times `weight`."""
    line = look.line(weight)
    if isinstance(shape, Point):
        painter.circle(shape.position, frame.units(look.dot * weight), look.spot())
    else:
        line_mark(painter, shape, look.area(weight) if isinstance(shape, Circle) and shape.solid else line)


def line_mark(painter: Painter, shape: Shape, style: Style) -> None:
    """Draw a segment, an arc or a circle in a style."""
    if isinstance(shape, Segment):
        painter.segment(shape.p0, shape.p1, style)
    elif isinstance(shape, Arc):
        painter.arc(shape.center, shape.radius, shape.start_angle, shape.end_angle, style)
    elif isinstance(shape, Circle):
        painter.circle(shape.center, shape.radius, style)


def glow_mark(painter: Painter, frame: Frame, shape: Shape, strength: float, weight: float) -> None:
    """Draw the glow of a shape that was hit, `strength` from 0 to 1."""
    for width, opacity in GLOW:
        style = Style("glow", width=width * max(weight, 0.6), opacity=opacity * strength)
        if isinstance(shape, Point):
            painter.circle(shape.position, frame.units(0.5 * style.width), Style(fill="glow", opacity=style.opacity))
        else:
            line_mark(painter, shape, style)


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
    painter.polyline(np.array(corners), Style(fill=style.stroke, opacity=style.opacity))


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


def sector_mark(painter: Painter, arc: Arc) -> None:
    """Draw the sector of an arc: the area, and the two radii that bound it."""
    sweep = (arc.end_angle - arc.start_angle) % (2.0 * pi)
    angles = arc.start_angle + np.linspace(0.0, sweep, max(2, int(sweep / SECTOR_STEP)))
    (x, y), radius = arc.center, arc.radius
    edge = np.column_stack([x + radius * np.cos(angles), y + radius * np.sin(angles)])
    painter.polyline(np.concatenate([[[x, y]], edge]), SECTOR_AREA)
    for end in (arc.p0, arc.p1):
        painter.segment(arc.center, end, SECTOR)


def box_mark(painter: Painter, box: Aabb, style: Style = BOX) -> None:
    """Draw a box: four lines, or the area where the style has a fill alone."""
    corners = ((box.left, box.bottom), (box.right, box.bottom), (box.right, box.top), (box.left, box.top))
    if style.stroke is None:
        painter.polyline(np.array(corners), style)
        return
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        painter.segment(start, end, style)


def faded(style: Style, opacity: float) -> Style:
    """A style, fainter."""
    return replace(style, opacity=style.opacity * opacity)
