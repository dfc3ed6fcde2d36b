"""Pool, the end of a game: a cue ball on its way to the eight, on a table of nine feet.

Lengths are centimetres and masses kilograms. The playing surface is 254 by 127 between the noses of the cushions. A
ball that is potted stays: a gate across each pocket lets it in, and the pocket's wall gives almost nothing back.
"""

from __future__ import annotations

from math import cos, hypot, radians, sin, tan
from typing import Any

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import CircleDescriptor, GateDescriptor
from carom.scene.shipped.outline import Disc, rounded
from carom.typing import Vector

LENGTH, WIDTH = 254.0, 127.0
BALL_RADIUS = 2.8575
BALL_MASS = 0.17

CORNER_CUT = 8.3  # along each cushion, from where two of them would meet to where each ends
SIDE_CUT = 6.5  # from the middle of the long cushion to where it ends
CORNER_TURN = radians(38.0)  # by which a cushion bends into its pocket
SIDE_TURN = radians(76.0)
NOSE_RADIUS = 1.2  # of the bend
CORNER_POCKET_RADIUS = 5.4
SIDE_POCKET_RADIUS = 5.6

CUSHION_ELASTICITY = 0.8
POCKET_ELASTICITY = 0.05
ROLLING_FRICTION = 12.0  # cm/s²: 0.012 of gravity


def pool() -> Scene:
    """The end of a game of pool: the cue ball is on its way to the eight, which is on its way to a pocket."""
    return Scene(
        name="pool",
        world=WorldDescriptor(
            detection="continuous",  # so that the eight goes exactly as aimed
            friction=ROLLING_FRICTION,
            sleep_speed=0.5,
            bounds=(-20.0, -20.0, LENGTH + 20.0, WIDTH + 20.0),
        ),
        guard=True,
        shapes=(*_rim(), *_sensors()),
        balls=_balls(),
    )


def _balls() -> tuple[BallDescriptor, ...]:
    """The cue ball, aimed so that it sends the eight into the upper right pocket, and the eight."""
    ball: dict[str, Any] = {"radius": BALL_RADIUS, "mass": BALL_MASS, "elasticity": 0.975}
    cue, eight = (70.0, 38.0), (196.0, 84.0)
    target = (LENGTH - 1.5, WIDTH - 1.5)
    aim = _towards(cue, _beyond(target, eight, 2.0 * BALL_RADIUS), 260.0)
    return (
        BallDescriptor(position=cue, velocity=aim, name="cue ball", **ball),
        BallDescriptor(position=eight, name="eight", **ball),
    )


def _towards(start: Vector, target: Vector, speed: float) -> Vector:
    """The velocity of `speed` from `start` towards `target`."""
    x, y = target[0] - start[0], target[1] - start[1]
    distance = hypot(x, y)
    return speed * x / distance, speed * y / distance


def _beyond(start: Vector, end: Vector, distance: float) -> Vector:
    """The point `distance` past `end` on the way from `start`: where the cue ball is when it sends the eight there."""
    x, y = _towards(start, end, distance)
    return end[0] + x, end[1] + y


def _rim() -> list[Any]:
    """One closed line, counterclockwise, along the cushions and round the pockets; and a gate across each pocket."""
    half = [*_lower_cushions(), *_right_cushion()]
    corners = [*half, *(((LENGTH - x, WIDTH - y), radius) for (x, y), radius in half)]
    parts = rounded(corners, closed=True, elasticity=CUSHION_ELASTICITY, name="cushion")
    pockets = [place for place, part in enumerate(parts) if getattr(part, "radius", 0.0) > NOSE_RADIUS]
    gates = [_gate(parts[place - 1], parts[place], parts[(place + 1) % len(parts)]) for place in pockets]
    for place in pockets:
        parts[place] = parts[place].model_copy(update={"elasticity": POCKET_ELASTICITY, "name": "pocket"})
    return [*parts, *gates]


def _gate(jaw: Any, pocket: Any, other_jaw: Any) -> GateDescriptor:
    """The gate between the middles of a pocket's jaws, which opens into the pocket."""
    start, end = _middle(jaw), _middle(other_jaw)
    x, y = pocket.center[0] - start[0], pocket.center[1] - start[1]
    return GateDescriptor(start=start, end=end, direction=(x, y), elasticity=POCKET_ELASTICITY, name="pocket gate")


def _middle(segment: Any) -> Vector:
    """The middle of a segment."""
    return (segment.start[0] + segment.end[0]) / 2.0, (segment.start[1] + segment.end[1]) / 2.0


def _lower_cushions() -> list[Disc]:
    """The corners from the lower left pocket to the lower right one, each with the radius that rounds it.

    A pocket's jaws would meet far behind it; its wall is the arc that rounds that corner.
    """
    middle = LENGTH / 2.0
    depth = SIDE_CUT * tan(SIDE_TURN)
    behind = CORNER_CUT / (cos(CORNER_TURN) - sin(CORNER_TURN)) * sin(CORNER_TURN)
    return [
        ((CORNER_CUT, 0.0), NOSE_RADIUS),
        ((middle - SIDE_CUT, 0.0), NOSE_RADIUS),
        ((middle, -depth), SIDE_POCKET_RADIUS),
        ((middle + SIDE_CUT, 0.0), NOSE_RADIUS),
        ((LENGTH - CORNER_CUT, 0.0), NOSE_RADIUS),
        ((LENGTH + behind, -behind), CORNER_POCKET_RADIUS),
    ]


def _right_cushion() -> list[Disc]:
    """The corners from the lower right pocket to the upper right one."""
    behind = CORNER_CUT / (cos(CORNER_TURN) - sin(CORNER_TURN)) * sin(CORNER_TURN)
    return [
        ((LENGTH, CORNER_CUT), NOSE_RADIUS),
        ((LENGTH, WIDTH - CORNER_CUT), NOSE_RADIUS),
        ((LENGTH + behind, WIDTH + behind), CORNER_POCKET_RADIUS),
    ]


def _sensors() -> list[Any]:
    """The sensors that notice a potted ball."""
    places = {
        "lower left": (-1.5, -1.5),
        "lower middle": (LENGTH / 2.0, -4.5),
        "lower right": (LENGTH + 1.5, -1.5),
        "upper right": (LENGTH + 1.5, WIDTH + 1.5),
        "upper middle": (LENGTH / 2.0, WIDTH + 4.5),
        "upper left": (-1.5, WIDTH + 1.5),
    }
    return [
        CircleDescriptor(center=place, radius=1.0, solid=True, sensor=True, name=f"{name} pocket")
        for name, place in places.items()
    ]
