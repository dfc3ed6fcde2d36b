"""Taking rows out of a world, and with them the relations of what they held."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from carom.rows.ball import BallRow
from carom.rows.hit import EXIT, HIT_ROW
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, LYING, NO_RELATION, RelationRow
from carom.rows.tables import Numbered
from carom.world.kernels.step.hits import write_hit
from carom.world.kernels.step.relations import add_relation, is_of_balls
from carom.world.tables import OF_BALLS, Arrays
from carom.world.waking import begin_anew

#: A relation outside of the pool: kind, row of the ball, row of the other, force on the ball along x and y.
Relation = tuple[int, int, int, float, float]


def relations_in_order(arrays: Arrays) -> list[Relation]:
    """All relations, ball by ball, each ball's from the last added to the first."""
    found: list[Relation] = []
    if arrays.states[0]["relations"] > 0:
        balls = arrays.balls.used
        for i in np.flatnonzero(balls["relation"] != NO_RELATION):
            index = int(balls[i]["relation"])
            while index != NO_RELATION:
                relation: RelationRow = arrays.relations[index]
                force_x, force_y = float(relation["force_x"]), float(relation["force_y"])
                found.append((int(relation["kind"]), int(i), int(relation["other"]), force_x, force_y))
                index = int(relation["next"])
    return found


def set_relations(arrays: Arrays, relations: list[Relation]) -> None:
    """Replace all relations by these, which stand in the order of `relations_in_order`."""
    state = arrays.states[0]
    state["relations"] = state["relations_high"] = 0
    state["free_relation"] = NO_RELATION
    arrays.balls.used["relation"] = NO_RELATION
    arrays.extend_relations(len(relations))
    for kind, ball, other, force_x, force_y in reversed(relations):
        row = arrays.balls.rows[ball]
        add_relation(state, arrays.relations, row, ball, kind, other)
        arrays.relations[row["relation"]]["force_x"] = force_x
        arrays.relations[row["relation"]]["force_y"] = force_y


def remove_rows(arrays: Arrays, balls: NDArray[np.bool_], shapes: NDArray[np.bool_]) -> None:
    """Take out the rows that the masks name. Balls leave sensors, and sensors balls, with an `EXIT` now.

    Those of shapes stay in their table for a while, see `Layout`.
    """
    kept = _ended(arrays, balls, shapes) if balls.any() or _is_met(arrays, shapes) else None
    if balls.any():
        _remove_balls(arrays, balls)
    if kept is not None:
        set_relations(arrays, kept)
    if shapes.any():
        arrays.bury(np.flatnonzero(shapes))


def _is_met(arrays: Arrays, shapes: NDArray[np.bool_]) -> bool:
    """Whether a ball may have a relation to one of the shapes that the mask names."""
    state = arrays.states[0]
    pool = arrays.relations[: int(state["relations_high"])]
    others = pool["other"][~np.isin(pool["kind"], OF_BALLS)]
    return bool(state["relations"] > 0 and shapes[others[others < len(shapes)]].any())


def _ended(arrays: Arrays, balls: NDArray[np.bool_], shapes: NDArray[np.bool_]) -> list[Relation]:
    """The relations that stay when what the masks name goes, by the rows that balls have then.

    A ball that was held by that, or lay on it, is to begin a new flight.
    """
    kept: list[Relation] = []
    let_go = np.zeros(len(balls), np.bool_)
    new_ball = np.cumsum(~balls) - 1
    for kind, ball, other, force_x, force_y in relations_in_order(arrays):
        others, gone = (arrays.balls.used, balls) if is_of_balls(kind) else (arrays.shape_table.used, shapes)
        if balls[ball] or gone[other]:
            if kind in (INSIDE_SHAPE, INSIDE_BALL):
                _exit(arrays, arrays.balls.used[ball], others[other])
            let_go[ball] |= kind in (LASTING, LYING)
        else:
            moved = int(new_ball[other]) if is_of_balls(kind) else other
            kept.append((kind, int(new_ball[ball]), moved, force_x, force_y))
    begin_anew(arrays, let_go)
    return kept


def _remove_balls(arrays: Arrays, balls: NDArray[np.bool_]) -> None:
    """Take out the rows of balls."""
    asleep = int(np.count_nonzero(arrays.balls.used["asleep"][balls]))
    # What was foreseen names balls by their rows.
    arrays.states[0]["foreseen"] = 0
    arrays.states[0]["sleeping"] -= asleep
    if len(arrays.saved) >= len(balls):
        still = arrays.saved[: len(balls)][~balls]
        arrays.saved[: len(still)] = still
    if len(arrays.flights) >= len(balls):
        flying = arrays.flights[: len(balls)][~balls]
        arrays.flights[: len(flying)] = flying
    arrays.balls.drop(balls)


def _exit(arrays: Arrays, ball: BallRow, other: Numbered) -> None:
    """Record that a ball left a sensor."""
    state = arrays.states[0]
    if state["hits"] >= len(arrays.hits):
        state["wanted_hits"] = state["hits"] + 1
        arrays.extend_hits()
    write_hit(state, arrays.hits.view(HIT_ROW)[state["hits"]], float(state["time"]), EXIT, ball, int(other["id"]))
