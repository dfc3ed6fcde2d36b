"""Slow, independent twins of the geometry, by angles, textbook formulas and `math.hypot`.

They take figures as `tests.strategies` makes them and are right to about nine digits away from the edges of slabs and
sectors; `margin` says how far away a meeting is from any edge at which an answer jumps.
"""

from collections.abc import Callable
from math import atan2, cos, hypot, inf, pi, sin, sqrt

from carom.geometry import overlap as overlaps
from carom.geometry.arc import arc_ends
from tests.flat import flat

overlap = flat(overlaps)
Contact = tuple[float, float, float, float, float]
Figure = tuple[str, tuple[float, ...]]


def in_sector(start: float, end: float, x: float, y: float) -> bool:
    """Whether the direction of (x, y) is from `start` counterclockwise to `end`, by the arctangent."""
    angle = atan2(y, x) % (2.0 * pi)
    if start < end:
        return start <= angle <= end
    return angle >= start or angle <= end


def between(angle: float, other: float) -> float:
    """The angle between two directions, 0 to π."""
    turn = abs(angle - other) % (2.0 * pi)
    return min(turn, 2.0 * pi - turn)


def closest(figure: Figure, x: float, y: float) -> tuple[float, float] | None:
    """The point of a figure that a ball at (x, y) meets, None past an end; for no centre of a circle."""
    kind, given = figure
    if kind == "point":
        return given[0], given[1]
    if kind == "segment":
        ax, ay, bx, by = given
        part = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
        return (ax + part * (bx - ax), ay + part * (by - ay)) if 0.0 <= part <= 1.0 else None
    if kind == "arc" and not in_sector(given[3], given[4], x - given[0], y - given[1]):
        return None
    angle = atan2(y - given[1], x - given[0])
    return given[0] + given[2] * cos(angle), given[1] + given[2] * sin(angle)


def find_overlap(figure: Figure, x: float, y: float, radius: float) -> Contact | None:
    """The overlap of a ball with a figure whose closest point is not the ball's very centre."""
    place = closest(figure, x, y)
    if place is None:
        return None
    px, py = place
    gap = hypot(x - px, y - py)
    if figure[0] == "disc" and hypot(x - figure[1][0], y - figure[1][1]) < figure[1][2]:
        return px, py, (px - x) / gap, (py - y) / gap, radius + gap
    return (px, py, (x - px) / gap, (y - py) / gap, radius - gap) if gap < radius else None


def margin(figure: Figure, x: float, y: float, radius: float) -> float:
    """How far a ball is from any place where its overlap with a figure begins, ends or turns about."""
    kind, given = figure
    if kind == "point":
        gap = hypot(x - given[0], y - given[1])
        return min(gap, abs(radius - gap))
    if kind == "segment":
        ax, ay, bx, by = given
        length = hypot(bx - ax, by - ay)
        along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length
        gap = abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length
        return min(gap, abs(radius - gap), abs(along), abs(along - length))
    away = hypot(x - given[0], y - given[1])
    least = min(away, abs(away - given[2]), abs(abs(away - given[2]) - radius))
    if kind != "arc":
        return least
    angle = atan2(y - given[1], x - given[0])
    return min(least, *(away * between(angle, edge) for edge in given[3:]))


def carom_overlap(figure: Figure, x: float, y: float, radius: float, wx: float, wy: float) -> Contact | None:
    """What carom finds for a figure, in the form that carom takes it."""
    kind, given = figure
    if kind == "point":
        return overlap.overlap_point(given[0], given[1], x, y, radius, wx, wy)
    if kind == "segment":
        ax, ay, bx, by = given
        length = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
        tx, ty = (bx - ax) / length, (by - ay) / length
        return overlap.overlap_segment(ax, ay, tx, ty, length, x, y, radius, wx, wy)
    cx, cy, r = given[:3]
    if kind == "arc":
        return overlap.overlap_arc(cx, cy, r, *arc_ends(cx, cy, r, *given[3:]), x, y, radius, wx, wy)
    return overlap.overlap_circle(cx, cy, r, int(kind == "disc"), x, y, radius, wx, wy)


def moved_point(motion: tuple[float, float, float], x: float, y: float) -> tuple[float, float]:
    """A point turned about the origin by the motion's angle, then shifted."""
    turn, dx, dy = motion
    return x * cos(turn) - y * sin(turn) + dx, x * sin(turn) + y * cos(turn) + dy


def moved_figure(motion: tuple[float, float, float], figure: Figure) -> Figure:
    """A figure moved likewise."""
    kind, given = figure
    place = moved_point(motion, given[0], given[1])
    if kind == "segment":
        return kind, place + moved_point(motion, given[2], given[3])
    edges = tuple((edge + motion[0]) % (2.0 * pi) for edge in given[3:])
    return kind, place + given[2:3] + edges


def tangent_points(
    cx: float, cy: float, radius: float, x: float, y: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Where the tangents through an outer point touch a circle, by the angles of the triangle."""
    away = hypot(cx - x, cy - y)
    tangent = sqrt(away * away - radius * radius)
    middle, half = atan2(cy - y, cx - x), atan2(radius, tangent)
    first, second = middle + half, middle - half
    return (x + tangent * cos(first), y + tangent * sin(first)), (x + tangent * cos(second), y + tangent * sin(second))


def exchanged(u1: float, u2: float, m1: float, m2: float, e: float) -> tuple[float, float]:
    """Velocities after a meeting, by way of the common centre of mass, where each one turns about and is scaled."""
    common = (m1 * u1 + m2 * u2) / (m1 + m2)
    return common - e * (u1 - common), common - e * (u2 - common)


def least_by_search(function: Callable[[float], float], low: float, high: float) -> float:
    """The least value of a function in a range, by ever finer grids."""
    least = inf
    for _ in range(12):
        step = (high - low) / 40.0
        value, place = min((function(low + step * index), low + step * index) for index in range(41))
        least = min(least, value)
        low, high = max(low, place - step), min(high, place + step)
    return least
