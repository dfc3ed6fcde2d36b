"""Segments and arcs from what an outline was reckoned in, and the points that their ends need."""

from __future__ import annotations

import inspect
from cmath import phase, rect
from collections.abc import Callable, Iterable, Iterator
from math import frexp, ldexp, pi, sin
from typing import Any, NamedTuple, TypeVar

from carom.checks import flag, positive, refuse
from carom.constants import HALF_PI, LEAST_TOLERANCE, STRAIGHT_TURN
from carom.geometry.angle import normalize_angle
from carom.rows.shape import KIND_NAMES
from carom.shapes import SHAPE_CLASSES
from carom.shapes.guard import guard_points
from carom.shapes.outlines.bow import Bow, largest_radius
from carom.shapes.shape import Shape, ShapeOptions
from carom.spelling import spelled
from carom.typing import Vector

F = TypeVar("F", bound=Callable[..., Any])

#: Powers of two between which the largest coordinate of a curve has to be, so that radii and tolerances are doubles.
SMALLEST_UNIT, LARGEST_UNIT = -960, 960

#: The rounding of places in units of the largest coordinate, times what a tolerance must be above it.
LEAST_OF_PLACES = 1e-12

#: Two arcs are one where they part by less than this, in units of the largest coordinate, and turn by less, in radians.
SAME_ARC, WIDEST_JOINED = 1e-15, 4.0

#: Share of the tolerance within which two segments are one.
SAME_LINE = 1e-2


def builder(function: F) -> F:
    """The function, which takes the options of every shape besides its own arguments and refuses all others."""
    own = list(inspect.signature(function).parameters.values())
    common = list(inspect.signature(Shape._fill).parameters.values())[2:]
    made: Any = function
    made.__signature__ = inspect.Signature([*own[:-1], *common])
    return spelled(function)


class Figure(NamedTuple):
    """A segment or an arc before it is a shape: its kind, and the arguments that make it, angles in [0, 2π)."""

    kind: str
    geometry: dict[str, Any]


class Frame(NamedTuple):
    """The unit of length that a curve is reckoned in, a power of two: all coordinates are then 1 at most."""

    power: int

    def inward(self, place: Vector) -> complex:
        """A place in this unit."""
        return complex(ldexp(place[0], -self.power), ldexp(place[1], -self.power))

    def outward(self, place: complex) -> Vector:
        """A place as users know it."""
        return ldexp(place.real, self.power), ldexp(place.imag, self.power)

    def length(self, size: float) -> float:
        """A length as users know it."""
        return ldexp(size, self.power)


def frame_of(name: str, places: Iterable[Vector]) -> Frame:
    """The frame for places; raises, argument `name` to blame, where they are too large or small to be reckoned with."""
    most = max(max(abs(x), abs(y)) for x, y in places)
    power = frexp(most)[1]
    if most > 0.0 and not SMALLEST_UNIT <= power <= LARGEST_UNIT:
        raise refuse(name, f"must have coordinates of 2^{SMALLEST_UNIT} to 2^{LARGEST_UNIT}", most)
    return Frame(power)


def tolerance_in(frame: Frame, tolerance: Any, size: float) -> float:
    """A user's tolerance in a frame, where a curve is about as large as `size`; raises where it is too small for that.

    Twice the greatest coordinate, and so everything, if it is larger.
    """
    given = positive("tolerance", tolerance)
    least = max(LEAST_TOLERANCE * size, LEAST_OF_PLACES)
    if given < frame.length(least):
        raise refuse(
            "tolerance", f"must be at least {frame.length(least):.3g} for a curve of this size and place", given
        )
    return ldexp(min(given, frame.length(2.0)), -frame.power)


def walled(bows: Iterable[Bow], tolerance: float, frame: Frame, guard: Any, options: ShapeOptions) -> list[Shape]:
    """The segments and arcs for a chain of arcs that was reckoned in a frame, and the points that they need."""
    classes: dict[str, Any] = {KIND_NAMES[code]: made for code, made in SHAPE_CLASSES.items()}
    return guarded([classes[kind](**geometry, **options) for kind, geometry in figures(bows, tolerance, frame)], guard)


