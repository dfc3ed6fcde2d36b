"""Arcs and straight pieces on their way from place to place, and how far curves lie from them."""

from __future__ import annotations

from cmath import phase
from math import inf
from typing import NamedTuple

from carom.constants import LARGEST_RADIUS
from carom.geometry.biarc import bend, biarc_joint, side_of_arc
from carom.shapes.outlines.cubic import Cubic, dot

#: Lengths, for outlines whose coordinates are at most 1: the rounding of a place, and of an arc's end for its radius.
PLACE_ROUNDING, END_ROUNDING = 2e-15, 1e-15

#: Radians: an arc that turns by more is not compared with a curve, and times that a curve is halved to compare it.
WIDEST, HALVINGS = 3.0, 6

#: Share of the tolerance by which a curve may reach past the ends of the arc that follows it.
PAST_END = 0.03


def largest_radius(tolerance: float) -> float:
    """The largest radius of an arc within a tolerance: the rounding of its ends must leave nine tenths of that."""
    return min(LARGEST_RADIUS, 0.1 * tolerance / END_ROUNDING)


class Bow(NamedTuple):
    """An arc from a place to another: the unit tangents there, in the direction of travel, and the signed curvature."""

    start: complex
    out: complex
    curvature: float
    end: complex
    into: complex

    @property
    def turn(self) -> float:
        """The angle from the first tangent to the last, from -π to π."""
        return phase(self.into * self.out.conjugate())

    def side(self, place: complex) -> float:
        """How far a place lies to the left of its circle; signed."""
        away = place - self.start
        return side_of_arc(self.out.real, self.out.imag, self.curvature, away.real, away.imag)

    def distance(self, place: complex) -> float:
        """How far a place is from it."""
        ahead = dot(self.out, place - self.start) >= 0.0
        before = dot(self.into, self.end - place) >= 0.0
        narrow = self.turn * self.curvature >= 0.0  # no more than half a turn
        if (ahead and before) if narrow else (ahead or before):
            return abs(self.side(place))
        return min(abs(place - self.start), abs(place - self.end))

    def room(self, tolerance: float) -> float:
        """How far a curve may lie from it, so that what is built in its place is within the tolerance."""
        largest, straight = largest_radius(tolerance), abs(self.end - self.start)
        bending = abs(self.curvature)
        if bending * largest < 1.0:
            return tolerance - PLACE_ROUNDING - END_ROUNDING * largest - 0.125 * bending * straight * straight
        return tolerance - PLACE_ROUNDING - END_ROUNDING / bending

    def reach(self) -> float:
        """How far its farthest place is from its start."""
        straight = abs(self.end - self.start)
        return straight if self.turn * self.curvature >= 0.0 else min(2.0 / abs(self.curvature), 10.0 * straight)

    def follows(self, cubic: Cubic, room: float, halvings: int = HALVINGS) -> bool:
        """Whether a cubic keeps within `room` of it and goes from its one end to the other: True only if that is sure.

        With q from the start, n the left normal and k the curvature, q·n - k·q²/2 is between bounds where the distance
        is. It is a polynomial of degree 6 on a cubic, which lies between the least and the greatest of its Bernstein
        coefficients. So are the ways along the tangents at both ends.
        """
        inside, outside = _bounds(self.curvature, room)
        half, tx, ty = 0.5 * self.curvature, self.out.real, self.out.imag
        a, b, c, d = cubic.a - self.start, cubic.b - self.start, cubic.c - self.start, cubic.d - self.start
        ax, ay, bx, by, cx, cy, dx, dy = a.real, a.imag, b.real, b.imag, c.real, c.imag, d.real, d.imag
        s0, s3 = tx * ay - ty * ax, tx * dy - ty * dx
        first, last = s0 - half * (ax * ax + ay * ay), s3 - half * (dx * dx + dy * dy)
        if not (outside <= first <= inside and outside <= last <= inside):
            return False
        slack = -PAST_END * room
        if tx * ax + ty * ay < slack or dot(self.into, self.end - cubic.d) < slack:
            return False
        s1, s2 = tx * by - ty * bx, tx * cy - ty * cx
        inner = (
            (s0 + s1) / 2.0 - half * (ax * bx + ay * by),
            (s0 + 3.0 * s1 + s2) / 5.0 - half * ((2.0 * (ax * cx + ay * cy) + 3.0 * (bx * bx + by * by)) / 5.0),
            (s0 + 9.0 * s1 + 9.0 * s2 + s3) / 20.0 - half * ((ax * dx + ay * dy + 9.0 * (bx * cx + by * cy)) / 10.0),
            (s1 + 3.0 * s2 + s3) / 5.0 - half * ((2.0 * (bx * dx + by * dy) + 3.0 * (cx * cx + cy * cy)) / 5.0),
            (s2 + s3) / 2.0 - half * (cx * dx + cy * dy),
        )
        if outside <= min(inner) and max(inner) <= inside:
            ahead = min(tx * ax + ty * ay, tx * bx + ty * by, tx * cx + ty * cy, tx * dx + ty * dy)
            if ahead >= slack and min(dot(self.into, self.end - place) for place in cubic) >= slack:
                return True
        if halvings == 0:
            return False
        return all(self.follows(part, room, halvings - 1) for part in cubic.halves())


def _bounds(curvature: float, room: float) -> tuple[float, float]:
    """The most and the least of q·n - k·q²/2 within `room` of an arc."""
    half = 0.5 * curvature * room * room
    inside, outside = room - half, -room - half
    if curvature * room >= 1.0:
        inside = inf
    elif curvature * room <= -1.0:
        outside = -inf
    return inside, outside


def biarc(start: complex, out: complex, end: complex, into: complex) -> tuple[Bow, Bow] | None:
    """The two arcs from one place and direction to another, or None where there are none; see `biarc_joint`."""
    found = biarc_joint(start.real, start.imag, out.real, out.imag, end.real, end.imag, into.real, into.imag)
    if found is None:
        return None
    x, y, tx, ty = found
    joint, along = complex(x, y), complex(tx, ty)
    first = bend(start.real, start.imag, out.real, out.imag, x, y)
    last = bend(x, y, tx, ty, end.real, end.imag)
    return Bow(start, out, first, joint, along), Bow(joint, along, last, end, into)
