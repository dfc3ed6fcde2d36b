"""The row of a ball."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4, i8, u1, u4

ALL_LAYERS = 0xFFFFFFFF

#: The friction of a ball that has none of its own: that of the world holds.
OF_WORLD = -1.0


class BallRow(TypedDict):
    """A row of `BALL`."""

    x: f8
    y: f8
    vx: f8
    vy: f8
    radius: f8
    mass: f8
    elasticity: f8
    friction: f8  # deceleration in length/s², or OF_WORLD
    still_time: f8  # seconds spent below the sleep speed
    id: i8
    layer: u4
    collides_with: u4
    relation: i4  # first of this ball's relations in the world's pool, or NO_RELATION
    sensor: u1
    can_collide: u1
    asleep: u1
    stray: u1


BALL = dtype_of(BallRow)
