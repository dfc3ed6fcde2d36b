"""Figures of boxes along the axes."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, RED, Sheet, figure


@figure("boxes-round", (-3.2, -1.5, 3.4, 1.6), 90, "A circle and an arc, each with the smallest box around it.")
def boxes_round(sheet: Sheet) -> None:
    """Boxes around a circle and an arc."""
    circle = carom.Circle((-1.7, 0.0), 1.1)
    arc = carom.Arc((1.5, -0.6), 1.6, 0.35, 2.6)
    for shape in (circle, arc):
        sheet.box(shape.aabb)
        sheet.shape(shape)


@figure("box-corners", (-2.6, -1.25, 2.6, 1.3), 100, "A box, its four sides named, two opposite corners marked.")
def box_corners(sheet: Sheet) -> None:
    """What a box stores."""
    box = carom.Aabb(-1.5, -0.8, 1.5, 0.8)
    sheet.box(box)
    sheet.dot(box.top_left, BLUE)
    sheet.dot(box.bottom_right, BLUE)
    sheet.label(box.top_left, "top_left", pi * 0.8, BLUE, 20)
    sheet.label(box.bottom_right, "bottom_right", -pi * 0.2, BLUE, 20)
    sheet.label((-1.5, 0.0), "left", 0.0, away=16)
    sheet.label((1.5, 0.0), "right", pi, away=16)
    sheet.label((0.0, 0.8), "top", -pi / 2)
    sheet.label((0.0, -0.8), "bottom", pi / 2)


@figure(
    "boxes-apart",
    (-3.3, -1.4, 3.3, 1.4),
    90,
    "Two boxes with a gap between the right of one and the left of the other.",
)
def boxes_apart(sheet: Sheet) -> None:
    """Boxes that do not overlap."""
    one, other = carom.Aabb(-2.8, -0.4, -0.7, 1.1), carom.Aabb(0.6, -1.1, 2.7, 0.5)
    assert not one.overlaps(other)
    sheet.box(one, BLUE)
    sheet.box(other)
    sheet.label((-1.75, 0.35), "A")
    sheet.label((1.65, -0.3), "B")
    sheet.line((one.right, 1.3), (one.right, -1.3))
    sheet.line((other.left, 1.3), (other.left, -1.3))
    sheet.span((one.right, -0.75), (other.left, -0.75))
    sheet.label((-0.05, -0.75), "gap", pi / 2)


@figure("box-point", (-3.0, -1.3, 3.4, 1.3), 95, "A box with one point inside of it, one on its edge and one outside.")
def box_point(sheet: Sheet) -> None:
    """Points in and out of a box."""
    box = carom.Aabb(-2.0, -0.9, 1.2, 0.9)
    sheet.box(box)
    for place, words in (((-0.9, 0.3), "in"), ((1.2, -0.4), "on the edge: in"), ((2.0, 0.5), "out")):
        sheet.dot(place, BLUE if place in box else RED)
        sheet.label(place, words, 0.0, away=16)
