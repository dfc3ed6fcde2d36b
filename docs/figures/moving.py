"""Figures of shapes that move, and of balls under gravity."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GOLD, GREEN, GREY, RED, Sheet, figure, plus


@figure(
    "moving-kick",
    (-0.8, -0.8, 7.0, 3.5),
    82,
    "A flipper turns about its pivot; the surface at the contact moves across the lever.",
)
def moving_kick(sheet: Sheet) -> None:
    """The velocity of a turning surface."""
    flipper = carom.Segment((0.0, 0.0), (5.0, 0.6), motion="kinematic", pivot=(0.0, 0.0), angular_velocity=0.55)
    ball = carom.Ball((3.4, 0.98), 0.6, velocity=(0.6, -1.0))
    contact = flipper.detect(ball)
    assert contact is not None
    lever = contact.point
    surface = plus((0.0, 0.0), carom.perp(lever), flipper.angular_velocity)
    sheet.shape(flipper)
    sheet.ball(ball.position, ball.radius)
    sheet.arrow((0.0, 0.0), lever, GREY, 1.6)
    sheet.label((1.6, 0.0), "w", -pi / 2, GREY)
    sheet.arrow(ball.position, plus(ball.position, ball.velocity), GREEN)
    sheet.label(plus(ball.position, ball.velocity), "v", -0.3, GREEN)
    sheet.arrow(lever, plus(lever, surface), BLUE)
    sheet.label(plus(lever, surface), "ω·perp(w)", 0.1, BLUE, 34)
    before = ball.position
    ball.respond(contact)
    sheet.arrow(before, plus(before, ball.velocity, 0.3), RED, 2.6)
    sheet.label(plus(before, ball.velocity, 0.3), "v′ (×0.3)", pi, RED, 26)
    sheet.dot((0.0, 0.0), "moving", 5.0)
    sheet.angle((0.0, 0.0), 0.2, 1.1, BLUE, 60.0)
    sheet.label((0.95, 0.75), "ω", None, BLUE)
    sheet.dot(contact.point, RED, 4.5)


@figure(
    "gravity-depth",
    (-2.8, -1.6, 4.6, 2.4),
    80,
    "A falling ball is found below the floor; at contact it was higher and slower.",
)
def gravity_depth(sheet: Sheet) -> None:
    """The approach at contact, not at the depth found."""
    floor, ball = carom.Segment((-2.4, 0.0), (2.2, 0.0)), carom.Ball((0.0, 0.25), 1.0)
    contact = floor.detect(ball)
    assert contact is not None
    sheet.shape(floor)
    sheet.ball((0.0, 1.0), 1.0, "muted", ghost=True)
    sheet.ball(ball.position, 1.0)
    sheet.arrow((0.0, 1.0), (0.0, 0.45), GREEN)
    sheet.arrow(ball.position, (0.0, -1.2), RED)
    sheet.line((0.1, 0.85), (1.5, 1.25), GREEN)
    sheet.label((1.5, 1.3), "s at contact", 0.0, GREEN, 18)
    sheet.label((0.0, -1.2), "s as found: s² is 2·|g·n|·setback more", 0.0, RED, 24)
    sheet.span((-1.55, 0.0), (-1.55, -0.75), GOLD)
    sheet.line((-1.55, -0.75), (0.0, -0.75), GOLD)
    sheet.label((-1.55, -0.38), "setback", pi, GOLD, 18)
    sheet.arrow((3.4, 2.0), (3.4, 1.2), GREY)
    sheet.label((3.4, 1.6), "g", 0.0, GREY)


@figure("turning-limits", (-1.0, -1.4, 5.6, 2.6), 80, "A flipper between its two stops, drawn at both and in between.")
def turning_limits(sheet: Sheet) -> None:
    """A flipper's stops."""
    flipper = carom.Segment((0.0, 0.0), (3.6, -0.9), motion="kinematic", pivot=(0.0, 0.0), turn_limits=(0.0, 0.9))
    for turn, words in ((0.0, "low = 0"), (0.45, ""), (0.9, "high")):
        flipper.rotate((0.0, 0.0), turn)
        tip = max(flipper.p0, flipper.p1)
        if turn == 0.45:
            sheet.line((0.0, 0.0), tip, BLUE)
        else:
            sheet.shape(flipper, "moving")
        sheet.label(tip, words, 0.0, away=20)
    sheet.angle((0.0, 0.0), -0.245, 0.655, GREEN, 150.0)
    sheet.arrow((1.83, 0.55), (1.62, 0.93), GREEN)
    sheet.label((2.15, 0.35), "ω", None, GREEN)
    sheet.dot((0.0, 0.0), "moving", 5.0)
    sheet.label((0.0, 0.0), "pivot", pi)
