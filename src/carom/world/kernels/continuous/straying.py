"""When a ball leaves the world's bounds, or comes back; one that is to be removed then takes no part any more."""

from __future__ import annotations

from math import fabs, inf

from carom.constants import GAP_ROUNDING, SEPARATION_SLACK
from carom.geometry.path import Path, path_after
from carom.geometry.roots import falling_time
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, NO_BALL, NO_SHAPE, STRAY, FlightRow
from carom.rows.hit import HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.island import BodyRow
from carom.rows.relation import INSIDE_BALL, NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.arrival import arrive, keep_course
from carom.world.kernels.continuous.flight import consider, event_age, path_box, path_of
from carom.world.kernels.continuous.island import hasten, lies, part_from_all
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.step.ending import write_exit
from carom.world.kernels.step.relations import drop_kind, drop_relation, find_relation

#: Sides of the bounds: left, right, bottom, top.
SIDES = 4


def removes_strays(state: StateRow) -> bool:
    """True where balls that leave the bounds are removed."""
    return bool(state["remove_strays"] != 0 and state["bounded"] != 0)


def is_out(state: StateRow, ball: BallRow) -> bool:
    """True for a ball that has left the bounds of a world which removes such: it is there until the step ends."""
    return bool(ball["stray"] != 0) and removes_strays(state)


def count_out(state: StateRow, balls: Table[BallRow]) -> int:
    """How many balls are to be removed when the step ends."""
    found = 0
    if removes_strays(state):
        for i in range(state["balls"]):
            found += int(balls[i]["stray"] != 0)
    return found


def predict_stray(state: StateRow, ball: BallRow, flight: FlightRow, age: float) -> None:
    """Foresee, from an age of its flight on, when a ball is wholly outside of the bounds, or a stray no more.

    It leaves when it is beyond a side by more than rounding, and is back when it is beyond none, so neither is found
    again; at once where a flight begins so: it was put there, or the bounds were. Asked last: most hit before that.
    """
    path, radius, until = path_of(ball, flight), float(ball["radius"]), event_age(flight)
    stray = ball["stray"] != 0
    if not stray and until < inf and stays_within(state, path, radius, age, until):
        return
    x, y, _vx, _vy, _gx, _gy = path
    slack = SEPARATION_SLACK * radius + GAP_ROUNDING * (fabs(x) + fabs(y))
    if age == 0.0 and is_outside(state, path, radius, 0.0 if stray else slack) != stray:
        consider(flight, 0.0, STRAY, NO_BALL)
        return
    if flight["kind"] != FLYING:
        return
    for side in range(SIDES):
        beyond, rate, pull = past_side(state, path, radius, side)
        if stray:
            time = falling_time(beyond, rate, pull)
            if time is not None and time >= age and not is_outside(state, path_after(path, time), radius, slack):
                consider(flight, time, STRAY, NO_BALL)
        else:
            time = falling_time(slack - beyond, -rate, -pull)
            if time is not None and time >= age:
                consider(flight, time, STRAY, NO_BALL)


def stays_within(state: StateRow, path: Path, radius: float, begin: float, end: float) -> bool:
    """True if a ball surely does not leave the bounds between two ages of its flight."""
    left, bottom, right, top = path_box(path, begin, end)
    return bool(
        left + radius > state["left"]
        and bottom + radius > state["bottom"]
        and right - radius < state["right"]
        and top - radius < state["top"]
    )


def past_side(state: StateRow, path: Path, radius: float, side: int) -> tuple[float, float, float]:
    """How far a ball is wholly past a side of the bounds, and the first two derivatives of that."""
    x, y, vx, vy, gx, gy = path
    if side == 0:
        return float(state["left"]) - x - radius, -vx, -gx
    if side == 1:
        return x - radius - float(state["right"]), vx, gx
    if side == 2:
        return float(state["bottom"]) - y - radius, -vy, -gy
    return y - radius - float(state["top"]), vy, gy


def is_outside(state: StateRow, path: Path, radius: float, slack: float) -> bool:
    """True if a ball is wholly past a side of the bounds, by more than a slack."""
    for side in range(SIDES):
        beyond, _rate, _pull = past_side(state, path, radius, side)
        if beyond > slack:
            return True
    return False


def cross_bounds(
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
    i: int,
) -> None:
    """Let a ball be a stray now, or be none any more. There must be room for a hit for each relation."""
    ball = balls[i]
    keep_course(state, ball, flights, i)
    if not is_out(state, ball):
        ball["stray"] = 1 - ball["stray"]
        # A stray counts once, when it leaves.
        state["strays"] += ball["stray"]
    if is_out(state, ball):
        take_out(state, balls, shapes, index, cells, members, hits, relations, flights, bodies, i)


def take_out(
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
    i: int,
) -> None:
    """End what a ball has to do with others: who lies on it is solved anew, at once, and sensors see it leave."""
    arrive(state, balls, shapes, index, cells, members, flights, relations, i, NO_SHAPE)
    ball, now = balls[i], float(state["now"])
    if lies(relations, ball):
        hasten(state, balls, flights, relations, bodies, i)
        part_from_all(state, balls, relations, i)
        state["foreseen"] = 0
    while ball["relation"] != NO_RELATION:
        place = int(ball["relation"])
        kind, other = int(relations[place]["kind"]), row_of(relations[place]["other"])
        write_exit(state, balls, shapes, hits, ball, kind, other, now)
        drop_relation(state, relations, ball, place, NO_RELATION)
    for j in range(state["balls"]):
        if balls[j]["relation"] != NO_RELATION and find_relation(relations, balls[j], INSIDE_BALL, i):
            write_exit(state, balls, shapes, hits, balls[j], INSIDE_BALL, i, now)
            drop_kind(state, relations, balls[j], INSIDE_BALL, i)
