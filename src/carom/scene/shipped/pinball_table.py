"""A pinball table: dome, lanes, bumpers, slingshots, drop targets, flippers, gates, plunger lane, the drain's way back.

One unit of length is 2.25 cm, so that a ball of 27 mm has a radius of 0.6 and the table of 42 is 95 cm long. It slopes
by 6.5 degrees, and a ball that rolls has 5/7 of the acceleration of one that slides: 9.81 m/s² · sin 6.5° · 5/7 is 35
units/s² down the table. A ball that drains rolls back to the plunger, whose coil kicks it up the lane again.
"""

from __future__ import annotations

from math import acos, cos, pi, radians, sin
from typing import Any

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import (
    ArcDescriptor,
    CircleDescriptor,
    CompoundDescriptor,
    GateDescriptor,
    SegmentDescriptor,
)
from carom.scene.shipped.outline import band, mirrored, polar, rounded
from carom.typing import Vector

WIDTH, HEIGHT = 20.0, 42.0
DOME = ((10.0, 32.0), 10.0)
LANE = 18.6  # x of the wall between field and plunger lane
MIDDLE = LANE / 2.0  # of the field
OUTLANE, INLANE = 1.6, 1.9  # their widths
SHOULDER = 1.4  # how far the shoulders stand out from the walls
FOOT = 1.0  # of the slingshots; it ends short of the flipper, or a ball on its root would be squeezed out like a pip
BALL_RADIUS = 0.6

FLIPPER_BASE = ((MIDDLE - 4.25, 8.6), 0.6)
FLIPPER_TIP_RADIUS = 0.35
FLIPPER_LENGTH = 3.5
FLIPPER_REST = radians(-28.0)
FLIPPER_SWING = radians(56.0)

WOOD: dict[str, Any] = {"elasticity": 0.5}
RUBBER: dict[str, Any] = {"elasticity": 0.8}
# A bat that does not bounce carries the ball along until it stops or the ball slides off the tip: so where the ball lay
# says where it goes. One that bounces strikes it away at once, by its outer half always the same way.
BAT: dict[str, Any] = {"elasticity": 0.0}
SENSOR: dict[str, Any] = {"sensor": True}


def pinball() -> Scene:
    """A pinball table in play: one ball on its way up the plunger lane, two that follow from the trough."""
    return Scene(
        name="pinball",
        world=WorldDescriptor(
            gravity=(0.0, -35.0), substeps=8, max_speed=120.0, bounds=(-2.0, -2.0, WIDTH + 2.0, HEIGHT + 2.0)
        ),
        guard=True,
        shapes=(*_cabinet(), *_top(), *_middle(), *_bottom()),
        balls=_balls(),
    )


def _balls() -> tuple[BallDescriptor, ...]:
    """One ball in the plunger lane, two that roll down the trough to it."""
    in_lane = BallDescriptor(position=(19.3, 5.0), radius=BALL_RADIUS, velocity=(0.0, 57.0), name="first ball")
    second = BallDescriptor(position=(13.0, 2.7), radius=BALL_RADIUS, name="second ball")
    third = BallDescriptor(position=(4.0, 4.3), radius=BALL_RADIUS, name="third ball")
    return in_lane, second, third


