"""When a ball comes onto a sensor past one of its ends, leaves one, or comes off what it passed.

A ball's way is cut at equal parts of its radius, counted from where its flight began, and looked at there; between two
looks of which one finds the ball on the shape and the other does not, the time is found by halving. Looks at which a
ball is known to be too far off are left out.
"""

from __future__ import annotations

from math import fabs, floor, inf, sqrt

from carom.constants import INDEX_MARGIN, LOOK_TRAVEL, ROOT_STEPS, SENSOR_LOOKS, SEPARATION_SLACK, SWEEP_ROUNDING
from carom.geometry.impact import impact_disc
from carom.geometry.instants import is_before, later, resolution, seconds_since
from carom.geometry.path import Path, path_after, path_from, place_on
from carom.geometry.vector import dot, larger, length
from carom.rows.ball import BallRow
from carom.rows.flight import CLEAR, EXIT_BALL, EXIT_SHAPE, FLYING, HIT_SHAPE, LOOK, NO_BALL, FlightRow
from carom.rows.kinds_near import distance_to_shape
from carom.rows.pose import is_moving
from carom.rows.shape import ShapeRow
from carom.world.kernels.continuous.flight import (
    consider,
    consider_at,
    event_age,
    path_of,
    place_after,
    time_to_go,
)
from carom.world.kernels.continuous.surfaces import age_of_motion, gap_to_shape, into_frame

#: As many looks as are left out at once at most: whole numbers up to far beyond are doubles.
MOST_LOOKS = 1e12

# What is asked of a ball and a shape.
ON_IT = 0  # beside it and touching
OVERLAPS = 1  # any place of the shape, its ends included


def predict_entry(ball: BallRow, flight: FlightRow, shape: ShapeRow, row: int, age: float) -> None:
    """Foresee that a ball comes onto a sensor past one of its ends, from an age of its flight on."""
    if not is_moving(shape) and not comes_near(ball, flight, shape):
        return
    predict_change(ball, flight, shape, row, age, ON_IT, True, HIT_SHAPE)


def comes_near(ball: BallRow, flight: FlightRow, shape: ShapeRow) -> bool:
    """False where a ball never comes near a shape at rest on its flight."""
    path = path_of(ball, flight)
    left, bottom, right, top = float(shape["left"]), float(shape["bottom"]), float(shape["right"]), float(shape["top"])
    cx, cy = 0.5 * left + 0.5 * right, 0.5 * bottom + 0.5 * top
    circle = (length(right - cx, top - cy) + float(ball["radius"])) * INDEX_MARGIN
    away = path_from(path, cx, cy)
    x, y, _vx, _vy, _gx, _gy = away
    if x * x + y * y <= circle * circle:
        return True
    return impact_disc(away, circle, inf) is not None


def predict_exit(ball: BallRow, flight: FlightRow, shape: ShapeRow, row: int, age: float) -> None:
    """Foresee that a ball leaves a sensor that it is on."""
    predict_change(ball, flight, shape, row, age, ON_IT, False, EXIT_SHAPE)


def predict_clear(ball: BallRow, flight: FlightRow, shape: ShapeRow, row: int, age: float) -> None:
    """Foresee that a ball comes off a shape that it passes."""
    predict_change(ball, flight, shape, row, age, OVERLAPS, False, CLEAR)


def predict_change(
    ball: BallRow,
    flight: FlightRow,
    shape: ShapeRow,
    row: int,
    age: float,
    question: int,
    wanted: bool,
    event: int,
) -> None:
    """Foresee when the answer to a question becomes what is wanted, or a look from farther along."""
    speed, pull = sight_speed(ball, flight, shape)
    way = LOOK_TRAVEL * float(ball["radius"])
    if age == 0.0 and not wanted and not is_there(ball, flight, shape, question, speed, pull):
        consider(flight, 0.0, event, row)
        return
    if time_to_go(speed, pull, way) == inf:
        return
    number = looks_behind(speed, pull, age, way)
    begin = time_to_go(speed, pull, number * way) if number > 0.0 else 0.0
    for _ in range(SENSOR_LOOKS):
        if begin > event_age(flight) or begin == inf:
            return
        number += 1.0
        end = time_to_go(speed, pull, number * way)
        # What it is on now it may have come onto since an earlier look; or the shape was elsewhere then.
        not_yet = begin < age and answer(ball, flight, shape, question, age, 0.0) != wanted
        if answer(ball, flight, shape, question, end, 0.0) == wanted and not (not_yet and end <= age):
            found = time_of_change(ball, flight, shape, question, wanted, max(begin, 0.0), end)
            if not_yet and found < age:
                found = time_of_change(ball, flight, shape, question, wanted, age, end)
            if not wanted and found > 0.0:
                # At the very instant at which the ball came it would be where it came still, and come again.
                found = larger(found, resolution(float(flight["time"])))
            consider(flight, max(found, age), event, row)
            return
        begin = end
        clear = looks_clear(ball, flight, shape, end, way) if wanted else 0.0
        if clear > 0.0:
            number += clear
            begin = time_to_go(speed, pull, number * way)
    consider(flight, begin, LOOK, NO_BALL)


