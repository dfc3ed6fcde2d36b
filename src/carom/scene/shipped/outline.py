"""Outlines whose joints are tangent by construction: bands round discs, paths with rounded corners, mirror images."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import acos, atan2, cos, hypot, pi, sin, tan
from typing import Any, TypeAlias

from carom.scene.shape_descriptors import ArcDescriptor, CompoundDescriptor, Part, SegmentDescriptor
from carom.typing import Vector

#: A centre and a radius.
Disc: TypeAlias = tuple[Vector, float]


def polar(center: Vector, radius: float, angle: float) -> Vector:
    """The point at `angle` on the circle round `center`; the formula by which an arc places its ends."""
    return center[0] + radius * cos(angle), center[1] + radius * sin(angle)


def walls(points: Sequence[Vector], **looks: Any) -> list[Part]:
    """A segment between each point and the next."""
    return [SegmentDescriptor(start=start, end=end, **looks) for start, end in pairwise(points)]


def band(discs: Sequence[Disc], **looks: Any) -> list[Part]:
    """A tight band round discs that are corners of a convex shape, counterclockwise: segment, arc, segment and so on.

    The first segment leads from the first disc to the second, the first arc goes round the second. Two discs give a
    capsule, or a flipper. Source: outer common tangents, as `Circle.common_tangents`.
    """
    following = [*discs[1:], discs[0]]
    normals = [_outer_normal(disc, after) for disc, after in zip(discs, following, strict=True)]
    parts: list[Part] = []
    for disc, after, normal, turned in zip(discs, following, normals, [*normals[1:], normals[0]], strict=True):
        start, end = polar(*disc, normal), polar(*after, normal)
        parts.append(SegmentDescriptor(start=start, end=end, **looks))
        center, radius = after
        parts.append(ArcDescriptor(center=center, radius=radius, start_angle=normal, end_angle=turned, **looks))
    return parts


def _outer_normal(disc: Disc, after: Disc) -> float:
    """The direction from both centres to where the common tangent on the right hand touches."""
    (x, y), radius = disc
    (after_x, after_y), after_radius = after
    along_x, along_y = after_x - x, after_y - y
    return atan2(along_y, along_x) - acos((radius - after_radius) / hypot(along_x, along_y))


def rounded(corners: Sequence[Disc], closed: bool = False, **looks: Any) -> list[Part]:
    """A path through corners, each cut short by an arc of its radius that touches both sides: segment, arc, and so on.

    The radii of the first and the last corner of an open path are not used. A closed path begins after the first corner
    and ends with that corner's arc.
    """
    if closed:
        corners = [*corners, *corners[:2]]
    parts: list[Part] = []
    begin = corners[0][0]
    for (before, _), (corner, radius), (after, _) in zip(corners, corners[1:], corners[2:], strict=False):
        leave, enter, arc = _fillet(before, corner, after, radius)
        parts.append(SegmentDescriptor(start=begin, end=leave, **looks))
        parts.append(ArcDescriptor(**arc, **looks))
        begin = enter
    if not closed:
        return [*parts, SegmentDescriptor(start=begin, end=corners[-1][0], **looks)]
    # The first segment began in the corner that has been rounded last.
    return [parts[0].model_copy(update={"start": begin}), *parts[1:]]


def _fillet(before: Vector, corner: Vector, after: Vector, radius: float) -> tuple[Vector, Vector, dict[str, Any]]:
    """Where the path leaves the first side and enters the second, and the arc between them.

    The centre lies radius / sin(half the angle between the sides) from the corner, on their bisector.
    """
    arriving = atan2(corner[1] - before[1], corner[0] - before[0])
    leaving = atan2(after[1] - corner[1], after[0] - corner[0])
    turn = (leaving - arriving + pi) % (2.0 * pi) - pi
    side = pi / 2.0 if turn > 0.0 else -pi / 2.0
    back = radius * tan(abs(turn) / 2.0)
    touch = polar(corner, -back, arriving)
    center = polar(touch, radius, arriving + side)
    angles = (arriving - side, leaving - side) if turn > 0.0 else (leaving - side, arriving - side)
    arc = {"center": center, "radius": radius, "start_angle": angles[0], "end_angle": angles[1]}
    return polar(center, radius, arriving - side), polar(center, radius, leaving - side), arc


def mirrored(parts: Iterable[Any], axis: float) -> list[Any]:
    """The mirror images of parts at rest in the vertical line x = `axis`; what was called left is called right."""
    return [_mirrored(part, axis) for part in parts]


def _mirrored(part: Any, axis: float) -> Any:
    """The mirror image of one part."""
    changes: dict[str, Any] = {}
    for field in ("position", "center", "start", "end", "pivot"):
        place = getattr(part, field, None)
        if place is not None:
            changes[field] = (2.0 * axis - place[0], place[1])
    if isinstance(part, ArcDescriptor):
        changes |= {"start_angle": pi - part.end_angle, "end_angle": pi - part.start_angle}
    if isinstance(part, CompoundDescriptor):
        changes["shapes"] = tuple(mirrored(part.shapes, axis))
        if part.turn_limits is not None:
            low, high = part.turn_limits
            changes["turn_limits"] = (-high, -low)
    if part.name is not None:
        changes["name"] = part.name.replace("left", "right")
    return part.model_copy(update=changes)
