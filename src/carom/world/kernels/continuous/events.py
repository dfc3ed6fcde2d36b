"""The events of the film, one after the other: what happens at each, and what comes next for those concerned."""

from __future__ import annotations

from carom.constants import END_DEPTH_CONTINUOUS, LIFT
from carom.rows.ball import BallRow
from carom.rows.flight import (
    CLEAR,
    EXIT_BALL,
    EXIT_SHAPE,
    HIT_BALL,
    HIT_SHAPE,
    LEAVE,
    LOOK,
    NO_BALL,
    NO_SHAPE,
    SLEEP,
    STOP,
    STRAY,
    FlightRow,
    QueueRow,
)
from carom.rows.hit import EXIT, HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import BodyRow, IslandContactRow
from carom.rows.kinds import has_ends
from carom.rows.pose import is_moving
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import arrive, keep_course, work_of_shift
from carom.world.kernels.continuous.encounter import impact_of_balls, impact_with_shape, keep_push_out
from carom.world.kernels.continuous.flight import age_now, begins_now, let_sleep, path_of
from carom.world.kernels.continuous.island import hasten, is_solved, lies
from carom.world.kernels.continuous.jolt import jolt
from carom.world.kernels.continuous.lasting import hold
from carom.world.kernels.continuous.movers import change_movers, changes_now
from carom.world.kernels.continuous.predict import file_anew, is_filed_first, predict
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.rounding import keep_rounding, way_of
from carom.world.kernels.continuous.sensing import cross_edge
from carom.world.kernels.continuous.straying import cross_bounds
from carom.world.kernels.continuous.surfaces import age_of_motion, seen_on_path
from carom.world.kernels.step.hits import cross_ball
from carom.world.kernels.step.relations import add_relation, drop_kind, has_kind


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
    queue: Table[QueueRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    i: int,
) -> None:
    """Deal with the next event, which is that of ball `i`, and foresee what comes next for the balls concerned."""
    ball, flight = balls[i], flights[i]
    if is_filed_first(flight):
        file_anew(state, balls, shapes, order, index, heads, flights, relations, queue, i)
        return
    event, partner = int(flight["event"]), row_of(flight["partner"])
    of_two = event == HIT_BALL or event == EXIT_BALL
    looks = event == LOOK or (of_two and flights[partner]["version"] != flight["partner_version"])
    if looks or deal_on_way(state, balls, shapes, index, cells, members, hits, relations, flights, island[0], i):
        predict(state, balls, shapes, order, index, cells, members, heads, relations, flights, queue, i)
        return
    came = way_of(ball, flight)
    met = partner if event == HIT_SHAPE else NO_SHAPE
    arrive(state, balls, shapes, index, cells, members, flights, relations, i, met)
    second = partner if of_two else NO_BALL
    struck, changed = event == HIT_BALL, event == HIT_BALL or event == LEAVE or event == STOP
    if of_two:
        arrive(state, balls, shapes, index, cells, members, flights, relations, partner, NO_SHAPE)
        low, high = min(i, partner), max(i, partner)
        if event == HIT_BALL:
            meet_balls(state, balls, shapes, index, cells, members, hits, relations, flights, low, high)
        else:
            drop_kind(state, relations, balls[high], INSIDE_BALL, low)
            cross_ball(state, hits[state["hits"]], float(state["now"]), EXIT, balls[high], balls[low])
    elif event == HIT_SHAPE:
        struck, changed = True, True
        impact_with_shape(
            state, ball, flight, i, shapes, partner, index, cells, members, hits, relations
        )  # fmt: skip
        keep_rounding(ball, flight, shapes[partner], came)
    else:
        end_quietly(state, ball, flight, shapes, hits, relations, event, partner)
    fly_on_from(
        state, balls, shapes, order, index, cells, members, heads, relations, flights, queue, island, i, second,
        struck, changed,
    )  # fmt: skip


def deal_on_way(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
    i: int,
) -> bool:
    """True if the next event of a ball leaves its path what it is, which then is dealt with.

    It crosses the bounds, or comes off a shape that it passed, or onto a moving one past an end of that.
    """
    ball, flight = balls[i], flights[i]
    event, partner = int(flight["event"]), row_of(flight["partner"])
    if event == STRAY:
        cross_bounds(state, balls, shapes, index, cells, members, hits, relations, flights, bodies, i)
    elif event == CLEAR:
        keep_course(state, ball, flights, i)
        drop_kind(state, relations, ball, PASSING, partner)
    elif event == HIT_SHAPE and came_past_end(state, ball, flight, shapes[partner], relations):
        keep_course(state, ball, flights, i)
        add_relation(state, relations, ball, i, PASSING, partner)
    else:
        return False
    return True


