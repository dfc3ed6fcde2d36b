"""What comes next for a ball: of all that may, the first; and the queue of all balls' next events."""

from __future__ import annotations

from math import inf

from carom.constants import FEW_FLIGHTS, FINEST_LEVEL
from carom.geometry.instants import is_before, later
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, LEAVE, NO_BALL, NO_TICK, NOTHING, STRAY, TICK, FlightRow, QueueRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.bins import (
    cell_at,
    file_ball,
    level_after,
    may_meet,
    open_bins,
    own_level,
    time_filed,
    unfile_ball,
)
from carom.world.kernels.continuous.flight import KEY_SIDE, age_now, consider, consider_at, note_course, place_after
from carom.world.kernels.continuous.predict_balls import (
    NO_CELL,
    predict_balls,
    predict_balls_beyond,
    predict_leaving,
)
from carom.world.kernels.continuous.predict_sensors import predict_clear, predict_exit
from carom.world.kernels.continuous.predict_shapes import asks_bit_by_bit, known_until, predict_members, predict_shapes
from carom.world.kernels.continuous.queue import open_queue, put_event, row_of, take_event
from carom.world.kernels.continuous.rest import predict_rest
from carom.world.kernels.continuous.sliding import only_holder, slide_time
from carom.world.kernels.continuous.straying import is_out, predict_stray
from carom.world.kernels.step.relations import find_relation


def predict_all(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    queue: Table[QueueRow],
) -> bool:
    """True when what comes next was foreseen for every ball; False if the cells of the balls need more room."""
    open_queue(state, queue)
    state["binned"] = 0
    state["bin_levels"] = 1 if state["balls"] > 1 and may_meet(state, balls) else 0
    for i in range(state["balls"]):
        note_course(state, balls[i], flights[i])
        flights[i]["row"] = i
        flights[i]["body"] = 0
        flights[i]["filings"] = 0
    if state["balls"] > FEW_FLIGHTS and state["bin_levels"] != 0 and not open_bins(state, balls, flights, heads):
        return False
    for i in range(state["balls"]):
        predict_own(state, balls, flights, shapes, relations, i)
        foresee_filing(state, balls[i], flights[i], age_now(state, flights[i]))
    for i in range(state["balls"]):
        if state["bin_levels"] != 0 and flights[i]["kind"] == FLYING and not is_out(state, balls[i]):
            predict_balls(state, balls, heads, flights, relations, i, False)
    for i in range(state["balls"]):
        predict_rest_of(state, balls[i], flights[i], shapes, order, index, cells, members, relations)
        queue_up(state, flights, queue, i)
    return True


def predict(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    queue: Table[QueueRow],
    i: int,
) -> None:
    """Find what comes next for ball `i` from now on and put it into the queue, or take the ball out if nothing does."""
    if state["binned"] != 0 and not is_out(state, balls[i]):
        note_course(state, balls[i], flights[i])
        if not keep_filed(state, balls, flights, heads, i):
            predict_parting_far(state, balls, flights, relations, queue, i)
    else:
        never_filed_anew(flights[i])
    predict_own(state, balls, flights, shapes, relations, i)
    # One that sleeps, too: an impact may have been known in its place alone.
    if state["bin_levels"] != 0 and not is_out(state, balls[i]):
        predict_balls(state, balls, heads, flights, relations, i, True)
    predict_rest_of(state, balls[i], flights[i], shapes, order, index, cells, members, relations)
    queue_up(state, flights, queue, i)


def predict_rest_of(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
) -> None:
    """Foresee what a ball meets besides balls, after these: up to an impact with one of them few shapes are near."""
    age = age_now(state, flight)
    if state["shapes"] > 0 and not is_out(state, ball):
        predict_shapes(state, ball, flight, shapes, order, index, cells, members, relations, age)
    if state["bounded"] != 0 and not is_out(state, ball):
        predict_stray(state, ball, flight, age)


def keep_filed(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], heads: Table[int], i: int
) -> bool:  # fmt: skip
    """File a ball anew that an event has moved out of where it may be, and foresee when it may leave that.

    True if it stays near those that it was near.
    """
    flight = flights[i]
    age = age_now(state, flight)
    wait = time_filed(state, balls[i], flight, age)
    flight["filings"] = 0
    state["bin_predictions"] += 1
    if wait < 0.0 or flight["level"] > FINEST_LEVEL:
        unfile_ball(state, flights, heads, i)
        file_ball(state, balls, flights, heads, i, age, own_level(state, balls[i]))
        note_filing(flight, age, time_filed(state, balls[i], flight, age))
        return wait >= 0.0
    note_filing(flight, age, wait)
    return True


def predict_parting_far(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    queue: Table[QueueRow],
    i: int,
) -> None:
    """Foresee that ball `i`, which was put elsewhere, parts from those whose rows tell that one is inside the other.

    They are near it no more, and would not be asked.
    """
    for j in range(i + 1, state["balls"]):
        if balls[j]["relation"] != NO_RELATION and find_relation(relations, balls[j], INSIDE_BALL, i):
            predict_leaving(state, balls, flights, j, i)
            queue_up(state, flights, queue, j)


