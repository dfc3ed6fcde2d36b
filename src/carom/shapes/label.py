"""What shapes and balls are called in lists and tables."""

from __future__ import annotations

from carom.shapes.ball import Ball
from carom.shapes.shape import Shape


def name_of(shape: Shape) -> str | None:
    """The name of `shape`, or that of the compound or group that it is a part of, or None."""
    if shape.name is None and shape._whole is not None:
        return shape._whole.name
    return shape.name


def label_of(member: Shape | Ball) -> str:
    """What to call a shape or ball: its name, or what and where a shape is, or `ball 7`."""
    if isinstance(member, Ball):
        return member.name or f"ball {member.id}"
    x, y = member.position
    return name_of(member) or f"{member.kind} at ({x:.4g}, {y:.4g})"
