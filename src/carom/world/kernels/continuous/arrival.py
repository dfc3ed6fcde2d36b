"""How a ball comes to an event of its flight: where it is then, and which of its relations have begun or ended."""

from __future__ import annotations

from carom.constants import END_DEPTH_CONTINUOUS, ROOT_STEPS, SEPARATION_SLACK
from carom.geometry.impact import impact_ball
from carom.geometry.path import path_back
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, FlightRow
from carom.rows.hit import ENTER, EXIT, HitRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import has_ends
from carom.rows.kinds_in_motion import impact_at_rest
from carom.rows.kinds_near import distance_to_shape
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.bins import file_ball, leash, unfile_ball
from carom.world.kernels.continuous.flight import fly_to, path_at, path_of, place_at
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.support import keep_energy
from carom.world.kernels.continuous.surfaces import gap_to_shape, impact_in_motion, into_frame
from carom.world.kernels.step.hits import write_hit
from carom.world.kernels.step.relations import add_relation, drop_relation, find_relation


def time_of(state: StateRow, time: float) -> float:
    """The world's time at a time of the span."""
    substep = float(state["dt"]) / float(state["substeps"])
    within = float(state["substep"]) * substep + float(state["span_begin"]) + time
    return float(state["time"]) + min(within, float(state["dt"]))


def note_late(state: StateRow, hits: Table[HitRow], time: float, kind: int, ball: int, shape: int) -> None:
    """Write what happened at a time of the span that may be past into the step's hits, where it belongs in time.

    There must be room for a hit.
    """
    when = time_of(state, time)
    place = int(state["hits"])
    while place > state["step_hits"] and hits[place - 1]["time"] > when:
        hits[place] = hits[place - 1]
        place -= 1
    write_hit(state, hits[place], when, kind, ball, shape)


