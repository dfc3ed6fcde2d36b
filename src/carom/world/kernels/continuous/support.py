"""Lasting contacts: a ball that rests on a shape, rolls or slides along it, or is pressed by it.

Such a ball flies on with the acceleration that keeps it on the shape: exactly along a segment at rest, along the
osculating parabola where the shape is bent or moves, from where it is put back onto the shape after a part of the
substep. On shapes at rest its speed follows from its energy, so it changes by gravity alone.
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import (
    ELASTIC_LIFT,
    END_SLOP,
    LASTING_PART,
    LIFT,
    PATIENCE_DEPTH,
    PATIENCE_HALVINGS,
    PATIENCE_PART,
    SEPARATION_SLACK,
    SLIDE_PART,
    SLIDE_TURN,
    THROW_OFF,
)
from carom.geometry.roots import falling_time
from carom.geometry.vector import cross, dot, length
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, FlightRow
from carom.rows.kinds import bend_center
from carom.rows.kinds_near import height_over
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.relation import LASTING, NO_RELATION, RelationRow
from carom.rows.shape import ARC, POINT, SEGMENT, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Row, Table
from carom.world.kernels.continuous.flight import fall_freely
from carom.world.kernels.continuous.surfaces import gap_to_shape, into_frame, out_of_frame
from carom.world.kernels.step.relations import drop_relation


def holding_acceleration(
    shape: ShapeRow, time: float, x: float, y: float, vx: float, vy: float, nx: float, ny: float
) -> float:
    """The acceleration along the normal that keeps a touching ball at (x, y) on the shape at a time of the span.

    The second derivative of the gap is 0: for a line that turns with ω about c, travelling with u, that of
    (p - c)·n is a·n + 2ω(v - u)·perp(n) - ω²(p - c)·n; for a circle about C, that of |p - C| is
    (a - C'')·m + w_t²/|p - C|.
    """
    moving = is_moving(shape)
    spin = float(shape["spin"]) if moving else 0.0
    ux = float(shape["velocity_x"]) if moving else 0.0
    uy = float(shape["velocity_y"]) if moving else 0.0
    px, py = float(shape["pivot_x"]) + ux * time, float(shape["pivot_y"]) + uy * time
    center = bend_center(shape)
    if center is None:
        return spin * spin * dot(x - px, y - py, nx, ny) - 2.0 * spin * dot(vx - ux, vy - uy, -ny, nx)
    cx, cy = center
    if moving:
        cx, cy = out_of_frame(shape, time, cx, cy)
    dx, dy = x - cx, y - cy
    away_squared = dx * dx + dy * dy
    if away_squared == 0.0:
        return 0.0
    away = sqrt(away_squared)
    mx, my = dx / away, dy / away
    wx, wy = vx - (ux - spin * (cy - py)), vy - (uy + spin * (cx - px))
    across = cross(mx, my, wx, wy)
    outward = -spin * spin * dot(cx - px, cy - py, mx, my) - across * across / away
    return outward if dot(mx, my, nx, ny) > 0.0 else -outward


def pressure(shape: ShapeRow, time: float, ball: BallRow, nx: float, ny: float, ax: float, ay: float) -> float:
    """The acceleration with which a touching ball that (ax, ay) pulls is pressed on a shape; negative if off it."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    return holding_acceleration(shape, time, x, y, vx, vy, nx, ny) - dot(ax, ay, nx, ny)


def lasting_speed(press: float, duration: float) -> float:
    """The speed of a rebound that ends within a `LASTING_PART` of a substep of length `duration`."""
    return 0.5 * press * LASTING_PART * duration


