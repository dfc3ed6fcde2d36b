"""A sheet to draw a figure on: shapes, balls, arrows, angles and words, in world coordinates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np

import carom
from carom.draw import Lettering, Style, SvgPainter, ThemeName
from carom.draw.parts.frame import Frame

if TYPE_CHECKING:
    from pathlib import Path

    from carom.draw import Painter

Vector = tuple[float, float]

#: Pixels of an arrow's head: its length, and half of its width.
HEAD, HALF_HEAD = 9.0, 4.0
#: Pixels: the side of the mark of a right angle, the height of letters, the way from a point to its name.
SQUARE, LETTERS, AWAY = 9.0, 15.0, 13.0
BLUE, RED, GREEN, GOLD, GREY = "moving", "hit", "sensor", "gate", "muted"


@dataclass(frozen=True)
class Figure:
    """A figure: what it says to those who do not see it, the part of the world that it shows, and what draws it."""

    alt: str
    left: float
    bottom: float
    right: float
    top: float
    scale: float
    draw: Callable[[Sheet], None]


FIGURES: dict[str, Figure] = {}


def figure(
    name: str, box: tuple[float, float, float, float], scale: float, alt: str
) -> Callable[[Callable[[Sheet], None]], Callable[[Sheet], None]]:
    """Enter a drawing into `FIGURES`: `box` is left, bottom, right, top, `scale` pixels for a unit of length."""

    def enter(draw: Callable[[Sheet], None]) -> Callable[[Sheet], None]:
        FIGURES[name] = Figure(alt, *box, scale, draw)
        return draw

    return enter


def draw_all(folder: Path) -> None:
    """Write every figure, for light and dark pages; files that would not change are left alone."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in FIGURES:
        for theme in (ThemeName.LIGHT, ThemeName.DARK):
            path = folder / f"{name}-{theme.value}.svg"
            text = svg_of(name, theme)
            if not path.exists() or path.read_text("utf-8") != text:
                path.write_text(text, "utf-8")


def svg_of(name: str, theme: ThemeName) -> str:
    """The SVG text of a figure."""
    plan = FIGURES[name]
    width, height = (plan.right - plan.left) * plan.scale, (plan.top - plan.bottom) * plan.scale
    frame = Frame(
        width=round(width),
        height=round(height),
        stage=carom.Aabb(plan.left, plan.bottom, plan.right, plan.top),
        scale=plan.scale,
        stage_left=0.0,
        stage_top=0.0,
    )
    painter = SvgPainter(frame, theme, title=plan.alt)
    painter.layer("figure")
    plan.draw(Sheet(painter, plan.scale))
    return painter.finish()


