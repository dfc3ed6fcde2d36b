"""Contacts: what two overlapping shapes have to say to each other, outside of any world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.checks import refuse
from carom.geometry.overlap import overlap_ball
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.kinds import detect_contact
from carom.rows.masks import may_collide
from carom.rows.pose import acting_spin, surface_velocity
from carom.rows.shape import BALL_KIND
from carom.shapes.member import Member
from carom.typing import Vector

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape


@dataclass(frozen=True, slots=True)
class Contact:
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
    """The contact of a ball with a shape that is no ball; a miss is None.

    A gate yields one only where the ball's centre is on the closed side and the ball approaches. Masks and
    `can_collide` hold; sensors are found like anything else.
    """
    body = _ball_row(ball)
    row = shape._row
    if not may_collide(row, body):
        return None
    x, y, radius = float(body["x"]), float(body["y"]), float(body["radius"])
    spin = acting_spin(row)
    # At the ball's centre: this serves only as a direction where centres coincide, and along the normal of a gate,
    # where it is the same at the centre as at the point of contact.
    surface_x, surface_y = surface_velocity(row, spin, x, y, 0.0)
    wx, wy = float(body["vx"]) - surface_x, float(body["vy"]) - surface_y
    found = detect_contact(row, x, y, radius, wx, wy)
    if found is None:
        return None
    px, py, nx, ny, setback = found
    surface_x, surface_y = surface_velocity(row, spin, px, py, 0.0)
    speed = length(float(body["vx"]) - surface_x, float(body["vy"]) - surface_y)
    return Contact(shape, ball, (px, py), (nx, ny), setback, speed)


def detect_pair(first: Ball, second: Ball) -> Contact | None:
    """The contact of two balls, with the normal from the first to the second; a miss, or the same ball, is None."""
    other = _ball_row(second)
    own = first._row
    if first is second or not may_collide(own, other):
        return None
    wx, wy = float(other["vx"]) - float(own["vx"]), float(other["vy"]) - float(own["vy"])
    x, y, radius = float(own["x"]), float(own["y"]), float(own["radius"])
    found = overlap_ball(x, y, radius, float(other["x"]), float(other["y"]), float(other["radius"]), wx, wy)
    if found is None:
        return None
    px, py, nx, ny, setback = found
    return Contact(first, second, (px, py), (nx, ny), setback, length(wx, wy))
