"""Why a step was refused, as the exception that says so."""

from __future__ import annotations

import numpy as np

from carom.errors import InvalidArgument, NonFiniteState
from carom.rows import Rows
from carom.world.layout import NOT_FINITE, REFUSED
from carom.world.safety import is_sound


def refusal(status: int, balls: Rows) -> InvalidArgument | NonFiniteState:
    """The exception for a step that came back with `status`; `balls` are as they were before the step."""
    if status == REFUSED:
        bad = balls[(balls["radius"] <= 0.0) | (balls["mass"] <= 0.0)]
        return InvalidArgument(f"radius and mass must be positive, not those of balls {_ids(bad)}")
    assert status == NOT_FINITE
    bad = balls[[not (is_sound(row) and np.isfinite(row["radius"] + row["mass"])) for row in balls]]
    which = f"balls {_ids(bad)} are not finite" if len(bad) else "balls became infinite in the step"
    return NonFiniteState(f"{which}; the world is as it was before the step")


def _ids(rows: Rows) -> str:
    """The first few ids of rows, for a message."""
    ids = [str(int(ball)) for ball in rows["id"][:10]]
    return ", ".join(ids) + (f" and {len(rows) - 10} more" if len(rows) > 10 else "")
