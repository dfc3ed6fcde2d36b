"""Balls: circles with mass that move freely."""

from __future__ import annotations

from math import isfinite
from typing import Any, ClassVar, TypedDict, Unpack

import numpy as np

from carom.checks import flag, layers, non_negative, one_of, pair, positive, refuse, text_or_none
from carom.geometry.aabb import circle_box
from carom.geometry.circle import closest_on_circle
from carom.geometry.response import exchanged, reflected, separated
from carom.geometry.vector import dot
from carom.rows.ball import ALL_LAYERS, BALL, OF_WORLD, BallRow
from carom.rows.relation import NO_RELATION
from carom.rows.shape import BALL_KIND, Motion
from carom.shapes.aabb import Aabb
from carom.shapes.detection import Contact, detect_pair
from carom.shapes.round import Round
from carom.shapes.shape import Shape
from carom.shapes.table import put_fields, word_of
from carom.spelling import spelled
from carom.turns import changing, setting
from carom.typing import Pair, Restitution, Vector

#: Where a row has them, as words of 64 bits.
X, Y, VX, VY, RADIUS = (word_of(BALL, field) for field in ("x", "y", "vx", "vy", "radius"))

#: What is said of a ball that is put beyond the range of numbers.
LEAVES = "must leave the ball's box and velocity finite"


class BallGeometry(TypedDict, total=False):
    """The fields of a row on which a ball's box and way depend."""

    x: float
    y: float
    radius: float
    vx: float
    vy: float


