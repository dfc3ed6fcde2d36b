"""How a ball comes to an event of its flight: where it is then, and which of its relations have begun or ended."""

from __future__ import annotations

from carom.constants import END_DEPTH_CONTINUOUS, SEPARATION_SLACK
from carom.geometry.impact import impact_ball
from carom.rows import CIRCLE, NO_RELATION, POINT, Row, Rows
from carom.world.bins import file_ball, leash, unfile_ball
from carom.world.flight import fly_to, place_at
from carom.world.layout import (
    EXIT,
    FLYING,
    INSIDE_BALL,
    INSIDE_SHAPE,
    LASTING,
    PASSING,
)
from carom.world.narrow import may_collide
from carom.world.recording import write_hit
from carom.world.relations import add_relation, drop_relation, find_relation
from carom.world.shape_index import FIXED, distance_to_shape, locate
from carom.world.surfaces import (
    gap_to_shape,
    impact_at_rest,
    impact_in_motion,
    into_frame,
    is_moving,
)


def time_of(state: Row, time: float) -> float:
    """The world's time at a time of the span."""
    substep = float(state["dt"]) / float(state["substeps"])
    within = float(state["substep"]) * substep + float(state["span_begin"]) + time
    return float(state["time"]) + min(within, float(state["dt"]))


def arrive(
    state: Row,
    balls: Rows,
    shapes: Rows,
    order: Rows,
    index: Rows,
    cells: Rows,
    members: Rows,
    heads: Rows,
    flights: Rows,
    hits: Rows,
    relations: Rows,
    i: int,
    time: float,
) -> None:
    """Move a ball to where it is at a time of the span, file it anew if need be, and bring its relations up to date."""
    ball, flight = balls[i], flights[i]
    began = float(flight["time"])
    fly_to(ball, flight, time)
    if state["binned"] != 0:
        dx, dy = float(ball["x"]) - float(flight["bin_x"]), float(ball["y"]) - float(flight["bin_y"])
        half = 0.5 * leash(state, flight)
        if dx * dx + dy * dy > half * half:
            unfile_ball(flights, heads, i)
            file_ball(state, balls, flights, heads, i)
    if ball["relation"] != NO_RELATION:
        end_relations(state, balls, shapes, flights, hits, relations, i, time - began)
    if time > began and flight["kind"] == FLYING:
        cell = locate(state, index[FIXED], cells, float(ball["x"]), float(ball["y"]))
        if cell >= 0:
            begin, end = int(cells[cell]["begin"]), int(cells[cell]["end"])
            note_passing(state, ball, flight, i, shapes, members, begin, end, relations)
        note_passing(state, ball, flight, i, shapes, order, int(state["fixed"]), int(state["shapes"]), relations)


def note_passing(
    state: Row,
    ball: Row,
    flight: Row,
    i: int,
    shapes: Rows,
    members: Rows,
    begin: int,
    end: int,
    relations: Rows,
) -> None:
    """Let a ball pass the shapes with ends that it overlaps without an impact: it came in past an end.

    There must be room for a relation with each.
    """
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    for k in range(begin, end):
        row = int(members[k])
        shape = shapes[row]
        if shape["kind"] == POINT or shape["kind"] == CIRCLE or shape["sensor"] != 0 or ball["sensor"] != 0:
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
        ):
            add_relation(state, relations, ball, i, PASSING, row)


def end_relations(
    state: Row, balls: Rows, shapes: Rows, flights: Rows, hits: Rows, relations: Rows, i: int, way: float
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
            write_hit(
                state, hits[state["hits"]], time_of(state, now - ago), EXIT, int(ball["id"]), int(shapes[other]["id"])
            )
        elif kind == INSIDE_BALL:
            ago = time_since_ball(balls[other], flights[other], ball, flight, way)
            write_hit(
                state, hits[state["hits"]], time_of(state, now - ago), EXIT, int(ball["id"]), int(balls[other]["id"])
            )
        place = drop_relation(state, relations, ball, place, before)


def overlaps_still(balls: Rows, shapes: Rows, flights: Rows, ball: Row, flight: Row, kind: int, other: int) -> bool:
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


def time_since_shape(shape: Row, ball: Row, flight: Row, way: float) -> float:
    """How long ago, within `way` seconds, a ball left a shape."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    vx, vy, ax, ay = -float(ball["vx"]), -float(ball["vy"]), float(flight["ax"]), float(flight["ay"])
    if is_moving(shape):
        ago = impact_in_motion(shape, float(flight["time"]), x, y, radius, vx, vy, ax, ay, way, -1.0)
    else:
        ago = impact_at_rest(shape, x, y, radius, vx, vy, ax, ay, way)
    if ago is None:
        return 0.0
    return 0.0 + ago


def time_since_ball(other: Row, partner: Row, ball: Row, flight: Row, way: float) -> float:
    """How long ago, within `way` seconds, a ball left another."""
    x1, y1, vx1, vy1 = place_at(other, partner, float(flight["time"]))
    x2, y2, vx2, vy2 = float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])
    ax, ay = float(flight["ax"]) - float(partner["ax"]), float(flight["ay"]) - float(partner["ay"])
    r1, r2 = float(other["radius"]), float(ball["radius"])
    ago = impact_ball(x1, y1, -vx1, -vy1, r1, x2, y2, -vx2, -vy2, r2, ax, ay, way)
    if ago is None:
        return 0.0
    return 0.0 + ago
