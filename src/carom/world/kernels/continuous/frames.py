"""Between two steps: what users have changed in the film is taken up, and a step that fails is undone."""

from __future__ import annotations

from carom.constants import NEVER
from carom.geometry.instants import is_before, later
from carom.geometry.path import Path
from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, FLYING, IN_PART, NO_SHAPE, NO_TICK, FlightRow
from carom.rows.hit import HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import BodyRow
from carom.rows.relation import LASTING, NO_RELATION, RelationRow
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import (
    BEGIN,
    CHANGED,
    DONE,
    FLY,
    FORESEE,
    HAS_STRAYS,
    MOTIONS_CHANGED,
    MOVE,
    MOVERS,
    NEEDS_PAIRS,
    NEEDS_ROOM,
    NOT_FINITE,
    NOTE,
    STALE,
    TAKE_UP,
    TOO_MANY_IMPACTS,
    UNCHANGED,
    WHOLE,
    StateRow,
)
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING
from carom.world.kernels.continuous.arrival import copy_course, energy_of, note_all_passing
from carom.world.kernels.continuous.flight import age_now, place_after
from carom.world.kernels.continuous.island import hasten, lies, part_from_all
from carom.world.kernels.continuous.lasting import hold
from carom.world.kernels.continuous.movers import (
    are_tame,
    begins_to_move,
    foresee_changes,
    list_movers,
    show_movers,
    take_back,
    take_up_changed,
    unlist_resting,
)
from carom.world.kernels.continuous.regions import rebuild_regions
from carom.world.kernels.continuous.showing import (
    age_shown,
    is_as_shown,
    is_shown_sound,
    is_where_shown,
    look_at_balls,
    show,
    show_as_seen,
    take_back_ball,
)
from carom.world.kernels.continuous.straying import count_out, removes_strays
from carom.world.kernels.step.ending import end_relations
from carom.world.kernels.step.motion import unsoundness, wake_all
from carom.world.kernels.step.relations import relations_room
from carom.world.kernels.step.soundness import is_in_reach, shapes_are_sound
from carom.world.kernels.step.spending import keep_spent, unspend
from carom.world.kernels.step.stages import enter_stage


