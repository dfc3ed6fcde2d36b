"""How things move as long as nothing meets them: the path of a ball's centre, and a shape that travels and turns."""

from typing import NamedTuple

from carom.constants import LEAST_SQUARE


class Path(NamedTuple):
    """A parabola: t seconds from now a ball's centre is at p + v·t + g·t²/2.

    p = (x, y) is where it is now, v its velocity and g its acceleration, both per second. A ray is a path without
    acceleration on which t runs from 0 to 1.
    """

    x: float
    y: float
    vx: float
    vy: float
    gx: float
    gy: float


class Turning(NamedTuple):
    """The motion of a shape: t seconds from now what is at q now is at o + u·t + R(ωt)·(q - o).

    o is the pivot now, u its velocity, ω the `spin` in rad/s, and R(α) turns counterclockwise by the angle α.
    """

    pivot_x: float
    pivot_y: float
    pivot_vx: float
    pivot_vy: float
    spin: float


def is_straight(path: Path) -> bool:
    """Whether the path has no acceleration, or so little that its square is lost to underflow."""
    return path.gx * path.gx + path.gy * path.gy < LEAST_SQUARE


def place_on(path: Path, time: float) -> tuple[float, float]:
    """Where the ball's centre is at a time."""
    x, y, vx, vy, gx, gy = path
    return x + (vx + 0.5 * gx * time) * time, y + (vy + 0.5 * gy * time) * time


def path_after(path: Path, time: float) -> Path:
    """The path as it goes on from a time, which is 0 then."""
    x, y = place_on(path, time)
    return Path(x, y, path.vx + path.gx * time, path.vy + path.gy * time, path.gx, path.gy)


def path_from(path: Path, x: float, y: float) -> Path:
    """The path as seen from the place (x, y), which is the origin then."""
    return Path(path.x - x, path.y - y, path.vx, path.vy, path.gx, path.gy)


def path_beside(path: Path, turning: Turning) -> Path:
    """The path as seen by one who travels with a shape's pivot and does not turn, from where the shape is now."""
    x, y, vx, vy, gx, gy = path
    return Path(x, y, vx - turning.pivot_vx, vy - turning.pivot_vy, gx, gy)
