"""Figures of bare ends, guard points and joints."""

from __future__ import annotations

from math import pi

import carom
from docs.figures.sheet import BLUE, GREEN, RED, Sheet, figure, plus, polar


@figure(
    "bare-end",
    (-1.3, -2.5, 8.9, 1.2),
    70,
    "A ball at the end of a segment: missed, thrown back by the bare segment, bounced by a guard point.",
)
def bare_end(sheet: Sheet) -> None:
    """What happens at an end without a point, and with one."""
    for shift, words in ((0.0, "no contact yet"), (3.4, "then too much"), (6.8, "with a point")):
        wall = carom.Segment((shift, 0.0), (shift, -2.0))
        center = (shift - 0.45, 0.25) if words != "then too much" else (shift - 0.12, -0.12)
        ball = carom.Ball(center, 0.6, velocity=(1.3, -1.0))
        contact = wall.detect(ball)
        sheet.shape(wall)
        if words == "no contact yet":
            assert contact is None
        elif words == "then too much":
            assert contact is not None
            sheet.ball(plus(center, contact.normal, contact.setback), 0.6, RED, ghost=True)
            sheet.arrow(center, plus(center, contact.normal, contact.setback), RED)
        else:
            guard = carom.Point((shift, 0.0))
            contact = guard.detect(ball)
            assert contact is not None
            ball.respond(contact)
            sheet.dot(guard.position, RED, 4.5)
            sheet.arrow(ball.position, plus(ball.position, ball.velocity, 0.7), BLUE)
        sheet.ball(ball.position if words == "with a point" else center, 0.6)
        if words != "with a point":
            sheet.arrow(center, plus(center, (1.3, -1.0), 0.62), GREEN)
        sheet.label((shift, -2.3), words)


@figure(
    "smooth-joint",
    (-0.6, -0.8, 6.6, 2.3),
    85,
    "A segment that an arc continues smoothly, and a ball that rolls over the joint.",
)
def smooth_joint(sheet: Sheet) -> None:
    """A joint that needs no point."""
    floor = carom.Segment((0.0, 0.0), (3.0, 0.0))
    bend = carom.Arc((3.0, 2.0), 2.0, 1.5 * pi, 2.0 * pi - 0.25)
    assert [point.position for point in carom.guard_points([floor, bend])] == [floor.p0, bend.p1]
    sheet.shape(floor)
    sheet.shape(bend)
    for angle in (0.0, 0.45, 0.9):
        center = polar(bend.center, 1.5, 1.5 * pi + angle) if angle else (2.2, 0.5)
        sheet.ball(center, 0.5, ghost=angle != 0.0)
    sheet.arrow((2.2, 0.5), (3.3, 0.5), GREEN)
    sheet.dot((3.0, 0.0), RED, 4.5)
    sheet.label((3.0, 0.0), "no point here", -pi / 2, RED, 18)
    for end, words, way in ((floor.p0, "a point", -pi / 2), (bend.p1, "a point", 0.0)):
        sheet.dot(end, BLUE, 4.5)
        sheet.label(end, words, way if words != "a point" or end is not floor.p0 else -1.1, BLUE, 18)
    sheet.arrow((3.0, 0.0), plus((3.0, 0.0), floor.t0, 0.9), "muted", 1.6)
    sheet.arrow((3.0, 0.0), plus((3.0, 0.0), bend.t0, 0.9), "muted", 1.6)


@figure(
    "corner-guard",
    (-0.6, -0.9, 7.6, 2.2),
    75,
    "A convex corner of two walls: a ball that comes at it misses both slabs and needs the point.",
)
def corner_guard(sheet: Sheet) -> None:
    """A corner between two slabs."""
    floor, wall = carom.Segment((0.0, 0.6), (3.2, 0.6)), carom.Segment((3.2, 0.6), (3.2, -0.8))
    sheet.area([(0.0, 0.6), (3.2, 0.6), (3.2, 2.1), (0.0, 2.1)], BLUE)
    sheet.area([(3.2, 0.6), (5.4, 0.6), (5.4, -0.8), (3.2, -0.8)], BLUE)
    sheet.shape(floor)
    sheet.shape(wall)
    ball = carom.Ball((3.55, 1.0), 0.7)
    assert floor.detect(ball) is None
    assert wall.detect(ball) is None
    contact = carom.Point((3.2, 0.6)).detect(ball)
    assert contact is not None
    sheet.ball(ball.position, ball.radius)
    sheet.arrow((3.2, 0.6), plus((3.2, 0.6), contact.normal, 1.3), BLUE)
    sheet.label(plus((3.2, 0.6), contact.normal, 1.3), "n", 0.3, BLUE)
    sheet.dot((3.2, 0.6), RED, 4.5)
    sheet.label((3.2, 0.6), "q", -pi * 0.75, RED, 16)
    sheet.label((1.5, 1.6), "beside the first", None, BLUE)
    sheet.label((4.3, -0.45), "beside the second", None, BLUE)
    sheet.label((6.1, 1.6), "beside neither:")
    sheet.label((6.1, 1.3), "the point's")


@figure(
    "passing",
    (-2.6, -1.7, 5.4, 1.9),
    78,
    "A ball that comes round an end from beyond it passes the segment until it is clear.",
)
def passing(sheet: Sheet) -> None:
    """A ball that came in past an end."""
    wall = carom.Segment((0.0, 0.0), (4.6, 0.0))
    sheet.area([(0.0, -1.6), (4.6, -1.6), (4.6, 1.8), (0.0, 1.8)], BLUE)
    sheet.line((0.0, -1.6), (0.0, 1.8), BLUE)
    sheet.shape(wall)
    places = [(-1.5, 0.55), (0.35, 0.1), (2.1, -0.35), (3.6, -0.75)]
    for place, words in zip(places, ("", "passes", "still", "clear"), strict=True):
        sheet.ball(place, 0.62, "ball-1" if words else "muted")
        if words:
            sheet.label(plus(place, (0.28, -0.62)), words, -pi / 2)
    sheet.arrow(places[0], places[1], GREEN)
    sheet.label((2.4, 1.4), "the slab: centres beside the segment", None, BLUE)
