"""Figures of segments, of a ball beside them, and of gates."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GOLD, GREEN, RED, Sheet, figure, plus


@figure(
    "segment-parts",
    (-0.9, -0.7, 5.9, 2.9),
    90,
    "A segment with its ends p0 and p1, the unit vectors t0 and t1 into it, and its normal.",
)
def segment_parts(sheet: Sheet) -> None:
    """The ends of a segment, its tangents and its normal."""
    segment = carom.Segment((5.0, 1.6), (0.0, 0.2))
    sheet.shape(segment)
    for end, tangent, words, name in (
        (segment.p0, segment.t0, "t₀", "p₀"),
        (segment.p1, segment.t1, "t₁", "p₁"),
    ):
        sheet.arrow(end, plus(end, tangent, 1.1), BLUE)
        sheet.label(plus(end, tangent, 0.75), words, -pi / 2, BLUE)
        sheet.dot(end, RED, 4.5)
        sheet.label(end, name, pi / 2 if name == "p₁" else pi, RED)
    sheet.arrow(segment.p0, plus(segment.p0, segment.normal, 1.6), GREEN)
    sheet.label(plus(segment.p0, segment.normal, 1.6), "n = perp(t₀)", 0.2, GREEN, 28)


@figure("segment-past-end", (-2.4, -1.5, 6.6, 2.2), 72, "The slab beside a segment, one ball in it, one past each end.")
def segment_past_end(sheet: Sheet) -> None:
    """Where balls are beside a segment, and where past an end of it."""
    segment = carom.Segment((0.0, 0.0), (4.2, 0.0))
    sheet.area([(0.0, -1.4), (4.2, -1.4), (4.2, 2.1), (0.0, 2.1)], BLUE)
    for x in (0.0, 4.2):
        sheet.line((x, -1.4), (x, 2.1), BLUE)
    sheet.shape(segment)
    for x, y in ((-0.7, 0.45), (4.8, 0.6), (2.1, 0.7)):
        ball = carom.Ball((x, y), radius=0.85)
        ink = "muted" if segment.detect(ball) is None else "ball-1"
        sheet.ball(ball.position, ball.radius, ink)
    sheet.label((-0.9, 1.75), "(c − p₀)·t₀ < 0")
    sheet.label((5.45, 1.85), "(c − p₁)·t₁ < 0")
    sheet.label((2.1, -0.85), "beside: a contact", None, BLUE)
    sheet.dot(segment.p0, RED)
    sheet.dot(segment.p1, RED)
    sheet.label(segment.p0, "p₀", -pi * 0.8, RED, 17)
    sheet.label(segment.p1, "p₁", -pi * 0.2, RED, 17)


@figure(
    "segment-nearest",
    (-0.8, -1.0, 6.0, 2.5),
    90,
    "A ball over a segment: the foot of its centre, the normal, the setback below.",
)
def segment_nearest(sheet: Sheet) -> None:
    """The foot of the centre, and the contact there."""
    segment, ball = carom.Segment((0.0, 0.0), (5.4, 0.6)), carom.Ball((2.4, 1.1), radius=1.1)
    contact = segment.detect(ball)
    assert contact is not None
    sheet.shape(segment)
    sheet.ball(ball.position, ball.radius)
    sheet.line(segment.p0, ball.position)
    sheet.label((1.15, 0.62), "c − p₀", pi * 0.7, "muted", 18)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 0.8), BLUE)
    sheet.label(plus(contact.point, contact.normal, 0.5), "n", 0.0, BLUE)
    rim = plus(contact.point, contact.normal, -contact.setback)
    side = (segment.t0[0] * 0.3, segment.t0[1] * 0.3)
    sheet.span(plus(contact.point, side), plus(rim, side), GOLD)
    sheet.label(plus(rim, side), "setback", -0.1, GOLD, 22)
    sheet.dot(contact.point, RED, 4.5)
    sheet.label(contact.point, "q", -pi * 0.75, RED, 14)
    sheet.label(ball.position, "c", pi / 2, "ball-1")
    sheet.dot(segment.p0, RED)
    sheet.label(segment.p0, "p₀", pi, RED)
    sheet.arrow(plus(segment.p1, segment.t0, -1.1), segment.p1, GREEN)
    sheet.label(plus(segment.p1, segment.t0, -0.4), "t₀", pi / 2, GREEN)


@figure(
    "gate-sides",
    (-2.3, -2.0, 6.3, 2.0),
    75,
    "A gate: a ball from its open side passes, one from its closed side bounces.",
)
def gate_sides(sheet: Sheet) -> None:
    """The two sides of a gate."""
    for x in (0.0, 4.2):
        gate = carom.Gate((x, -1.3), (x, 1.3), direction=(1.0, 0.0))
        sheet.shape(gate, GOLD)
        sheet.arrow((x, 0.0), (x + 0.55, 0.0), GOLD, 2.6)
        sheet.label((x, 1.3), "closed side ▸", 0.35, "muted", 22)
    sheet.ball((-1.1, -0.55), 0.4, ghost=True)
    sheet.ball((1.2, -0.55), 0.4)
    sheet.arrow((-1.1, -0.55), (0.75, -0.55), GREEN)
    sheet.label((0.0, -1.65), "passes")
    sheet.ball((5.7, -0.1), 0.4, ghost=True)
    sheet.ball((5.5, -1.155), 0.4)
    sheet.path([(5.7, -0.1), (4.6, -0.68), (5.5, -1.155)], GREEN)
    sheet.label((4.2, -1.65), "bounces", None, RED)
