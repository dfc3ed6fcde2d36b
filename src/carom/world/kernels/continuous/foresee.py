"""What comes next for a ball in flight: the first impact with a shape or a ball, or a look around before that."""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import FEW_SHAPES, FLIGHT_SLICES, LOOK_TRAVEL
from carom.geometry.vector import larger
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, HIT_SHAPE, LEAVE, LOOK, NO_BALL, NO_PLACE, NOTHING, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import has_ends
from carom.rows.kinds_in_motion import impact_at_rest
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.relation import INSIDE_BALL, LASTING, NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.bins import leash
from carom.world.kernels.continuous.flight import consider, path_box, path_of, top_speed
from carom.world.kernels.continuous.foresee_balls import foresee_balls, foresee_pairs
from carom.world.kernels.continuous.queue import put_event, row_of, take_event
from carom.world.kernels.continuous.support import lean, slide_time
from carom.world.kernels.continuous.surfaces import impact_in_motion, span_box

#: No cell: what is looked for may be in several.
UNSURE = -1


def foresee(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    flights: Table[FlightRow],
    queue: Table[int],
    relations: Table[RelationRow],
    i: int,
) -> None:
    """Find what comes next for ball `i` and put it into the queue, or take the ball out if nothing does."""
    foresee_shapes(state, balls[i], flights[i], shapes, order, index, cells, members, relations)
    if flights[i]["kind"] == FLYING and state["bin_levels"] != 0:
        foresee_balls(state, balls, heads, flights, relations, i, True)
    queue_up(state, flights, queue, i)


def foresee_all(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    heads: Table[int],
    pairs: Pairs,
    relations: Table[RelationRow],
    flights: Table[FlightRow],
    queue: Table[int],
) -> None:
    """Foresee what comes first for every ball; each pair is looked at once."""
    duration = float(state["dt"]) / float(state["substeps"])
    for i in range(state["balls"]):
        if balls[i]["relation"] != NO_RELATION:
            lean(state, balls[i], flights[i], shapes, relations, duration, True)
    for i in range(state["balls"]):
        foresee_shapes(state, balls[i], flights[i], shapes, order, index, cells, members, relations)
    if state["swept"] != 0:
        foresee_pairs(state, balls, pairs, flights, relations)
    elif state["bin_levels"] != 0:
        for i in range(state["balls"]):
            if flights[i]["kind"] == FLYING:
                foresee_balls(state, balls, heads, flights, relations, i, False)
    for i in range(state["balls"]):
        queue_up(state, flights, queue, i)


def queue_up(state: StateRow, flights: Table[FlightRow], queue: Table[int], i: int) -> None:
    """Put the next event of ball `i` into the queue, or take the ball out if it has none."""
    if flights[i]["event"] != NOTHING:
        put_event(state, flights, queue, i)
    elif flights[i]["place"] != NO_PLACE:
        take_event(state, flights, queue, i)


def foresee_shapes(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
) -> None:
    """Foresee what comes first for a ball but for other balls: an impact with a shape, or a look around."""
    flight["event"] = NOTHING
    flight["event_time"] = state["span"]
    if flight["kind"] != FLYING:
        return
    remaining = float(state["span"]) - float(flight["time"])
    speed = top_speed(ball, flight, remaining)
    if speed > 0.0 and state["binned"] != 0:
        dx, dy = float(ball["x"]) - float(flight["bin_x"]), float(ball["y"]) - float(flight["bin_y"])
        # A push may have taken it farther; then it is filed anew at once, not at a time that is past.
        consider(flight, larger(leash(state, flight) - sqrt(dx * dx + dy * dy), 0.0) / speed, LOOK, NO_BALL)
    if speed > 0.0 and ball["relation"] != NO_RELATION:
        foresee_relations(state, ball, flight, shapes, relations, speed)
    cell = cell_around(state, index[FIXED], cells, float(ball["x"]), float(ball["y"]), speed * remaining)
    if cell == UNSURE:
        foresee_fixed(state, ball, flight, shapes, order, index, cells, members, relations, speed)
    else:
        begin, end = cell_span(cells, cell)
        if begin < end:
            duration = float(flight["event_time"]) - float(flight["time"])
            foresee_members(state, ball, flight, shapes, members, relations, begin, end, 0.0, duration)
    if state["shapes"] > state["fixed"]:
        foresee_kinematic(state, ball, flight, shapes, order, relations)


