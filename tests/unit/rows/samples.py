"""A shape of each kind, its outline as many points, and what is found by looking at these one by one."""

from collections.abc import Callable
from math import inf, pi
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import carom
from carom.rows.shape import KIND_NAMES
from carom.rows.tables import Row
from carom.shapes import SHAPE_CLASSES

Points = NDArray[np.float64]
MANY = 20_001
#: How far apart two points of an outline may be, and what is found by looking at points and moments one by one.
NEAR = 2e-3
#: One shape of each kind, all about the middle of a room of 4 by 4, with the place of its outline that a ball is thrown
#: at and the unit normal there. A new kind needs its line here, and one in `outline` and `is_inside`.
SAMPLES: dict[str, tuple[carom.Shape, tuple[float, float], tuple[float, float]]] = {
    "point": (carom.Point((0.25, -0.5)), (0.25, -0.5), (0.6, 0.8)),
    "segment": (carom.Segment((-0.5, -0.5), (1.0, 0.625)), (0.25, 0.0625), (-0.6, 0.8)),
    "gate": (carom.Gate((-0.5, -0.5), (1.0, 0.625), direction=(0.6, -0.8)), (0.25, 0.0625), (0.6, -0.8)),
    "circle": (carom.Circle((0.25, -0.5), 0.8, solid=True), (0.73, 0.14), (0.6, 0.8)),
    "arc": (carom.Arc((0.25, -0.5), 0.8, 0.2, 2.0), (0.73, 0.14), (0.6, 0.8)),
}
STRAIGHT, ROUND, ENDED = {"segment", "gate"}, {"point", "circle", "arc"}, {"segment", "gate", "arc"}
RADIUS = 0.125
BOXES = [(x, y, x + 0.3, y + 0.3) for x in np.arange(-1.5, 1.5, 0.37) for y in np.arange(-1.5, 1.5, 0.37)]
PLACES = [(float(x), float(y)) for x in np.arange(-1.5, 1.6, 0.29) for y in np.arange(-1.5, 1.6, 0.29)]
KINDS = pytest.mark.parametrize("kind", [KIND_NAMES[code] for code in SHAPE_CLASSES])


def row_of(kind: str) -> Row:
    """The row of the sample of a kind."""
    return SAMPLES[kind][0]._row


def outline(shape: Any) -> Points:
    """Many points along a shape from end to end, from what its attributes say."""
    share = np.linspace(0.0, 1.0, MANY)[:, None]
    if isinstance(shape, carom.Segment):
        return np.asarray(shape.p0) + share * (np.asarray(shape.p1) - np.asarray(shape.p0))
    if isinstance(shape, carom.Point):
        return np.array([shape.position])
    start, turn = 0.0, 2.0 * pi
    if isinstance(shape, carom.Arc):
        start, turn = shape.start_angle, (shape.end_angle - shape.start_angle) % (2.0 * pi)
    angles = start + share * turn
    return np.asarray(shape.center) + shape.radius * np.hstack([np.cos(angles), np.sin(angles)])


def nearest(kind: str, x: float, y: float) -> tuple[float, Points, bool, bool]:
    """The distance of a sample from a place, its point there, and whether that is a bare end; whether it is inside."""
    shape = SAMPLES[kind][0]
    points = outline(shape)
    ways = np.hypot(*(points - (x, y)).T)
    first = int(ways.argmin())
    bare = kind in ENDED and first in (0, MANY - 1)
    return float(ways[first]), points[first], bare, is_inside(shape, x, y)


def is_inside(shape: Any, x: float, y: float) -> bool:
    """Whether a place is inside of a shape that is solid."""
    return isinstance(shape, carom.Circle) and shape.contains((x, y))


def thrown(kind: str) -> tuple[float, float, float, float]:
    """The place of a ball before the side of a sample that stops it, and its velocity towards that."""
    _, (px, py), (nx, ny) = SAMPLES[kind]
    return px + nx, py + ny, -2.0 * nx, -2.0 * ny


def first_moment(kind: str, moved: Callable[[float], tuple[float, float]]) -> float:
    """The first share of a way, from 0 to 1, at which a ball that is at `moved(share)` touches a sample."""
    points = outline(SAMPLES[kind][0])[::20]
    for share in np.linspace(0.0, 1.0, 2001):
        x, y = moved(float(share))
        if float(np.hypot(*(points - (x, y)).T).min()) <= RADIUS:
            return float(share)
    return inf
