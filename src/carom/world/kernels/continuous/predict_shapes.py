"""What comes next for a ball in flight among the shapes: the first impact, or a look from farther along its way.

What is found depends on the ball's path and the shape alone, not on from where or how far one looks.
"""

from __future__ import annotations

from math import copysign, fabs, floor, inf, sqrt

from carom.constants import CROWD_SLICES, FEW_SHAPES, FLIGHT_SLICES, GAP_ROUNDING, SEARCH_MARGIN, SWEEP_ROUNDING
from carom.geometry.instants import later, seconds_since
from carom.geometry.path import Path, path_after, place_on
from carom.geometry.vector import larger
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, HIT_SHAPE, LOOK, NO_BALL, FlightRow
from carom.rows.index import CellRow, IndexRow
from carom.rows.kinds import has_ends
from carom.rows.kinds_in_motion import impact_at_rest
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.relation import RelationRow
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import GRID, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.shape_index import (
    FIXED,
    MOVING,
    QUARTERS,
    cell_span,
    clear_towards,
    locate,
    quarter_of,
)
from carom.world.kernels.continuous.flight import age_at, age_now, consider, event_age, path_box, path_of, time_to_go
from carom.world.kernels.continuous.lasting import is_walked_over
from carom.world.kernels.continuous.predict_movers import predict_movers
from carom.world.kernels.continuous.predict_sensors import predict_entry
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.surfaces import touches_on_path
from carom.world.kernels.step.relations import is_related


def predict_shapes(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    age: float,
) -> None:
    """Foresee the first impact with a shape from an age of a flight on; a ball that sleeps waits for what moves."""
    moves = flight["kind"] == FLYING and (
        ball["vx"] != 0.0 or ball["vy"] != 0.0 or flight["ax"] != 0.0 or flight["ay"] != 0.0
    )
    if moves:
        if asks_all_fixed(state, index):
            until = known_until(flight) if asks_bit_by_bit(state, index) else inf
            fixed = int(state["fixed"])
            predict_members(state, ball, flight, shapes, order, relations, 0, fixed, age, until)
        else:
            predict_on_way(state, ball, flight, shapes, index[FIXED], cells, members, relations, age, False)
    if state["fixed"] < state["shapes"]:
        predict_kinematic(state, ball, flight, shapes, index[MOVING], cells, members, relations, age, moves)


def asks_all_fixed(state: StateRow, index: Table[IndexRow]) -> bool:
    """True if all static shapes are asked, and no cells."""
    return bool(
        state["fixed"] <= FEW_SHAPES or state["broad_phase"] != GRID or float(index[FIXED]["side"]) == inf
    )  # fmt: skip


def asks_bit_by_bit(state: StateRow, index: Table[IndexRow]) -> bool:
    """True if all static shapes are asked, and each time no farther than up to when the ball is filed anew.

    Not where there are kinematic shapes: these are looked for up to the impact with a static one.
    """
    return bool(state["binned"] != 0 and state["fixed"] == state["shapes"]) and asks_all_fixed(state, index)


def known_until(flight: FlightRow) -> float:
    """The age of the flight of a ball that is filed up to which impacts with static shapes are looked for, if with all.

    That of what is to come, or when the ball is filed anew: then they are looked for farther along the way.
    """
    return min(event_age(flight), age_at(flight, float(flight["file_time"]), float(flight["file_low"])))


def predict_kinematic(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    age: float,
    moves: bool,
) -> None:
    """The same for the kinematic shapes: first those at rest, if the ball moves, and then those that move."""
    wide_begin, wide_end = int(entry["wide_begin"]), int(entry["wide_end"])
    if moves:
        predict_members(state, ball, flight, shapes, members, relations, wide_begin, wide_end, age, inf)
        if entry["resting"] > 0:
            predict_on_way(state, ball, flight, shapes, entry, cells, members, relations, age, False)
    predict_movers(state, ball, flight, shapes, members, relations, wide_begin, wide_end, age, inf)
    if entry["moving"] > 0:
        if moves:
            predict_on_way(state, ball, flight, shapes, entry, cells, members, relations, age, True)
        else:
            cell = locate(entry, cells, float(ball["x"]), float(ball["y"]))
            begin, end = cell_span(cells, cell)
            predict_movers(state, ball, flight, shapes, members, relations, begin, end, age, inf)


