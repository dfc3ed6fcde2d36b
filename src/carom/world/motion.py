"""How balls and kinematic shapes move in one substep (1.8)."""

from __future__ import annotations

from math import sqrt

from carom.rows import KINEMATIC, Row, Rows
from carom.shapes.pose import advance_pose


def move_ball(ball: Row, duration: float, gravity_x: float, gravity_y: float) -> None:
    """Move a ball along the exact parabola of constant gravity for `duration` seconds."""
    half = 0.5 * duration * duration
    ball["x"] += ball["vx"] * duration + gravity_x * half
    ball["y"] += ball["vy"] * duration + gravity_y * half
    ball["vx"] += gravity_x * duration
    ball["vy"] += gravity_y * duration


def move_shapes(state: Row, balls: Rows, shapes: Rows, order: Rows, duration: float) -> bool:
    """Move the kinematic shapes for `duration` seconds and wake the balls in their way; True if any shape moved.

    A shape's way is the box around its box before and after.
    """
    moved = False
    for k in range(state["fixed"], state["shapes"]):
        shape = shapes[order[k]]
        left = shape["left"]
        bottom = shape["bottom"]
        right = shape["right"]
        top = shape["top"]
        if shape["motion"] == KINEMATIC and advance_pose(shape, duration):
            moved = True
            if state["sleeping"] > 0:
                left = min(left, shape["left"])
                bottom = min(bottom, shape["bottom"])
                right = max(right, shape["right"])
                top = max(top, shape["top"])
                wake_in_box(state, balls, left, bottom, right, top)
    return moved


def wake(state: Row, ball: Row) -> None:
    """Wake a ball that sleeps; a waking ball starts counting its rest anew."""
    if ball["asleep"] != 0:
        ball["asleep"] = 0
        ball["still_time"] = 0.0
        state["sleeping"] -= 1


def wake_in_box(state: Row, balls: Rows, left: float, bottom: float, right: float, top: float) -> None:
    """Wake the sleeping balls whose boxes meet the box."""
    for i in range(state["balls"]):
        ball = balls[i]
        if ball["asleep"] != 0:
            x = ball["x"]
            y = ball["y"]
            radius = ball["radius"]
            if left <= x + radius and x - radius <= right and bottom <= y + radius and y - radius <= top:
                wake(state, ball)


def wake_all(state: Row, balls: Rows) -> None:
    """Wake every sleeping ball."""
    for i in range(state["balls"]):
        wake(state, balls[i])


def slow_by_friction(ball: Row, loss: float) -> None:
    """Take `loss` from a ball's speed, at most all of it."""
    vx = ball["vx"]
    vy = ball["vy"]
    speed_squared = vx * vx + vy * vy
    if speed_squared <= loss * loss:
        ball["vx"] = 0.0
        ball["vy"] = 0.0
    else:
        kept = 1.0 - loss / sqrt(speed_squared)
        ball["vx"] = vx * kept
        ball["vy"] = vy * kept
