"""Lasting contacts: a ball that rests on a shape, rolls or slides along it, or is pressed by it.

Such a ball flies on with the acceleration that keeps it on the shape: exactly along a segment that does not turn, along
the osculating parabola where the shape is bent or turns (see `sliding`).
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import (
    ELASTIC_REBOUND,
    LEAST_ROLL,
    LIFT,
    PRESS_ROUNDING,
    REBOUND,
    SEPARATION_SLACK,
    THROW_OFF,
    TOUCH_STEPS,
)
from carom.geometry.vector import cross, dot, length
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, FlightRow
from carom.rows.kinds import has_side
from carom.rows.kinds_near import height_over
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, moves_with, surface_velocity
from carom.rows.relation import LASTING, LYING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Row, Table
from carom.world.kernels.continuous.filling import drops_out, fills_bend, settle_in_bend
from carom.world.kernels.continuous.flight import add_friction, fall_freely, friction_of, is_tired
from carom.world.kernels.continuous.surfaces import (
    age_of_motion,
    center_of_bend,
    gap_to_shape,
    into_frame,
    out_of_frame,
)
from carom.world.kernels.step.relations import drop_relation, has_kind


def holding_acceleration(
    shape: ShapeRow, time: float, x: float, y: float, vx: float, vy: float, nx: float, ny: float
) -> float:
    """The acceleration along the normal that keeps a touching ball at (x, y) on the shape at an age of its motion.

    The second derivative of the gap is 0: for a line that turns with ω about c, travelling with u, that of
    (p - c)·n is a·n + 2ω(v - u)·perp(n) - ω²(p - c)·n; for a circle about C, that of |p - C| is
    (a - C'')·m + w_t²/|p - C|.
    """
    moving = is_moving(shape)
    spin = float(shape["spin"]) if moving else 0.0
    ux = float(shape["velocity_x"]) if moving else 0.0
    uy = float(shape["velocity_y"]) if moving else 0.0
    px, py = float(shape["pivot_x"]) + ux * time, float(shape["pivot_y"]) + uy * time
    center = center_of_bend(shape, time)
    if center is None:
        return spin * spin * dot(x - px, y - py, nx, ny) - 2.0 * spin * dot(vx - ux, vy - uy, -ny, nx)
    cx, cy = center
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
    press = holding_acceleration(shape, time, x, y, vx, vy, nx, ny) - dot(ax, ay, nx, ny)
    least = PRESS_ROUNDING * length(ax, ay)
    if fabs(press) < least and is_drawn_in(shape, time, ball, nx, ny, ax, ay):
        return least
    return press


def is_drawn_in(
    shape: ShapeRow, time: float, ball: BallRow, nx: float, ny: float, ax: float, ay: float
) -> bool:  # fmt: skip
    """True if a touching ball that nothing presses is pressed a moment later: it gets faster round a hollow bend.

    So is one that is let go where gravity is tangent to a bowl.
    """
    center = center_of_bend(shape, time)
    if center is None:
        return False
    cx, cy = center
    vx, vy = float(ball["vx"]), float(ball["vy"])
    if is_moving(shape):
        vx -= float(shape["velocity_x"])
        vy -= float(shape["velocity_y"])
    hollow = dot(float(ball["x"]) - cx, float(ball["y"]) - cy, nx, ny) < 0.0
    return hollow and cross(nx, ny, vx, vy) * cross(nx, ny, ax, ay) >= 0.0 and cross(nx, ny, ax, ay) != 0.0


def lasting_speed(press: float, radius: float, elasticity: float) -> float:
    """The speed of a rebound so low that the contact lasts; 0 where nothing presses the touching ball on."""
    if press <= 0.0:
        return 0.0
    return sqrt(2.0 * press * (REBOUND if elasticity < 1.0 else ELASTIC_REBOUND) * radius)


def slow_rebound(
    state: StateRow, shape: ShapeRow, ball: BallRow, flight: FlightRow, nx: float, ny: float, elasticity: float
) -> float:
    """The speed of a rebound off a shape so low that the contact lasts; 0 where nothing presses the ball on."""
    time = age_of_motion(shape, flight)
    gx, gy = pull_on(state, ball)
    press = pressure(shape, time, ball, nx, ny, gx, gy)
    ax, ay = float(flight["ax"]), float(flight["ay"])
    if ax != gx or ay != gy:
        # What holds the ball already may press it on, as a floor that slopes down to an upright wall does.
        press = max(press, pressure(shape, time, ball, nx, ny, ax, ay))
    return lasting_speed(press, float(ball["radius"]), elasticity)


def pull_on(state: StateRow, ball: BallRow) -> tuple[float, float]:
    """The acceleration of a ball where nothing holds it: gravity, and friction if it moves.

    Friction presses a ball on what pushes it. How much of it acts on one that stands still, what holds that decides.
    """
    return pull_at(state, ball, float(ball["vx"]), float(ball["vy"]))


def pull_at(state: StateRow, ball: BallRow, vx: float, vy: float) -> tuple[float, float]:
    """The same of a ball when it has a velocity."""
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    loss = friction_of(state, ball)
    speed = length(vx, vy)
    if loss == 0.0 or speed == 0.0:
        return gx, gy
    return gx - loss * (vx / speed), gy - loss * (vy / speed)


def keep_still(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Add friction to the acceleration of a ball that stands still on what holds it."""
    if ball["vx"] == 0.0 and ball["vy"] == 0.0:
        add_friction(state, ball, flight)


