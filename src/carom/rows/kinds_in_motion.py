"""Which function answers which question for which kind of shape: when a ball in flight, or a ray, first touches one."""

from __future__ import annotations

from math import fabs

from carom.constants import END_SLOP, RAY_SLOP
from carom.geometry.advance import advance_arc, advance_circle, advance_point, advance_segment
from carom.geometry.figures import SegmentGeometry
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.path import Path, Turning
from carom.geometry.ray import ray_arc, ray_circle, ray_disc, ray_point, ray_segment
from carom.rows.kinds import arc_of, circle_of, is_straight, lets_pass, segment_of
from carom.rows.shape import ARC, CIRCLE, POINT, ShapeRow


def impact_at_rest(shape: ShapeRow, path: Path, radius: float, duration: float) -> float | None:
    """When a ball first touches a shape that does not move, within `duration`, or None."""
    kind = shape["kind"]
    if kind == POINT:
        return impact_point(float(shape["cx"]), float(shape["cy"]), path, radius, duration)
    if kind == CIRCLE:
        return impact_circle(circle_of(shape), path, radius, duration)
    slop = END_SLOP * radius
    if is_straight(kind):
        return impact_segment(segment_of(shape), path, radius, duration, slop)
    if kind == ARC:
        return impact_arc(arc_of(shape), path, radius, duration, slop)
    return None


def impact_in_frame(shape: ShapeRow, turning: Turning, path: Path, radius: float, duration: float) -> float | None:
    """When a ball first touches a shape that travels, and turns about its pivot, or None.

    All as seen where the shape stands in its row, which is where it is at first; within `duration`.
    """
    kind = shape["kind"]
    if kind == POINT:
        return advance_point(float(shape["cx"]), float(shape["cy"]), turning, path, radius, duration)
    if kind == CIRCLE:
        return advance_circle(circle_of(shape), turning, path, radius, duration)
    slop = END_SLOP * radius
    if is_straight(kind):
        return advance_segment(segment_of(shape), turning, path, radius, duration, slop)
    if kind == ARC:
        return advance_arc(arc_of(shape), turning, path, radius, duration, slop)
    return None


def ray_shape(
    shape: ShapeRow, x: float, y: float, radius: float, dx: float, dy: float
) -> tuple[float, float, float, float, float] | None:
    """The first touch of a ray or a moved circle with a shape, `(fraction, px, py, nx, ny)`; None where there is none.

    A gate is not touched from the side where it opens.
    """
    kind = shape["kind"]
    if kind == POINT:
        return ray_point(float(shape["cx"]), float(shape["cy"]), x, y, radius, dx, dy)
    if kind == CIRCLE:
        if shape["solid"] != 0:
            return ray_disc(circle_of(shape), x, y, radius, dx, dy)
        return ray_circle(circle_of(shape), x, y, radius, dx, dy)
    slop = joint_slop(float(shape["ax"]), float(shape["ay"]), x, y, radius, dx, dy)
    if is_straight(kind):
        if lets_pass(shape, x, y):
            return None
        ax, ay, tx, ty, extent = segment_of(shape)
        longer = SegmentGeometry(ax - slop * tx, ay - slop * ty, tx, ty, extent + 2.0 * slop)
        return ray_segment(longer, x, y, radius, dx, dy)
    if kind == ARC:
        return ray_arc(arc_of(shape), x, y, radius, dx, dy, slop)
    return None


def joint_slop(ax: float, ay: float, x: float, y: float, radius: float, dx: float, dy: float) -> float:
    """How far past its ends a segment or arc from a is met, so that rounding leaves no gap at a joint with another.

    For a circle it is what a ball has in a step, for a ray what rounding amounts to.
    """
    return END_SLOP * radius + RAY_SLOP * (fabs(x - ax) + fabs(y - ay) + fabs(dx) + fabs(dy))
