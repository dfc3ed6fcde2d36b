"""Descriptors of worlds and balls, as pydantic models: what a scene file may say of them, and what it makes.

Fields bear the names of the constructors' arguments and have their defaults.
"""

from __future__ import annotations

from inspect import signature
from math import isfinite
from typing import Any, Literal, Self

from pydantic import Field, model_validator

from carom.rows.ball import ALL_LAYERS
from carom.scene.descriptor import Descriptor
from carom.scene.faults import fault_below
from carom.scene.fields import (
    Impacts,
    Iterations,
    Layers,
    Levels,
    NonNegative,
    Positive,
    Sides,
    Substeps,
    Text,
    Vector,
)
from carom.shapes.aabb import Aabb
from carom.shapes.ball import Ball
from carom.typing import Detection, Restitution
from carom.world.settings import Settings
from carom.world.world import World


def _setting(name: str) -> Any:
    """The field of a world's setting, whose default and text are the world's."""
    return Field(signature(World).parameters[name].default, description=vars(Settings)[name].__doc__)


class WorldDescriptor(Descriptor):
    """The settings of a world."""

    gravity: Vector = _setting("gravity")
    detection: Detection = _setting("detection")
    substeps: Substeps = _setting("substeps")
    iterations: Iterations = _setting("iterations")
    broad_phase: Literal["grid", "quadtree", "brute"] = _setting("broad_phase")
    levels: Levels = _setting("levels")
    restitution: Restitution = _setting("restitution")
    friction: NonNegative = _setting("friction")
    sleep_speed: NonNegative = _setting("sleep_speed")
    sleep_time: NonNegative = _setting("sleep_time")
    rest_speed: NonNegative | None = _setting("rest_speed")
    max_speed: Positive | None = _setting("max_speed")
    max_impacts: Impacts | None = _setting("max_impacts")
    bounds: Sides | None = _setting("bounds")
    remove_strays: bool = _setting("remove_strays")

    def settings(self) -> dict[str, Any]:
        """The arguments for `World`."""
        return dict(self) | {"bounds": Aabb(*self.bounds) if self.bounds is not None else None}


class CollidingDescriptor(Descriptor):
    """What shapes and balls share."""

    name: Text | None = None
    """What it is called."""
    elasticity: NonNegative = 1.0
    """Its factor in the ratio of speeds after and before an impact; above 1 adds speed."""
    sensor: bool = False
    """Whether it only reports what overlaps it."""
    can_collide: bool = True
    """Whether it meets anything at all."""
    layer: Layers = 1
    """The layers that it is on, as a mask of 32 bits."""
    collides_with: Layers = ALL_LAYERS
    """The layers that it meets; two meet where each is on a layer that the other meets."""


class BallDescriptor(CollidingDescriptor):
    """A ball."""

    position: Vector
    """Its centre."""
    radius: Positive
    """Its radius."""
    velocity: Vector = (0.0, 0.0)
    """How fast it moves, in length/s."""
    mass: Positive = 1.0
    """Its mass; only ratios matter."""
    friction: NonNegative | None = None
    """Its deceleration by the table, in length/s²; by default the world's."""

    @model_validator(mode="after")
    def _can_be_built(self) -> Self:
        """The descriptor itself, unless no number can hold the ball's box."""
        x, y = self.position
        if not isfinite(max(abs(x), abs(y)) + self.radius):
            raise fault_below(".position", f"must leave the ball's box finite, not {self.position}")
        return self

    def build(self) -> Ball:
        """The ball, in no world."""
        return Ball(**dict(self))
