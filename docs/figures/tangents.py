"""Figures of tangents, from a point and to two circles."""

from __future__ import annotations

from math import asin, pi, sqrt

import carom
from docs.figures.sheet import BLUE, GOLD, GREEN, RED, Sheet, Vector, direction, figure, middle, plus, polar

P: Vector = (0.0, 0.0)
CIRCLE = carom.Circle((4.2, 1.0), 1.4)


def _touching() -> tuple[Vector, Vector]:
    """Where the tangents through P touch the circle."""
    places = CIRCLE.tangent_points(P)
    assert places is not None
    return places


@figure("tangent-points", (-0.8, -1.1, 6.2, 2.9), 85, "A circle and its two tangents through a point outside of it.")
def tangent_points(sheet: Sheet) -> None:
    """Both tangents through a point."""
    sheet.shape(CIRCLE)
    sheet.arrow(P, CIRCLE.center, "muted", 1.6)
    sheet.label(middle(P, CIRCLE.center), "v", -pi / 2, "muted")
    for place, words, unit, way in zip(_touching(), ("p₀", "p₁"), ("v₀", "v₁"), (pi / 2, -pi / 2), strict=True):
        sheet.line(P, plus(P, place, 1.3), "wall", dashed=False, width=1.6)
        sheet.arrow(P, polar(P, 1.1, direction(P, place)), BLUE)
        sheet.label(polar(P, 0.9, direction(P, place)), unit, way, BLUE)
        sheet.dot(place, RED, 4.5)
        sheet.label(place, words, way, RED)
    sheet.dot(P)
    sheet.label(P, "p", pi)
    sheet.dot(CIRCLE.center)
    sheet.label(CIRCLE.center, "u", 0.0)


@figure(
    "tangent-triangle", (-0.8, -0.7, 6.2, 2.9), 85, "The right triangle of p, the point of tangency and the centre."
)
def tangent_triangle(sheet: Sheet) -> None:
    """The first tangent's triangle."""
    first, _ = _touching()
    sheet.area([P, first, CIRCLE.center], BLUE)
    sheet.shape(CIRCLE)
    sheet.line(P, (3.4, 0.0))
    sheet.line(P, CIRCLE.center, "wall", dashed=False, width=1.8)
    sheet.line(P, first, "wall", dashed=False, width=1.8)
    sheet.line(first, CIRCLE.center, "wall", dashed=False, width=1.8)
    sheet.right_angle(first, direction(first, P))
    tilt, opening = direction(P, CIRCLE.center), asin(CIRCLE.radius / sqrt(4.2 * 4.2 + 1.0))
    sheet.angle(P, 0.0, tilt, GREEN, 130.0)
    sheet.angle(P, tilt, tilt + opening, BLUE, 62.0)
    sheet.label(polar(P, 1.72, tilt / 2), "φ", None, GREEN)
    sheet.label(polar(P, 0.93, tilt + opening / 2), "θ", None, BLUE)
    sheet.label(middle(P, CIRCLE.center), "d", -pi / 2.2)
    sheet.label(middle(P, first), "δ", pi * 0.65)
    sheet.label(middle(first, CIRCLE.center), "R", 0.2)
    sheet.dot(first, RED, 4.5)
    sheet.label(first, "p₀", pi / 2, RED)
    sheet.label(P, "p", pi)
    sheet.label(CIRCLE.center, "u", 0.0)
    sheet.dot(CIRCLE.center)