def arrive(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    flights: Table[FlightRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    i: int,
    time: float,
) -> None:
    """Move a ball to where it is at a time of the span, file it anew if need be, and bring its relations up to date."""
    ball, flight = balls[i], flights[i]
    began, from_x, from_y = float(flight["time"]), float(ball["x"]), float(ball["y"])
    fly_to(ball, flight, time)
    if state["binned"] != 0:
        dx, dy = float(ball["x"]) - float(flight["bin_x"]), float(ball["y"]) - float(flight["bin_y"])
        half = 0.5 * leash(state, flight)
        if dx * dx + dy * dy > half * half:
            unfile_ball(flights, heads, i)
            file_ball(state, balls, flights, heads, i)
    if ball["relation"] != NO_RELATION:
        keep_energy(state, ball, flight, shapes, relations)
        end_relations(state, balls, shapes, flights, hits, relations, i, time - began)
    if time > began and flight["kind"] == FLYING:
        cell = locate(state, index[FIXED], cells, float(ball["x"]), float(ball["y"]))
        begin, end = cell_span(cells, cell)
        if begin < end:
            note_passing(state, ball, flight, i, shapes, members, begin, end, hits, relations, began, from_x, from_y)
        begin, end = int(state["fixed"]), int(state["shapes"])
        note_passing(state, ball, flight, i, shapes, order, begin, end, hits, relations, began, from_x, from_y)


def near_ends(
    shapes: Table[ShapeRow], members: Table[int], begin: int, end: int, x: float, y: float, radius: float
) -> bool:
    """True if a ball at (x, y) may be on one of the shapes `members[begin:end]` that have ends."""
    for k in range(begin, end):
        shape = shapes[members[k]]
        if has_ends(shape["kind"]):
            apart = (
                x + radius < shape["left"]
                or x - radius > shape["right"]
                or y + radius < shape["bottom"]
                or y - radius > shape["top"]
            )
            if not apart or is_moving(shape):
                return True
    return False


def note_passing(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    members: Table[int],
    begin: int,
    end: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    began: float,
    from_x: float,
    from_y: float,
) -> None:
    """Let a ball pass the shapes that it overlaps and came into past an end since it was at `from` at the time `began`.

    One that overlaps a shape otherwise was pushed onto it. There must be room for a relation and a hit with
    each.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    for k in range(begin, end):
        row = row_of(members[k])
        shape = shapes[row]
        if not has_ends(shape["kind"]):
            continue
        if not is_moving(shape) and (
            x + radius < shape["left"]
            or x - radius > shape["right"]
            or y + radius < shape["bottom"]
            or y - radius > shape["top"]
        ):
            continue
        found = gap_to_shape(shape, float(flight["time"]), x, y, radius, 0.0, 0.0)
        if found is None:
            continue
        gap, _nx, _ny = found
        if (
            gap < -END_DEPTH_CONTINUOUS * radius
            and may_collide(ball, shape)
            and not find_relation(relations, ball, PASSING, row)
            and not find_relation(relations, ball, LASTING, row)
            and not find_relation(relations, ball, INSIDE_SHAPE, row)
            and gap_to_shape(shape, began, from_x, from_y, radius, 0.0, 0.0) is None
        ):
            sensing = shape["sensor"] != 0 or ball["sensor"] != 0
            add_relation(state, relations, ball, i, INSIDE_SHAPE if sensing else PASSING, row)
            if sensing:
                time = time_of_entry(shape, ball, flight, began)
                note_late(state, hits, time, ENTER, int(ball["id"]), int(shape["id"]))


def time_of_entry(shape: ShapeRow, ball: BallRow, flight: FlightRow, began: float) -> float:
    """The time since `began` at which a ball came past an end onto a sensor that it is on."""
    out, within = began, float(flight["time"])
    for _ in range(ROOT_STEPS):
        middle = 0.5 * (out + within)
        if is_on_sensor(shape, ball, flight, middle):
            within = middle
        else:
            out = middle
    return within


def end_relations(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    flights: Table[FlightRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
    i: int,
    way: float,
) -> None:
    """End the relations of a ball that flew for `way` seconds with what it does not overlap any more.

    A sensor's end gives an `EXIT` at the time at which the ball, flying back, would touch it first.
    """
    ball, flight = balls[i], flights[i]
    now = float(flight["time"])
    before = NO_RELATION
    place = int(ball["relation"])
    while place != NO_RELATION:
        kind, other = int(relations[place]["kind"]), int(relations[place]["other"])
        if kind == LASTING or overlaps_still(balls, shapes, flights, ball, flight, kind, other):
            before = place
            place = int(relations[place]["next"])
            continue
        if kind == INSIDE_SHAPE:
            ago = time_since_shape(shapes[other], ball, flight, way)
            note_late(state, hits, now - ago, EXIT, int(ball["id"]), int(shapes[other]["id"]))
        elif kind == INSIDE_BALL:
            ago = time_since_ball(balls[other], flights[other], ball, flight, way)
            note_late(state, hits, now - ago, EXIT, int(ball["id"]), int(balls[other]["id"]))
        place = drop_relation(state, relations, ball, place, before)


def overlaps_still(
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    flights: Table[FlightRow],
    ball: BallRow,
    flight: FlightRow,
    kind: int,
    other: int,
) -> bool:
    """True if a ball overlaps a shape, its ends included where it passes it, or another ball, at its own time."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    time = float(flight["time"])
    if kind == INSIDE_BALL:
        x1, y1, _vx, _vy = place_at(balls[other], flights[other], time)
        reach = radius + float(balls[other]["radius"])
        return (x - x1) * (x - x1) + (y - y1) * (y - y1) < reach * reach
    shape = shapes[other]
    if kind == PASSING:
        if is_moving(shape):
            x, y = into_frame(shape, time, x, y)
        return distance_to_shape(shape, x, y) < radius
    found = gap_to_shape(shape, time, x, y, radius, 0.0, 0.0)
    if found is None:
        return False
    gap, _nx, _ny = found
    return gap <= SEPARATION_SLACK * radius


def time_since_shape(shape: ShapeRow, ball: BallRow, flight: FlightRow, way: float) -> float:
    """How long ago, within `way` seconds, a ball left a shape."""
    back, radius = path_back(path_of(ball, flight)), float(ball["radius"])
    now = float(flight["time"])
    if is_moving(shape):
        ago = impact_in_motion(shape, now, back, radius, way, -1.0)
    else:
        ago = impact_at_rest(shape, back, radius, way)
    if ago is not None:
        return 0.0 + ago
    # It left past an end, or touched just so when it was looked at last.
    out, within = 0.0, way
    for _ in range(ROOT_STEPS):
        middle = 0.5 * (out + within)
        if is_on_sensor(shape, ball, flight, now - middle):
            within = middle
        else:
            out = middle
    return within


def is_on_sensor(shape: ShapeRow, ball: BallRow, flight: FlightRow, time: float) -> bool:
    """True if a ball overlaps a shape, beside which its centre is, at a time of its flight."""
    x, y, _vx, _vy = place_at(ball, flight, time)
    found = gap_to_shape(shape, time, x, y, float(ball["radius"]), 0.0, 0.0)
    if found is None:
        return False
    gap, _nx, _ny = found
    return gap <= 0.0


def time_since_ball(other: BallRow, partner: FlightRow, ball: BallRow, flight: FlightRow, way: float) -> float:
    """How long ago, within `way` seconds, a ball left another."""
    first = path_back(path_at(other, partner, float(flight["time"])))
    reach = float(other["radius"]) + float(ball["radius"])
    ago = impact_ball(first, path_back(path_of(ball, flight)), reach, way)
    if ago is None:
        return way
    return 0.0 + ago
