"""Figures of infinite lines."""

from __future__ import annotations

from math import atan2, inf, pi

import carom
from docs.figures.sheet import BLUE, GREEN, RED, Sheet, direction, figure, middle, polar


def _axes(sheet: Sheet, right: float, top: float) -> None:
    """Draw the axes of a plane."""
    sheet.arrow((-0.4, 0.0), (right, 0.0), "muted", 1.2)
    sheet.arrow((0.0, -0.4), (0.0, top), "muted", 1.2)
    sheet.label((right, 0.0), "x", -pi / 2, "muted")
    sheet.label((0.0, top), "y", pi, "muted")


@figure("lines-cross", (-0.8, -0.6, 6.2, 3.4), 85, "Two slanted lines that cross at a point p.")
def lines_cross(sheet: Sheet) -> None:
    """Two lines and the point in which they meet."""
    _axes(sheet, 5.8, 3.1)
    one, other = carom.Line((0.0, 0.4), 0.5), carom.Line((0.0, 2.6), -0.5)
    place = one.intersection(other)
    assert place is not None
    sheet.line((0.0, 0.4), (5.2, 3.0), "wall", dashed=False, width=2.2)
    sheet.line((0.0, 2.6), (5.2, -0.0), BLUE, dashed=False, width=2.2)
    sheet.dot(place, RED, 4.5)
    sheet.label(place, "p", pi / 2, RED)
    sheet.label((4.7, 2.15), "y = m₀x + b₀")
    sheet.label((4.6, 0.95), "y = m₁x + b₁", None, BLUE)
    sheet.dot((0.0, 0.4))
    sheet.label((0.0, 0.4), "b₀", pi)
    sheet.dot((0.0, 2.6), BLUE)
    sheet.label((0.0, 2.6), "b₁", pi, BLUE)


@figure("line-vertical", (-0.8, -0.6, 6.2, 3.2), 85, "A vertical line that crosses a slanted one at p.")
def line_vertical(sheet: Sheet) -> None:
    """A line without a gradient."""
    _axes(sheet, 5.8, 2.9)
    upright, other = carom.Line((2.6, 0.0), inf), carom.Line((0.0, 0.5), 0.45)
    place = upright.intersection(other)
    assert place is not None
    sheet.line((2.6, -0.4), (2.6, 2.9), "wall", dashed=False, width=2.2)
    sheet.line((-0.3, 0.365), (5.2, 2.84), BLUE, dashed=False, width=2.2)
    sheet.dot(place, RED, 4.5)
    sheet.label(place, "p", pi * 0.8, RED)
    sheet.label((2.6, 0.3), "x = c", 0.0, away=24)
    sheet.label((4.6, 2.05), "y = mx + b", None, BLUE)


@figure(
    "lines-perpendicular",
    (-0.7, -0.7, 5.9, 3.0),
    95,
    "A right triangle whose height makes two smaller ones of one shape.",
)
def lines_perpendicular(sheet: Sheet) -> None:
    """Gradients of lines at right angles."""
    a, b, c = (0.0, 0.0), (3.2, 2.4), (5.0, 0.0)
    foot = (b[0], 0.0)
    sheet.area([a, b, foot], BLUE)
    sheet.line(a, c, "muted", dashed=False)
    sheet.line(a, b, "wall", dashed=False, width=2.4)
    sheet.line(b, c, RED, dashed=False, width=2.4)
    sheet.line(b, foot, BLUE)
    slope = direction(a, b)
    sheet.right_angle(b, direction(b, a))
    sheet.right_angle(foot, pi / 2)
    sheet.angle(a, 0.0, slope)
    sheet.label(polar(a, 0.56, slope / 2), "θ", None, GREEN)
    sheet.angle(b, -pi / 2, direction(b, c))
    sheet.label(polar(b, 0.62, (direction(b, c) - pi / 2) / 2), "θ", None, GREEN)
    sheet.label((1.15, 1.45), "m = tan θ")
    sheet.label((4.75, 1.3), "−1/m", None, RED)
    sheet.label(middle(a, foot), "run", -pi / 2, BLUE)
    sheet.label(middle(b, foot), "rise", pi, BLUE, 18)
    for place, words, way in ((a, "A", -pi * 0.75), (b, "B", pi / 2), (c, "C", -pi * 0.25)):
        sheet.label(place, words, way)


@figure(
    "line-nearest",
    (-0.8, -0.6, 6.0, 3.3),
    85,
    "A line, a point off it, and the foot of the perpendicular between them.",
)
def line_nearest(sheet: Sheet) -> None:
    """The point of a line that is nearest to p."""
    line, p = carom.Line((0.0, 0.5), 0.4), (2.0, 2.9)
    foot = line.closest_point(p)
    sheet.line((-0.5, 0.3), (5.5, 2.7), "wall", dashed=False, width=2.4)
    sheet.line(p, foot, BLUE)
    sheet.arrow((0.4, 0.66), polar((0.4, 0.66), 1.0, atan2(0.4, 1.0)), GREEN)
    sheet.label((0.95, 0.88), "u", -pi / 2, GREEN)
    sheet.dot((0.4, 0.66))
    sheet.label((0.4, 0.66), "a", pi / 2)
    sheet.right_angle(foot, direction(foot, p) - pi / 2)
    sheet.dot(p, BLUE)
    sheet.dot(foot, RED, 4.5)
    sheet.label(p, "p", pi * 0.8, BLUE)
    sheet.label(foot, "q", -pi / 2, RED)
