"""Lengths and times of substeps, and what follows from them: the speed below which a contact comes to rest."""

from __future__ import annotations

from carom.geometry.vector import length
from carom.rows.state import DISCRETE, StateRow


def substep_length(state: StateRow) -> float:
    """The length of a substep in seconds."""
    return float(state["dt"]) / float(state["substeps"])


def substep_end(state: StateRow) -> float:
    """The world's time at the end of the substep."""
    # The last one ends with the step, whatever its parts add up to.
    if state["substep"] + 1 == state["substeps"]:
        return float(state["time"]) + float(state["dt"])
    return float(state["time"]) + float(state["substep"] + 1) * substep_length(state)


def hit_time(state: StateRow) -> float:
    """The time of hits between balls that overlap: the end of the substep, or its beginning in the continuous mode."""
    if state["detection"] == DISCRETE:
        return substep_end(state)
    return float(state["time"]) + float(state["substep"]) * substep_length(state)


def rest_speed(state: StateRow) -> float:
    """The speed of approach below which an inelastic contact comes to rest."""
    speed = float(state["rest_speed"])
    if speed >= 0.0:
        return speed
    # What gravity adds in a substep is no approach; twice that leaves room for the rounding of the bounce before.
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    return 2.0 * length(gx, gy) * substep_length(state)
