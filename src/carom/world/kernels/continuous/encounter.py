"""Impacts of balls in flight: with shapes, gates and sensors, and with each other."""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import (
    JOINT_TURN,
    LEAST_PART,
    LEAST_SQUARE,
    LIFT,
    MOST_AT_ONCE,
    PUSH_MOST,
    SEPARATION_SLACK,
    SHORT_GAP,
)
from carom.geometry.gap import placed
from carom.geometry.response import exchanged, rebounded
from carom.geometry.vector import cross, dot, larger, length
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.hit import ENTER, HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import lacks_room, lets_pass
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, reach_of, surface_velocity
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import is_any_near, kinematic_near, next_near
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.arrival import work_of_shift
from carom.world.kernels.continuous.flight import count_impact, is_tired, let_fly
from carom.world.kernels.continuous.island import is_solved, join, lies
from carom.world.kernels.continuous.lasting import end_thrown, lasting_speed, slow_rebound
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.sensing import cross_edge
from carom.world.kernels.continuous.squeezing import is_squeezed
from carom.world.kernels.continuous.surfaces import age_of_motion, center_of_bend, gap_to_shape, into_frame
from carom.world.kernels.step.hits import cross_ball, record_hit
from carom.world.kernels.step.narrow import limit_speed, push_apart
from carom.world.kernels.step.relations import add_relation, drop_all, find_relation, has_kind
from carom.world.kernels.step.spending import spend


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
) -> None:
    """Do what follows from a ball's touching a shape: it bounces, comes to rest, enters a sensor or passes.

    There must be room for a hit and a relation.
    """
    shape = shapes[row]
    if shape["sensor"] != 0 or ball["sensor"] != 0:
        add_relation(state, relations, ball, i, INSIDE_SHAPE, row)
        cross_edge(state, hits, ENTER, ball, flight, shape)
        return
    time = age_of_motion(shape, flight)
    let_fly(state, ball, flight)
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    fx, fy = x, y
    if is_moving(shape):
        fx, fy = into_frame(shape, time, x, y)
    if lets_pass(shape, fx, fy):
        add_relation(state, relations, ball, i, PASSING, row)
        return
    found = gap_to_shape(shape, time, x, y, radius, float(ball["vx"]), float(ball["vy"]))
    if found is None:
        # Rounding has put it beside the shape when it was foreseen, and beyond an end now; it may do so without end.
        flight["at_once"] += 1
        if flight["at_once"] >= MOST_AT_ONCE:
            flight["at_once"] = 0
            add_relation(state, relations, ball, i, PASSING, row)
        return
    gap, nx, ny = found
    # One at rest may have been put onto the ball.
    pushes = is_moving(shape) or (shape["motion"] == KINEMATIC and gap < -LIFT * radius)
    # In what is smaller than itself a ball would be put from one side onto the other, without end.
    stuck = flight["at_once"] >= MOST_AT_ONCE or lacks_room(shape, fx, fy, radius)
    if stuck or (pushes and is_squeezed(ball, flight, shapes, index, cells, members, row, max(-gap, 0.0), nx, ny)):
        flight["at_once"] = 0
        state["squeezed"] += 1
        add_relation(state, relations, ball, i, PASSING, row)
        return
    if gap <= LIFT * radius:
        # From both sides: what is pushed out where it is too deep, and left where it is short, gains with every impact.
        # What a moving shape's frame rounds is more than that, and not of one kind: there it is always put.
        scale = 0.0 if is_moving(shape) else fabs(x) + fabs(y) + radius + reach_of(shape)
        ball["x"], ball["y"] = placed(x, y, gap, nx, ny, scale)
        if is_solved(relations, ball, flight):
            flight["surplus"] += work_of_shift(state, ball, x, y) / float(ball["mass"])
    bounce(state, ball, flight, i, shapes, row, hits, relations, gap, nx, ny)
    if not lies(relations, ball) and is_tired(flight, float(ball["elasticity"]) * float(shape["elasticity"]), False):
        stop_between(ball, flight, shapes, index, cells, members, row, nx, ny)