def patience(
    state: StateRow, ball: BallRow, flight: FlightRow, other: BallRow, partner: FlightRow
) -> tuple[float, float]:
    """How long two balls that rest on each other wait before they meet again, and the speed that pulls them meanwhile.

    No slower approach is a bounce. The wait is a part of the substep, halved as often as need be, so all waits end at
    the same ticks.
    """
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    ax, ay = float(flight["ax"]) - float(partner["ax"]), float(flight["ay"]) - float(partner["ay"])
    # Without gravity it is what holds the balls that may press them together.
    pull = max(length(gx, gy), length(ax, ay))
    deep = 2.0 * PATIENCE_DEPTH * min(float(ball["radius"]), float(other["radius"]))
    wait = PATIENCE_PART * float(state["dt"]) / float(state["substeps"])
    for _ in range(PATIENCE_HALVINGS):
        if pull * wait * wait <= deep:
            break
        wait = 0.5 * wait
    return wait, pull * wait


def slow_rebound(
    state: StateRow, shape: ShapeRow, ball: BallRow, flight: FlightRow, nx: float, ny: float, elasticity: float
) -> float:
    """The speed of a rebound so slow that the contact lasts; 0 where nothing presses the touching ball on.

    At elasticities of 1 and more rebounds never end, and it is the speed of those that come more often than
    `max_impacts` allows and are lower than `ELASTIC_LIFT`.
    """
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    press = pressure(shape, float(flight["time"]), ball, nx, ny, gx, gy)
    # What holds the ball already may press it on, as a floor that slopes down to an upright wall does.
    press = max(press, pressure(shape, float(flight["time"]), ball, nx, ny, float(flight["ax"]), float(flight["ay"])))
    if press <= 0.0:
        return 0.0
    substep = float(state["dt"]) / float(state["substeps"])
    if elasticity < 1.0:
        return lasting_speed(press, substep)
    often = 0.5 * press * substep / float(state["max_impacts"])
    return min(often, sqrt(2.0 * press * ELASTIC_LIFT * float(ball["radius"])))