def hold(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    changed: bool,
) -> None:
    """Give a ball the acceleration that its lasting contacts and gravity leave it, and put it onto what holds it.

    Where its velocity has `changed` by an impact, contacts from which it is thrown, or
    into which, end; so do those that pull it off, have opened, or ended. Of more than two the last ones begun count.
    """
    fall_freely(state, ball, flight)
    if flight["kind"] != FLYING or ball["relation"] == NO_RELATION or has_kind(relations, ball, LYING):
        return
    leave_points(state, ball, flight, shapes, relations)
    gx, gy = pull_on(state, ball)
    # What gravity presses the ball onto, and then what that presses it onto.
    ax, ay = gx, gy
    first = NO_RELATION
    for _ in range(2):
        second = NO_RELATION
        place = int(ball["relation"])
        while place != NO_RELATION and second == NO_RELATION:
            if relations[place]["kind"] == LASTING and place != first:
                shape = shapes[relations[place]["other"]]
                if holds(ball, flight, shape, changed, gx, gy) or (
                    first != NO_RELATION and holds(ball, flight, shape, changed, ax, ay)
                ):
                    second = place
            place = int(relations[place]["next"])
        if first == NO_RELATION:
            first = second
            second = NO_RELATION
            if first == NO_RELATION:
                break
            ax, ay = held_by(ball, flight, shapes[relations[first]["other"]], gx, gy)
    if changed and first != NO_RELATION and second != NO_RELATION:
        one, other = shapes[relations[first]["other"]], shapes[relations[second]["other"]]
        if rolls_off(ball, flight, one, other, gx, gy):
            second = NO_RELATION
        elif rolls_off(ball, flight, other, one, gx, gy):
            first = second
            second = NO_RELATION
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
    if second == NO_RELATION and drops_out(ball, flight, shapes[relations[first]["other"]], gx, gy):
        relations[first]["kind"] = PASSING
    elif second == NO_RELATION:
        rest_on_one(state, ball, flight, shapes[relations[first]["other"]])
    else:
        rest_on_two(state, ball, flight, shapes[relations[first]["other"]], shapes[relations[second]["other"]])


