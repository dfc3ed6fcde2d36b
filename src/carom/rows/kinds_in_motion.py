"""Which function answers which question for which kind of shape: when a ball in flight, or a ray, first touches one."""

from __future__ import annotations

from math import fabs

from carom.constants import END_SLOP, RAY_SLOP
from carom.geometry.advance import advance_arc, advance_circle, advance_point, advance_segment
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.ray import ray_arc, ray_circle, ray_disc, ray_point, ray_segment
from carom.rows.kinds import is_straight, lets_pass
from carom.rows.shape import ARC, CIRCLE, POINT, ShapeRow


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
    if is_straight(kind):
        tx, ty = float(shape["tx"]), float(shape["ty"])
        return impact_segment(x0, y0, tx, ty, float(shape["length"]), x, y, radius, vx, vy, ax, ay, duration, slop)
    if kind == ARC:
        x1, y1 = float(shape["bx"]), float(shape["by"])
        return impact_arc(cx, cy, r, x0, y0, x1, y1, x, y, radius, vx, vy, ax, ay, duration, slop)
    return None


def impact_in_frame(
    shape: ShapeRow,
    ux: float,
    uy: float,
    spin: float,
    x: float,
    y: float,
    radius: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    duration: float,
) -> float | None:
    """When a ball first touches a shape that travels with u and turns by `spin` about its pivot, or None.

    All as seen where the shape stands in its row, which is where it is at first; within `duration`.
    """
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
    if is_straight(kind):
        tx, ty, extent = float(shape["tx"]), float(shape["ty"]), float(shape["length"])
        return advance_segment(
            x0, y0, tx, ty, extent, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration, slop
        )
    if kind == ARC:
        x1, y1 = float(shape["bx"]), float(shape["by"])
        return advance_arc(
            cx, cy, r, x0, y0, x1, y1, px, py, ux, uy, spin, x, y, radius, vx, vy, ax, ay, duration, slop
        )
    return None


def ray_shape(
    shape: ShapeRow, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch of a ray or a moved circle with a shape, `(fraction, px, py, nx, ny)`; None where there is none.

    A gate is not touched from the side where it opens.
    """
    kind = shape["kind"]
    cx, cy, r = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    if kind == POINT:
        return ray_point(cx, cy, x, y, radius, dx, dy)
    if kind == CIRCLE:
        if shape["solid"] != 0:
            return ray_disc(cx, cy, r, x, y, radius, dx, dy)
        return ray_circle(cx, cy, r, 0, x, y, radius, dx, dy)
    ax, ay, bx, by = float(shape["ax"]), float(shape["ay"]), float(shape["bx"]), float(shape["by"])
    slop = joint_slop(ax, ay, x, y, radius, dx, dy)
    if is_straight(kind):
        if lets_pass(shape, x, y):
            return None
        tx, ty, extent = float(shape["tx"]), float(shape["ty"]), float(shape["length"])
        return ray_segment(ax - slop * tx, ay - slop * ty, tx, ty, extent + 2.0 * slop, x, y, radius, dx, dy)
    if kind == ARC:
        return ray_arc(cx, cy, r, ax, ay, bx, by, x, y, radius, dx, dy, slop)
    return None


def joint_slop(ax: float, ay: float, x: float, y: float, radius: float, dx: float, dy: float) -> float:
    """How far past its ends a segment or arc from a is met, so that rounding leaves no gap at a joint with another.

    For a circle it is what a ball has in a step, for a ray what rounding amounts to.
    """
    return END_SLOP * radius + RAY_SLOP * (fabs(x - ax) + fabs(y - ay) + fabs(dx) + fabs(dy))
