"""The apron over the trough: lacquer with fans, the table's name, a card of instructions, a window on the balls."""

from __future__ import annotations

from collections.abc import Iterable
from math import pi

from carom.play.pinball.art.paint import CORAL, CREAM, GOLD, INDIGO, NIGHT, TEAL, Canvas, Spot, bow, mixed
from carom.play.pinball.art.parts import DARK_STEEL, FLOOR, LACQUER, LANE_WALL, STEEL, AnyShape, outlines

#: How high the balls stand over the trough that are seen through its window, in units.
WINDOW = (0.12, 1.14)
SHOULDER, DIP = 5.75, 4.95
CARD = ("S-K-Y  MULTIPLIES THE BONUS", "1-2-3  TWICE: THREE BALLS", "ORBITS PAY THE JACKPOTS")


def paint_apron(canvas: Canvas, shapes: Iterable[AnyShape]) -> None:
    """Paint the apron onto an empty canvas, and leave its window open."""
    shapes = list(shapes)
    trough = min(outlines(shapes, ("trough",))[0]), max(outlines(shapes, ("trough",))[0])
    wall = trough[1][0]
    edge = [(0.1, SHOULDER), *_dip(0.5 * wall), (wall, SHOULDER)]
    canvas.fill([(x, y + 0.28) for x, y in edge] + [(wall, 3.0), (0.1, 3.0)], (0, 0, 0, 80))
    canvas.fill([*edge, (wall, FLOOR + 0.1), (0.1, FLOOR + 0.1)], LACQUER)
    _fans(canvas, wall)
    canvas.stroke(edge, 0.3, mixed(GOLD, NIGHT, 0.6))
    canvas.stroke(edge, 0.18, GOLD)
    canvas.stroke(edge, 0.06, CREAM)
    _window(canvas, trough)
    canvas.stroke([(wall, SHOULDER), (wall, FLOOR + 0.2)], 0.3, DARK_STEEL)
    canvas.stroke([(wall, SHOULDER), (wall, FLOOR + 0.2)], 0.17, STEEL)
    _card(canvas, (13.95, 0.28))
    canvas.words("CAROM", (4.9, 1.55), 2.1, GOLD, 0.22)
    canvas.words("C O M E T", (4.9, 0.18), 0.95, TEAL, 0.3)
    for side in (-1.0, 1.0):
        canvas.stroke([(4.9 + side * 2.75, 0.2), (4.9 + side * 4.1, 0.2)], 0.07, CORAL)


def paint_trough(canvas: Canvas) -> None:
    """Darken the ground below the apron."""
    canvas.fill([(0.0, DIP), (LANE_WALL, DIP), (LANE_WALL, FLOOR), (0.0, FLOOR)], (*NIGHT, 215))


def _dip(middle: float) -> list[Spot]:
    """The apron's edge, lower in the middle, where balls are to be seen as they drain."""
    return [(middle - 5.2, SHOULDER), (middle - 3.6, DIP), (middle + 3.6, DIP), (middle + 5.2, SHOULDER)]


def _fans(canvas: Canvas, wall: float) -> None:
    """Paint scales of fans over the apron."""
    for row in range(4):
        for column in range(-1, 7):
            center = (column * 3.1 + (1.55 if row % 2 else 0.0), -1.6 + row * 1.55)
            for radius, colour in ((1.5, INDIGO), (1.1, mixed(INDIGO, NIGHT, 0.5)), (0.7, INDIGO)):
                path = [
                    (min(max(x, 0.1), wall - 0.1), min(y, DIP - 0.12))
                    for x, y in bow(center, radius, 0.0, pi, 0.15)
                    if y > FLOOR
                ]
                if len(path) > 1:
                    canvas.stroke(path, 0.07, colour)


def _window(canvas: Canvas, trough: tuple[Spot, Spot]) -> None:
    """Cut a window along the trough, framed in brass."""
    (x, y), (end_x, end_y) = trough
    low, high = WINDOW
    slope = (end_y - y) / (end_x - x)
    begin, end = x + 0.6, end_x - 0.45

    def frame(by: float) -> list[Spot]:
        """The window's corners, farther out by some units."""
        return [
            (begin - by, y + slope * (begin - x) + low - by),
            (end + by, y + slope * (end - x) + low - by),
            (end + by, y + slope * (end - x) + high + by),
            (begin - by, y + slope * (begin - x) + high + by),
        ]

    canvas.fill(frame(0.14), GOLD)
    canvas.fill(frame(0.06), mixed(GOLD, NIGHT, 0.6))
    canvas.clear(frame(0.0))


def _card(canvas: Canvas, middle: Spot) -> None:
    """Paint the card with what is to be done."""
    x, y = middle
    half, high = 3.85, 0.82
    corners = [(x - half, y - high), (x - half, y + high), (x + half, y + high), (x + half, y - high)]
    canvas.fill([(a + 0.1, b - 0.12) for a, b in corners], (0, 0, 0, 120))
    canvas.fill(corners, CREAM)
    canvas.stroke(corners, 0.06, CORAL, closed=True)
    for number, line in enumerate(CARD):
        canvas.words(line, (x, y + 0.5 - 0.5 * number), 0.58, NIGHT)
