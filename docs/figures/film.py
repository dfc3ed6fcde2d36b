"""Figures of the film: flights and cells."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GREEN, GREY, RED, Sheet, figure, plus


@figure(
    "film-flights",
    (-0.4, -0.5, 7.4, 3.2),
    85,
    "Two flights of a ball, which begin at its impacts; what is seen at the ends of steps is read off them.",
)
def film_flights(sheet: Sheet) -> None:
    """A ball that is thrown onto a floor: its path in fine steps, and what four steps a second show."""
    floor = carom.Segment((-0.2, 0.0), (7.2, 0.0), elasticity=0.8)
    sheet.shape(floor)
    places = []
    for dt in (1 / 64, 1 / 4):
        world = carom.World(gravity=(0.0, -4.0), detection="continuous")
        world.add(carom.Segment((-0.2, 0.0), (7.2, 0.0), elasticity=0.8))
        ball = world.add(carom.Ball((0.2, 2.4), 0.25, velocity=(2.0, 0.6)))
        places.append([ball.position])
        for _ in range(round(3.0 / dt)):
            for hit in world.step(dt):
                if len(places) == 1:
                    sheet.dot(hit.point, RED, 4.5)
                    sheet.label(hit.point, "impact", -pi / 2, RED)
            places[-1].append(ball.position)
    sheet.path(places[0], BLUE)
    for place in places[1]:
        sheet.dot(place, GREEN, 3.4)
    sheet.ball(places[1][0], 0.25)
    sheet.label(places[1][2], "shown at the end of a step", 0.5, GREEN, 14)


@figure(
    "film-cells",
    (-0.3, -0.3, 6.3, 4.3),
    85,
    "A ball is looked for near its cell; where it leaves the dashed square, it is filed anew.",
)
def film_cells(sheet: Sheet) -> None:
    """Cells, a ball where it was filed and where it has come, and the square that it leaves next."""
    for column in range(7):
        sheet.line((column, 0.0), (column, 4.0), GREY, dashed=False, width=0.8)
    for line in range(5):
        sheet.line((0.0, line), (6.0, line), GREY, dashed=False, width=0.8)
    filed = (2.4, 1.7)
    corners = [(1.75, 0.75), (3.25, 0.75), (3.25, 2.25), (1.75, 2.25)]
    for k in range(4):
        sheet.line(corners[k - 1], corners[k], GREEN)
    now = plus(filed, (0.75, 0.4))
    sheet.ball(filed, 0.22, "ball-1", ghost=True)
    sheet.ball(now, 0.22, "ball-1")
    sheet.arrow(now, plus(now, (0.9, 0.5)), BLUE)
    sheet.dot(filed, GREEN)
    sheet.label(filed, "filed here", pi, GREEN, 70)
    sheet.ball((4.3, 2.6), 0.25, "ball-4")
    sheet.ball((1.3, 3.4), 0.2, "ball-2")
