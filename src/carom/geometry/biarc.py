"""Biarcs: two arcs that meet without a bend, from one place and direction to another.

An arc is told by where it begins, the unit tangent there, and its signed curvature: 1/radius, positive where it bends
to the left, 0 where it is straight. So an arc and a segment are one thing here, and nothing is lost where one is nearly
the other.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import BIARC_LEAST_DIVISOR
from carom.geometry.vector import cross, dot, length, unit


def biarc_joint(
    ax: float, ay: float, tx: float, ty: float, bx: float, by: float, ux: float, uy: float
) -> tuple[float, float, float, float] | None:
    """Where the two arcs from a to b meet, and the unit tangent there: (x, y, tangent x, tangent y).

    t and u are the unit tangents at a and b, in the direction of travel. Of the biarcs there are it is the one whose
    control polygon a, a + d·t, b - d·u, b has equal first and last legs: d is the positive root of
    2d²(1 - t·u) + 2d·v·(t + u) = v·v for v = b - a. None where a and b are one place, and where the legs would be
    longer than 1000 chords (t and u both nearly opposite to v). Source: K. M. Bolton, "Biarc curves", 1975.
    """
    vx, vy = bx - ax, by - ay
    chord = length(vx, vy)
    along = unit(vx, vy)
    if along is None:
        return None
    ex, ey = along
    forward = dot(tx, ty, ex, ey) + dot(ux, uy, ex, ey)
    sideways = cross(ex, ey, tx, ty) + cross(ex, ey, ux, uy)
    # (t·v + u·v)² + 2v²(1 - t·u), in units of v²; it is 4 - sideways², for t and u are of length 1.
    divisor = forward + sqrt(fabs((2.0 - sideways) * (2.0 + sideways)))
    if divisor < BIARC_LEAST_DIVISOR:
        return None
    leg = chord / divisor
    joint = unit(vx - leg * (tx + ux), vy - leg * (ty + uy))
    if joint is None:
        return None
    jx, jy = joint
    return 0.5 * (ax + leg * tx) + 0.5 * (bx - leg * ux), 0.5 * (ay + leg * ty) + 0.5 * (by - leg * uy), jx, jy


def bend(ax: float, ay: float, tx: float, ty: float, bx: float, by: float) -> float:
    """The signed curvature of the circle that leaves a along the unit tangent t and goes through b; 0 where a is b."""
    vx, vy = bx - ax, by - ay
    chord = length(vx, vy)
    if chord == 0.0:
        return 0.0
    return 2.0 * cross(tx, ty, vx / chord, vy / chord) / chord


def side_of_arc(tx: float, ty: float, curvature: float, x: float, y: float) -> float:
    """How far (x, y) lies to the left of the circle that leaves the origin along the unit tangent t; signed.

    The difference of the distance from the centre and the radius, without the loss of digits that it has for large
    radii: of a straight line, the distance.
    """
    lean = cross(tx, ty, x, y) - 0.5 * curvature * dot(x, y, x, y)
    rest = 1.0 - 2.0 * curvature * lean
    if rest <= 0.0:  # the centre itself, by rounding
        return 2.0 * lean
    return 2.0 * lean / (1.0 + sqrt(rest))
