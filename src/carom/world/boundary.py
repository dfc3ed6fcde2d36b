"""Hits as places along the outline of a table, and the directions in which balls came there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.checks import refuse
from carom.constants import JOINT_GAP, TWO_PI
from carom.rows.hit import EXIT
from carom.rows.kinds import has_ends, has_side, is_straight
from carom.rows.tables import Rows
from carom.shapes.shape import Shape

if TYPE_CHECKING:
    from carom.shapes.arc import Arc
    from carom.shapes.circle import Circle
    from carom.shapes.segment import Segment
    from carom.typing import Vector
    from carom.world.hits import Hits
    from carom.world.world import World

#: What an outline is made of.
Wall: TypeAlias = "Segment | Arc | Circle"
#: The same, told where something else was given.
PIECES = "must be a Segment, an Arc or a Circle of the world of the hits"


class Boundary(NamedTuple):
    """Hits on an outline in the coordinates of Birkhoff, one number of each array for each of `hits`.

    `hits` are those of the hits that are on the outline, without those of kind `EXIT`. `arc_length` is how far along
    the outline each is, from the first end of the first shape. `sine` is the sine of the angle of incidence, in
    [-1, 1]: the part of the ball's velocity along the outline; positive where it goes on in the outline's direction, 0
    for a ball at rest.
    """

    hits: Hits
    arc_length: NDArray[np.float64]
    sine: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Piece:
    """A shape of an outline, and whether the outline goes along it from its first end to the second."""

    shape: Wall
    forward: bool

    @property
    def begin(self) -> Vector:
        """Where the outline comes to it."""
        return ends_of(self.shape)[0 if self.forward else 1]

    @property
    def end(self) -> Vector:
        """Where the outline leaves it."""
        return ends_of(self.shape)[1 if self.forward else 0]


class Track:
    """Pieces of outlines, one after the other, where hits on them are: as they are when this is made.

    Of each: how long it is and where along all of them it begins, a place and a direction by which hits on it are
    measured. For a segment these are its first end and its tangent; for an arc or a circle the centre, and its radius
    and the angle of its first end.
    """

    def __init__(self, pieces: Sequence[Piece]) -> None:
        """Look at the pieces."""
        shapes = [piece.shape for piece in pieces]
        self._ids = np.array([shape.id for shape in shapes])
        self._lengths = np.array([shape.length for shape in shapes])
        self._straight = np.array([is_straight(shape._row["kind"]) for shape in shapes])
        self._measures = np.array([measures_of(shape) for shape in shapes]).T
        forward = np.array([piece.forward for piece in pieces])
        # A piece that is gone along backwards begins at its far end.
        self._begins = np.cumsum([0.0, *self._lengths[:-1]]) + np.where(forward, 0.0, self._lengths)
        self._ways = np.where(forward, 1.0, -1.0)

    def places_of(self, shapes: NDArray[np.int64]) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """Which piece each of some shapes is, by their ids, and whether it is one at all."""
        by_id = np.argsort(self._ids)
        places = by_id[np.minimum(np.searchsorted(self._ids[by_id], shapes), len(self._ids) - 1)]
        return places, self._ids[places] == shapes

    def coordinates(self, rows: Rows, places: NDArray[np.intp]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """How far along all pieces each hit is that is on the piece so given, and its sine."""
        along, tangent_x, tangent_y = self._along(rows["point"], places)
        ways = self._ways[places]
        along = self._begins[places] + ways * along
        return along, ways * _parts_along(rows["velocity"], tangent_x, tangent_y)

    def _along(
        self, points: NDArray[np.float64], places: NDArray[np.intp]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """How far each point is along its piece from that one's first end, and the piece's unit tangent, x and y."""
        lengths = self._lengths[places]
        x, y, tangent_x, tangent_y = self._measures[:, places]
        dx, dy = points[:, 0] - x, points[:, 1] - y
        along = dx * tangent_x + dy * tangent_y
        bent = np.flatnonzero(~self._straight[places])
        if len(bent):
            dx, dy, radius, first = dx[bent], dy[bent], tangent_x[bent], tangent_y[bent]
            turned = np.mod(np.arctan2(dy, dx) - first, TWO_PI)
            # What rounding has put before the first end comes out as almost a whole turn.
            before = TWO_PI - turned < turned - lengths[bent] / radius
            along[bent] = radius * np.where(before, 0.0, turned)
            away = np.sqrt(dx * dx + dy * dy)
            tangent_x[bent], tangent_y[bent] = -dy / away, dx / away
        return np.clip(along, 0.0, lengths), tangent_x, tangent_y


def boundary_of(hits: Hits, outline: Any) -> Boundary:
    """What `Hits.boundary` returns."""
    track = Track(_pieces_of(hits._world, outline))
    places, on = track.places_of(hits["shape"])
    on &= hits["kind"] != EXIT
    found = hits if on.all() else hits[on]
    return Boundary(found, *track.coordinates(found.view(np.ndarray), places if on.all() else places[on]))


def measures_of(shape: Wall) -> tuple[float, float, float, float]:
    """What places on a shape are measured by: see `Track`."""
    row = shape._row
    if is_straight(row["kind"]):
        return float(row["ax"]), float(row["ay"]), float(row["tx"]), float(row["ty"])
    first = float(row["start_angle"]) if has_ends(row["kind"]) else 0.0
    return float(row["cx"]), float(row["cy"]), float(row["radius"]), first


def ends_of(shape: Wall) -> tuple[Vector, Vector]:
    """The ends of a shape; of a circle, which has none, twice the place at angle 0."""
    row = shape._row
    if not has_ends(row["kind"]):
        x, y = float(row["cx"]), float(row["cy"])
        return (x + float(row["radius"]), y), (x + float(row["radius"]), y)
    return (float(row["ax"]), float(row["ay"])), (float(row["bx"]), float(row["by"]))


def _parts_along(
    velocities: NDArray[np.float64], tangent_x: NDArray[np.float64], tangent_y: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The part of each velocity that is along its tangent, in [-1, 1]; 0 of none."""
    x, y = np.ascontiguousarray(velocities[:, 0]), np.ascontiguousarray(velocities[:, 1])
    speed = np.sqrt(x * x + y * y)
    parts = np.divide(x * tangent_x + y * tangent_y, speed, out=np.zeros(len(x)), where=speed > 0.0)
    return np.asarray(np.clip(parts, -1.0, 1.0))