def begin_film_step(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> int:
    """DONE when the horizon is set and what was changed is known; NOT_FINITE or REFUSED where the state is bad.

    In the later steps of a call nothing can have been changed: then the film just goes on.
    """
    state = states[0]
    changed = False
    if state["running"] == 0:
        bad, changed = look_at_balls(state, balls, flights)
        if bad != DONE:
            return bad
        if state["sleeping"] > 0 and changed and state["wake"] == 0:
            state["wake"] = CHANGED
        if state["index_stale"] + state["taken"] + state["put"] > 0:
            state["foreseen"] = 0
    state["step_hits"] = state["hits"]
    state["step_number"] += 1
    state["now"] = state["time"]
    state["now_low"] = state["time_low"]
    horizon, horizon_low = later(float(state["time"]), float(state["time_low"]), float(state["dt"]))
    state["horizon"] = horizon
    state["horizon_low"] = horizon_low
    keep_tables(states, shapes, order, relations)
    state["substep"] = 0
    if state["running"] != 0:
        enter_stage(state, FLY)
    elif changed:
        state["foreseen"] = 0
        take_up_motions(state, shapes, order)
        enter_stage(state, NOTE)
    else:
        enter_stage(state, TAKE_UP)
        state["running"] = 1
    return DONE


def take_up_motions(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> None:
    """Have kinematic shapes move on as they did; anew from now those of which it was changed where or how."""
    if state["wake"] == MOTIONS_CHANGED:
        take_up_changed(state, shapes, order)
    else:
        take_back(state, shapes, order)


def keep_tables(
    states: Table[StateRow], shapes: Table[ShapeRow], order: Table[int], relations: Table[RelationRow]
) -> None:
    """Keep all that a step may change but for the balls: state, relations, and the kinematic shapes that move.

    Or all kinematic ones, where any of them was changed from outside; and none in a step in which none stops or
    arrives, which can be shown again as they were.
    """
    state = states[0]
    whole = state["wake"] == MOTIONS_CHANGED
    state["kept_whole"] = WHOLE if whole else UNCHANGED if is_none_to_change(state, shapes, order) else MOVERS
    if state["kept_whole"] != UNCHANGED:
        unlist_resting(state, shapes, order)
    count = int(state["shapes"])
    begin, end = kept_shapes(state)
    for k in range(begin, end):
        shapes[count + k - begin] = shapes[order[k]]
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[half + k] = relations[k]
    states[1] = states[0]


def is_none_to_change(state: StateRow, shapes: Table[ShapeRow], order: Table[int]) -> bool:
    """True if kinematic shapes move, all evenly in the step, and where it may show them, numbers reach them all."""
    horizon, horizon_low = float(state["horizon"]), float(state["horizon_low"])
    change, change_low = float(state["change"]), float(state["change_low"])
    if state["movers"] == 0 or not is_before(horizon, horizon_low, change, change_low):
        return False
    return not may_be_last(state) or are_tame(state, shapes, order)


def may_be_last(state: StateRow) -> bool:
    """True if a step that begins may be the last one of its call, which shows where everything is."""
    stops = state["stop_hits"] > 0 or state["max_impacts"] > 0
    return bool(state["steps_left"] == 1 or removes_strays(state) or stops)


def kept_shapes(state: StateRow) -> tuple[int, int]:
    """Where those kinematic shapes begin and end in `order` that were copied when the step began."""
    count = int(state["shapes"])
    if state["kept_whole"] == WHOLE:
        return int(state["fixed"]), count
    return count, count + (int(state["movers"]) if state["kept_whole"] == MOVERS else 0)


def shown_shapes(state: StateRow) -> tuple[int, int]:
    """The same of those that may not be sound when they are shown."""
    count = int(state["shapes"])
    return kept_shapes(state) if state["kept_whole"] == WHOLE else (count, count + int(state["movers"]))


def note_passed(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> int:
    """DONE when balls in flight that have come onto shapes past their ends pass them, before anything is parted.

    NEEDS_ROOM where relations ran out, NEEDS_PAIRS where the index of shapes lacks room.
    """
    if not rebuild_regions(state, balls, shapes, order, (index, cells, members)):
        return NEEDS_PAIRS
    most = int(index[FIXED]["longest"] + index[MOVING]["longest"])
    for i in range(state["cursor"], state["balls"]):
        ball, flight = balls[i], flights[i]
        state["cursor"] = i
        if relations_room(state, relations) < most:
            state["wanted_hits"] = state["hits"]
            state["wanted_relations"] = state["relations"] + most
            return NEEDS_ROOM
        age = age_now(state, flight)
        moved = ball["x"] != flight["shown_x"] or ball["y"] != flight["shown_y"]
        if moved or abs(flight["id"]) != ball["id"] or flight["kind"] != FLYING or not age > 0.0:
            continue
        x, y, vx, vy = float(flight["x"]), float(flight["y"]), float(flight["vx"]), float(flight["vy"])
        path = Path(x, y, vx, vy, float(flight["ax"]), float(flight["ay"]))
        note_all_passing(
            state, ball, flight, i, shapes, (index, cells, members), relations, age, age, path, NO_SHAPE
        )  # fmt: skip
    show_movers(state, shapes, order)
    enter_stage(state, MOVE)
    return DONE


def take_up(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
) -> int:
    """DONE when every ball is on its flight again: on the one it was on, or a new one where something was changed."""
    if len(hits) - state["hits"] < state["relations"]:
        state["wanted_hits"] = state["hits"] + state["relations"]
        return NEEDS_ROOM
    if state["wake"] != 0:
        wake_all(state, balls)
        let_go_of_what_is_off(state, balls, shapes, hits, relations, flights)
    take_up_motions(state, shapes, order)
    what = int(state["wake"])
    state["wake"] = 0
    foresee_changes(state, shapes, order)
    if state["running"] == 0:
        take_up_balls(state, balls, shapes, relations, flights, bodies, what)
        state["running"] = 1
    enter_stage(state, FLY if state["foreseen"] != 0 else FORESEE)
    return DONE


def let_go_of_what_is_off(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> None:
    """End the relations of balls to what may not be met any more; a ball that has lost one is to begin a new flight."""
    for i in range(state["balls"]):
        if end_relations(state, balls, shapes, hits, relations, balls[i], float(state["now"])):
            keep_flight(state, flights, i)
            flights[i]["id"] = -abs(flights[i]["id"])


def take_up_balls(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
    what: int,
) -> None:
    """Put every ball back onto its flight, or begin a new one where the ball, or what holds it, was changed.

    `what` says how much was changed.
    """
    for i in range(state["balls"]):
        ball, flight = balls[i], flights[i]
        woken = flight["kind"] == ASLEEP and ball["asleep"] == 0
        held_otherwise = what != 0 and is_held_otherwise(state, ball, shapes, relations, what == MOTIONS_CHANGED)
        if is_as_shown(ball, flight) and not woken and not held_otherwise:
            take_back_ball(ball, flight)
        else:
            keep_flight(state, flights, i)
            flight["id"] = -ball["id"] if is_where_shown(ball, flight) else 0
    for i in range(state["balls"]):
        ball, flight = balls[i], flights[i]
        if flight["id"] == ball["id"]:
            continue
        if lies(relations, ball):
            # What lies on it has to be held otherwise.
            hasten(state, balls, flights, relations, bodies, i)
            if flight["id"] == 0:
                part_from_all(state, balls, relations, i)
        begin_anew(state, ball, flight)
        if lies(relations, ball):
            flight["tick_time"] = state["now"]
            flight["tick_low"] = state["now_low"]
        hold(state, ball, flight, shapes, relations, True)


def is_held_otherwise(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    motions_changed: bool,
) -> bool:
    """True if a shape holds a ball that begins to move otherwise now; or that kicks, as it does when there is room."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING:
            shape = shapes[relations[place]["other"]]
            if shape["kick"] > 0.0 or (motions_changed and begins_to_move(state, shape)):
                return True
        place = int(relations[place]["next"])
    return False


def keep_flight(state: StateRow, flights: Table[FlightRow], i: int) -> None:
    """Keep a flight as it was when the step began, once a step, for one that fails to go back to."""
    flight = flights[i]
    if flight["kept"] != state["step_number"]:
        flights[len(flights) // 2 + i] = flight
        flight["kept"] = state["step_number"]
        flight["impacts"] = 0


def begin_anew(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Begin the flight of a ball that was put where it is, now."""
    flight["id"] = ball["id"]
    flight["time"] = state["now"]
    flight["low"] = state["now_low"]
    flight["low_vx"] = 0.0
    flight["low_vy"] = 0.0
    flight["kind"] = ASLEEP if ball["asleep"] != 0 else FLYING
    flight["slow_for"] = ball["still_time"]
    flight["energy"] = energy_of(state, ball)
    flight["surplus"] = 0.0
    flight["quiet"] = 0
    flight["tick_time"] = NO_TICK
    flight["tick_low"] = 0.0
    flight["met_time"] = NEVER
    flight["met_low"] = 0.0
    flight["short"] = 0
    flight["at_once"] = 0
    flight["version"] += 1


def finish_frame(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> int:
    """DONE when the step has ended; the last one of a call shows where everything is. NOT_FINITE if it was undone."""
    state = states[0]
    state["now"] = state["horizon"]
    state["now_low"] = state["horizon_low"]
    stopped = is_stopped(state, flights)
    enough = 0 < state["stop_hits"] <= state["hits"]
    state["outside"] = count_out(state, balls)
    last = state["steps_left"] == 1 or stopped or enough or state["outside"] > 0
    sound = show(state, balls, shapes, relations, flights) if last else is_shown_sound(state, balls, flights)
    if not sound:
        undo(states, balls, shapes, order, saved, relations, flights)
        return NOT_FINITE
    if last:
        show_movers(state, shapes, order)
        state["running"] = 0
    begin, end = shown_shapes(state)
    # Others stand as their motion began.
    if (last or state["kept_whole"] != UNCHANGED) and not shapes_are_sound(shapes, order, begin, end):
        undo(states, balls, shapes, order, saved, relations, flights)
        return NOT_FINITE
    state["time"] = state["horizon"]
    state["time_low"] = state["horizon_low"]
    keep_spent(state, shapes)
    state["steps_made"] += 1
    state["steps_left"] = 0 if stopped or enough else state["steps_left"] - 1
    state["stage"] = BEGIN
    if stopped:
        return TOO_MANY_IMPACTS
    return HAS_STRAYS if state["outside"] > 0 else DONE


def is_stopped(state: StateRow, flights: Table[FlightRow]) -> bool:
    """True if a ball has had as many impacts in this step as there may be."""
    if state["max_impacts"] > 0:
        for i in range(state["balls"]):
            if flights[i]["kept"] == state["step_number"] and flights[i]["impacts"] >= state["max_impacts"]:
                return True
    return False


def undo(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> None:
    """Put everything back to what it was when the step began; the copies tell what was not finite any more."""
    number, spent = int(states[0]["step_number"]), int(states[0]["spent"])
    for i in range(states[0]["balls"]):
        sound = unsoundness(*place_after(balls[i], flights[i], age_shown(states[0], balls[i], flights[i]))) == 0.0
        saved[i]["overflowed"] = 0 if sound else 1
        if flights[i]["kept"] == number:
            go_back(balls[i], flights, i)
    states[0] = states[1]
    state = states[0]
    state["cursor"] = 0
    count = int(state["shapes"])
    begin, end = shown_shapes(state)
    for k in range(begin, end):
        row, copy = int(order[k]), count + k - begin
        sound = is_in_reach(shapes[row])
        if state["kept_whole"] == UNCHANGED:
            shapes[copy] = shapes[row]
        else:
            shapes[row] = shapes[copy]
        shapes[copy]["once"] = 0 if sound else 1
    for k in range(count + end - begin, 2 * count - state["fixed"]):
        shapes[k]["once"] = 0
    list_movers(state, shapes, order)
    if spent > 0:
        unspend(shapes, count)
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[k] = relations[half + k]
    if state["running"] == 0:
        show_as_seen(balls, flights, int(state["balls"]))
    else:
        show(state, balls, shapes, relations, flights)
    if state["running"] != 0 or state["kept_whole"] == UNCHANGED:
        show_movers(state, shapes, order)
    state["running"] = 0
    state["foreseen"] = 0
    state["index_stale"] = STALE
    state["moving_stale"] = STALE


def go_back(ball: BallRow, flights: Table[FlightRow], i: int) -> None:
    """Put a ball back onto the flight that it was on when the step began."""
    flight, copy = flights[i], flights[len(flights) // 2 + i]
    if copy["impacts"] == IN_PART:
        copy_course(copy, flight)
        # It was on this flight when the call began, so what was seen had been shown; showing it again may have failed.
        flight["shown_x"] = flight["seen_x"]
        flight["shown_y"] = flight["seen_y"]
        flight["shown_vx"] = flight["seen_vx"]
        flight["shown_vy"] = flight["seen_vy"]
    else:
        flights[i] = copy
    take_back_ball(ball, flight)
    ball["still_time"] = flight["still_time"]
    ball["relation"] = flight["relation"]
    ball["asleep"] = flight["asleep"]
    ball["stray"] = flight["stray"]
