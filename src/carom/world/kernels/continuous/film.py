"""A step in the continuous mode: it shows the film up to its end.

What happens is there before anyone looks. Every ball is on a flight, which changes only at an event of its own; every
prediction is a function of the flights concerned alone. So the state at an instant does not depend on the steps that
lead to it. Source: docs/modes.md.
"""

from __future__ import annotations

from carom.constants import EVENTS_BETWEEN_PAUSES, PARTING_ROUNDS
from carom.geometry.instants import is_before
from carom.rows.ball import BallRow
from carom.rows.flight import COPIED_LINES, EVENT_LINES, HIT_BALL, FlightRow, QueueRow
from carom.rows.hit import BOUNCE, HitRow
from carom.rows.index import CellRow, IndexRow, SlotRow
from carom.rows.island import BodyRow, IslandContactRow
from carom.rows.prefetch import prefetch, prefetch_lines
from carom.rows.relation import RelationRow
from carom.rows.saved import KEPT, PAIRS_DUE, SHAPES_DUE, SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import (
    BEGIN,
    DONE,
    FIND_PAIRS,
    FINISH,
    FLY,
    FORESEE,
    MOVE,
    NEEDS_PAIRS,
    NEEDS_ROOM,
    NOTE,
    PAIRS,
    PAUSE,
    SHAPES,
    SHOW,
    TAKE_UP,
    StateRow,
)
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING
from carom.world.kernels.continuous.bins import fit_bins
from carom.world.kernels.continuous.dropping import let_go
from carom.world.kernels.continuous.events import change_shapes, deal_with
from carom.world.kernels.continuous.frames import begin_film_step, finish_frame, note_passed, take_up
from carom.world.kernels.continuous.predict import predict_all
from carom.world.kernels.continuous.queue import front_of, row_of
from carom.world.kernels.continuous.regions import rebuild_regions
from carom.world.kernels.continuous.showing import is_as_shown
from carom.world.kernels.step.discrete import find_pairs, meet_all_pairs
from carom.world.kernels.step.relations import relations_room
from carom.world.kernels.step.rounds import meet_all_shapes
from carom.world.kernels.step.stages import enter_stage

#: Places at the front of the queue: the first one, the two of whom one comes next, and the four after them.
FRONT = 7

#: Lines of memory in which a ball's row lies, at most.
BALL_LINES = 2


