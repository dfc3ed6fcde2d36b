"""The collision toy's table: a room of 32 by 24 with every kind of shape in it, and parts that turn when told to.

A ball goes up the launch lane at the lower right, is turned into the room by the quarter arc above it, and cannot come
back through the gate. The pocket at the upper left gives more than it takes, and so does the bumper.
"""

from __future__ import annotations

from math import pi, radians
from typing import Any

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import (
    ArcDescriptor,
    CircleDescriptor,
    CompoundDescriptor,
    GateDescriptor,
    PointDescriptor,
    SegmentDescriptor,
)
from carom.scene.shipped.outline import polar, walls
from carom.typing import Vector

WIDTH, HEIGHT = 32.0, 24.0
LANE = 30.6  # x of the wall between room and launch lane
CORNER = ((28.0, 20.0), 4.0)
POCKET = ((5.0, 19.0), 3.5)

WALL: dict[str, Any] = {"elasticity": 0.97}


def toy() -> Scene:
    """The collision toy's table, one ball in the launch lane and four in the room."""
    return Scene(
        name="toy",
        world=WorldDescriptor(
            detection="discrete",  # so that the toy can show what may tunnel
            gravity=(0.0, -5.0),
            max_speed=40.0,
            bounds=(-2.0, -2.0, WIDTH + 2.0, HEIGHT + 2.0),
        ),
        guard=True,
        shapes=(*_room(), *_pocket(), *_lane(), *_inside(), *_below(), *_posts()),
        balls=_balls(),
    )


def _balls() -> tuple[BallDescriptor, ...]:
    """The ball in the launch lane, on its way up, and four others."""
    launched = BallDescriptor(position=(31.45, 1.0), radius=0.5, velocity=(0.0, 24.0), name="launched")
    others = {
        "upper": ((16.0, 21.5), (-4.0, 0.0)),
        "on the shelf": ((19.0, 17.6), (3.0, 0.0)),
        "in the cup": ((15.0, 5.0), (0.0, 0.0)),
        "left": ((2.2, 9.5), (1.0, 4.0)),
    }
    return launched, *(
        BallDescriptor(position=place, velocity=velocity, radius=0.5, name=name)
        for name, (place, velocity) in others.items()
    )


def _room() -> list[Any]:
    """The outer walls with the quarter arc at the upper right, but for the corner where the pocket is."""
    center, radius = CORNER
    return [
        *walls([(0.0, 11.5), (0.0, 0.0), (WIDTH, 0.0), (WIDTH, center[1])], name="wall", **WALL),
        ArcDescriptor(center=center, radius=radius, start_angle=0.0, end_angle=pi / 2.0, name="corner", **WALL),
        *walls([(center[0], HEIGHT), (12.5, HEIGHT)], name="wall", **WALL),
    ]


def _pocket() -> list[Any]:
    """The three-quarter arc that opens towards the room, and the slanted walls that join it to the others."""
    center, radius = POCKET
    arc = ArcDescriptor(
        center=center, radius=radius, start_angle=0.0, end_angle=1.5 * pi, name="pocket", elasticity=1.15
    )
    right, below = polar(center, radius, 0.0), polar(center, radius, 1.5 * pi)
    slants = [*walls([(12.5, HEIGHT), right], name="slant", **WALL), *walls([below, (0.0, 11.5)], name="slant", **WALL)]
    return [arc, *slants]


def _lane() -> list[Any]:
    """The launch lane's inner wall, and the gate above it, which lets a ball in and rolls it off to the left."""
    top = (LANE, 18.8)
    return [
        *walls([(LANE, 0.0), top], name="lane wall", **WALL),
        GateDescriptor(start=top, end=(WIDTH, CORNER[0][1]), direction=(-1.2, 1.4), name="launch gate", **WALL),
    ]


def _inside() -> list[Any]:
    """One vertical, one horizontal and one slanted segment, and the bumper; the slanted one turns when told to."""
    slanted = [SegmentDescriptor(start=(21.5, 9.0), end=(26.5, 12.0), **WALL)]
    return [
        *walls([(12.0, 13.5), (12.0, 18.0)], name="upright", **WALL),
        *walls([(18.5, 17.0), (24.0, 17.0)], name="shelf", **WALL),
        _at_rest("paddle", slanted, pivot=(24.0, 10.5), angular_velocity=1.5),
        CircleDescriptor(center=(16.5, 11.8), radius=1.8, solid=True, name="bumper", elasticity=1.3),
    ]


def _below() -> list[Any]:
    """Three arcs: a hill, a cup that can be tipped and a crescent that can be turned."""
    cup, crescent = (15.5, 6.2), (24.0, 4.6)
    return [
        _arc((6.5, 0.8), 4.0, 35.0, 145.0, name="hill"),
        _at_rest("cup", [_arc(cup, 2.6, 185.0, 355.0)], pivot=cup, angular_velocity=1.0),
        _at_rest("crescent", [_arc(crescent, 2.4, 95.0, 265.0)], pivot=crescent, angular_velocity=-2.0),
    ]


def _arc(center: Vector, radius: float, start: float, end: float, name: str | None = None) -> ArcDescriptor:
    """An arc of the walls' kind between two angles in degrees."""
    return ArcDescriptor(
        center=center, radius=radius, start_angle=radians(start), end_angle=radians(end), name=name, **WALL
    )


def _posts() -> list[Any]:
    """Points: two rows of posts in the lower half."""
    places = [(10.2, 9.2), (7.8, 8.2), (5.4, 7.2), (3.0, 6.2), (27.2, 2.2), (28.3, 4.0), (27.2, 5.8)]
    return [PointDescriptor(position=place, name="post", **WALL) for place in places]


def _at_rest(name: str, parts: list[Any], pivot: Vector, angular_velocity: float) -> CompoundDescriptor:
    """Parts that turn about `pivot` once `rotating` is set."""
    return CompoundDescriptor(
        shapes=tuple(parts), pivot=pivot, angular_velocity=angular_velocity, rotating=False, name=name
    )
