"""A step that fails leaves everything as it was."""

from __future__ import annotations

from carom.rows.ball import BallRow
from carom.rows.relation import RelationRow
from carom.rows.saved import SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import STALE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.step.motion import note_met, put_ball
from carom.world.kernels.step.soundness import is_in_reach, is_sound
from carom.world.kernels.step.spending import unspend


def save_balls(state: StateRow, balls: Table[BallRow], saved: Table[SavedRow]) -> None:
    """Keep what a step may change in the balls."""
    for i in range(state["balls"]):
        save_ball(balls[i], saved[i])
        note_met(saved[i], balls[i])


def save_ball(ball: BallRow, kept: SavedRow) -> None:
    """The same of one ball, but for where it has met the shapes."""
    x, y, vx, vy = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    still_time, relation, asleep, stray = ball["still_time"], ball["relation"], ball["asleep"], ball["stray"]
    kept["x"] = x
    kept["y"] = y
    kept["vx"] = vx
    kept["vy"] = vy
    kept["still_time"] = still_time
    kept["relation"] = relation
    kept["asleep"] = asleep
    kept["stray"] = stray
    kept["touched"] = 0


def call_back(state: StateRow, balls: Table[BallRow], saved: Table[SavedRow]) -> None:
    """Put the balls back, as many as `state["cursor"]` says, that the beginning of a step has moved."""
    for i in range(state["cursor"]):
        put_back(balls[i], saved[i])
    state["cursor"] = 0


def put_back(ball: BallRow, kept: SavedRow) -> None:
    """Put a ball back to where it was when it was saved, with the velocity that it had."""
    put_ball(ball, float(kept["x"]), float(kept["y"]), float(kept["vx"]), float(kept["vy"]))


def save(
    states: Table[StateRow], shapes: Table[ShapeRow], order: Table[int], relations: Table[RelationRow]
) -> None:  # fmt: skip
    """Keep what a step may change but balls: state, shapes that move (behind the shapes), relations (upper half)."""
    state = states[0]
    count = int(state["shapes"])
    for k in range(count, count + state["movers"]):
        # Others do not change in a step but by switching themselves off, so they need no copy.
        shapes[k] = shapes[order[k]]
    # The whole pool in use is copied, free rows too: they are linked by their numbers.
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[half + k] = relations[k]
    states[1] = states[0]


def roll_back(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> None:
    """Put everything back to where it was when `save` was called; the copies tell what was not finite any more."""
    spent = int(states[0]["spent"])
    states[0] = states[1]
    state = states[0]
    for i in range(state["balls"]):
        ball, kept = balls[i], saved[i]
        # Python names the ball in the error, so the copy keeps which one it was.
        kept["overflowed"] = 0 if is_sound(ball) else 1
        put_back(ball, kept)
        ball["still_time"] = kept["still_time"]
        ball["relation"] = kept["relation"]
        ball["asleep"] = kept["asleep"]
        ball["stray"] = kept["stray"]
    state["cursor"] = 0
    count = int(state["shapes"])
    for k in range(count, count + state["movers"]):
        sound = is_in_reach(shapes[order[k]])
        shapes[order[k]] = shapes[k]
        shapes[k]["once"] = 0 if sound else 1
    for k in range(count + state["movers"], 2 * count - state["fixed"]):
        shapes[k]["once"] = 0
    if spent > 0:
        unspend(shapes, count)
    half = len(relations) // 2
    for k in range(state["relations_high"]):
        relations[k] = relations[half + k]
    # The index holds shapes where the failed step had moved them.
    state["index_stale"] = STALE
    state["moving_stale"] = STALE
