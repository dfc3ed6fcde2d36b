"""Guard points: the points that bare ends need, so that balls meet them."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from itertools import combinations
from math import atan2, fabs

import numpy as np
from numpy.typing import NDArray

from carom.checks import non_negative, refuse
from carom.constants import GUARD_ANGLE_TOLERANCE, GUARD_TOLERANCE
from carom.geometry.vector import cross, dot, length
from carom.rows import KINEMATIC
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.compound import Compound
from carom.shapes.gate import Gate
from carom.shapes.point import Point
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape, ShapeOptions
from carom.spelling import spelled
from carom.typing import Vector


@dataclass(frozen=True, slots=True)
class _End:
    """One end of a segment or arc: its place, and the unit tangent that points out of the shape there."""

    place: Vector
    outward: Vector
    shape: Segment | Arc


@spelled
def guard_points(
    shapes: Iterable[Shape | Compound],
    tolerance: float = GUARD_TOLERANCE,
    angle_tolerance: float = GUARD_ANGLE_TOLERANCE,
) -> list[Point]:
    """The points that the bare ends of `shapes` need, as new shapes in no world.

    One at each distinct place where a segment or arc ends (ends within `tolerance`, a length, are in one place), except
    where two of them continue each other smoothly (their outward tangents are opposite within `angle_tolerance`,
    radians: a point there would make a ball stumble) or where the end lies within another shape: on a segment or arc,
    on a circle, in a solid one, or at a point. A cusp gets its point.

    Gates, sensors and shapes whose `can_collide` is off neither need points nor cover an end. Shapes that move
    differently are looked at apart, for they part. A point has the surface and the motion of the first shape that ends
    there, as they are now. Raises `InvalidArgument` for what is no shape or compound, and for a negative tolerance.

    >>> from carom import Segment
    >>> [point.position for point in guard_points([Segment((0, 0), (4, 0)), Segment((4, 0), (9, 0))])]
    [(0.0, 0.0), (9.0, 0.0)]
    """
    gap = non_negative("tolerance", tolerance)
    bend = non_negative("angle_tolerance", angle_tolerance)
    groups: dict[Hashable, list[Shape]] = {}
    for shape in _parts(shapes):
        if shape.can_collide and not shape.sensor and not isinstance(shape, Gate):
            groups.setdefault(_motion_of(shape), []).append(shape)
    return [point for group in groups.values() for point in _guards(group, gap, bend)]


def _parts(shapes: Iterable[Shape | Compound]) -> list[Shape]:
    """All shapes, those of compounds too; raises for anything else."""
    try:
        items = list(shapes)
    except TypeError:
        raise refuse("shapes", "must be a list of shapes", shapes) from None
    parts: list[Shape] = []
    for place, item in enumerate(items):
        if isinstance(item, Compound):
            parts.extend(item.shapes)
        elif isinstance(item, Shape):
            parts.append(item)
        else:
            raise refuse(f"shapes[{place}]", "must be a shape or a compound", item)
    return parts


def _motion_of(shape: Shape) -> Hashable:
    """What shapes have in common that keep their places relative to each other."""
    if shape.motion != KINEMATIC:
        return None
    turn = (shape.pivot, shape.orientation, shape.angular_velocity, shape.rotating, shape.turn_limits)
    return turn, shape.velocity


def _guards(shapes: list[Shape], gap: float, bend: float) -> list[Point]:
    """The points for shapes that move alike, in the order in which their ends are found."""
    boxes = np.array([tuple(shape.aabb) for shape in shapes])
    return [
        Point(ends[0].place, **_options(ends[0].shape))
        for ends in _places(_ends(shapes), gap)
        if not _is_smooth(ends, gap, bend) and not _is_covered(ends, shapes, boxes, gap)
    ]


def _ends(shapes: list[Shape]) -> list[_End]:
    """Both ends of every segment and arc."""
    ends = []
    for shape in shapes:
        if isinstance(shape, Segment):  # its tangents point inwards: each is the outward one of the other end
            ends += [_End(shape.p0, shape.t1, shape), _End(shape.p1, shape.t0, shape)]
        elif isinstance(shape, Arc):
            ends += [_End(shape.p0, shape.t0, shape), _End(shape.p1, shape.t1, shape)]
    return ends


def _places(ends: list[_End], gap: float) -> list[list[_End]]:
    """The ends by place: each is where the first end is that no earlier place was near to."""
    places: list[list[_End]] = []
    sorted_by_x: list[tuple[float, int]] = []
    for end in ends:
        near = _place_near(end.place, places, sorted_by_x, gap)
        if near is None:
            insort(sorted_by_x, (end.place[0], len(places)))
            places.append([end])
        else:
            near.append(end)
    return places


def _place_near(
    point: Vector, places: list[list[_End]], sorted_by_x: list[tuple[float, int]], gap: float
) -> list[_End] | None:
    """The first place by x that is within `gap` of a point, or None."""
    x, y = point
    for i in range(bisect_left(sorted_by_x, (x - gap, -1)), len(sorted_by_x)):
        near_x, k = sorted_by_x[i]
        if near_x > x + gap:
            break
        if length(x - near_x, y - places[k][0].place[1]) <= gap:
            return places[k]
    return None


def _is_smooth(ends: list[_End], gap: float, bend: float) -> bool:
    """Whether two of the ends at one place continue each other."""
    for one, other in combinations(ends, 2):
        # Both ends of a shape that is shorter than the tolerance are in one place, and continue nothing.
        if one.shape is other.shape and one.shape.length <= 2.0 * gap:
            continue
        (ax, ay), (bx, by) = one.outward, other.outward
        if atan2(fabs(cross(ax, ay, bx, by)), -dot(ax, ay, bx, by)) <= bend:
            return True
    return False


def _is_covered(ends: list[_End], shapes: list[Shape], boxes: NDArray[np.float64], gap: float) -> bool:
    """Whether the place of the ends lies within a shape that does not end there."""
    x, y = ends[0].place
    left, bottom, right, top = boxes.T
    near = (left - gap <= x) & (x <= right + gap) & (bottom - gap <= y) & (y <= top + gap)
    ending = [end.shape for end in ends]
    for k in np.flatnonzero(near):
        shape = shapes[k]
        if any(shape is other for other in ending):
            continue
        inside = isinstance(shape, Circle) and shape.solid and shape.contains((x, y))
        if inside or shape.distance((x, y)) <= gap:
            return True
    return False


def _options(shape: Shape) -> ShapeOptions:
    """The options of a point that stands for an end of `shape`: its surface and its motion."""
    options: ShapeOptions = {
        "elasticity": shape.elasticity,
        "kick": shape.kick,
        "layer": shape.layer,
        "collides_with": shape.collides_with,
    }
    if shape.motion == KINEMATIC:
        limits, turned = shape.turn_limits, shape.orientation
        options |= {
            "motion": shape.motion,
            "pivot": shape.pivot,
            "angular_velocity": shape.angular_velocity,
            "rotating": shape.rotating,
            # The point's orientation is 0 where its shape's is `turned`; rounding must not put 0 beyond a stop.
            "turn_limits": limits and (min(limits[0] - turned, 0.0), max(limits[1] - turned, 0.0)),
            "velocity": shape.velocity,
        }
    return options
