"""What can be set in the toy, and what each setting does to a world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import carom
from carom import draw
from carom.draw import Layer
from carom.typing import BroadPhase, Detection, Restitution

#: How many times slower than real time the world may run.
PACES = (1, 4, 10)
#: The fastest that the scene lets balls be; launches and throws that are faster lift it.
USUAL_MOST_SPEED = 40.0

BOTH = "both"


@dataclass(slots=True)
class Settings:
    """Everything that the panel can set, as it is now.

    Attributes:
        size: Radius of the next ball.
        speed: Speed of the next ball.
        count: How many balls `launch` sends up.
        broad_phase: How pairs are found: `brute`, `quadtree` or `grid`.
        levels: Levels of the quadtree.
        motion: Motion iterations a step.
        collision: Collision iterations a motion iteration, at most.
        detection: `discrete`, `continuous`, or `both` side by side.
        restitution: `normal` or `total`.
        gravity: Downwards.
        friction: Deceleration of every ball.
        sleep: Speed below which balls fall asleep; 0 for never.
        pace: How many times slower than real time.
        muted: Whether there is no sound.
        rotating: Whether the parts that can turn do.
        paused: Whether time stands still but for single steps.
        editing: Whether the table is being changed, while time stands still.
        kind: What is added to it then: `segment`, `arc`, `circle`, `point` or `ball`.
        layers: What is drawn.
    """

    size: float = 0.5
    speed: float = 24.0
    count: int = 10
    broad_phase: BroadPhase = "grid"
    levels: int = 6
    motion: int = 4
    collision: int = 6
    detection: str = "discrete"
    restitution: Restitution = "normal"
    gravity: float = 5.0
    friction: float = 0.0
    sleep: float = 0.0
    pace: int = 1
    muted: bool = False
    rotating: bool = False
    paused: bool = False
    editing: bool = False
    kind: str = "segment"
    layers: frozenset[Layer] = field(default=draw.DEFAULT_LAYERS)


def apply(settings: Settings, world: carom.World, detection: Detection) -> None:
    """Set a world as `settings` say, its detection aside."""
    for name, act in ACTS.items():
        act(world, getattr(settings, name))
    world.detection = detection


def _attribute(name: str) -> Callable[[carom.World, Any], None]:
    """What sets a world's attribute."""
    return lambda world, value: setattr(world, name, value)


def _pull(world: carom.World, gravity: float) -> None:
    """Let balls fall."""
    world.gravity = (0.0, -gravity)


def _lift(world: carom.World, speed: float) -> None:
    """Let balls be as fast as they are launched."""
    world.max_speed = max(USUAL_MOST_SPEED, speed)


def _turn(world: carom.World, rotating: bool) -> None:
    """Have the parts that can turn do so, or stand."""
    for shape in world.shapes:
        if isinstance(shape, carom.Compound) and shape.rotating != rotating:
            shape.rotating = rotating


#: What each setting does to a world; those that are not here concern the toy alone.
ACTS: Mapping[str, Callable[[carom.World, Any], None]] = MappingProxyType(
    {
        "broad_phase": _attribute("broad_phase"),
        "levels": _attribute("levels"),
        "motion": _attribute("substeps"),
        "collision": _attribute("iterations"),
        "restitution": _attribute("restitution"),
        "gravity": _pull,
        "friction": _attribute("friction"),
        "sleep": _attribute("sleep_speed"),
        "speed": _lift,
        "rotating": _turn,
    }
)

#: The switches of what is shown, each with its layers.
SHOWN: Mapping[str, frozenset[Layer]] = MappingProxyType(
    {
        "hit points": frozenset({Layer.HITS}),
        "tracks": frozenset({Layer.TRACKS}),
        "tangents": frozenset({Layer.TANGENTS}),
        "boxes": frozenset({Layer.BOXES, Layer.CELLS}),
        "reticles": frozenset({Layer.RETICLES}),
        "velocity": frozenset({Layer.VELOCITIES}),
        "sectors": frozenset({Layer.SECTORS}),
        "lights": frozenset({Layer.LIGHTS}),
    }
)
