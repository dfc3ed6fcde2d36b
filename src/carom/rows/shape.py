"""The row of a shape that is no ball, and what the numbers of its kind and motion mean."""

from enum import IntEnum
from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i8, u1, u4

POINT = 0
SEGMENT = 1
GATE = 2
CIRCLE = 3
ARC = 4
BALL_KIND = 5

KIND_NAMES = ("point", "segment", "gate", "circle", "arc", "ball")

STATIC = 0
KINEMATIC = 1
DYNAMIC = 2

# What a shape's `once` is.
ONCE = 1  # it switches itself off at its first bounce
SPENT = 2  # it has, in this step

#: The `time_left` of a shape that has come where it was sent, until the substep is over and it rests.
ARRIVED = -1.0


class Motion(IntEnum):
    """How a shape moves: not at all, on rails that nothing pushes it off, or freely."""

    STATIC = STATIC
    KINEMATIC = KINEMATIC
    DYNAMIC = DYNAMIC


class ShapeRow(TypedDict):
    """A row of `SHAPE`."""

    # the box, compared before anything else
    left: f8
    bottom: f8
    right: f8
    top: f8
    kind: u1
    motion: u1
    sensor: u1
    can_collide: u1
    solid: u1  # circles: the inside is solid too
    rotating: u1  # kinematic: whether angular_velocity acts
    turn_limited: u1  # whether turn_low and turn_high act
    once: u1  # 0, ONCE or SPENT; in the copies of a step that was undone, whether it was out of numbers' range
    layer: u4
    collides_with: u4
    id: i8
    drops_with: i8  # the next id in the ring of those that switch themselves off together; 0: it does so alone
    elasticity: f8
    kick: f8
    # geometry as it is now
    cx: f8  # position: a point's own, a segment's midpoint, a circle's or an arc's centre
    cy: f8
    radius: f8
    ax: f8  # p0 of a segment, gate or arc
    ay: f8
    bx: f8  # p1
    by: f8
    tx: f8  # t0 of a segment or gate: unit vector from p0 to p1
    ty: f8
    length: f8
    dx: f8  # unit direction in which a gate lets balls pass
    dy: f8
    start_angle: f8
    end_angle: f8
    # geometry as it was set; every turn starts from here, so turns accumulate no drift
    initial_cx: f8
    initial_cy: f8
    initial_ax: f8
    initial_ay: f8
    initial_bx: f8
    initial_by: f8
    initial_dx: f8
    initial_dy: f8
    initial_start_angle: f8
    initial_end_angle: f8
    initial_pivot_x: f8
    initial_pivot_y: f8
    hinge_x: f8  # the place in the initial geometry that is at the pivot: the initial pivot, unless rotated
    hinge_y: f8  # about another one since
    # motion
    pivot_x: f8
    pivot_y: f8
    orientation: f8  # radians turned since the initial geometry
    angular_velocity: f8
    turn_low: f8
    turn_high: f8
    velocity_x: f8
    velocity_y: f8
    # where `move_to` sends it
    time_left: f8  # seconds until it is there; 0: it is sent nowhere, ARRIVED: it came there just now
    target_x: f8  # its position there
    target_y: f8
    target_pivot_x: f8
    target_pivot_y: f8
    target_orientation: f8
    # the last substep
    spin: f8  # angular velocity that acted in it
    orientation_before: f8
    pivot_before_x: f8
    pivot_before_y: f8
    # since when it moves as it does (continuous), and what it was at orientation_before and pivot_before
    since: f8
    since_low: f8
    time_left_before: f8
    velocity_before_x: f8
    velocity_before_y: f8


SHAPE = dtype_of(ShapeRow)
