"""How each kind of shape is drawn: its outline, its sign, and the places of it that marks stand at."""

from __future__ import annotations

from math import atan2, pi
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.paint.painter import Style
from carom.draw.parts.looks import GATE, rounded
from carom.draw.parts.marks import arrow_mark
from carom.geometry.arc import middle_direction
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.gate import Gate
from carom.shapes.point import Point
from carom.shapes.segment import Segment

if TYPE_CHECKING:
    from collections.abc import Iterable

    from carom.draw.paint.painter import Lines, Painter, Vector
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.looks import Look
    from carom.shapes.shape import Shape

#: A glow's strokes, the widest first: pixels of width, and opacity where it is brightest.
GLOW = ((16.0, 0.22), (9.0, 0.4), (4.0, 0.9))
#: Radians between two points of a sector's edge.
SECTOR_STEP = pi / 45.0
SECTOR = Style("sector", width=1.0, dash=(4.0, 4.0), opacity=0.7)
SECTOR_AREA = Style(fill="sector", fill_opacity=0.12)


def shape_mark(painter: Painter, frame: Frame, shape: Shape, look: Look, weight: float) -> None:
    """Draw one shape, as it stands, its lines' width times `weight`."""
    line = look.line(weight)
    if isinstance(shape, Point):
        painter.circle(shape.position, frame.units(look.dot * weight), look.spot())
    else:
        line_mark(painter, shape, look.area(weight) if isinstance(shape, Circle) and shape.solid else line)


def line_mark(painter: Lines, shape: Shape, style: Style) -> None:
    """Draw the outline of a shape in a style; a point has none."""
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


def sign_mark(painter: Painter, frame: Frame, shape: Shape) -> None:
    """Draw the arrow of a gate's open way; other kinds have no sign."""
    if isinstance(shape, Gate):
        arrow_mark(painter, frame, shape.position, open_way(shape), GATE.style)


def open_way(gate: Gate) -> Vector:
    """The unit normal of `gate` on the side that it lets balls pass to, however slanted its direction is."""
    (x, y), (dx, dy) = gate.normal, gate.direction
    return (x, y) if x * dx + y * dy > 0.0 else (-x, -y)


def has_sector(shape: Shape) -> bool:
    """Whether `sector_mark` draws anything."""
    return isinstance(shape, Arc)


def sector_mark(painter: Painter, arc: Shape) -> None:
    """Draw the sector of an arc: the area, and the two radii that bound it. Other kinds have none."""
    if not isinstance(arc, Arc):
        return
    sweep = (arc.end_angle - arc.start_angle) % (2.0 * pi)
    angles = arc.start_angle + np.linspace(0.0, sweep, max(2, int(sweep / SECTOR_STEP)))
    (x, y), radius = arc.center, arc.radius
    edge = np.column_stack([x + radius * np.cos(angles), y + radius * np.sin(angles)])
    painter.polyline(np.concatenate([[[x, y]], edge]), SECTOR_AREA)
    for end in (arc.p0, arc.p1):
        painter.segment(arc.center, end, SECTOR)


def ends_of(shapes: Iterable[Shape]) -> frozenset[Vector]:
    """The ends of segments, gates and arcs, rounded."""
    return frozenset(
        rounded(end) for shape in shapes if isinstance(shape, Segment | Arc) for end in (shape.p0, shape.p1)
    )


def tangents_of(shape: Shape) -> list[tuple[Vector, Vector]]:
    """The ends of a segment or an arc, the top of a circle, and the unit tangents that lead out of it there."""
    if isinstance(shape, Segment):  # whose own point into it: each is the outward one of the other end
        return [(shape.p0, shape.t1), (shape.p1, shape.t0)]
    if isinstance(shape, Arc):
        return [(shape.p0, shape.t0), (shape.p1, shape.t1)]
    if isinstance(shape, Circle):
        return [(top_of(shape), (1.0, 0.0)), (top_of(shape), (-1.0, 0.0))]
    return []


def middle_of(shape: Shape) -> tuple[Vector, Vector] | None:
    """The middle of a segment or an arc, the top of a circle, and the unit normal there; None for a point."""
    if isinstance(shape, Segment):
        return shape.position, shape.normal
    if isinstance(shape, Arc):
        (x, y), (ax, ay), (bx, by) = shape.center, shape.p0, shape.p1
        nx, ny = middle_direction(ax - x, ay - y, bx - x, by - y)
        return (x + shape.radius * nx, y + shape.radius * ny), (nx, ny)
    return (top_of(shape), (0.0, 1.0)) if isinstance(shape, Circle) else None


def top_of(circle: Circle) -> Vector:
    """The uppermost place of a circle."""
    return circle.center[0], circle.center[1] + circle.radius


def anchor(shape: Shape) -> Vector:
    """The place of a shape that its name stands beside: its middle, inside of a solid circle."""
    middle = middle_of(shape)
    return shape.position if middle is None or (isinstance(shape, Circle) and shape.solid) else middle[0]


def part_near(shape: Shape, point: Vector, reach: float) -> Shape:
    """What of a shape is no farther from a point of it than `reach`, along a line; of a round one, along its arc."""
    x, y = point
    if isinstance(shape, Segment):
        (start_x, start_y), (dx, dy) = shape.p0, shape.t0
        along = (x - start_x) * dx + (y - start_y) * dy
        low, high = max(0.0, along - reach), min(shape.length, along + reach)
        if low >= high:
            return shape
        return Segment((start_x + low * dx, start_y + low * dy), (start_x + high * dx, start_y + high * dy))
    if isinstance(shape, Circle | Arc) and shape.radius > reach:
        along, turn = atan2(y - shape.center[1], x - shape.center[0]), reach / shape.radius
        low, high = along - turn, along + turn
        if isinstance(shape, Arc):
            begin, sweep = shape.start_angle, (shape.end_angle - shape.start_angle) % (2.0 * pi)
            along = (along - begin) % (2.0 * pi)
            low, high = begin + max(0.0, along - turn), begin + min(sweep, along + turn)
        return Arc(shape.center, shape.radius, low, high) if low < high else shape
    return shape
