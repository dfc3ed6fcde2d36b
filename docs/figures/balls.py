"""Figures of two balls that meet."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GREEN, RED, Sheet, figure, plus


@figure(
    "ball-ball",
    (-3.4, -2.0, 4.2, 2.0),
    85,
    "Two balls at contact: before, their velocities; after, the normal parts exchanged.",
)
def ball_ball(sheet: Sheet) -> None:
    """Two equal balls exchange the normal parts of their velocities."""
    one, other = carom.Ball((-1.0, -0.45), 1.0, velocity=(1.5, 0.55)), carom.Ball((0.78, 0.4), 1.0)
    contact = one.detect(other)
    assert contact is not None
    n = contact.normal
    for ball, ink, words in ((one, "ball-1", "c₁"), (other, "ball-4", "c₂")):
        sheet.ball(ball.position, ball.radius, ink)
        sheet.label(ball.position, words, pi * 0.7, ink, 15)
    sheet.line(plus(one.position, n, -1.7), plus(other.position, n, 2.6))
    sheet.arrow(one.position, plus(one.position, one.velocity, 1.0), GREEN)
    sheet.label(plus(one.position, one.velocity), "v₁", -pi / 2, GREEN)
    other.respond(contact)
    sheet.arrow(other.position, plus(other.position, other.velocity, 1.0), BLUE, 2.6)
    sheet.label(plus(other.position, other.velocity), "v₂′", -0.5, BLUE, 18)
    sheet.arrow(one.position, plus(one.position, one.velocity, 3.0), BLUE, 2.6)
    sheet.label(plus(one.position, one.velocity, 3.0), "v₁′ (×3)", -1.2, BLUE, 22)
    sheet.dot(contact.point, RED, 4.5)
    sheet.arrow(plus(other.position, n, 1.75), plus(other.position, n, 2.5), "text", 1.6)
    sheet.label(plus(other.position, n, 2.5), "n", pi / 2)


@figure(
    "ball-apart",
    (-2.6, -1.5, 5.9, 1.5),
    75,
    "Two overlapping balls move apart; the one with half the mass moves twice as far.",
)
def ball_apart(sheet: Sheet) -> None:
    """Overlapping balls move apart in inverse proportion to their masses."""
    one, other = carom.Ball((0.0, 0.0), 1.2, mass=2.0), carom.Ball((1.65, 0.0), 1.2, mass=1.0)
    places = [ball.position for ball in (one, other)]
    contact = one.detect(other)
    assert contact is not None
    other.respond(contact)
    for before, ball, words in zip(places, (one, other), ("2m", "m"), strict=True):
        sheet.ball(before, 1.2, "muted", ghost=True)
        sheet.ball(ball.position, 1.2, "ball-1" if ball is one else "ball-4")
        sheet.arrow(before, ball.position, RED)
        sheet.label(ball.position, words, pi / 2)
    sheet.label((4.6, 0.45), "setback · m / 3m")
    sheet.label((4.6, 0.05), "and")
    sheet.label((4.6, -0.35), "setback · 2m / 3m")


@figure(
    "offset-shot", (-3.2, -2.2, 4.6, 2.0), 80, "A ball meets one at rest off its middle; they leave at a right angle."
)
def offset_shot(sheet: Sheet) -> None:
    """Equal elastic balls part at a right angle."""
    world = carom.World(detection="continuous")
    cue = world.add(carom.Ball((-2.6, -0.45), 0.5, velocity=(2.0, 0.0)))
    target = world.add(carom.Ball((0.8, 0.1), 0.5))
    line = world.aim(cue, (1, 0))
    assert line is not None
    assert line.direction is not None
    assert line.other_direction is not None
    sheet.ball(cue.position, 0.5)
    sheet.ball(line.ghost, 0.5, ghost=True)
    sheet.ball(target.position, 0.5, "ball-4")
    sheet.line(cue.position, line.ghost)
    sheet.arrow(cue.position, plus(cue.position, (1.2, 0.0)), GREEN)
    sheet.arrow(target.position, plus(target.position, line.other_direction, 1.9), "ball-4")
    sheet.arrow(line.ghost, plus(line.ghost, line.direction, 1.5), "ball-1")
    sheet.label(line.ghost, "ghost", -pi * 0.7, "muted", 52)
    sheet.label(plus(target.position, line.other_direction, 1.9), "along n", -0.1, "ball-4", 24)
    sheet.label(plus(line.ghost, line.direction, 1.5), "across n", -0.1, "ball-1", 24)
