"""The end of a substep: relations that end, friction, and balls that fall asleep; and that of a step."""

from __future__ import annotations

from carom.rows.ball import OF_WORLD, BallRow
from carom.rows.hit import EXIT, HitRow
from carom.rows.kinds import find_contact
from carom.rows.kinds_near import distance_to_shape
from carom.rows.masks import may_collide
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, LYING, NO_RELATION, PASSING, RelationRow
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import BEGIN, DISCRETE, DONE, HAS_STRAYS, NOT_FINITE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.step.hits import write_hit
from carom.world.kernels.step.motion import slow_by_friction
from carom.world.kernels.step.narrow import boxes_apart
from carom.world.kernels.step.relations import drop_relation
from carom.world.kernels.step.rollback import roll_back, save_balls
from carom.world.kernels.step.soundness import balls_are_sound
from carom.world.kernels.step.spending import keep_spent


def is_there(balls: Table[BallRow], shapes: Table[ShapeRow], ball: BallRow, kind: int, other: int) -> bool:
    """True if what a ball's relation is to may be met still, as a sensor or not, as when the relation began."""
    if kind == LYING:
        return may_collide(ball, balls[other]) and balls[other]["sensor"] == 0 and ball["sensor"] == 0
    if kind == INSIDE_BALL:
        return may_collide(ball, balls[other]) and (balls[other]["sensor"] != 0 or ball["sensor"] != 0)
    sensing = shapes[other]["sensor"] != 0 or ball["sensor"] != 0
    return may_collide(ball, shapes[other]) and bool(sensing) == (kind == INSIDE_SHAPE)


def still_holds(
    state: StateRow, balls: Table[BallRow], shapes: Table[ShapeRow], ball: BallRow, kind: int, other: int
) -> bool:
    """True if a ball's relation lasts: both are there to collide, and it overlaps the other row still.

    A ball that passes a segment or arc overlaps it as long as any place of it, the ends included, is inside the ball.
    In the continuous mode a ball's flight has ended what it does not overlap any more.
    """
    # Events have kept its relations up to date; what is left to see is what a user has switched meanwhile.
    if state["detection"] != DISCRETE:
        return is_there(balls, shapes, ball, kind, other)
    # Only flights have lasting contacts; this one is left from a time in the other mode.
    if kind == LASTING or kind == LYING:
        return False
    if kind == INSIDE_BALL:
        partner = balls[other]
        if not may_collide(ball, partner) or (partner["sensor"] == 0 and ball["sensor"] == 0):
            return False
        dx, dy = float(partner["x"]) - float(ball["x"]), float(partner["y"]) - float(ball["y"])
        reach = float(partner["radius"]) + float(ball["radius"])
        return dx * dx + dy * dy < reach * reach
    shape = shapes[other]
    if not may_collide(ball, shape) or boxes_apart(ball, shape):
        return False
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    if kind == PASSING:
        return bool(shape["sensor"] == 0 and ball["sensor"] == 0 and distance_to_shape(shape, x, y) < radius)
    if shape["sensor"] == 0 and ball["sensor"] == 0:
        return False
    return find_contact(shape, x, y, radius, 0.0, 0.0) is not None


def sweep_relations(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    time: float,
) -> None:
    """Drop the relations that do not hold any more; a sensor's end with an `EXIT`, for which there must be room."""
    for i in range(state["balls"]):
        end_relations(state, balls, shapes, hits, relations, balls[i], time)


def end_relations(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    ball: BallRow,
    time: float,
) -> bool:
    """Whether one ball has lost any; drops those of it."""
    lost = False
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        kind, other = int(relations[place]["kind"]), int(relations[place]["other"])
        if still_holds(state, balls, shapes, ball, kind, other):
            before = place
            place = int(relations[place]["next"])
            continue
        write_exit(state, balls, shapes, hits, ball, kind, other, time)
        place = drop_relation(state, relations, ball, place, before)
        lost = True
    return lost


def write_exit(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    hits: Table[HitRow],
    ball: BallRow,
    kind: int,
    other: int,
    time: float,
) -> None:
    """Record that a ball leaves what it has a relation to, where that is a sensor or it is one. There must be room."""
    if kind == INSIDE_SHAPE:
        write_hit(state, hits[state["hits"]], time, EXIT, ball, int(shapes[other]["id"]))
    elif kind == INSIDE_BALL:
        write_hit(state, hits[state["hits"]], time, EXIT, ball, int(balls[other]["id"]))


def finish_substep(state: StateRow, balls: Table[BallRow], duration: float) -> None:
    """Apply friction for `duration` seconds, and put to sleep the balls that have been slow for long enough."""
    worlds_loss = float(state["friction"]) * duration
    sleep_speed = float(state["sleep_speed"])
    # Most worlds have neither: then the balls need not be looked at.
    if worlds_loss == 0.0 and sleep_speed == 0.0 and state["braked"] == 0:
        return
    state["doubtful"] = 1
    for i in range(state["balls"]):
        ball = balls[i]
        if ball["asleep"] != 0:
            continue
        friction = float(ball["friction"])
        loss = worlds_loss if friction == OF_WORLD else friction * duration
        if loss > 0.0:
            slow_by_friction(ball, loss)
        vx, vy = float(ball["vx"]), float(ball["vy"])
        if vx * vx + vy * vy >= sleep_speed * sleep_speed:
            ball["still_time"] = 0.0
            continue
        ball["still_time"] += duration
        # What is slow for a moment only, at the top of its way, must not freeze there.
        if ball["still_time"] >= state["sleep_time"]:
            ball["asleep"] = 1
            ball["vx"] = 0.0
            ball["vy"] = 0.0
            state["sleeping"] += 1


def end_step(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when the step is complete; HAS_STRAYS if balls are to be removed; NOT_FINITE if it was rolled back."""
    state = states[0]
    if state["doubtful"] != 0 and not balls_are_sound(state, balls):
        roll_back(states, balls, shapes, order, saved, relations)
        return NOT_FINITE
    if state["bounded"] != 0:
        find_strays(state, balls)
    if state["sleeping"] > 0:
        # The next step compares with this, to see what was changed through a view while something slept.
        save_balls(state, balls, saved)
    state["time"] += state["dt"]
    keep_spent(state, shapes)
    state["steps_made"] += 1
    state["steps_left"] = 0 if 0 < state["stop_hits"] <= state["hits"] else state["steps_left"] - 1
    state["stage"] = BEGIN
    return HAS_STRAYS if state["outside"] > 0 and state["remove_strays"] != 0 else DONE


def find_strays(state: StateRow, balls: Table[BallRow]) -> None:
    """Mark and count the balls that lie wholly outside of the bounds; those that did not before count as strays."""
    left, bottom = float(state["left"]), float(state["bottom"])
    right, top = float(state["right"]), float(state["top"])
    for i in range(state["balls"]):
        ball = balls[i]
        x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
        outside = x + radius < left or x - radius > right or y + radius < bottom or y - radius > top
        if outside:
            state["outside"] += 1
            # A stray counts once, when it leaves, not in every step that it is out.
            state["strays"] += 1 - ball["stray"]
        ball["stray"] = 1 if outside else 0
