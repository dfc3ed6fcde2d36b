"""How kernels write a hit."""

from __future__ import annotations

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
    speed: float,
    impulse: float,
) -> None:
    """Write a bounce into `hit`, the next free row, and count the collision.

    `touch` is the point, the unit normal towards the ball and the setback.
    """
    px, py, nx, ny, setback = touch
    # The row may hold an older hit: every field is written.
    write_hit(state, hit, time, BOUNCE, int(ball["id"]), int(shape["id"]))
    hit["point_x"] = px
    hit["point_y"] = py
    hit["normal_x"] = nx
    hit["normal_y"] = ny
    hit["setback"] = setback
    hit["speed"] = speed
    hit["impulse"] = impulse
    state["collisions"] += 1


def write_hit(state: StateRow, hit: HitRow, time: float, kind: int, ball: int, shape: int) -> None:
    """Write zeros but for time, kind and ids (what `ENTER` and `EXIT` are) into `hit`, the next free row."""
    hit["time"] = time
    hit["kind"] = kind
    hit["ball"] = ball
    hit["shape"] = shape
    hit["point_x"] = 0.0
    hit["point_y"] = 0.0
    hit["normal_x"] = 0.0
    hit["normal_y"] = 0.0
    hit["setback"] = 0.0
    hit["speed"] = 0.0
    hit["impulse"] = 0.0
    state["hits"] += 1