class Sheet:
    """Draws marks of one size in pixels, at places in world coordinates."""

    def __init__(self, painter: Painter, scale: float) -> None:
        self._painter = painter
        self._pixel = 1.0 / scale

    # -- things ----------------------------------------------------------------------------------------------------

    def shape(self, shape: carom.Shape, ink: str = "wall", width: float = 2.6) -> None:
        """Draw a shape as it stands."""
        line = Style(ink, width=width)
        if isinstance(shape, carom.Point):
            self.dot(shape.position, ink, 4.0)
        elif isinstance(shape, carom.Segment):
            self._painter.segment(shape.p0, shape.p1, line)
        elif isinstance(shape, carom.Arc):
            self._painter.arc(shape.center, shape.radius, shape.start_angle, shape.end_angle, line)
        elif isinstance(shape, carom.Circle):
            fill = Style(ink, fill=ink, width=width, fill_opacity=0.12) if shape.solid else line
            self._painter.circle(shape.center, shape.radius, fill)

    def ball(self, center: Vector, radius: float, ink: str = "ball-1", *, ghost: bool = False) -> None:
        """Draw a ball and its centre; a ghost is where one was, or would be."""
        if ghost:
            self._painter.circle(center, radius, Style(ink, width=1.5, dash=(4.0, 4.0)))
        else:
            self._painter.circle(center, radius, Style(ink, fill=ink, width=1.8, fill_opacity=0.16))
        self.dot(center, ink, 2.4)

    def box(self, box: carom.Aabb, ink: str = GREEN) -> None:
        """Draw a box along the axes."""
        corners = [(box.left, box.bottom), (box.right, box.bottom), (box.right, box.top), (box.left, box.top)]
        points = np.array([*corners, corners[0]], dtype=np.float64)
        self._painter.polyline(points, Style(ink, fill=ink, width=1.6, fill_opacity=0.08))

    def area(self, points: list[Vector], ink: str) -> None:
        """Tint an area."""
        self._painter.polyline(np.array(points, dtype=np.float64), Style(fill=ink, fill_opacity=0.12))

    def circle(self, center: Vector, radius: float, ink: str = GREY) -> None:
        """Draw a thin dashed circle, one that is only thought of."""
        self._painter.circle(center, radius, Style(ink, width=1.3, dash=(5.0, 4.0)))

    def path(self, points: list[Vector], ink: str, width: float = 1.8) -> None:
        """Draw a line through points."""
        self._painter.polyline(np.array(points, dtype=np.float64), Style(ink, width=width))

    # -- marks -----------------------------------------------------------------------------------------------------

    def dot(self, place: Vector, ink: str = "text", pixels: float = 3.4) -> None:
        """Draw a point."""
        self._painter.circle(place, pixels * self._pixel, Style(fill=ink))

    def line(self, start: Vector, end: Vector, ink: str = GREY, *, dashed: bool = True, width: float = 1.3) -> None:
        """Draw a thin line, dashed if it is only thought of."""
        self._painter.segment(start, end, Style(ink, width=width, dash=(5.0, 4.0) if dashed else ()))

    def arrow(self, start: Vector, end: Vector, ink: str = BLUE, width: float = 2.0) -> None:
        """Draw an arrow."""
        (x, y), (tip_x, tip_y) = start, end
        size = hypot(tip_x - x, tip_y - y)
        ux, uy = (tip_x - x) / size, (tip_y - y) / size
        head, half = HEAD * self._pixel, HALF_HEAD * self._pixel
        neck_x, neck_y = tip_x - head * ux, tip_y - head * uy
        self._painter.segment(start, (neck_x, neck_y), Style(ink, width=width))
        corners = [(neck_x - half * uy, neck_y + half * ux), end, (neck_x + half * uy, neck_y - half * ux)]
        self._painter.polyline(np.array(corners), Style(fill=ink))

    def span(self, start: Vector, end: Vector, ink: str = GOLD) -> None:
        """Draw a distance: a line with a bar across each end."""
        (ax, ay), (bx, by) = start, end
        size = hypot(bx - ax, by - ay)
        nx, ny = 5.0 * self._pixel * (ay - by) / size, 5.0 * self._pixel * (bx - ax) / size
        for first, second in ((start, end), *(((x - nx, y - ny), (x + nx, y + ny)) for x, y in (start, end))):
            self._painter.segment(first, second, Style(ink, width=1.6))

    def angle(self, center: Vector, start: float, end: float, ink: str = GREEN, pixels: float = 34.0) -> None:
        """Draw the angle from one direction counterclockwise to another."""
        self._painter.arc(center, pixels * self._pixel, start, end, Style(ink, width=1.6))

    def right_angle(self, corner: Vector, direction: float, ink: str = GREY) -> None:
        """Mark a right angle, between `direction` and a quarter turn counterclockwise of it."""
        side = SQUARE * self._pixel
        steps = [(direction, 1.0), (direction + pi / 4, 2**0.5), (direction + pi / 2, 1.0)]
        points = [(corner[0] + side * r * cos(a), corner[1] + side * r * sin(a)) for a, r in steps]
        self._painter.polyline(np.array(points), Style(ink, width=1.2))

    def label(
        self, place: Vector, words: str, direction: float | None = None, ink: str = "text", away: float = AWAY
    ) -> None:
        """Write `words`, their middle `away` pixels from a place in a direction (radians); on the place for None."""
        x, y = place
        if direction is not None:
            reach = away + 3.6 * max(0, len(words) - 2) * abs(cos(direction))
            x += reach * self._pixel * cos(direction)
            y += reach * self._pixel * sin(direction)
        # Letters stand on their baseline, a third of their height below their middle.
        at = (x, y - 0.33 * LETTERS * self._pixel)
        self._painter.text(at, words, Lettering(ink=ink, size=LETTERS, anchor="middle"))


def polar(center: Vector, radius: float, angle: float) -> Vector:
    """The point `radius` away from `center` in the direction `angle`."""
    return center[0] + radius * cos(angle), center[1] + radius * sin(angle)


def plus(a: Vector, b: Vector, factor: float = 1.0) -> Vector:
    """A + factor·b."""
    return a[0] + factor * b[0], a[1] + factor * b[1]


def middle(a: Vector, b: Vector) -> Vector:
    """The point half-way."""
    return 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])


def direction(a: Vector, b: Vector) -> float:
    """The direction from a to b."""
    return atan2(b[1] - a[1], b[0] - a[0])