def predict_on_way(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    age: float,
    moving: bool,
) -> None:
    """Foresee the first impact with a shape near the way of a ball, cell by cell, and a look where that ends.

    With one at rest, or, where `moving`, with one that moves.
    """
    path = path_of(ball, flight)
    _x, _y, begin_vx, begin_vy, gx, gy = path
    if gx == 0.0 and gy == 0.0:
        predict_on_line(state, ball, flight, shapes, entry, cells, members, relations, age, moving)
        return
    side = float(entry["side"])
    left, bottom = float(entry["left"]), float(entry["bottom"])
    right, top = left + side * float(entry["columns"]), bottom + side * float(entry["lines"])
    pull = sqrt(gx * gx + gy * gy)
    step = (1.0 - SEARCH_MARGIN) * side
    known = entry["measured"] != 0
    begin, until = age, event_age(flight)
    for _ in range(FLIGHT_SLICES if state["binned"] == 0 else CROWD_SLICES):
        x, y = place_on(path, begin)
        if not (left <= x <= right and bottom <= y <= top):
            begin = time_into_box(path, begin, left, bottom, right, top)
        if begin > until or begin == inf:
            return
        clear = cells_clear(entry, cells, (x - left) / side, (y - bottom) / side) if known else 0
        vx, vy = begin_vx + gx * begin, begin_vy + gy * begin
        end = begin + time_to_go(sqrt(vx * vx + vy * vy), pull, step * max(clear, 1))
        if not end > begin:
            return
        if clear == 0:
            predict_slice(state, ball, flight, shapes, entry, cells, members, relations, begin, end, moving)
            until = event_age(flight)
        begin = end
    consider(flight, begin, LOOK, NO_BALL)


def predict_on_line(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    shapes: Table[ShapeRow],
    entry: IndexRow,
    cells: Table[CellRow],
    members: Table[int],
    relations: Table[RelationRow],
    age: float,
    moving: bool,
) -> None:
    """The same where the way is straight: by what it crosses of each cell, or of a square of cells without members.

    Which cell comes next follows from the side by which the way leaves one, so that rounding holds it in none; members
    are listed from so much farther off that no rounding of a place hides one.
    """
    path = path_of(ball, flight)
    first_x, first_y, vx, vy, _gx, _gy = path
    side, left, bottom = float(entry["side"]), float(entry["left"]), float(entry["bottom"])
    columns, lines, first = int(entry["columns"]), int(entry["lines"]), int(entry["cells_begin"])
    begin, until = age, event_age(flight)
    x, y = place_on(path, begin)
    right, top = left + side * columns, bottom + side * lines
    if not (left <= x <= right and bottom <= y <= top):
        begin = time_into_box(path, begin, left, bottom, right, top)
        if begin > until or begin == inf:
            return
        x, y = place_on(path, begin)
    column = min(max(floor((x - left) / side), 0), columns - 1)
    line = min(max(floor((y - bottom) / side), 0), lines - 1)
    pace_x, pace_y, per_side = pace_of(vx), pace_of(vy), 1.0 / side
    way_x, way_y = (1 if vx > 0.0 else -1), (1 if vy > 0.0 else -1)
    known, quarter = entry["measured"] != 0, quarter_of(way_x > 0, way_y > 0)
    for _ in range(FLIGHT_SLICES if state["binned"] == 0 else CROWD_SLICES):
        cell = cells[first + line * columns + column]
        clear = clear_towards(cell, quarter) if known else 0
        wide = max(clear, 1)
        across = time_out(first_x, pace_x, left, side, column, wide)
        along = time_out(first_y, pace_y, bottom, side, line, wide)
        end = max(min(across, along), begin)
        low, high = int(cell["begin"]), int(cell["end"])
        if clear == 0 and low < high:
            if moving:
                predict_movers(state, ball, flight, shapes, members, relations, low, high, begin, end)
            else:
                predict_members(state, ball, flight, shapes, members, relations, low, high, begin, end)
            until = event_age(flight)
        if end >= until:
            return
        if across <= along:
            column += way_x * wide
            line = between(floor((first_y + vy * end - bottom) * per_side), line, line + way_y * (wide - 1))
        else:
            line += way_y * wide
            column = between(floor((first_x + vx * end - left) * per_side), column, column + way_x * (wide - 1))
        if not (0 <= column < columns and 0 <= line < lines):
            return
        begin = end
    if begin > age:
        consider(flight, begin, LOOK, NO_BALL)


