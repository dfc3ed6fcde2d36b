"""Pieces of ellipses from their ends, as SVG writes them, and from a bulge, as DXF does."""

from __future__ import annotations

from math import atan, atan2, cos, hypot, radians, sin, sqrt

from carom.scene.drawings.pieces import Conic, Straight, Vector


def between(
    start: Vector, end: Vector, radii: Vector, turn: float, *, large: bool, onward: bool
) -> Conic | Straight | None:
    """The piece of an ellipse from `start` to `end`; None where these are one place, straight where a radius is 0.

    `turn` is that of the ellipse's first axis, in degrees; `large` takes the longer way, `onward` the way of growing
    angles. Radii that are too small to reach grow until they do. Source: SVG 2, appendix B.2.4; the angles are taken by
    `atan2`, for an arc cosine loses half of the digits near half a turn.
    """
    rx, ry = abs(radii[0]), abs(radii[1])
    if start == end:
        return None
    if rx == 0.0 or ry == 0.0:
        return Straight(start, end)
    c, s = cos(radians(turn)), sin(radians(turn))
    dx, dy = 0.5 * (start[0] - end[0]), 0.5 * (start[1] - end[1])
    # The half chord, in units of the radii, as the ellipse's own axes see it.
    hx, hy = (c * dx + s * dy) / rx, (c * dy - s * dx) / ry
    half = hypot(hx, hy)
    if half > 1.0:
        rx, ry, hx, hy, half = rx * half, ry * half, hx / half, hy / half, 1.0
    distance = sqrt((1.0 - half) * (1.0 + half))
    away = (-distance if large == onward else distance) / half
    mx, my = away * hy, -away * hx
    begin = atan2(hy - my, hx - mx)
    sweep = 2.0 * atan2(half, -distance if large else distance)
    ux, uy, vx, vy = rx * c, rx * s, -ry * s, ry * c
    center = 0.5 * (start[0] + end[0]) + mx * ux + my * vx, 0.5 * (start[1] + end[1]) + mx * uy + my * vy
    return Conic(center, (ux, uy), (vx, vy), begin, sweep if onward else -sweep)


def bulged(start: Vector, end: Vector, bulge: float) -> Conic | Straight | None:
    """The arc from `start` to `end` whose quarter angle has the tangent `bulge`, counterclockwise if positive.

    Straight without a bulge, None where both ends are one place.
    """
    if start == end:
        return None
    if bulge == 0.0:
        return Straight(start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    # From the middle of the chord to the centre, in chords: (1 - b²)/(4b) to the left.
    left = (1.0 - bulge * bulge) / (4.0 * bulge)
    center = 0.5 * (start[0] + end[0]) - left * dy, 0.5 * (start[1] + end[1]) + left * dx
    radius = hypot(dx, dy) * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
    begin = atan2(start[1] - center[1], start[0] - center[0])
    return Conic(center, (radius, 0.0), (0.0, radius), begin, 4.0 * atan(bulge))
