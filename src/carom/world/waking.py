"""Whether a step is to begin with waking all balls."""

from __future__ import annotations

from carom.rows.state import DISCRETE
from carom.world.kernels.continuous.frames import is_any_changed
from carom.world.kernels.step.beginning import was_changed
from carom.world.tables import Arrays


def will_wake(arrays: Arrays) -> bool:
    """Whether the next step wakes all balls: something was changed from outside, or a ball that sleeps was moved."""
    state = arrays.states[0]
    if state["wake"] or not state["sleeping"]:
        return bool(state["wake"])
    state["balls"] = arrays.balls.count
    if state["detection"] != DISCRETE:
        return bool(is_any_changed(state, arrays.balls.rows, arrays.flights))
    return was_changed(state, arrays.balls.rows, arrays.saved)
