"""Newton's cradle, lying down: equal balls that touch, in a lane between two walls."""

from __future__ import annotations

from carom.checks import whole
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shipped.outline import walls
from carom.spelling import spelled

RADIUS = 0.5
RUN_UP = 4.0  # free way of the first ball on one side, and of the last on the other
SPEED = 6.0


@spelled
def newtons_cradle(balls: int = 5) -> Scene:
    """Newton's cradle, lying down: a row of balls that touch and rest, and one more on its way to them.

    `balls` (2 to 1,000) are all of them.
    """
    count = whole("balls", balls, 2, 1_000)
    diameter = 2.0 * RADIUS
    row = diameter * (count - 1)
    left, right = -RUN_UP - diameter, row + RUN_UP
    first = BallDescriptor(position=(left + diameter, 0.0), radius=RADIUS, velocity=(SPEED, 0.0), name="first")
    others = [BallDescriptor(position=(diameter * place + RADIUS, 0.0), radius=RADIUS) for place in range(count - 1)]
    corners = [(left, -diameter), (right, -diameter), (right, diameter), (left, diameter), (left, -diameter)]
    return Scene(
        name="newtons_cradle",
        world=WorldDescriptor(detection="continuous", substeps=1, bounds=(left - 1.0, -3.0, right + 1.0, 3.0)),
        guard=True,
        shapes=walls(corners, name="wall"),
        balls=[first, *others],
    )
