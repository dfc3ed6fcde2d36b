"""What rounding takes from a ball at an impact with what is bent, kept for its next one.

At an elastic impact with a circle or an arc a ball keeps its speed, and its angular momentum about the centre. Both are
rounded, by another bit each time, so they would walk from what they were, and after n impacts in a round room the ball
would be n³ᐟ² roundings from where it ought to be. What is lacking of both is kept as the part of the velocity that its
doubles cannot hold (`low_vx`, `low_vy`), and given back as soon as they can.
"""

from __future__ import annotations

from math import fabs

from carom.constants import KEPT_ROUNDING, LEAST_STEEPNESS
from carom.geometry.exact import exact_cross, exact_length_squared, exact_sum
from carom.geometry.vector import cross, dot, length
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.kinds import bend_center
from carom.rows.pose import is_moving
from carom.rows.shape import ShapeRow


def way_of(ball: BallRow, flight: FlightRow) -> tuple[float, float, float, float, float, float]:
    """Where the flight of a ball began, with what velocity, and what that lacked: (x, y, vx, vy, low_vx, low_vy)."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    return x, y, vx, vy, float(flight["low_vx"]), float(flight["low_vy"])


def keep_rounding(
    ball: BallRow, flight: FlightRow, shape: ShapeRow, came: tuple[float, float, float, float, float, float]
) -> None:
    """Give a ball that has met a shape what rounding took from its speed and angular momentum, and keep the rest.

    `came` is the place at which it came onto the way to the impact, its velocity there, and what that lacked. Where
    the impact has taken or given more than rounding does, or pulls act on the ball, nothing is done.
    """
    center = bend_center(shape)
    if center is None or is_moving(shape) or flight["ax"] != 0.0 or flight["ay"] != 0.0:
        return
    cx, cy = center
    vx, vy = float(ball["vx"]), float(ball["vy"])
    dx, low_x = exact_sum(float(ball["x"]), -cx)
    dy, low_y = exact_sum(float(ball["y"]), -cy)
    x, y, from_vx, from_vy, from_low_vx, from_low_vy = came
    from_dx, from_low_x = exact_sum(x, -cx)
    from_dy, from_low_y = exact_sum(y, -cy)
    distance, speed = length(dx, dy), length(vx, vy)
    steepness = fabs(dot(vx, vy, dx, dy))
    if not steepness > LEAST_STEEPNESS * distance * speed:
        return
    before, before_low = exact_cross(from_dx, from_dy, from_vx, from_vy)
    before_low += cross(from_low_x, from_low_y, from_vx, from_vy) + cross(from_dx, from_dy, from_low_vx, from_low_vy)
    after, after_low = exact_cross(dx, dy, vx, vy)
    after_low += cross(low_x, low_y, vx, vy)
    turn = ((before - after) + (before_low - after_low)) / distance
    before, before_low = exact_length_squared(from_vx, from_vy)
    after, after_low = exact_length_squared(vx, vy)
    before_low += 2.0 * dot(from_vx, from_vy, from_low_vx, from_low_vy)
    gain = 0.5 * ((before - after) + (before_low - after_low))
    if not (fabs(turn) <= KEPT_ROUNDING * speed and fabs(gain) <= KEPT_ROUNDING * speed * speed):
        return
    nx, ny = dx / distance, dy / distance
    out = (gain - turn * cross(nx, ny, vx, vy)) / dot(vx, vy, nx, ny)
    ball["vx"], flight["low_vx"] = exact_sum(vx, out * nx - turn * ny)
    ball["vy"], flight["low_vy"] = exact_sum(vy, out * ny + turn * nx)
