"""Balls that slide along a bent or turning shape: where they are when, with the energy that they have.

In the frame in which the shape stands still a ball goes along a line or a circle, so its state is a way and a speed.
Both follow from its flight's origin alone, by a rule of Hermite; then they are moved, by the rule's error, to where the
ball has the energy that the work of gravity, of friction and of the frame's turning leaves it. Between two such ticks
it flies the parabola that osculates its path, by which others meet it.
"""

from __future__ import annotations

from math import cos, fabs, inf, sin, sqrt

from carom.constants import END_SLOP, LEAST_SQUARE, ROOT_STEPS, SHORT_GAP, SLIDE_LIFT, SLIDE_ROUNDS, SLIDE_TURN
from carom.geometry.roots import falling_time
from carom.geometry.vector import cross, dot, larger, length, rotated, smaller
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, FlightRow
from carom.rows.kinds import bend_center, has_ends, is_straight
from carom.rows.pose import is_moving
from carom.rows.relation import LASTING, LYING, NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.flight import friction_of, place_after
from carom.world.kernels.continuous.lasting import holding_acceleration, pull_at
from carom.world.kernels.continuous.surfaces import age_of_motion, center_of_bend, gap_past_ends, into_frame


def only_holder(ball: BallRow, relations: Table[RelationRow]) -> int:
    """The row of the one shape that holds a ball; NO_RELATION where none does, or more than one, or balls do too."""
    held = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == LYING:
            return NO_RELATION
        if relations[place]["kind"] == LASTING:
            if held != NO_RELATION:
                return NO_RELATION
            held = int(relations[place]["other"])
        place = int(relations[place]["next"])
    return held


def slides(flight: FlightRow, shape: ShapeRow) -> bool:
    """True if a ball that one shape holds slides along a bend or a turning line."""
    if flight["kind"] != FLYING:
        return False
    return bend_center(shape) is not None or (is_moving(shape) and shape["spin"] != 0.0)


def slides_along(ball: BallRow, flight: FlightRow, shapes: Table[ShapeRow], relations: Table[RelationRow]) -> int:
    """The row of the one bent or turning shape along which a ball slides, or NO_RELATION."""
    held = only_holder(ball, relations)
    if held == NO_RELATION or not slides(flight, shapes[held]):
        return NO_RELATION
    return held


def frame_spin(shape: ShapeRow) -> float:
    """How fast the frame turns in which a ball slides along a shape.

    That is the shape's own spin; but what is bent about its own pivot does not move by turning.
    """
    if not is_moving(shape):
        return 0.0
    center = bend_center(shape)
    if center is not None:
        cx, cy = center
        if cx == shape["pivot_x"] and cy == shape["pivot_y"]:
            return 0.0
    return float(shape["spin"])


def frame_at(shape: ShapeRow, age: float) -> tuple[float, float, float, float]:
    """Where the pivot of a shape is at an age of its motion, and how fast it goes, as (x, y, vx, vy)."""
    if not is_moving(shape):
        return float(shape["pivot_x"]), float(shape["pivot_y"]), 0.0, 0.0
    vx, vy = float(shape["velocity_x"]), float(shape["velocity_y"])
    return float(shape["pivot_x"]) + vx * age, float(shape["pivot_y"]) + vy * age, vx, vy


def track_at(shape: ShapeRow, age: float, x: float, y: float, least: float) -> tuple[float, float, float]:
    """The way that a ball at (x, y) slides: the unit tangent (tx, ty), and the bend to its left, 1/radius or 0.

    The tangent is (0, 0) at the centre of a bend, where there is none. No radius is below the `least`.
    """
    center = center_of_bend(shape, age)
    if center is None:
        tx, ty = float(shape["tx"]), float(shape["ty"])
        if is_moving(shape):
            turn = float(shape["spin"]) * age
            tx, ty = rotated(tx, ty, cos(turn), sin(turn))
        return tx, ty, 0.0
    cx, cy = center
    dx, dy = x - cx, y - cy
    away = length(dx, dy)
    if away == 0.0:
        return 0.0, 0.0, 1.0 / least
    return -dy / away, dx / away, 1.0 / larger(away, least)