def figures(bows: Iterable[Bow], tolerance: float, frame: Frame) -> list[Figure]:
    """What `walled` makes shapes of."""
    return [_figure(bow, frame) for bow in _straightened(_joined(bows, tolerance), largest_radius(tolerance))]


def guarded(walls: list[Shape], guard: Any) -> list[Shape]:
    """Walls, and the points that their ends need if `guard` says so, which are named as the walls are."""
    if not flag("guard", guard):
        return walls
    points = guard_points(walls)
    for point in points:
        point.name, point.user = walls[0].name, walls[0].user
    return [*walls, *points]


def _joined(bows: Iterable[Bow], tolerance: float) -> Iterator[Bow]:
    """The arcs, those of one circle or line that follow each other made one."""
    last: Bow | None = None
    for bow in bows:
        if last is not None and last.into == bow.out and _is_one(last, bow, tolerance):
            last = Bow(last.start, last.out, 0.5 * (last.curvature + bow.curvature), bow.end, bow.into)
            continue
        if last is not None:
            yield last
        last = bow
    if last is not None:
        yield last


def _is_one(first: Bow, last: Bow, tolerance: float) -> bool:
    """Whether two arcs that follow each other are one to rounding, or straight and in one line."""
    straight = abs(last.end - first.start)
    parting = abs(first.curvature - last.curvature) * straight * straight
    if parting > SAME_ARC and abs(first.curvature) * abs(first.end - first.start) > 2.0 * STRAIGHT_TURN:
        return False  # nor is it straight, which takes longer to tell
    turn = abs(first.turn) + abs(last.turn)
    if turn <= STRAIGHT_TURN:
        return turn * straight <= SAME_LINE * tolerance
    return parting <= SAME_ARC and abs(first.turn + last.turn) < WIDEST_JOINED


def _straightened(bows: Iterable[Bow], largest: float) -> Iterator[Bow]:
    """The arcs, but for each one with a larger radius a straight piece between two arcs of a tenth of the largest."""
    for bow in bows:
        if abs(bow.curvature) * largest >= 1.0:
            yield bow
            continue
        turn = bow.turn
        if abs(turn) <= STRAIGHT_TURN:
            yield bow
            continue
        radius = 0.1 * largest
        along = bow.out * rect(1.0, 0.5 * turn)
        step = 2.0 * radius * sin(0.25 * abs(turn))
        leave = bow.start + step * bow.out * rect(1.0, 0.25 * turn)
        enter = bow.end - step * bow.into * rect(1.0, -0.25 * turn)
        curvature = 1.0 / radius if turn > 0.0 else -1.0 / radius
        yield Bow(bow.start, bow.out, curvature, leave, along)
        yield Bow(leave, along, 0.0, enter, along)
        yield Bow(enter, along, curvature, bow.end, bow.into)


def _figure(bow: Bow, frame: Frame) -> Figure:
    """The segment or arc for an arc on its way; where the radius is from the angles that are kept, the ends meet."""
    start, end = phase(bow.out), phase(bow.into)
    turn = (end - start + pi) % (2.0 * pi) - pi
    if abs(turn) <= STRAIGHT_TURN and abs(bow.end - bow.start) * abs(bow.curvature) < 1.0:
        return Figure("segment", {"start": frame.outward(bow.start), "end": frame.outward(bow.end)})
    if turn * bow.curvature < 0.0:
        turn -= 2.0 * pi if turn > 0.0 else -2.0 * pi
    radius = abs(bow.end - bow.start) / (2.0 * sin(0.5 * abs(turn)))
    left = radius * (1j if turn > 0.0 else -1j)
    center = 0.5 * (bow.start + left * bow.out) + 0.5 * (bow.end + left * bow.into)
    begin, close = (start - HALF_PI, end - HALF_PI) if turn > 0.0 else (end + HALF_PI, start + HALF_PI)
    angles = {"start_angle": normalize_angle(begin), "end_angle": normalize_angle(close)}
    return Figure("arc", {"center": frame.outward(center), "radius": frame.length(radius), **angles})
