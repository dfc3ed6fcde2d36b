"""Figures of a ball and a point."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GOLD, GREEN, RED, Sheet, figure, plus


@figure(
    "point-contact",
    (-2.6, -1.9, 4.4, 1.9),
    85,
    "A ball that overlaps a point, before and after it is moved out along the normal.",
)
def point_contact(sheet: Sheet) -> None:
    """Point, normal and setback."""
    ball, point = carom.Ball((0.0, 0.3), radius=1.2, velocity=(2.0, -0.5)), carom.Point((0.85, -0.1))
    contact = point.detect(ball)
    assert contact is not None
    out = plus(ball.position, contact.normal, contact.setback)
    sheet.ball(out, ball.radius, "muted", ghost=True)
    sheet.ball(ball.position, ball.radius)
    sheet.arrow(ball.position, plus(ball.position, ball.velocity, 0.9), GREEN)
    sheet.label(plus(ball.position, ball.velocity, 0.9), "v", 0.0, GREEN)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 2.5), BLUE)
    sheet.label(plus(contact.point, contact.normal, 2.5), "n", pi * 0.8, BLUE)
    rim = plus(contact.point, contact.normal, -contact.setback)
    side = plus((0.0, 0.0), carom.perp(contact.normal), 0.2)
    sheet.span(plus(contact.point, side), plus(rim, side), GOLD)
    sheet.label((1.85, -0.62), "setback", None, GOLD)
    sheet.dot(contact.point, RED, 4.5)
    sheet.label(contact.point, "q", -pi * 0.8, RED, 16)
    sheet.label(ball.position, "c", pi / 2, "ball-1")
    sheet.label((3.2, -1.4), "|c − q| < r")


@figure("point-deep", (-2.2, -1.6, 6.2, 1.7), 80, "A point beyond the ball's centre, and a point at the centre itself.")
def point_deep(sheet: Sheet) -> None:
    """What goes wrong where a ball is found late."""
    late, point = carom.Ball((0.0, 0.0), radius=1.2, velocity=(1.0, 0.0)), carom.Point((-0.65, 0.5))
    contact = point.detect(late)
    assert contact is not None
    sheet.ball(late.position, late.radius)
    sheet.arrow(late.position, (1.7, 0.0), GREEN)
    sheet.label((1.7, 0.0), "v", pi / 2, GREEN)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 1.05), BLUE)
    sheet.label(plus(contact.point, contact.normal, 0.5), "n", -pi * 0.7, BLUE)
    sheet.dot(contact.point, RED, 4.5)
    sheet.label(contact.point, "q", pi / 2, RED)
    centred = carom.Ball((4.4, 0.0), radius=1.2, velocity=(1.0, 0.0))
    contact = carom.Point((4.4, 0.0)).detect(centred)
    assert contact is not None
    assert contact.normal == (-1.0, 0.0)
    sheet.ball(centred.position, centred.radius)
    sheet.arrow(centred.position, (6.1, 0.0), GREEN)
    sheet.label((5.95, 0.0), "v", pi / 2, GREEN)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 0.8), BLUE)
    sheet.label((3.6, 0.0), "n", pi / 2, BLUE)
    sheet.dot(contact.point, RED, 4.5)
    sheet.label(contact.point, "c = q", -pi / 2, RED)