def file_anew(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    heads: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    queue: Table[QueueRow],
    i: int,
) -> None:
    """File a ball under the cell that it has come to, and foresee impacts with what is near it from there on.

    What was foreseen stands.
    """
    flight = flights[i]
    age = age_now(state, flight)
    column, line = int(flight["column"]), int(flight["line"])
    x, y, _vx, _vy = place_after(balls[i], flight, age)
    if (column, line) != cell_at(state, x, y, int(flight["level"])):
        level = level_after(state, flight)
        if level != flight["level"]:
            column, line = NO_CELL, NO_CELL
        unfile_ball(state, flights, heads, i)
        file_ball(state, balls, flights, heads, i, age, level)
        state["bin_filings"] += 1
        predict_balls_beyond(state, balls, heads, flights, relations, i, column, line, True)
    foresee_filing(state, balls[i], flight, age)
    if asks_bit_by_bit(state, index):
        until = known_until(flight)
        predict_members(state, balls[i], flight, shapes, order, relations, 0, int(state["fixed"]), age, until)
    queue_up(state, flights, queue, i)


def queue_up(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], i: int) -> None:
    """Put what comes next for ball `i` into the queue, or take the ball out if nothing does."""
    flight = flights[i]
    if is_filed_first(flight):
        flight["due_time"] = flight["file_time"]
        flight["due_low"] = flight["file_low"]
        flight["due_key"] = i * KEY_SIDE
    elif flight["event"] != NOTHING:
        flight["due_time"] = flight["event_time"]
        flight["due_low"] = flight["event_low"]
        flight["due_key"] = flight["event_key"]
    else:
        take_event(state, flights, queue, i)
        return
    put_event(state, flights, queue, i)


def is_filed_first(flight: FlightRow) -> bool:
    """True if a ball is to be filed anew before its next event comes."""
    if flight["event"] == NOTHING:
        return bool(flight["file_time"] < inf)
    return is_before(
        float(flight["file_time"]), float(flight["file_low"]), float(flight["event_time"]), float(flight["event_low"])
    )


def predict_own(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    i: int,
) -> None:
    """Foresee what comes first for a ball but for impacts."""
    ball, flight = balls[i], flights[i]
    flight["event"] = NOTHING
    age = age_now(state, flight)
    if is_out(state, ball):
        if ball["relation"] != NO_RELATION:
            consider(flight, age, STRAY, NO_BALL)
        return
    in_island = flight["tick_time"] < NO_TICK
    if flight["kind"] == FLYING:
        if in_island:
            consider_at(flight, float(flight["tick_time"]), float(flight["tick_low"]), TICK, NO_BALL)
        else:
            predict_rest(state, ball, flight)
    if ball["relation"] != NO_RELATION:
        predict_relations(state, balls, flights, shapes, relations, i, age)


def foresee_filing(state: StateRow, ball: BallRow, flight: FlightRow, age: float) -> None:
    """Foresee when a ball may leave where it is filed, as seen from an age of its flight."""
    if state["binned"] == 0 or is_out(state, ball):
        never_filed_anew(flight)
    else:
        note_filing(flight, age, time_filed(state, ball, flight, age))


def note_filing(flight: FlightRow, age: float, wait: float) -> None:
    """Note when a ball is to be filed anew: so many seconds after an age of its flight it may leave where it is."""
    never_filed_anew(flight)
    if flight["kind"] == FLYING and wait < inf:
        time, low = later(float(flight["time"]), float(flight["low"]), age + max(wait, 0.0))
        flight["file_time"] = time
        flight["file_low"] = low


def never_filed_anew(flight: FlightRow) -> None:
    """Note that a ball stays where it is filed, or that it is filed nowhere."""
    flight["file_time"] = inf
    flight["file_low"] = 0.0


def predict_relations(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    i: int,
    age: float,
) -> None:
    """Foresee when a ball's relations end, or have to be looked at."""
    ball, flight = balls[i], flights[i]
    alone = only_holder(ball, relations) != NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        relation = relations[place]
        kind, other = int(relation["kind"]), row_of(relation["other"])
        if kind == LASTING:
            delay, leaves = slide_time(state, ball, flight, shapes[other], alone)
            # An island has ticks of its own.
            wanted = leaves or flight["tick_time"] == NO_TICK
            if flight["kind"] == FLYING and delay < inf and wanted:
                consider(flight, delay, LEAVE if leaves else TICK, other)
        elif kind == INSIDE_SHAPE:
            predict_exit(ball, flight, shapes[other], other, age)
        elif kind == INSIDE_BALL:
            # Not only where it is filed near: what else they overlapped may have been moved apart far.
            predict_leaving(state, balls, flights, i, other)
        elif kind == PASSING:
            predict_clear(ball, flight, shapes[other], other, age)
        place = int(relation["next"])
