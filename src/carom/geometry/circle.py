"""Circles: nearest points, insides, and the tangents from a point and to another circle."""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import ROUNDING
from carom.geometry.exact import exact_product, exact_sum
from carom.geometry.vector import length, unit


def circle_contains(cx: float, cy: float, radius: float, x: float, y: float) -> bool:
    """Whether (x, y) lies strictly inside the circle about c, compared as squares."""
    dx, dy = x - cx, y - cy
    return dx * dx + dy * dy < radius * radius


def closest_on_circle(cx: float, cy: float, radius: float, x: float, y: float) -> tuple[float, float]:
    """The point of the circle's perimeter nearest to (x, y); the point at angle 0 for the centre itself."""
    direction = unit(x - cx, y - cy)
    if direction is None:
        return cx + radius, cy
    ux, uy = direction
    return cx + radius * ux, cy + radius * uy


def closest_on_disc(cx: float, cy: float, radius: float, x: float, y: float) -> tuple[float, float, bool]:
    """The point of a solid circle's or a ball's perimeter nearest to (x, y), and whether that is inside."""
    px, py = closest_on_circle(cx, cy, radius, x, y)
    return px, py, circle_contains(cx, cy, radius, x, y)


def tangent_points(cx: float, cy: float, radius: float, x: float, y: float) -> tuple[float, float, float, float] | None:
    """Where the two tangents through p = (x, y) touch the circle about c, as (x0, y0, x1, y1); None from inside.

    The first is the one counterclockwise of the direction from p to c. A point on the circle, to within the rounding
    of its coordinates, is its own tangent point, twice.

    With d = |c - p| and δ² = d² - R² the touching points are c + R·(-R/d·û ± δ/d·perp(û)), û = (c - p)/d: reckoned
    from the centre, so that no digits are lost to a point far away, and with δ² summed so that none are lost to a
    point close to the circle.
    """
    dx, dy = cx - x, cy - y
    distance = length(dx, dy)
    excess = power(x, y, cx, cy, radius, 0.0)
    if fabs(excess) <= (distance + radius) * ROUNDING * (radius + fabs(cx) + fabs(cy)):
        return x, y, x, y
    direction = unit(dx, dy)
    if excess < 0.0 or direction is None:
        return None
    ux, uy = direction
    # Ratios of lengths first, whose products neither vanish nor overflow.
    back = radius * (radius / distance)
    side = radius * (sqrt(excess) / distance)
    left, up = cx - back * ux, cy - back * uy
    return left - side * uy, up + side * ux, left + side * uy, up - side * ux


def common_tangents(
    x1: float, y1: float, r1: float, x2: float, y2: float, r2: float
) -> tuple[float, float, float, float, float, float, float, float] | None:
    """The two outer common tangents of two circles, as (first: x, y on circle 1, x, y on circle 2; second: the same).

    The first is the one counterclockwise of the direction from circle 1 to circle 2. None where one circle lies
    inside the other, touching or not, or where they are so nearly the same that the ends of a tangent are one point.

    Both tangents touch the circles along one normal n each: n·û = (r1 - r2)/d, with û the direction from centre to
    centre, since the centres' distances r1 and r2 from the line differ by d·(n·û). Any order of radii is right.
    """
    direction = unit(x2 - x1, y2 - y1)
    excess = power(x1, y1, x2, y2, r1, r2)
    if excess <= 0.0 or direction is None:
        return None
    ux, uy = direction
    distance = length(x2 - x1, y2 - y1)
    cosine = (r1 - r2) / distance
    sine = sqrt(excess) / distance
    # n is û turned by the angle of that cosine, to either side; its sine is the tangent's length over d.
    nx, ny = cosine * ux - sine * uy, cosine * uy + sine * ux
    mx, my = cosine * ux + sine * uy, cosine * uy - sine * ux
    px, py, qx, qy = x1 + r1 * nx, y1 + r1 * ny, x2 + r2 * nx, y2 + r2 * ny
    sx, sy, tx, ty = x1 + r1 * mx, y1 + r1 * my, x2 + r2 * mx, y2 + r2 * my
    # The excess is above zero, but a tangent shorter than the rounding of places has no direction.
    if (px == qx and py == qy) or (sx == tx and sy == ty):
        return None
    return px, py, qx, qy, sx, sy, tx, ty


def power(x1: float, y1: float, x2: float, y2: float, r1: float, r2: float) -> float:
    """|p2 - p1|² - (r1 - r2)², the squared length of a tangent, to about 30 digits of its largest term.

    With r2 = 0 it is the power of the point p1 for the circle (p2, r1). Every difference and square is taken with its
    rounding error (Shewchuk 1997, sections 2.3 to 2.5), so that the terms may cancel.
    """
    dx, dx_tail = exact_sum(x2, -x1)
    dy, dy_tail = exact_sum(y2, -y1)
    dr, dr_tail = exact_sum(r1, -r2)
    xx, xx_tail = exact_product(dx, dx)
    yy, yy_tail = exact_product(dy, dy)
    rr, rr_tail = exact_product(dr, dr)
    plus, plus_tail = exact_sum(xx, yy)
    head, head_tail = exact_sum(plus, -rr)
    # (d + tail)² is d² + 2·d·tail, but for the square of the tail, which is below the last of 30 digits.
    mixed = 2.0 * (dx * dx_tail + dy * dy_tail - dr * dr_tail)
    return head + (plus_tail + head_tail + (xx_tail + yy_tail - rr_tail) + mixed)