def leave_points(
    state: StateRow, ball: BallRow, flight: FlightRow, shapes: Table[ShapeRow], relations: Table[RelationRow]
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
            on_wall = not has_side(shape["kind"]) and is_on_wall_of(ball, flight, shape, shapes, relations)
        if on_wall:
            place = drop_relation(state, relations, ball, place, before)
        else:
            before = place
            place = int(relations[place]["next"])


def is_walked_over(
    ball: BallRow, flight: FlightRow, shape: ShapeRow, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> bool:
    """True for a point on the wall that holds a ball: rounding alone would find it in the way before that ends.

    Balls that lie on others keep to a wall less closely, and may come onto its point before; not ever anew.
    """
    if has_side(shape["kind"]) or ball["relation"] == NO_RELATION:
        return False
    if has_kind(relations, ball, LYING) and not is_tired(flight, 0.0, False):
        return False
    return is_on_wall_of(ball, flight, shape, shapes, relations)


def is_on_wall_of(
    ball: BallRow, flight: FlightRow, point: Row, shapes: Table[ShapeRow], relations: Table[RelationRow]
) -> bool:
    """True if a ball is beside a wall that holds it too, and a point is on that or behind it, and stays there."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LASTING and has_side(shapes[relations[place]["other"]]["kind"]):
            wall = shapes[relations[place]["other"]]
            px, py = x, y
            qx, qy = float(point["cx"]), float(point["cy"])
            if is_moving(point):
                qx, qy = out_of_frame(point, age_of_motion(point, flight), qx, qy)
            time = age_of_motion(wall, flight)
            if is_moving(wall):
                px, py = into_frame(wall, time, x, y)
                qx, qy = into_frame(wall, time, qx, qy)
            beside = gap_to_shape(wall, time, x, y, radius, 0.0, 0.0) is not None
            stays = moves_with(point, wall) or not (is_moving(point) or is_moving(wall))
            if beside and stays and height_over(wall, px, py, qx, qy) <= SEPARATION_SLACK * radius:
                return True
        place = int(relations[place]["next"])
    return False


def held_by(ball: BallRow, flight: FlightRow, shape: ShapeRow, gx: float, gy: float) -> tuple[float, float]:
    """The acceleration of a ball that gravity presses onto a shape."""
    time = age_of_motion(shape, flight)
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    found = gap_to_shape(shape, time, x, y, float(ball["radius"]), vx, vy)
    if found is None:
        return gx, gy
    _gap, nx, ny = found
    push = pressure(shape, time, ball, nx, ny, gx, gy)
    return gx + push * nx, gy + push * ny


def may_hold(ball: BallRow, flight: FlightRow, shape: ShapeRow, in_heap: bool) -> bool:
    """True unless a shape lets a ball through, or has a kick, be it since the ball lies on it: that throws it off.

    It does not where the ball's impacts are too close on one another to be told apart.
    """
    if not may_collide(ball, shape):
        return False
    return bool(shape["kick"] == 0.0) or is_tired(
        flight, float(ball["elasticity"]) * float(shape["elasticity"]), in_heap
    )


def holds(ball: BallRow, flight: FlightRow, shape: ShapeRow, changed: bool, ax: float, ay: float) -> bool:
    """True if a lasting contact goes on: it is closed and pressed, and no impact throws the ball off or in."""
    if not may_hold(ball, flight, shape, False):
        return False
    time = age_of_motion(shape, flight)
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
    elasticity = float(ball["elasticity"]) * float(shape["elasticity"])
    return fabs(dot(vx - ux, vy - uy, nx, ny)) <= lasting_speed(press, radius, elasticity)


def rolls_off(ball: BallRow, flight: FlightRow, one: Row, other: Row, gx: float, gy: float) -> bool:
    """True if a ball that two shapes hold rolls along the one, off the other, farther than it may to rest on both.

    The height to which it comes over the other says little where the two are all but even.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    vx, vy = float(ball["vx"]), float(ball["vy"])
    found = gap_to_shape(one, age_of_motion(one, flight), x, y, radius, vx, vy)
    time = age_of_motion(other, flight)
    beside = gap_to_shape(other, time, x, y, radius, vx, vy)
    if found is None or beside is None:
        return False
    _gap, mx, my = found
    _gap, nx, ny = beside
    ux, uy = surface_velocity(other, float(other["spin"]), x - radius * nx, y - radius * ny, time)
    speed = dot(vx - ux, vy - uy, nx, ny)
    if speed <= LEAST_ROLL * length(vx - ux, vy - uy):
        return False
    ax, ay = held_by(ball, flight, one, gx, gy)
    press = pressure(other, time, ball, nx, ny, ax, ay) * fabs(cross(mx, my, nx, ny))
    return speed > lasting_speed(press, radius, float(ball["elasticity"]) * float(other["elasticity"]))


def end_thrown(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
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
            shape = shapes[relations[place]["other"]]
            found = gap_to_shape(shape, age_of_motion(shape, flight), x, y, radius, 0.0, 0.0)
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

    The ball keeps no speed along the normal but the surface's, nor any other in a bend that it fills.
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
    if fills_bend(shape, time, x, y, radius):
        vx, vy = surface_velocity(shape, float(shape["spin"]), x, y, time)
    ball["x"] = x
    ball["y"] = y
    ball["vx"] = vx
    ball["vy"] = vy
    return nx, ny, holding_acceleration(shape, time, x, y, vx, vy, nx, ny)


def rest_on_one(state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow) -> None:
    """Let one shape hold a ball."""
    gx, gy = pull_on(state, ball)
    age = age_of_motion(shape, flight)
    nx, ny, held = put_onto(ball, age, shape)
    if settle_in_bend(ball, flight, shape, age, gx, gy):
        return
    push = held - dot(gx, gy, nx, ny)
    flight["ax"] = gx + push * nx
    flight["ay"] = gy + push * ny
    keep_still(state, ball, flight)


def rest_on_two(state: StateRow, ball: BallRow, flight: FlightRow, first: ShapeRow, second: ShapeRow) -> None:
    """Let two shapes hold a ball: a·n = h for both, or for one if that lifts the ball off the other."""
    age1, age2 = age_of_motion(first, flight), age_of_motion(second, flight)
    gx, gy = pull_on(state, ball)
    put_onto_both(ball, age1, first, age2, second)
    n1x, n1y, held1 = put_onto(ball, age1, first)
    n2x, n2y, held2 = put_onto(ball, age2, second)
    wedge = cross(n1x, n1y, n2x, n2y)
    stop_in_wedge(ball, (age1, age2), first, second, n1x, n1y, n2x, n2y, wedge)
    if fabs(wedge) > LIFT:
        x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
        held1 = holding_acceleration(first, age1, x, y, vx, vy, n1x, n1y)
        held2 = holding_acceleration(second, age2, x, y, vx, vy, n2x, n2y)
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
    keep_still(state, ball, flight)


def put_onto_both(ball: BallRow, age1: float, first: ShapeRow, age2: float, second: ShapeRow) -> None:
    """Move a ball to where it touches both of two shapes that hold it, by Newton's method."""
    radius, vx, vy = float(ball["radius"]), float(ball["vx"]), float(ball["vy"])
    for _ in range(TOUCH_STEPS):
        x, y = float(ball["x"]), float(ball["y"])
        one = gap_to_shape(first, age1, x, y, radius, vx, vy)
        two = gap_to_shape(second, age2, x, y, radius, vx, vy)
        if one is None or two is None:
            return
        gap1, n1x, n1y = one
        gap2, n2x, n2y = two
        wedge = cross(n1x, n1y, n2x, n2y)
        if fabs(wedge) <= LIFT or max(fabs(gap1), fabs(gap2)) > 2.0 * LIFT * radius:
            return
        # d·n1 = -gap1 and d·n2 = -gap2.
        ball["x"] = x + (gap2 * n1y - gap1 * n2y) / wedge
        ball["y"] = y + (gap1 * n2x - gap2 * n1x) / wedge


def stop_in_wedge(
    ball: BallRow,
    ages: tuple[float, float],
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
    ux, uy = surface_velocity(first, float(first["spin"]), x - radius * n1x, y - radius * n1y, ages[0])
    u1 = dot(ux, uy, n1x, n1y)
    if dot(float(ball["vx"]), float(ball["vy"]), n1x, n1y) >= u1:
        return
    ux, uy = surface_velocity(second, float(second["spin"]), x - radius * n2x, y - radius * n2y, ages[1])
    u2 = dot(ux, uy, n2x, n2y)
    ball["vx"] = (u1 * n2y - u2 * n1y) / wedge
    ball["vy"] = (u2 * n1x - u1 * n2x) / wedge
