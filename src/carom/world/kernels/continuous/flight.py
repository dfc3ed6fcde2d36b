"""A ball's flight within a span of a substep: its own time, its acceleration, and where it is when."""

from __future__ import annotations

from math import sqrt

from carom.geometry.path import Path, place_on
from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, FLYING, NO_PLACE, NOTHING, STALLED, FlightRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def begin_flight(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Let a ball begin a span: it falls freely, unless it sleeps or has been stopped for the substep."""
    flight["time"] = 0.0
    flight["event"] = NOTHING
    flight["place"] = NO_PLACE
    flight["patience"] = 0.0
    flight["version"] += 1
    if flight["kind"] != STALLED:
        flight["kind"] = ASLEEP if ball["asleep"] != 0 else FLYING
    fall_freely(state, flight)


def fall_freely(state: StateRow, flight: FlightRow) -> None:
    """Give a ball the acceleration of gravity, or none if it does not fly."""
    falls = flight["kind"] == FLYING
    flight["ax"] = float(state["gravity_x"]) if falls else 0.0
    flight["ay"] = float(state["gravity_y"]) if falls else 0.0


def place_at(ball: BallRow, flight: FlightRow, time: float) -> tuple[float, float, float, float]:
    """Where a ball is at a time of the span and how fast it moves, as (x, y, vx, vy)."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    if flight["kind"] != FLYING:
        return x, y, 0.0, 0.0
    ax, ay = float(flight["ax"]), float(flight["ay"])
    dt = time - float(flight["time"])
    half = 0.5 * dt * dt
    return x + (vx * dt + ax * half), y + (vy * dt + ay * half), vx + ax * dt, vy + ay * dt


def path_of(ball: BallRow, flight: FlightRow) -> Path:
    """The path of a ball from where it is in its row."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    return Path(x, y, vx, vy, float(flight["ax"]), float(flight["ay"]))


def path_at(ball: BallRow, flight: FlightRow, time: float) -> Path:
    """The path of a ball from where it is at a time of the span."""
    x, y, vx, vy = place_at(ball, flight, time)
    return Path(x, y, vx, vy, float(flight["ax"]), float(flight["ay"]))


def fly_to(ball: BallRow, flight: FlightRow, time: float) -> None:
    """Move a ball to where it is at a time of the span."""
    if flight["kind"] == FLYING:
        x, y, vx, vy = place_at(ball, flight, time)
        ball["x"] = x
        ball["y"] = y
        ball["vx"] = vx
        ball["vy"] = vy
    flight["time"] = time


def top_speed(ball: BallRow, flight: FlightRow, duration: float) -> float:
    """The most that a ball's speed can be in the next `duration` seconds of its flight."""
    vx, vy = float(ball["vx"]), float(ball["vy"])
    ax, ay = float(flight["ax"]), float(flight["ay"])
    return sqrt(vx * vx + vy * vy) + sqrt(ax * ax + ay * ay) * duration


def path_box(path: Path, begin: float, end: float) -> tuple[float, float, float, float]:
    """The box (left, bottom, right, top) of a ball's centre between two times from now."""
    x0, y0 = place_on(path, begin)
    x1, y1 = place_on(path, end)
    # Between two of its points a parabola is never farther from their chord than an eighth of this.
    bulge_x = 0.125 * abs(path.gx) * (end - begin) * (end - begin)
    bulge_y = 0.125 * abs(path.gy) * (end - begin) * (end - begin)
    return min(x0, x1) - bulge_x, min(y0, y1) - bulge_y, max(x0, x1) + bulge_x, max(y0, y1) + bulge_y


def consider(flight: FlightRow, delay: float, event: int, partner: int) -> None:
    """Make an event the next one if it comes sooner than what was to come."""
    time = float(flight["time"]) + delay
    if time < flight["event_time"]:
        flight["event_time"] = time
        flight["event"] = event
        flight["partner"] = partner


def forget_partner(flight: FlightRow) -> None:
    """Let events that others foresaw with this ball count no more: its path is another from now on."""
    flight["version"] += 1


def new_flights(state: StateRow, flights: Table[FlightRow]) -> None:
    """Begin a substep: nothing is stopped and no impacts are counted."""
    for i in range(state["balls"]):
        flights[i]["kind"] = FLYING
        flights[i]["impacts"] = 0
