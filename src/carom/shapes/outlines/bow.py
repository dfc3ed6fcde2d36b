"""Arcs and straight pieces on their way from place to place, and how far curves lie from them."""

from __future__ import annotations

from cmath import phase
from math import inf
from typing import NamedTuple

from carom.constants import LARGEST_RADIUS
from carom.geometry.biarc import bend, biarc_joint, side_of_arc
from carom.shapes.outlines.cubic import Cubic, cross, dot

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
        places = [place - self.start for place in cubic]
        leans = [cross(self.out, place) for place in places]
        values = _lean(leans, self.curvature, places)
        if not (outside <= values[0] <= inside and outside <= values[6] <= inside):
            return False
        slack = -PAST_END * room
        if dot(self.out, places[0]) < slack or dot(self.into, self.end - cubic.d) < slack:
            return False
        if outside <= min(values) and max(values) <= inside:
            ahead = min(dot(self.out, place) for place in places)
            if ahead >= slack and min(dot(self.into, self.end - place) for place in cubic) >= slack:
                return True
        if halvings == 0:
            return False
        return all(self.follows(half, room, halvings - 1) for half in cubic.halves())


def _bounds(curvature: float, room: float) -> tuple[float, float]:
    """The most and the least of q·n - k·q²/2 within `room` of an arc."""
    half = 0.5 * curvature * room * room
    inside, outside = room - half, -room - half
    if curvature * room >= 1.0:
        inside = inf
    elif curvature * room <= -1.0:
        outside = -inf
    return inside, outside


def _lean(sides: list[float], curvature: float, q: list[complex]) -> list[float]:
    """The Bernstein coefficients of degree 6 of q·n - k·q²/2, for those of q·n and q, of degree 3."""
    half = 0.5 * curvature
    squares = (
        dot(q[0], q[0]),
        dot(q[0], q[1]),
        (2.0 * dot(q[0], q[2]) + 3.0 * dot(q[1], q[1])) / 5.0,
        (dot(q[0], q[3]) + 9.0 * dot(q[1], q[2])) / 10.0,
        (2.0 * dot(q[1], q[3]) + 3.0 * dot(q[2], q[2])) / 5.0,
        dot(q[2], q[3]),
        dot(q[3], q[3]),
    )
    s0, s1, s2, s3 = sides
    raised = (
        s0,
        (s0 + s1) / 2.0,
        (s0 + 3.0 * s1 + s2) / 5.0,
        (s0 + 9.0 * s1 + 9.0 * s2 + s3) / 20.0,
        (s1 + 3.0 * s2 + s3) / 5.0,
        (s2 + s3) / 2.0,
        s3,
    )
    return [lean - half * square for lean, square in zip(raised, squares, strict=True)]


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
