"""Slow, independent twins of times of impact: dense samples of a gap by textbook formulas, and roots in 60 digits.

Figures are those of `tests.strategies`; a flight is a ball's motion, a carriage how a shape moves and turns meanwhile.
"""

import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from math import atan2, cos, hypot, inf, pi, sin, sqrt
from typing import Any

import mpmath

from carom.geometry import advance as advances
from carom.geometry import impact as impacts
from carom.geometry.arc import arc_ends
from tests import naive
from tests.flat import flat

advance, impact = flat(advances), flat(impacts)
Figure = tuple[str, tuple[float, ...]]


@dataclass(frozen=True)
class Flight:
    """A ball that moves along p + v·t + g·t²/2 for `duration` seconds."""

    x: float
    y: float
    radius: float
    vx: float
    vy: float
    gx: float
    gy: float
    duration: float

    def place(self, time: float) -> tuple[float, float]:
        """Where the ball's centre is."""
        return (
            self.x + self.vx * time + 0.5 * self.gx * time * time,
            self.y + self.vy * time + 0.5 * self.gy * time * time,
        )

    def path(self) -> float:
        """No less than the length of the way from the origin to the ball, and of its path."""
        speed, pull = hypot(self.vx, self.vy), hypot(self.gx, self.gy)
        return hypot(self.x, self.y) + (speed + pull * self.duration) * self.duration

    def numbers(self) -> tuple[float, ...]:
        """What carom takes of it, in its order."""
        return self.x, self.y, self.radius, self.vx, self.vy, self.gx, self.gy, self.duration


@dataclass(frozen=True)
class Carriage:
    """A pivot that moves, and an angular velocity about it."""

    x: float
    y: float
    vx: float
    vy: float
    spin: float

    def seen(self, x: float, y: float, time: float) -> tuple[float, float]:
        """Where something at (x, y) would be if the shape had stood still and all else had moved."""
        dx, dy = x - self.x - self.vx * time, y - self.y - self.vy * time
        c, s = cos(self.spin * time), sin(self.spin * time)
        return self.x + c * dx + s * dy, self.y + c * dy - s * dx


STANDING = Carriage(0.0, 0.0, 0.0, 0.0, 0.0)


def tangent(given: tuple[float, ...]) -> tuple[float, float, float]:
    """A segment's unit vector and length."""
    ax, ay, bx, by = given
    length = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
    return (bx - ax) / length, (by - ay) / length, length


def carom_impact(figure: Figure, flight: Flight, slop: float) -> float | None:
    """What carom finds for a figure at rest, in the form that carom takes it."""
    kind, given = figure
    numbers = flight.numbers()
    if kind == "point":
        return impact.impact_point(*given, *numbers)
    if kind == "segment":
        return impact.impact_segment(given[0], given[1], *tangent(given), *numbers, slop)
    cx, cy, r = given[:3]
    if kind == "arc":
        return impact.impact_arc(cx, cy, r, *arc_ends(cx, cy, r, *given[3:]), *numbers, slop)
    return impact.impact_circle(cx, cy, r, int(kind == "disc"), *numbers)


def carom_advance(figure: Figure, flight: Flight, carriage: Carriage, slop: float) -> float | None:
    """What carom finds for a figure that moves and turns."""
    kind, given = figure
    numbers = (carriage.x, carriage.y, carriage.vx, carriage.vy, carriage.spin, *flight.numbers())
    if kind == "point":
        return advance.advance_point(*given, *numbers)
    if kind == "segment":
        return advance.advance_segment(given[0], given[1], *tangent(given), *numbers, slop)
    cx, cy, r = given[:3]
    if kind == "arc":
        return advance.advance_arc(cx, cy, r, *arc_ends(cx, cy, r, *given[3:]), *numbers, slop)
    return advance.advance_circle(cx, cy, r, int(kind == "disc"), *numbers)


def gap(figure: Figure, radius: float, x: float, y: float) -> float:
    """The distance of a ball from the whole line or circle that a figure is part of."""
    kind, given = figure
    if kind == "segment":
        ax, ay, bx, by = given
        return abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / hypot(bx - ax, by - ay) - radius
    away = hypot(x - given[0], y - given[1])
    if kind in {"point", "disc"}:
        return away - radius - (given[2] if kind == "disc" else 0.0)
    return abs(away - given[2]) - radius