def _pieces_of(world: World, outline: Any) -> list[Piece]:
    """The pieces of an outline, each the way that it is gone along; raises for shapes that do not join."""
    if isinstance(outline, (str, bytes)) or not isinstance(outline, Sequence) or len(outline) == 0:
        raise refuse("outline", "must be a list of shapes that join, in order", outline)
    for place, shape in enumerate(outline):
        if not isinstance(shape, Shape) or not has_side(shape._row["kind"]) or shape.world is not world:
            raise refuse(f"outline[{place}]", PIECES, shape)
        if shape in outline[:place]:
            raise refuse(f"outline[{place}]", "must not be in it twice", shape)
        if not has_ends(shape._row["kind"]) and len(outline) > 1:
            raise refuse(f"outline[{place}]", "must be the only one, for a circle joins no other shape", shape)
    gap = JOINT_GAP * sum(shape.length for shape in outline)
    pieces = [Piece(outline[0], _goes_forward(outline, gap))]
    for place, shape in enumerate(outline[1:], 1):
        here = pieces[-1].end
        forward = _is_near(here, ends_of(shape)[0], gap)
        if not forward and not _is_near(here, ends_of(shape)[1], gap):
            raise refuse(f"outline[{place}]", f"must begin or end where outline[{place - 1}] ends, at {here}", shape)
        pieces.append(Piece(shape, forward))
    return pieces


def _goes_forward(outline: Sequence[Wall], gap: float) -> bool:
    """Whether an outline goes along its first shape from that one's first end on; so it does where both would do."""
    if len(outline) == 1:
        return True
    first, second = ends_of(outline[0])
    ends = ends_of(outline[1])
    return any(_is_near(second, end, gap) for end in ends) or not any(_is_near(first, end, gap) for end in ends)


def _is_near(a: Vector, b: Vector, gap: float) -> bool:
    """Whether two places are no farther than a gap from each other."""
    return hypot(a[0] - b[0], a[1] - b[1]) <= gap
