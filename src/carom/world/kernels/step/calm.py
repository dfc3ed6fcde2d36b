"""Kinematic shapes that do nothing in a step but turn, or nothing at all, are left alone while no ball comes near.

What each substep would do to them is made up for when a ball does, or when the step ends, to the same bits.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import INDEX_MARGIN, ROUNDING
from carom.geometry.vector import larger, smaller
from carom.rows.index import IndexRow
from carom.rows.pose import acting_spin, advance, reach_along_axes
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table

#: The sides of a box: left, bottom, right, top.
Box = tuple[float, float, float, float]


def is_calm(shape: ShapeRow, duration: float, count: int) -> bool:
    """True if a kinematic shape only turns in `count` substeps of `duration` seconds, and comes to no stop.

    Or if it rests from the first of them on.
    """
    if shape["time_left"] != 0.0 or shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0:
        return False
    spin = acting_spin(shape)
    if spin == 0.0 or not shape["turn_limited"]:
        return True
    orientation, turn = float(shape["orientation"]), spin * duration
    # Turns are added one by one, and every sum is rounded.
    end = orientation + turn * count
    slack = ROUNDING * count * (fabs(orientation) + fabs(end))
    low, high = min(orientation + turn, end - slack), max(orientation + turn, end + slack)
    return bool(shape["turn_low"] < low and high < shape["turn_high"])


def leave_alone(
    state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow, around: Box, duration: float
) -> int:
    """How many of the shapes that do not rest, the last ones listed, are left alone in this substep of `duration` s.

    `around` is a box with all in it that the balls come near to, and `entry` that of the kinematic shapes' index.
    """
    if state["substep"] == 0:
        entry["owed"] = 0
        keep_off(state, shapes, order, entry, around, duration)
    calm = int(entry["calm"])
    if calm == 0:
        return 0
    left, bottom, right, top = around
    if (
        left > entry["calm_left"]
        and bottom > entry["calm_bottom"]
        and right < entry["calm_right"]
        and top < entry["calm_top"]
    ):
        entry["owed"] += 1
        return calm
    end = int(state["shapes"] + state["movers"])
    for k in range(end - calm, end):
        pay_turns(shapes[order[k]], duration, int(entry["owed"]))
    entry["calm"] = 0
    return 0


def keep_off(
    state: StateRow, shapes: Table[ShapeRow], order: Table[int], entry: IndexRow, around: Box, duration: float
) -> None:
    """Let those rest that are calm and do not turn, and note the box that balls must stay in for the others' sake.

    That is `around` and as far around it as the nearest of them is; a box with nothing in it where one is near.
    """
    left, bottom, right, top = around
    apart = inf
    end = int(state["shapes"] + state["movers"])
    for k in range(end - int(entry["calm"]), end):
        shape = shapes[order[k]]
        if acting_spin(shape) == 0.0:
            advance(shape, duration)
            continue
        x, y = float(shape["pivot_x"]), float(shape["pivot_y"])
        dx, dy = reach_along_axes(shape)
        reach = (dx + dy) * INDEX_MARGIN
        across = larger(left - (x + reach), (x - reach) - right)
        along = larger(bottom - (y + reach), (y - reach) - top)
        apart = smaller(apart, larger(across, along))
    # A little less, for what is rounded.
    apart -= 4.0 * ROUNDING * (fabs(left) + fabs(bottom) + fabs(right) + fabs(top) + apart) if apart < inf else 0.0
    apart = apart if apart > 0.0 else -inf
    entry["calm_left"] = left - apart
    entry["calm_bottom"] = bottom - apart
    entry["calm_right"] = right + apart
    entry["calm_top"] = top + apart


def pay_turns(shape: ShapeRow, duration: float, count: int) -> None:
    """Turn a calm shape for so many substeps of `duration` seconds; ends and box stay where they were."""
    spin = acting_spin(shape)
    if spin != 0.0:
        orientation, turn = float(shape["orientation"]), spin * duration
        for _ in range(count):
            orientation += turn
        shape["orientation"] = orientation
