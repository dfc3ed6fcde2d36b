"""The balls of a scene and those of a world, all at once: columns of numbers, not one object after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from carom.rows.ball import OF_WORLD
from carom.scene.descriptors import BallDescriptor

if TYPE_CHECKING:
    from carom.world.world import World

#: What stands for many balls' fields in a table of rows.
NUMBERS = ("radius", "mass", "elasticity", "layer", "collides_with")
SWITCHES = ("sensor", "can_collide")


def add_balls(world: World, balls: Sequence[BallDescriptor]) -> None:
    """Add balls to a world, in their order, as if each were built and added."""
    if not balls:
        return
    fields = ("position", "velocity", *NUMBERS, *SWITCHES)
    columns: dict[str, Any] = {field: [getattr(ball, field) for ball in balls] for field in fields}
    friction = [OF_WORLD if ball.friction is None else ball.friction for ball in balls]
    ids = world.add_balls(friction=friction, **columns)
    for ball_id, ball in zip(ids.tolist(), balls, strict=True):
        if ball.name is not None:
            world.object(ball_id).name = ball.name


def described_balls(world: World) -> list[dict[str, Any]]:
    """The tables of a world's balls as they stand now, in their order."""
    rows = world._arrays.balls.used
    fields: dict[str, list[Any]] = {
        "position": list(zip(rows["x"].tolist(), rows["y"].tolist(), strict=True)),
        "velocity": list(zip(rows["vx"].tolist(), rows["vy"].tolist(), strict=True)),
        **{field: rows[field].tolist() for field in NUMBERS},
        "friction": [None if friction == OF_WORLD else friction for friction in rows["friction"].tolist()],
        **{field: rows[field].astype("?").tolist() for field in SWITCHES},
        "name": [getattr(world._objects.get(ball), "name", None) for ball in rows["id"].tolist()],
    }
    return [dict(zip(fields, values, strict=True)) for values in zip(*fields.values(), strict=True)]
