"""A table in a part of the window: its picture, and what the mouse points at in it."""

from __future__ import annotations

from math import cos, hypot, sin
from typing import Any, TypeAlias

import pygame

import carom
from carom import draw
from carom.play.letters import Colour
from carom.play.pen import Pen
from carom.play.toy import colours
from carom.play.toy.figures import Figures, Tree, tree_of
from carom.play.toy.settings import Settings
from carom.play.toy.table import Table

Vector: TypeAlias = tuple[float, float]

#: Units of the table around its walls.
MARGIN = 0.6
#: Steps that an arc's mark is drawn in, and pixels that marks are wide and stand off what they mark.
ARC_STEPS, WIDE, OFF = 48, 3, 4
#: Seconds: the arrow of a throw is as long as the ball would fly in that time.
ARROW = 0.12


class View:
    """A table drawn in `area` of the window, `times` as large.

    Attributes:
        table: The table.
        area: Where in the window.
        figures: How many tests and collisions it has.
        tree: What its broad phase looks like.
    """

    def __init__(self, table: Table, area: pygame.Rect, times: int = 1) -> None:
        self.table = table
        self.area = area
        self.figures = Figures(table)
        self._live = self._drawn(times)
        self._shown: tuple[object, ...] = ()
        self._largest = -1.0
        self.tree = Tree(0, 0, 0.0, 0.0, 0)

    def _drawn(self, times: int) -> draw.Live:
        """The table's picture, so many times as large."""
        size = self.area.width * times, self.area.height * times
        return draw.Live(self.table.world, around(self.table.world), size, zoom=times)

    def magnify(self, times: int) -> None:
        """Draw the table `times` as large from now on."""
        live, self._live = self._live, self._drawn(times)
        self._live.layers = live.layers

    @property
    def reach(self) -> float:
        """How far from a shape the mouse still points at it, in units of the table."""
        return 6.0 / self._live.frame.scale

    def place(self, pixel: tuple[int, int]) -> Vector:
        """Where on the table a pixel of the window is."""
        return self._live.frame.world(pixel[0] - self.area.left, pixel[1] - self.area.top)

    def pixel(self, place: Vector) -> Vector:
        """Where in the window a place of the table is."""
        x, y = self._live.frame.pixel(*place)
        return x + self.area.left, y + self.area.top

    def note(self, hits: carom.Hits) -> None:
        """Take note of a step."""
        self._live.note(hits)

    def forget(self) -> None:
        """Forget tracks and hits."""
        self._live.forget()

    def renew(self) -> None:
        """Look at the shapes anew, which were changed."""
        self.figures = Figures(self.table)
        self._largest = -1.0
        self._live.refresh()
        self.measure()

    def look(self, settings: Settings) -> None:
        """Show what the settings say, where that is not what is shown."""
        shown = (settings.layers, settings.broad_phase, settings.levels)
        if shown != self._shown:
            if shown[1:] != self._shown[1:]:
                self._largest = -1.0
            self._shown = shown
            self._live.layers = settings.layers

    def measure(self) -> None:
        """Look at the broad phase anew where it was set otherwise, or there is a larger ball."""
        largest = max((ball.radius for ball in self.table.world.balls), default=0.0)
        if largest != self._largest:
            if self._largest >= 0.0 and draw.Layer.CELLS in self._live.layers:
                self._live.refresh()
            self._largest = largest
            self.tree = tree_of(self.table.world)

    def draw(self, pen: Pen) -> None:
        """Draw the table."""
        self._live.draw(pen.surface.subsurface(pen.area(self.area)))
        if self.table.world.statistics.sleeping:
            for ball in self.table.world.balls:
                if ball.asleep:
                    self._hollow(pen, ball)

    def _hollow(self, pen: Pen, ball: carom.Ball) -> None:
        """Make a ring of a ball that sleeps."""
        inside = ball.radius * self._live.frame.scale - WIDE
        pen.circle(colours.STAGE, self.pixel(ball.position), max(1.0, inside))

    def mark(self, pen: Pen, shape: Any) -> None:
        """Mark the shape that the mouse points at."""
        ways: dict[str, Any] = {"segment": self._mark_line, "gate": self._mark_line, "arc": self._mark_arc}
        ways.get(shape.kind, self._mark_round)(pen, shape)

    def _mark_line(self, pen: Pen, shape: Any) -> None:
        pen.line(colours.ACCENT, self.pixel(shape.p0), self.pixel(shape.p1), WIDE + 2)

    def _mark_arc(self, pen: Pen, shape: Any) -> None:
        (x, y), turn = shape.center, (shape.end_angle - shape.start_angle) / ARC_STEPS
        angles = [shape.start_angle + step * turn for step in range(ARC_STEPS + 1)]
        points = [self.pixel((x + shape.radius * cos(angle), y + shape.radius * sin(angle))) for angle in angles]
        pen.lines(colours.ACCENT, points, WIDE + 1)

    def _mark_round(self, pen: Pen, shape: Any) -> None:
        radius = getattr(shape, "radius", 0.0) * self._live.frame.scale + OFF
        pen.circle(colours.ACCENT, self.pixel(shape.position), radius, WIDE - 1)

    def mark_throw(self, pen: Pen, ball: carom.Ball, velocity: Vector, target: Vector) -> None:
        """Draw the way to the mouse, and the velocity that a ball would be thrown with."""
        x, y = ball.position
        pen.thread(colours.MUTED, self.pixel((x, y)), self.pixel(target))
        tip = (x + ARROW * velocity[0], y + ARROW * velocity[1])
        self._mark_round(pen, ball)
        arrow(pen, colours.WARM, self.pixel((x, y)), self.pixel(tip))


def around(world: carom.World) -> carom.Aabb:
    """The box around all shapes, and a margin."""
    boxes = [shape.aabb for shape in world.shapes]
    return carom.Aabb(
        min(box.left for box in boxes) - MARGIN,
        min(box.bottom for box in boxes) - MARGIN,
        max(box.right for box in boxes) + MARGIN,
        max(box.top for box in boxes) + MARGIN,
    )


def arrow(pen: Pen, colour: Colour, start: Vector, tip: Vector) -> None:
    """Draw an arrow, unless it is shorter than its head."""
    along_x, along_y = tip[0] - start[0], tip[1] - start[1]
    long = hypot(along_x, along_y)
    if long < 10.0:
        return
    x, y = along_x / long, along_y / long
    neck = (tip[0] - 10.0 * x, tip[1] - 10.0 * y)
    pen.line(colour, start, neck, WIDE)
    wings = [(neck[0] - 5.0 * y, neck[1] + 5.0 * x), (neck[0] + 5.0 * y, neck[1] - 5.0 * x)]
    pen.polygon(colour, [tip, *wings])
