"""How balls and kinematic shapes move in one substep."""

from __future__ import annotations

from math import fabs, inf

from carom.constants import FEW_TO_ASK, INDEX_MARGIN, ROUNDING
from carom.geometry.vector import larger, length, smaller
from carom.rows.ball import BallRow
from carom.rows.index import IndexRow, SlotRow
from carom.rows.pose import (
    STILL,
    UNPOSED,
    advance,
    cosine_and_sine,
    pose_by,
    reach_along_axes,
    rest,
    turn_unposed,
    turns_only,
)
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.step.calm import Box, leave_alone

#: A box that no place is outside of.
EVERYWHERE = (-inf, -inf, inf, inf)

#: An orientation, its cosine and its sine.
Turn = tuple[float, float, float]
UNTURNED = (0.0, 1.0, 0.0)


def moved(ball: BallRow, duration: float, gravity_x: float, gravity_y: float) -> tuple[float, float, float, float]:
    """The place and the velocity, (x, y, vx, vy), of a ball after `duration` seconds of flight."""
    # Exact for constant gravity, so a fall takes no energy, whatever the substep is.
    half = 0.5 * duration * duration
    vx, vy = float(ball["vx"]), float(ball["vy"])
    x = float(ball["x"]) + (vx * duration + gravity_x * half)
    y = float(ball["y"]) + (vy * duration + gravity_y * half)
    return x, y, vx + gravity_x * duration, vy + gravity_y * duration


def put_ball(ball: BallRow, x: float, y: float, vx: float, vy: float) -> None:
    """Give a ball a place and a velocity."""
    ball["x"] = x
    ball["y"] = y
    ball["vx"] = vx
    ball["vy"] = vy


def launch_ball(ball: BallRow, mark: SavedRow, slot: SlotRow, i: int, x: float, y: float, vx: float, vy: float) -> None:
    """Move the ball in row `i` in a substep, and note where that leaves it, shapes aside, and in a slot."""
    radius = float(ball["radius"])
    put_ball(ball, x, y, vx, vy)
    mark["met_x"] = x
    mark["met_y"] = y
    slot["x"] = x
    slot["y"] = y
    slot["radius"] = radius
    slot["ball"] = i


def note_met(mark: SavedRow, ball: BallRow) -> None:
    """Note where a ball is that has met the shapes; what pushes it from there on is other balls."""
    mark["met_x"] = ball["x"]
    mark["met_y"] = ball["y"]


def unsoundness(x: float, y: float, vx: float, vy: float) -> float:
    """0 where a place and a velocity, or the sides of a box, are finite, NaN where they are not."""
    return ((x - x) + (y - y)) + ((vx - vx) + (vy - vy))


def move_shapes(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    entry: IndexRow,
    duration: float,
) -> bool:
    """Move the kinematic shapes for `duration` seconds and wake the balls in their way; True if any shape moved.

    A shape's way is the box around its box before and after, and as far around that as a turning shape bulges. One that
    turns far from all of a few balls is put to where it is when it matters: when a ball is near, or the step ends. One
    that has come in the last substep where `move_to` sent it rests first. `entry` is that of the shapes' index.
    """
    moved = False
    asked = state["sleeping"] == 0 and state["substep"] + 1 < state["substeps"]
    few = asked and state["balls"] <= FEW_TO_ASK
    around = box_of_ways(state, balls, duration) if few or (asked and entry["calm"] > 0) else EVERYWHERE
    left_alone = leave_alone(state, shapes, order, entry, around, duration)
    # Parts of a compound turn alike, but stand among others by their kinds.
    last, second, third = UNTURNED, UNTURNED, UNTURNED
    for k in range(state["shapes"], state["shapes"] + state["movers"] - left_alone):
        shape = shapes[order[k]]
        rest(shape)
        if few and turns_only(shape, duration) and is_far_from_all(state, balls, shape, duration, around):
            turn_unposed(shape, duration)
            continue
        left, bottom = float(shape["left"]), float(shape["bottom"])
        right, top = float(shape["right"]), float(shape["top"])
        how = advance(shape, duration)
        if how == UNPOSED:
            if shape["orientation"] != last[0]:
                second, third, last = last, second, turn_of(float(shape["orientation"]), second, third)
            pose_by(shape, last[1], last[2])
        if how != STILL:
            moved = True
            if shape["time_left"] < 0.0:
                # It was put where it was sent, wherever its region is.
                state["moving_stale"] = STALE
            # Waking is needed only while something sleeps, and then costs a look at every ball.
            if state["sleeping"] > 0:
                bulge = turning_bulge(shape)
                left = smaller(left, float(shape["left"])) - bulge
                bottom = smaller(bottom, float(shape["bottom"])) - bulge
                right = larger(right, float(shape["right"])) + bulge
                top = larger(top, float(shape["top"])) + bulge
                wake_in_box(state, balls, left, bottom, right, top)
    return moved


