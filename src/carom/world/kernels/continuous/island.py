"""Who an island is made of: the balls that lie on each other, and their contacts with each other and with shapes."""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import ISLAND_TICK, ISLAND_TURN, REBOUND, STILL_SPEED
from carom.geometry.vector import dot, larger, length, smaller
from carom.rows.ball import BallRow
from carom.rows.flight import NO_BALL, NO_TICK, FlightRow
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.relation import LASTING, LYING, NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import age_of_mover
from carom.world.kernels.continuous.arrival import keep_course
from carom.world.kernels.continuous.filling import fills_bend
from carom.world.kernels.continuous.flight import age_now, is_crowded, place_after
from carom.world.kernels.continuous.lasting import leave_points, may_hold
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.surfaces import center_of_bend, gap_to_shape
from carom.world.kernels.step.relations import add_relation, drop_kind, drop_relation, find_relation, has_kind


def lies(relations: Table[RelationRow], ball: BallRow) -> bool:
    """True for a ball that is pressed against another one."""
    return ball["relation"] != NO_RELATION and has_kind(relations, ball, LYING)


def is_solved(relations: Table[RelationRow], ball: BallRow, flight: FlightRow) -> bool:
    """True for a ball whose island is to be solved at its events.

    One that lay on others which were taken away has its tick still, until it is solved alone.
    """
    return bool(flight["tick_time"] < NO_TICK) or lies(relations, ball)


def join(state: StateRow, balls: Table[BallRow], relations: Table[RelationRow], i: int, j: int) -> None:
    """Let two balls lie on each other; there must be room for two relations."""
    if not find_relation(relations, balls[i], LYING, j):
        add_relation(state, relations, balls[i], i, LYING, j)
        add_relation(state, relations, balls[j], j, LYING, i)


def part(state: StateRow, balls: Table[BallRow], relations: Table[RelationRow], i: int, j: int) -> None:
    """Let two balls lie on each other no more."""
    drop_kind(state, relations, balls[i], LYING, j)
    drop_kind(state, relations, balls[j], LYING, i)


def part_from_all(state: StateRow, balls: Table[BallRow], relations: Table[RelationRow], i: int) -> None:
    """Let a ball lie on no other any more."""
    place = int(balls[i]["relation"])
    while place != NO_RELATION:
        following = int(relations[place]["next"])
        if relations[place]["kind"] == LYING:
            part(state, balls, relations, i, row_of(relations[place]["other"]))
        place = following


def collect(
    balls: Table[BallRow],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
    first: int,
    second: int,
) -> int:
    """The number of balls that lie on one of two (the second may be NO_BALL), directly or not, with these.

    They are listed in `bodies`; their flights tell their places until they are dismissed.
    """
    count = enlist(flights, bodies, 0, first)
    if second != NO_BALL:
        count = enlist(flights, bodies, count, second)
    k = 0
    while k < count:
        count = enlist_neighbours(balls, flights, relations, bodies, count, k)
        k += 1
    return count


