"""What queries of a world answer: an object or None for one query, an array of rows for many.

Every array is a structured NumPy array whose columns are the fields of the object, with ids in the place of shapes and
balls. `answers[i]` and iteration give the objects, None where query `i` found nothing; `answers.found` says which did.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from carom.errors import LostObject
from carom.rows import query
from carom.shapes.detection import Contact
from carom.typing import Vector
from carom.world.plural import Plural, vector

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape
    from carom.world.world import World

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class CastHit:
    """What a ray or a moving circle touches first.

    Attributes:
        shape: The shape or ball that it touches.
        fraction: How much of the way to the target is gone then, 0 to 1.
        point: Where it touches, on the shape.
        normal: Unit vector there, from the shape towards where the ray or circle came from.
    """

    shape: Shape | Ball
    fraction: float
    point: Vector
    normal: Vector


@dataclass(frozen=True, slots=True)
class Neighbor:
    """What is nearest to a place.

    Attributes:
        shape: The shape or ball that is nearest.
        distance: How far away; below 0 inside a ball or a solid circle, where it is the way out.
        point: The shape's nearest point.
    """

    shape: Shape | Ball
    distance: float
    point: Vector


@dataclass(frozen=True, slots=True)
class Aim:
    """A ball's path up to its next impact, and what follows from that.

    Attributes:
        ball: The ball.
        shape: The shape or ball that it meets.
        time: The world's time of the impact.
        start: Where the ball's centre is.
        ghost: Where its centre is at the impact.
        distance: How far that is, as the crow flies.
        point: Where they touch.
        normal: Unit vector there, from the shape to the ball.
        direction: Unit vector in which the ball goes on; None if it stands still.
        speed: How fast it goes on, if it came as fast as the direction that was asked about is long.
        other_direction: Unit vector in which the other ball goes; None if that is no ball, or stands still.
        other_speed: How fast the other ball goes.
    """

    ball: Ball
    shape: Shape | Ball
    time: float
    start: Vector
    ghost: Vector
    distance: float
    point: Vector
    normal: Vector
    direction: Vector | None
    speed: float
    other_direction: Vector | None
    other_speed: float


class Answers(Plural[T]):
    """The answers to many queries, in their order: a structured array whose items are objects, or None.

    It is false where there are no rows; `found` says which queries found something. Objects are looked up when an item
    is asked for; it is a `LostObject` where one has left the world for good.
    """

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {np.count_nonzero(self.found)} of {len(self)} found something>"

    __str__ = __repr__

    @property
    def found(self) -> NDArray[np.bool_]:
        """Which queries found something."""
        return np.asarray(self.view(np.ndarray)["shape"] != 0)


class CastHits(Answers[CastHit | None]):
    """What many rays or circles touch first.

    Where one touches nothing, `shape` is 0, `fraction` 1, `point` the target and `normal` 0.
    """

    DTYPE = query.CAST_HIT

    def _object(self, world: World, row: query.CastRow) -> CastHit | None:
        if row["shape"] == 0:
            return None
        shape = _member(world, row["shape"])
        return CastHit(shape, float(row["fraction"]), vector(row["point"]), vector(row["normal"]))


class Neighbors(Answers[Neighbor | None]):
    """What is nearest to many places; `shape` 0 and `distance` infinite in a world where nothing can be seen."""

    DTYPE = query.NEIGHBOR

    def _object(self, world: World, row: query.NeighborRow) -> Neighbor | None:
        if row["shape"] == 0:
            return None
        return Neighbor(_member(world, row["shape"]), float(row["distance"]), vector(row["point"]))


class Contacts(Answers[Contact]):
    """Overlaps of balls with shapes and other balls, in the order of the balls' ids, then of the shapes'."""

    DTYPE = query.CONTACT

    def _object(self, world: World, row: query.ContactRow) -> Contact:
        shape, ball = _member(world, row["shape"]), _member(world, row["ball"])
        point, normal = vector(row["point"]), vector(row["normal"])
        return Contact(shape, ball, point, normal, float(row["setback"]), float(row["speed"]))


class InBoxes(Plural[Any]):
    """Which shapes and balls are in which boxes: a row for every box and shape that meet, as it stands in the array."""

    DTYPE = query.IN_BOX

    def _item(self, row: Any) -> Any:
        return row


class Aims(Answers[Aim | None]):
    """The paths of many balls, or of one in many directions.

    Where one meets nothing, `shape` is 0, and so is all else but `ball` and `start`. A direction that is None in `Aim`
    is (0, 0) here.
    """

    DTYPE = query.AIM

    def _object(self, world: World, row: query.AimRow) -> Aim | None:
        if row["shape"] == 0:
            return None
        direction, other_direction = vector(row["direction"]), vector(row["other_direction"])
        return Aim(
            _member(world, row["ball"]),
            _member(world, row["shape"]),
            float(row["time"]),
            vector(row["start"]),
            vector(row["ghost"]),
            float(row["distance"]),
            vector(row["point"]),
            vector(row["normal"]),
            direction if any(direction) else None,
            float(row["speed"]),
            other_direction if any(other_direction) else None,
            float(row["other_speed"]),
        )


def _member(world: World, member_id: int) -> Any:
    """The shape or ball with an id, which may have left the world since, if someone keeps it."""
    member = world._object_of_hit(int(member_id), None)
    if member is None:
        raise LostObject(f"what has the id {member_id} has left the world; read these answers as arrays")
    return member
