"""When a ball comes to rest: friction stops it, or it has been slow for so long that it sleeps."""

from __future__ import annotations

from math import inf, sqrt

from carom.constants import FRICTION_TICK, FRICTION_TURN
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, NO_BALL, SLEEP, STOP, TICK, FlightRow
from carom.rows.state import StateRow
from carom.world.kernels.continuous.flight import consider, friction_of


def slow_since(state: StateRow, ball: BallRow, flight: FlightRow, age: float) -> float:
    """The age of a flight since which a ball has been slower than the sleep speed at an age; that age if it is not.

    Below 0 where it had been so when the flight began. The square of the speed is a quadratic in time that has a least
    value, so a ball is slow in one stretch of time.
    """
    least = float(state["sleep_speed"])
    vx, vy, ax, ay = float(ball["vx"]), float(ball["vy"]), float(flight["ax"]), float(flight["ay"])
    ux, uy = vx + ax * age, vy + ay * age
    if least == 0.0 or flight["kind"] != FLYING or ux * ux + uy * uy >= least * least:
        return age
    if vx * vx + vy * vy < least * least:
        return -float(flight["slow_for"])
    begin, _end = slow_stretch(vx, vy, ax, ay, least)
    return min(begin, age)


def slow_stretch(vx: float, vy: float, ax: float, ay: float, least: float) -> tuple[float, float]:
    """The two ages between which a ball, fast at first, is slower than a speed; both infinite where it never is."""
    a, b, c = ax * ax + ay * ay, vx * ax + vy * ay, vx * vx + vy * vy - least * least
    discriminant = b * b - a * c
    if a == 0.0 or b >= 0.0 or discriminant <= 0.0:
        return inf, inf
    root = sqrt(discriminant)
    return c / (root - b), (root - b) / a


def predict_rest(state: StateRow, ball: BallRow, flight: FlightRow) -> None:
    """Foresee that friction stops a ball or has to be reckoned anew, and that it falls asleep."""
    vx, vy, ax, ay = float(ball["vx"]), float(ball["vy"]), float(flight["ax"]), float(flight["ay"])
    speed, pull = sqrt(vx * vx + vy * vy), sqrt(ax * ax + ay * ay)
    if speed > 0.0 and pull > 0.0 and speed / pull < inf and friction_of(state, ball) > 0.0:
        # Along its velocity it goes on straight until it stands; else the direction of friction turns with it.
        if abs(ax * vy - ay * vx) <= FRICTION_TURN * pull * speed:
            if ax * vx + ay * vy < 0.0:
                consider(flight, speed / pull, STOP, NO_BALL)
        else:
            consider(flight, FRICTION_TICK * speed / pull + friction_least(ball, pull), TICK, NO_BALL)
    least = float(state["sleep_speed"])
    if least > 0.0 and not (speed == 0.0 and pull == 0.0 and ball["asleep"] != 0):
        predict_sleep(flight, vx, vy, ax, ay, least, float(state["sleep_time"]))


def friction_least(ball: BallRow, pull: float) -> float:
    """The least tick of a ball whose friction turns: what it goes in it is a small part of its radius."""
    return FRICTION_TICK * sqrt(FRICTION_TICK * float(ball["radius"]) / pull)


def predict_sleep(
    flight: FlightRow, vx: float, vy: float, ax: float, ay: float, least: float, sleep_time: float
) -> None:
    """Foresee that a ball which is slower than a speed for long enough falls asleep."""
    if vx * vx + vy * vy < least * least:
        begin, end = -float(flight["slow_for"]), inf
        age = max(begin + sleep_time, 0.0)
        ux, uy = vx + ax * age, vy + ay * age
        if ux * ux + uy * uy >= least * least:
            return
    else:
        begin, end = slow_stretch(vx, vy, ax, ay, least)
        age = begin + sleep_time
    if age <= end and age < inf:
        consider(flight, age, SLEEP, NO_BALL)