def enlist_neighbours(
    balls: Table[BallRow],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
    count: int,
    k: int,
) -> int:
    """The number of bodies with those among them that lie on body `k`, which is in the core of the island then."""
    bodies[k]["core"] = 1
    place = int(balls[bodies[k]["ball"]]["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LYING:
            count = enlist(flights, bodies, count, row_of(relations[place]["other"]))
        place = int(relations[place]["next"])
    return count


def enlist(flights: Table[FlightRow], bodies: Table[BodyRow], count: int, ball: int) -> int:
    """The number of bodies with a ball among them."""
    if flights[ball]["body"] != 0:
        return count
    bodies[count]["ball"] = ball
    bodies[count]["core"] = 0
    flights[ball]["body"] = count + 1
    return count + 1


def dismiss(flights: Table[FlightRow], bodies: Table[BodyRow], count: int) -> None:
    """Forget the places of balls in an island."""
    for k in range(count):
        flights[bodies[k]["ball"]]["body"] = 0


def hasten(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    bodies: Table[BodyRow],
    i: int,
) -> None:
    """Let the island of a ball be solved now."""
    count = collect(balls, flights, relations, bodies, i, NO_BALL)
    dismiss(flights, bodies, count)
    for k in range(count):
        i = row_of(bodies[k]["ball"])
        keep_course(state, balls[i], flights, i)
        flight = flights[i]
        flight["tick_time"] = state["now"]
        flight["tick_low"] = state["now_low"]


def fill_body(state: StateRow, ball: BallRow, flight: FlightRow, body: BodyRow) -> None:
    """Give a body of an island what its ball is now, whether its flight begins now or not."""
    x, y, vx, vy = place_after(ball, flight, age_now(state, flight))
    body["x"] = x
    body["y"] = y
    body["vx"] = vx
    body["vy"] = vy
    body["ax"] = flight["ax"]
    body["ay"] = flight["ay"]
    body["gx"] = state["gravity_x"]
    body["gy"] = state["gravity_y"]
    body["radius"] = ball["radius"]
    body["mass"] = ball["mass"]
    body["inverse_mass"] = 1.0 / float(ball["mass"])


def fill_contacts(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    count: int,
) -> int:
    """The number of contacts of an island's core, which are listed: pairs, moving shapes, those that stand still.

    So what stands still has the last word. Contacts with what a ball is not beside any more, or may not meet, end.
    """
    bodies, contacts = island
    found = 0
    for k in range(count):
        if bodies[k]["core"] == 0:
            continue
        i = row_of(bodies[k]["ball"])
        leave_points(state, balls[i], flights[i], shapes, relations)
        place = int(balls[i]["relation"])
        while place != NO_RELATION:
            if relations[place]["kind"] == LYING:
                other = row_of(relations[place]["other"])
                partner = int(flights[other]["body"]) - 1
                if partner < k or bodies[partner]["core"] == 0:
                    contact = contacts[found]
                    clear(contact, k, partner, float(relations[place]["force_x"]), float(relations[place]["force_y"]))
                    crowded = is_crowded(flights[i]) or is_crowded(flights[other])
                    elasticity = float(balls[i]["elasticity"]) * float(balls[other]["elasticity"])
                    contact["elasticity"] = 0.0 if crowded else elasticity
                    found += 1
            place = int(relations[place]["next"])
    for moving in range(1, -1, -1):
        for k in range(count):
            if bodies[k]["core"] == 0:
                continue
            found = fill_shapes(state, balls, flights, shapes, relations, island, found, k, moving == 1)
    return found


def fill_shapes(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    found: int,
    k: int,
    moving: bool,
) -> int:
    """The number of contacts with those of a body with shapes that move, or stand still, after them."""
    bodies, contacts = island
    i = row_of(bodies[k]["ball"])
    before = NO_RELATION
    place = int(balls[i]["relation"])
    while place != NO_RELATION:
        row = row_of(relations[place]["other"])
        ends = False
        if relations[place]["kind"] == LASTING and is_moving(shapes[row]) == moving:
            contact = contacts[found]
            clear(contact, k, NO_BODY, float(relations[place]["force_x"]), float(relations[place]["force_y"]))
            contact["shape"] = row
            elasticity = float(balls[i]["elasticity"]) * float(shapes[row]["elasticity"])
            contact["elasticity"] = 0.0 if is_crowded(flights[i]) else elasticity
            held = may_hold(balls[i], flights[i], shapes[row], True)
            ends = not (held and find_surface(state, bodies[k], shapes[row], contact))
            found += 0 if ends else 1
        if ends:
            place = drop_relation(state, relations, balls[i], place, before)
        else:
            before = place
            place = int(relations[place]["next"])
    return found


def clear(contact: IslandContactRow, first: int, second: int, force_x: float, force_y: float) -> None:
    """Begin a contact with the force that it had."""
    contact["first"] = first
    contact["second"] = second
    contact["lasting"] = 1
    contact["force"] = length(force_x, force_y)
    contact["force_x"] = force_x
    contact["force_y"] = force_y
    contact["impulse"] = 0.0
    contact["bend"] = 0.0
    contact["gap"] = 0.0
    contact["start_bias"] = 0.0
    contact["holds"] = 0


def find_surface(state: StateRow, body: BodyRow, shape: ShapeRow, contact: IslandContactRow) -> bool:
    """True if a body is beside a shape; the contact then has its gap, normal and bend, and the surface's velocity."""
    x, y, radius = float(body["x"]), float(body["y"]), float(body["radius"])
    age = age_of_mover(state, shape) if is_moving(shape) else 0.0
    found = gap_to_shape(shape, age, x, y, radius, float(body["vx"]), float(body["vy"]))
    if found is None:
        return False
    gap, nx, ny = found
    contact["gap"] = gap
    contact["start_nx"] = nx
    contact["start_ny"] = ny
    contact["start_bias"] = -surface_speed(shape, age, x, y, radius, nx, ny)
    center = center_of_bend(shape, age)
    if center is not None and not fills_bend(shape, age, x, y, radius):
        cx, cy = center
        contact["bend"] = dot(cx - x, cy - y, nx, ny)
    return True


def surface_speed(shape: ShapeRow, age: float, x: float, y: float, radius: float, nx: float, ny: float) -> float:
    """The speed along a normal of the place of a shape that a ball touches."""
    if not is_moving(shape):
        return 0.0
    ux, uy = surface_velocity(shape, float(shape["spin"]), x - radius * nx, y - radius * ny, age)
    return dot(ux, uy, nx, ny)


def aim_at_middle(
    state: StateRow,
    shapes: Table[ShapeRow],
    island: tuple[Table[BodyRow], Table[IslandContactRow]],
    count: int,
    tau: float,
) -> None:
    """Give contacts with shapes the normals for the mean velocity of a tick.

    Inside what is bent and on what is straight that of the tick's middle, outside of what is bent that of its start:
    the other way round contacts would do work.
    """
    bodies, contacts = island
    for q in range(count):
        contact = contacts[q]
        if contact["second"] != NO_BODY:
            continue
        body = bodies[contact["first"]]
        shape = shapes[contact["shape"]]
        nx, ny, bias = float(contact["start_nx"]), float(contact["start_ny"]), float(contact["start_bias"])
        if contact["bend"] >= 0.0:
            half, radius = 0.5 * tau, float(body["radius"])
            x, y = float(body["x"]) + half * float(body["vx"]), float(body["y"]) + half * float(body["vy"])
            age = age_of_mover(state, shape) + half if is_moving(shape) else 0.0
            found = gap_to_shape(shape, age, x, y, radius, float(body["vx"]), float(body["vy"]))
            if found is not None and (is_moving(shape) or contact["bend"] > 0.0):
                _gap, mx, my = found
                # Deep in it, or past its end, it may show another side.
                if dot(mx, my, nx, ny) > 0.5:
                    nx, ny = mx, my
                    bias = -surface_speed(shape, age, x, y, radius, nx, ny)
        contact["mean_nx"] = nx
        contact["mean_ny"] = ny
        contact["mean_bias"] = bias


def pull_on(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], shapes: Table[ShapeRow], counts: tuple[int, int]
) -> tuple[float, float, float, float]:
    """What presses an island together, and the scales of its motion: (pull, turning, radius, fastest).

    The largest acceleration of a ball, by what pulls it or by the bend along which it slides; the largest rate at which
    a contact's normal turns; the least radius; and the largest speed of a ball or a surface.
    """
    body_count, count = counts
    pull, turning, radius, fastest = 0.0, 0.0, inf, 0.0
    for k in range(body_count):
        body = bodies[k]
        pull = larger(pull, length(float(body["gx"]), float(body["gy"])))
        radius = smaller(radius, float(body["radius"]))
        fastest = larger(fastest, length(float(body["vx"]), float(body["vy"])))
    for q in range(count):
        contact = contacts[q]
        first = bodies[contact["first"]]
        vx, vy = float(first["vx"]), float(first["vy"])
        bend, spin = float(contact["bend"]), 0.0
        if contact["second"] != NO_BODY:
            second = bodies[contact["second"]]
            vx -= float(second["vx"])
            vy -= float(second["vy"])
            bend = float(first["radius"]) + float(second["radius"])
        elif is_moving(shapes[contact["shape"]]):
            shape = shapes[contact["shape"]]
            spin = fabs(float(shape["spin"]))
            vx -= float(shape["velocity_x"])
            vy -= float(shape["velocity_y"])
        if bend != 0.0:
            speed = length(vx, vy)
            turning = larger(turning, speed / fabs(bend) + spin)
            pull = larger(pull, speed * speed / fabs(bend))
        elif spin > 0.0:
            turning = larger(turning, spin)
            pull = larger(pull, spin * length(vx, vy))
        fastest = larger(fastest, fabs(float(contact["start_bias"])))
    return pull, turning, radius, fastest


def tick_length(pull: float, turning: float, radius: float) -> float:
    """The seconds after which an island is to be solved anew; infinite if nothing presses or turns it."""
    tick = ISLAND_TICK * sqrt(radius / pull) if pull > 0.0 else inf
    return smaller(tick, ISLAND_TURN / turning) if turning > 0.0 else tick


def tick_of(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], shapes: Table[ShapeRow], counts: tuple[int, int]
) -> float:
    """The same for an island as its bodies move now."""
    pull, turning, radius, _fastest = pull_on(bodies, contacts, shapes, counts)
    return tick_length(pull, turning, radius)


def rest_speed_of(pull: float, radius: float, fastest: float) -> float:
    """The speed below which a contact of an island does not rebound."""
    return sqrt(2.0 * REBOUND * pull * radius) if pull > 0.0 else STILL_SPEED * fastest


def next_tick(flights: Table[FlightRow], bodies: Table[BodyRow], count: int) -> tuple[float, float]:
    """The instant of the earliest tick of the islands whose balls these are; NO_TICK if none has one."""
    time, low = NO_TICK, 0.0
    for k in range(count):
        flight = flights[bodies[k]["ball"]]
        tick, tick_low = float(flight["tick_time"]), float(flight["tick_low"])
        if tick < time or (tick == time and tick_low < low):
            time, low = tick, tick_low
    return time, low
