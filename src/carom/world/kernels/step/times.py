"""Lengths and times of substeps, and what follows from them: the speed below which a contact comes to rest."""

from __future__ import annotations

from math import sqrt

from carom.constants import REBOUND
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
    """The time of hits between balls that overlap: the end of the substep, or now in the continuous mode."""
    if state["detection"] == DISCRETE:
        return substep_end(state)
    return float(state["now"])


def rest_speed(state: StateRow, radius: float) -> float:
    """The speed of approach below which an inelastic contact of a ball of a radius comes to rest."""
    speed = float(state["rest_speed"])
    if speed >= 0.0:
        return speed
    pull = length(float(state["gravity_x"]), float(state["gravity_y"]))
    if state["detection"] != DISCRETE:
        # How long a step is says nothing there: a rebound that is too low to be seen is none.
        return sqrt(2.0 * pull * REBOUND * radius)
    # What gravity adds in a substep is no approach; twice that leaves room for the rounding of the bounce before.
    return 2.0 * pull * substep_length(state)
