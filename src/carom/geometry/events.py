"""When a ball in flight leaves a box, slows down, or stops: what happens to it without meeting anything.

As times of impact, these depend on the path alone. Each is the first time, from 0 on, or None if it never comes.
"""

from __future__ import annotations

from math import inf, sqrt

from carom.geometry.path import Path
from carom.geometry.roots import falling_time, time_within
from carom.geometry.vector import cross, dot, length, smaller, unit


def leaving_time(path: Path, radius: float, left: float, bottom: float, right: float, top: float) -> float | None:
    """When the box of a ball leaves a box wholly, so that they do not even touch any more from then on; 0 if it has.

    Sides of the box may be infinite. None where the ball's box only comes to its edge and turns.
    """
    x, y, vx, vy, gx, gy = path
    # How far it is from having left to the right, the left, the top and the bottom.
    to_right = height_lost(right + radius - x, -vx, -gx)
    to_left = height_lost(x + radius - left, vx, gx)
    to_top = height_lost(top + radius - y, -vy, -gy)
    to_bottom = height_lost(y + radius - bottom, vy, gy)
    return time_within(smaller(smaller(to_right, to_left), smaller(to_top, to_bottom)), inf)


def height_lost(height: float, rate: float, acceleration: float) -> float:
    """When height + rate·t + acceleration·t²/2 gets below zero, 0 if it is there; infinite if it never does."""
    if height < 0.0:
        return 0.0
    if height == 0.0 and (rate < 0.0 or (rate == 0.0 and acceleration < 0.0)):
        return 0.0
    if not height < inf:
        return inf
    time = falling_time(height, rate, acceleration)
    return inf if time is None else 0.0 + time


def slowing_time(path: Path, speed: float) -> float | None:
    """When the ball is as slow as `speed` or slower; 0 if it is so already, None if it never is.

    |v + g·t|² = v² + 2(v·g)·t + g²·t² falls to the square of the speed at the first of the two times
    (-v·g ± √(g²·speed² - (v × g)²))/g², here in the form that loses no digits to a weak pull.
    """
    _, _, vx, vy, gx, gy = path
    pace = length(vx, vy)
    if pace <= speed:
        return 0.0
    slowing, aside = dot(vx, vy, gx, gy), cross(vx, vy, gx, gy)
    root_squared = (gx * gx + gy * gy) * (speed * speed) - aside * aside
    if slowing >= 0.0 or root_squared < 0.0:
        return None
    return time_within((pace - speed) * (pace + speed) / (sqrt(root_squared) - slowing), inf)


def stopping_time(path: Path, deceleration: float) -> float | None:
    """When a ball stops that is slowed against its velocity, on a `braked` path; 0 at rest, None if it never stops."""
    pace = length(path.vx, path.vy)
    if pace == 0.0:
        return 0.0
    if not deceleration > 0.0:
        return None
    return time_within(pace / deceleration, inf)


def braked(path: Path, deceleration: float) -> Path:
    """The path, until it stops, of a ball that is slowed against its velocity by a constant deceleration.

    It is straight. A ball at rest stays, and what else pulls it does not count.
    """
    x, y, vx, vy, _, _ = path
    direction = unit(vx, vy)
    if direction is None:
        return Path(x, y, vx, vy, 0.0, 0.0)
    ux, uy = direction
    return Path(x, y, vx, vy, -deceleration * ux, -deceleration * uy)