def keep_energy(
    state: StateRow, ball: BallRow, flight: FlightRow, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> None:
    """Give a ball that slides along one bent shape at rest the speed that its energy leaves it where it is.

    Its acceleration along the shape's normal has done work since it was put onto the shape.
    """
    held = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING:
            if held != NO_RELATION:
                return
            held = place
        place = int(relations[place]["next"])
    if held == NO_RELATION or flight["kind"] != FLYING:
        return
    shape = shapes[relations[held]["other"]]
    if is_moving(shape) or bend_center(shape) is None:
        return
    vx, vy = float(ball["vx"]), float(ball["vy"])
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    squared = 2.0 * (float(flight["energy"]) + dot(gx, gy, float(ball["x"]), float(ball["y"])))
    speed = sqrt(vx * vx + vy * vy)
    if squared > 0.0 and speed > 0.0:
        share = sqrt(squared) / speed
        ball["vx"] = vx * share
        ball["vy"] = vy * share


def lean(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    duration: float,
    changed: bool,
) -> None:
    """Give a ball the acceleration that its lasting contacts and gravity leave it, and put it onto what holds it.

    `duration` is that of a substep. Where its velocity has `changed` by an impact, contacts from which it is thrown, or
    into which, end; so do those that pull it off, have opened, or ended. Of more than two the last ones begun count.
    """
    fall_freely(state, flight)
    if flight["kind"] != FLYING or ball["relation"] == NO_RELATION:
        return
    time = float(flight["time"])
    leave_points(state, ball, time, shapes, relations)
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    # What gravity presses the ball onto, and then what that presses it onto.
    ax, ay = gx, gy
    first = NO_RELATION
    for _ in range(2):
        second = NO_RELATION
        place = int(ball["relation"])
        while place != NO_RELATION and second == NO_RELATION:
            if relations[place]["kind"] == LASTING and place != first:
                shape = shapes[relations[place]["other"]]
                if holds(ball, time, shape, duration, changed, gx, gy) or (
                    first != NO_RELATION and holds(ball, time, shape, duration, changed, ax, ay)
                ):
                    second = place
            place = int(relations[place]["next"])
        if first == NO_RELATION:
            first = second
            second = NO_RELATION
            if first == NO_RELATION:
                break
            ax, ay = held_by(ball, time, shapes[relations[first]["other"]], gx, gy)
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING and place != first and place != second:
            place = drop_relation(state, relations, ball, place, before)
        else:
            before = place
            place = int(relations[place]["next"])
    if first == NO_RELATION:
        return
    if second == NO_RELATION:
        rest_on_one(state, ball, flight, shapes[relations[first]["other"]], changed)
    else:
        rest_on_two(ball, flight, shapes[relations[first]["other"]], shapes[relations[second]["other"]])


def leave_points(
    state: StateRow, ball: BallRow, time: float, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> None:
    """End the lasting contacts of a ball with points that stand on a wall, or lie behind it, which it is beside now.

    It has come over a joint; held by its point, whose normal turns as the ball goes on, it would stick there.
    """
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        on_wall = False
        if relations[place]["kind"] == LASTING:  # of the other kinds, what they are with may be a ball
            shape = shapes[relations[place]["other"]]
            on_wall = shape["kind"] == POINT and is_on_wall_of(ball, time, shape, shapes, relations)
        if on_wall:
            place = drop_relation(state, relations, ball, place, before)
        else:
            before = place
            place = int(relations[place]["next"])


def is_on_wall_of(
    ball: BallRow, time: float, point: Row, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> bool:
    """True if a ball is beside a wall that holds it too, and a point is on that or behind it."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING and shapes[relations[place]["other"]]["kind"] != POINT:
            wall = shapes[relations[place]["other"]]
            px, py = x, y
            qx, qy = float(point["cx"]), float(point["cy"])
            if is_moving(point):
                qx, qy = out_of_frame(point, time, qx, qy)
            if is_moving(wall):
                px, py = into_frame(wall, time, x, y)
                qx, qy = into_frame(wall, time, qx, qy)
            beside = gap_to_shape(wall, time, x, y, radius, 0.0, 0.0) is not None
            if beside and height_over(wall, px, py, qx, qy) <= SEPARATION_SLACK * radius:
                return True
        place = int(relations[place]["next"])
    return False


def held_by(ball: BallRow, time: float, shape: ShapeRow, gx: float, gy: float) -> tuple[float, float]:
    """The acceleration of a ball that gravity presses onto a shape."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    found = gap_to_shape(shape, time, x, y, float(ball["radius"]), vx, vy)
    if found is None:
        return gx, gy
    _gap, nx, ny = found
    push = pressure(shape, time, ball, nx, ny, gx, gy)
    return gx + push * nx, gy + push * ny


def holds(ball: BallRow, time: float, shape: ShapeRow, duration: float, changed: bool, ax: float, ay: float) -> bool:
    """True if a lasting contact goes on: it is closed and pressed, and no impact throws the ball off or in."""
    if not may_collide(ball, shape):
        return False
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    vx, vy = float(ball["vx"]), float(ball["vy"])
    found = gap_to_shape(shape, time, x, y, radius, vx, vy)
    if found is None:
        return False
    gap, nx, ny = found
    press = pressure(shape, time, ball, nx, ny, ax, ay)
    if press <= 0.0 or fabs(gap) > LIFT * radius:
        return False
    if not changed:
        return True
    ux, uy = surface_velocity(shape, float(shape["spin"]), x - radius * nx, y - radius * ny, time)
    return fabs(dot(vx - ux, vy - uy, nx, ny)) <= lasting_speed(press, duration)


def throw_off(
    state: StateRow,
    ball: BallRow,
    time: float,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    nx: float,
    ny: float,
) -> None:
    """End the lasting contacts of a ball off which an impact along (nx, ny) throws it, however slow it was.

    They would press the ball onto what it has just left, for ever.
    """
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        thrown = False
        if relations[place]["kind"] == LASTING:
            x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
            found = gap_to_shape(shapes[relations[place]["other"]], time, x, y, radius, 0.0, 0.0)
            if found is not None:
                _gap, mx, my = found
                thrown = dot(nx, ny, mx, my) > THROW_OFF
        if thrown:
            place = drop_relation(state, relations, ball, place, before)
        else:
            before = place
            place = int(relations[place]["next"])


def put_onto(ball: BallRow, time: float, shape: ShapeRow) -> tuple[float, float, float]:
    """The normal of a shape at a ball that it holds, and the acceleration that holds it; the ball then touches it.

    The ball keeps no speed along the normal but the surface's.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    vx, vy = float(ball["vx"]), float(ball["vy"])
    found = gap_to_shape(shape, time, x, y, radius, vx, vy)
    if found is None:
        return 0.0, 0.0, 0.0
    gap, nx, ny = found
    x -= gap * nx
    y -= gap * ny
    ux, uy = surface_velocity(shape, float(shape["spin"]), x - radius * nx, y - radius * ny, time)
    into = dot(vx - ux, vy - uy, nx, ny)
    vx -= into * nx
    vy -= into * ny
    ball["x"] = x
    ball["y"] = y
    ball["vx"] = vx
    ball["vy"] = vy
    return nx, ny, holding_acceleration(shape, time, x, y, vx, vy, nx, ny)


def rest_on_one(state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, changed: bool) -> None:
    """Let one shape hold a ball."""
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    nx, ny, held = put_onto(ball, float(flight["time"]), shape)
    vx, vy = float(ball["vx"]), float(ball["vy"])
    potential = dot(gx, gy, float(ball["x"]), float(ball["y"]))
    if changed or is_moving(shape):
        flight["energy"] = 0.5 * (vx * vx + vy * vy) - potential
    else:
        along = cross(nx, ny, vx, vy)
        speed = sqrt(max(2.0 * (float(flight["energy"]) + potential), 0.0))
        if along < 0.0:
            speed = -speed
        ball["vx"] = -ny * speed
        ball["vy"] = nx * speed
        if bend_center(shape) is not None:
            x, y = float(ball["x"]), float(ball["y"])
            time = float(flight["time"])
            held = holding_acceleration(shape, time, x, y, float(ball["vx"]), float(ball["vy"]), nx, ny)
    push = held - dot(gx, gy, nx, ny)
    flight["ax"] = gx + push * nx
    flight["ay"] = gy + push * ny


def rest_on_two(ball: BallRow, flight: FlightRow, first: ShapeRow, second: ShapeRow) -> None:
    """Let two shapes hold a ball: a·n = h for both, or for one if that lifts the ball off the other."""
    time = float(flight["time"])
    gx, gy = float(flight["ax"]), float(flight["ay"])
    n1x, n1y, held1 = put_onto(ball, time, first)
    n2x, n2y, held2 = put_onto(ball, time, second)
    wedge = cross(n1x, n1y, n2x, n2y)
    stop_in_wedge(ball, time, first, second, n1x, n1y, n2x, n2y, wedge)
    if fabs(wedge) > LIFT:
        x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
        held1 = holding_acceleration(first, time, x, y, vx, vy, n1x, n1y)
        held2 = holding_acceleration(second, time, x, y, vx, vy, n2x, n2y)
    push1 = held1 - dot(gx, gy, n1x, n1y)
    push2 = held2 - dot(gx, gy, n2x, n2y)
    ax, ay = gx + push1 * n1x, gy + push1 * n1y
    if dot(ax, ay, n2x, n2y) < held2:
        ax, ay = gx + push2 * n2x, gy + push2 * n2y
        if dot(ax, ay, n1x, n1y) < held1 and fabs(wedge) > LIFT:
            ax = (held1 * n2y - held2 * n1y) / wedge
            ay = (held2 * n1x - held1 * n2x) / wedge
    flight["ax"] = ax
    flight["ay"] = ay
    vx, vy = float(ball["vx"]), float(ball["vy"])
    flight["energy"] = 0.5 * (vx * vx + vy * vy) - dot(gx, gy, float(ball["x"]), float(ball["y"]))


def stop_in_wedge(
    ball: BallRow,
    time: float,
    first: ShapeRow,
    second: ShapeRow,
    n1x: float,
    n1y: float,
    n2x: float,
    n2y: float,
    wedge: float,
) -> None:
    """Leave a ball between two shapes, which has been put onto the second, no speed into the first."""
    if fabs(wedge) <= LIFT:
        return
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    ux, uy = surface_velocity(first, float(first["spin"]), x - radius * n1x, y - radius * n1y, time)
    u1 = dot(ux, uy, n1x, n1y)
    if dot(float(ball["vx"]), float(ball["vy"]), n1x, n1y) >= u1:
        return
    ux, uy = surface_velocity(second, float(second["spin"]), x - radius * n2x, y - radius * n2y, time)
    u2 = dot(ux, uy, n2x, n2y)
    ball["vx"] = (u1 * n2y - u2 * n1y) / wedge
    ball["vy"] = (u2 * n1x - u1 * n2x) / wedge


def turn_time(ball: BallRow, shape: ShapeRow) -> float:
    """The time in which a ball that slides along a shape, and the shape, turn by `SLIDE_TURN`; may be infinite."""
    vx, vy = float(ball["vx"]) - float(shape["velocity_x"]), float(ball["vy"]) - float(shape["velocity_y"])
    turns = fabs(float(shape["spin"])) if is_moving(shape) else 0.0
    center = bend_center(shape)
    if center is not None:
        cx, cy = center
        away = length(float(ball["x"]) - cx, float(ball["y"]) - cy)
        if away > 0.0:
            turns += length(vx, vy) / away
    return SLIDE_TURN / turns if turns > 0.0 else inf


def slide_time(ball: BallRow, flight: FlightRow, shape: ShapeRow, duration: float) -> tuple[float, bool]:
    """How long a ball may go on along a shape that holds it, and whether it comes to the shape's end then."""
    if is_moving(shape) or (shape["kind"] != SEGMENT and shape["kind"] != ARC):
        return min(SLIDE_PART * duration, turn_time(ball, shape)), False
    if shape["kind"] == ARC:
        return slide_time_on_arc(ball, flight, shape, min(SLIDE_PART * duration, turn_time(ball, shape)))
    tx, ty, slop = float(shape["tx"]), float(shape["ty"]), 3.0 * END_SLOP * float(ball["radius"])
    along = dot(float(ball["x"]) - float(shape["ax"]), float(ball["y"]) - float(shape["ay"]), tx, ty)
    rate = dot(float(ball["vx"]), float(ball["vy"]), tx, ty)
    acceleration = dot(float(flight["ax"]), float(flight["ay"]), tx, ty)
    time = duration
    leaves = False
    back = falling_time(along + slop, rate, acceleration)
    if back is not None and back < time:
        time = 0.0 + back
        leaves = True
    ahead = falling_time(float(shape["length"]) + slop - along, -rate, -acceleration)
    if ahead is not None and ahead < time:
        time = 0.0 + ahead
        leaves = True
    return time, leaves


def slide_time_on_arc(ball: BallRow, flight: FlightRow, shape: ShapeRow, duration: float) -> tuple[float, bool]:
    """How long a ball may go on along an arc at rest, `duration` at most, and whether it comes to an end of it then."""
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    dx, dy, slop = float(ball["x"]) - cx, float(ball["y"]) - cy, 3.0 * END_SLOP * float(ball["radius"])
    vx, vy, ax, ay = float(ball["vx"]), float(ball["vy"]), float(flight["ax"]), float(flight["ay"])
    time = duration
    leaves = False
    for end in range(2):
        # The unit vector to an end, and the distance from its ray's line, which is above 0 on the arc.
        ex, ey = (float(shape["ax"]) - cx) / r, (float(shape["ay"]) - cy) / r
        nx, ny = -ey, ex
        if end == 1:
            ex, ey = (float(shape["bx"]) - cx) / r, (float(shape["by"]) - cy) / r
            nx, ny = ey, -ex
        if dot(ex, ey, dx, dy) > 0.0:
            crossing = falling_time(dot(nx, ny, dx, dy) + slop, dot(nx, ny, vx, vy), dot(nx, ny, ax, ay))
            if crossing is not None and crossing < time:
                time = 0.0 + crossing
                leaves = True
    return time, leaves
