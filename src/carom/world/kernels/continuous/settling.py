"""Islands solved: at a tick of their own time, and at each event of one of their balls for what remains of the tick.

Velocities first, then places, then accelerations, with which every ball flies on until the next solve.
"""

from __future__ import annotations

from math import inf

from carom.constants import (
    ISLAND_OPEN,
    MOTION_SHARE,
    QUIET_PULL,
    QUIET_SPEED,
    QUIET_TICKS,
    REST_SHARE,
    SETTLED_SHARE,
    SQUEEZE_DEEP,
    TICK_SHARE,
)
from carom.geometry.instants import later
from carom.geometry.vector import larger, length, smaller
from carom.rows.ball import BallRow
from carom.rows.flight import NO_SHAPE, NO_TICK, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.pose import is_moving
from carom.rows.relation import LASTING, LYING, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import arrive, energy_of, work_of_shift
from carom.world.kernels.continuous.encounter import keep_push_out
from carom.world.kernels.continuous.flight import begins_now, fall_freely, is_crowded, let_fly, let_sleep
from carom.world.kernels.continuous.island import (
    aim_at_middle,
    collect,
    dismiss,
    fill_body,
    fill_contacts,
    find_surface,
    lies,
    part,
    pull_on,
    rest_speed_of,
    tick_length,
)
from carom.world.kernels.continuous.lasting import hold
from carom.world.kernels.continuous.ledger import island_energy, take_energy
from carom.world.kernels.continuous.places import resolve_places
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.relaxation import contact_speed
from carom.world.kernels.continuous.resolve import aim_contacts, resolve_accelerations, resolve_velocities
from carom.world.kernels.continuous.spreading import resolve_impact
from carom.world.kernels.step.relations import add_relation, drop_kind, set_force, set_no_forces


