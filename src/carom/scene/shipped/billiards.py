"""Billiards of the textbooks: rooms in which paths that begin as one part exponentially.

The balls of a billiard do not meet each other. They start from one place in directions that differ by little, and all
that is given back is what was taken: energy stays the same to the last digits.
"""

from __future__ import annotations

from math import pi
from typing import Any

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import ArcDescriptor, CircleDescriptor
from carom.scene.shipped.outline import polar, walls

BALLS = 5
SPREAD = 1e-3  # radians between one ball's direction and the next one's
SPEED = 4.0
BALL_RADIUS = 0.08

BALL_LAYER, WALL_LAYER = 2, 1


def stadium() -> Scene:
    """Bunimovich's stadium: two half circles joined by straight walls, and five balls that start almost alike.

    Source: L. A. Bunimovich, On the ergodic properties of nowhere dispersing billiards, 1979.
    """
    half, radius = 2.0, 2.0
    right = ArcDescriptor(
        center=(half, 0.0), radius=radius, start_angle=-pi / 2.0, end_angle=pi / 2.0, name="right half circle"
    )
    left = ArcDescriptor(
        center=(-half, 0.0), radius=radius, start_angle=pi / 2.0, end_angle=-pi / 2.0, name="left half circle"
    )
    straight = [
        *walls([polar(left.center, radius, -pi / 2.0), polar(right.center, radius, -pi / 2.0)], name="lower wall"),
        *walls([polar(right.center, radius, pi / 2.0), polar(left.center, radius, pi / 2.0)], name="upper wall"),
    ]
    return _billiard("stadium", [right, left, *straight], (-1.0, 0.3), 0.7)


def sinai() -> Scene:
    """Sinai's billiard: a square room round a solid disc, and five balls that start almost alike.

    Source: Ya. G. Sinai, Dynamical systems with elastic reflections, 1970.
    """
    corners = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0), (-2.0, -2.0)]
    disc = CircleDescriptor(center=(0.0, 0.0), radius=1.0, solid=True, name="disc")
    return _billiard("sinai", [*walls(corners, name="wall"), disc], (-1.5, -1.2), 0.9)


def _billiard(name: str, shapes: list[Any], start: tuple[float, float], direction: float) -> Scene:
    """A scene of balls that leave `start` in almost one direction and meet nothing but `shapes`."""
    balls = [
        BallDescriptor(
            position=start,
            velocity=polar((0.0, 0.0), SPEED, direction + SPREAD * place),
            radius=BALL_RADIUS,
            layer=BALL_LAYER,
            collides_with=WALL_LAYER,
        )
        for place in range(BALLS)
    ]
    world = WorldDescriptor(detection="continuous", substeps=1, bounds=(-5.0, -3.0, 5.0, 3.0))
    return Scene(name=name, world=world, guard=True, shapes=shapes, balls=balls)
