"""What was changed from outside: whose flights are to begin anew, and whether a step begins with waking all balls."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.rows.state import CHANGED, DISCRETE
from carom.rows.tables import Rows
from carom.world.kernels.continuous.showing import is_any_changed
from carom.world.kernels.step.beginning import was_changed
from carom.world.tables import Arrays


def note_changed(states: Rows, which: NDArray[np.bool_]) -> None:
    """Have the next steps of the worlds with some states, `which` a mask says, wake their balls; motions go on."""
    states["wake"][which] = np.maximum(states["wake"][which], CHANGED)


def begin_anew(arrays: Arrays, which: NDArray[Any]) -> None:
    """Have the next step begin new flights of the balls that a mask or indices name: they are not what they were.

    One that has come since the last step has none yet, and is passed over.
    """
    flying = min(arrays.balls.count, len(arrays.flights) // 2)
    mark_changed(arrays.flights[:flying], which[:flying] if which.dtype.kind == "b" else which[which < flying])


def mark_changed(flights: Rows, which: NDArray[Any]) -> None:
    """Mark flights, which a mask or indices name, as those of balls that were changed."""
    flights["id"][which] = -np.abs(flights["id"][which])


def will_wake(arrays: Arrays) -> int:
    """Why the next step wakes all balls, or 0: what was changed from outside, or that a ball that sleeps was moved."""
    state = arrays.states[0]
    if state["wake"] or not state["sleeping"]:
        return int(state["wake"])
    state["balls"] = arrays.balls.count
    if state["detection"] != DISCRETE:
        return CHANGED if is_any_changed(state, arrays.balls.rows, arrays.flights) else 0
    return CHANGED if was_changed(state, arrays.balls.rows, arrays.saved) else 0