def along_track(tx: float, ty: float, bend: float, way: float) -> tuple[float, float, float, float]:
    """How far, as (x, y), something gets by a way along a track that begins with a tangent; and the tangent there."""
    if bend == 0.0:
        return way * tx, way * ty, tx, ty
    half = 0.5 * bend * way
    c, s = cos(half), sin(half)
    # The chord, which keeps its digits where the way is short.
    mx, my = rotated(tx, ty, c, s)
    chord = 2.0 * s / bend
    ux, uy = rotated(mx, my, c, s)
    return chord * mx, chord * my, ux, uy


def turned_back(gx: float, gy: float, turn: float) -> tuple[float, float]:
    """A vector as it is seen from a frame that has turned by an angle."""
    if turn == 0.0:
        return gx, gy
    return rotated(gx, gy, cos(turn), -sin(turn))


def pull_along(
    track: tuple[float, float, float],
    arm: tuple[float, float],
    pull: tuple[float, float],
    drag: float,
    spin: float,
    seconds: float,
    way: float,
    speed: float,
) -> tuple[float, float]:
    """The acceleration along a track of what has gone a way on it, and that acceleration's change in a second.

    `arm` leads from the pivot of the frame to where it began, `pull` is gravity as seen then, and `drag` what friction
    gives along the track.
    """
    tx, ty, bend = track
    dx, dy, ux, uy = along_track(tx, ty, bend, way)
    gx, gy = turned_back(pull[0], pull[1], spin * seconds)
    fx, fy = gx + spin * spin * (arm[0] + dx), gy + spin * spin * (arm[1] + dy)
    change = bend * speed * cross(ux, uy, fx, fy) + spin * cross(ux, uy, gx, gy) + spin * spin * speed
    return dot(ux, uy, fx, fy) + drag, change


def work_along(
    track: tuple[float, float, float],
    arm: tuple[float, float],
    pull: tuple[float, float],
    drag: float,
    spin: float,
    seconds: float,
    way: float,
    speeds: tuple[float, float],
    accelerations: tuple[float, float],
) -> float:
    """The work, per mass, of gravity, of friction and of the turning of the frame on what goes a way along a track.

    It is exact but for what gravity turns by meanwhile, as seen from the frame.
    """
    tx, ty, bend = track
    dx, dy, ux, uy = along_track(tx, ty, bend, way)
    mx, my = turned_back(pull[0], pull[1], 0.5 * spin * seconds)
    lever = dot(arm[0], arm[1], dx, dy) + 0.5 * dot(dx, dy, dx, dy)
    work = dot(mx, my, dx, dy) + drag * way + spin * spin * lever
    if spin == 0.0 or seconds == 0.0:
        return work
    # By the rule of Hermite for the power of the rest of gravity.
    for end in range(2):
        wx, wy = (tx, ty) if end == 0 else (ux, uy)
        gx, gy = turned_back(pull[0], pull[1], spin * seconds * end)
        speed, acceleration = speeds[end], accelerations[end]
        rest_x, rest_y = gx - mx, gy - my
        rate = spin * cross(wx, wy, gx, gy) * speed + dot(wx, wy, rest_x, rest_y) * acceleration
        rate += bend * speed * speed * cross(wx, wy, rest_x, rest_y)
        work += 0.5 * seconds * dot(wx, wy, rest_x, rest_y) * speed
        work += seconds * seconds * (rate if end == 0 else -rate) / 12.0
    return work


def drag_along(state: StateRow, ball: BallRow, track: tuple[float, float, float]) -> float:
    """What friction, which acts against a ball's velocity, takes along a track."""
    tx, ty, _bend = track
    vx, vy, loss = float(ball["vx"]), float(ball["vy"]), friction_of(state, ball)
    speed = length(vx, vy)
    return -loss * dot(vx / speed, vy / speed, tx, ty) if loss > 0.0 and speed > 0.0 else 0.0


def slid_along(
    track: tuple[float, float, float],
    arm: tuple[float, float],
    pull: tuple[float, float],
    drag: float,
    spin: float,
    seconds: float,
    speed: float,
) -> tuple[float, float]:
    """The way along a track, and the speed, of what began with a speed so many seconds ago."""
    a0, j0 = pull_along(track, arm, pull, drag, spin, 0.0, 0.0, speed)
    way = seconds * (speed + seconds * (0.5 * a0 + seconds * j0 / 6.0))
    now = speed + seconds * (a0 + 0.5 * seconds * j0)
    a1 = a0
    for _ in range(SLIDE_ROUNDS):
        a1, j1 = pull_along(track, arm, pull, drag, spin, seconds, way, now)
        now = speed + seconds * (0.5 * (a0 + a1) + seconds * (j0 - j1) / 12.0)
        way = seconds * (0.5 * (speed + now) + seconds * (a0 - a1) / 12.0)
    # Where the ball is fast its speed gives way, and where it turns back its place.
    for _ in range(2):
        work = work_along(track, arm, pull, drag, spin, seconds, way, (speed, now), (a0, a1))
        gained = seconds * a1
        size = now * now + gained * gained
        if size > LEAST_SQUARE:
            share = (work - 0.5 * (now - speed) * (now + speed)) / size
            now += share * now
            way -= share * gained * seconds
    return way, now