def cell_around(state: StateRow, entry: IndexRow, cells: Table[CellRow], x: float, y: float, way: float) -> int:
    """The cell that holds every place within `way` of (x, y) along both axes, or UNSURE."""
    cell = locate(state, entry, cells, x - way, y - way)
    if cell >= 0 and locate(state, entry, cells, x + way, y + way) == cell:
        return cell
    return UNSURE


def foresee_relations(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    speed: float,
) -> None:
    """Foresee when a ball of a top `speed` has to look whether its relations go on."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        relation = relations[place]
        if relation["kind"] == LASTING:
            substep = float(state["dt"]) / float(state["substeps"])
            delay, leaves = slide_time(ball, flight, shapes[relation["other"]], substep)
            consider(flight, delay, LEAVE if leaves else LOOK, row_of(relation["other"]))
        else:
            consider(flight, LOOK_TRAVEL * float(ball["radius"]) / speed, LOOK, NO_BALL)
        place = int(relation["next"])


def foresee_fixed(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    speed: float,
) -> None:
    """Foresee the first impact with a static shape: one of a few, or one near a slice of the way of a ball.

    Its speed is `speed` at most.
    """
    entry = index[FIXED]
    if entry["cells_begin"] == entry["cells_end"]:
        return
    duration = float(flight["event_time"]) - float(flight["time"])
    slice_time = duration
    if speed * duration > entry["side"]:
        slice_time = float(entry["side"]) / speed
    few = state["fixed"] <= FEW_SHAPES and slice_time < duration
    if few or slice_time * FLIGHT_SLICES < duration:
        foresee_members(state, ball, flight, shapes, order, relations, 0, int(state["fixed"]), 0.0, duration)
        return
    begin = 0.0
    while begin < duration:
        end = min(begin + slice_time, duration)
        foresee_slice(state, ball, flight, shapes, entry, cells, members, relations, begin, end)
        duration = float(flight["event_time"]) - float(flight["time"])
        begin = end


def foresee_slice(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    begin: float,
    end: float,
) -> None:
    """Foresee impacts with the static shapes near a slice of a way that is no wider than a cell."""
    left, bottom, right, top = path_box(path_of(ball, flight), begin, end)
    first = locate(state, entry, cells, left, bottom)
    if first >= 0 and locate(state, entry, cells, right, top) == first:
        if cells[first]["begin"] < cells[first]["end"]:
            low, high = cell_span(cells, first)
            foresee_members(state, ball, flight, shapes, members, relations, low, high, begin, end)
        return
    second = locate(state, entry, cells, right, bottom)
    third = locate(state, entry, cells, left, top)
    fourth = locate(state, entry, cells, right, top)
    for corner in range(4):
        if corner == 0:
            cell = first
        elif corner == 1:
            cell = second if second != first else -1
        elif corner == 2:
            cell = third if third != first and third != second else -1
        else:
            cell = fourth if fourth != first and fourth != second and fourth != third else -1
        if cell >= 0:
            low, high = cell_span(cells, cell)
            foresee_members(state, ball, flight, shapes, members, relations, low, high, begin, end)


def foresee_members(
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
    """Foresee impacts with those of the shapes `members[low:high]` that stand still, near a slice of a ball's way."""
    path, radius = path_of(ball, flight), float(ball["radius"])
    left, bottom, right, top = path_box(path, begin, end)
    state["box_tests"] += high - low
    for k in range(low, high):
        row = row_of(members[k])
        shape = shapes[row]
        if (
            right + radius >= shape["left"]
            and left - radius <= shape["right"]
            and top + radius >= shape["bottom"]
            and bottom - radius <= shape["top"]
            and not is_moving(shape)
            and may_collide(ball, shape)
            and not is_related(relations, ball, row)
        ):
            state["full_tests"] += 1
            duration = float(flight["event_time"]) - float(flight["time"])
            time = impact_at_rest(shape, path, radius, duration)
            if time is not None:
                consider_shape(flight, shapes, 0.0 + time, row)
            if is_entered_past_ends(ball, shape):
                foresee_entry(flight, shape, ball, begin)


