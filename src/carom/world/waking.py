"""Whether a step is to begin with waking all balls."""

from __future__ import annotations

from typing import Any

import numpy as np

from carom.rows.state import CHANGED, DISCRETE
from carom.rows.tables import Rows
from carom.world.kernels.continuous.showing import is_any_changed
from carom.world.kernels.step.beginning import was_changed
from carom.world.tables import Arrays


def note_changed(states: Rows, which: Any = ...) -> None:
    """Have the next steps of the worlds with some states, `which` of all, wake their balls; motions go on."""
    states["wake"][which] = np.maximum(states["wake"][which], CHANGED)


def will_wake(arrays: Arrays) -> int:
    """Why the next step wakes all balls, or 0: what was changed from outside, or that a ball that sleeps was moved."""
    state = arrays.states[0]
    if state["wake"] or not state["sleeping"]:
        return int(state["wake"])
    state["balls"] = arrays.balls.count
    if state["detection"] != DISCRETE:
        return CHANGED if is_any_changed(state, arrays.balls.rows, arrays.flights) else 0
    return CHANGED if was_changed(state, arrays.balls.rows, arrays.saved) else 0