def slid_place(
    state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, seconds: float
) -> tuple[float, float, float, float]:
    """Place and velocity of a ball that has slid along a shape for so many seconds since its flight began.

    It is on the shape, or past its ends on what continues it, and its speed is that which its energy leaves it.
    """
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    age, spin = age_of_motion(shape, flight), frame_spin(shape)
    px, py, ux, uy = frame_at(shape, age)
    track = track_at(shape, age, x, y, SHORT_GAP * float(ball["radius"]))
    tx, ty, _bend = track
    if seconds == 0.0 or (tx == 0.0 and ty == 0.0):
        return place_after(ball, flight, seconds)
    arm = (x - px, y - py)
    speed = dot(tx, ty, vx - (ux - spin * arm[1]), vy - (uy + spin * arm[0]))
    pull = (float(state["gravity_x"]), float(state["gravity_y"]))
    drag = drag_along(state, ball, track)
    way, now = slid_along(track, arm, pull, drag, spin, seconds, speed)
    dx, dy, wx, wy = along_track(track[0], track[1], track[2], way)
    if spin == 0.0:
        return x + (ux * seconds + dx), y + (uy * seconds + dy), ux + now * wx, uy + now * wy
    c, s = cos(spin * seconds), sin(spin * seconds)
    dx, dy = rotated(arm[0] + dx, arm[1] + dy, c, s)
    wx, wy = rotated(wx, wy, c, s)
    return (
        px + ux * seconds + dx,
        py + uy * seconds + dy,
        ux - spin * dy + now * wx,
        uy + spin * dx + now * wy,
    )


def slide_on(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    seconds: float,
) -> bool:
    """True for a ball that slides along one bent or turning shape: it is moved on for so many seconds.

    Its flight begins where its row says still.
    """
    held = slides_along(ball, flight, shapes, relations)
    if held == NO_RELATION:
        return False
    x, y, vx, vy = slid_place(state, ball, flight, shapes[held], seconds)
    ball["x"] = x
    ball["y"] = y
    ball["vx"] = vx
    ball["vy"] = vy
    return True


def turn_time(state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow) -> float:
    """The tick of a ball that slides along a bent or turning shape: it hardly leaves the shape in it; may be infinite.

    With a speed w, an acceleration a and turning by b in a second, the parabola is off by w·b³·t⁴/8 + a·b·t³/2 +
    a²·bend·t⁴/8, but for higher powers of the time.
    """
    x, y = float(ball["x"]), float(ball["y"])
    age, spin = age_of_motion(shape, flight), frame_spin(shape)
    px, py, ux, uy = frame_at(shape, age)
    track = track_at(shape, age, x, y, SHORT_GAP * float(ball["radius"]))
    tx, ty, bend = track
    arm, pull = (x - px, y - py), (float(state["gravity_x"]), float(state["gravity_y"]))
    vx, vy = float(ball["vx"]) - ux, float(ball["vy"]) - uy
    speed = length(vx, vy)
    along = fabs(dot(tx, ty, vx + spin * arm[1], vy - spin * arm[0]))
    gains = fabs(pull_along(track, arm, pull, drag_along(state, ball, track), spin, 0.0, 0.0, 0.0)[0])
    turns = fabs(spin) + bend * along
    if turns == 0.0 and gains * bend == 0.0:
        return inf
    # As fast as it swings about where it would stay, too.
    sway = sqrt(bend * (length(pull[0], pull[1]) + spin * spin * length(arm[0], arm[1])))
    time = SLIDE_TURN / (turns + sway)
    lift = SLIDE_LIFT * float(ball["radius"])
    fourth = (speed * turns * turns * turns + gains * gains * bend) * time * time * time * time
    if fourth > 8.0 * lift:
        time = time * sqrt(sqrt(8.0 * lift / fourth))
    for _ in range(SLIDE_ROUNDS):
        third = gains * turns * time * time * time
        if third > 2.0 * lift:
            # Comes near to the cube root that it asks for, from above.
            time = time * sqrt(sqrt(2.0 * lift / third))
    return time


