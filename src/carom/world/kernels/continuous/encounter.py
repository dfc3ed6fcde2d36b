"""Impacts of balls in flight: with shapes, gates and sensors, and with each other."""

from __future__ import annotations

from math import floor

from carom.constants import JOINT_TURN, PUSH_MOST, SEPARATION_SLACK, SQUEEZE_GAP, TICK_MARGIN
from carom.geometry.response import exchanged, reflected
from carom.geometry.vector import dot, larger, length
from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, FLYING, STALLED, FlightRow
from carom.rows.hit import ENTER, HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import gap_at_rest, lets_pass
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.arrival import time_of
from carom.world.kernels.continuous.flight import fall_freely
from carom.world.kernels.continuous.support import patience, slow_rebound, throw_off
from carom.world.kernels.continuous.surfaces import gap_to_shape, into_frame
from carom.world.kernels.step.hits import record_hit, write_hit
from carom.world.kernels.step.motion import rouse, wake
from carom.world.kernels.step.narrow import limit_speed, push_apart
from carom.world.kernels.step.relations import add_relation, drop_all, find_relation, has_kind
from carom.world.kernels.step.room import ACROSS, barrier, pressed_depth


def impact_with_shape(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    row: int,
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    rest_speed: float,
) -> None:
    """Do what follows from a ball's touching a shape: it bounces, comes to rest, enters a sensor or passes.

    There must be room for a hit and a relation.
    """
    shape = shapes[row]
    time = float(flight["time"])
    if shape["sensor"] != 0 or ball["sensor"] != 0:
        add_relation(state, relations, ball, i, INSIDE_SHAPE, row)
        write_hit(state, hits[state["hits"]], time_of(state, time), ENTER, int(ball["id"]), int(shape["id"]))
        return
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    fx, fy = x, y
    if is_moving(shape):
        fx, fy = into_frame(shape, time, x, y)
    if lets_pass(shape, fx, fy):
        add_relation(state, relations, ball, i, PASSING, row)
        return
    found = gap_to_shape(shape, time, x, y, radius, float(ball["vx"]), float(ball["vy"]))
    if found is None:
        return
    gap, nx, ny = found
    if is_moving(shape) and is_squeezed(ball, shapes, index, state, cells, members, nx, ny):
        state["squeezed"] += 1
        add_relation(state, relations, ball, i, PASSING, row)
        return
    if gap < -SEPARATION_SLACK * radius and not is_moving(shape):
        # It was put there. What two sides push to and fro would go on so for ever, so it stays for now.
        depth = pressed_depth(state, ball, shapes, (index, cells, members), relations, row, nx, ny, -gap)
        across = barrier(state, ball, shapes, (index, cells, members), relations, row, -gap * nx, -gap * ny) == ACROSS
        if across or depth > SEPARATION_SLACK * radius:
            state["squeezed"] += 1
            flight["kind"] = STALLED
            fall_freely(state, flight)
            return
    if gap < 0.0:
        ball["x"] = x - gap * nx
        ball["y"] = y - gap * ny
    bounce(state, ball, flight, i, shapes, row, hits, relations, rest_speed, gap, nx, ny)


def bounce(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    row: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    rest_speed: float,
    gap: float,
    nx: float,
    ny: float,
) -> None:
    """Turn a touching ball's velocity if it approaches, record the hit, and let the contact last if it would."""
    shape = shapes[row]
    time = float(flight["time"])
    radius, vx, vy = float(ball["radius"]), float(ball["vx"]), float(ball["vy"])
    px, py = float(ball["x"]) - radius * nx, float(ball["y"]) - radius * ny
    ux, uy = surface_velocity(shape, float(shape["spin"]), px, py, time)
    s = dot(vx - ux, vy - uy, nx, ny)
    elasticity = float(ball["elasticity"]) * float(shape["elasticity"])
    kick = float(shape["kick"])
    if s < 0.0 and -s <= JOINT_TURN * length(vx - ux, vy - uy) and has_kind(relations, ball, LASTING):
        # It comes over a joint that is not quite even; held by the piece before, it would meet this one for ever.
        ball["vx"] = vx - s * nx
        ball["vy"] = vy - s * ny
        drop_all(state, relations, ball, LASTING)
    elif s < 0.0:
        if (
            elasticity < 1.0
            and kick == 0.0
            and -s < larger(rest_speed, slow_rebound(state, shape, ball, flight, nx, ny, elasticity))
        ):
            ball["vx"] = vx - s * nx
            ball["vy"] = vy - s * ny
        else:
            total = state["total_restitution"] != 0
            new_x, new_y, gain = reflected(vx, vy, ux, uy, nx, ny, elasticity, s, kick, total)
            ball["vx"] = new_x
            ball["vy"] = new_y
            limit_speed(state, ball)
            setback, speed = max(-gap, 0.0), length(vx - ux, vy - uy)
            impulse = gain * float(ball["mass"])
            touch = (px, py, nx, ny, setback)
            record_hit(state, hits[state["hits"]], time_of(state, time), ball, shape, touch, speed, impulse)
    slowest = slow_rebound(state, shape, ball, flight, nx, ny, elasticity) if kick == 0.0 else 0.0
    u = dot(float(ball["vx"]) - ux, float(ball["vy"]) - uy, nx, ny)
    if slowest > 0.0 and u <= slowest:
        ball["vx"] -= u * nx
        ball["vy"] -= u * ny
        add_relation(state, relations, ball, i, LASTING, row)
    elif s < 0.0:
        throw_off(state, ball, time, shapes, relations, nx, ny)


