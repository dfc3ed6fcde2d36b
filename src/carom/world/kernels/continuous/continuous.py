"""A step in the continuous mode: balls fly on their exact paths from impact to impact, in order of time.

Each stage can stop where room runs out, and go on from there when there is more.
"""

from __future__ import annotations

from carom.constants import SPAN_END
from carom.rows.ball import BallRow
from carom.rows.flight import HIT_BALL, HIT_SHAPE, LEAVE, FlightRow
from carom.rows.hit import HitRow
from carom.rows.index import CellRow, IndexRow, SlotRow
from carom.rows.relation import LASTING, NO_RELATION, RelationRow
from carom.rows.saved import PAIRS_DUE, SHAPES_DUE, SavedRow
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
    PAIRS,
    SHAPES,
    SPAN,
    StateRow,
)
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.arrival import arrive, near_ends
from carom.world.kernels.continuous.bins import open_bins
from carom.world.kernels.continuous.encounter import count_impact, impact_of_balls, impact_with_shape, keep_push_out
from carom.world.kernels.continuous.flight import fly_to, forget_partner, new_flights, place_at
from carom.world.kernels.continuous.foresee import foresee, foresee_all
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.spans import (
    begin_flights,
    move_shapes_on,
    set_shapes_going,
    span_length,
    sweep_pairs,
)
from carom.world.kernels.continuous.support import lean
from carom.world.kernels.step.discrete import (
    enter_stage,
    find_pairs,
    finish,
    meet_all_pairs,
    meet_all_shapes,
    rebuild_index,
)
from carom.world.kernels.step.relations import drop_kind, has_kind, relations_room
from carom.world.kernels.step.rollback import begin_step, end_step
from carom.world.kernels.step.times import rest_speed, substep_length


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
    queue: Table[int],
) -> int:
    """Why the kernel came back: DONE after `state["steps_left"]` steps, or what it needs to go on, as `step_discrete`.

    Balls that overlap when a step begins are first moved apart by the stages of the discrete mode.
    """
    state = states[0]
    while state["steps_left"] > 0:
        stage = state["stage"]
        if stage == BEGIN:
            status = begin_step(states, balls, shapes, order, saved, relations)
        elif stage == MOVE:
            status = begin_substep(state, balls, shapes, order, index, cells, members, saved, flights)
        elif stage == SHAPES:
            status = meet_all_shapes(state, balls, shapes, (index, cells, members), saved, hits, relations)
            if state["stage"] == FINISH:
                enter_stage(state, SPAN)
        elif stage == FIND_PAIRS and state["balls"] < 2 and state["found"] == 0:
            enter_stage(state, SPAN)
            status = DONE
        elif stage == FIND_PAIRS:
            status = find_pairs(state, balls, shapes, (index, cells, members), (slots, starts, pairs), saved)
        elif stage == PAIRS:
            status = meet_all_pairs(
                state, balls, shapes, (index, cells, members), pairs, saved, hits, relations
            )  # fmt: skip
            if state["stage"] == FINISH:
                enter_stage(state, SPAN)
        elif stage == SPAN:
            status = begin_span(
                state, balls, shapes, order, index, cells, members, slots, starts, pairs, flights
            )  # fmt: skip
        elif stage == FORESEE:
            foresee_all(
                state, balls, shapes, order, index, cells, members, starts, pairs, relations, flights, queue
            )  # fmt: skip
            enter_stage(state, FLY)
            status = DONE
        elif stage == FLY:
            status = fly(
                state, balls, shapes, order, index, cells, members, starts, hits, relations, flights, queue
            )  # fmt: skip
        elif stage == FINISH:
            status = finish(state, balls, shapes, order, hits, relations)
        else:
            status = end_step(states, balls, shapes, order, saved, relations)
        if status != DONE:
            return status
    return DONE


def begin_substep(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    saved: Table[SavedRow],
    flights: Table[FlightRow],
) -> int:
    """DONE when the index of shapes is right and balls may be moved apart (once a step) or fly."""
    if not rebuild_index(state, balls, shapes, order, (index, cells, members)):
        return NEEDS_PAIRS
    new_flights(state, flights)
    state["span_begin"] = 0.0
    state["iteration"] = 0
    state["found"] = 0
    for i in range(state["balls"]):
        saved[i]["touched"] = SHAPES_DUE | PAIRS_DUE
    enter_stage(state, SHAPES if state["substep"] == 0 else SPAN)
    return DONE


