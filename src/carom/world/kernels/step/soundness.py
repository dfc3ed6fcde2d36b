"""What balls and shapes must be for a step to be made: where numbers reach, and what they may be."""

from __future__ import annotations

from carom.rows.ball import OF_WORLD, BallRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.step.motion import unsoundness


def is_finite(value: float) -> bool:
    """True unless the value is infinite or NaN."""
    # Infinity minus itself is NaN, and NaN equals nothing.
    return value - value == 0.0


def is_sound(ball: BallRow) -> bool:
    """True if a ball's place and velocity are finite."""
    return unsoundness(float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])) == 0.0


def balls_are_sound(state: StateRow, balls: Table[BallRow]) -> bool:
    """True if the places and velocities of all balls are finite."""
    lost = 0.0
    for i in range(state["balls"]):
        ball = balls[i]
        lost += unsoundness(float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"]))
    return lost == 0.0


def is_measured(ball: BallRow) -> bool:
    """True if a ball's radius, mass, elasticity and friction are finite."""
    size = is_finite(float(ball["radius"])) and is_finite(float(ball["mass"]))
    return size and is_finite(float(ball["elasticity"])) and is_finite(float(ball["friction"]))


def is_good(ball: BallRow) -> bool:
    """True if a ball is sound, and its radius, mass, elasticity and friction are finite and what they may be."""
    radius, mass = float(ball["radius"]), float(ball["mass"])
    elasticity, friction = float(ball["elasticity"]), float(ball["friction"])
    fit = radius > 0.0 and mass > 0.0 and elasticity >= 0.0 and (friction == OF_WORLD or friction >= 0.0)
    # Zero times what is not finite is NaN, so this is zero if all are finite; two products are there sooner than one.
    motion = 0.0 * float(ball["x"]) * float(ball["y"]) * float(ball["vx"]) * float(ball["vy"])
    measures = 0.0 * radius * mass * elasticity * friction
    return fit and motion + measures == 0.0


def is_in_reach(shape: ShapeRow) -> bool:
    """True if a shape is where numbers reach."""
    left, bottom = float(shape["left"]), float(shape["bottom"])
    return unsoundness(left, bottom, float(shape["right"]), float(shape["top"])) == 0.0


def shapes_are_sound(shapes: Table[ShapeRow], order: Table[int], begin: int, end: int) -> bool:
    """True if the shapes `order[begin:end]` are where numbers reach."""
    sound = True
    for k in range(begin, end):
        sound = sound and is_in_reach(shapes[order[k]])
    return sound
