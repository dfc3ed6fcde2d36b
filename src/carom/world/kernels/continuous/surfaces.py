"""Shapes as a ball in flight meets them: where they are when, when it touches them, and where."""

from __future__ import annotations

from math import cos, sin

from carom.constants import END_SLOP, SEPARATION_SLACK
from carom.geometry.instants import seconds_since
from carom.geometry.path import Path, Turning, place_on
from carom.geometry.vector import rotated
from carom.rows.flight import FlightRow
from carom.rows.kinds import bend_center, gap_at_rest
from carom.rows.kinds_in_motion import impact_in_frame
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.shape import ShapeRow


def age_of_motion(shape: ShapeRow, flight: FlightRow) -> float:
    """The seconds for which a shape had been moving as it does when a flight began; 0 if it stands still."""
    if not is_moving(shape):
        return 0.0
    return seconds_since(
        float(flight["time"]), float(flight["low"]), float(shape["since"]), float(shape["since_low"])
    )  # fmt: skip


def into_frame(shape: ShapeRow, time: float, x: float, y: float) -> tuple[float, float]:
    """The place (x, y) at an age of a shape's motion, relative to the shape as it stood when that began."""
    turn = -float(shape["spin"]) * time
    dx = x - (float(shape["pivot_x"]) + float(shape["velocity_x"]) * time)
    dy = y - (float(shape["pivot_y"]) + float(shape["velocity_y"]) * time)
    if turn != 0.0:
        dx, dy = rotated(dx, dy, cos(turn), sin(turn))
    return float(shape["pivot_x"]) + dx, float(shape["pivot_y"]) + dy


def out_of_frame(shape: ShapeRow, time: float, x: float, y: float) -> tuple[float, float]:
    """The opposite of `into_frame`."""
    dx, dy = x - float(shape["pivot_x"]), y - float(shape["pivot_y"])
    turn = float(shape["spin"]) * time
    if turn != 0.0:
        dx, dy = rotated(dx, dy, cos(turn), sin(turn))
    return (
        float(shape["pivot_x"]) + float(shape["velocity_x"]) * time + dx,
        float(shape["pivot_y"]) + float(shape["velocity_y"]) * time + dy,
    )


def center_of_bend(shape: ShapeRow, time: float) -> tuple[float, float] | None:
    """Where what a shape is bent about, of a point itself, is at an age of its motion; None of what is straight."""
    center = bend_center(shape)
    if center is None or not is_moving(shape):
        return center
    cx, cy = center
    return out_of_frame(shape, time, cx, cy)


def impact_in_motion(
    shape: ShapeRow, time: float, path: Path, radius: float, duration: float, sign: float
) -> float | None:
    """When, from an age of its motion on, a ball first touches a shape that moves, within `duration`, or None.

    `sign` is 1, or -1 for a motion that runs backwards, the ball's path being given as it is then.
    """
    x, y, vx, vy, gx, gy = path
    turn = -float(shape["spin"]) * time
    c, s = cos(turn), sin(turn)
    x, y = into_frame(shape, time, x, y)
    vx, vy = rotated(vx, vy, c, s)
    gx, gy = rotated(gx, gy, c, s)
    ux, uy = rotated(sign * float(shape["velocity_x"]), sign * float(shape["velocity_y"]), c, s)
    turning = Turning(float(shape["pivot_x"]), float(shape["pivot_y"]), ux, uy, sign * float(shape["spin"]))
    return impact_in_frame(shape, turning, Path(x, y, vx, vy, gx, gy), radius, duration)


def gap_to_shape(
    shape: ShapeRow, time: float, x: float, y: float, radius: float, vx: float, vy: float
) -> tuple[float, float, float] | None:
    """What `gap_at_rest` returns, for a shape at an age of its motion and a ball's own velocity; None past its ends."""
    # Twice as far as impacts are found, or one that is found just there would be lost to rounding, and found for ever.
    return gap_past_ends(shape, time, x, y, radius, vx, vy, 2.0 * END_SLOP * radius)


def gap_past_ends(
    shape: ShapeRow, time: float, x: float, y: float, radius: float, vx: float, vy: float, slop: float
) -> tuple[float, float, float] | None:
    """The same as far as `slop` past the shape's ends, and None beyond."""
    if not is_moving(shape):
        return gap_at_rest(shape, x, y, radius, vx, vy, slop)
    ux, uy = surface_velocity(shape, float(shape["spin"]), x, y, time)
    turn = -float(shape["spin"]) * time
    c, s = cos(turn), sin(turn)
    fx, fy = into_frame(shape, time, x, y)
    wx, wy = rotated(vx - ux, vy - uy, c, s)
    found = gap_at_rest(shape, fx, fy, radius, wx, wy, slop)
    if found is None:
        return None
    gap, nx, ny = found
    nx, ny = rotated(nx, ny, c, -s)
    return gap, nx, ny


def seen_on_path(
    shape: ShapeRow, motion_age: float, path: Path, radius: float, time: float, depth: float
) -> tuple[bool, bool]:
    """Whether a ball is past the ends of a shape at a time of its path, and whether it is in it by more than a `depth`.

    The path began at an age of the shape's motion; one of less than 0 is how far from it a ball may be.
    """
    x, y = place_on(path, time)
    found = gap_to_shape(shape, motion_age + time, x, y, radius, 0.0, 0.0)
    if found is None:
        return True, False
    gap, _nx, _ny = found
    return False, gap < -depth


def touches_on_path(shape: ShapeRow, motion_age: float, path: Path, radius: float, time: float) -> bool:
    """True if a ball touches a shape at a time of its path."""
    _past, touches = seen_on_path(shape, motion_age, path, radius, time, -SEPARATION_SLACK * radius)
    return touches