@figure(
    "tangent-second", (-0.8, -1.2, 6.2, 2.8), 85, "The second tangent lies as far clockwise of the line to the centre."
)
def tangent_second(sheet: Sheet) -> None:
    """The second tangent's angle."""
    _, second = _touching()
    sheet.shape(CIRCLE)
    sheet.line(P, (3.4, 0.0))
    sheet.line(P, CIRCLE.center, "wall", dashed=False, width=1.8)
    sheet.line(P, second, "wall", dashed=False, width=1.8)
    sheet.line(second, CIRCLE.center)
    tilt, low = direction(P, CIRCLE.center), direction(P, second)
    sheet.angle(P, 0.0, tilt, GREEN, 130.0)
    sheet.angle(P, low, tilt, BLUE, 62.0)
    sheet.label(polar(P, 1.75, tilt / 2), "φ", None, GREEN)
    sheet.label(polar(P, 0.75, tilt + 0.25), "θ", None, BLUE)
    sheet.angle(P, low, 0.0, RED, 195.0)
    sheet.label(polar(P, 2.62, low / 2), "φ − θ", None, RED)
    sheet.dot(second, RED, 4.5)
    sheet.label(second, "p₁", -pi / 2, RED)
    sheet.label(P, "p", pi)
    sheet.dot(CIRCLE.center)
    sheet.label(CIRCLE.center, "u", 0.0)


@figure(
    "tangents-shrunk",
    (-2.0, -2.1, 10.1, 2.1),
    56,
    "Two circles and their common tangents; both radii made smaller, the tangents keep their directions.",
)
def tangents_shrunk(sheet: Sheet) -> None:
    """Shrinking both circles by as much keeps the tangents parallel to what they were."""
    for shift, less in ((0.0, 0.0), (5.9, 0.7)):
        one = carom.Circle((shift, 0.0), 1.7 - less)
        sheet.shape(one)
        far = (shift + 2.9, 0.4)
        if less:
            sheet.circle(one.center, 1.7)
            sheet.circle(far, 0.7)
            places = one.tangent_points(far)
            assert places is not None
            tangents = [(place, far) for place in places]
            sheet.dot(far, RED, 4.5)
        else:
            other = carom.Circle(far, 0.7)
            sheet.shape(other, GOLD)
            lines = one.common_tangents(other)
            assert lines is not None
            tangents = [(line.p0, line.p1) for line in lines]
        for start, end in tangents:
            along = (end[0] - start[0], end[1] - start[1])
            sheet.line(plus(start, along, -0.25), plus(end, along, 0.25), BLUE, dashed=False, width=2.0)
        sheet.label(one.center, "R₁ − R₂" if less else "R₁", -pi / 2)
        sheet.dot(one.center)
        sheet.label(far, "a point" if less else "R₂", -pi / 2, away=58 if less else 13)
        if not less:
            sheet.dot(far)


@figure(
    "tangents-common",
    (-2.1, -2.0, 6.2, 2.0),
    82,
    "Two circles, the normals of both common tangents, and the four points of contact.",
)
def tangents_common(sheet: Sheet) -> None:
    """Each tangent has one normal at both circles."""
    one, other = carom.Circle((0.0, 0.0), 1.6), carom.Circle((4.2, 0.3), 0.8)
    lines = one.common_tangents(other)
    assert lines is not None
    sheet.shape(one)
    sheet.shape(other, GOLD)
    sheet.line(one.center, other.center)
    for first, (start, end), names in zip((True, False), _ends(lines, one), ("q₀q₂", "q₁q₃"), strict=True):
        way = pi / 2 if first else -pi / 2
        sheet.line(start, end, BLUE, dashed=False, width=2.4)
        for centre, place, words in ((one.center, start, names[:2]), (other.center, end, names[2:])):
            sheet.arrow(centre, place, GREEN, 1.6)
            sheet.dot(place, RED, 4.5)
            sheet.label(place, words, way, RED)
        sheet.label(middle(one.center, start), "m₀" if first else "m₁", 0.0, GREEN, 15)
    for circle, words in ((one, "u₁"), (other, "u₂")):
        sheet.dot(circle.center)
        sheet.label(circle.center, words, pi if words == "u₁" else 0.0)


def _ends(lines: tuple[carom.Segment, carom.Segment], one: carom.Circle) -> list[tuple[Vector, Vector]]:
    """The ends of tangents, that on the first circle first."""
    return [(line.p0, line.p1) if one.distance(line.p0) < 1e-9 else (line.p1, line.p0) for line in lines]
