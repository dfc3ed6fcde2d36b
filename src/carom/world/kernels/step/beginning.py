"""The beginning of a step: bad state is refused, and what the step may change is kept."""

from __future__ import annotations

from math import inf

from carom.constants import FEW_TO_ASK, FEW_TO_SORT
from carom.geometry.vector import larger, smaller
from carom.rows.ball import OF_WORLD, BallRow
from carom.rows.index import IndexRow, SlotRow
from carom.rows.pose import is_at_rest
from carom.rows.relation import RelationRow
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import CHANGED, DONE, GRID, MOVE, NOT_FINITE, OTHER_REACH, REFUSED, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import lay_grid
from carom.world.kernels.broad_phase.shape_index import MOVING
from carom.world.kernels.step.calm import is_calm
from carom.world.kernels.step.motion import launch_ball, moved, note_met, wake_all
from carom.world.kernels.step.rollback import call_back, save, save_ball, save_balls
from carom.world.kernels.step.soundness import is_good, is_in_reach, is_measured, is_sound
from carom.world.kernels.step.times import substep_length


def begin_step(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    slots: Table[SlotRow],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
    index: Table[IndexRow],
) -> int:
    """DONE when the state was found good and is saved; NOT_FINITE or REFUSED, with nothing changed, where it is bad.

    Of more than a few balls, none of which sleeps, the first substep's move is made already: see `look_at_balls`.
    """
    state = states[0]
    status, largest, braked = look_at_balls(state, balls, slots, saved)
    if status != DONE:
        return status
    if state["sleeping"] > 0:
        if state["wake"] == 0 and was_changed(state, balls, saved):
            state["wake"] = CHANGED
        save_balls(state, balls, saved)
    state["step_hits"] = state["hits"]
    list_restless(state, shapes, order, index[MOVING])
    save(states, shapes, order, relations)
    # From here on `roll_back` undoes what has been done, until then `call_back`.
    state["stage"] = MOVE
    state["cursor"] = 0
    if state["wake"] != 0:
        wake_all(state, balls)
        state["wake"] = 0
    # An index for larger balls serves smaller ones; it is made anew when it serves far larger ones than there are.
    if largest > state["reach"] or largest * 4.0 < state["reach"]:
        state["reach"] = largest
        if state["index_stale"] == 0:
            state["index_stale"] = OTHER_REACH
    state["substep"] = 0
    state["outside"] = 0
    state["braked"] = braked
    state["stage_entered"] = 0
    return DONE


def list_restless(state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow) -> None:
    """List the kinematic shapes that do not rest in `order`, behind all shapes; a step does nothing to the others.

    Where nothing was set of any of them since the last step, those alone can be in it that were. Calm ones come
    last: `entry`, that of the kinematic shapes' index, says how many those are; none where more balls are to be asked.
    """
    count, found, busy = int(state["shapes"]), 0, 0
    duration, substeps = substep_length(state), int(state["substeps"])
    changed = state["moving_stale"] != 0
    begin, end = (int(state["fixed"]), count) if changed else (count, count + int(state["movers"]))
    for k in range(begin, end):
        row = order[k]
        shape = shapes[row]
        # What is not where numbers reach is listed too: the step is refused for it.
        if not (is_at_rest(shape) and is_in_reach(shape)):
            order[count + found] = row
            if not is_calm(shape, duration, substeps):
                order[count + found] = order[count + busy]
                order[count + busy] = row
                busy += 1
            found += 1
    state["movers"] = found
    entry["calm"] = found - busy if state["balls"] <= max(FEW_TO_ASK, found - busy) else 0


def look_at_balls(
    state: StateRow, balls: Table[BallRow], slots: Table[SlotRow], saved: Table[SavedRow]
) -> tuple[int, float, int]:  # fmt: skip
    """DONE, or what is wrong with a ball; the largest radius, and how many balls have a friction of their own.

    Where none sleeps nobody will ask what was kept of the balls before, so what a step may change in them is kept in
    the same go; and more than a few are moved in it to where they come to in the first substep, shapes aside:
    `state["met_noted"]` says so. Around these places a grid is laid where one serves.
    """
    awake = state["sleeping"] == 0
    ahead = awake and state["balls"] > FEW_TO_SORT
    duration = substep_length(state)
    gravity_x, gravity_y = float(state["gravity_x"]), float(state["gravity_y"])
    left, bottom, right, top = inf, inf, -inf, -inf
    smallest, largest = inf, 0.0
    braked = 0
    state["cursor"] = 0
    total = int(state["balls"])
    for i in range(total):
        ball = balls[i]
        if not is_good(ball):
            call_back(state, balls, saved)
            return (REFUSED if is_sound(ball) and is_measured(ball) else NOT_FINITE), largest, braked
        radius = float(ball["radius"])
        smallest, largest = smaller(smallest, radius), larger(largest, radius)
        braked += int(ball["friction"] != OF_WORLD)
        kept = saved[i]
        if ahead:
            # All is read before anything is written, so that neighbouring numbers go together.
            x, y, vx, vy = moved(ball, duration, gravity_x, gravity_y)
            save_ball(ball, kept)
            state["cursor"] = i + 1
            launch_ball(ball, kept, slots[total + i], i, x, y, vx, vy)
            left, bottom = smaller(left, x), smaller(bottom, y)
            right, top = larger(right, x), larger(top, y)
        elif awake:
            save_ball(ball, kept)
            note_met(kept, ball)
    state["grid_size"] = 0
    if ahead and state["broad_phase"] == GRID:
        lay_grid(state, left, bottom, right, top, smallest, largest)
    state["met_noted"] = int(ahead)
    # Those that are found in a grid, and keep their velocities, are sound still.
    state["doubtful"] = int(state["grid_size"] == 0 or gravity_x != 0.0 or gravity_y != 0.0)
    return DONE, largest, braked


def was_changed(state: StateRow, balls: Table[BallRow], saved: Table[SavedRow]) -> bool:
    """True if a ball is not as the last step left it: it was changed through a view."""
    for i in range(state["balls"]):
        ball, kept = balls[i], saved[i]
        if ball["x"] != kept["x"] or ball["y"] != kept["y"] or ball["vx"] != kept["vx"] or ball["vy"] != kept["vy"]:
            return True
    return False