@spelled
class Ball(Round[BallRow]):
    """A dynamic circle, which other shapes push about.

    `position` in length, `radius` in length (positive), `velocity` in length/s, `mass` in any unit (positive),
    `friction` in length/s² (None: the world's). Raises `InvalidArgument`, which names the argument and its value.

    >>> import carom
    >>> ball = carom.Ball((5, 0.25), radius=0.5, velocity=(3, -2))
    >>> contact = carom.Segment((0, 0), (10, 0), elasticity=0.5).detect(ball)
    >>> contact.normal, contact.setback
    ((0.0, 1.0), 0.25)
    >>> ball.respond(contact)
    >>> ball.position, ball.velocity
    ((5.0, 0.5), (3.0, 1.0))
    """

    __slots__ = ()

    _KIND = BALL_KIND
    _DTYPE: ClassVar[np.dtype[Any]] = BALL

    def __init__(
        self,
        position: Pair,
        radius: float,
        velocity: Pair = (0.0, 0.0),
        mass: float = 1.0,
        *,
        elasticity: float = 1.0,
        friction: float | None = None,
        sensor: bool = False,
        can_collide: bool = True,
        layer: int = 1,
        collides_with: int = ALL_LAYERS,
        name: str | None = None,
        user: Any = None,
    ) -> None:
        row: BallRow = np.zeros(1, BALL)[0]
        row["x"], row["y"] = pair("position", position)
        row["radius"] = positive("radius", radius)
        row["vx"], row["vy"] = pair("velocity", velocity)
        row["mass"] = positive("mass", mass)
        row["elasticity"] = non_negative("elasticity", elasticity)
        row["friction"] = _friction(friction)
        row["sensor"] = flag("sensor", sensor)
        row["can_collide"] = flag("can_collide", can_collide)
        row["layer"] = layers("layer", layer)
        row["collides_with"] = layers("collides_with", collides_with)
        row["relation"] = NO_RELATION
        _check(row, "position", position)
        self._begin(row, text_or_none("name", name), user)

    def __repr__(self) -> str:
        return f"Ball({self.position}, {self.radius}, velocity={self.velocity}, mass={self.mass})"

    def _lone_row(self) -> BallRow:
        row = super()._lone_row()
        row["relation"] = NO_RELATION
        row["still_time"] = 0.0
        row["asleep"] = row["stray"] = 0
        return row

    def _with(self, name: str, value: object, **fields: Unpack[BallGeometry]) -> BallRow:
        """A copy of the row with some fields changed; raises where the ball leaves the range of numbers."""
        row = self._table.copied(self)
        put_fields(row, fields)
        _check(row, name, value)
        return row

    # -- state -------------------------------------------------------------------------------------------------------

    @property
    def position(self) -> Vector:
        """Where its centre is."""
        table = self._table
        at = table.at(self)
        floats = table.floats
        return floats[at + X], floats[at + Y]

    @position.setter
    @setting
    def position(self, value: Pair) -> None:
        self._put_at("position", value)

    def _put_at(self, name: str, value: Pair) -> None:
        x, y = pair(name, value)
        table = self._table
        at = table.at(self)
        floats = table.floats
        radius = floats[at + RADIUS]
        if not (isfinite(abs(x) + radius) and isfinite(abs(y) + radius)):
            raise refuse(name, LEAVES, value)
        self._go(at + X, x, y)

    @property
    def velocity(self) -> Vector:
        """How fast it moves, in length/s."""
        table = self._table
        at = table.at(self)
        floats = table.floats
        return floats[at + VX], floats[at + VY]

    @velocity.setter
    @setting
    def velocity(self, value: Pair) -> None:
        vx, vy = pair("velocity", value)
        self._go(self._table.at(self) + VX, vx, vy)

    def _go(self, at: int, x: float, y: float) -> None:
        """Write where the ball is, or how fast it moves, by words of the table; a step sees by itself whose that is."""
        floats = self._table.floats
        if floats[at] != x or floats[at + 1] != y:
            floats[at], floats[at + 1] = x, y
            if self._world is not None:
                self._world._note_change()

    @property
    def radius(self) -> float:
        """Its radius; positive."""
        table = self._table
        at = table.at(self)
        return table.floats[at + RADIUS]

    @radius.setter
    @setting
    def radius(self, value: float) -> None:
        self._write(self._with("radius", value, radius=positive("radius", value)))

    @property
    def mass(self) -> float:
        """Its mass, in any unit; positive. Only ratios matter."""
        return float(self._row["mass"])

    @mass.setter
    @setting
    def mass(self, value: float) -> None:
        self._put("mass", positive("mass", value))

    @property
    def friction(self) -> float | None:
        """Its deceleration by the table, in length/s², 0 or more; None: that of the world that it is in."""
        friction = float(self._row["friction"])
        return None if friction == OF_WORLD else friction

    @friction.setter
    @setting
    def friction(self, value: float | None) -> None:
        self._put("friction", _friction(value))

    @property
    def asleep(self) -> bool:
        """Whether it sleeps: in a world, after it has been slow for a while; never outside of one."""
        return bool(self._row["asleep"])

    @property
    def motion(self) -> Motion:
        """Always DYNAMIC."""
        return Motion.DYNAMIC

    @property
    def orientation(self) -> float:
        """Always 0: a ball does not turn."""
        return 0.0

    @property
    def aabb(self) -> Aabb:
        """The smallest box around it."""
        return Aabb(*circle_box(*self.position, self.radius))

    # -- what it does ------------------------------------------------------------------------------------------------

    def closest_point(self, p: Pair) -> Vector:
        """The point of its perimeter that is nearest to `p`; the one at angle 0 where `p` is its centre."""
        x, y = pair("p", p)
        return closest_on_circle(*self.position, self.radius, x, y)

    @spelled
    @changing
    def move(self, dt: float, gravity: Pair = (0.0, 0.0)) -> None:
        """Move the ball freely for `dt` seconds (not negative), on the exact parabola of constant gravity.

        `p += v·dt + g·dt²/2`, then `v += g·dt`; `gravity` in length/s². Raises `InvalidArgument` for bad arguments, and
        where the ball would leave the range of numbers.
        """
        h = non_negative("dt", dt)
        gx, gy = pair("gravity", gravity)
        (x, y), (vx, vy) = self.position, self.velocity
        half = 0.5 * h * h
        x, y = x + (vx * h + gx * half), y + (vy * h + gy * half)
        self._write(self._with("dt", dt, x=x, y=y, vx=vx + gx * h, vy=vy + gy * h))

    def detect(self, ball: Ball) -> Contact | None:
        """The contact with another ball, with the normal from this ball to that one; None where they do not overlap."""
        return detect_pair(self, ball)

    @spelled
    @changing
    def respond(self, contact: Contact, restitution: Restitution = "normal") -> None:
        """Do what follows from a contact of this ball: move it out of the shape and turn its velocity.

        With e the product of the two elasticities, a ball that approaches leaves with e times its normal speed relative
        to the surface, plus the shape's kick; of two balls, both move and both turn. `restitution="total"` scales the
        tangential speed by e too, against shapes. A sensor moves nothing. Raises `InvalidArgument` for a contact of
        another ball, and for an unknown restitution.
        """
        _check_contact(contact, self)
        total = one_of("restitution", restitution, ("normal", "total")) == "total"
        if contact.shape.sensor or contact.ball.sensor:
            return
        if isinstance(contact.shape, Ball):
            _respond_to_ball(contact, contact.shape)
        else:
            _respond_to_shape(contact, contact.shape, total)


