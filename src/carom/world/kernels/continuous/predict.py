"""What comes next for a ball: of all that may, the first; and the queue of all balls' next events."""

from __future__ import annotations

from math import inf, sqrt

from carom.constants import FEW_BALLS
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, LEAVE, LOOK, NO_BALL, NO_PLACE, NO_TICK, NOTHING, TICK, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.relation import INSIDE_SHAPE, LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.bins import file_ball, leash, may_meet, open_bins, unfile_ball
from carom.world.kernels.continuous.flight import age_now, consider, consider_at, place_after, time_to_go
from carom.world.kernels.continuous.predict_balls import predict_balls
from carom.world.kernels.continuous.predict_sensors import predict_clear, predict_exit
from carom.world.kernels.continuous.predict_shapes import predict_shapes
from carom.world.kernels.continuous.queue import put_event, row_of, take_event
from carom.world.kernels.continuous.rest import predict_rest
from carom.world.kernels.continuous.sliding import only_holder, slide_time


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
    queue: Table[int],
) -> bool:
    """True when what comes next was foreseen for every ball; False if the cells of the balls need more room."""
    state["queued"] = 0
    state["binned"] = 0
    state["bin_levels"] = 1 if state["balls"] > 1 and may_meet(state, balls) else 0
    for i in range(state["balls"]):
        flights[i]["place"] = NO_PLACE
        flights[i]["row"] = i
        flights[i]["body"] = 0
    if state["balls"] > FEW_BALLS and state["bin_levels"] != 0 and not open_bins(state, balls, flights, heads):
        return False
    for i in range(state["balls"]):
        predict_own(state, balls, flights, shapes, order, index, cells, members, relations, i)
    for i in range(state["balls"]):
        if state["bin_levels"] != 0 and flights[i]["kind"] == FLYING:
            predict_balls(state, balls, heads, flights, relations, i, False)
    for i in range(state["balls"]):
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
    queue: Table[int],
    i: int,
) -> None:
    """Find what comes next for ball `i` from now on and put it into the queue, or take the ball out if nothing does."""
    if state["binned"] != 0:
        refile(state, balls, flights, heads, i)
    predict_own(state, balls, flights, shapes, order, index, cells, members, relations, i)
    # One that sleeps, too: an impact may have been known in its place alone.
    if state["bin_levels"] != 0:
        predict_balls(state, balls, heads, flights, relations, i, True)
    queue_up(state, flights, queue, i)


def refile(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], heads: Table[int], i: int
) -> None:  # fmt: skip
    """File a ball anew if it has gone half of the way that it may from where it was filed."""
    flight = flights[i]
    age = age_now(state, flight)
    x, y, _vx, _vy = place_after(balls[i], flight, age)
    dx, dy = x - float(flight["bin_x"]), y - float(flight["bin_y"])
    half = 0.5 * leash(state, flight)
    if dx * dx + dy * dy > half * half:
        unfile_ball(flights, heads, i)
        file_ball(state, balls, flights, heads, i, age)


def queue_up(state: StateRow, flights: Table[FlightRow], queue: Table[int], i: int) -> None:
    """Put the next event of ball `i` into the queue, or take the ball out if it has none."""
    if flights[i]["event"] != NOTHING:
        put_event(state, flights, queue, i)
    elif flights[i]["place"] != NO_PLACE:
        take_event(state, flights, queue, i)


def predict_own(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    i: int,
) -> None:
    """Foresee what comes first for a ball but for impacts with other balls."""
    ball, flight = balls[i], flights[i]
    flight["event"] = NOTHING
    age = age_now(state, flight)
    in_island = flight["tick_time"] < NO_TICK
    if flight["kind"] == FLYING:
        if in_island:
            consider_at(flight, float(flight["tick_time"]), float(flight["tick_low"]), TICK, NO_BALL)
        else:
            predict_rest(state, ball, flight)
        if state["binned"] != 0:
            predict_leash(state, ball, flight, age)
    if ball["relation"] != NO_RELATION:
        predict_relations(state, balls, flights, shapes, relations, i, age)
    if state["shapes"] > 0:
        predict_shapes(state, ball, flight, shapes, order, index, cells, members, relations, age)


def predict_leash(state: StateRow, ball: BallRow, flight: FlightRow, age: float) -> None:
    """Foresee a look at the time at which a ball may be as far from where it was filed as it may."""
    x, y, vx, vy = place_after(ball, flight, age)
    dx, dy = x - float(flight["bin_x"]), y - float(flight["bin_y"])
    left = leash(state, flight) - sqrt(dx * dx + dy * dy)
    ax, ay = float(flight["ax"]), float(flight["ay"])
    wait = time_to_go(sqrt(vx * vx + vy * vy), sqrt(ax * ax + ay * ay), max(left, 0.0))
    if wait < inf:
        consider(flight, age + wait, LOOK, NO_BALL)


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
        elif kind == PASSING:
            predict_clear(ball, flight, shapes[other], other, age)
        place = int(relation["next"])