def edge(figure: Figure, x: float, y: float) -> float:
    """How far inside a figure's slab or sector a centre is, negative outside; infinite where there is none."""
    kind, given = figure
    if kind == "segment":
        ax, ay, bx, by = given
        length = hypot(bx - ax, by - ay)
        along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length
        return min(along, length - along)
    if kind != "arc":
        return inf
    away, angle = hypot(x - given[0], y - given[1]), atan2(y - given[1], x - given[0])
    nearest = min(naive.between(angle, ray) for ray in given[3:])
    off = away * (sin(nearest) if nearest < 0.5 * pi else 1.0)
    return off if naive.in_sector(given[3], given[4], x - given[0], y - given[1]) else -off


def samples(
    figure: Figure, flight: Flight, carriage: Carriage, until: float, count: int
) -> Iterator[tuple[float, ...]]:
    """Times up to `until`, each with the gap and the edge then."""
    for index in range(count + 1):
        time = until * (index / count)
        x, y = carriage.seen(*flight.place(time), time)
        yield time, gap(figure, flight.radius, x, y), edge(figure, x, y)


def missed(
    figure: Figure, flight: Flight, carriage: Carriage, until: float, tolerance: float, count: int
) -> float | None:
    """A time before `until` by which the ball, beside the figure, has gone from clear to deeper than `tolerance`."""
    clear = False
    for time, depth, inside in samples(figure, flight, carriage, until, count):
        if inside <= tolerance:
            clear = False
        elif depth > tolerance:
            clear = True
        elif clear and depth < -tolerance:
            return time
    return None


def quartic(flight: Flight, cx: float, cy: float, level: Any) -> list[Any]:
    """The coefficients of |p(t) - c|² - level²."""
    exact = mpmath.mpf
    px, py = exact(flight.x) - exact(cx), exact(flight.y) - exact(cy)
    vx, vy, gx, gy = (exact(number) for number in (flight.vx, flight.vy, flight.gx, flight.gy))
    return [
        (gx * gx + gy * gy) / 4,
        vx * gx + vy * gy,
        vx * vx + vy * vy + px * gx + py * gy,
        2 * (px * vx + py * vy),
        px * px + py * py - level * level,
    ]


def exact_falls(coefficients: list[Any], duration: float) -> list[tuple[Any, Any]]:
    """The times within a duration at which a polynomial falls through zero, each with its slope there."""
    while coefficients and coefficients[0] == 0:
        coefficients = coefficients[1:]
    if len(coefficients) < 2:
        return []
    scale = max(map(abs, coefficients))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # newer releases ask for an order that older ones lack
        roots = mpmath.polyroots([part / scale for part in coefficients], maxsteps=500, extraprec=500, error=False)
    real = [mpmath.re(root) for root in roots if abs(mpmath.im(root)) <= mpmath.mpf(10) ** -25 * (1 + abs(root))]
    found = [(root, slope_at(coefficients, root)) for root in sorted(real)]
    return [(root, slope) for root, slope in found if 0 <= root <= duration and slope < 0]


def slope_at(coefficients: list[Any], time: Any) -> Any:
    """The rate of change of a polynomial."""
    degree = len(coefficients) - 1
    return sum(part * (degree - at) * time ** (degree - at - 1) for at, part in enumerate(coefficients[:-1]))


def exact_touches(figure: Figure, flight: Flight) -> list[tuple[float, float, float]]:
    """All touches of the figure's whole line or circle, as (time, speed of approach, edge), by roots in 60 digits."""
    kind, given = figure
    with mpmath.workdps(60):
        exact = mpmath.mpf
        found: list[tuple[Any, Any]] = []
        if kind == "segment":
            tx, ty, _ = tangent(given)
            for sign in (1, -1):
                pull = sign * (exact(tx) * flight.gy - exact(ty) * flight.gx) / 2
                rate = sign * (exact(tx) * flight.vy - exact(ty) * flight.vx)
                side = sign * (exact(tx) * (exact(flight.y) - given[1]) - exact(ty) * (exact(flight.x) - given[0]))
                found += exact_falls([pull, rate, side - flight.radius], flight.duration)
        else:
            r = exact(given[2]) if kind != "point" else exact(0)
            outer = r + exact(flight.radius)
            falls = exact_falls(quartic(flight, given[0], given[1], outer), flight.duration)
            found += [(time, slope / (2 * outer)) for time, slope in falls]
            inner = r - exact(flight.radius)
            if kind in {"circle", "arc"} and inner > 0:
                rises = [-part for part in quartic(flight, given[0], given[1], inner)]
                found += [(time, slope / (2 * inner)) for time, slope in exact_falls(rises, flight.duration)]
        return [(float(time), -float(slope), edge(figure, *flight.place(float(time)))) for time, slope in sorted(found)]