def _cabinet() -> list[Any]:
    """The outer walls with the dome, the plunger lane, and the trough below the flippers."""
    center, radius = DOME
    trough, lane_floor = (LANE, 1.1), (LANE, 0.7)
    return [
        SegmentDescriptor(start=(0.0, 4.2), end=(0.0, center[1]), name="left wall", **WOOD),
        ArcDescriptor(center=center, radius=radius, start_angle=0.0, end_angle=pi, name="dome", **WOOD),
        SegmentDescriptor(start=(WIDTH, center[1]), end=(WIDTH, 0.4), name="right wall", **WOOD),
        SegmentDescriptor(start=(0.0, 4.2), end=trough, name="trough", elasticity=0.3),
        SegmentDescriptor(start=trough, end=lane_floor, name="trough's edge", elasticity=0.3),
        SegmentDescriptor(start=lane_floor, end=(WIDTH, 0.4), name="plunger", elasticity=0.3, kick=60.0),
        SegmentDescriptor(start=(LANE, 2.9), end=(LANE, 31.0), name="lane wall", **WOOD),
        GateDescriptor(
            start=(LANE, 31.0), end=(WIDTH, center[1]), direction=(-1.0, 1.4), name="launch gate", elasticity=0.3
        ),
        SegmentDescriptor(start=(LANE + 0.2, 8.0), end=(WIDTH - 0.2, 8.0), name="plunger lane", **SENSOR),
        SegmentDescriptor(start=(0.2, 5.6), end=(LANE - 0.2, 5.6), name="drain", **SENSOR),
    ]


def _top() -> list[Any]:
    """The orbit gate on the dome, the orbits' inner guides, and the three lanes with their rollovers."""
    center, radius = DOME
    stop = radians(116.0)
    guides = {"center": center, **WOOD}
    parts: list[Any] = [
        GateDescriptor(
            start=polar(center, radius, stop),
            end=polar(center, radius - 1.4, stop),
            direction=polar((0.0, 0.0), 1.0, stop - pi / 2.0),
            name="orbit gate",
            elasticity=0.3,
        ),
        ArcDescriptor(radius=7.9, start_angle=radians(150.0), end_angle=pi, name="left orbit guide", **guides),
        SegmentDescriptor(start=(2.1, 32.0), end=(2.1, 27.0), name="left orbit guide", **WOOD),
        ArcDescriptor(radius=6.5, start_angle=0.0, end_angle=radians(32.0), name="right orbit guide", **guides),
        SegmentDescriptor(start=(16.5, 32.0), end=(16.5, 27.0), name="right orbit guide", **WOOD),
        SegmentDescriptor(start=(0.3, 30.0), end=(1.8, 30.0), name="left orbit", **SENSOR),
        SegmentDescriptor(start=(16.8, 29.0), end=(18.3, 29.0), name="right orbit", **SENSOR),
    ]
    for x in (6.3, 8.3, 10.3, 12.3):
        parts += band([((x, 33.8), 0.25), ((x, 36.2), 0.25)], name="lane guide", **RUBBER)
    for x, name in ((7.3, "left lane"), (9.3, "middle lane"), (11.3, "right lane")):
        parts.append(SegmentDescriptor(start=(x - 0.65, 35.0), end=(x + 0.65, 35.0), name=name, **SENSOR))
    return parts


def _middle() -> list[Any]:
    """The bumpers, the posts, the spinner and the shoulders that narrow the field above the outlanes."""
    bumpers = [
        ((MIDDLE - 3.1, 28.6), "left bumper"),
        ((MIDDLE + 3.1, 28.6), "right bumper"),
        ((MIDDLE, 24.6), "low bumper"),
    ]
    left = [
        *_shoulder(),
        CircleDescriptor(center=(MIDDLE - 3.6, 21.6), radius=0.4, solid=True, name="left post", **RUBBER),
    ]
    hub = (MIDDLE, 18.8)
    return [
        *(
            CircleDescriptor(center=center, radius=1.3, solid=True, kick=16.0, elasticity=0.7, name=name)
            for center, name in bumpers
        ),
        *left,
        *mirrored(left, MIDDLE),
        *_bank(),
        CompoundDescriptor(
            shapes=tuple(band([((hub[0] - 1.5, hub[1]), 0.22), ((hub[0] + 1.5, hub[1]), 0.22)], **RUBBER)),
            pivot=hub,
            angular_velocity=2.5,
            name="spinner",
        ),
    ]