def step_continuous(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    slots: Table[SlotRow],
    starts: Table[int],
    pairs: Pairs,
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    queue: Table[QueueRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
) -> int:
    """Why the kernel came back: DONE after `state["steps_left"]` steps, or what it needs to go on, as `step_discrete`.

    Balls that overlap because something was changed are first moved apart by the stages of the discrete mode.
    """
    state = states[0]
    state["events"] = 0
    while state["steps_left"] > 0:
        stage = state["stage"]
        if stage == BEGIN:
            status = begin_film_step(states, balls, shapes, order, relations, flights)
        elif stage == NOTE:
            status = note_passed(state, balls, shapes, order, index, cells, members, relations, flights)  # fmt: skip
        elif stage == MOVE or stage == SHAPES or stage == FIND_PAIRS or stage == PAIRS:
            status = part_overlaps(
                state, balls, shapes, (index, cells, members), (slots, starts, pairs), saved, hits, relations, flights
            )  # fmt: skip
        elif stage == TAKE_UP:
            status = take_up(state, balls, shapes, order, hits, relations, flights, island[0])
        elif stage == FORESEE:
            status = DONE
            if not rebuild_regions(state, balls, shapes, order, (index, cells, members)) or not predict_all(
                state, balls, shapes, order, index, cells, members, starts, relations, flights, queue
            ):
                status = NEEDS_PAIRS
            else:
                state["foreseen"] = 1
                enter_stage(state, FLY)
        elif stage == FLY:
            status = fly(
                state, balls, shapes, order, index, cells, members, starts, hits, relations, flights, queue, island
            )  # fmt: skip
        else:
            status = finish_frame(states, balls, shapes, order, saved, relations, flights)
        if status != DONE:
            return status
    return DONE


def part_overlaps(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    shape_index: tuple[Table[IndexRow], Table[CellRow], Table[int]],
    pair_index: tuple[Table[SlotRow], Table[int], Pairs],
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> int:
    """DONE when a stage has moved balls apart that overlap, and the next one is entered; else what it needs."""
    stage = state["stage"]
    _slots, _starts, pairs = pair_index
    status = DONE
    if stage == MOVE:
        begin_parting(state, balls, flights, saved)
    elif stage == SHAPES:
        status = meet_all_shapes(state, balls, shapes, shape_index, pair_index, saved, hits, relations)
    elif stage == FIND_PAIRS and state["balls"] < 2 and state["found"] == 0:
        enter_stage(state, TAKE_UP)
    elif stage == FIND_PAIRS:
        status = find_pairs(state, balls, shapes, shape_index, pair_index, saved)
    else:
        status = meet_all_pairs(state, balls, shapes, shape_index, pairs, saved, hits, relations)
    if state["stage"] == FINISH:
        enter_stage(state, after_parting(state))
    return status


def begin_parting(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], saved: Table[SavedRow]
) -> None:  # fmt: skip
    """Make all balls due to be moved apart from what they overlap; the index of shapes is right, see `note_passed`."""
    state["iteration"] = 0
    state["found"] = 0
    for i in range(state["balls"]):
        kept = KEPT if is_as_shown(balls[i], flights[i]) else 0
        saved[i]["touched"] = SHAPES_DUE | PAIRS_DUE | kept
    enter_stage(state, SHAPES)


def after_parting(state: StateRow) -> int:
    """The stage that comes after a round of parting balls: another one where the last iteration still found some."""
    if state["iteration"] < state["iterations"] or state["substep"] == PARTING_ROUNDS:
        return TAKE_UP
    state["substep"] += 1
    return MOVE


def fly(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    queue: Table[QueueRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
) -> int:
    """DONE when all events up to the horizon are dealt with; NEEDS_ROOM if there may be too little for the next one."""
    most = 2 * int(index[FIXED]["longest"] + index[MOVING]["longest"]) + 4
    horizon, horizon_low = float(state["horizon"]), float(state["horizon_low"])
    while True:
        if lacks_room_for_event(state, len(hits), relations, most):
            return NEEDS_ROOM
        i = front_of(state, flights, queue)
        change, change_low, _of_regions = next_change(state)
        next_is_shape = i < 0 or not is_before(
            float(flights[i]["due_time"]), float(flights[i]["due_low"]), change, change_low
        )
        if next_is_shape:
            if is_before(horizon, horizon_low, change, change_low):
                break
            go_to_change(state, balls, shapes, order, index, cells, members, flights, relations, island[0])
            return DONE
        time, low = float(flights[i]["due_time"]), float(flights[i]["due_low"])
        if is_before(horizon, horizon_low, time, low):
            break
        # What was foreseen for a time that is past, by rounding, is now.
        if is_before(float(state["now"]), float(state["now_low"]), time, low):
            state["now"] = time
            state["now_low"] = low
        if state["binned"] != 0:
            prefetch_next(state, balls, flights, queue)
        spent = int(state["spent"])
        state["renewals"] = 0
        deal_with(
            state, balls, shapes, order, index, cells, members, heads, hits, relations, flights, queue, island, i
        )  # fmt: skip
        over = is_over(state, balls, flights, hits, i)
        if state["spent"] != spent:
            let_go(state, balls, shapes, index, cells, members, hits, relations, flights, island[0])
            state["foreseen"] = 0
        if over:
            state["horizon"] = state["now"]
            state["horizon_low"] = state["now_low"]
            enter_stage(state, SHOW)
            return DONE
        state["events"] += 1
        if state["foreseen"] == 0 or fit_bins(state):
            enter_stage(state, FORESEE)
            return DONE
        if state["events"] > EVENTS_BETWEEN_PAUSES:
            return PAUSE
    enter_stage(state, SHOW)
    return DONE


def prefetch_next(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], queue: Table[QueueRow]
) -> None:  # fmt: skip
    """Of a crowd, have those at hand who come next after the first of the queue, and who are met by these."""
    half = len(flights) // 2
    for k in range(1, min(FRONT, int(state["queued"]))):
        ball = row_of(queue[k]["ball"])
        if k > 2:
            prefetch_lines(flights, ball, EVENT_LINES)
            prefetch_lines(balls, ball, BALL_LINES)
        elif flights[ball]["event"] == HIT_BALL:
            partner = row_of(flights[ball]["partner"])
            prefetch_lines(flights, partner, EVENT_LINES)
            prefetch_lines(balls, partner, BALL_LINES)
            prefetch_lines(flights, half + ball, COPIED_LINES)
            prefetch_lines(flights, half + partner, COPIED_LINES)
            prefetch(queue, partner)


def go_to_change(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
) -> None:
    """Let it be when the next shape stops or arrives, or when regions hold no more; all is to be foreseen anew."""
    time, low, of_regions = next_change(state)
    state["now"] = time
    state["now_low"] = low
    if of_regions:
        state["renewals"] += 1
    else:
        change_shapes(state, balls, shapes, order, index, cells, members, flights, relations, bodies)
    enter_stage(state, FORESEE)


def next_change(state: StateRow) -> tuple[float, float, bool]:
    """When the next shape stops or arrives, or their regions hold no more, and whether it is the latter."""
    change, change_low = float(state["change"]), float(state["change_low"])
    valid, valid_low = float(state["valid"]), float(state["valid_low"])
    if is_before(valid, valid_low, change, change_low):
        return valid, valid_low, True
    return change, change_low, False


def lacks_room_for_event(state: StateRow, hits: int, relations: Table[RelationRow], most: int) -> bool:
    """True if a table of so many hits, or the relations, may lack room for the next event: `most` hits and relations.

    All balls of an island may begin to pass something at once, and a shape that switches itself off may end every
    relation there is with a hit.
    """
    wanted_hits = most + int(state["relations"])
    wanted = most * (int(state["relations"]) + 1)
    if hits - state["hits"] >= wanted_hits and relations_room(state, relations) >= wanted:
        return False
    state["wanted_hits"] = state["hits"] + wanted_hits
    state["wanted_relations"] = state["relations"] + wanted
    return True


def is_over(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], hits: Table[HitRow], i: int
) -> bool:  # fmt: skip
    """True if the event of ball `i` ends the step: it has had as many impacts as it may, or who is watched has one."""
    if flights[i]["kept"] == state["step_number"] and 0 < state["max_impacts"] <= flights[i]["impacts"]:
        return True
    if state["watched"] == 0 or state["hits"] == state["step_hits"]:
        return False
    hit, watched = hits[state["hits"] - 1], int(balls[state["watched"] - 1]["id"])
    return bool(hit["kind"] == BOUNCE and (hit["ball"] == watched or hit["shape"] == watched))