def bounce(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    row: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    gap: float,
    nx: float,
    ny: float,
) -> None:
    """Turn a touching ball's velocity if it approaches, record the hit, and let the contact last if it would."""
    shape = shapes[row]
    rest_speed = float(state["rest_speed"])
    time = age_of_motion(shape, flight)
    radius, vx, vy = float(ball["radius"]), float(ball["vx"]), float(ball["vy"])
    px, py = float(ball["x"]) - radius * nx, float(ball["y"]) - radius * ny
    ux, uy = surface_velocity(shape, float(shape["spin"]), px, py, time)
    s = dot(vx - ux, vy - uy, nx, ny)
    elasticity = float(ball["elasticity"]) * float(shape["elasticity"])
    kick = float(shape["kick"])
    # What others press on a shape that has got a kick since they lie on it does not even approach.
    approach = -s if s < 0.0 else kick
    count_impact(ball, flight, elasticity, approach, -gap if is_moving(shape) else 0.0)
    tired = is_tired(flight, elasticity, lies(relations, ball))
    elasticity = 0.0 if tired else elasticity
    state["held"] += 1 if tired and s < 0.0 else 0
    # Kicks too would come without end.
    kick = 0.0 if tired else kick
    strikes = s < 0.0 or (kick != 0.0 and s == 0.0)
    lasting = slow_rebound(state, shape, ball, flight, nx, ny, elasticity) if kick == 0.0 else 0.0
    slowest = lasting if rest_speed < 0.0 or lasting == 0.0 else rest_speed
    if tired and (lasting > 0.0 or lies(relations, ball)):
        # Of an island even what nothing presses on, or balls between two heavy ones would go to and fro for long.
        lasting, slowest = max(lasting, LEAST_SQUARE), inf
    if s < 0.0 and -s <= JOINT_TURN * length(vx - ux, vy - uy) and has_kind(relations, ball, LASTING):
        # It comes over a joint that is all but even. The piece before holds it too, up to its end.
        ball["vx"] = vx - s * nx
        ball["vy"] = vy - s * ny
        if lasting == 0.0:
            drop_all(state, relations, ball, LASTING)
    elif strikes:
        rebound = -s * (elasticity if rest_speed < 0.0 else 1.0)
        if kick == 0.0 and (tired or slowest > 0.0) and rebound <= slowest:
            ball["vx"] = vx - s * nx
            ball["vy"] = vy - s * ny
        else:
            touch, surface = (px, py, nx, ny, max(-gap, 0.0)), (ux, uy)
            rebound_off(state, ball, shapes, row, time, hits, touch, surface, elasticity, kick)
    u = dot(float(ball["vx"]) - ux, float(ball["vy"]) - uy, nx, ny)
    if lasting > 0.0 and u <= slowest:
        ball["vx"] -= u * nx
        ball["vy"] -= u * ny
        add_relation(state, relations, ball, i, LASTING, row)
        return
    along = length(vx - ux, vy - uy)
    # What travels with a surface parts from it by what the digits of its own speed can tell.
    speed = larger(along, length(vx, vy))
    if strikes:
        if elasticity == 0.0 and kick == 0.0:
            part_least(ball, speed, nx, ny)
        end_thrown(state, ball, flight, shapes, relations, nx, ny)
    elif u <= LEAST_PART * along:
        # It goes along the surface; rounding alone has found the impact, and would find it again.
        part_least(ball, larger(speed, sqrt(length(float(flight["ax"]), float(flight["ay"])) * radius)), nx, ny)


def rebound_off(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    row: int,
    time: float,
    hits: Table[HitRow],
    touch: tuple[float, float, float, float, float],
    surface: tuple[float, float],
    elasticity: float,
    kick: float,
) -> None:
    """Give a ball the velocity with which it leaves a shape whose surface moves so at the touch, and record the hit."""
    shape = shapes[row]
    _px, _py, nx, ny, _setback = touch
    ux, uy = surface
    vx, vy = float(ball["vx"]), float(ball["vy"])
    mx, my = long_normal(ball, shape, time, nx, ny)
    total = state["total_restitution"] != 0
    new_x, new_y, gain = rebounded(vx, vy, ux, uy, mx, my, elasticity, kick, total)
    ball["vx"] = new_x
    ball["vy"] = new_y
    limit_speed(state, ball)
    # No slower than the surface that pushes it, or that would go through.
    behind = min(dot(float(ball["vx"]) - ux, float(ball["vy"]) - uy, nx, ny), 0.0)
    ball["vx"] -= behind * nx
    ball["vy"] -= behind * ny
    speed, impulse = length(vx - ux, vy - uy), gain * float(ball["mass"])
    record_hit(state, hits[state["hits"]], float(state["now"]), ball, shape, touch, (vx, vy), speed, impulse)
    if shape["once"] != 0:
        spend(state, shapes, shape)


