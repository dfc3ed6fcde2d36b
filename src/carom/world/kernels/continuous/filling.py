"""Balls as large as the arc or circle in which they lie.

Such a ball touches all of the bend at once, so that where it is within it, by rounding, tells no direction: it lies on
the place onto which it is pulled, and goes along with the bend.
"""

from __future__ import annotations

from carom.constants import SHORT_GAP
from carom.geometry.vector import cross, length, unit
from carom.rows.ball import BallRow
from carom.rows.flight import FlightRow
from carom.rows.kinds import has_ends
from carom.rows.pose import is_moving
from carom.rows.shape import ShapeRow
from carom.world.kernels.continuous.surfaces import age_of_motion, center_of_bend, gap_to_shape


def fills_bend(shape: ShapeRow, age: float, x: float, y: float, radius: float) -> bool:
    """True for a ball at (x, y) that is as large as the bend it lies in: it touches all of it and slides nowhere."""
    center = center_of_bend(shape, age)
    if center is None:
        return False
    cx, cy = center
    return length(x - cx, y - cy) <= SHORT_GAP * radius


def settle_in_bend(
    ball: BallRow, flight: FlightRow, shape: ShapeRow, age: float, gx: float, gy: float
) -> bool:  # fmt: skip
    """True for a ball that fills the bend it lies in, and is pulled onto a place of it: it goes there, and with it."""
    center, pull = center_of_bend(shape, age), pull_in_bend(ball, shape, age, gx, gy)
    if center is None or pull is None:
        return False
    cx, cy = center
    px, py, ax, ay = pull
    if not is_bent_there(ball, shape, age, px, py):
        return False
    away = length(float(ball["x"]) - cx, float(ball["y"]) - cy)
    ball["x"] = cx + away * px
    ball["y"] = cy + away * py
    flight["ax"] = ax
    flight["ay"] = ay
    return True


def drops_out(ball: BallRow, flight: FlightRow, shape: ShapeRow, gx: float, gy: float) -> bool:
    """True for a ball that fills an arc of no more than half a turn, and is pulled to where that is open.

    Wherever it is it touches all of the arc, so that is never beside it to the last digit.
    """
    age = age_of_motion(shape, flight)
    pull = pull_in_bend(ball, shape, age, gx, gy)
    if pull is None or not has_ends(shape["kind"]):
        return False
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    ax, ay = (float(shape["ax"]) - cx) / r, (float(shape["ay"]) - cy) / r
    bx, by = (float(shape["bx"]) - cx) / r, (float(shape["by"]) - cy) / r
    px, py, _ax, _ay = pull
    return cross(ax, ay, bx, by) > -SHORT_GAP and not is_bent_there(ball, shape, age, px, py)


def pull_in_bend(
    ball: BallRow, shape: ShapeRow, age: float, gx: float, gy: float
) -> tuple[float, float, float, float] | None:
    """Where a ball is pulled in the bend that it fills, a unit vector, and the acceleration of the bend's centre.

    None if it fills none, or nothing pulls it there.
    """
    center = center_of_bend(shape, age)
    if center is None or not fills_bend(shape, age, float(ball["x"]), float(ball["y"]), float(ball["radius"])):
        return None
    cx, cy = center
    ax, ay = 0.0, 0.0
    if is_moving(shape):
        spin = float(shape["spin"])
        ax = -spin * spin * (cx - (float(shape["pivot_x"]) + float(shape["velocity_x"]) * age))
        ay = -spin * spin * (cy - (float(shape["pivot_y"]) + float(shape["velocity_y"]) * age))
    pull = unit(gx - ax, gy - ay)
    if pull is None:
        return None
    px, py = pull
    return px, py, ax, ay


def is_bent_there(ball: BallRow, shape: ShapeRow, age: float, px: float, py: float) -> bool:
    """True if a bend that a ball fills has a place in a direction, a unit vector, from its centre."""
    center, radius = center_of_bend(shape, age), float(ball["radius"])
    if center is None:
        return False
    cx, cy = center
    least = SHORT_GAP * radius
    return gap_to_shape(shape, age, cx + least * px, cy + least * py, radius, 0.0, 0.0) is not None
