"""Guard points: the points that bare ends need, so that balls meet them."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Hashable, Iterable
from math import floor, ldexp

import numpy as np
from numpy.typing import NDArray

from carom.checks import non_negative, refuse
from carom.constants import GUARD_ANGLE_TOLERANCE, GUARD_ROUNDING, GUARD_TOLERANCE, HALF_PI, ROUNDING, TWO_PI
from carom.geometry.vector import length
from carom.rows.shape import ARC, CIRCLE, KINEMATIC, POINT, SEGMENT, SHAPE
from carom.rows.tables import Rows
from carom.shapes.compound import Compound
from carom.shapes.covering import Floats, Indices, Tolerances, covered_places
from carom.shapes.gate import Gate
from carom.shapes.group import Group
from carom.shapes.point import Point
from carom.shapes.shape import Shape, ShapeOptions
from carom.spelling import spelled


@spelled
def guard_points(
    shapes: Iterable[Shape | Compound | Group],
    tolerance: float | None = None,
    angle_tolerance: float | None = None,
) -> list[Point]:
    """The points that the bare ends of `shapes` need, as new shapes in no world.

    One at each distinct place where a segment or arc ends, except where two of them continue each other (their outward
    tangents are opposite) or where the end lies within another shape: on a segment or arc, on a circle, in a solid one,
    or at a point. A cusp gets its point.

    Args:
        shapes: Shapes, and compounds and groups for their parts. Gates, sensors and shapes whose `can_collide` is off
            neither need points nor cover an end. Shapes that move differently are looked at apart, for they part.
        tolerance: A length. Ends this near to each other are in one place, and one this near to a shape lies on it.
            By default 1e-9 of the length of the shorter shape (`GUARD_TOLERANCE`) and the rounding of coordinates, so
            that shapes of any size are told apart. Ends that were rounded apart, as in a file, need more.
        angle_tolerance: Radians by which tangents may fail to be opposite. By default 1e-9 (`GUARD_ANGLE_TOLERANCE`)
            and what the rounding of coordinates turns them by. A point at a joint that is bent less does no harm: only
            balls between both shapes meet it. Without one, a joint that is bent more has a gap as wide as the bend.

    Returns:
        The points, each at the end of the first shape that ends there, with its surface and its motion as they are now.

    Raises:
        InvalidArgument: For what is no shape, compound or group, and for a negative tolerance.

    >>> from carom import Segment
    >>> [point.position for point in guard_points([Segment((0, 0), (4, 0)), Segment((4, 0), (9, 0))])]
    [(0.0, 0.0), (9.0, 0.0)]
    """
    gap = None if tolerance is None else non_negative("tolerance", tolerance)
    bend = None if angle_tolerance is None else non_negative("angle_tolerance", angle_tolerance)
    walls = [
        shape for shape in _parts(shapes) if shape.can_collide and not shape.sensor and not isinstance(shape, Gate)
    ]
    with np.errstate(over="ignore", invalid="ignore"):  # of the largest numbers, which are then as far apart as can be
        return _guards(walls, gap, bend) if walls else []


def _parts(shapes: Iterable[Shape | Compound | Group]) -> list[Shape]:
    """All shapes, those of compounds and groups too; raises for anything else."""
    try:
        items = list(shapes)
    except TypeError:
        raise refuse("shapes", "must be a list of shapes", shapes) from None
    parts: list[Shape] = []
    for place, item in enumerate(items):
        if isinstance(item, Compound | Group):
            parts.extend(item.shapes)
        elif isinstance(item, Shape):
            parts.append(item)
        else:
            raise refuse(f"shapes[{place}]", "must be a shape, a compound or a group", item)
    return parts


def _motion_of(shape: Shape) -> Hashable:
    """What shapes have in common that keep their places relative to each other."""
    if shape.motion != KINEMATIC:
        return None
    turn = (shape.pivot, shape.orientation, shape.angular_velocity, shape.rotating, shape.turn_limits)
    return turn, shape.velocity


def _guards(shapes: list[Shape], gap: float | None, bend: float | None) -> list[Point]:
    """The points for shapes that stop every ball, in the order in which their ends are found."""
    rows: Rows = np.array([shape._row for shape in shapes], SHAPE)
    kinds: dict[Hashable, int] = {}
    motions = np.array([kinds.setdefault(_motion_of(shape), len(kinds)) for shape in shapes])
    sizes, magnitudes = _sizes(rows), _magnitudes(rows)
    tolerances = _tolerances_of(rows, sizes, magnitudes, gap)
    turns = _turn_tolerance(sizes, magnitudes) if bend is None else np.full(len(rows), 0.5 * bend)
    ended = np.flatnonzero((rows["kind"] == SEGMENT) | (rows["kind"] == ARC))
    owners = np.repeat(ended, 2)
    x, y, outward = _ends(rows[ended])
    places, first = _places(x, y, tolerances.take(owners), magnitudes[owners], motions[owners])
    short = sizes <= 2.0 * (tolerances.near + tolerances.rounding)
    rough = np.flatnonzero(~_smooth_places(places, len(first), outward, turns[owners], short[owners]))
    ending = np.full((len(rows), 2), -1)
    ending[ended] = places.reshape(-1, 2)
    spots = first[rough]
    near, there = tolerances.take(owners[spots]), owners[spots]
    covered = covered_places(rows, sizes, tolerances, motions, ending, x[spots], y[spots], near, there, rough)
    bare = np.sort(spots[~covered])
    return [Point((float(x[end]), float(y[end])), **_options(shapes[owners[end]])) for end in bare.tolist()]


# -- tolerances ------------------------------------------------------------------------------------------------------


def _sizes(rows: Rows) -> Floats:
    """The lengths of segments, arcs and circles; infinite for points, which are as near as the other shape says."""
    kind = rows["kind"]
    sweeps = (rows["end_angle"] - rows["start_angle"]) % TWO_PI
    sizes = np.select([kind == ARC, kind == CIRCLE], [rows["radius"] * sweeps, rows["radius"]], rows["length"])
    return np.where(kind == POINT, np.inf, np.minimum(sizes, np.finfo(np.float64).max))


def _magnitudes(rows: Rows) -> Floats:
    """The largest number of each shape's geometry, by whose rounding its ends may be off."""
    numbers = [np.abs(rows[name]) for name in ("left", "bottom", "right", "top", "cx", "cy", "radius")]
    turned = rows["motion"] == KINEMATIC
    numbers += [np.where(turned, np.abs(rows[name]), 0.0) for name in ("pivot_x", "pivot_y")]
    return np.asarray(np.max(numbers, axis=0), np.float64)


