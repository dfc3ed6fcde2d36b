"""What a shape that has switched itself off between two steps held, or was sensed by, lets it go at that instant."""

from __future__ import annotations

from carom.rows.ball import BallRow
from carom.rows.flight import ASLEEP, NO_SHAPE, FlightRow
from carom.rows.hit import HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import BodyRow
from carom.rows.relation import NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import arrive
from carom.world.kernels.continuous.flight import let_fly
from carom.world.kernels.continuous.island import hasten, lies
from carom.world.kernels.continuous.lasting import hold
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.step.ending import end_relations, is_there


def let_go(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    bodies: Table[BodyRow],
) -> None:
    """End the balls' relations to shapes that are off now, sensors' with an `EXIT`, and wake all balls that sleep.

    There must be room for a hit for each relation. What comes next is to be foreseen anew for every ball.
    """
    for i in range(state["balls"]):
        ball, flight = balls[i], flights[i]
        if flight["kind"] != ASLEEP and not is_let_go(balls, shapes, relations, ball):
            continue
        arrive(state, balls, shapes, index, cells, members, flights, relations, i, NO_SHAPE)
        let_fly(state, ball, flight)
        if lies(relations, ball):
            hasten(state, balls, flights, relations, bodies, i)
        end_relations(state, balls, shapes, hits, relations, ball, float(state["now"]))
        hold(state, ball, flight, shapes, relations, True)


def is_let_go(
    balls: Table[BallRow], shapes: Table[ShapeRow], relations: Table[RelationRow], ball: BallRow
) -> bool:  # fmt: skip
    """True if a ball has a relation to what is not there any more."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if not is_there(balls, shapes, ball, int(relations[place]["kind"]), row_of(relations[place]["other"])):
            return True
        place = int(relations[place]["next"])
    return False
