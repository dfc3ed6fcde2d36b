"""Figures of arcs: their parts, boxes and sectors, and a ball that meets one."""

from __future__ import annotations

from math import cos, pi, sin

import carom
from docs.figures.sheet import BLUE, GOLD, GREEN, RED, Sheet, Vector, figure, plus, polar


@figure(
    "arc-parts",
    (-2.6, -0.9, 3.0, 2.4),
    95,
    "An arc from a start angle counterclockwise to an end angle, its ends and tangents.",
)
def arc_parts(sheet: Sheet) -> None:
    """Angles, ends and tangents."""
    arc = carom.Arc((0.0, 0.0), 1.7, 0.5, 2.4)
    sheet.line(arc.center, (2.6, 0.0))
    for angle, end, tangent, number in ((arc.start_angle, arc.p0, arc.t0, "₀"), (arc.end_angle, arc.p1, arc.t1, "₁")):
        sheet.line(arc.center, end)
        sheet.angle(arc.center, 0.0, angle, GREEN, 46.0 if number == "₀" else 88.0)
        sheet.arrow(end, plus(end, tangent, 0.9), BLUE)
        sheet.label(plus(end, tangent, 0.9), f"t{number}", 0.9 if number == "₀" else pi, BLUE)
    sheet.shape(arc)
    sheet.label(polar(arc.center, 0.7, 0.26), "α₀", None, GREEN)
    sheet.label(polar(arc.center, 1.12, 1.6), "α₁", None, GREEN)
    for place, words, way in ((arc.p0, "p₀", 0.3), (arc.p1, "p₁", 2.4)):
        sheet.dot(place, RED, 4.5)
        sheet.label(place, words, way, RED, 16)
    sheet.dot(arc.center)
    sheet.label(arc.center, "u", -pi / 2)


@figure(
    "arc-acute-obtuse", (-2.2, -1.8, 6.4, 1.8), 78, "An arc that does not pass angle 0, and its complement, which does."
)
def arc_acute_obtuse(sheet: Sheet) -> None:
    """An arc and the rest of its circle."""
    arc = carom.Arc((0.0, 0.0), 1.4, 0.6, 3.6)
    for shift, shape in ((0.0, arc), (4.2, arc.complement())):
        center = (shift, 0.0)
        sheet.circle(center, 1.4)
        sheet.line(center, (shift + 2.0, 0.0))
        moved = carom.Arc(center, 1.4, shape.start_angle, shape.end_angle)
        sheet.shape(moved, width=3.2)
        for place, words, tangent in ((moved.p0, "p₀", moved.t0), (moved.p1, "p₁", moved.t1)):
            sheet.arrow(place, plus(place, tangent, 0.55), BLUE)
            sheet.dot(place, RED, 4.5)
            sheet.label(place, words, 0.6 + pi if place[0] > shift else 0.3, RED, 16)
        sheet.label((shift, -0.45), "α₀ < α₁" if moved.acute else "α₀ > α₁")
        sheet.label((shift, 0.38), "acute" if moved.acute else "obtuse")


@figure(
    "arc-box",
    (-2.0, -1.7, 2.9, 1.9),
    95,
    "An arc between two of its circle's extreme points: its box reaches from end to end.",
)
def arc_box(sheet: Sheet) -> None:
    """The box of an arc without an extreme point."""
    arc = carom.Arc((0.0, 0.0), 1.5, 0.25, 1.3)
    sheet.circle(arc.center, arc.radius)
    sheet.box(arc.aabb)
    sheet.shape(arc, width=3.2)
    _extremes(sheet, arc)
    sheet.dot(arc.p0, BLUE, 4.5)
    sheet.dot(arc.p1, BLUE, 4.5)
    sheet.label(arc.p0, "p₀", 0.0, BLUE, 16)
    sheet.label(arc.p1, "p₁", 1.8, BLUE, 16)


@figure(
    "arc-boxes",
    (-1.9, -1.75, 10.1, 1.75),
    60,
    "Three arcs over one, two and three extreme points of their circles, which their boxes reach.",
)
def arc_boxes(sheet: Sheet) -> None:
    """Boxes of arcs over extreme points."""
    for shift, start, end in ((0.0, 0.4, 2.1), (4.1, 0.4, 3.7), (8.2, 0.9, 5.6)):
        arc = carom.Arc((shift, 0.0), 1.5, start, end)
        sheet.circle(arc.center, arc.radius)
        sheet.box(arc.aabb)
        sheet.shape(arc, width=3.2)
        _extremes(sheet, arc)


