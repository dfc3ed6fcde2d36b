"""What comes next for a ball with a shape that moves: their first touch, or a look from farther along.

Both have moved evenly since the later of the two began. From there on time is cut into slices whose length follows from
the two motions alone, and each is searched from its own beginning: so what is found does not depend on when one looks.
"""

from __future__ import annotations

from math import fabs, floor, inf, sqrt

from carom.constants import INDEX_MARGIN, MOVER_LOOKS, MOVER_TURN, MOVER_WAY
from carom.geometry.impact import impact_disc
from carom.geometry.path import Path, path_after
from carom.rows.ball import BallRow
from carom.rows.flight import HIT_SHAPE, LOOK, NO_BALL, FlightRow
from carom.rows.kinds import has_ends
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, reach_of
from carom.rows.relation import RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.flight import age_now, consider, event_age, path_at, path_box, path_of, time_to_go
from carom.world.kernels.continuous.lasting import is_walked_over
from carom.world.kernels.continuous.predict_sensors import predict_entry
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.surfaces import age_of_motion, impact_in_motion, touches_on_path
from carom.world.kernels.step.relations import is_related


def predict_movers(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    members: Table[int],
    relations: Table[RelationRow],
    low: int,
    high: int,
    begin: float,
    end: float,
) -> None:
    """Foresee touches with those of the shapes `members[low:high]` that move, between two ages of a ball's flight."""
    left, bottom, right, top = -inf, -inf, inf, inf
    if end < inf:
        left, bottom, right, top = path_box(path_of(ball, flight), begin, end)
    radius = float(ball["radius"])
    state["box_tests"] += high - low
    for k in range(low, high):
        row = row_of(members[k])
        shape = shapes[row]
        if not is_moving(shape) or is_related(relations, ball, row):
            continue
        if is_walked_over(ball, flight, shape, shapes, relations):
            continue
        if shape["velocity_x"] == 0.0 and shape["velocity_y"] == 0.0:
            # It does not leave the circle about its pivot.
            x, y, reach = float(shape["pivot_x"]), float(shape["pivot_y"]), (reach_of(shape) + radius) * INDEX_MARGIN
            if x + reach < left or x - reach > right or y + reach < bottom or y - reach > top:
                continue
        predict_mover(state, ball, flight, shape, row, begin, end)


def predict_mover(
    state: StateRow, ball: BallRow, flight: FlightRow, shape: ShapeRow, row: int, age: float, last: float
) -> None:
    """Foresee the touch of a ball with a shape that moves, from an age of the ball's flight on.

    What comes after the age `last` need not be found.
    """
    if not may_collide(ball, shape):
        return
    motion_age, now = age_of_motion(shape, flight), age_now(state, flight)
    # The ages of both when the later of them began.
    begin, shape_begin = max(-motion_age, 0.0), max(motion_age, 0.0)
    path = path_at(ball, flight, begin)
    radius = float(ball["radius"])
    reach = reach_of(shape) + radius
    length = slice_length(shape, path, reach, radius)
    if length == inf or length == 0.0:
        return
    number = max(1.0 * floor((age - begin) / length), 0.0)
    if (shape["sensor"] != 0 or ball["sensor"] != 0) and has_ends(shape["kind"]):
        away = seen_from_pivot(shape, path, shape_begin, number * length)
        if time_until_near(away, reach, length) < inf:
            predict_entry(ball, flight, shape, row, age)
    for _ in range(MOVER_LOOKS):
        start = number * length
        # What touches at the very time of what is known is found too: which of them comes first is told by their rows.
        if begin + start > min(event_age(flight), last):
            return
        away = seen_from_pivot(shape, path, shape_begin, start)
        clear = time_until_near(away, reach, length)
        if clear == inf:
            return
        if clear > length:
            number += max(1.0 * floor(clear / length), 1.0)
            continue
        state["full_tests"] += 1
        gone = now - (begin + start)
        time = impact_from(shape, shape_begin + start, path_after(path, start), radius, length, gone)
        if time is not None:
            consider(flight, begin + (start + time), HIT_SHAPE, row)
            return
        number += 1.0
    consider(flight, begin + number * length, LOOK, NO_BALL)


def impact_from(
    shape: ShapeRow, motion_age: float, path: Path, radius: float, duration: float, gone: float
) -> float | None:
    """The time of a path at which a ball touches a moving shape, or None; `gone` is that which is over.

    What it would have met in that was off then: it is asked from now on.
    """
    time = impact_in_motion(shape, motion_age, path, radius, duration, 1.0)
    if time is None or time >= gone or touches_on_path(shape, motion_age, path, radius, gone):
        return time
    time = impact_in_motion(shape, motion_age + gone, path_after(path, gone), radius, duration - gone, 1.0)
    return None if time is None else gone + time


def slice_length(shape: ShapeRow, path: Path, reach: float, radius: float) -> float:
    """The length of the slices: in one the ball goes a part of the shape's reach, or the shape turns by a part."""
    dvx, dvy = path.vx - float(shape["velocity_x"]), path.vy - float(shape["velocity_y"])
    spin = fabs(float(shape["spin"]))
    pull = sqrt(path.gx * path.gx + path.gy * path.gy)
    way = max(MOVER_WAY * reach, radius)
    length = time_to_go(sqrt(dvx * dvx + dvy * dvy), pull, way)
    return min(length, MOVER_TURN / spin) if spin > 0.0 else length


def seen_from_pivot(shape: ShapeRow, path: Path, shape_begin: float, start: float) -> Path:
    """The path of a ball, from a time on, relative to the pivot of a shape."""
    x, y, vx, vy, gx, gy = path_after(path, start)
    ux, uy = float(shape["velocity_x"]), float(shape["velocity_y"])
    time = shape_begin + start
    return Path(
        x - (float(shape["pivot_x"]) + ux * time), y - (float(shape["pivot_y"]) + uy * time), vx - ux, vy - uy, gx, gy
    )


def time_until_near(away: Path, reach: float, length: float) -> float:
    """The time until a ball may come within reach of a pivot: 0 if it may within a slice, infinite if it never does."""
    distance = sqrt(away.x * away.x + away.y * away.y)
    circle = reach * INDEX_MARGIN
    if distance <= circle:
        return 0.0
    speed, pull = sqrt(away.vx * away.vx + away.vy * away.vy), sqrt(away.gx * away.gx + away.gy * away.gy)
    if not time_to_go(speed, pull, distance - circle) > length:
        return 0.0
    found = impact_disc(away, circle, inf)
    return inf if found is None else 0.0 + found
