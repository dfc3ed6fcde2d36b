"""The contact of a ball with a shape, and that of two balls, as their rows stand."""

from __future__ import annotations

from carom.geometry.overlap import overlap_ball
from carom.geometry.vector import length
from carom.rows.ball import BallRow
from carom.rows.kinds import detect_contact
from carom.rows.masks import may_collide
from carom.rows.pose import acting_spin, surface_velocity
from carom.rows.shape import ShapeRow


def contact_with_shape(shape: ShapeRow, ball: BallRow) -> tuple[float, float, float, float, float, float] | None:
    """Point, unit normal from the shape, setback and speed `(px, py, nx, ny, setback, speed)`; a miss is None.

    Masks and switches hold. A gate yields a contact only where the ball's centre is on its closed side and the ball
    approaches. The speed is that of the ball relative to the surface at the point.
    """
    if not may_collide(shape, ball):
        return None
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    spin = acting_spin(shape)
    # At the ball's centre: this serves only as a direction where centres coincide, and along the normal of a gate,
    # where it is the same at the centre as at the point of contact.
    ux, uy = surface_velocity(shape, spin, x, y, 0.0)
    found = detect_contact(shape, x, y, float(ball["radius"]), vx - ux, vy - uy)
    if found is None:
        return None
    px, py, nx, ny, setback = found
    ux, uy = surface_velocity(shape, spin, px, py, 0.0)
    return px, py, nx, ny, setback, length(vx - ux, vy - uy)


def contact_of_balls(first: BallRow, second: BallRow) -> tuple[float, float, float, float, float, float] | None:
    """The same for two balls, with the normal from the first to the second; a miss is None."""
    if not may_collide(first, second):
        return None
    wx, wy = float(second["vx"]) - float(first["vx"]), float(second["vy"]) - float(first["vy"])
    x, y, radius = float(first["x"]), float(first["y"]), float(first["radius"])
    found = overlap_ball(x, y, radius, float(second["x"]), float(second["y"]), float(second["radius"]), wx, wy)
    if found is None:
        return None
    px, py, nx, ny, setback = found
    return px, py, nx, ny, setback, length(wx, wy)
