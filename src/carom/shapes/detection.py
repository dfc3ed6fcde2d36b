"""Contacts: what two overlapping shapes have to say to each other, outside of any world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.checks import refuse
from carom.pictured import Pictured
from carom.rows.ball import BallRow
from carom.rows.contact import contact_of_balls, contact_with_shape
from carom.rows.shape import BALL_KIND
from carom.shapes.member import Member
from carom.typing import Vector

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape


@dataclass(frozen=True, slots=True)
class Contact(Pictured):
    """One overlap of a ball with a shape or with another ball, as `detect` found it.

    `shape` is what was met (the part, where that is a part of a compound; the first ball, where two balls meet) and
    `ball` the ball that met it; `point` where they touch; `normal` the unit vector from the shape to the ball;
    `setback` how far along it the ball must move to touch, positive; `speed` the magnitude of the ball's velocity
    relative to the surface at the point, in length/s.
    """

    shape: Shape | Ball
    ball: Ball
    point: Vector
    normal: Vector
    setback: float
    speed: float


def _ball_row(value: Any) -> BallRow:
    """The row of `value`, which must be a ball; otherwise raises `InvalidArgument`."""
    if not isinstance(value, Member) or value._KIND != BALL_KIND:
        raise refuse("ball", "must be a Ball", value)
    row: BallRow = value._row
    return row


def detect_shape(shape: Shape, ball: Ball) -> Contact | None:
    """The contact of a ball with a shape that is no ball; a miss is None. Sensors are found like anything else."""
    return _contact(shape, ball, contact_with_shape(shape._row, _ball_row(ball)))


def detect_pair(first: Ball, second: Ball) -> Contact | None:
    """The contact of two balls, with the normal from the first to the second; a miss, or the same ball, is None."""
    other = _ball_row(second)
    return None if first is second else _contact(first, second, contact_of_balls(first._row, other))


def _contact(
    shape: Shape | Ball, ball: Ball, found: tuple[float, float, float, float, float, float] | None
) -> Contact | None:
    """The contact that was found, if there was one."""
    if found is None:
        return None
    px, py, nx, ny, setback, speed = found
    return Contact(shape, ball, (px, py), (nx, ny), setback, speed)