def settle(
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
    """The number of balls of the islands of one or two (the second may be NO_BALL), which are listed in `bodies`.

    `struck` after an impact. All of them are solved for a tick that begins now. There must be room for what they
    begin to pass.
    """
    bodies, contacts = island
    count = collect(balls, flights, relations, bodies, first, second)
    for k in range(count):
        i = row_of(bodies[k]["ball"])
        begin_now(state, balls, shapes, index, cells, members, flights, relations, i)
        let_fly(state, balls[i], flights[i])
        fall_freely(state, balls[i], flights[i])
        fill_body(state, balls[i], flights[i], bodies[k])
        bodies[k]["gx"] = flights[i]["ax"]
        bodies[k]["gy"] = flights[i]["ay"]
    found = fill_contacts(state, balls, flights, shapes, relations, island, count)
    counts = (count, found)
    pull, _turning, radius, fastest = pull_on(bodies, contacts, shapes, counts)
    speed = rest_speed_of(pull, radius, fastest)
    frame, moved = frame_of(bodies, contacts, shapes, counts)
    debt = 0.0 if moved else pay_surplus(flights, bodies, count, frame)
    if struck:
        resolve_impact(bodies, contacts, counts, speed)
    resolve_velocities(bodies, contacts, counts, tolerance_of(speed, SETTLED_SHARE, fastest))
    # An impact may have thrown somebody onto a bend, where it is to be solved soon.
    pull, turning, radius, _fastest = pull_on(bodies, contacts, shapes, counts)
    tau = tick_length(pull, turning, radius)
    debt += shift_places(state, balls, shapes, index, cells, members, relations, island, counts, frame, moved)
    if pull > 0.0 and tau < inf:
        aim_at_middle(state, shapes, island, found, tau)
        resolve_accelerations(bodies, contacts, counts, tau, tolerance_of(tau * pull, TICK_SHARE, fastest))
    else:
        fly_straight(bodies, contacts, counts)
    store_forces(balls, relations, island, found)
    end_contacts(
        state, balls, shapes, index, cells, members, flights, relations, island, counts, speed, pull > 0.0
    )  # fmt: skip
    time, low = later(float(state["now"]), float(state["now_low"]), tau) if tau < inf else (NO_TICK, 0.0)
    put_back(state, balls, flights, bodies, count, debt, (time, low))
    fall_asleep(state, balls, flights, bodies, count, pull, speed, moved)
    let_loose(state, balls, flights, shapes, relations, bodies, count)
    return count


def tolerance_of(scale: float, share: float, fastest: float) -> float:
    """The speed down to which an island is solved: a share of a scale at most, and less the slower its balls are."""
    return larger(REST_SHARE * scale, smaller(share * scale, MOTION_SHARE * fastest))


def begin_now(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
) -> None:
    """Begin a new flight of a ball now; of one that has begun now, what others have foreseen with it counts no more."""
    if begins_now(state, flights[i]):
        flights[i]["version"] += 1
    else:
        arrive(state, balls, shapes, index, cells, members, flights, relations, i, NO_SHAPE)


def let_loose(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
    count: int,
) -> None:
    """Dismiss the balls of an island; those that lie on none any more fly by themselves, or as shapes hold them.

    What these have won the others have from now on: what a contact has done to one of two balls it has taken from the
    other, so it stays in the ledger until it is paid.
    """
    dismiss(flights, bodies, count)
    surplus, mass = 0.0, 0.0
    for k in range(count):
        i = row_of(bodies[k]["ball"])
        if lies(relations, balls[i]):
            mass += float(balls[i]["mass"])
        else:
            surplus += let_go(state, balls[i], flights[i], shapes, relations)
    if surplus != 0.0 and mass > 0.0:
        for k in range(count):
            i = row_of(bodies[k]["ball"])
            if lies(relations, balls[i]):
                flights[i]["surplus"] += surplus / mass


def let_go(
    state: StateRow, ball: BallRow, flight: FlightRow, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> float:
    """What a ball has won in the island that it leaves, and by being put onto the shapes that hold it now."""
    x, y = float(ball["x"]), float(ball["y"])
    surplus = float(ball["mass"]) * float(flight["surplus"])
    flight["tick_time"] = NO_TICK
    flight["tick_low"] = 0.0
    flight["quiet"] = 0
    flight["surplus"] = 0.0
    set_no_forces(relations, ball)
    hold(state, ball, flight, shapes, relations, True)
    return surplus + work_of_shift(state, ball, x, y)


def frame_of(
    bodies: Table[BodyRow],
    contacts: Table[IslandContactRow],
    shapes: Table[ShapeRow],
    counts: tuple[int, int],
) -> tuple[tuple[float, float], bool]:
    """The velocity of the frame in which an island's energy counts; whether a moving shape holds it.

    That of its centre of mass where no shape holds it: what is taken out of it then takes no momentum.
    """
    body_count, count = counts
    held, moved = False, False
    for q in range(count):
        if contacts[q]["second"] == NO_BODY:
            held = True
            moved = moved or is_moving(shapes[contacts[q]["shape"]])
    if held:
        return (0.0, 0.0), moved
    mass, px, py = 0.0, 0.0, 0.0
    for k in range(body_count):
        body = bodies[k]
        mass += float(body["mass"])
        px += float(body["mass"]) * float(body["vx"])
        py += float(body["mass"]) * float(body["vy"])
    return (px / mass, py / mass), moved


def pay_surplus(flights: Table[FlightRow], bodies: Table[BodyRow], count: int, frame: tuple[float, float]) -> float:
    """The debt that is left of what an island has won since its last solve, which its motion pays."""
    surplus = 0.0
    for k in range(count):
        surplus += float(bodies[k]["mass"]) * float(flights[bodies[k]["ball"]]["surplus"])
    return take_energy(bodies, count, surplus, frame)


def shift_places(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    counts: tuple[int, int],
    frame: tuple[float, float],
    moved: bool,
) -> float:
    """The debt that is left after overlaps have been taken back; what balls are raised by that, their motion pays."""
    bodies, contacts = island
    gravity = (float(state["gravity_x"]), float(state["gravity_y"]))
    _kinetic, before = island_energy(bodies, counts[0], gravity, frame)
    resolve_places(bodies, contacts, counts)
    for k in range(counts[0]):
        body = bodies[k]
        ball = balls[body["ball"]]
        if body["x"] != body["from_x"] or body["y"] != body["from_y"]:
            ball["x"] = body["x"]
            ball["y"] = body["y"]
            keep_push_out(ball, shapes, index, cells, members, relations, float(body["from_x"]), float(body["from_y"]))
            body["x"] = ball["x"]
            body["y"] = ball["y"]
    _kinetic, after = island_energy(bodies, counts[0], gravity, frame)
    for q in range(counts[1]):
        contact = contacts[q]
        if contact["second"] == NO_BODY:
            body = bodies[contact["first"]]
            find_surface(state, body, shapes[contact["shape"]], contact)
    return 0.0 if moved else take_energy(bodies, counts[0], after - before, frame)


def fly_straight(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int]) -> None:
    """Give bodies the accelerations that they have without contacts, and these no forces."""
    for k in range(counts[0]):
        bodies[k]["ax"] = bodies[k]["gx"]
        bodies[k]["ay"] = bodies[k]["gy"]
    for q in range(counts[1]):
        contacts[q]["force"] = 0.0
        contacts[q]["force_x"] = 0.0
        contacts[q]["force_y"] = 0.0


def end_contacts(
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
    speed: float,
    pressed: bool,
) -> None:
    """End the contacts that do not press and have opened, or part fast; all that do not press where nothing pulls.

    A moving shape that has gone far into a ball, which had no room, goes over it. Whoever loses a contact begins a new
    flight first: it has come here as what it was.
    """
    bodies, contacts = island
    for k in range(counts[0]):
        bodies[k]["wx"] = bodies[k]["vx"]
        bodies[k]["wy"] = bodies[k]["vy"]
    aim_contacts(bodies, contacts, counts[1])
    for q in range(counts[1]):
        contact = contacts[q]
        body = bodies[contact["first"]]
        i = row_of(body["ball"])
        opened = contact["gap"] > ISLAND_OPEN * float(body["radius"]) or contact_speed(bodies, contact) > speed
        # Who is between others that leave it no way to go is held by all of them at once.
        kept = pressed or is_crowded(flights[i])
        loose = contact["force"] <= 0.0
        if contact["second"] != NO_BODY:
            j = row_of(bodies[contact["second"]]["ball"])
            if loose and (opened or not (kept or is_crowded(flights[j]))):
                begin_now(state, balls, shapes, index, cells, members, flights, relations, i)
                begin_now(state, balls, shapes, index, cells, members, flights, relations, j)
                part(state, balls, relations, i, j)
            continue
        row = row_of(contact["shape"])
        deep = contact["gap"] < -SQUEEZE_DEEP * float(body["radius"]) and is_moving(shapes[row])
        if deep or (loose and (opened or not kept)):
            begin_now(state, balls, shapes, index, cells, members, flights, relations, i)
            drop_kind(state, relations, balls[i], LASTING, row)
        if deep:
            add_relation(state, relations, balls[i], i, PASSING, row)
            state["squeezed"] += 1


def store_forces(
    balls: Table[BallRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    count: int,
) -> None:
    """Keep the forces of contacts, with which their next solve begins."""
    bodies, contacts = island
    for q in range(count):
        contact = contacts[q]
        i = row_of(bodies[contact["first"]]["ball"])
        force_x, force_y = float(contact["force_x"]), float(contact["force_y"])
        if contact["second"] == NO_BODY:
            set_force(relations, balls[i], LASTING, row_of(contact["shape"]), force_x, force_y)
        else:
            j = row_of(bodies[contact["second"]]["ball"])
            set_force(relations, balls[i], LYING, j, force_x, force_y)
            set_force(relations, balls[j], LYING, i, -force_x, -force_y)


def put_back(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
    count: int,
    debt: float,
    tick: tuple[float, float],
) -> None:
    """Give the balls of an island their velocities and accelerations, and the instant of its next tick.

    The debt that their motion could not pay they have won until it can.
    """
    mass = 0.0
    for k in range(count):
        mass += float(bodies[k]["mass"])
    for k in range(count):
        body = bodies[k]
        ball, flight = balls[body["ball"]], flights[body["ball"]]
        ball["vx"] = body["vx"]
        ball["vy"] = body["vy"]
        flight["ax"] = body["ax"]
        flight["ay"] = body["ay"]
        flight["energy"] = energy_of(state, ball)
        flight["surplus"] = debt / mass
        flight["tick_time"] = tick[0]
        flight["tick_low"] = tick[1]


def fall_asleep(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
    count: int,
    pull: float,
    speed: float,
    moved: bool,
) -> None:
    """Let an island sleep whose balls have hardly moved for some ticks, and which no moving shape holds."""
    all_quiet = not moved
    for k in range(count):
        body = bodies[k]
        flight = flights[body["ball"]]
        slow = length(float(body["vx"]), float(body["vy"])) <= QUIET_SPEED * speed
        quiet = slow and length(float(body["ax"]), float(body["ay"])) <= QUIET_PULL * pull
        flight["quiet"] = int(flight["quiet"]) + 1 if quiet else 0
        all_quiet = all_quiet and flight["quiet"] >= QUIET_TICKS
    if not all_quiet:
        return
    for k in range(count):
        ball, flight = balls[bodies[k]["ball"]], flights[bodies[k]["ball"]]
        let_sleep(state, ball, flight)
        flight["ax"] = 0.0
        flight["ay"] = 0.0
        flight["quiet"] = 0
        flight["energy"] = energy_of(state, ball)
        flight["tick_time"] = NO_TICK
        flight["tick_low"] = 0.0
