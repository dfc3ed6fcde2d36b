"""Kinematic shapes in the film: each moves evenly since an instant, until it stops, arrives or is changed.

While a step is made their rows stand as at that instant; between two steps they show where the shapes are.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import FARTHEST_CROSSING, LEAST_SQUARE, STOP_MARGIN
from carom.geometry.instants import is_before, later
from carom.rows.pose import POSED, acting_spin, advance, is_moving, pose, rest, set_before
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import age_of_mover


def begin_motion(shape: ShapeRow, time: float, low: float) -> None:
    """Let a shape move from an instant on as its row says, from where it stands."""
    set_before(shape)
    shape["time_left_before"] = shape["time_left"]
    shape["velocity_before_x"] = shape["velocity_x"]
    shape["velocity_before_y"] = shape["velocity_y"]
    shape["spin"] = acting_spin(shape)
    shape["since"] = time
    shape["since_low"] = low


def take_up_changed(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Put all kinematic shapes, which the rows show, back to where their motion began, or let them begin another one.

    Another one begin those that were put elsewhere or set to move otherwise, from where they are seen.
    """
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        if shape["rotating"] and shape["spin"] == 0.0 and acting_spin(shape) == 0.0:
            # It is pressed against its stop.
            shape["angular_velocity"] = 0.0
        if moves_as_before(state, shape):
            take_back_mover(shape)
        else:
            begin_motion(shape, float(state["now"]), float(state["now_low"]))
    state["moving_stale"] = STALE
    list_movers(state, shapes, order)


def moves_as_before(state: StateRow, shape: ShapeRow) -> bool:
    """True if a kinematic shape, whose row shows it, is where its motion has brought it, and is to move on likewise."""
    age = age_of_mover(state, shape)
    x, y = pivot_at(shape, age)
    same_place = shape["pivot_x"] == x and shape["pivot_y"] == y and shape["orientation"] == orientation_at(shape, age)
    same_x = shape["velocity_x"] == shape["velocity_before_x"]
    # At its stop it is to turn on still, until it has been dealt with that it is there.
    spin = shape["angular_velocity"] if shape["rotating"] != 0 else 0.0
    same_speed = same_x and shape["velocity_y"] == shape["velocity_before_y"] and shape["spin"] == spin
    return bool(same_place and same_speed and shape["time_left"] == time_left_at(shape, age))


def begins_to_move(state: StateRow, shape: ShapeRow) -> bool:
    """True if a kinematic shape's motion begins at the instant that the film is shown."""
    kinematic = shape["motion"] == KINEMATIC
    return bool(kinematic and shape["since"] == state["now"] and shape["since_low"] == state["now_low"])


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


def changes_now(state: StateRow, shape: ShapeRow) -> bool:
    """True if a shape has come to its stop or to where it was sent at the instant that the film is shown."""
    wait = time_to_change(shape)
    if wait == inf:
        return False
    time, low = later(float(shape["since"]), float(shape["since_low"]), wait)
    return not is_before(float(state["now"]), float(state["now_low"]), time, low)


def change_movers(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Let the shapes that stop or arrive now do so, and move on from here as they do then."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        if changes_now(state, shape):
            stop_or_arrive(shape, time_to_change(shape))
            rest(shape)
            begin_motion(shape, float(state["now"]), float(state["now_low"]))
            state["moving_stale"] = STALE
    foresee_changes(state, shapes, order)


def stop_or_arrive(shape: ShapeRow, seconds: float) -> None:
    """Put a shape, which stands as its motion began, to its stop or to where it was sent, so many seconds later."""
    shape["time_left"] = shape["time_left_before"]
    # A stop is reached exactly, whatever the rounding of its time; how far it has travelled says that time alone.
    if advance(shape, seconds * STOP_MARGIN) == POSED:
        return
    x, y = pivot_at(shape, seconds)
    shape["pivot_x"] = x
    shape["pivot_y"] = y
    shape["time_left"] = time_left_at(shape, seconds)
    pose(shape)


def show_movers(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Put the kinematic shapes to where they are now; where their motion began stays known."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        shape = shapes[order[k]]
        if is_moving(shape):
            age = age_of_mover(state, shape)
            x, y = pivot_at(shape, age)
            shape["orientation"] = orientation_at(shape, age)
            shape["pivot_x"] = x
            shape["pivot_y"] = y
            shape["time_left"] = time_left_at(shape, age)
            pose(shape)


def pivot_at(shape: ShapeRow, age: float) -> tuple[float, float]:
    """Where a shape's pivot is at an age of its motion."""
    x = float(shape["pivot_before_x"]) + float(shape["velocity_before_x"]) * age
    y = float(shape["pivot_before_y"]) + float(shape["velocity_before_y"]) * age
    return x, y


def time_left_at(shape: ShapeRow, age: float) -> float:
    """The seconds after which a shape is where it was sent, at an age of its motion; 0 if it was sent nowhere."""
    left = float(shape["time_left_before"])
    # On its way still, there is some time left, if less than rounding; what rests there already counts none.
    return max(left - age, LEAST_SQUARE) if left > 0.0 and is_moving(shape) else left


def orientation_at(shape: ShapeRow, age: float) -> float:
    """How far a shape has turned at an age of its motion; not beyond its stops."""
    orientation = float(shape["orientation_before"]) + float(shape["spin"]) * age
    if shape["turn_limited"] != 0:
        return min(max(orientation, float(shape["turn_low"])), float(shape["turn_high"]))
    return orientation


def take_back(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Put the kinematic shapes, which the rows show as they are now, back to where their motion began."""
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        take_back_mover(shapes[order[k]])


def take_back_mover(shape: ShapeRow) -> None:
    """Put one back."""
    if is_moving(shape):
        shape["orientation"] = shape["orientation_before"]
        shape["pivot_x"] = shape["pivot_before_x"]
        shape["pivot_y"] = shape["pivot_before_y"]
        shape["time_left"] = shape["time_left_before"]
        pose(shape)