def part_least(ball: BallRow, speed: float, nx: float, ny: float) -> None:
    """Let a ball that came with a speed, all of whose approach is taken, part from the shape by rounding.

    What rounding has left of the approach would be an impact again, at once and without end.
    """
    ball["vx"] += LEAST_PART * speed * nx
    ball["vy"] += LEAST_PART * speed * ny


def stop_between(
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    row: int,
    nx: float,
    ny: float,
) -> None:
    """Leave a ball that has met a shape along a normal, and another one just before, no speed into either.

    Between the two it would come to rest only after impacts without end, each of which leaves it a part of its speed.
    """
    x, y = float(ball["x"]), float(ball["y"])
    begin, end = cell_span(cells, locate(index[FIXED], cells, x, y))
    for k in range(begin, end):
        if row_of(members[k]) != row and is_stopped_by(ball, flight, shapes[row], shapes[members[k]], nx, ny):
            return
    near, wide = kinematic_near(index, cells, x, y)
    while is_any_near(near, wide):
        other, near, wide = next_near(shapes, members, near, wide)
        if other != row and is_stopped_by(ball, flight, shapes[row], shapes[other], nx, ny):
            return


def is_stopped_by(ball: BallRow, flight: FlightRow, shape: ShapeRow, other: ShapeRow, nx: float, ny: float) -> bool:
    """True if a ball, which has met a shape along a normal, goes into another that leads it back: then both stop it."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    vx, vy = float(ball["vx"]), float(ball["vy"])
    if other["sensor"] != 0 or not may_collide(ball, other):
        return False
    age, time = age_of_motion(other, flight), age_of_motion(shape, flight)
    found = gap_to_shape(other, age, x, y, radius, vx, vy)
    if found is None:
        return False
    gap, mx, my = found
    fx, fy = x, y
    if is_moving(other):
        fx, fy = into_frame(other, age, x, y)
    if gap > SHORT_GAP * radius or gap < -LIFT * radius or lets_pass(other, fx, fy):
        return False
    ux, uy = surface_velocity(shape, float(shape["spin"]), x - radius * nx, y - radius * ny, time)
    wx, wy = surface_velocity(other, float(other["spin"]), x - radius * mx, y - radius * my, age)
    u, w, wedge = dot(ux, uy, nx, ny), dot(wx, wy, mx, my), cross(nx, ny, mx, my)
    into = dot(vx, vy, mx, my) - w
    if into >= 0.0 or fabs(wedge) <= LIFT or dot(vx - into * mx, vy - into * my, nx, ny) >= u:
        return False
    ball["vx"] = (u * my - w * ny) / wedge
    ball["vy"] = (w * nx - u * mx) / wedge
    return True


def long_normal(ball: BallRow, shape: ShapeRow, age: float, nx: float, ny: float) -> tuple[float, float]:
    """A touching ball's normal as the vector from what the shape is bent about, or to it; of a straight one, a unit.

    Without a unit vector's rounding the ball keeps its speed and, in a round room, its angular momentum.
    """
    center = center_of_bend(shape, age)
    if center is None:
        return nx, ny
    cx, cy = center
    dx, dy = float(ball["x"]) - cx, float(ball["y"]) - cy
    if dx * nx + dy * ny > 0.0:
        return dx, dy
    return -dx, -dy


def impact_of_balls(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    i: int,
    j: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> bool:
    """Do what follows from two balls' touching: `i` before `j` by row. True if a push has moved them.

    There must be room for a hit and a relation.
    """
    first, second = balls[i], balls[j]
    dx, dy = float(second["x"]) - float(first["x"]), float(second["y"]) - float(first["y"])
    if first["sensor"] != 0 or second["sensor"] != 0:
        add_relation(state, relations, second, j, INSIDE_BALL, i)
        cross_ball(state, hits[state["hits"]], float(state["now"]), ENTER, second, first)
        return False
    vx, vy = float(first["vx"]), float(first["vy"])
    wx, wy = float(second["vx"]), float(second["vy"])
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
        push_apart(first, second, nx, ny, setback)
    u1, u2 = dot(vx, vy, nx, ny), dot(wx, wy, nx, ny)
    elasticity = float(first["elasticity"]) * float(second["elasticity"])
    # What rounding alone has found counts too, or it would be found without end.
    count_impact(first, flights[i], elasticity, larger(u1 - u2, 0.0), 0.0)
    count_impact(second, flights[j], elasticity, larger(u1 - u2, 0.0), 0.0)
    in_heap = lies(relations, first) or lies(relations, second)
    tired = is_tired(flights[i], elasticity, in_heap) or is_tired(flights[j], elasticity, in_heap)
    press = pressing(state, first, flights[i], second, flights[j], relations, nx, ny)
    quiet = lasting_speed(press, min(float(first["radius"]), float(second["radius"])), elasticity)
    rest_speed = float(state["rest_speed"])
    rebound = u1 - u2 if rest_speed >= 0.0 else elasticity * (u1 - u2)
    slowest = quiet if rest_speed < 0.0 or press <= 0.0 else rest_speed
    let_fly(state, first, flights[i])
    let_fly(state, second, flights[j])
    state["held"] += 1 if tired and u2 - u1 < 0.0 else 0
    if tired or (press > 0.0 and rebound <= slowest):
        join(state, balls, relations, i, j)
        elasticity = 0.0
    if u2 - u1 >= 0.0:
        return pushed
    gain = exchange(first, second, u1, u2, nx, ny, elasticity)
    if u1 - u2 <= slowest:
        return pushed
    if not tired:
        # A third one may push the two on, without end, to what is more than allowed.
        limit_speeds(state, first, second, nx, ny)
    px, py = float(first["x"]) + float(first["radius"]) * nx, float(first["y"]) + float(first["radius"]) * ny
    speed = length(wx - vx, wy - vy)
    touch = (px, py, nx, ny, setback)
    record_hit(state, hits[state["hits"]], float(state["now"]), second, first, touch, (wx, wy), speed, gain)
    return pushed


def pressing(
    state: StateRow,
    first: BallRow,
    flight: FlightRow,
    second: BallRow,
    partner: FlightRow,
    relations: Table[RelationRow],
    nx: float,
    ny: float,
) -> float:
    """The acceleration that presses two touching balls together along the normal; 0 or less if nothing does.

    That of their flights, less what their turning about each other takes. Of balls that lie on others it is not
    known before all of them are solved: there as much as gravity, and as what presses on either of the two already.
    """
    ax, ay = float(flight["ax"]) - float(partner["ax"]), float(flight["ay"]) - float(partner["ay"])
    press = dot(ax, ay, nx, ny)
    if lies(relations, first) or lies(relations, second):
        press = larger(press, length(float(state["gravity_x"]), float(state["gravity_y"])))
        press = larger(press, larger(strongest_force(relations, first), strongest_force(relations, second)))
    vx, vy = float(second["vx"]) - float(first["vx"]), float(second["vy"]) - float(first["vy"])
    across = cross(nx, ny, vx, vy)
    return press - across * across / (float(first["radius"]) + float(second["radius"]))


def strongest_force(relations: Table[RelationRow], ball: BallRow) -> float:
    """The largest force of what a ball lies on, or what lies on it, per its mass."""
    force = 0.0
    place = int(ball["relation"])
    while place != NO_RELATION:
        force = larger(force, length(float(relations[place]["force_x"]), float(relations[place]["force_y"])))
        place = int(relations[place]["next"])
    return force / float(ball["mass"])


def keep_push_out(
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
        begin, end = cell_span(cells, locate(index[FIXED], cells, from_x + dx, from_y + dy))
        for k in range(begin, end):
            row = int(members[k])
            shape = shapes[row]
            if shape["sensor"] != 0 or ball["sensor"] != 0 or not may_collide(ball, shape):
                continue
            if find_relation(relations, ball, PASSING, row):
                continue
            found = gap_to_shape(shape, 0.0, from_x, from_y, radius, dx, dy)  # static: their motion has no age
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
    first: BallRow, second: BallRow, u1: float, u2: float, nx: float, ny: float, elasticity: float
) -> float:  # fmt: skip
    """The momentum that the second ball gets along the normal when two balls that approach bounce."""
    m1, m2 = float(first["mass"]), float(second["mass"])
    new1, new2 = exchanged(u1, u2, m1, m2, elasticity)
    first["vx"] += (new1 - u1) * nx
    first["vy"] += (new1 - u1) * ny
    second["vx"] += (new2 - u2) * nx
    second["vy"] += (new2 - u2) * ny
    return m2 * (new2 - u2)


def limit_speeds(state: StateRow, first: BallRow, second: BallRow, nx: float, ny: float) -> None:
    """Slow two balls that have met to what is allowed, but neither below the one that pushes it: they part."""
    slowed = int(state["slowed"])
    limit_speed(state, first)
    limit_speed(state, second)
    if state["slowed"] == slowed:
        return
    u1 = dot(float(first["vx"]), float(first["vy"]), nx, ny)
    u2 = dot(float(second["vx"]), float(second["vy"]), nx, ny)
    if u1 > u2:
        exchange(first, second, u1, u2, nx, ny, 0.0)