def turn_of(orientation: float, one: Turn, other: Turn) -> Turn:
    """An orientation with its cosine and sine, which one of two others may have already."""
    if orientation == one[0]:
        return one
    if orientation == other[0]:
        return other
    c, s = cosine_and_sine(orientation)
    return orientation, c, s


def box_of_ways(state: StateRow, balls: Table[BallRow], duration: float) -> Box:
    """A box with all in it that a few balls come near to within a substep of `duration` seconds: see `is_far_from_all`.

    None is outside that box by any rounding.
    """
    pull = length(float(state["gravity_x"]), float(state["gravity_y"])) * duration
    left, bottom, right, top, most = inf, inf, -inf, -inf, 0.0
    for i in range(state["balls"]):
        ball = balls[i]
        x, y = float(ball["x"]), float(ball["y"])
        way = (length(float(ball["vx"]), float(ball["vy"])) + pull) * duration
        most = larger(most, way + 3.0 * float(ball["radius"]))
        left, bottom = smaller(left, x), smaller(bottom, y)
        right, top = larger(right, x), larger(top, y)
    most = most * INDEX_MARGIN + 4.0 * ROUNDING * (fabs(left) + fabs(bottom) + fabs(right) + fabs(top))
    return left - most, bottom - most, right + most, top + most


def is_far_from_all(state: StateRow, balls: Table[BallRow], shape: ShapeRow, duration: float, around: Box) -> bool:
    """True if no ball comes near the circle that a turning shape stays in, within a substep of `duration` seconds.

    Near is what the ball may fly, and three radii: other shapes and balls push it by less. `around` is a box around all
    of that.
    """
    x, y = float(shape["pivot_x"]), float(shape["pivot_y"])
    left, bottom, right, top = around
    # Most shapes are far from that too, which is seen without a root.
    dx, dy = reach_along_axes(shape)
    reach = (dx + dy) * INDEX_MARGIN
    if x + reach < left or x - reach > right or y + reach < bottom or y - reach > top:
        return True
    reach = length(dx, dy) * INDEX_MARGIN
    pull = length(float(state["gravity_x"]), float(state["gravity_y"])) * duration
    for i in range(state["balls"]):
        ball = balls[i]
        way = (length(float(ball["vx"]), float(ball["vy"])) + pull) * duration
        if not length(float(ball["x"]) - x, float(ball["y"]) - y) > reach + way + 3.0 * float(ball["radius"]):
            return False
    return True


def turning_bulge(shape: ShapeRow) -> float:
    """How far a shape that turned in this substep came, at most, from the straight way between where it was and is.

    A point at distance r from the pivot that turns by the angle a stays within r·a²/8 of the straight way, and within
    2r at any angle. The farthest corner of the box stands for the farthest point.
    """
    turn = fabs(float(shape["orientation"]) - float(shape["orientation_before"]))
    if turn == 0.0:
        return 0.0
    x, y = float(shape["pivot_x"]), float(shape["pivot_y"])
    across = larger(fabs(float(shape["left"]) - x), fabs(float(shape["right"]) - x))
    along = larger(fabs(float(shape["bottom"]) - y), fabs(float(shape["top"]) - y))
    # The sagitta of an arc of radius r and angle a is r(1 - cos(a/2)), which is r·a²/8 at most.
    return length(across, along) * smaller(0.125 * turn * turn, 2.0)


def wake(state: StateRow, ball: BallRow) -> None:
    """Wake a ball that sleeps; a waking ball starts counting its rest anew."""
    if ball["asleep"] != 0:
        rouse(state, ball)
        ball["still_time"] = 0.0


def rouse(state: StateRow, ball: BallRow) -> None:
    """Wake a ball that sleeps until the substep's end, where it falls asleep again if it is slow still."""
    if ball["asleep"] != 0:
        ball["asleep"] = 0
        state["sleeping"] -= 1


def wake_in_box(state: StateRow, balls: Table[BallRow], left: float, bottom: float, right: float, top: float) -> None:
    """Wake the sleeping balls whose boxes meet the box."""
    for i in range(state["balls"]):
        ball = balls[i]
        if ball["asleep"] != 0:
            x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
            if left <= x + radius and x - radius <= right and bottom <= y + radius and y - radius <= top:
                wake(state, ball)


def wake_all(state: StateRow, balls: Table[BallRow]) -> None:
    """Wake every sleeping ball."""
    for i in range(state["balls"]):
        wake(state, balls[i])


def slow_by_friction(ball: BallRow, loss: float) -> None:
    """Take `loss` from a ball's speed, at most all of it."""
    vx, vy = float(ball["vx"]), float(ball["vy"])
    speed = length(vx, vy)
    # Sliding friction stops a ball, it never turns it round.
    if speed <= loss:
        ball["vx"] = 0.0
        ball["vy"] = 0.0
    else:
        kept = 1.0 - loss / speed
        ball["vx"] = vx * kept
        ball["vy"] = vy * kept
