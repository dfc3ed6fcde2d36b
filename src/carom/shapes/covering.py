"""Which places lie on shapes: the tests behind guard points, on whole tables of rows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from carom.constants import COVER_SAMPLE, COVER_TESTS, GUARD_ROUNDING
from carom.rows.shape import ARC, CIRCLE, POINT, SEGMENT
from carom.rows.tables import Rows

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Tolerances:
    """How near shapes or places are to each other to be in one place.

    That is the smaller `near` of the two and the larger `rounding` of the two, in lengths.
    """

    near: Floats
    rounding: Floats

    def take(self, which: Indices) -> Tolerances:
        """The same for some of them."""
        return Tolerances(self.near[which], self.rounding[which])

    def to(self, other: Tolerances) -> Floats:
        """How near each of these is to each of the others, in a table."""
        near = np.minimum(self.near[:, None], other.near)
        return near + np.maximum(self.rounding[:, None], other.rounding)

    def most(self) -> Tolerances:
        """The largest of them, as one."""
        return Tolerances(self.near.max(keepdims=True), self.rounding.max(keepdims=True))


@dataclass(frozen=True, slots=True)
class _Places:
    """Places, of what moves in which way, with the numbers by which shapes that end there know them."""

    x: Floats
    y: Floats
    tolerances: Tolerances
    motions: Indices
    numbers: Indices


@dataclass(frozen=True, slots=True)
class _Box:
    """A box, by its middle and half its size."""

    x: float
    y: float
    half_width: float
    half_height: float


@dataclass(frozen=True, slots=True)
class _Covers:
    """Shapes of one kind that may cover places; how far from them places are, and how far boxes are at least."""

    rows: Rows
    tolerances: Tolerances
    motions: Indices
    ending: Indices
    distance: Callable[[Rows, Floats, Floats], Floats]
    apart: Callable[[Rows, _Box], Floats]

    def take(self, which: Indices) -> _Covers:
        """Some of them."""
        tolerances, motions, ending = self.tolerances.take(which), self.motions[which], self.ending[which]
        return _Covers(self.rows[which], tolerances, motions, ending, self.distance, self.apart)


def covered_places(
    rows: Rows,
    sizes: Floats,
    tolerances: Tolerances,
    motions: Indices,
    ending: Indices,
    x: Floats,
    y: Floats,
    near: Tolerances,
    owners: Indices,
    numbers: Indices,
) -> NDArray[np.bool_]:
    """For each place, whether it lies on a shape that moves alike and does not end there, or in a solid circle.

    Args:
        rows: The shapes, dtype `SHAPE`.
        sizes: Their lengths.
        tolerances: How near each shape has to be.
        motions: For each shape a number, the same for those that move alike.
        ending: For each shape the numbers of the two places at which it ends, -1 for none.
        x: The x of the places.
        y: Their y.
        near: How near each place has to be.
        owners: For each place a shape that ends there.
        numbers: The places' numbers, as in `ending`.
    """
    places = _Places(x, y, near, motions[owners], numbers)
    covered = np.zeros(len(x), np.bool_)
    # The largest come first, for they cover most.
    order = np.argsort(-sizes, kind="stable")
    for kind, (distance, apart) in _DISTANCES.items():
        which = order[rows["kind"][order] == kind]
        _mark_covered(_Covers(rows, tolerances, motions, ending, distance, apart).take(which), places, covered)
    return covered


def _mark_covered(covers: _Covers, places: _Places, covered: NDArray[np.bool_]) -> None:
    """Mark the places that lie on shapes of one kind.

    Places are halved by their motion, then by their x or y, and with each half go the shapes that come near to its box.
    What many shapes cover is found by a few of them, so that those go no farther together.
    """
    waiting = [(np.flatnonzero(~covered), covers)]
    while waiting:
        spots, some = waiting.pop()
        count = len(some.rows)
        if len(spots) == 0 or count == 0:
            continue
        if len(spots) == 1 or len(spots) * count <= COVER_TESTS:
            covered[spots[_lie_on(some, places, spots)]] = True
            continue
        on = _lie_on(some.take(np.arange(0, count, -(-count // COVER_SAMPLE))), places, spots)
        covered[spots[on]] = True
        spots = spots[~on]
        if len(spots) > 0:
            some = some.take(np.flatnonzero(_are_near(some, places, spots)))
            waiting += [(half, some) for half in _halves(places, spots)]


def _lie_on(covers: _Covers, places: _Places, spots: Indices) -> NDArray[np.bool_]:
    """For each of some places, whether it lies on one of some shapes, by testing each against each."""
    away = covers.distance(covers.rows, places.x[spots], places.y[spots])
    on = away <= covers.tolerances.to(places.tolerances.take(spots))
    on &= covers.motions[:, None] == places.motions[spots]
    here = places.numbers[spots]
    on &= (covers.ending[:, :1] != here) & (covers.ending[:, 1:] != here)
    return np.asarray(on.any(axis=0), np.bool_)


def _are_near(covers: _Covers, places: _Places, spots: Indices) -> NDArray[np.bool_]:
    """For each shape, whether it comes near to the box around some places, and moves as one of them may."""
    x, y, motions, rows = places.x[spots], places.y[spots], places.motions[spots], covers.rows
    # Halves are added, not a sum halved: the sum of two large coordinates may overflow.
    left, bottom, right, top = 0.5 * x.min(), 0.5 * y.min(), 0.5 * x.max(), 0.5 * y.max()
    box = _Box(left + right, bottom + top, right - left, top - bottom)
    size = abs(box.x) + abs(box.y) + box.half_width + box.half_height
    slack = GUARD_ROUNDING * (size + np.abs(rows["cx"]) + np.abs(rows["cy"]) + rows["radius"] + rows["length"])
    within = covers.tolerances.to(places.tolerances.take(spots).most())[:, 0] + slack
    near = covers.apart(rows, box) <= within
    near &= (rows["left"] - box.x <= box.half_width + within) & (box.x - rows["right"] <= box.half_width + within)
    near &= (rows["bottom"] - box.y <= box.half_height + within) & (box.y - rows["top"] <= box.half_height + within)
    near &= (motions.min() <= covers.motions) & (covers.motions <= motions.max())
    return np.asarray(near, np.bool_)


def _halves(places: _Places, spots: Indices) -> tuple[Indices, Indices]:
    """Some places in two halves: by motion where that differs, else by the coordinate that spreads them more."""
    x, y, motions = places.x[spots], places.y[spots], places.motions[spots]
    across = 0.5 * x.max() - 0.5 * x.min() >= 0.5 * y.max() - 0.5 * y.min()
    by = motions if motions.min() < motions.max() else x if across else y
    half = len(spots) // 2
    order = np.argpartition(by, half)
    return spots[order[:half]], spots[order[half:]]


# -- distances, in tables of shapes by places ------------------------------------------------------------------------


def _column(rows: Rows, name: str) -> Floats:
    """A field of the rows, to be set against a line of places."""
    return np.asarray(rows[name], np.float64)[:, None]


def _to_points(rows: Rows, x: Floats, y: Floats) -> Floats:
    """How far places are from points."""
    return np.hypot(x - _column(rows, "cx"), y - _column(rows, "cy"))


def _to_segments(rows: Rows, x: Floats, y: Floats) -> Floats:
    """How far places are from segments, ends included."""
    tx, ty = _column(rows, "tx"), _column(rows, "ty")
    dx, dy = x - _column(rows, "ax"), y - _column(rows, "ay")
    along = np.clip(dx * tx + dy * ty, 0.0, _column(rows, "length"))
    return np.hypot(dx - along * tx, dy - along * ty)


def _to_circles(rows: Rows, x: Floats, y: Floats) -> Floats:
    """How far places are from the perimeters of circles, or from the discs of solid ones."""
    outside = _to_points(rows, x, y) - _column(rows, "radius")
    return np.where(rows["solid"][:, None] != 0, np.maximum(outside, 0.0), np.abs(outside))


def _to_arcs(rows: Rows, x: Floats, y: Floats) -> Floats:
    """How far places are from arcs, ends included."""
    cx, cy, radius = _column(rows, "cx"), _column(rows, "cy"), _column(rows, "radius")
    ends = [(_column(rows, f"{end}x"), _column(rows, f"{end}y")) for end in "ab"]
    (ax, ay), (bx, by) = [((ex - cx) / radius, (ey - cy) / radius) for ex, ey in ends]
    dx, dy = x - cx, y - cy
    after_start, before_end = ax * dy - ay * dx >= 0.0, dx * by - dy * bx >= 0.0
    # Opposite to a very narrow sector both may hold by rounding, but there a place points away from it.
    facing = (ax * bx + ay * by <= 0.0) | (dx * (ax + bx) + dy * (ay + by) >= 0.0)
    wide = ax * by - ay * bx <= 0.0
    within = np.where(wide, after_start | before_end, after_start & before_end & facing)
    to_ends = np.minimum(*[np.hypot(x - ex, y - ey) for ex, ey in ends])
    return np.where(within, np.abs(np.hypot(dx, dy) - radius), to_ends)


# -- and from boxes, at least: what remains when places are halved ---------------------------------------------------


def _points_apart(rows: Rows, _box: _Box) -> Floats:
    """How far a box is from points at least: what their own boxes say is all there is to know."""
    return np.zeros(len(rows))


def _segments_apart(rows: Rows, box: _Box) -> Floats:
    """How far a box is from the lines of segments."""
    tx, ty = rows["tx"], rows["ty"]
    side = np.abs(tx * (box.y - rows["ay"]) - ty * (box.x - rows["ax"]))
    return np.asarray(side - (box.half_width * np.abs(ty) + box.half_height * np.abs(tx)))


def _circles_apart(rows: Rows, box: _Box) -> Floats:
    """How far a box is from whole circles, from the outside or within a hollow one."""
    across, along = np.abs(box.x - rows["cx"]), np.abs(box.y - rows["cy"])
    nearest = np.hypot(np.maximum(across - box.half_width, 0.0), np.maximum(along - box.half_height, 0.0))
    farthest = np.hypot(across + box.half_width, along + box.half_height)
    within = np.where(rows["solid"] != 0, 0.0, rows["radius"] - farthest)
    return np.asarray(np.maximum(nearest - rows["radius"], within))


_DISTANCES: dict[int, tuple[Callable[[Rows, Floats, Floats], Floats], Callable[[Rows, _Box], Floats]]] = {
    POINT: (_to_points, _points_apart),
    SEGMENT: (_to_segments, _segments_apart),
    CIRCLE: (_to_circles, _circles_apart),
    ARC: (_to_arcs, _circles_apart),
}
