"""The slow twin of guard points: what their definition says of one end, pair by pair, by angles and `math.hypot`."""

from math import atan2, hypot, pi

import carom
from carom.constants import GUARD_ANGLE_TOLERANCE, GUARD_ROUNDING, GUARD_TOLERANCE

Vector = tuple[float, float]
End = tuple[Vector, float, carom.Shape]


def ends_of(shape: carom.Shape) -> list[End]:
    """Each end of a shape with the direction in which it goes on."""
    if isinstance(shape, carom.Segment):
        direction = atan2(shape.p1[1] - shape.p0[1], shape.p1[0] - shape.p0[0])
        return [(shape.p0, direction + pi, shape), (shape.p1, direction, shape)]
    if isinstance(shape, carom.Arc):
        return [(shape.p0, shape.start_angle - pi / 2, shape), (shape.p1, shape.end_angle + pi / 2, shape)]
    return []


def size_of(shape: carom.Shape) -> float:
    """The length that tolerances are a share of."""
    if isinstance(shape, carom.Circle):
        return shape.radius
    return shape.length if isinstance(shape, carom.Segment | carom.Arc) else float("inf")


def magnitude_of(shape: carom.Shape) -> float:
    """The largest number of a shape's geometry."""
    numbers = [*shape.aabb, *shape.position]
    return max(abs(number) for number in [*numbers, getattr(shape, "radius", 0.0)])


def reach(one: carom.Shape, other: carom.Shape) -> float:
    """How near two shapes are in one place."""
    near = GUARD_TOLERANCE * min(size_of(one), size_of(other))
    return near + GUARD_ROUNDING * max(magnitude_of(one), magnitude_of(other))


def is_near(one: End, other: End) -> bool:
    """Whether two ends are one place."""
    return hypot(one[0][0] - other[0][0], one[0][1] - other[0][1]) <= reach(one[2], other[2])


def turn_slack(shape: carom.Shape) -> float:
    """By how much rounding may turn a shape."""
    return GUARD_ROUNDING * (magnitude_of(shape) / size_of(shape))


def needs_guard(end: End, shapes: list[carom.Shape]) -> bool:
    """Whether an end of one of the shapes, which all stand still, is to be guarded."""
    neighbours = [other for shape in shapes for other in ends_of(shape) if is_near(end, other)]
    for k, (_, first, one) in enumerate(neighbours):
        for _, second, other in neighbours[:k]:
            bend = abs((first - second) % (2 * pi) - pi)
            if one is not other and bend <= GUARD_ANGLE_TOLERANCE + turn_slack(one) + turn_slack(other):
                return False
    for shape in shapes:
        if any(shape is other[2] for other in neighbours):
            continue
        if shape.distance(end[0]) <= reach(end[2], shape):
            return False
        if isinstance(shape, carom.Circle) and shape.solid and shape.contains(end[0]):
            return False
    return True