def is_entered_past_ends(ball: BallRow, shape: ShapeRow) -> bool:
    """True if a ball may come onto a shape past one of its ends, and it matters when: for sensors with ends."""
    if shape["sensor"] == 0 and ball["sensor"] == 0:
        return False
    return has_ends(shape["kind"])


def foresee_entry(flight: FlightRow, shape: ShapeRow, ball: BallRow, begin: float) -> None:
    """Foresee a look around when a ball near a sensor with ends has gone a part of its radius, as seen from there.

    Not before it comes near it, at a time `begin` from now.
    """
    vx, vy = float(ball["vx"]), float(ball["vy"])
    speed = sqrt(vx * vx + vy * vy)
    if is_moving(shape):
        speed += top_surface_speed(shape)
    if speed > 0.0:
        consider(flight, begin + LOOK_TRAVEL * float(ball["radius"]) / speed, LOOK, NO_BALL)


def top_surface_speed(shape: ShapeRow) -> float:
    """The most that any place of a moving shape's box moves at."""
    ux, uy = float(shape["velocity_x"]), float(shape["velocity_y"])
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    dx = max(px - float(shape["left"]), float(shape["right"]) - px)
    dy = max(py - float(shape["bottom"]), float(shape["top"]) - py)
    return sqrt(ux * ux + uy * uy) + fabs(float(shape["spin"])) * sqrt(dx * dx + dy * dy)


def consider_shape(flight: FlightRow, shapes: Table[ShapeRow], delay: float, row: int) -> None:
    """Make an impact with a shape the next event if it comes sooner; of impacts at one time points come first."""
    time = float(flight["time"]) + delay
    if time == flight["event_time"] and flight["event"] == HIT_SHAPE:
        if shapes[row]["kind"] < shapes[flight["partner"]]["kind"]:
            flight["partner"] = row
        return
    consider(flight, delay, HIT_SHAPE, row)


def is_related(relations: Table[RelationRow], ball: BallRow, row: int) -> bool:
    """True if a ball passes a shape, is inside it as a sensor, or is held by it: no impact with it is to come."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["other"] == row and relations[place]["kind"] != INSIDE_BALL:
            return True
        place = int(relations[place]["next"])
    return False


def foresee_kinematic(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    relations: Table[RelationRow],
) -> None:
    """Foresee the first impact with a kinematic shape: those that stand still first, then those that move."""
    fixed, count = int(state["fixed"]), int(state["shapes"])
    duration = float(flight["event_time"]) - float(flight["time"])
    foresee_members(state, ball, flight, shapes, order, relations, fixed, count, 0.0, duration)
    for k in range(fixed, count):
        if is_moving(shapes[order[k]]):
            foresee_moving(state, ball, flight, shapes, row_of(order[k]), relations)


def foresee_moving(
    state: StateRow, ball: BallRow, flight: FlightRow, shapes: Table[ShapeRow], row: int, relations: Table[RelationRow]
) -> None:
    """Foresee the impact with a shape that moves."""
    shape = shapes[row]
    duration = float(flight["event_time"]) - float(flight["time"])
    path, radius = path_of(ball, flight), float(ball["radius"])
    left, bottom, right, top = path_box(path, 0.0, duration)
    box_left, box_bottom, box_right, box_top = span_box(shape, float(state["span"]))
    state["box_tests"] += 1
    if (
        right + radius >= box_left
        and left - radius <= box_right
        and top + radius >= box_bottom
        and bottom - radius <= box_top
        and may_collide(ball, shape)
        and not is_related(relations, ball, row)
    ):
        state["full_tests"] += 1
        time = impact_in_motion(shape, float(flight["time"]), path, radius, duration, 1.0)
        if time is not None:
            consider_shape(flight, shapes, 0.0 + time, row)
        if is_entered_past_ends(ball, shape):
            foresee_entry(flight, shape, ball, 0.0)
