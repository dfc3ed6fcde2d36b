"""What outlines are made of before they are shapes: straight pieces, pieces of ellipses, cubic Béziers, other curves.

All of them stay what they are under any linear transform, so that groups may turn, mirror, stretch and slant them; what
is a circle is only asked at the end. Coordinates are those of the drawing until a transform has turned y up.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, dist, hypot, pi, sin
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float]

#: The share of its radius by which an ellipse may differ from a circle and be one: what transforms with six digits and
#: more leave of a turned circle.
ROUND = 1e-6


@dataclass(frozen=True, slots=True)
class Matrix:
    """A linear transform: (x, y) becomes (ax + cy + e, bx + dy + f)."""

    a: float = 1.0
    b: float = 0.0
    c: float = 0.0
    d: float = 1.0
    e: float = 0.0
    f: float = 0.0

    def after(self, first: Matrix) -> Matrix:
        """The transform that does `first` and then this one."""
        a, b = self.turned((first.a, first.b))
        c, d = self.turned((first.c, first.d))
        e, f = self.place((first.e, first.f))
        return Matrix(a, b, c, d, e, f)

    def place(self, point: Vector) -> Vector:
        """Where a point comes to lie."""
        x, y = point
        return self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f

    def turned(self, vector: Vector) -> Vector:
        """What becomes of a vector."""
        x, y = vector
        return self.a * x + self.c * y, self.b * x + self.d * y


@dataclass(frozen=True, slots=True)
class Straight:
    """A straight piece."""

    start: Vector
    end: Vector

    def moved(self, matrix: Matrix) -> Straight:
        """The piece after a transform."""
        return Straight(matrix.place(self.start), matrix.place(self.end))

    def points(self) -> tuple[Vector, ...]:
        """Points that the piece lies between."""
        return self.start, self.end


@dataclass(frozen=True, slots=True)
class Conic:
    """A piece of an ellipse, or all of it: `center + u cos(t) + v sin(t)`, with t from `begin` on for `sweep`."""

    center: Vector
    u: Vector
    v: Vector
    begin: float = 0.0
    sweep: float = 2.0 * pi

    @property
    def start(self) -> Vector:
        """Where it begins."""
        return self.at(self.begin)

    @property
    def end(self) -> Vector:
        """Where it ends."""
        return self.at(self.begin + self.sweep)

    @property
    def whole(self) -> bool:
        """Whether it goes all the way round."""
        return abs(self.sweep) >= 2.0 * pi

    @property
    def round(self) -> bool:
        """Whether it is part of a circle."""
        (ux, uy), (vx, vy) = self.u, self.v
        size = hypot(ux, uy)
        return abs(hypot(vx, vy) - size) <= ROUND * size and abs(ux * vx + uy * vy) <= ROUND * size * size

    @property
    def radius(self) -> float:
        """The radius of what is round."""
        return 0.5 * (hypot(*self.u) + hypot(*self.v))

    def at(self, t: float) -> Vector:
        """The point at a parameter."""
        (x, y), (ux, uy), (vx, vy) = self.center, self.u, self.v
        return x + ux * cos(t) + vx * sin(t), y + uy * cos(t) + vy * sin(t)

    def moved(self, matrix: Matrix) -> Conic:
        """The piece after a transform."""
        center, u, v = matrix.place(self.center), matrix.turned(self.u), matrix.turned(self.v)
        return Conic(center, u, v, self.begin, self.sweep)

    def points(self) -> tuple[Vector, ...]:
        """Points of the piece; of a whole one the corners of its box."""
        if self.whole:
            (x, y), across, along = self.center, hypot(self.u[0], self.v[0]), hypot(self.u[1], self.v[1])
            return (x - across, y - along), (x + across, y + along)
        (x, y), (ux, uy), (vx, vy) = self.center, self.u, self.v
        turns = [self.begin + 0.25 * k * self.sweep for k in range(5)]
        return tuple((x + ux * cos(t) + vx * sin(t), y + uy * cos(t) + vy * sin(t)) for t in turns)


@dataclass(frozen=True, slots=True)
class Cubic:
    """A cubic Bézier curve."""

    start: Vector
    first: Vector
    second: Vector
    end: Vector

    def moved(self, matrix: Matrix) -> Cubic:
        """The piece after a transform."""
        return Cubic(*(matrix.place(point) for point in self.points()))

    def points(self) -> tuple[Vector, Vector, Vector, Vector]:
        """Points that the piece lies between."""
        return self.start, self.first, self.second, self.end


@dataclass(frozen=True, slots=True)
class Course:
    """Any smooth curve, `curve(t)` with t from 0 to 1."""

    curve: Callable[[float], Vector]
    matrix: Matrix = Matrix()

    @property
    def start(self) -> Vector:
        """Where it begins."""
        return self.at(0.0)

    @property
    def end(self) -> Vector:
        """Where it ends."""
        return self.at(1.0)

    def at(self, t: float) -> Vector:
        """The point at a parameter."""
        return self.matrix.place(self.curve(t))

    def moved(self, matrix: Matrix) -> Course:
        """The piece after a transform."""
        return Course(self.curve, matrix.after(self.matrix))

    def points(self) -> tuple[Vector, ...]:
        """Points of the piece."""
        return tuple(self.at(k / 16.0) for k in range(17))


Piece: TypeAlias = Straight | Conic | Cubic | Course


def moved(outline: list[Piece], matrix: Matrix) -> list[Piece]:
    """The pieces of an outline after a transform; an end that is the next one's beginning is one place in both."""
    done: list[Piece] = []
    before: Vector | None = None
    after: Vector | None = None
    for piece in outline:
        if isinstance(piece, (Straight, Cubic)):
            start = after if after is not None and piece.start is before else matrix.place(piece.start)
            before, after = piece.end, matrix.place(piece.end)
            if isinstance(piece, Straight):
                done.append(Straight(start, after))
            else:
                done.append(Cubic(start, matrix.place(piece.first), matrix.place(piece.second), after))
        else:
            done.append(piece.moved(matrix))
    return done


def is_bare(piece: Piece, length: float) -> bool:
    """Whether a piece is no more than a place: no part of it farther than about a `length` from its start.

    A whole ellipse is only that where a transform has left it no area.
    """
    x, y = piece.start
    if isinstance(piece, Straight):
        return abs(piece.end[0] - x) <= length and abs(piece.end[1] - y) <= length
    if isinstance(piece, Conic) and piece.whole:
        return piece.u[0] * piece.v[1] == piece.u[1] * piece.v[0]
    return all(hypot(px - x, py - y) <= length for px, py in piece.points())


def is_nothing(outlines: list[list[Piece]]) -> bool:
    """Whether outlines draw nothing at all: none of their pieces is more than a place."""
    return all(is_bare(piece, 0.0) for outline in outlines for piece in outline)


def arcs_of(piece: Piece, tolerance: float) -> float:
    """About how many arcs stand for a piece within a tolerance; 0 of what is straight or round.

    An arc deviates by the cube of its length, so they are as many as the root of the curve's length in tolerances. They
    come in pairs.
    """
    if isinstance(piece, Straight) or (isinstance(piece, Conic) and piece.round):
        return 0.0
    if isinstance(piece, Conic):
        length = abs(piece.sweep) * piece.radius
    else:
        points = piece.points()
        length = sum(map(dist, points, points[1:]))
    return max(2.0, 1.0 + 0.6 * float((length / tolerance) ** (1.0 / 3.0)))