def _tolerances_of(rows: Rows, sizes: Floats, magnitudes: Floats, gap: float | None) -> Tolerances:
    """How near each shape has to be to another to be in one place with it."""
    if gap is not None:
        return Tolerances(np.full(len(rows), gap), np.zeros(len(rows)))
    return Tolerances(GUARD_TOLERANCE * sizes, GUARD_ROUNDING * magnitudes)


def _turn_tolerance(sizes: Floats, magnitudes: Floats) -> Floats:
    """By how much the outward tangent of each shape may be off, so that two add up to the tolerance of a joint."""
    return 0.5 * GUARD_ANGLE_TOLERANCE + GUARD_ROUNDING * (magnitudes / sizes)


# -- ends ------------------------------------------------------------------------------------------------------------


def _ends(rows: Rows) -> tuple[Floats, Floats, Floats]:
    """Both ends of every segment and arc: x, y, and the direction out of the shape as an angle from 0 to 2π."""
    bent = rows["kind"] == ARC
    straight = np.arctan2(rows["ty"], rows["tx"])
    outward = np.where(
        bent,
        [rows["start_angle"] - HALF_PI, rows["end_angle"] + HALF_PI],
        [straight + 0.5 * TWO_PI, straight],
    )
    x, y = np.stack([rows["ax"], rows["bx"]], axis=1), np.stack([rows["ay"], rows["by"]], axis=1)
    return x.ravel(), y.ravel(), outward.T.ravel() % TWO_PI


