"""What may be set on a shape's row about its motion: each function checks, then writes, or raises `InvalidArgument`."""

from __future__ import annotations

from math import cos, isfinite, sin
from typing import Any, cast

from carom.checks import flag, number, one_of, pair, refuse
from carom.errors import InvalidArgument
from carom.geometry.vector import rotated
from carom.rows.shape import DYNAMIC, KINEMATIC, SHAPE, STATIC, Motion, ShapeRow
from carom.shapes.table import word_of
from carom.typing import Vector

#: Where a row has how its shape moves, as words of 64 bits.
ANGULAR_VELOCITY, VELOCITY_X, VELOCITY_Y, TIME_LEFT = (
    word_of(SHAPE, field) for field in ("angular_velocity", "velocity_x", "velocity_y", "time_left")
)

#: The byte of a row that says how the shape moves.
MOTION = int(cast("dict[str, tuple[object, int]]", SHAPE.fields)["motion"][1])

_MOTIONS = {"static": STATIC, "kinematic": KINEMATIC}


def motion_value(value: Any) -> int:
    """STATIC or KINEMATIC, from a string or a `Motion`; only balls are dynamic."""
    if isinstance(value, Motion):
        if value == DYNAMIC:
            raise refuse("motion", "must be 'static' or 'kinematic' for a shape that is no ball", value)
        return int(value)
    return _MOTIONS[one_of("motion", value, tuple(_MOTIONS))]


def halt(row: ShapeRow) -> None:
    """Let the row rest where it is, if `move_to` has sent it somewhere."""
    if row["time_left"] > 0.0:
        row["time_left"] = row["velocity_x"] = row["velocity_y"] = row["angular_velocity"] = 0.0


def target_pivot(row: ShapeRow, x: float, y: float, orientation: float) -> Vector:
    """Where the row's pivot is to be so that its position is (x, y), turned to `orientation`."""
    dx = float(row["initial_cx"]) - float(row["hinge_x"])
    dy = float(row["initial_cy"]) - float(row["hinge_y"])
    if orientation != 0.0:
        dx, dy = rotated(dx, dy, cos(orientation), sin(orientation))
    return x - dx, y - dy


def target_orientation(row: ShapeRow, value: Any) -> float:
    """The orientation that `value` asks for, or that the row has for None; raises where it cannot turn there."""
    if value is None:
        return float(row["orientation"])
    orientation = number("orientation", value)
    low, high = float(row["turn_low"]), float(row["turn_high"])
    if row["turn_limited"] and not low <= orientation <= high:
        raise refuse("orientation", f"must be within turn_limits={(low, high)}", value)
    if not row["rotating"] and orientation != row["orientation"]:
        raise refuse("orientation", "must be None while rotating is False", value)
    return orientation


def send(row: ShapeRow, pivot: Vector, orientation: float, dt: float) -> None:
    """Set the row's speeds so that it has this pivot and orientation after `dt` seconds; raises where they overflow."""
    halt(row)
    row["target_pivot_x"], row["target_pivot_y"] = x, y = pivot
    row["target_orientation"] = orientation
    row["time_left"] = dt
    row["velocity_x"], row["velocity_y"] = (x - float(row["pivot_x"])) / dt, (y - float(row["pivot_y"])) / dt
    row["angular_velocity"] = (orientation - float(row["orientation"])) / dt
    if not all(map(isfinite, (row["velocity_x"], row["velocity_y"], row["angular_velocity"]))):
        raise refuse("dt", "must be long enough for finite speeds", dt)


def write_motion(row: ShapeRow, value: Any) -> None:
    """Make the row static or kinematic. A row that still moves, or has stops, cannot become static."""
    motion = motion_value(value)
    if motion == STATIC:
        moving = row["angular_velocity"] != 0.0 or row["velocity_x"] != 0.0 or row["velocity_y"] != 0.0
        moving = moving or row["time_left"] > 0.0
        if moving or row["turn_limited"]:
            needs = "must stay 'kinematic' while angular_velocity, velocity or turn_limits is set"
            raise refuse("motion", needs, value)
    row["motion"] = motion


def write_angular_velocity(row: ShapeRow, value: Any) -> None:
    """Set how fast the row turns, in rad/s."""
    angular_velocity = number("angular_velocity", value)
    if angular_velocity != 0.0:
        _need_kinematic(row, "angular_velocity", value)
    halt(row)
    row["angular_velocity"] = angular_velocity


def write_rotating(row: ShapeRow, value: Any) -> None:
    """Set whether the row's angular velocity acts."""
    rotating = flag("rotating", value)
    halt(row)
    row["rotating"] = rotating


def write_velocity(row: ShapeRow, value: Any) -> None:
    """Set how fast the row's pivot, and the shape with it, move."""
    x, y = pair("velocity", value)
    if x != 0.0 or y != 0.0:
        _need_kinematic(row, "velocity", value)
    halt(row)
    row["velocity_x"], row["velocity_y"] = x, y


def write_turn_limits(row: ShapeRow, value: Any) -> None:
    """Set the stops `(low, high)` of the row's orientation, or take them away with None.

    They must hold 0, the initial orientation to which `reset` goes back, and the orientation as it is.
    """
    if value is None:
        halt(row)
        row["turn_limited"], row["turn_low"], row["turn_high"] = False, 0.0, 0.0
        return
    low, high = pair("turn_limits", value)
    orientation = float(row["orientation"])
    if not low <= min(0.0, orientation) or not max(0.0, orientation) <= high:
        held = "0" if orientation == 0.0 else f"0 and the orientation {orientation!r}"
        raise refuse("turn_limits", f"must be (low, high) with {held} between them", value)
    _need_kinematic(row, "turn_limits", value)
    halt(row)
    row["turn_limited"], row["turn_low"], row["turn_high"] = True, low, high


def _need_kinematic(row: ShapeRow, name: str, value: Any) -> None:
    """Raise where the row is static, for there the setting would silently do nothing."""
    if row["motion"] != KINEMATIC:
        raise not_kinematic(name, value)


def not_kinematic(name: str, value: Any) -> InvalidArgument:
    """The error to raise where it is not."""
    return refuse(name, "must not be set unless motion is 'kinematic'", value)