def _extremes(sheet: Sheet, arc: carom.Arc) -> None:
    """Mark the four extreme points of an arc's circle: full where they lie on the arc."""
    for quarter in range(4):
        x, y = round(cos(quarter * pi / 2)), round(sin(quarter * pi / 2))
        place = plus(arc.center, (x, y), arc.radius)
        sheet.dot(place, RED if arc.in_sector(place) else "off", 4.5)


@figure("sector-acute", (-2.3, -1.65, 3.6, 2.2), 85, "The sector of an acute arc: between both rays.")
def sector_acute(sheet: Sheet) -> None:
    """A sector below half a turn."""
    _sector(sheet, carom.Arc((0.0, 0.0), 1.5, 0.4, 2.2), ((1.4, 1.75), (-2.0, 0.4), (1.6, -0.8)))


@figure(
    "sector-obtuse",
    (-3.0, -2.2, 3.6, 2.2),
    80,
    "The sector of an obtuse arc: all but what lies between its end and its start.",
)
def sector_obtuse(sheet: Sheet) -> None:
    """A sector over angle 0, beyond half a turn."""
    _sector(sheet, carom.Arc((0.0, 0.0), 1.4, 3.9, 2.3), ((1.9, 1.0), (-1.9, -0.1), (1.3, -1.5)))


def _sector(sheet: Sheet, arc: carom.Arc, places: tuple[Vector, ...]) -> None:
    """Draw a sector, and points inside and outside of it."""
    sweep = (arc.end_angle - arc.start_angle) % (2 * pi)
    sheet.area([arc.center, *(polar(arc.center, 2.0, arc.start_angle + sweep * k / 40) for k in range(41))], BLUE)
    sheet.circle(arc.center, arc.radius)
    for angle in (arc.start_angle, arc.end_angle):
        sheet.line(arc.center, polar(arc.center, 2.0, angle), BLUE)
    sheet.shape(arc, width=3.2)
    for place in places:
        inside = arc.in_sector(place)
        sheet.dot(place, BLUE if inside else RED, 4.5)
        sheet.label(place, "in" if inside else "out", 0.0, BLUE if inside else RED, 18)
    sheet.arrow(arc.center, arc.p0, GREEN, 1.6)
    sheet.arrow(arc.center, arc.p1, GREEN, 1.6)
    sheet.label(polar(arc.center, 0.75, arc.start_angle), "a", arc.start_angle - pi / 2, GREEN)
    sheet.label(polar(arc.center, 0.75, arc.end_angle), "b", arc.end_angle + pi / 2, GREEN)
    sheet.dot(arc.center)


@figure(
    "arc-contact",
    (-2.7, -2.1, 2.9, 1.0),
    95,
    "A ball in a bowl: the nearest point of the arc, and the normal towards the centre.",
)
def arc_contact(sheet: Sheet) -> None:
    """A ball inside an arc."""
    arc, ball = carom.Arc((0.0, 0.4), 2.2, 3.5, 5.9), carom.Ball((0.75, -0.95), radius=0.75)
    contact = arc.detect(ball)
    assert contact is not None
    sheet.shape(arc)
    sheet.ball(plus(ball.position, contact.normal, contact.setback), ball.radius, "muted", ghost=True)
    sheet.ball(ball.position, ball.radius)
    sheet.line(arc.center, contact.point)
    for end in (arc.p0, arc.p1):
        sheet.line(arc.center, end)
    sheet.arrow(contact.point, plus(contact.point, contact.normal, 0.6), BLUE)
    sheet.label(plus(contact.point, contact.normal, 0.3), "n", pi, BLUE, 16)
    rim = plus(contact.point, contact.normal, -contact.setback)
    side = plus((0.0, 0.0), carom.perp(contact.normal), -0.2)
    sheet.span(plus(contact.point, side), plus(rim, side), GOLD)
    sheet.label((1.85, -1.6), "setback", None, GOLD)
    sheet.dot(contact.point, RED, 4.5)
    sheet.label(contact.point, "q", -pi / 2, RED, 19)
    sheet.dot(arc.center)
    sheet.label(arc.center, "u", pi / 2)
