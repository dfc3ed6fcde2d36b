"""Shapes as a ball in flight meets them: where they are at a time of the span, when it touches them, and where."""

from __future__ import annotations

from math import cos, fabs, sin, sqrt

from carom.constants import END_SLOP
from carom.geometry.advance import advance_arc, advance_circle, advance_point, advance_segment
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.reach import in_wide_sector
from carom.geometry.vector import dot, length, rotated
from carom.rows.shape import ARC, CIRCLE, KINEMATIC, POINT, ShapeRow


def is_moving(shape: ShapeRow) -> bool:
    """True if the shape moves in this span."""
    if shape["motion"] != KINEMATIC:
        return False
    return bool(shape["spin"] != 0.0 or shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0)


def span_box(shape: ShapeRow, span: float) -> tuple[float, float, float, float]:
    """A box around a moving shape that it does not leave during the span."""
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    left, bottom = float(shape["left"]), float(shape["bottom"])
    right, top = float(shape["right"]), float(shape["top"])
    shift_x, shift_y = float(shape["velocity_x"]) * span, float(shape["velocity_y"]) * span
    if shape["spin"] != 0.0:
        reach = length(max(px - left, right - px), max(py - bottom, top - py))
        # Turning by an angle moves nothing farther than by that angle times its distance from the pivot.
        way = min(fabs(float(shape["spin"])) * span, 3.0) * reach
        left, right = max(left - way, px - reach), min(right + way, px + reach)
        bottom, top = max(bottom - way, py - reach), min(top + way, py + reach)
    return left + min(shift_x, 0.0), bottom + min(shift_y, 0.0), right + max(shift_x, 0.0), top + max(shift_y, 0.0)


def into_frame(shape: ShapeRow, time: float, x: float, y: float) -> tuple[float, float]:
    """The place (x, y) at a time of the span, relative to the shape as it stands at the span's beginning."""
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


def impact_at_rest(
    shape: ShapeRow, x: float, y: float, radius: float, vx: float, vy: float, ax: float, ay: float, duration: float
) -> float | None:
    """When a ball first touches a shape that does not move, within `duration`, or None."""
    kind = shape["kind"]
    cx, cy = float(shape["cx"]), float(shape["cy"])
    if kind == POINT:
        return impact_point(cx, cy, x, y, radius, vx, vy, ax, ay, duration)
    r = float(shape["radius"])
    if kind == CIRCLE:
        return impact_circle(cx, cy, r, int(shape["solid"]), x, y, radius, vx, vy, ax, ay, duration)
    x0, y0 = float(shape["ax"]), float(shape["ay"])
    slop = END_SLOP * radius
    if kind == ARC:
        x1, y1 = float(shape["bx"]), float(shape["by"])
        return impact_arc(cx, cy, r, x0, y0, x1, y1, x, y, radius, vx, vy, ax, ay, duration, slop)
    tx, ty = float(shape["tx"]), float(shape["ty"])
    return impact_segment(x0, y0, tx, ty, float(shape["length"]), x, y, radius, vx, vy, ax, ay, duration, slop)


def impact_in_motion(
    shape: ShapeRow,
    time: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    duration: float,
    sign: float,
) -> float | None:
    """When, from a time of the span on, a ball first touches a shape that moves, within `duration`, or None.

    `sign` is 1, or -1 for a motion that runs backwards, the ball's velocity being given as it is then.
    """
    turn = -float(shape["spin"]) * time
    c, s = cos(turn), sin(turn)
    x, y = into_frame(shape, time, x, y)
    vx, vy = rotated(vx, vy, c, s)
    ax, ay = rotated(ax, ay, c, s)
    ux, uy = rotated(sign * float(shape["velocity_x"]), sign * float(shape["velocity_y"]), c, s)
    spin = sign * float(shape["spin"])
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    kind = shape["kind"]
    if kind == POINT:
        return advance_point(cx, cy, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration)
    if kind == CIRCLE:
        solid = int(shape["solid"])
        return advance_circle(cx, cy, r, solid, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration)
    x0, y0 = float(shape["ax"]), float(shape["ay"])
    slop = END_SLOP * radius
    if kind == ARC:
        x1, y1 = float(shape["bx"]), float(shape["by"])
        return advance_arc(
            cx, cy, r, x0, y0, x1, y1, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration, slop
        )
    tx, ty, extent = float(shape["tx"]), float(shape["ty"]), float(shape["length"])
    return advance_segment(x0, y0, tx, ty, extent, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration, slop)


def gap_at_rest(
    shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float, slop: float
) -> tuple[float, float, float] | None:
    """The gap between a ball and a shape and the unit normal from the shape, as (gap, nx, ny); negative if it overlaps.

    None beyond the shape's ends by more than `slop`. (wx, wy), the ball's velocity relative to the shape, decides the
    normal where the centre lies on the shape.
    """
    kind = shape["kind"]
    cx, cy = float(shape["cx"]), float(shape["cy"])
    if kind == POINT or kind == CIRCLE or kind == ARC:
        dx, dy, r = x - cx, y - cy, float(shape["radius"])
        if kind == ARC:
            x0, y0, x1, y1 = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
            if not in_wide_sector(x0 - cx, y0 - cy, x1 - cx, y1 - cy, dx, dy, slop * r):
                return None
        away = length(dx, dy)
        if away == 0.0:
            nx, ny = against(wx, wy)
            return (r if kind == ARC or (kind == CIRCLE and shape["solid"] == 0) else -r) - radius, nx, ny
        hollow = kind == ARC or (kind == CIRCLE and shape["solid"] == 0)
        inward = hollow and (away < r or (away == r and dot(dx, dy, wx, wy) > 0.0))
        if inward:
            return r - away - radius, -dx / away, -dy / away
        return away - r - radius, dx / away, dy / away
    tx, ty = float(shape["tx"]), float(shape["ty"])
    dx, dy = x - float(shape["ax"]), y - float(shape["ay"])
    along = dot(dx, dy, tx, ty)
    if along < -slop or along > float(shape["length"]) + slop:
        return None
    side = tx * dy - ty * dx
    if side < 0.0 or (side == 0.0 and tx * wy - ty * wx > 0.0):
        return -side - radius, ty, -tx
    return side - radius, -ty, tx


def against(wx: float, wy: float) -> tuple[float, float]:
    """The unit vector against a velocity, or (0, 1) where there is none."""
    speed = sqrt(wx * wx + wy * wy)
    if speed == 0.0:
        return 0.0, 1.0
    return -wx / speed, -wy / speed


def gap_to_shape(
    shape: ShapeRow, time: float, x: float, y: float, radius: float, vx: float, vy: float
) -> tuple[float, float, float] | None:
    """What `gap_at_rest` returns, for a shape at a time of the span and a ball's own velocity; None past its ends."""
    # Twice as far as impacts are found, or one that is found just there would be lost to rounding, and found for ever.
    slop = 2.0 * END_SLOP * radius
    if not is_moving(shape):
        return gap_at_rest(shape, x, y, radius, vx, vy, slop)
    ux, uy = velocity_of_surface(shape, time, x, y)
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


def velocity_of_surface(shape: ShapeRow, time: float, x: float, y: float) -> tuple[float, float]:
    """The velocity of a shape's surface at (x, y) at a time of the span."""
    if not is_moving(shape):
        return 0.0, 0.0
    ux, uy, spin = float(shape["velocity_x"]), float(shape["velocity_y"]), float(shape["spin"])
    dx = x - (float(shape["pivot_x"]) + ux * time)
    dy = y - (float(shape["pivot_y"]) + uy * time)
    return ux - spin * dy, uy + spin * dx