def _places(
    x: Floats,
    y: Floats,
    tolerances: Tolerances,
    magnitudes: Floats,
    motions: Indices,
) -> tuple[Indices, Indices]:
    """For each end the number of the place that it is in, and for each place its first end.

    An end is in the first place that it is near to, else in a new one. Ends come by the size of what is near to them,
    the largest first, so that what an end looks for is never farther than what is near to the places there are. Those
    are filed in cells, a grid for each size, whose cells are 16 times as wide as what is near to their places.
    """
    sizes = np.maximum(np.frexp(tolerances.near + tolerances.rounding)[1], np.frexp(magnitudes)[1] - 1000)
    near, rounding, moves = tolerances.near.tolist(), tolerances.rounding.tolist(), motions.tolist()
    points = list(zip(x.tolist(), y.tolist(), strict=True))
    founders: list[int] = []
    cells: dict[tuple[int, int, int, int], list[int]] = {}
    levels: list[int] = []
    places = np.empty(len(points), np.intp)
    for end in np.argsort(-sizes, kind="stable").tolist():
        px, py = points[end]
        found = len(founders)
        for level in levels:
            for column in _cells_near(px, level):
                for line in _cells_near(py, level):
                    for place in cells.get((moves[end], level, column, line), ()):
                        other = founders[place]
                        far = min(near[end], near[other]) + max(rounding[end], rounding[other])
                        if place < found and length(px - points[other][0], py - points[other][1]) <= far:
                            found = place
        places[end] = found
        if found == len(founders):
            founders.append(end)
            level = int(sizes[end]) + 4
            if level not in levels:
                levels.append(level)
            cell = moves[end], level, floor(ldexp(px, -level)), floor(ldexp(py, -level))
            cells.setdefault(cell, []).append(found)
    first = np.full(len(founders), len(points))
    np.minimum.at(first, places, np.arange(len(points)))
    return places, first


def _cells_near(x: float, level: int) -> Iterable[int]:
    """The columns of cells, 2^level wide, that hold what is within an eighth of a cell of x."""
    across = ldexp(x, -level)
    return range(floor(across - 0.125), floor(across + 0.125) + 1)


def _smooth_places(
    places: Indices,
    count: int,
    outward: Floats,
    turns: Floats,
    short: NDArray[np.bool_],
) -> NDArray[np.bool_]:
    """For each of `count` places, whether two of the ends there continue each other.

    Both ends of a shape that is `short`, no longer than what is near to it, are in one place and continue nothing.
    """
    members: list[list[tuple[float, int]]] = [[] for _ in range(count)]
    for end, (place, angle) in enumerate(zip(places.tolist(), outward.tolist(), strict=True)):
        members[place].append((angle, end))
    slack, brief = turns.tolist(), short.tolist()
    return np.array([_has_smooth_pair(sorted(ends), slack, brief) for ends in members], np.bool_)


def _has_smooth_pair(ends: list[tuple[float, int]], turns: list[float], short: list[bool]) -> bool:
    """Whether two of the ends at one place, sorted by their outward angles, are opposite within their tolerances.

    Of the ends next to the opposite of an end, at most two are no partners of its own: itself and its shape's other
    end. So three on either side are enough to look at, where tolerances are alike; of unlike ones the larger are those
    of shapes shorter than rounding lets tell directions apart.
    """
    count = len(ends)
    for angle, end in ends:
        opposite = (angle + 0.5 * TWO_PI) % TWO_PI
        begin = bisect_left(ends, (opposite, -1))
        for step in range(-3, 3) if count > 6 else range(count):
            other_angle, other = ends[(begin + step) % count]
            if other == end or (other == end ^ 1 and short[end]):
                continue
            off = abs(abs(other_angle - angle) - 0.5 * TWO_PI)
            if off <= turns[end] + turns[other] + 4.0 * ROUNDING:
                return True
    return False


# -- points ----------------------------------------------------------------------------------------------------------


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