def begin_span(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    slots: Table[SlotRow],
    starts: Table[int],
    pairs: Pairs,
    flights: Table[FlightRow],
) -> int:
    """DONE when shapes and balls are set going for the span; NEEDS_PAIRS if there is too little room for cells."""
    if not rebuild_index(state, balls, shapes, order, (index, cells, members)):
        return NEEDS_PAIRS
    state["span"] = span_length(state, shapes, order, substep_length(state) - float(state["span_begin"]))
    # Balls that a shape wakes on its way are to fly.
    set_shapes_going(state, balls, shapes, order)
    if begin_flights(state, balls, flights):
        # Sorting the balls for the pairs and filing them use the same room, one after the other.
        tests = int(state["box_tests"])
        found = sweep_pairs(state, balls, flights, slots, starts, pairs)
        if not found or not open_bins(state, balls, flights, starts):
            state["box_tests"] = tests
            return NEEDS_PAIRS
    enter_stage(state, FORESEE)
    return DONE


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
    queue: Table[int],
) -> int:
    """DONE when all events of the span are dealt with and every ball is where it ends; NEEDS_ROOM if hits ran out."""
    rest = rest_speed(state)
    most = 2 * int(index[FIXED]["longest"] + state["shapes"] - state["fixed"]) + 2
    while True:
        wanted = most + int(state["relations"])
        if len(hits) - state["hits"] < wanted or relations_room(state, relations) < most:
            state["wanted_hits"] = state["hits"] + wanted
            state["wanted_relations"] = state["relations"] + most
            return NEEDS_ROOM
        if state["queued"] > 0:
            i = row_of(queue[0])
            deal_with(
                state, balls, shapes, order, index, cells, members, heads, hits, relations, flights, queue, i, rest
            )  # fmt: skip
        else:
            end_flights(state, balls, shapes, order, index, cells, members, heads, hits, relations, flights, most)
            if state["cursor"] == state["balls"]:
                break
    move_shapes_on(state, shapes, order)
    state["span_begin"] += state["span"]
    enter_stage(state, SPAN if state["span_begin"] < substep_length(state) * SPAN_END else FINISH)
    return DONE


def end_flights(
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
    most: int,
) -> None:
    """Move the balls, from the cursor on, to where they end the span; as far as there is room for hits."""
    span = float(state["span"])
    duration = substep_length(state)
    fixed, count = int(state["fixed"]), int(state["shapes"])
    kinematic = count > fixed
    for i in range(state["cursor"], state["balls"]):
        if len(hits) - state["hits"] < most + state["relations"] or relations_room(state, relations) < most:
            return
        state["cursor"] = i + 1
        ball, flight = balls[i], flights[i]
        if ball["relation"] == NO_RELATION:
            x, y, _vx, _vy = place_at(ball, flight, span)
            radius = float(ball["radius"])
            begin, end = cell_span(cells, locate(state, index[FIXED], cells, x, y))
            near = near_ends(shapes, members, begin, end, x, y, radius)
            if not near and not (kinematic and near_ends(shapes, order, fixed, count, x, y, radius)):
                fly_to(ball, flight, span)
                continue
        arrive(
            state, balls, shapes, order, index, cells, members, heads, flights, hits, relations, i, span
        )  # fmt: skip
        lean(state, ball, flight, shapes, relations, duration, False)


def deal_with(
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
    queue: Table[int],
    i: int,
    rest: float,
) -> None:
    """Deal with the next event, which is that of ball `i`, and foresee what comes next for the balls concerned."""
    ball, flight = balls[i], flights[i]
    event, partner, time = int(flight["event"]), row_of(flight["partner"]), float(flight["event_time"])
    stale = event == HIT_BALL and flights[partner]["version"] != flight["partner_version"]
    arrive(
        state, balls, shapes, order, index, cells, members, heads, flights, hits, relations, i, time
    )  # fmt: skip
    duration = substep_length(state)
    if event == HIT_BALL and not stale:
        arrive(
            state, balls, shapes, order, index, cells, members, heads, flights, hits, relations, partner, time
        )  # fmt: skip
        x, y = float(ball["x"]), float(ball["y"])
        other_x, other_y = float(balls[partner]["x"]), float(balls[partner]["y"])
        if impact_of_balls(state, balls, flights, min(i, partner), max(i, partner), hits, relations, rest):
            keep_push_out(state, ball, shapes, index, cells, members, relations, x, y)
            keep_push_out(state, balls[partner], shapes, index, cells, members, relations, other_x, other_y)
        count_impact(state, flight)
        count_impact(state, flights[partner])
        change_path(state, balls[partner], flights[partner], shapes, relations, duration)
        change_path(state, ball, flight, shapes, relations, duration)
        foresee(
            state, balls, shapes, order, index, cells, members, heads, flights, queue, relations, partner
        )  # fmt: skip
    elif event == HIT_SHAPE:
        impact_with_shape(
            state, ball, flight, i, shapes, partner, index, cells, members, hits, relations, rest
        )  # fmt: skip
        count_impact(state, flight)
        change_path(state, ball, flight, shapes, relations, duration)
    elif event == LEAVE:
        drop_kind(state, relations, ball, LASTING, partner)
        change_path(state, ball, flight, shapes, relations, duration)
    elif not stale:
        look_around(state, ball, flight, shapes, relations, duration)
    foresee(state, balls, shapes, order, index, cells, members, heads, flights, queue, relations, i)


def change_path(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    duration: float,
) -> None:
    """Let a ball fly on as an impact left it; what others have foreseen with it counts no more."""
    forget_partner(flight)
    lean(state, ball, flight, shapes, relations, duration, True)


def look_around(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    duration: float,
) -> None:
    """Put a ball that slides back onto what holds it; its path changes a little with that."""
    if has_kind(relations, ball, LASTING):
        forget_partner(flight)
        lean(state, ball, flight, shapes, relations, duration, False)