def slide_time(state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, alone: bool) -> tuple[float, bool]:
    """How long a ball may go on along a shape that holds it, `alone` or with another, and whether it leaves it then."""
    if bend_center(shape) is None and not (is_moving(shape) and shape["spin"] != 0.0):
        return time_to_end(ball, flight, shape)
    time = turn_time(state, ball, flight, shape)
    if time == inf or is_held(state, ball, flight, shape, alone, time):
        return time, False
    begin, end = 0.0, time
    for _ in range(ROOT_STEPS):
        middle = 0.5 * (begin + end)
        if not begin < middle < end:
            break
        if is_held(state, ball, flight, shape, alone, middle):
            begin = middle
        else:
            end = middle
    return end, True


def time_to_end(ball: BallRow, flight: FlightRow, shape: ShapeRow) -> tuple[float, bool]:
    """When a ball comes to an end of a straight shape that does not turn, and True; infinite and False if never."""
    if not is_straight(shape["kind"]):
        return inf, False
    px, py, ux, uy = frame_at(shape, age_of_motion(shape, flight))
    dx, dy = float(ball["x"]) - px, float(ball["y"]) - py
    tx, ty, slop = float(shape["tx"]), float(shape["ty"]), 3.0 * END_SLOP * float(ball["radius"])
    dx -= float(shape["ax"]) - float(shape["pivot_x"])
    dy -= float(shape["ay"]) - float(shape["pivot_y"])
    along = dot(dx, dy, tx, ty)
    rate = dot(float(ball["vx"]) - ux, float(ball["vy"]) - uy, tx, ty)
    acceleration = dot(float(flight["ax"]), float(flight["ay"]), tx, ty)
    time = inf
    back = falling_time(along + slop, rate, acceleration)
    if back is not None and back < time:
        time = 0.0 + back
    ahead = falling_time(float(shape["length"]) + slop - along, -rate, -acceleration)
    if ahead is not None and ahead < time:
        time = 0.0 + ahead
    return time, time < inf


def is_held(
    state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, alone: bool, seconds: float
) -> bool:  # fmt: skip
    """True if a ball is beside a shape still after so many seconds, and pressed onto it if that holds it `alone`."""
    age, radius = age_of_motion(shape, flight) + seconds, float(ball["radius"])
    if alone and slides(flight, shape):
        x, y, vx, vy = slid_place(state, ball, flight, shape, seconds)
    else:
        x, y, vx, vy = place_after(ball, flight, seconds)
    if has_ends(shape["kind"]):
        fx, fy = x, y
        if is_moving(shape):
            fx, fy = into_frame(shape, age, x, y)
        if past_end(shape, fx, fy) > 3.0 * END_SLOP * radius:
            return False
    if not alone:
        return True
    found = gap_past_ends(shape, age, x, y, radius, vx, vy, radius)
    if found is None:
        return False
    _gap, nx, ny = found
    gx, gy = pull_at(state, ball, vx, vy)
    return holding_acceleration(shape, age, x, y, vx, vy, nx, ny) > dot(gx, gy, nx, ny)


def past_end(shape: ShapeRow, x: float, y: float) -> float:
    """How far a place is past an end of a segment or arc, seen as it stands; below 0 where it is beside it."""
    ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
    if is_straight(shape["kind"]):
        tx, ty = float(shape["tx"]), float(shape["ty"])
        along = dot(x - ax, y - ay, tx, ty)
        return -smaller(along, float(shape["length"]) - along)
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    dx, dy = x - cx, y - cy
    ax, ay, bx, by = (ax - cx) / r, (ay - cy) / r, (bx - cx) / r, (by - cy) / r
    # The distances from the lines of the two rays, where it is near to one. Past both it is outside of an arc of more
    # than half a turn, past one outside of a shorter.
    past_a, past_b = -cross(ax, ay, dx, dy), cross(bx, by, dx, dy)
    if dot(ax, ay, dx, dy) <= 0.0:
        return past_b if dot(bx, by, dx, dy) > 0.0 else -inf
    if dot(bx, by, dx, dy) <= 0.0:
        return past_a
    return smaller(past_a, past_b) if cross(ax, ay, bx, by) < 0.0 else larger(past_a, past_b)
