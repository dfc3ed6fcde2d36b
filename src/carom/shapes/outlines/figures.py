"""Polygons and what is rounded: outlines that segments and arcs give exactly."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterable
from itertools import pairwise
from math import cos, sin
from typing import Unpack

from carom.checks import flag, non_negative, number, pair, positive, refuse, whole
from carom.constants import HALF_PI, TWO_PI
from carom.geometry.vector import unit
from carom.shapes.arc import Arc
from carom.shapes.outlines.places import places_of
from carom.shapes.outlines.walls import builder, guarded
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape, ShapeOptions
from carom.typing import Pair, Vector

#: Corners of a regular polygon at most.
MOST_CORNERS = 100_000


@builder
def polyline(
    points: Iterable[Pair], closed: bool = False, guard: bool = True, **options: Unpack[ShapeOptions]
) -> list[Shape]:
    """A segment from each point to the next, from the last to the first too if it is `closed`; and then their points.

    Raises `InvalidArgument` for fewer than 2 points, 3 if it is closed, and for two in a row in one place.

    >>> import carom
    >>> [shape.kind for shape in carom.outlines.polyline([(0, 0), (4, 0), (4, 3)])]
    ['segment', 'segment', 'point', 'point', 'point']
    """
    places = places_of("points", points)
    least = 3 if flag("closed", closed) else 2
    if len(places) < least:
        raise refuse("points", f"must be {least} or more", places)
    if closed:
        places.append(places[0])
    for index, (before, after) in enumerate(pairwise(places), 1):
        if before == after:
            raise refuse(f"points[{index % (len(places) - closed)}]", "must differ from the one before it", after)
    return guarded([Segment(before, after, **options) for before, after in pairwise(places)], guard)


@builder
def polygon(points: Iterable[Pair], guard: bool = True, **options: Unpack[ShapeOptions]) -> list[Shape]:
    """The sides of a polygon by its corners, in either order, and then its points: a closed `polyline`.

    >>> import carom
    >>> len(carom.outlines.polygon([(0, 0), (4, 0), (4, 3)]))
    6
    """
    return polyline(points, closed=True, guard=guard, **options)


@builder
def rectangle(
    left: float,
    bottom: float,
    right: float,
    top: float,
    corner: float = 0.0,
    guard: bool = True,
    **options: Unpack[ShapeOptions],
) -> list[Shape]:
    """The sides of an upright rectangle, and then its points; arcs of radius `corner` round its corners need none.

    Sides and arcs come counterclockwise, the bottom first. A side that two arcs use up is left out. Raises
    `InvalidArgument` for a left not below the right, a bottom not below the top, and a corner larger than half a side.

    >>> import carom
    >>> [shape.kind for shape in carom.outlines.rectangle(0, 0, 4, 2, corner=1)]
    ['segment', 'arc', 'arc', 'segment', 'arc', 'arc']
    """
    x0, y0, x1, y1 = number("left", left), number("bottom", bottom), number("right", right), number("top", top)
    radius = non_negative("corner", corner)
    if x0 >= x1:
        raise refuse("right", f"must be above left={x0!r}", right)
    if y0 >= y1:
        raise refuse("top", f"must be above bottom={y0!r}", top)
    if 2.0 * radius > min(x1 - x0, y1 - y0):
        raise refuse("corner", "must be half of the shorter side at most", corner)
    if radius == 0.0:
        return polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], guard=guard, **options)
    low_x, low_y, high_x, high_y = x0 + radius, y0 + radius, x1 - radius, y1 - radius
    centers = [(high_x, low_y), (high_x, high_y), (low_x, high_y), (low_x, low_y)]
    sides = [
        ((low_x, y0), (high_x, y0)),
        ((x1, low_y), (x1, high_y)),
        ((high_x, y1), (low_x, y1)),
        ((x0, high_y), (x0, low_y)),
    ]
    used_up = (x1 - x0 <= 2.0 * radius, y1 - y0 <= 2.0 * radius)
    shapes: list[Shape] = []
    for index, (center, side) in enumerate(zip(centers, sides, strict=True)):
        if not used_up[index % 2] and side[0] != side[1]:
            shapes.append(Segment(*side, **options))
        shapes.append(Arc(center, radius, (index - 1) * HALF_PI, index * HALF_PI, **options))
    return guarded(shapes, guard)


@builder
def regular_polygon(
    center: Pair, radius: float, n: int, angle: float = 0.0, guard: bool = True, **options: Unpack[ShapeOptions]
) -> list[Shape]:
    """The sides of a regular polygon of `n` corners, and then its points.

    Its corners are `radius` from the center, counterclockwise, the first of them at `angle`, in radians. Raises
    `InvalidArgument` for a radius that is not positive, and fewer than 3 corners.

    >>> import carom
    >>> len(carom.outlines.regular_polygon((0, 0), 1.0, 6, guard=False))
    6
    """
    (x, y), size, first = pair("center", center), positive("radius", radius), number("angle", angle)
    count = whole("n", n, 3, MOST_CORNERS)
    angles = [first + TWO_PI * index / count for index in range(count)]
    return polygon([(x + size * cos(turn), y + size * sin(turn)) for turn in angles], guard=guard, **options)


@builder
def capsule(a: Pair, b: Pair, radius: float, guard: bool = True, **options: Unpack[ShapeOptions]) -> list[Shape]:
    """All that is `radius` from the segment from `a` to `b`: two segments and two half circles; it needs no points.

    The first segment lies to the right of the way from a to b, and they come counterclockwise. Raises
    `InvalidArgument` where a and b are one place, and for a radius that is not positive.

    >>> import carom
    >>> [shape.kind for shape in carom.outlines.capsule((0, 0), (3, 4), 1.0)]
    ['segment', 'arc', 'segment', 'arc']
    """
    first, last, size = pair("a", a), pair("b", b), positive("radius", radius)
    along = unit(0.5 * last[0] - 0.5 * first[0], 0.5 * last[1] - 0.5 * first[1])
    if along is None:
        raise refuse("b", "must differ from a", b)
    angle = phase(complex(*along))
    right, left = angle - HALF_PI, angle + HALF_PI
    return guarded(
        [
            Segment(_polar(first, size, right), _polar(last, size, right), **options),
            Arc(last, size, right, left, **options),
            Segment(_polar(last, size, left), _polar(first, size, left), **options),
            Arc(first, size, left, right, **options),
        ],
        guard,
    )


@builder
def stadium(
    center: Pair, length: float, radius: float, guard: bool = True, **options: Unpack[ShapeOptions]
) -> list[Shape]:
    """Two sides of `length`, along the x axis, and two half circles of `radius`, a lying `capsule` about its center.

    >>> import carom
    >>> carom.outlines.stadium((0, 0), 2.0, 1.0)[1]
    Arc((1.0, 0.0), 1.0, 4.71238898038469, 1.5707963267948966)
    """
    (x, y), half = pair("center", center), 0.5 * positive("length", length)
    return capsule((x - half, y), (x + half, y), radius, guard=guard, **options)


def _polar(center: Vector, radius: float, angle: float) -> Vector:
    """The place at `angle` on a circle; the formula by which an arc places its ends."""
    turned = angle % TWO_PI
    return center[0] + radius * cos(turned), center[1] + radius * sin(turned)
