"""Kinematic shapes in the film: each moves evenly since an instant, until it stops, arrives or is changed.

While a step is made their rows stand as at that instant; between two steps they show where the shapes are.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import FARTHEST_CROSSING, LEAST_SQUARE, STOP_MARGIN
from carom.geometry.instants import is_before, later
from carom.rows.pose import acting_spin, advance_pose, is_moving, pose, rest, set_before
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import age_of_mover


def begin_motion(shape: ShapeRow, time: float, low: float) -> None:
    """Let a shape move from an instant on as its row says, from where it stands."""
    set_before(shape)
    shape["time_left_before"] = shape["time_left"]
    shape["spin"] = acting_spin(shape)
    if shape["rotating"] and shape["spin"] == 0.0:
        # It is pressed against its stop.
        shape["angular_velocity"] = 0.0
    shape["since"] = time
    shape["since_low"] = low


def begin_motions(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Let all kinematic shapes move on from now as their rows say."""
    for k in range(state["fixed"], state["shapes"]):
        begin_motion(shapes[order[k]], float(state["now"]), float(state["now_low"]))
    state["moving_stale"] = STALE
    list_movers(state, shapes, order)


def is_restless(shape: ShapeRow) -> bool:
    """True if a shape moves, or is to arrive somewhere."""
    return is_moving(shape) or bool(shape["time_left_before"] > 0.0)


def list_movers(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """List the kinematic shapes that move in `order`, behind all shapes; steps do nothing to the others."""
    count, found = int(state["shapes"]), 0
    for k in range(state["fixed"], count):
        if is_restless(shapes[order[k]]):
            order[count + found] = order[k]
            found += 1
    state["movers"] = found


def unlist_resting(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Take out of that list what has come to rest."""
    count, found = int(state["shapes"]), 0
    for k in range(count, count + state["movers"]):
        if is_restless(shapes[order[k]]):
            order[count + found] = order[k]
            found += 1
    state["movers"] = found


def are_tame(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> bool:
    """True if no kinematic shape is so far out, or so fast, that numbers may not reach it when the step ends."""
    tame, horizon = True, float(state["horizon"])
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        out = fabs(float(shape["pivot_before_x"])) + fabs(float(shape["pivot_before_y"]))
        size = fabs(float(shape["left"])) + fabs(float(shape["bottom"]))
        size += fabs(float(shape["right"])) + fabs(float(shape["top"]))
        fast = fabs(float(shape["velocity_x"])) + fabs(float(shape["velocity_y"])) + fabs(float(shape["spin"]))
        # No motion has begun before time 0.
        far = out + size + fabs(float(shape["orientation_before"])) + fast * horizon
        tame = tame and far < FARTHEST_CROSSING
    return tame


def time_to_stop(shape: ShapeRow) -> float:
    """The seconds from a turning shape's beginning in which it reaches its stop; below 0 if it does not."""
    spin = float(shape["spin"])
    if spin == 0.0 or shape["turn_limited"] == 0:
        return -1.0
    stop = float(shape["turn_high"]) if spin > 0.0 else float(shape["turn_low"])
    return (stop - float(shape["orientation_before"])) / spin


def time_to_change(shape: ShapeRow) -> float:
    """The seconds from a shape's beginning after which it stops or arrives; infinite if it moves on for ever."""
    first = inf
    for time in (time_to_stop(shape), float(shape["time_left_before"])):
        if 0.0 < time < first:
            first = time
    return first


def foresee_changes(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Find the instant at which the next shape stops or arrives."""
    state["change"] = inf
    state["change_low"] = 0.0
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        wait = time_to_change(shape)
        if wait < inf:
            time, low = later(float(shape["since"]), float(shape["since_low"]), wait)
            if is_before(time, low, float(state["change"]), float(state["change_low"])):
                state["change"] = time
                state["change_low"] = low


def change_movers(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Let the shapes that stop or arrive now do so, and move on from here as they do then."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        wait = time_to_change(shape)
        if wait == inf:
            continue
        time, low = later(float(shape["since"]), float(shape["since_low"]), wait)
        if not is_before(float(state["now"]), float(state["now_low"]), time, low):
            # A stop is reached exactly, whatever the rounding of its time.
            go_on(shape, wait * STOP_MARGIN)
            rest(shape)
            begin_motion(shape, float(state["now"]), float(state["now_low"]))
            state["moving_stale"] = STALE
    foresee_changes(state, shapes, order)


def go_on(shape: ShapeRow, seconds: float) -> None:
    """Put a shape, which stands as its motion began, to where it is so many seconds later."""
    shape["time_left"] = shape["time_left_before"]
    if shape["motion"] == KINEMATIC:
        advance_pose(shape, seconds)


def show_movers(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Put the kinematic shapes to where they are now; where their motion began stays known."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        if is_moving(shape):
            age = age_of_mover(state, shape)
            shape["orientation"] = orientation_at(shape, age)
            shape["pivot_x"] = float(shape["pivot_before_x"]) + float(shape["velocity_x"]) * age
            shape["pivot_y"] = float(shape["pivot_before_y"]) + float(shape["velocity_y"]) * age
            if shape["time_left_before"] > 0.0:
                # It is on its way still, so there is some time left, if less than rounding.
                shape["time_left"] = max(float(shape["time_left_before"]) - age, LEAST_SQUARE)
            pose(shape)


def orientation_at(shape: ShapeRow, age: float) -> float:
    """How far a shape has turned at an age of its motion; not beyond its stops."""
    orientation = float(shape["orientation_before"]) + float(shape["spin"]) * age
    if shape["turn_limited"] != 0:
        return min(max(orientation, float(shape["turn_low"])), float(shape["turn_high"]))
    return orientation


def take_back(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Put the kinematic shapes, which the rows show as they are now, back to where their motion began."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        if is_moving(shape):
            shape["orientation"] = shape["orientation_before"]
            shape["pivot_x"] = shape["pivot_before_x"]
            shape["pivot_y"] = shape["pivot_before_y"]
            shape["time_left"] = shape["time_left_before"]
            pose(shape)
