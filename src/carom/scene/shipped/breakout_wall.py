"""Breakout: a ball, a paddle whose top is an arc, and rows of round bricks that are gone once they were hit.

Nothing takes energy from the ball, and a slight pull downwards keeps it from going from side to side for ever. A sensor
above the floor notices that it is lost; the floor sends it up again, so that a table without a player plays on. Bricks
are discs, since a disc has no ends: what is left when its neighbour is gone is whole.
"""

from __future__ import annotations

from math import pi, sin
from typing import Any

from carom.checks import positive, whole
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import ArcDescriptor, CircleDescriptor, CompoundDescriptor, SegmentDescriptor
from carom.scene.shipped.outline import polar, rounded
from carom.spelling import spelled
from carom.typing import Vector

WIDTH, HEIGHT = 24.0, 30.0
CORNER_RADIUS = 2.0  # of the room, whose corners would send a ball back the way that it came

BRICK_RADIUS = 0.85  # of eleven in a row
ROWS, LONG_ROW = 6, 11  # every other row has one brick less, and lies in the gaps
FIRST_ROW = 17.0  # y of the lowest one
HIGHEST = 29.0  # y up to which bricks may come, so that a ball has room above them
MOST_COLUMNS = 24

BALL_RADIUS = 0.45
SPEED = 18.0

PADDLE_TOP = 4.0  # y of its highest point
PADDLE_RADIUS = 5.0  # of the arc on top
PADDLE_HALF_ANGLE = 0.5  # of that arc
PADDLE_CAP = 0.3  # radius of its rounded ends


@spelled
def breakout(rows: int = ROWS, columns: int = LONG_ROW, speed: float = SPEED) -> Scene:
    """A game of breakout as it begins: the ball is on its way up to the bricks, the paddle waits in the middle.

    Every other row has one brick less than `columns`; bricks are as large as so many leave them. The ball is as fast as
    `speed`, and never more than twice that.
    """
    columns = whole("columns", columns, 2, MOST_COLUMNS)
    pitch, radius = _brick_sizes(columns)
    most = 1 + int((HIGHEST - radius - FIRST_ROW) / (pitch * sin(pi / 3.0)))
    rows = whole("rows", rows, 1, most, f"of bricks this large, {columns} in one")
    speed = positive("speed", speed)
    return Scene(
        name="breakout",
        world=WorldDescriptor(
            gravity=(0.0, -3.0),
            max_speed=2.0 * speed,
            bounds=(-2.0, -2.0, WIDTH + 2.0, HEIGHT + 2.0),
        ),
        shapes=(*_room(), *_bricks(rows, columns), _paddle()),
        balls=(
            BallDescriptor(
                position=(WIDTH / 2.0, PADDLE_TOP + 1.5),
                radius=BALL_RADIUS,
                velocity=polar((0.0, 0.0), speed, 1.2),
                name="ball",
            ),
        ),
    )


def _room() -> list[Any]:
    """The walls with their round corners, and the sensor above the floor."""
    corners = [((x, y), CORNER_RADIUS) for x, y in ((0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT))]
    # As high as the corners, so that none comes back from one unnoticed.
    drain = SegmentDescriptor(start=(0.0, CORNER_RADIUS), end=(WIDTH, CORNER_RADIUS), sensor=True, name="drain")
    return [*rounded(corners, closed=True, name="wall"), drain]


def _brick_sizes(columns: int) -> tuple[float, float]:
    """How far bricks are from each other in a row of so many, and their radius."""
    return WIDTH / (columns + 0.5), BRICK_RADIUS * ((LONG_ROW + 0.5) / (columns + 0.5))


def _bricks(rows: int, columns: int) -> list[CircleDescriptor]:
    """The rows of bricks, the lowest first, from left to right."""
    pitch, radius = _brick_sizes(columns)
    bricks = []
    for row in range(rows):
        count = columns - row % 2
        left = WIDTH / 2.0 - 0.5 * pitch * (count - 1)
        y = FIRST_ROW + row * pitch * sin(pi / 3.0)
        for place in range(count):
            name = f"brick {row + 1}.{place + 1}"
            center = (left + place * pitch, y)
            bricks.append(CircleDescriptor(center=center, radius=radius, solid=True, once=True, name=name))
    return bricks


def _paddle() -> CompoundDescriptor:
    """The paddle: an arc on top, small arcs round its ends, and a flat underside; all joints are tangent."""
    x = WIDTH / 2.0
    center: Vector = (x, PADDLE_TOP - PADDLE_RADIUS)
    left, right = pi / 2.0 + PADDLE_HALF_ANGLE, pi / 2.0 - PADDLE_HALF_ANGLE
    reach = PADDLE_RADIUS - PADDLE_CAP
    caps = polar(center, reach, left), polar(center, reach, right)
    below = caps[0][1] - PADDLE_CAP
    return CompoundDescriptor(
        shapes=(
            ArcDescriptor(center=center, radius=PADDLE_RADIUS, start_angle=right, end_angle=left),
            ArcDescriptor(center=caps[0], radius=PADDLE_CAP, start_angle=left, end_angle=1.5 * pi),
            SegmentDescriptor(start=(caps[0][0], below), end=(caps[1][0], below)),
            ArcDescriptor(center=caps[1], radius=PADDLE_CAP, start_angle=-pi / 2.0, end_angle=right),
        ),
        pivot=(x, PADDLE_TOP),
        name="paddle",
    )
