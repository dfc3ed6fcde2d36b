"""A ball's flight: the instant it began, its acceleration, where the ball is when, and how soon it has ended."""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import (
    GAP_ROUNDING,
    MOST_AT_ONCE,
    SHORT_ELASTIC_FLIGHT,
    SHORT_ELASTIC_FLIGHTS,
    SHORT_FLIGHT,
    SHORT_FLIGHTS,
)
from carom.geometry.instants import is_before, later, seconds_since
from carom.geometry.path import Path, place_on
from carom.geometry.vector import larger, length
from carom.rows.ball import OF_WORLD, BallRow
from carom.rows.flight import ASLEEP, EXIT_BALL, FLYING, HIT_BALL, NOTHING, FlightRow
from carom.rows.state import StateRow
from carom.world.kernels.step.motion import wake

#: Factor by which the keys of balls stand apart, so that two rows make one number.
KEY_SIDE = 4294967296


def age_now(state: StateRow, flight: FlightRow) -> float:
    """The seconds since a flight began, at the instant that the film is shown."""
    return seconds_since(float(state["now"]), float(state["now_low"]), float(flight["time"]), float(flight["low"]))


def age_at(flight: FlightRow, time: float, low: float) -> float:
    """The seconds since a flight began at an instant."""
    return seconds_since(time, low, float(flight["time"]), float(flight["low"]))


def begins_now(state: StateRow, flight: FlightRow) -> bool:
    """True if a flight begins at the instant that the film is shown."""
    return bool(flight["time"] == state["now"] and flight["low"] == state["now_low"])


def place_after(ball: BallRow, flight: FlightRow, age: float) -> tuple[float, float, float, float]:
    """Where a ball is at an age of its flight and how fast it moves, as (x, y, vx, vy)."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    if flight["kind"] != FLYING:
        return x, y, 0.0, 0.0
    ax, ay = float(flight["ax"]), float(flight["ay"])
    half = 0.5 * age * age
    return x + (vx * age + ax * half), y + (vy * age + ay * half), vx + ax * age, vy + ay * age


def note_course(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Let the flight of a ball tell from where on it is, as its row does, and whether it falls freely.

    A sensor does not count as such: who has left one by rounding alone is to be asked as well.
    """
    flight["x"] = ball["x"]
    flight["y"] = ball["y"]
    flight["vx"] = ball["vx"]
    flight["vy"] = ball["vy"]
    falls = flight["ax"] == state["gravity_x"] and flight["ay"] == state["gravity_y"] and flight["kind"] == FLYING
    flight["reach"] = ball["radius"] if falls and ball["sensor"] == 0 else 0.0


def path_of(ball: BallRow, flight: FlightRow) -> Path:
    """The path of a ball from where its flight began."""
    if flight["kind"] != FLYING:
        return Path(float(ball["x"]), float(ball["y"]), 0.0, 0.0, 0.0, 0.0)
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    return Path(x, y, vx, vy, float(flight["ax"]), float(flight["ay"]))


def path_at(ball: BallRow, flight: FlightRow, age: float) -> Path:
    """The path of a ball from an age of its flight on; to the bit `path_of` at 0."""
    if age == 0.0:
        return path_of(ball, flight)
    x, y, vx, vy = place_after(ball, flight, age)
    if flight["kind"] != FLYING:
        return Path(x, y, vx, vy, 0.0, 0.0)
    return Path(x, y, vx, vy, float(flight["ax"]), float(flight["ay"]))


def friction_of(state: StateRow, ball: BallRow) -> float:
    """The deceleration of a ball by friction."""
    friction = float(ball["friction"])
    return float(state["friction"]) if friction == OF_WORLD else friction