def is_squeezed(
    ball: BallRow,
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    state: StateRow,
    cells: Table[CellRow],
    members: Table[int],
    nx: float,
    ny: float,
) -> bool:
    """True if a ball that a moving shape pushes along its normal has next to no room before a static shape."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    # The index gives the shapes that a ball touches, so it is asked where the ball would touch what is near it.
    ahead = 2.0 * SQUEEZE_GAP * radius
    cell = locate(state, index[FIXED], cells, x + ahead * nx, y + ahead * ny)
    if cell < 0:
        return False
    for k in range(int(cells[cell]["begin"]), int(cells[cell]["end"])):
        shape = shapes[members[k]]
        if shape["sensor"] == 0 and may_collide(ball, shape):
            found = gap_at_rest(shape, x, y, radius, nx, ny, 0.0)
            if found is not None:
                gap, wall_x, wall_y = found
                if gap < SQUEEZE_GAP * radius and dot(nx, ny, wall_x, wall_y) < -0.5:
                    return not lets_pass(shape, x, y)
    return False


def impact_of_balls(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    i: int,
    j: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    rest_speed: float,
) -> bool:
    """Do what follows from two balls' touching: `i` before `j` by row. True if a push has moved them.

    There must be room for a hit and a relation.
    """
    first, second = balls[i], balls[j]
    now = float(flights[i]["time"])
    dx, dy = float(second["x"]) - float(first["x"]), float(second["y"]) - float(first["y"])
    if first["sensor"] != 0 or second["sensor"] != 0:
        add_relation(state, relations, second, j, INSIDE_BALL, i)
        write_hit(state, hits[state["hits"]], time_of(state, now), ENTER, int(second["id"]), int(first["id"]))
        return False
    vx, vy = velocity_in_flight(first, flights[i])
    wx, wy = velocity_in_flight(second, flights[j])
    away = length(dx, dy)
    if away == 0.0:
        state["overlaps"] += 1
        dx, dy = vx - wx, vy - wy
        if dx == 0.0 and dy == 0.0:
            dy = 1.0
        nx, ny = dx / length(dx, dy), dy / length(dx, dy)
    else:
        nx, ny = dx / away, dy / away
    reach = float(first["radius"]) + float(second["radius"])
    setback = max(reach - away, 0.0)
    pushed = setback > SEPARATION_SLACK * reach
    if pushed:
        part_balls(first, flights[i], second, flights[j], nx, ny, setback)
    u1, u2 = dot(vx, vy, nx, ny), dot(wx, wy, nx, ny)
    elasticity = float(first["elasticity"]) * float(second["elasticity"])
    wait, quiet = patience(state, first, flights[i], second, flights[j])
    if u2 - u1 >= 0.0:
        be_patient(flights[i], flights[j], now, wait)
        return pushed
    resting = elasticity < 1.0 and u1 - u2 < larger(rest_speed, quiet)
    if resting:
        # Slow as they are, they move; at the substep's end they fall asleep again if they are slow still.
        stir(state, first, flights[i])
        stir(state, second, flights[j])
    gain = exchange(first, flights[i], second, flights[j], u1, u2, nx, ny, 0.0 if resting else elasticity)
    if resting:
        be_patient(flights[i], flights[j], now, wait)
        return pushed
    flights[i]["patience"] = 0.0
    flights[j]["patience"] = 0.0
    let_fly(state, first, flights[i])
    let_fly(state, second, flights[j])
    limit_speed(state, first)
    limit_speed(state, second)
    px, py = float(first["x"]) + float(first["radius"]) * nx, float(first["y"]) + float(first["radius"]) * ny
    speed = length(wx - vx, wy - vy)
    touch = (px, py, nx, ny, setback)
    record_hit(state, hits[state["hits"]], time_of(state, now), second, first, touch, speed, gain)
    return pushed


def be_patient(flight: FlightRow, partner: FlightRow, now: float, wait: float) -> None:
    """Let two balls that rest on each other, or are pressed together, meet again after a wait only.

    All wait for the same ticks, so one that meets another meanwhile does not put off the first.
    """
    until = (floor(now / wait + TICK_MARGIN) + 1.0) * wait
    flight["patience"] = until
    partner["patience"] = until


def velocity_in_flight(ball: BallRow, flight: FlightRow) -> tuple[float, float]:
    """The velocity with which a ball meets others: none, if it stands still for the rest of the substep."""
    if flight["kind"] == FLYING:
        return float(ball["vx"]), float(ball["vy"])
    return 0.0, 0.0


def part_balls(
    first: BallRow, one: FlightRow, second: BallRow, other: FlightRow, nx: float, ny: float, setback: float
) -> None:
    """Move two balls apart until they touch; one that stands still stays where it is."""
    if one["kind"] != STALLED and other["kind"] != STALLED:
        push_apart(first, second, nx, ny, setback)
    elif one["kind"] != STALLED:
        first["x"] -= setback * nx
        first["y"] -= setback * ny
    elif other["kind"] != STALLED:
        second["x"] += setback * nx
        second["y"] += setback * ny


def keep_push_out(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    from_x: float,
    from_y: float,
) -> None:
    """Take from a push, which moved a ball from (from_x, from_y), what is more than PUSH_MOST or goes into a shape."""
    radius = float(ball["radius"])
    dx, dy = float(ball["x"]) - from_x, float(ball["y"]) - from_y
    way = length(dx, dy)
    if way == 0.0:
        return
    if way > PUSH_MOST * radius:
        dx, dy = dx * (PUSH_MOST * radius / way), dy * (PUSH_MOST * radius / way)
    for _ in range(2):
        begin, end = cell_span(cells, locate(state, index[FIXED], cells, from_x + dx, from_y + dy))
        for k in range(begin, end):
            row = int(members[k])
            shape = shapes[row]
            if shape["sensor"] != 0 or ball["sensor"] != 0 or not may_collide(ball, shape):
                continue
            if find_relation(relations, ball, PASSING, row):
                continue
            found = gap_to_shape(shape, 0.0, from_x, from_y, radius, dx, dy)
            if found is None:
                continue
            gap, nx, ny = found
            over = -(dx * nx + dy * ny) - max(gap, 0.0)
            if over > 0.0:
                dx += over * nx
                dy += over * ny
    ball["x"] = from_x + dx
    ball["y"] = from_y + dy


def exchange(
    first: BallRow,
    one: FlightRow,
    second: BallRow,
    other: FlightRow,
    u1: float,
    u2: float,
    nx: float,
    ny: float,
    elasticity: float,
) -> float:
    """The momentum that the second ball gets along the normal when two balls that approach bounce.

    One that stands still for the rest of the substep is met as a wall, and keeps its velocity.
    """
    m1, m2 = float(first["mass"]), float(second["mass"])
    if one["kind"] != STALLED and other["kind"] != STALLED:
        new1, new2 = exchanged(u1, u2, m1, m2, elasticity)
    elif one["kind"] == STALLED:
        new1, new2 = u1, u1 - elasticity * (u2 - u1)
    else:
        new1, new2 = u2 - elasticity * (u1 - u2), u2
    if one["kind"] != STALLED:
        first["vx"] += (new1 - u1) * nx
        first["vy"] += (new1 - u1) * ny
    if other["kind"] != STALLED:
        second["vx"] += (new2 - u2) * nx
        second["vy"] += (new2 - u2) * ny
    return m2 * (new2 - u2) if other["kind"] != STALLED else m1 * (u1 - new1)


def let_fly(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Wake a ball that was hit and let it fly from now on."""
    if flight["kind"] == ASLEEP:
        wake(state, ball)
        flight["kind"] = FLYING
        fall_freely(state, flight)


def stir(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Let a sleeping ball fly for the rest of the substep."""
    if flight["kind"] == ASLEEP:
        rouse(state, ball)
        flight["kind"] = FLYING
        fall_freely(state, flight)


def count_impact(state: StateRow, flight: FlightRow) -> None:
    """Count an impact of a ball, and stop the ball for the rest of the substep if it has had too many."""
    flight["impacts"] += 1
    if flight["impacts"] >= state["max_impacts"] and flight["kind"] == FLYING:
        flight["kind"] = STALLED
        fall_freely(state, flight)
        state["stalled"] += 1