def is_there(
    ball: BallRow, flight: FlightRow, shape: ShapeRow, question: int, speed: float, pull: float
) -> bool:  # fmt: skip
    """False where a ball that was on a shape is not as its flight begins, because it was put elsewhere.

    What has begun by touching is there, whatever the rounding of its place, and so is what came past an end and is put
    back before that by rounding: it is there when it has gone a way that is hardly more than that. And so is what is so
    fast that it has come before it touches, as no instant in between can be told apart.
    """
    if answer(ball, flight, shape, question, 0.0, SEPARATION_SLACK):
        return True
    soon = time_to_go(speed, pull, SEPARATION_SLACK * float(ball["radius"]))
    soon = larger(soon, resolution(float(flight["time"])))
    return soon < inf and answer(ball, flight, shape, question, soon, SEPARATION_SLACK)


def looks_clear(ball: BallRow, flight: FlightRow, shape: ShapeRow, age: float, way: float) -> float:
    """How many of the next looks need not be made, because a ball is too far from a shape to be on it at them."""
    x, y, _vx, _vy = place_after(ball, flight, age)
    if is_moving(shape):
        x, y = into_frame(shape, age_of_motion(shape, flight) + age, x, y)
    gap = distance_to_shape(shape, x, y) - float(ball["radius"])
    if not 0.0 < gap < inf:
        return 0.0
    # One less than the gap allows, so that no rounding hides a touch, and no more than are counted exactly.
    return max(1.0 * floor(min(gap / (way * SWEEP_ROUNDING), MOST_LOOKS)) - 1.0, 0.0)


def sight_speed(ball: BallRow, flight: FlightRow, shape: ShapeRow) -> tuple[float, float]:
    """Bounds of the speed at which a ball moves as seen from a shape as its flight begins, and of its acceleration."""
    vx, vy, ax, ay = 0.0, 0.0, 0.0, 0.0
    if flight["kind"] == FLYING:
        vx, vy, ax, ay = float(ball["vx"]), float(ball["vy"]), float(flight["ax"]), float(flight["ay"])
    speed = sqrt(vx * vx + vy * vy)
    if is_moving(shape):
        speed += top_surface_speed(shape)
    return speed, sqrt(ax * ax + ay * ay)


def top_surface_speed(shape: ShapeRow) -> float:
    """The most that any place of a moving shape's box moves at."""
    ux, uy = float(shape["velocity_x"]), float(shape["velocity_y"])
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    dx = max(px - float(shape["left"]), float(shape["right"]) - px)
    dy = max(py - float(shape["bottom"]), float(shape["top"]) - py)
    return sqrt(ux * ux + uy * uy) + fabs(float(shape["spin"])) * sqrt(dx * dx + dy * dy)


def time_of_change(
    ball: BallRow, flight: FlightRow, shape: ShapeRow, question: int, wanted: bool, before: float, after: float
) -> float:
    """When, between two ages of a flight, the answer to a question becomes what is wanted."""
    for _ in range(ROOT_STEPS):
        middle = 0.5 * (before + after)
        if answer(ball, flight, shape, question, middle, 0.0) == wanted:
            after = middle
        else:
            before = middle
    return after