def fall_freely(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Give a ball the acceleration of gravity and of friction, or none if it does not fly."""
    flight["ax"] = float(state["gravity_x"]) if flight["kind"] == FLYING else 0.0
    flight["ay"] = float(state["gravity_y"]) if flight["kind"] == FLYING else 0.0
    add_friction(state, ball, flight)


def add_friction(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Add friction to a ball's acceleration: against its velocity, or what keeps it from moving where that suffices."""
    loss = friction_of(state, ball)
    if loss == 0.0 or flight["kind"] != FLYING:
        return
    vx, vy = float(ball["vx"]), float(ball["vy"])
    speed = sqrt(vx * vx + vy * vy)
    ax, ay = float(flight["ax"]), float(flight["ay"])
    if speed > 0.0:
        flight["ax"] = ax - loss * (vx / speed)
        flight["ay"] = ay - loss * (vy / speed)
        return
    pull = sqrt(ax * ax + ay * ay)
    share = 1.0 - loss / pull if pull > loss else 0.0
    flight["ax"] = ax * share
    flight["ay"] = ay * share


def time_to_go(speed: float, pull: float, way: float) -> float:
    """The least time in which what has a speed, and a `pull` at most, can go a way; infinite where it never does."""
    root = speed + sqrt(speed * speed + 2.0 * pull * way)
    if root == inf:
        # The square of the speed has overflowed; a pull adds nothing to such a one.
        return way / speed
    return 2.0 * way / root if root > 0.0 else inf


def path_box(path: Path, begin: float, end: float) -> tuple[float, float, float, float]:
    """The box (left, bottom, right, top) of a ball's centre between two ages of its flight.

    It is no wider and no higher than the way that the ball goes.
    """
    x0, y0 = place_on(path, begin)
    x1, y1 = place_on(path, end)
    left, right = widened(min(x0, x1), max(x0, x1), path.x, path.vx, path.gx, begin, end)
    bottom, top = widened(min(y0, y1), max(y0, y1), path.y, path.vy, path.gy, begin, end)
    return left, bottom, right, top


def widened(
    low: float, high: float, place: float, speed: float, pull: float, begin: float, end: float
) -> tuple[float, float]:
    """A stretch of a line with the place where what falls along the line turns round between two times, if it does."""
    if (speed + pull * begin) * (speed + pull * end) >= 0.0:
        return low, high
    turn = place - 0.5 * speed * (speed / pull)
    return min(low, turn), max(high, turn)


def event_age(flight: FlightRow) -> float:
    """The age of a flight at which its next event comes; infinite if nothing does."""
    if flight["event"] == NOTHING:
        return inf
    return age_at(flight, float(flight["event_time"]), float(flight["event_low"]))


def consider(flight: FlightRow, age: float, event: int, partner: int) -> bool:
    """True where an event at an age of the flight comes sooner than what was to come, and is what comes next now."""
    time, low = later(float(flight["time"]), float(flight["low"]), age)
    return consider_at(flight, time, low, event, partner)


def consider_at(flight: FlightRow, time: float, low: float, event: int, partner: int) -> bool:
    """The same for an event at an instant.

    Of those at one instant the one with the lower key comes first, as in the queue; of several of one ball alone the
    greatest kind, and of these that with the lower row. So it does not matter in which order they are found, nor in
    which of two rows an impact of two balls stands.
    """
    row = int(flight["row"])
    of_two = event == HIT_BALL or event == EXIT_BALL
    key = min(row, partner) * KEY_SIDE + max(row, partner) + 1 if of_two else row * KEY_SIDE
    if flight["event"] != NOTHING:
        if is_before(float(flight["event_time"]), float(flight["event_low"]), time, low):
            return False
        if time == flight["event_time"] and low == flight["event_low"]:
            known, known_key = int(flight["event"]), int(flight["event_key"])
            if known_key < key:
                return False
            if known_key == key and (known > event or (known == event and int(flight["partner"]) <= partner)):
                return False
    flight["event_time"] = time
    flight["event_low"] = low
    flight["event"] = event
    flight["partner"] = partner
    flight["event_key"] = key
    return True


def is_tired(flight: FlightRow, elasticity: float, in_heap: bool) -> bool:
    """True for a ball whose impacts, at an elasticity, follow too close on one another to be told apart.

    What lies behind a ball of a heap throws it back at once onto what it has met, whatever its elasticity: there the
    second impact takes the rest, as all that would follow together do.
    """
    if elasticity >= 1.0:
        return bool(flight["short"] > SHORT_ELASTIC_FLIGHTS)
    return bool(flight["short"] > (0 if in_heap else SHORT_FLIGHTS))


def let_fly(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Wake a ball that was hit and let it fly from now on."""
    if flight["kind"] == ASLEEP:
        wake(state, ball)
        flight["kind"] = FLYING
        flight["slow_for"] = 0.0


def let_sleep(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Let a ball, whose flight begins now, sleep from now on."""
    ball["vx"] = 0.0
    ball["vy"] = 0.0
    ball["asleep"] = 1
    ball["still_time"] = flight["slow_for"]
    state["sleeping"] += 1
    flight["kind"] = ASLEEP


def is_crowded(flight: FlightRow) -> bool:
    """True for a ball that has had ever more impacts at one instant, between others that leave it no way to go."""
    return bool(flight["at_once"] > SHORT_ELASTIC_FLIGHTS)


def is_worn(flight: FlightRow) -> bool:
    """True for a ball that has had ever more impacts too close on one another, and goes on having them."""
    return bool(flight["short"] >= MOST_AT_ONCE)


def count_impact(ball: BallRow, flight: FlightRow, elasticity: float, approach: float, depth: float) -> None:
    """Count an impact of a ball, and whether it came too soon after the one before.

    Too soon is where a part of the radius is more than the ball can have gone meanwhile, at the speed of approach. One
    that is deeper than that in what moves did not fly there: what moves with that has put it there.
    """
    flight["impacts"] += 1
    seconds = -age_at(flight, float(flight["met_time"]), float(flight["met_low"]))
    radius = float(ball["radius"])
    # Far from the origin a place is rounded by more than that part of the radius, and no shorter way is told from none.
    none = larger(SHORT_ELASTIC_FLIGHT * radius, GAP_ROUNDING * (fabs(float(ball["x"])) + fabs(float(ball["y"]))))
    least = larger(SHORT_FLIGHT * radius, none) if elasticity < 1.0 else none
    flight["short"] = flight["short"] + 1 if seconds * approach < least or depth > least else 0
    way = seconds * (approach + length(float(ball["vx"]), float(ball["vy"])))
    flight["at_once"] = flight["at_once"] + 1 if way < none else 0
    flight["met_time"] = flight["time"]
    flight["met_low"] = flight["low"]
