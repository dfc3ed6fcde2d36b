"""What may be set on a shape's row about its motion: each function checks, then writes, or raises `InvalidArgument`."""

from __future__ import annotations

from typing import Any

from carom.checks import flag, number, one_of, pair, refuse
from carom.rows import DYNAMIC, KINEMATIC, STATIC, Motion, Row

_MOTIONS = {"static": STATIC, "kinematic": KINEMATIC}


def motion_value(value: Any) -> int:
    """STATIC or KINEMATIC, from a string or a `Motion`; only balls are dynamic."""
    if isinstance(value, Motion):
        if value == DYNAMIC:
            raise refuse("motion", "must be 'static' or 'kinematic' for a shape that is no ball", value)
        return int(value)
    return _MOTIONS[one_of("motion", value, tuple(_MOTIONS))]


def write_motion(row: Row, value: Any) -> None:
    """Nothing; makes the row static or kinematic. A row that still moves, or has stops, cannot become static."""
    motion = motion_value(value)
    if motion == STATIC:
        moving = row["angular_velocity"] != 0.0 or row["velocity_x"] != 0.0 or row["velocity_y"] != 0.0
        if moving or row["turn_limited"]:
            needs = "must stay 'kinematic' while angular_velocity, velocity or turn_limits is set"
            raise refuse("motion", needs, value)
    row["motion"] = motion


def write_angular_velocity(row: Row, value: Any) -> None:
    """Nothing; sets how fast the row turns, in rad/s."""
    angular_velocity = number("angular_velocity", value)
    if angular_velocity != 0.0:
        _need_kinematic(row, "angular_velocity", value)
    row["angular_velocity"] = angular_velocity


def write_rotating(row: Row, value: Any) -> None:
    """Nothing; sets whether the row's angular velocity acts."""
    row["rotating"] = flag("rotating", value)


def write_velocity(row: Row, value: Any) -> None:
    """Nothing; sets how fast the row's pivot, and the shape with it, moves."""
    x, y = pair("velocity", value)
    if x != 0.0 or y != 0.0:
        _need_kinematic(row, "velocity", value)
    row["velocity_x"], row["velocity_y"] = x, y


def write_turn_limits(row: Row, value: Any) -> None:
    """Nothing; sets the stops `(low, high)` of the row's orientation, or takes them away with None.

    They must hold 0, the initial orientation to which `reset` goes back, and the orientation as it is.
    """
    if value is None:
        row["turn_limited"], row["turn_low"], row["turn_high"] = False, 0.0, 0.0
        return
    low, high = pair("turn_limits", value)
    orientation = float(row["orientation"])
    if not low <= min(0.0, orientation) or not max(0.0, orientation) <= high:
        held = "0" if orientation == 0.0 else f"0 and the orientation {orientation!r}"
        raise refuse("turn_limits", f"must be (low, high) with {held} between them", value)
    _need_kinematic(row, "turn_limits", value)
    row["turn_limited"], row["turn_low"], row["turn_high"] = True, low, high


def _need_kinematic(row: Row, name: str, value: Any) -> None:
    """Nothing; raises where the row is static, for there the setting would silently do nothing."""
    if row["motion"] != KINEMATIC:
        raise refuse(name, "must not be set unless motion is 'kinematic'", value)
