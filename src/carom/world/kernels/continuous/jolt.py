"""An event of a ball that lies on others: its impulse and its weight spread as far as they are felt.

What is far from it goes on as it was solved at its island's last tick.
"""

from __future__ import annotations

from carom.constants import JOLT_SHARE, JOLT_TOLERANCE, LEAST_TICK
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, NO_BALL, NO_TICK, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import WANTED, BodyRow, IslandContactRow
from carom.rows.relation import RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import energy_of
from carom.world.kernels.continuous.flight import fall_freely
from carom.world.kernels.continuous.instants import seconds_since
from carom.world.kernels.continuous.island import (
    aim_at_middle,
    dismiss,
    enlist,
    enlist_neighbours,
    fill_body,
    fill_contacts,
    next_tick,
    pull_on,
    rest_speed_of,
    tick_length,
)
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.resolve import adjust_accelerations
from carom.world.kernels.continuous.settling import begin_now, end_contacts, let_loose, settle, store_forces
from carom.world.kernels.continuous.spreading import resolve_impact


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
    count = list_wanted(state, balls, flights, bodies, first, second)
    while True:
        count = widen(state, balls, shapes, index, cells, members, flights, relations, bodies, count)
        time, low = next_tick(flights, bodies, count)
        found = fill_contacts(state, balls, flights, shapes, relations, island, count)
        counts = (count, found)
        pull, turning, radius, fastest = pull_on(bodies, contacts, shapes, counts)
        tau = seconds_since(time, low, float(state["now"]), float(state["now_low"])) if time < NO_TICK else 0.0
        asleep = is_any_asleep(flights, bodies, count)
        if asleep or not pull > 0.0 or tau <= LEAST_TICK * tick_length(pull, turning, radius):
            dismiss(flights, bodies, count)
            return settle(
                state, balls, shapes, index, cells, members, flights, relations, island, first, second, struck
            )  # fmt: skip
        speed = rest_speed_of(pull, radius, fastest)
        resolve_impact(bodies, contacts, counts, speed)
        if not take_in_reached(bodies, count):
            break
    while True:
        aim_at_middle(state, shapes, island, found, tau)
        adjust_accelerations(bodies, contacts, counts, tau, JOLT_TOLERANCE * speed)
        store_forces(balls, relations, island, found)
        if not take_in_pushed(flights, bodies, count, tau, JOLT_SHARE * speed):
            break
        count = widen(state, balls, shapes, index, cells, members, flights, relations, bodies, count)
        found = fill_contacts(state, balls, flights, shapes, relations, island, count)
        counts = (count, found)
    end_contacts(state, balls, shapes, relations, island, counts, speed, True)
    for k in range(count):
        i = row_of(bodies[k]["ball"])
        begin_now(state, balls, shapes, index, cells, members, flights, relations, i)
        fly_on_solved(state, balls[i], flights[i], bodies[k], time, low)
    let_loose(state, balls, flights, shapes, relations, bodies, count)
    return count


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
) -> int:
    """The number of bodies after those that are wanted were taken into the core, and their neighbours listed."""
    known = count
    for k in range(known):
        if bodies[k]["core"] == WANTED:
            begin_now(
                state, balls, shapes, index, cells, members, flights, relations, row_of(bodies[k]["ball"])
            )  # fmt: skip
            listed = count
            count = enlist_neighbours(balls, flights, relations, bodies, count, k)
            for new in range(listed, count):
                fill_body(state, balls[bodies[new]["ball"]], flights[bodies[new]["ball"]], bodies[new])
    return count


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
