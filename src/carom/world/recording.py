"""How kernels write a hit."""

from __future__ import annotations

from carom.rows import Row, Rows
from carom.world.layout import BOUNCE


def record_hit(
    state: Row,
    hits: Rows,
    time: float,
    ball: Row,
    shape: Row,
    px: float,
    py: float,
    nx: float,
    ny: float,
    setback: float,
    speed: float,
    impulse: float,
) -> None:
    """Write a bounce behind the other hits, where there must be room, and count the collision."""
    write_hit(state, hits, time, BOUNCE, int(ball["id"]), int(shape["id"]))
    hit = hits[state["hits"] - 1]
    hit["point"][0] = px
    hit["point"][1] = py
    hit["normal"][0] = nx
    hit["normal"][1] = ny
    hit["setback"] = setback
    hit["speed"] = speed
    hit["impulse"] = impulse
    state["collisions"] += 1


def write_hit(state: Row, hits: Rows, time: float, kind: int, ball: int, shape: int) -> None:
    """Write a hit of zeros but for time, kind and ids (what `ENTER` and `EXIT` are) behind the other hits."""
    hit = hits[state["hits"]]
    hit["time"] = time
    hit["kind"] = kind
    hit["ball"] = ball
    hit["shape"] = shape
    hit["point"][0] = 0.0
    hit["point"][1] = 0.0
    hit["normal"][0] = 0.0
    hit["normal"][1] = 0.0
    hit["setback"] = 0.0
    hit["speed"] = 0.0
    hit["impulse"] = 0.0
    state["hits"] += 1