def time_out(place: float, pace: float, edge: float, side: float, cell: int, wide: int) -> float:
    """When a coordinate leaves a cell and those that lie before it, so many in all, of cells that begin at an edge.

    `place` is that at the time 0, `pace` the inverse of its speed; infinite where it never leaves.
    """
    if fabs(pace) == inf:
        return inf
    ahead = cell + wide if pace > 0.0 else cell - wide + 1
    return (edge + side * ahead - place) * pace


def between(cell: int, one: int, other: int) -> int:
    """A cell, or of two others the nearer one where it is not between them."""
    return min(max(cell, min(one, other)), max(one, other))


def pace_of(speed: float) -> float:
    """The inverse of a speed, infinite for 0."""
    return 1.0 / speed if speed != 0.0 else inf


def cells_clear(entry: IndexRow, cells: Table[CellRow], across: float, along: float) -> int:
    """How many cells' widths a ball can go and come to no cell that has members, whichever way.

    The ball's place is given in cells, from the corner of the grid.
    """
    columns, lines = int(entry["columns"]), int(entry["lines"])
    if not (0.0 <= across < columns and 0.0 <= along < lines):
        return 0
    cell = cells[int(entry["cells_begin"]) + int(along) * columns + int(across)]
    least = clear_towards(cell, 0)
    for quarter in range(1, QUARTERS):
        least = min(least, clear_towards(cell, quarter))
    return max(least - 1, 0)


def time_into_box(path: Path, begin: float, left: float, bottom: float, right: float, top: float) -> float:
    """The first time from `begin` on at which a path that is outside of a box comes to it; infinite if never.

    A little before that, if anything: what is looked for inside must not be passed by.
    """
    first = inf
    for side in range(4):
        upright = side < 2
        level = left if side == 0 else (right if side == 1 else (bottom if side == 2 else top))
        if upright:
            one, two = crossings(0.5 * path.gx, path.vx, path.x - level)
        else:
            one, two = crossings(0.5 * path.gy, path.vy, path.y - level)
        for time in (one, two):
            # Where it crosses a side's line it comes in if the other coordinate is between the other two sides.
            if begin < time < first and is_between(path, time, upright, left, bottom, right, top):
                first = time
    return first


def is_between(
    path: Path, time: float, upright: bool, left: float, bottom: float, right: float, top: float
) -> bool:  # fmt: skip
    """True if a path is between the lower and the upper side of a box at a time, or between the others, all but."""
    x, y = place_on(path, time)
    if upright:
        slack = SEARCH_MARGIN * (top - bottom)
        return bottom - slack <= y <= top + slack
    slack = SEARCH_MARGIN * (right - left)
    return left - slack <= x <= right + slack


def crossings(c2: float, c1: float, c0: float) -> tuple[float, float]:
    """The two roots of c2·t² + c1·t + c0; -1 for each one that is missing."""
    if c2 == 0.0:
        return (-c0 / c1 if c1 != 0.0 else -1.0), -1.0
    discriminant = c1 * c1 - 4.0 * c2 * c0
    if discriminant < 0.0:
        return -1.0, -1.0
    half_sum = -0.5 * (c1 + copysign(sqrt(discriminant), c1))
    return half_sum / c2, (c0 / half_sum if half_sum != 0.0 else -1.0)