def fly_on_from(
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
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    i: int,
    second: int,
    struck: bool,
    changed: bool,
) -> None:
    """Let the balls concerned by an event fly on, `i` and maybe a `second`, and foresee what comes next for them.

    With them all balls of their islands. `struck` after an impact; `changed` where a velocity was.
    """
    if is_solved(relations, balls[i], flights[i]) or (
        second != NO_BALL and is_solved(relations, balls[second], flights[second])
    ):
        bodies, _contacts = island
        # An impact may have been foreseen with either of two; they are solved in the order of their rows.
        low, high = (i, second) if second == NO_BALL or i < second else (second, i)
        count = jolt(
            state, balls, shapes, index, cells, members, flights, relations, island, low, high, struck
        )  # fmt: skip
        for k in range(count):
            ball = row_of(bodies[k]["ball"])
            predict(state, balls, shapes, order, index, cells, members, heads, relations, flights, queue, ball)
        return
    if second != NO_BALL:
        hold(state, balls[second], flights[second], shapes, relations, changed)
    hold(state, balls[i], flights[i], shapes, relations, changed)
    if second != NO_BALL:
        predict(state, balls, shapes, order, index, cells, members, heads, relations, flights, queue, second)
    predict(state, balls, shapes, order, index, cells, members, heads, relations, flights, queue, i)


def came_past_end(
    state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, relations: Table[RelationRow]
) -> bool:
    """True if a ball has come onto a moving shape past an end of it since its flight began.

    Its sides are met at the touch; what is found deep in it, where a slice of time begins, has come in otherwise.
    """
    age = age_now(state, flight)
    if age == 0.0 or shape["sensor"] != 0 or ball["sensor"] != 0 or not has_ends(shape["kind"]) or not is_moving(shape):
        return False
    radius, time, path = float(ball["radius"]), age_of_motion(shape, flight), path_of(ball, flight)
    depth = (LIFT if has_kind(relations, ball, LASTING) else END_DEPTH_CONTINUOUS) * radius
    _past, deep = seen_on_path(shape, time, path, radius, age, depth)
    _past, was_deep = seen_on_path(shape, time, path, radius, 0.0, depth)
    return deep and not was_deep


def meet_balls(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    first: int,
    second: int,
) -> None:
    """Do what follows from two balls' touching, and keep them out of shapes where it moves them apart."""
    x1, y1 = float(balls[first]["x"]), float(balls[first]["y"])
    x2, y2 = float(balls[second]["x"]), float(balls[second]["y"])
    if impact_of_balls(state, balls, flights, first, second, hits, relations):
        keep_push_out(balls[first], shapes, index, cells, members, relations, x1, y1)
        keep_push_out(balls[second], shapes, index, cells, members, relations, x2, y2)
        work = work_of_shift(state, balls[first], x1, y1) + work_of_shift(state, balls[second], x2, y2)
        book_work(balls, flights, relations, first, second, work)


def book_work(
    balls: Table[BallRow],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    first: int,
    second: int,
    work: float,
) -> None:
    """Let those of two balls whose islands are solved pay what putting both elsewhere has won."""
    mass = 0.0
    for i in (first, second):
        if is_solved(relations, balls[i], flights[i]):
            mass += float(balls[i]["mass"])
    for i in (first, second):
        if is_solved(relations, balls[i], flights[i]):
            flights[i]["surplus"] += work / mass


def end_quietly(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    event: int,
    partner: int,
) -> None:
    """Do what follows from an event that is no impact: a relation or a motion ends, or a ball slides on."""
    if event == LEAVE:
        drop_kind(state, relations, ball, LASTING, partner)
    elif event == EXIT_SHAPE:
        drop_kind(state, relations, ball, INSIDE_SHAPE, partner)
        cross_edge(state, hits, EXIT, ball, flight, shapes[partner])
    elif event == STOP:
        ball["vx"] = 0.0
        ball["vy"] = 0.0
    elif event == SLEEP:
        let_sleep(state, ball, flight)


def change_shapes(
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
    """Let the shapes that stop or arrive now do so; balls that they hold begin new flights."""
    for i in range(state["balls"]):
        if balls[i]["relation"] != NO_RELATION and is_held_by_changing(state, balls[i], shapes, relations):
            arrive(state, balls, shapes, index, cells, members, flights, relations, i, NO_SHAPE)
            if lies(relations, balls[i]):
                hasten(state, balls, flights, relations, bodies, i)
    change_movers(state, shapes, order)
    for i in range(state["balls"]):
        if begins_now(state, flights[i]) and has_kind(relations, balls[i], LASTING):
            hold(state, balls[i], flights[i], shapes, relations, True)


def is_held_by_changing(
    state: StateRow, ball: BallRow, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> bool:  # fmt: skip
    """True if a shape holds a ball that stops or arrives now."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING and changes_now(state, shapes[relations[place]["other"]]):
            return True
        place = int(relations[place]["next"])
    return False
