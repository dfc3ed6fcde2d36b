"""The beginning and the end of a step: bad state is refused, and a step that fails leaves everything as it was."""

from __future__ import annotations

from math import inf

from carom.constants import FEW_TO_SORT
from carom.geometry.vector import larger, smaller
from carom.rows.ball import OF_WORLD, BallRow
from carom.rows.pose import is_at_rest
from carom.rows.relation import RelationRow
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import (
    BEGIN,
    DONE,
    GRID,
    HAS_STRAYS,
    MOVE,
    NOT_FINITE,
    OTHER_REACH,
    REFUSED,
    STALE,
    StateRow,
)
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import lay_grid
from carom.world.kernels.step.motion import moved, unsoundness, wake_all
from carom.world.kernels.step.spending import keep_spent, unspend
from carom.world.kernels.step.times import substep_length


def is_finite(value: float) -> bool:
    """True unless the value is infinite or NaN."""
    # Infinity minus itself is NaN, and NaN equals nothing.
    return value - value == 0.0


def is_sound(ball: BallRow) -> bool:
    """True if a ball's place and velocity are finite."""
    return unsoundness(float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])) == 0.0


def balls_are_sound(state: StateRow, balls: Table[BallRow]) -> bool:
    """True if the places and velocities of all balls are finite."""
    lost = 0.0
    for i in range(state["balls"]):
        ball = balls[i]
        lost += unsoundness(float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"]))
    return lost == 0.0


def is_measured(ball: BallRow) -> bool:
    """True if a ball's radius, mass, elasticity and friction are finite."""
    size = is_finite(float(ball["radius"])) and is_finite(float(ball["mass"]))
    return size and is_finite(float(ball["elasticity"])) and is_finite(float(ball["friction"]))


def is_good(ball: BallRow) -> bool:
    """True if a ball is sound, and its radius, mass, elasticity and friction are finite and what they may be."""
    radius, mass = float(ball["radius"]), float(ball["mass"])
    elasticity, friction = float(ball["elasticity"]), float(ball["friction"])
    fit = radius > 0.0 and mass > 0.0 and elasticity >= 0.0 and (friction == OF_WORLD or friction >= 0.0)
    # Zero times what is not finite is NaN, so this is zero if all are finite.
    motion = 0.0 * float(ball["x"]) * float(ball["y"]) * float(ball["vx"]) * float(ball["vy"])
    return fit and motion * radius * mass * elasticity * friction == 0.0


def is_in_reach(shape: ShapeRow) -> bool:
    """True if a shape is where numbers reach."""
    low = is_finite(float(shape["left"])) and is_finite(float(shape["bottom"]))
    return low and is_finite(float(shape["right"])) and is_finite(float(shape["top"]))


def shapes_are_sound(shapes: Table[ShapeRow], order: Table[int], begin: int, end: int) -> bool:
    """True if the shapes `order[begin:end]` are where numbers reach."""
    sound = True
    for k in range(begin, end):
        sound = sound and is_in_reach(shapes[order[k]])
    return sound


def begin_step(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when the state was found good and is saved; NOT_FINITE or REFUSED, with nothing changed, where it is bad."""
    state = states[0]
    status, largest, braked = look_at_balls(state, balls, saved)
    if status != DONE:
        return status
    if state["sleeping"] > 0:
        if state["wake"] == 0 and was_changed(state, balls, saved):
            state["wake"] = 1
        save_balls(state, balls, saved)
    state["step_hits"] = state["hits"]
    list_restless(state, shapes, order)
    save(states, shapes, order, relations)
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
    state["stage"] = MOVE
    return DONE


def list_restless(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """List the kinematic shapes that do not rest in `order`, behind all shapes; a step does nothing to the others.

    Where nothing was set of any of them since the last step, those alone can be in it that were.
    """
    count, found = int(state["shapes"]), 0
    changed = state["moving_stale"] != 0 or state["index_stale"] != 0
    begin, end = (int(state["fixed"]), count) if changed else (count, count + int(state["movers"]))
    for k in range(begin, end):
        shape = shapes[order[k]]
        # What is not where numbers reach is listed too: the step is refused for it.
        if not (is_at_rest(shape) and is_in_reach(shape)):
            order[count + found] = order[k]
            found += 1
    state["movers"] = found


def look_at_balls(
    state: StateRow, balls: Table[BallRow], saved: Table[SavedRow]
) -> tuple[int, float, int]:  # fmt: skip
    """DONE, or what is wrong with a ball; the largest radius, and how many balls have a friction of their own.

    Where none sleeps nobody will ask what was kept of the balls before, so what a step may change in them is kept in
    the same go; of more than a few also where they come to in the first substep, shapes aside: `state["met_noted"]`
    says so. Around these places a grid is laid where one serves.
    """
    awake = state["sleeping"] == 0
    ahead = awake and state["balls"] > FEW_TO_SORT
    duration = substep_length(state)
    gravity_x, gravity_y = float(state["gravity_x"]), float(state["gravity_y"])
    left, bottom, right, top = inf, inf, -inf, -inf
    smallest, largest = inf, 0.0
    braked = 0
    for i in range(state["balls"]):
        ball = balls[i]
        if not is_good(ball):
            return (REFUSED if is_sound(ball) and is_measured(ball) else NOT_FINITE), largest, braked
        radius = float(ball["radius"])
        smallest, largest = smaller(smallest, radius), larger(largest, radius)
        braked += int(ball["friction"] != OF_WORLD)
        kept = saved[i]
        if awake:
            save_ball(ball, kept)
        if ahead:
            x, y, _vx, _vy = moved(ball, duration, gravity_x, gravity_y)
            kept["met_x"] = x
            kept["met_y"] = y
            left, bottom = smaller(left, x), smaller(bottom, y)
            right, top = larger(right, x), larger(top, y)
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


def save_balls(state: StateRow, balls: Table[BallRow], saved: Table[SavedRow]) -> None:
    """Keep what a step may change in the balls."""
    for i in range(state["balls"]):
        save_ball(balls[i], saved[i])


def save_ball(ball: BallRow, kept: SavedRow) -> None:
    """The same of one ball."""
    kept["x"] = ball["x"]
    kept["y"] = ball["y"]
    kept["vx"] = ball["vx"]
    kept["vy"] = ball["vy"]
    kept["still_time"] = ball["still_time"]
    kept["relation"] = ball["relation"]
    kept["asleep"] = ball["asleep"]
    kept["stray"] = ball["stray"]
    kept["touched"] = 0
    kept["met_x"] = ball["x"]
    kept["met_y"] = ball["y"]


def save(
    states: Table[StateRow], shapes: Table[ShapeRow], order: Table[int], relations: Table[RelationRow]
) -> None:  # fmt: skip
    """Keep what a step may change but balls: state, shapes that move (behind the shapes), relations (upper half)."""
    state = states[0]
    count = int(state["shapes"])
    for k in range(count, count + state["movers"]):
        # Others do not change in a step but by switching themselves off, so they need no copy.
        shapes[k] = shapes[order[k]]
    # The whole pool in use is copied, free rows too: they are linked by their numbers.
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[half + k] = relations[k]
    states[1] = states[0]


def roll_back(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> None:
    """Put everything back to where it was when `save` was called; the copies tell what was not finite any more."""
    spent = int(states[0]["spent"])
    states[0] = states[1]
    state = states[0]
    for i in range(state["balls"]):
        ball, kept = balls[i], saved[i]
        # Python names the ball in the error, so the copy keeps which one it was.
        kept["overflowed"] = 0 if is_sound(ball) else 1
        ball["x"] = kept["x"]
        ball["y"] = kept["y"]
        ball["vx"] = kept["vx"]
        ball["vy"] = kept["vy"]
        ball["still_time"] = kept["still_time"]
        ball["relation"] = kept["relation"]
        ball["asleep"] = kept["asleep"]
        ball["stray"] = kept["stray"]
    count = int(state["shapes"])
    for k in range(count, count + state["movers"]):
        sound = is_in_reach(shapes[order[k]])
        shapes[order[k]] = shapes[k]
        shapes[k]["once"] = 0 if sound else 1
    for k in range(count + state["movers"], 2 * count - state["fixed"]):
        shapes[k]["once"] = 0
    if spent > 0:
        unspend(shapes, count)
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[k] = relations[half + k]
    # The index holds shapes where the failed step had moved them.
    state["index_stale"] = STALE
    state["moving_stale"] = STALE


def end_step(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when the step is complete; HAS_STRAYS if balls are to be removed; NOT_FINITE if it was rolled back."""
    state = states[0]
    if state["doubtful"] != 0 and not balls_are_sound(state, balls):
        roll_back(states, balls, shapes, order, saved, relations)
        return NOT_FINITE
    if state["bounded"] != 0:
        find_strays(state, balls)
    if state["sleeping"] > 0:
        # The next step compares with this, to see what was changed through a view while something slept.
        save_balls(state, balls, saved)
    state["time"] += state["dt"]
    keep_spent(state, shapes)
    state["steps_made"] += 1
    state["steps_left"] = 0 if 0 < state["stop_hits"] <= state["hits"] else state["steps_left"] - 1
    state["stage"] = BEGIN
    return HAS_STRAYS if state["outside"] > 0 and state["remove_strays"] != 0 else DONE


def find_strays(state: StateRow, balls: Table[BallRow]) -> None:
    """Mark and count the balls that lie wholly outside of the bounds; those that did not before count as strays."""
    left, bottom = float(state["left"]), float(state["bottom"])
    right, top = float(state["right"]), float(state["top"])
    for i in range(state["balls"]):
        ball = balls[i]
        x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
        outside = x + radius < left or x - radius > right or y + radius < bottom or y - radius > top
        if outside:
            state["outside"] += 1
            # A stray counts once, when it leaves, not in every step that it is out.
            state["strays"] += 1 - ball["stray"]
        ball["stray"] = 1 if outside else 0