def predict_slice(
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
    moving: bool,
) -> None:
    """Foresee impacts with shapes at rest, or those that move, near a slice of a way that is no wider than a cell."""
    left, bottom, right, top = path_box(path_of(ball, flight), begin, end)
    first = locate(entry, cells, left, bottom)
    second = locate(entry, cells, right, bottom)
    third = locate(entry, cells, left, top)
    fourth = locate(entry, cells, right, top)
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
            if low == high:
                continue
            if moving:
                predict_movers(state, ball, flight, shapes, members, relations, low, high, begin, end)
            else:
                predict_members(state, ball, flight, shapes, members, relations, low, high, begin, end)


def predict_members(
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
    """Foresee impacts with those of the shapes `members[low:high]` that stand still, on a slice of a ball's way.

    What it meets later is found on a later slice, so that most shapes near a wall that it leaves take little. What it
    would have met before now has come since, or was off: that is asked from now on.
    """
    path, radius, age = path_of(ball, flight), float(ball["radius"]), age_now(state, flight)
    left, bottom, right, top, reach = -inf, -inf, inf, inf, radius
    if end < inf:
        left, bottom, right, top = path_box(path, begin, end)
        # What touches just as the slice ends may not be left out by rounding: on the next one it would be found late.
        reach = SWEEP_ROUNDING * radius + GAP_ROUNDING * ((fabs(left) + fabs(right)) + (fabs(bottom) + fabs(top)))
    state["box_tests"] += high - low
    for k in range(low, high):
        row = row_of(members[k])
        shape = shapes[row]
        if (
            right + reach >= shape["left"]
            and left - reach <= shape["right"]
            and top + reach >= shape["bottom"]
            and bottom - reach <= shape["top"]
            and not is_moving(shape)
            and may_collide(ball, shape)
            and not is_related(relations, ball, row)
        ):
            state["full_tests"] += 1
            came, until = age_of_rest(shape, flight), min(end, event_age(flight))
            time = impact_since(shape, path, came, radius, until)
            if time is not None and time < age and not touches_on_path(shape, 0.0, path, radius, age):
                time = impact_since(shape, path, age, radius, until)
            if time is not None and not is_walked_over(ball, flight, shape, shapes, relations):
                consider_shape(flight, shapes, time, row)
            if is_entered_past_ends(ball, shape):
                predict_entry(ball, flight, shape, row, begin)


def impact_since(shape: ShapeRow, path: Path, came: float, radius: float, until: float) -> float | None:
    """When a ball on a path touches a shape at rest that it can meet since it `came` there, or None by a time."""
    if came == 0.0:
        return impact_at_rest(shape, path, radius, until)
    time = impact_at_rest(shape, path_after(path, came), radius, until - came)
    return None if time is None else came + time


def age_of_rest(shape: ShapeRow, flight: FlightRow) -> float:
    """The age of a flight from which on a shape at rest has stood where it does: 0 unless it came to rest since."""
    if shape["motion"] != KINEMATIC:
        return 0.0
    since, low = float(shape["since"]), float(shape["since_low"])
    return larger(seconds_since(since, low, float(flight["time"]), float(flight["low"])), 0.0)


def is_entered_past_ends(ball: BallRow, shape: ShapeRow) -> bool:
    """True if a ball may come onto a shape past one of its ends, and it matters when: for sensors with ends."""
    if shape["sensor"] == 0 and ball["sensor"] == 0:
        return False
    return has_ends(shape["kind"])


def consider_shape(flight: FlightRow, shapes: Table[ShapeRow], age: float, row: int) -> None:
    """Make an impact with a shape the next event if it comes sooner; of impacts at one time points come first."""
    if flight["event"] == HIT_SHAPE:
        time, low = later(float(flight["time"]), float(flight["low"]), age)
        if time == flight["event_time"] and low == flight["event_low"]:
            kind, known = shapes[row]["kind"], shapes[flight["partner"]]["kind"]
            if kind < known or (kind == known and row < flight["partner"]):
                flight["partner"] = row
            return
    consider(flight, age, HIT_SHAPE, row)