def answer(ball: BallRow, flight: FlightRow, shape: ShapeRow, question: int, age: float, slack: float) -> bool:
    """Whether a ball, larger by the part `slack`, is on a shape, or overlaps it, at an age of its flight.

    It overlaps what it touches: where it is carried along in what it fills, rounding parts the two at every instant.
    """
    x, y, _vx, _vy = place_after(ball, flight, age)
    radius = float(ball["radius"])
    motion_age = age_of_motion(shape, flight) + age
    if question == OVERLAPS:
        if is_moving(shape):
            x, y = into_frame(shape, motion_age, x, y)
        return distance_to_shape(shape, x, y) < radius + SEPARATION_SLACK * radius
    found = gap_to_shape(shape, motion_age, x, y, radius, 0.0, 0.0)
    if found is None:
        return False
    gap, _nx, _ny = found
    return gap <= slack * radius


def predict_parting(
    ball: BallRow, flight: FlightRow, other: BallRow, partner: FlightRow, row: int, time: float, low: float
) -> bool:
    """True where two balls, one of which is a sensor, part from an instant on, and it is what comes next for the first.

    The later of their flights is where the looks are counted from.
    """
    begin, begin_low = float(flight["time"]), float(flight["low"])
    if is_before(begin, begin_low, float(partner["time"]), float(partner["low"])):
        begin, begin_low = float(partner["time"]), float(partner["low"])
    one = seconds_since(begin, begin_low, float(flight["time"]), float(flight["low"]))
    two = seconds_since(begin, begin_low, float(partner["time"]), float(partner["low"]))
    first, second = path_after_age(ball, flight, one), path_after_age(other, partner, two)
    # Seen from the other: far on in time two that fall alike are at one place but for rounding.
    x1, y1, vx1, vy1, ax1, ay1 = first
    x2, y2, vx2, vy2, ax2, ay2 = second
    apart = Path(x1 - x2, y1 - y2, vx1 - vx2, vy1 - vy2, ax1 - ax2, ay1 - ay2)
    speed, pull = length(vx1 - vx2, vy1 - vy2), length(ax1 - ax2, ay1 - ay2)
    reach = float(ball["radius"]) + float(other["radius"])
    way = LOOK_TRAVEL * min(float(ball["radius"]), float(other["radius"]))
    age = max(seconds_since(time, low, begin, begin_low), 0.0)
    if age == 0.0 and is_apart(apart, 0.0, reach + SEPARATION_SLACK * reach):
        # One was put elsewhere; what has begun by touching is there, whatever the rounding of its place.
        return consider_at(flight, begin, begin_low, EXIT_BALL, row)
    if time_to_go(speed, pull, way) == inf:
        return False
    number = looks_behind(speed, pull, age, way)
    before = time_to_go(speed, pull, number * way) if number > 0.0 else 0.0
    while True:
        number += 1.0
        after = time_to_go(speed, pull, number * way)
        if after == inf:
            return False
        if has_parted(apart, after, reach):
            break
        before = after
    for _ in range(ROOT_STEPS):
        middle = 0.5 * (before + after)
        if has_parted(apart, middle, reach):
            after = middle
        else:
            before = middle
    found, found_low = later(begin, begin_low, max(after, age))
    return consider_at(flight, found, found_low, EXIT_BALL, row)


def looks_behind(speed: float, pull: float, age: float, way: float) -> float:
    """The number of ways surely gone at an age, so that looks are where they would be from anywhere.

    One less than are gone: what comes at the very look where it is foreseen anew was found before that.
    """
    return max(1.0 * floor((speed + 0.5 * pull * age) * age / way) - 1.0, 0.0)


def path_after_age(ball: BallRow, flight: FlightRow, age: float) -> tuple[float, float, float, float, float, float]:
    """Place, velocity and acceleration of a ball at an age of its flight."""
    x, y, vx, vy = place_after(ball, flight, age)
    _x, _y, _vx, _vy, gx, gy = path_of(ball, flight)
    return x, y, vx, vy, gx, gy


def is_apart(path: Path, age: float, reach: float) -> bool:
    """True if what is on a path is no nearer than `reach` to the origin at an age."""
    x, y = place_on(path, age)
    return x * x + y * y >= reach * reach


def has_parted(path: Path, age: float, reach: float) -> bool:
    """True if what is on a path is no nearer than `reach` to the origin at an age, and goes on away from it.

    Two that all but pass each other by may touch and be apart by rounding while they still approach; taken for parted
    they would touch anew, without end.
    """
    x, y, vx, vy, _gx, _gy = path_after(path, age)
    away = x * x + y * y
    if dot(x, y, vx, vy) < 0.0:
        reach += SEPARATION_SLACK * reach
    return away >= reach * reach
