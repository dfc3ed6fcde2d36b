"""The balls of a scene and those of a world, all at once: columns of numbers, not one object after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from carom.scene.descriptors import BallDescriptor

if TYPE_CHECKING:
    from carom.world.world import World

#: The fields of a ball by which `World.add_balls` makes it, and those that are set afterwards.
GIVEN = ("position", "velocity", "radius", "mass", "elasticity")
SET = ("sensor", "can_collide", "layer", "collides_with")


def add_balls(world: World, balls: Sequence[BallDescriptor]) -> None:
    """Add balls to a world, in their order, as if each were built and added."""
    if not balls:
        return
    columns: dict[str, Any] = {field: [getattr(ball, field) for ball in balls] for field in (*GIVEN, *SET)}
    ids = world.add_balls(**{field: columns[field] for field in GIVEN})
    rows = world._room.balls.used[-len(balls) :]
    for field in SET:
        rows[field] = columns[field]
    for ball_id, ball in zip(ids.tolist(), balls, strict=True):
        if ball.name is not None:
            world.object(ball_id).name = ball.name


def described_balls(world: World) -> list[dict[str, Any]]:
    """The tables of a world's balls as they stand now, in their order."""
    rows = world._room.balls.used
    fields: dict[str, list[Any]] = {
        "position": list(zip(rows["x"].tolist(), rows["y"].tolist(), strict=True)),
        "velocity": list(zip(rows["vx"].tolist(), rows["vy"].tolist(), strict=True)),
        **{field: rows[field].tolist() for field in ("radius", "mass", "elasticity", "layer", "collides_with")},
        **{field: rows[field].astype("?").tolist() for field in ("sensor", "can_collide")},
        "name": [getattr(world._objects.get(ball), "name", None) for ball in rows["id"].tolist()],
    }
    return [dict(zip(fields, values, strict=True)) for values in zip(*fields.values(), strict=True)]