def _friction(value: float | None) -> float:
    """A ball's friction as its row holds it."""
    return OF_WORLD if value is None else non_negative("friction", value)


def _check(row: BallRow, name: str, value: object) -> None:
    """Raise where a ball's box or velocity is not finite, with argument `name` and its `value` to blame."""
    box = circle_box(float(row["x"]), float(row["y"]), float(row["radius"]))
    if not all(map(isfinite, (*box, row["vx"], row["vy"]))):
        raise refuse(name, LEAVES, value)


def _check_contact(value: Any, ball: Ball) -> None:
    """Raise for what is no contact of `ball`."""
    if not isinstance(value, Contact) or (value.ball is not ball and value.shape is not ball):
        raise refuse("contact", "must be a Contact of this ball", value)


def _respond_to_shape(contact: Contact, shape: Shape, total: bool) -> None:
    """Change the ball's velocity as its collision with a static or kinematic shape does."""
    ball, (nx, ny) = contact.ball, contact.normal
    (x, y), (vx, vy) = ball.position, ball.velocity
    surface_vx, surface_vy = shape.surface_velocity(contact.point)
    approach = dot(vx - surface_vx, vy - surface_vy, nx, ny)
    if approach < 0.0:
        e = shape.elasticity * ball.elasticity
        vx, vy, _ = reflected(vx, vy, surface_vx, surface_vy, nx, ny, e, approach, shape.kick, total)
    x, y = x + contact.setback * nx, y + contact.setback * ny
    ball._write(ball._with("contact", contact, x=x, y=y, vx=vx, vy=vy))


def _respond_to_ball(contact: Contact, first: Ball) -> None:
    """Change the velocities of two balls as their collision does."""
    second, (nx, ny) = contact.ball, contact.normal
    (vx1, vy1), (vx2, vy2) = first.velocity, second.velocity
    m1, m2 = first.mass, second.mass
    x1, y1, x2, y2 = separated(*first.position, m1, *second.position, m2, nx, ny, contact.setback)
    u1, u2 = dot(vx1, vy1, nx, ny), dot(vx2, vy2, nx, ny)
    if u2 - u1 < 0.0:
        w1, w2 = exchanged(u1, u2, m1, m2, first.elasticity * second.elasticity)
        vx1, vy1 = vx1 + (w1 - u1) * nx, vy1 + (w1 - u1) * ny
        vx2, vy2 = vx2 + (w2 - u2) * nx, vy2 + (w2 - u2) * ny
    first_row = first._with("contact", contact, x=x1, y=y1, vx=vx1, vy=vy1)
    second_row = second._with("contact", contact, x=x2, y=y2, vx=vx2, vy=vy2)
    first._write(first_row)
    second._write(second_row)
