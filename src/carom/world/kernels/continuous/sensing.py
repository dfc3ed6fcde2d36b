"""Where and how fast a ball in flight crosses the edge of what senses it."""

from __future__ import annotations

from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.hit import HitRow
from carom.rows.kinds_near import closest_on_shape
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.surfaces import age_of_motion, gap_to_shape, into_frame, out_of_frame
from carom.world.kernels.step.hits import normal_from, write_crossing


def cross_edge(
    state: StateRow, hits: Table[HitRow], kind: int, ball: BallRow, flight: FlightRow, shape: ShapeRow
) -> None:
    """Record that a ball, whose flight begins now, has come onto a shape that senses it, or the reverse, or left it."""
    age = age_of_motion(shape, flight)
    px, py, nx, ny = edge_at(ball, shape, age)
    ux, uy = surface_velocity(shape, float(shape["spin"]), px, py, age)
    speed = length(float(ball["vx"]) - ux, float(ball["vy"]) - uy)
    write_crossing(
        state, hits[state["hits"]], float(state["now"]), kind, ball, int(shape["id"]), (px, py, nx, ny), speed
    )


def edge_at(ball: BallRow, shape: ShapeRow, age: float) -> tuple[float, float, float, float]:
    """The place of a shape, at an age of its motion, that a ball is nearest to, and the unit normal from there."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    found = gap_to_shape(shape, age, x, y, radius, float(ball["vx"]), float(ball["vy"]))
    if found is not None:
        gap, nx, ny = found
        return x - (radius + gap) * nx, y - (radius + gap) * ny, nx, ny
    # Past an end, over which it has gone.
    if is_moving(shape):
        fx, fy = into_frame(shape, age, x, y)
        px, py, _inside = closest_on_shape(shape, fx, fy)
        px, py = out_of_frame(shape, age, px, py)
    else:
        px, py, _inside = closest_on_shape(shape, x, y)
    nx, ny = normal_from(px, py, ball)
    return px, py, nx, ny
