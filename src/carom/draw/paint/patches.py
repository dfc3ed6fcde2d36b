"""Antialiased marks as small transparent surfaces: how much of each pixel a line or an area covers.

A mark is known by its distance function: for each pixel's centre, how far outside of the mark it is, in pixels. Large
marks are cut into tiles, and tiles that the mark does not touch are left out.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import ceil, floor, hypot, pi
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.extras import needed

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from carom.draw.paint.painter import Vector

    Floats: TypeAlias = NDArray[np.float64]
    #: The distance from a mark, for arrays of x and of y.
    Distance: TypeAlias = Callable[[Floats, Floats], Floats]
    Colour: TypeAlias = tuple[int, int, int]
    #: A surface of pygame's, and the pixel at which its upper left corner stands.
    Patch: TypeAlias = tuple[Any, int, int]

#: Pixels: the side of a tile.
TILE = 64
#: How many pixels finer than the picture the areas of polygons are drawn.
FINER = 4


@dataclass(frozen=True, slots=True)
class Extent:
    """A box in pixels, y down."""

    left: float
    top: float
    right: float
    bottom: float

    @classmethod
    def of(cls, points: Sequence[Vector], margin: float) -> Extent:
        """The box around points, and a margin around it."""
        xs, ys = [x for x, _ in points], [y for _, y in points]
        return cls(min(xs) - margin, min(ys) - margin, max(xs) + margin, max(ys) + margin)

    def cut(self, width: int, height: int) -> tuple[int, int, int, int]:
        """The whole pixels of the box that a picture of some size shows: left, top, right, bottom."""
        left, top = max(0, floor(self.left)), max(0, floor(self.top))
        return left, top, min(width, ceil(self.right)), min(height, ceil(self.bottom))


def from_segment(start: Vector, end: Vector) -> Distance:
    """The distance from a straight line."""
    (ax, ay), (bx, by) = start, end
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy or 1.0

    def distance(x: Floats, y: Floats) -> Floats:
        along = np.clip(((x - ax) * dx + (y - ay) * dy) / squared, 0.0, 1.0)
        return np.hypot(x - ax - along * dx, y - ay - along * dy)

    return distance


def from_circle(center: Vector, radius: float) -> Distance:
    """The distance from a circle's edge, inside below 0."""

    def distance(x: Floats, y: Floats) -> Floats:
        return np.hypot(x - center[0], y - center[1]) - radius

    return distance


def from_arc(center: Vector, radius: float, start_angle: float, end_angle: float) -> Distance:
    """The distance from an arc, counterclockwise with y up while pixels have y down."""
    sweep = (end_angle - start_angle) % (2.0 * pi)
    ends = [
        (center[0] + radius * np.cos(angle), center[1] - radius * np.sin(angle)) for angle in (start_angle, end_angle)
    ]

    def distance(x: Floats, y: Floats) -> Floats:
        dx, dy = x - center[0], y - center[1]
        beside = np.abs(np.hypot(dx, dy) - radius)
        inside = (np.arctan2(-dy, dx) - start_angle) % (2.0 * pi) <= sweep
        beyond = np.minimum(*(np.hypot(x - end_x, y - end_y) for end_x, end_y in ends))
        return np.where(inside, beside, beyond)

    return distance


def nearest_of(distances: Sequence[Distance]) -> Distance:
    """The distance from the nearest of some marks."""

    def distance(x: Floats, y: Floats) -> Floats:
        nearest = distances[0](x, y)
        for other in distances[1:]:
            nearest = np.minimum(nearest, other(x, y))
        return nearest

    return distance


def line_patches(
    distance: Distance, extent: Extent, width: float, colour: Colour, size: tuple[int, int]
) -> list[Patch]:
    """The patches of a line of some width around where `distance` is 0."""
    half, most = 0.5 * width, min(1.0, width)
    return patches(lambda x, y: np.abs(distance(x, y)) - half, extent, colour, size, most)


def patches(
    distance: Distance, extent: Extent, colour: Colour, size: tuple[int, int], most: float = 1.0
) -> list[Patch]:
    """The patches of what lies where `distance` is below 0, in a picture of some size; `most` is its opacity."""
    left, top, right, bottom = extent.cut(*size)
    found: list[Patch] = []
    for x in range(left, right, TILE):
        for y in range(top, bottom, TILE):
            width, height = min(TILE, right - x), min(TILE, bottom - y)
            middle = np.array([x + 0.5 * width]), np.array([y + 0.5 * height])
            if float(distance(*middle)[0]) < 0.5 * hypot(width, height) + 1.0:
                centers = np.arange(x + 0.5, x + width)[:, None], np.arange(y + 0.5, y + height)[None, :]
                cover = np.clip(0.5 - distance(*centers), 0.0, most)
                if cover.any():
                    found.append((surface(colour, cover), x, y))
    return found


def surface(colour: Colour, cover: Floats) -> Any:
    """A surface of one colour, its opacity for each pixel (x, y) between 0 and 1."""
    pygame = needed("pygame", "pygame-ce", "draw", "raster pictures")
    made = pygame.Surface(cover.shape, pygame.SRCALPHA)
    made.fill((*colour, 0))
    pygame.surfarray.pixels_alpha(made)[:] = np.rint(255.0 * cover)
    return made


def polyline_patches(points: Sequence[Vector], width: float, colour: Colour, size: tuple[int, int]) -> list[Patch]:
    """The patch of a line through `points`, its ends cut off square: the parts of a translucent line meet there."""
    left, top, right, bottom = Extent.of(points, width).cut(*size)
    if left >= right or top >= bottom:
        return []
    cover = np.zeros((right - left, bottom - top))
    last = len(points) - 2
    for number, (start, end) in enumerate(pairwise(points)):
        x, y, to_x, to_y = Extent.of((start, end), width).cut(*size)
        if x < to_x and y < to_y:
            across, down = np.arange(x + 0.5, to_x)[:, None], np.arange(y + 0.5, to_y)[None, :]
            piece = np.clip(0.5 * width + 0.5 - from_segment(start, end)(across, down), 0.0, min(1.0, width))
            length = hypot(end[0] - start[0], end[1] - start[1]) or 1.0
            along = ((across - start[0]) * (end[0] - start[0]) + (down - start[1]) * (end[1] - start[1])) / length
            if number == 0:
                piece *= np.clip(along + 0.5, 0.0, 1.0)
            if number == last:
                piece *= np.clip(length - along + 0.5, 0.0, 1.0)
            part = cover[x - left : to_x - left, y - top : to_y - top]
            np.maximum(part, piece, out=part)
    return [(surface(colour, cover), left, top)] if cover.any() else []


def polygon_patches(points: Sequence[Vector], colour: Colour, size: tuple[int, int]) -> list[Patch]:
    """The patch of the area that a line through `points` bounds."""
    pygame = needed("pygame", "pygame-ce", "draw", "raster pictures")
    left, top, right, bottom = Extent.of(points, 1.0).cut(*size)
    if left >= right or top >= bottom:
        return []
    fine = pygame.Surface((FINER * (right - left), FINER * (bottom - top)), pygame.SRCALPHA)
    fine.fill((*colour, 0))
    pygame.draw.polygon(fine, (*colour, 255), [(FINER * (x - left), FINER * (y - top)) for x, y in points])
    return [(pygame.transform.smoothscale(fine, (right - left, bottom - top)), left, top)]
