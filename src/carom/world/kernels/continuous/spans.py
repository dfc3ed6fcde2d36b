"""Spans of a substep: from one time at which a shape stops or arrives to the next, shapes move evenly."""

from __future__ import annotations

from carom.constants import FEW_BALLS, STOP_MARGIN, SWEEP_MOST, SWEEP_ROUNDING
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.index import SlotRow
from carom.rows.pose import acting_spin, advance_pose, is_moving, rest, set_before
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.grid import pairs_by_grid
from carom.world.kernels.continuous.bins import may_meet
from carom.world.kernels.continuous.flight import begin_flight, top_speed
from carom.world.kernels.continuous.surfaces import span_box
from carom.world.kernels.step.motion import wake_in_box


def time_to_stop(shape: ShapeRow) -> float:
    """The time in which a turning shape reaches its stop; below 0 if it does not."""
    spin = acting_spin(shape)
    if spin == 0.0 or shape["turn_limited"] == 0:
        return -1.0
    stop = float(shape["turn_high"]) if spin > 0.0 else float(shape["turn_low"])
    return (stop - float(shape["orientation"])) / spin


def span_length(state: StateRow, shapes: Table[ShapeRow], order: Table[int], left: float) -> float:
    """The time until the next kinematic shape stops or arrives, or what is `left` of the substep if none does."""
    span = left
    for k in range(state["fixed"], state["shapes"]):
        for time in (time_to_stop(shapes[order[k]]), float(shapes[order[k]]["time_left"])):
            if 0.0 < time < span:
                span = time
    return span


def set_shapes_going(state: StateRow, balls: Table[BallRow], shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Note how the kinematic shapes move in the span, and wake the balls in their way."""
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        set_before(shape)
        shape["spin"] = acting_spin(shape)
        if state["sleeping"] > 0 and is_moving(shape):
            left, bottom, right, top = span_box(shape, float(state["span"]))
            wake_in_box(state, balls, left, bottom, right, top)


def move_shapes_on(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Move the kinematic shapes to where they are at the end of the span."""
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        span = float(state["span"])
        # A stop that is reached at the span's end is reached exactly, whatever the rounding of its time.
        if 0.0 < time_to_stop(shape) <= span * STOP_MARGIN:
            span = span * STOP_MARGIN
        if shape["motion"] == KINEMATIC and advance_pose(shape, span):
            state["moving_stale"] = 1
        rest(shape)


def begin_flights(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow]) -> bool:
    """True if the balls, now ready to fly, are so many that what may meet in the span is looked for at once.

    `state["bin_levels"]` is 0 where no ball can meet another.
    """
    for i in range(state["balls"]):
        begin_flight(state, balls[i], flights[i])
    state["queued"] = 0
    state["binned"] = 0
    state["swept"] = 0
    state["bin_levels"] = 1 if state["balls"] > 1 and may_meet(state, balls) else 0
    return bool(state["balls"] > FEW_BALLS and state["bin_levels"] != 0)


def sweep_pairs(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    slots: Table[SlotRow],
    starts: Table[int],
    pairs: Pairs,
) -> bool:
    """True when `pairs` are all that may meet in the span, or the balls are too fast for that; False: no room."""
    way = 0.0
    smallest = float(balls[0]["radius"])
    for i in range(state["balls"]):
        way = max(way, top_speed(balls[i], flights[i], float(state["span"])) * float(state["span"]))
        smallest = min(smallest, float(balls[i]["radius"]))
    if way > SWEEP_MOST * smallest:
        return True
    count = pairs_by_grid(state, balls, (slots, starts, pairs), way * SWEEP_ROUNDING)
    if count < 0:
        return False
    state["pairs"] = count
    state["swept"] = 1
    return True
