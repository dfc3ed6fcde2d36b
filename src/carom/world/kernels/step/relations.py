"""Relations: which balls pass which shapes, and which are inside which sensors; a linked list for each ball."""

from __future__ import annotations

from carom.rows.ball import BallRow
from carom.rows.relation import INSIDE_BALL, LYING, NO_RELATION, RelationRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def is_of_balls(kind: int) -> bool:
    """True for relations of a ball with another ball."""
    return kind == INSIDE_BALL or kind == LYING


def find_relation(relations: Table[RelationRow], ball: BallRow, kind: int, other: int) -> bool:
    """True if the ball has the relation `kind` to row `other`."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == kind and relations[place]["other"] == other:
            return True
        place = int(relations[place]["next"])
    return False


def relations_room(state: StateRow, relations: Table[RelationRow]) -> int:
    """How many relations can be added; the upper half of the pool is for the copy that a failed step goes back to."""
    return len(relations) // 2 - int(state["relations"])


def add_relation(
    state: StateRow, relations: Table[RelationRow], ball: BallRow, ball_row: int, kind: int, other: int
) -> None:
    """Add a relation in front of a ball's others; there must be room."""
    # Rows that were given back come first, so the pool is as long as the most there ever were at once.
    place = int(state["free_relation"])
    if place == NO_RELATION:
        place = int(state["relations_high"])
        state["relations_high"] = place + 1
    else:
        state["free_relation"] = relations[place]["next"]
    relation = relations[place]
    relation["force_x"] = 0.0
    relation["force_y"] = 0.0
    relation["kind"] = kind
    relation["ball"] = ball_row
    relation["other"] = other
    relation["next"] = ball["relation"]
    ball["relation"] = place
    state["relations"] += 1


def set_force(
    relations: Table[RelationRow], ball: BallRow, kind: int, other: int, force_x: float, force_y: float
) -> None:
    """Keep the force on a ball of its relation `kind` to row `other`, if there is one."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == kind and relations[place]["other"] == other:
            relations[place]["force_x"] = force_x
            relations[place]["force_y"] = force_y
            return
        place = int(relations[place]["next"])


def set_no_forces(relations: Table[RelationRow], ball: BallRow) -> None:
    """Forget the forces of all relations of a ball."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        relations[place]["force_x"] = 0.0
        relations[place]["force_y"] = 0.0
        place = int(relations[place]["next"])


def drop_relation(state: StateRow, relations: Table[RelationRow], ball: BallRow, place: int, before: int) -> int:
    """The relation after `place`, which is taken out of its ball's list; `before` is the one before it, if any."""
    following = int(relations[place]["next"])
    if before == NO_RELATION:
        ball["relation"] = following
    else:
        relations[before]["next"] = following
    relations[place]["next"] = state["free_relation"]
    # Snapshots tell free rows from used ones by this.
    relations[place]["ball"] = NO_RELATION
    state["free_relation"] = place
    state["relations"] -= 1
    return following


def has_kind(relations: Table[RelationRow], ball: BallRow, kind: int) -> bool:
    """True if the ball has a relation of the kind to anything."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == kind:
            return True
        place = int(relations[place]["next"])
    return False


def drop_kind(state: StateRow, relations: Table[RelationRow], ball: BallRow, kind: int, other: int) -> None:
    """Take out the relation `kind` of a ball to row `other`, if there is one."""
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == kind and relations[place]["other"] == other:
            drop_relation(state, relations, ball, place, before)
            return
        before = place
        place = int(relations[place]["next"])


def drop_all(state: StateRow, relations: Table[RelationRow], ball: BallRow, kind: int) -> None:
    """Take out all relations of a ball of a kind."""
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["kind"] == kind:
            place = drop_relation(state, relations, ball, place, before)
        else:
            before = place
            place = int(relations[place]["next"])


def is_related(relations: Table[RelationRow], ball: BallRow, row: int) -> bool:
    """True if a ball passes a shape, is inside it as a sensor, or is held by it: no impact with it is to come."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["other"] == row and not is_of_balls(int(relations[place]["kind"])):
            return True
        place = int(relations[place]["next"])
    return False
