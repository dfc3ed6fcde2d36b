"""An event of a ball that lies on others: its impulse and its weight spread as far as they are felt.

What is far from it goes on as it was solved at its island's last tick.
"""

from __future__ import annotations

from math import inf

from carom.constants import JOLT_MOST, JOLT_NEAR, JOLT_SHARE, JOLT_TOLERANCE, JOLT_WAIT, LEAST_TICK
from carom.geometry.instants import later, seconds_since
from carom.geometry.vector import larger, length
from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, NO_BALL, NO_TICK, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import WANTED, BodyRow, IslandContactRow
from carom.rows.relation import LYING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import energy_of
from carom.world.kernels.continuous.flight import age_now, begins_now, fall_freely, place_after
from carom.world.kernels.continuous.island import (
    aim_at_middle,
    clear,
    dismiss,
    enlist,
    enlist_neighbours,
    fill_body,
    fill_contacts,
    join,
    lies,
    next_tick,
    pull_on,
    rest_speed_of,
    tick_length,
    tick_of,
)
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.resolve import adjust_accelerations
from carom.world.kernels.continuous.settling import (
    begin_now,
    end_contacts,
    frame_of,
    let_loose,
    pay_surplus,
    settle,
    store_forces,
)
from carom.world.kernels.continuous.spreading import end_approaches, spread_impact
from carom.world.kernels.step.relations import find_relation


def jolt(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    first: int,
    second: int,
    struck: bool,
) -> int:
    """The number of balls that fly on otherwise after an event of one or two (NO_BALL), which are listed in bodies.

    `struck` after an impact. Near the end of their island's tick, or where it has none, all of it is solved.
    """
    bodies, contacts = island
    count, rings = list_wanted(state, balls, flights, bodies, first, second), 1
    while True:
        count = widen(state, balls, shapes, index, cells, members, flights, relations, bodies, count, rings)
        rings = more_rings(rings, count)
        time, low = next_tick(flights, bodies, count)
        found = fill_contacts(state, balls, flights, shapes, relations, island, count)
        counts = (count, found)
        pull, turning, radius, fastest = pull_on(bodies, contacts, shapes, counts)
        tau = seconds_since(time, low, float(state["now"]), float(state["now_low"])) if time < NO_TICK else 0.0
        least = LEAST_TICK * tick_length(pull, turning, radius)
        if tau <= least or not pull > 0.0 or is_any_asleep(flights, bodies, count):
            dismiss(flights, bodies, count)
            return settle(
                state, balls, shapes, index, cells, members, flights, relations, island, first, second, struck
            )  # fmt: skip
        speed = rest_speed_of(pull, radius, fastest)
        if not goes_on(state, balls, relations, island, counts, speed, first, second if struck else NO_BALL):
            break
    tick = tick_of(bodies, contacts, shapes, counts)
    tau, time, low = in_time(state, tick, tau, time, low)
    sooner, sooner_low, rings = time, low, 1
    while True:
        aim_at_middle(state, shapes, island, found, tau)
        adjust_accelerations(bodies, contacts, counts, tau, JOLT_TOLERANCE * speed)
        store_forces(balls, relations, island, found)
        push, core = strongest_push(flights, bodies, count)
        wait = JOLT_SHARE * speed / push if push > 0.0 else inf
        if core >= JOLT_MOST and JOLT_WAIT * tick <= wait < tau:
            sooner, sooner_low = later(float(state["now"]), float(state["now_low"]), wait)
            break
        if not take_in_pushed(flights, bodies, count, tau, JOLT_SHARE * speed):
            break
        count = widen(state, balls, shapes, index, cells, members, flights, relations, bodies, count, rings)
        rings = more_rings(rings, count)
        found = fill_contacts(state, balls, flights, shapes, relations, island, count)
        counts = (count, found)
    end_contacts(state, balls, shapes, index, cells, members, flights, relations, island, counts, speed, True)
    return fly_on_changed(
        state, balls, shapes, index, cells, members, flights, relations, island, counts,
        (time, low), (sooner, sooner_low),
    )  # fmt: skip