def _shoulder() -> list[Any]:
    """The left wall's bulge, its flat face a target with a kick of its own."""
    corners = [((0.0, 26.0), 0.0), ((SHOULDER, 23.6), 1.2), ((SHOULDER, 20.0), 1.2), ((0.0, 17.6), 0.0)]
    parts = rounded(corners, name="left shoulder", **RUBBER)
    parts[2] = parts[2].model_copy(update={"kick": 8.0, "name": "left target"})
    return parts


def _bank() -> list[Any]:
    """Three drop targets before the right shoulder's face; one is down when its shapes do not collide.

    A ball that touches the face has its centre farther out than the targets' axis, so it rests on none that is up.
    """
    x, half, radius = LANE - SHOULDER - 0.28, 0.32, 0.2
    parts: list[Any] = []
    for number, y in enumerate((20.65, 21.8, 22.95), 1):
        parts += band([((x, y - half), radius), ((x, y + half), radius)], name=f"drop target {number}", **WOOD)
    return parts


def _bottom() -> list[Any]:
    """Flippers, slingshots, inlanes and outlanes: the left side and its mirror image."""
    left = [_flipper(), *_inlane(), *_slingshot(), *_gutter_sensors()]
    return [*left, *mirrored(left, MIDDLE)]


def _flipper() -> CompoundDescriptor:
    """The left flipper, at rest on its lower stop; set `angular_velocity` to swing it."""
    pivot, _ = FLIPPER_BASE
    tip = polar(pivot, FLIPPER_LENGTH, FLIPPER_REST)
    return CompoundDescriptor(
        shapes=tuple(band([FLIPPER_BASE, (tip, FLIPPER_TIP_RADIUS)], **BAT)),
        pivot=pivot,
        turn_limits=(0.0, FLIPPER_SWING),
        name="left flipper",
    )


def _top_edge() -> tuple[Vector, float]:
    """Where the left flipper's upper edge leaves its base at rest, and the edge's direction."""
    pivot, radius = FLIPPER_BASE
    normal = FLIPPER_REST + acos((radius - FLIPPER_TIP_RADIUS) / FLIPPER_LENGTH)
    return polar(pivot, radius, normal), normal - pi / 2.0


def _on_guide(x: float, above: float) -> Vector:
    """The point at `x` that lies at the distance `above` over the line of the inlane's guide."""
    (touch_x, touch_y), slope = _top_edge()
    return x, touch_y + (x - touch_x) * sin(slope) / cos(slope) + above / cos(slope)


def _inlane() -> list[Any]:
    """The wall between outlane and inlane, which bends into the line of the flipper's upper edge; its post on top."""
    touch, _ = _top_edge()
    top = (OUTLANE, 15.2)
    corners = [(top, 0.0), (_on_guide(OUTLANE, 0.0), 1.4), (touch, 0.0)]
    return [
        *rounded(corners, name="left inlane guide", **WOOD),
        CircleDescriptor(center=top, radius=0.25, solid=True, name="left outlane post", **RUBBER),
    ]


def _slingshot() -> list[Any]:
    """A band round three posts, the long side of which kicks."""
    radius = 0.35
    x = OUTLANE + INLANE + radius
    lower = _on_guide(x, INLANE + radius)
    inner = _on_guide(x + FOOT, INLANE + radius)
    parts = band([(lower, radius), (inner, radius), ((x, 16.2), radius)], name="left slingshot", **RUBBER)
    parts[2] = parts[2].model_copy(update={"kick": 14.0, "name": "left slingshot's band"})
    return parts


def _gutter_sensors() -> list[Any]:
    """The rollovers of outlane and inlane."""
    y = 13.4
    return [
        SegmentDescriptor(start=(0.25, y), end=(OUTLANE - 0.25, y), name="left outlane", **SENSOR),
        SegmentDescriptor(start=(OUTLANE + 0.25, y), end=(OUTLANE + INLANE - 0.25, y), name="left inlane", **SENSOR),
    ]
