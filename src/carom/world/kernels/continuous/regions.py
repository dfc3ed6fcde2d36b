"""The regions of kinematic shapes, as flights ask for them: they hold until an instant, `state["valid"]`."""

from __future__ import annotations

from math import inf

from carom.constants import FEW_SHAPES
from carom.geometry.instants import is_before, later
from carom.rows.ball import BallRow
from carom.rows.index import ShapeIndex
from carom.rows.shape import ShapeRow
from carom.rows.state import GRID, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import build_regions, span_on_way
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING, measure_clear
from carom.world.kernels.step.discrete import rebuild_static


def rebuild_regions(
    state: StateRow, balls: Table[BallRow], shapes: Table[ShapeRow], order: Table[int], shape_index: ShapeIndex
) -> bool:
    """True when the index of shapes is right for flights from now on; False where it has no room.

    They stand as they were made as long as they hold and no motion has changed. They hold twice as long after each
    renewal without an event since: a step's work does not grow with its length where nothing happens.
    """
    if not rebuild_static(state, balls, shapes, order, shape_index):
        return False
    entry = shape_index[0][FIXED]
    if entry["measured"] == 0 and state["broad_phase"] == GRID and state["fixed"] - state["dropped"] > FEW_SHAPES:
        measure_clear(entry, shape_index[1])
    now, now_low = float(state["now"]), float(state["now_low"])
    if state["moving_stale"] == 0 and is_before(now, now_low, float(state["valid"]), float(state["valid_low"])):
        return True
    span = span_on_way(state, shapes, order)
    for _ in range(state["renewals"]):
        span *= 2.0
    if span < inf:
        time, low = later(now, now_low, span)
        span = span if is_before(now, now_low, time, low) else inf
    if not build_regions(state, shapes, order, shape_index, span, False):
        return False
    state["moving_stale"] = 0
    state["valid"] = inf
    state["valid_low"] = 0.0
    holding = float(shape_index[0][MOVING]["span"])
    if holding < inf:
        time, low = later(now, now_low, holding)
        state["valid"] = time
        state["valid_low"] = low
    return True