def in_time(state: StateRow, tick: float, tau: float, time: float, low: float) -> tuple[float, float, float]:
    """How long from now, and up to which instant, bodies may fly on that are to be solved within a tick of their own.

    They have come onto a bend, say, or were thrown along one, and turn sooner than their island is solved anew.
    """
    if tau <= tick:
        return tau, time, low
    return tick, *later(float(state["now"]), float(state["now_low"]), tick)


def goes_on(
    state: StateRow,
    balls: Table[BallRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    counts: tuple[int, int],
    speed: float,
    first: int,
    second: int,
) -> bool:
    """True if an impact, which has spread among bodies, goes on beyond: those reached are wanted in the core.

    `second` is the ball that the first one has met, or NO_BALL.
    """
    bodies, contacts = island
    count, found = counts
    met = add_struck(balls, relations, island, found, second)
    least = spread_impact(bodies, contacts, (count, found + met), speed)
    if met != 0 and contacts[found]["acted"] != 0:
        # What lies behind throws the one back onto the other at once: they stay together, and are solved so.
        join(state, balls, relations, first, second)
        state["held"] += 1
        take_in_reached(bodies, count)
        return True
    if take_in_reached(bodies, count):
        return True
    end_approaches(bodies, contacts, counts, least)
    return take_in_reached(bodies, count)


def fly_on_changed(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    counts: tuple[int, int],
    tick: tuple[float, float],
    sooner: tuple[float, float],
) -> int:
    """The number of bodies whose balls begin new flights now, which are listed first from now on; all are dismissed.

    They fly up to an instant at which their island is solved anew, or those outside of the core up to a sooner one.
    """
    bodies, _contacts = island
    count, _found = counts
    for k in range(count):
        i = row_of(bodies[k]["ball"])
        time, low = tick if bodies[k]["core"] != 0 else sooner
        if is_changed(state, balls[i], flights[i], relations, bodies[k], time, low):
            begin_now(state, balls, shapes, index, cells, members, flights, relations, i)
            fly_on_solved(state, balls[i], flights[i], bodies[k], time, low)
    pay_where_all_part(balls, flights, shapes, relations, island, counts)
    let_loose(state, balls, flights, shapes, relations, bodies, count)
    changed = 0
    for k in range(count):
        if begins_now(state, flights[bodies[k]["ball"]]):
            bodies[changed]["ball"] = bodies[k]["ball"]
            changed += 1
    return changed


def pay_where_all_part(
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    counts: tuple[int, int],
) -> None:
    """Let bodies whose flights begin now, none of which lies on others any more, pay what they have won."""
    bodies, contacts = island
    count, _found = counts
    for k in range(count):
        if lies(relations, balls[bodies[k]["ball"]]):
            return
    frame, moved = frame_of(bodies, contacts, shapes, counts)
    if moved:
        return
    pay_surplus(flights, bodies, count, frame)
    for k in range(count):
        ball = balls[bodies[k]["ball"]]
        ball["vx"] = bodies[k]["vx"]
        ball["vy"] = bodies[k]["vy"]


def add_struck(
    balls: Table[BallRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    found: int,
    second: int,
) -> int:
    """1 when the contact of the first two bodies is listed behind `found` others, 0 where it is or is none.

    They have met, so an impact that spreads must not let them approach again.
    """
    bodies, contacts = island
    if second == NO_BALL:
        return 0
    one, other = balls[bodies[0]["ball"]], balls[bodies[1]["ball"]]
    if one["sensor"] != 0 or other["sensor"] != 0 or find_relation(relations, one, LYING, second):
        return 0
    clear(contacts[found], 0, 1, 0.0, 0.0)
    contacts[found]["elasticity"] = 0.0
    return 1


def is_changed(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    relations: Table[RelationRow],
    body: BodyRow,
    time: float,
    low: float,
) -> bool:
    """True unless a ball flies on to the bit as it would have without what was solved."""
    if begins_now(state, flight):
        return True
    if flight["tick_time"] != time or flight["tick_low"] != low or not lies(relations, ball):
        return True
    _x, _y, vx, vy = place_after(ball, flight, age_now(state, flight))
    return bool(body["vx"] != vx or body["vy"] != vy or body["ax"] != flight["ax"] or body["ay"] != flight["ay"])


def list_wanted(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
    first: int,
    second: int,
) -> int:
    """The number of bodies, one or two (the second ball may be NO_BALL), which are listed as wanted in the core."""
    count = enlist(flights, bodies, 0, first)
    if second != NO_BALL:
        count = enlist(flights, bodies, count, second)
    for k in range(count):
        ball, flight = balls[bodies[k]["ball"]], flights[bodies[k]["ball"]]
        if flight["tick_time"] == NO_TICK:
            # What held it until now is solved with the rest.
            fall_freely(state, ball, flight)
        fill_body(state, ball, flight, bodies[k])
        bodies[k]["core"] = WANTED
    return count


def fly_on_solved(
    state: StateRow, ball: BallRow, flight: FlightRow, body: BodyRow, time: float, low: float
) -> None:  # fmt: skip
    """Give a ball whose flight begins now the velocity and acceleration of its body, up to what it is solved for.

    That is the earliest tick among those solved with it. One that had a later tick may lie on them no more, and what
    holds no longer than that must not be flown on.
    """
    ball["vx"] = body["vx"]
    ball["vy"] = body["vy"]
    flight["ax"] = body["ax"]
    flight["ay"] = body["ay"]
    flight["energy"] = energy_of(state, ball)
    flight["tick_time"] = time
    flight["tick_low"] = low


def widen(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
    count: int,
    rings: int,
) -> int:
    """The number of bodies after those that are wanted were taken into the core, and their neighbours listed.

    Of more `rings` than one, all but the last are taken into the core too: those around, those around these, and so on.
    """
    for ring in range(rings):
        known = count
        for k in range(known):
            if bodies[k]["core"] == WANTED or (ring > 0 and bodies[k]["core"] == 0):
                begin_now(
                    state, balls, shapes, index, cells, members, flights, relations, row_of(bodies[k]["ball"])
                )  # fmt: skip
                listed = count
                count = enlist_neighbours(balls, flights, relations, bodies, count, k)
                for new in range(listed, count):
                    fill_body(state, balls[bodies[new]["ball"]], flights[bodies[new]["ball"]], bodies[new])
    return count


def more_rings(rings: int, count: int) -> int:
    """How many rings a jolt takes in after so many, with which it has `count` bodies: one more each time at first."""
    return rings + 1 if count < JOLT_NEAR else 1


def is_any_asleep(flights: Table[FlightRow], bodies: Table[BodyRow], count: int) -> bool:
    """True if one of the balls sleeps."""
    found = False
    for k in range(count):
        found = found or flights[bodies[k]["ball"]]["kind"] == ASLEEP
    return found


def take_in_reached(bodies: Table[BodyRow], count: int) -> bool:
    """True if an impact has reached bodies outside of the core, which are wanted there."""
    found = False
    for k in range(count):
        if bodies[k]["core"] == 0 and bodies[k]["reached"] != 0:
            bodies[k]["core"] = WANTED
            found = True
    return found


def strongest_push(flights: Table[FlightRow], bodies: Table[BodyRow], count: int) -> tuple[float, int]:
    """The largest change of the acceleration of a body outside of the core, and how many bodies are in it."""
    push, core = 0.0, 0
    for k in range(count):
        if bodies[k]["core"] == 0:
            flight = flights[bodies[k]["ball"]]
            change = length(float(bodies[k]["ax"]) - float(flight["ax"]), float(bodies[k]["ay"]) - float(flight["ay"]))
            push = larger(push, change)
        else:
            core += 1
    return push, core


def take_in_pushed(flights: Table[FlightRow], bodies: Table[BodyRow], count: int, tau: float, speed: float) -> bool:
    """True if bodies outside of the core are pushed so that they change by a speed within a tick; they are wanted."""
    found = False
    for k in range(count):
        if bodies[k]["core"] == 0:
            flight = flights[bodies[k]["ball"]]
            change = length(float(bodies[k]["ax"]) - float(flight["ax"]), float(bodies[k]["ay"]) - float(flight["ay"]))
            if change * tau > speed:
                bodies[k]["core"] = WANTED
                found = True
    return found
