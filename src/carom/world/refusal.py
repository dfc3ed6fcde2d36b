"""Why a step was refused, as the exception that says so."""

from __future__ import annotations

import numpy as np

from carom.errors import InvalidArgument, NonFiniteState
from carom.rows import Rows
from carom.world.layout import NOT_FINITE, REFUSED
from carom.world.safety import is_sound
from carom.world.tables import Room


def refusal(status: int, room: Room) -> InvalidArgument | NonFiniteState:
    """The exception for a step that came back with `status`; everything is as it was before the step."""
    balls = room.balls.used
    if status == REFUSED:
        bad = balls[(balls["radius"] <= 0.0) | (balls["mass"] <= 0.0)]
        return InvalidArgument(f"radius and mass must be positive, not those of balls {_ids(bad)}")
    assert status == NOT_FINITE
    bad = balls[[not (is_sound(row) and np.isfinite(row["radius"] + row["mass"])) for row in balls]]
    which = f"balls {_ids(bad)} are not finite" if len(bad) else _overflowed(room)
    return NonFiniteState(f"{which}; the world is as it was before the step")


def _overflowed(room: Room) -> str:
    """What was not finite any more when a step was undone, in words."""
    balls = room.balls.used[room.saved[: room.balls.count]["overflowed"] != 0]
    kinematic = room.shapes.count - int(room.states[0]["fixed"])
    copies = room.shapes.rows[room.shapes.count : room.shapes.count + kinematic]
    shapes = copies[copies["spare"] != 0]
    names = [f"{kind} {_ids(rows)}" for kind, rows in (("balls", balls), ("shapes", shapes)) if len(rows)]
    return " and ".join(names) + " became infinite in the step"


def _ids(rows: Rows) -> str:
    """The first few ids of rows, for a message."""
    ids = [str(int(ball)) for ball in rows["id"][:10]]
    return ", ".join(ids) + (f" and {len(rows) - 10} more" if len(rows) > 10 else "")
