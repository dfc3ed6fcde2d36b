"""Descriptors of worlds and balls, as pydantic models: what a scene file may say of them, and what it makes.

Fields bear the names of the constructors' arguments and have their defaults.
"""

from __future__ import annotations

from math import isfinite
from typing import Any, Literal, Self

from pydantic import model_validator

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


class WorldDescriptor(Descriptor):
    """The settings of a world."""

    gravity: Vector = (0.0, 0.0)
    """Acceleration (x, y) of all balls, in length/s²."""
    detection: Literal["discrete", "continuous"] = "discrete"
    """Whether overlaps are found after moving, or times of impact on the way."""
    substeps: Substeps = 4
    """Motion iterations per step."""
    iterations: Iterations = 6
    """Collision iterations per substep at most (discrete)."""
    broad_phase: Literal["grid", "quadtree", "brute"] = "grid"
    """How pairs are found; all find the same pairs, faster or slower."""
    levels: Levels = 6
    """Levels of the quadtree, the root included."""
    restitution: Literal["normal", "total"] = "normal"
    """Whether elasticity scales the normal part of a velocity or all of it."""
    friction: NonNegative = 0.0
    """Deceleration of every ball that has no friction of its own, in length/s²."""
    sleep_speed: NonNegative = 0.0
    """Speed below which a ball may fall asleep."""
    sleep_time: NonNegative = 0.5
    """Seconds below that speed before a ball sleeps."""
    rest_speed: NonNegative | None = None
    """Speed of approach below which an inelastic contact comes to rest; by default twice what gravity adds in a
    substep."""
    max_speed: Positive | None = None
    """A faster ball is slowed to this after a response."""
    max_impacts: Impacts = 100_000
    """Impacts of a ball in a substep at most (continuous)."""
    bounds: Sides | None = None
    """Left, bottom, right and top of a box; a ball wholly outside of it is a stray."""
    remove_strays: bool = False
    """Whether strays are removed."""

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
