"""How kernels write a hit."""

from __future__ import annotations

from carom.geometry.vector import length, unit
from carom.rows.ball import BallRow
from carom.rows.hit import BOUNCE, HitRow
from carom.rows.state import StateRow
from carom.rows.tables import Numbered


def record_hit(
    state: StateRow,
    hit: HitRow,
    time: float,
    ball: BallRow,
    shape: Numbered,
    touch: tuple[float, float, float, float, float],
    before: tuple[float, float],
    speed: float,
    impulse: float,
) -> None:
    """Write a bounce into `hit`, the next free row, and count the collision.

    `touch` is the point, the unit normal towards the ball and the setback; `before` the velocity that the ball had.
    """
    px, py, nx, ny, setback = touch
    vx, vy = before
    # The row may hold an older hit: every field is written.
    write_hit(state, hit, time, BOUNCE, ball, int(shape["id"]))
    hit["point_x"] = px
    hit["point_y"] = py
    hit["normal_x"] = nx
    hit["normal_y"] = ny
    hit["setback"] = setback
    hit["speed"] = speed
    hit["impulse"] = impulse
    hit["velocity_x"] = vx
    hit["velocity_y"] = vy
    state["collisions"] += 1


def write_hit(state: StateRow, hit: HitRow, time: float, kind: int, ball: BallRow, other: int) -> None:
    """Write time, kind, the ball as it is, and the id of what it met into `hit`, the next free row; zeros else."""
    hit["time"] = time
    hit["kind"] = kind
    hit["ball"] = ball["id"]
    hit["shape"] = other
    hit["point_x"] = 0.0
    hit["point_y"] = 0.0
    hit["normal_x"] = 0.0
    hit["normal_y"] = 0.0
    hit["setback"] = 0.0
    hit["speed"] = 0.0
    hit["impulse"] = 0.0
    hit["velocity_x"] = ball["vx"]
    hit["velocity_y"] = ball["vy"]
    hit["position_x"] = ball["x"]
    hit["position_y"] = ball["y"]
    state["hits"] += 1


def write_crossing(
    state: StateRow,
    hit: HitRow,
    time: float,
    kind: int,
    ball: BallRow,
    other: int,
    touch: tuple[float, float, float, float],
    speed: float,
) -> None:
    """Write into `hit`, the next free row, that a ball crosses a sensor's edge; `touch` is the point and the normal."""
    px, py, nx, ny = touch
    write_hit(state, hit, time, kind, ball, other)
    hit["point_x"] = px
    hit["point_y"] = py
    hit["normal_x"] = nx
    hit["normal_y"] = ny
    hit["speed"] = speed


def cross_ball(state: StateRow, hit: HitRow, time: float, kind: int, ball: BallRow, other: BallRow) -> None:
    """Write into `hit`, the next free row, that a ball has come onto another, of which one is a sensor, or left it."""
    x, y, radius = float(other["x"]), float(other["y"]), float(other["radius"])
    nx, ny = normal_from(x, y, ball)
    speed = length(float(ball["vx"]) - float(other["vx"]), float(ball["vy"]) - float(other["vy"]))
    touch = (x + radius * nx, y + radius * ny, nx, ny)
    write_crossing(state, hit, time, kind, ball, int(other["id"]), touch, speed)


def normal_from(x: float, y: float, ball: BallRow) -> tuple[float, float]:
    """The unit vector from (x, y) to a ball's centre; along y where they are one, as for balls that overlap so."""
    found = unit(float(ball["x"]) - x, float(ball["y"]) - y)
    if found is None:
        return 0.0, 1.0
    nx, ny = found
    return nx, ny
