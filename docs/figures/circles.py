"""Figures of circles and balls that meet them."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GOLD, RED, Sheet, direction, figure, middle, plus, polar


@figure(
    "circle-nearest",
    (-3.4, -1.75, 3.9, 1.75),
    85,
    "A circle, a point outside and one inside, and the perimeter's points nearest to them.",
)
def circle_nearest(sheet: Sheet) -> None:
    """The nearest points of a perimeter."""
    circle = carom.Circle((0.0, 0.0), 1.5)
    sheet.shape(circle)
    for p, words in (((2.9, 1.1), "p"), ((-0.7, 0.35), "p′")):
        q = circle.closest_point(p)
        sheet.line((0.0, 0.0), p if words == "p" else q)
        sheet.arrow(p, q, BLUE)
        sheet.dot(p, BLUE)
        sheet.dot(q, RED, 4.5)
        sheet.label(p, words, 0.0 if words == "p" else -pi / 2, BLUE)
        sheet.label(q, words.replace("p", "q"), -0.9 if words == "p" else pi, RED, 16)
    sheet.dot((0.0, 0.0))
    sheet.label((0.0, 0.0), "u", -pi / 2)


@figure(
    "circle-solid",
    (-2.0, -1.9, 7.0, 2.4),
    72,
    "A ball inside a hollow circle bounces off the inside; a solid one pushes it out.",
)
def circle_solid(sheet: Sheet) -> None:
    """A perimeter and a disc."""
    for x, solid in ((0.0, False), (4.2, True)):
        circle = carom.Circle((x, 0.0), 1.7, solid=solid)
        ball = carom.Ball((x + 1.0, 0.75), radius=0.75)
        contact = circle.detect(ball)
        assert contact is not None
        sheet.shape(circle)
        sheet.ball(plus(ball.position, contact.normal, contact.setback), ball.radius, "muted", ghost=True)
        sheet.ball(ball.position, ball.radius)
        sheet.arrow(contact.point, plus(contact.point, contact.normal, 0.85), BLUE)
        sheet.label(
            plus(contact.point, contact.normal, 0.85), "n", direction(circle.center, ball.position) + pi / 2, BLUE
        )
        sheet.dot(contact.point, RED, 4.5)
        sheet.dot(circle.center)
        sheet.label(circle.center, "u", -pi / 2)
        sheet.label((x - 0.65, 0.55), "solid" if solid else "hollow")


@figure(
    "circle-outside",
    (-2.6, -1.9, 5.0, 1.9),
    80,
    "A ball outside a circle, found too deep, with the point of contact on the line of centres.",
)
def circle_outside(sheet: Sheet) -> None:
    """A ball at a bumper."""
    circle, ball = carom.Circle((0.0, 0.0), 1.5, solid=True), carom.Ball((2.0, 0.65), radius=0.95)
    contact = circle.detect(ball)
    assert contact is not None
    out = plus(ball.position, contact.normal, contact.setback)
    sheet.shape(circle)
    sheet.ball(out, ball.radius, "muted", ghost=True)
    sheet.ball(ball.position, ball.radius)
    sheet.line(circle.center, ball.position)
    rim = plus(contact.point, contact.normal, -contact.setback)
    side = plus((0.0, 0.0), carom.perp(contact.normal), -0.22)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 0.62), BLUE)
    sheet.label(plus(contact.point, contact.normal, 0.35), "n", pi * 0.6, BLUE)
    sheet.span(plus(contact.point, side), plus(rim, side), GOLD)
    sheet.label((2.95, -0.7), "r + R − |c − u|", None, GOLD)
    sheet.dot(contact.point, RED, 4.5)
    sheet.dot(circle.center)
    sheet.label(circle.center, "u", -pi / 2)
    sheet.label(ball.position, "c", 0.0, "ball-1")
    sheet.label(middle(circle.center, polar(circle.center, 1.5, 2.4)), "R")
    sheet.line(circle.center, polar(circle.center, 1.5, 2.4 + 0.35), "wall")
