"""What a contact does to velocities and positions, per unit of mass where nothing else is said.

`n` is the unit normal from the shape to the ball, `s` a ball's velocity relative to the surface along it: negative
where the ball approaches. `e` is the product of the two elasticities.
"""

from __future__ import annotations

from math import sqrt

from carom.constants import GREATEST_SQUARE, LEAST_SQUARE
from carom.geometry.vector import dot, unit


def approach_at_contact(s: float, g_n: float, setback: float) -> float:
    """The approach `s` as it was when the ball touched, before it fell, or rose, `setback` too far along the normal.

    `s² + 2·g_n·setback` is its square, by the conservation of energy, with `g_n` the acceleration along the normal;
    0 where the ball cannot have come so deep. A ball that does not approach keeps its `s`, and so does one without
    acceleration along the normal, to the bit.
    """
    gain = 2.0 * g_n * setback
    if s >= 0.0 or gain == 0.0:
        return s
    approach_squared = s * s + gain
    if approach_squared <= 0.0:
        return 0.0
    return -sqrt(approach_squared)


def reflected(
    vx: float,
    vy: float,
    surface_vx: float,
    surface_vy: float,
    nx: float,
    ny: float,
    e: float,
    approach: float,
    kick: float,
    total: bool,
) -> tuple[float, float, float]:
    """The velocity of a ball after a bounce, and the speed gained along the normal.

    The normal part of w, the velocity relative to the surface, becomes `-e·approach + kick`, whatever it is now;
    `approach` is that at contact (`approach_at_contact`), `kick` the speed that the shape adds. The part along the
    surface stays, or by the `total` rule is scaled by `e` too: to `v_surface + e·(w - 2(w·n)n) + kick·n`, the normal
    part of w taken as at contact. The third result is the impulse along the normal per unit of the ball's mass.
    """
    wx, wy = vx - surface_vx, vy - surface_vy
    s = wx * nx + wy * ny
    gain = kick - e * approach - s
    if not total:
        return vx + gain * nx, vy + gain * ny, gain
    # w - (s + approach)·n has the part along the surface of w, and the normal part -approach.
    turned = s + approach
    rx = e * (wx - turned * nx) + kick * nx
    ry = e * (wy - turned * ny) + kick * ny
    return surface_vx + rx, surface_vy + ry, gain


def rebounded(
    vx: float,
    vy: float,
    surface_vx: float,
    surface_vy: float,
    px: float,
    py: float,
    e: float,
    kick: float,
    total: bool,
) -> tuple[float, float, float]:
    """What `reflected` returns for a ball at its very touch, by a normal p of any length in place of the unit normal.

    p is the vector from the touched place to the ball's centre, or along it, as from a centre of curvature. With w the
    velocity relative to the surface, `v - (1+e)·(w·p)/(p·p)·p` keeps the speed at e = 1 without the rounding of a unit
    vector. A share of p that is off by a unit in the last place still changes the speed, by the same again and again
    where p·p is next to a power of two and the places round it are finer on one side: so the normal part that is found
    to be left over is taken away too. Without a normal, the velocity stays.
    """
    squared = px * px + py * py
    if not LEAST_SQUARE < squared < GREATEST_SQUARE:
        direction = unit(px, py)
        if direction is None:
            return vx, vy, 0.0
        px, py = direction
        squared = px * px + py * py
    size = sqrt(squared)
    along = dot(vx - surface_vx, vy - surface_vy, px, py)
    # By the total rule the velocity is mirrored first, and then scaled.
    mirrored = along if total else e * along - kick * size
    share = (mirrored + along) / squared
    x, y = vx - share * px, vy - share * py
    rest = (mirrored + dot(x - surface_vx, y - surface_vy, px, py)) / squared
    x, y = x - rest * px, y - rest * py
    if total:
        push = kick / size
        x, y = surface_vx + e * (x - surface_vx) + push * px, surface_vy + e * (y - surface_vy) + push * py
    return x, y, kick - (e * along + along) / size


def exchanged(u1: float, u2: float, m1: float, m2: float, e: float) -> tuple[float, float]:
    """The normal velocities of two balls after they met with u1 and u2.

    `u1' = (m1·u1 + m2·u2 - e·m2·(u1 - u2))/(m1 + m2)` and its mirror, in the form that gives equal masses at e = 1
    exactly each other's velocity. Momentum is conserved to rounding at every `e`, energy at e = 1.
    """
    total = m1 + m2
    part1 = m1 / total
    part2 = m2 / total
    after1 = (part1 - e * part2) * u1 + (1.0 + e) * part2 * u2
    after2 = (1.0 + e) * part1 * u1 + (part2 - e * part1) * u2
    return after1, after2


def separated(
    x1: float, y1: float, m1: float, x2: float, y2: float, m2: float, nx: float, ny: float, setback: float
) -> tuple[float, float, float, float]:
    """The places (x1, y1, x2, y2) of two overlapping balls moved apart by `setback` until they touch.

    They move along the normal, which points from the first to the second, in inverse proportion to their masses.
    """
    total = m1 + m2
    back = setback * (m2 / total)
    forth = setback * (m1 / total)
    return x1 - back * nx, y1 - back * ny, x2 + forth * nx, y2 + forth * ny
