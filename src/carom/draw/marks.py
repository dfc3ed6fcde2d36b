"""The marks that a picture is made of: shapes, arrows, pivots, balls, hits, tracks, on the stage and in the legend."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.draw.painter import Style
from carom.draw.tracks import BANDS
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.point import Point
from carom.shapes.segment import Segment

if TYPE_CHECKING:
    from carom.draw.frame import Frame
    from carom.draw.looks import Look
    from carom.draw.painter import Painter, Vector
    from carom.shapes.shape import Shape

#: Pixels: half the width and the length of an arrow's head, the length of its shaft, the radius of a pivot's ring.
ARROW_HALF, ARROW_HEAD, ARROW_SHAFT, PIVOT_RING = 4.5, 7.0, 9.0, 3.2
#: Pixels: the dots of the weakest and of the strongest hits, in how many sizes.
SMALLEST_HIT, LARGEST_HIT, HIT_SIZES = 1.2, 4.8, 6
#: Pixels: the width of a track. Opacity of its youngest and of its oldest band.
TRACK_WIDTH, YOUNGEST, OLDEST = 1.5, 0.9, 0.1


def shape_mark(painter: Painter, frame: Frame, shape: Shape, look: Look, weight: float) -> None:
    """Draw one shape, as it stands, its lines' width times `weight`."""
    line = look.line(weight)
    if isinstance(shape, Point):
        painter.circle(shape.position, frame.units(look.dot * weight), look.spot())
    elif isinstance(shape, Segment):
        painter.segment(shape.p0, shape.p1, line)
    elif isinstance(shape, Arc):
        painter.arc(shape.center, shape.radius, shape.start_angle, shape.end_angle, line)
    elif isinstance(shape, Circle):
        painter.circle(shape.center, shape.radius, look.area(weight) if shape.solid else line)


def arrow_mark(painter: Painter, frame: Frame, position: Vector, direction: Vector, style: Style) -> None:
    """Draw an arrow from `position` along the unit vector `direction`, of one size in every picture."""
    half, head, shaft = frame.units(ARROW_HALF), frame.units(ARROW_HEAD), frame.units(ARROW_SHAFT)
    (x, y), (dx, dy) = position, direction
    neck_x, neck_y = x + shaft * dx, y + shaft * dy
    painter.segment(position, (neck_x, neck_y), style)
    corners = [
        (neck_x - half * dy, neck_y + half * dx),
        (neck_x + head * dx, neck_y + head * dy),
        (neck_x + half * dy, neck_y - half * dx),
    ]
    painter.polyline(np.array(corners), Style(fill=style.stroke))


def pivot_mark(painter: Painter, frame: Frame, position: Vector) -> None:
    """Draw the ring around the point that a moving part turns about."""
    painter.circle(position, frame.units(PIVOT_RING), Style("moving", fill="stage", width=1.6))


def ball_mark(painter: Painter, frame: Frame, center: Vector, radius: float, ink: str) -> None:
    """Draw a ball, with a rim that keeps it apart from its neighbours while it is large enough for one."""
    pixels = radius * frame.scale
    rim = min(1.5, 0.2 * pixels)
    if rim < 0.3:
        painter.circle(center, radius, Style(fill=ink))
    else:
        painter.circle(center, radius - 0.5 * frame.units(rim), Style("stage", fill=ink, width=rim))


def hit_mark(painter: Painter, frame: Frame, center: Vector, strength: float, weight: float) -> None:
    """Draw a hit point of a `strength` from 0 to 1; the dot's area grows with it, in `HIT_SIZES` sizes."""
    size = round(min(1.0, max(0.0, strength)) ** 0.5 * (HIT_SIZES - 1)) / (HIT_SIZES - 1)
    radius = (SMALLEST_HIT + (LARGEST_HIT - SMALLEST_HIT) * size) * weight
    painter.circle(center, frame.units(radius), Style(fill="hit", opacity=0.55))


def track_style(ink: str, band: int) -> Style:
    """The style of a track in one of its bands of age, 0 the oldest."""
    share = band / (BANDS - 1)
    return Style(ink, width=TRACK_WIDTH, opacity=OLDEST + (YOUNGEST - OLDEST) * share * share)
