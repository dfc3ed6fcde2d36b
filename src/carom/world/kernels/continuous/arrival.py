"""How a ball comes to an event of its flight: where it is then, and which shapes it has begun to pass."""

from __future__ import annotations

from carom.constants import END_DEPTH_CONTINUOUS, LIFT
from carom.geometry.path import Path
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, IN_PART, NO_TICK, FlightRow
from carom.rows.index import CellRow, IndexRow, ShapeIndex
from carom.rows.kinds import has_ends
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.relation import LASTING, NO_RELATION, PASSING, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.regions import is_any_near, kinematic_near, next_near
from carom.world.kernels.broad_phase.shape_index import FIXED, cell_span, locate
from carom.world.kernels.continuous.flight import age_now, path_of, place_after
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.rest import slow_since
from carom.world.kernels.continuous.sliding import slide_on
from carom.world.kernels.continuous.surfaces import age_of_motion, gap_to_shape, seen_on_path
from carom.world.kernels.step.relations import add_relation, find_relation, has_kind

#: Halvings of the time of a path by which it is found when a ball came deep into a shape: down to its rounding.
ENTRY_HALVINGS = 52


def arrive(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
    met: int,
) -> None:
    """Begin a new flight of a ball where it is now, and bring what it passes up to date.

    Whoever changes a ball's path lets it arrive first; what others foresaw with it counts no more. The shape in row
    `met`, or NO_SHAPE, which it meets now, it has not come into past an end, though one that slides may be a little in
    it.
    """
    ball, flight = balls[i], flights[i]
    keep_course(state, ball, flights, i)
    flight["version"] += 1
    age = age_now(state, flight)
    path = path_of(ball, flight)
    flight["slow_for"] = age - slow_since(state, ball, flight, age)
    if ball["relation"] == NO_RELATION or not slide_on(state, ball, flight, shapes, relations, age):
        fly_on(ball, flight, age)
    if flight["tick_time"] < NO_TICK:
        energy = energy_of(state, ball)
        flight["surplus"] += energy - float(flight["energy"])
        flight["energy"] = energy
    flight["time"] = state["now"]
    flight["low"] = state["now_low"]
    flight["low_vx"] = 0.0
    flight["low_vy"] = 0.0
    if age > 0.0 and flight["kind"] == FLYING:
        note_all_passing(
            state, ball, flight, i, shapes, (index, cells, members), relations, 0.0, age, path, met
        )  # fmt: skip


def energy_of(state: StateRow, ball: BallRow) -> float:
    """The energy of a ball, per mass, where nothing but gravity does work."""
    vx, vy = float(ball["vx"]), float(ball["vy"])
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    return 0.5 * (vx * vx + vy * vy) - (gx * float(ball["x"]) + gy * float(ball["y"]))


def work_of_shift(state: StateRow, ball: BallRow, from_x: float, from_y: float) -> float:
    """The potential energy that a ball has won by being put from (from_x, from_y) to where it is."""
    dx, dy = float(ball["x"]) - from_x, float(ball["y"]) - from_y
    return -float(ball["mass"]) * (float(state["gravity_x"]) * dx + float(state["gravity_y"]) * dy)


def keep_course(state: StateRow, ball: BallRow, flights: Table[FlightRow], i: int) -> None:
    """Keep what a ball was like when the step began, once a step, for one that fails to go back to."""
    flight = flights[i]
    if flight["kept"] == state["step_number"]:
        return
    flight["kept"] = state["step_number"]
    flight["impacts"] = 0
    flight["x"] = ball["x"]
    flight["y"] = ball["y"]
    flight["vx"] = ball["vx"]
    flight["vy"] = ball["vy"]
    flight["still_time"] = ball["still_time"]
    flight["relation"] = ball["relation"]
    flight["asleep"] = ball["asleep"]
    flight["stray"] = ball["stray"]
    copy = flights[len(flights) // 2 + i]
    copy_course(flight, copy)
    copy["impacts"] = IN_PART


def copy_course(flight: FlightRow, copy: FlightRow) -> None:
    """Copy what an event may change of a flight, but for what is foreseen; what was shown of it stays what it is."""
    copy["time"] = flight["time"]
    copy["low"] = flight["low"]
    copy["x"] = flight["x"]
    copy["y"] = flight["y"]
    copy["vx"] = flight["vx"]
    copy["vy"] = flight["vy"]
    copy["low_vx"] = flight["low_vx"]
    copy["low_vy"] = flight["low_vy"]
    copy["ax"] = flight["ax"]
    copy["ay"] = flight["ay"]
    copy["slow_for"] = flight["slow_for"]
    copy["tick_time"] = flight["tick_time"]
    copy["tick_low"] = flight["tick_low"]
    copy["kind"] = flight["kind"]
    copy["met_time"] = flight["met_time"]
    copy["met_low"] = flight["met_low"]
    copy["at_once"] = flight["at_once"]
    copy["energy"] = flight["energy"]
    copy["surplus"] = flight["surplus"]
    copy["short"] = flight["short"]
    copy["quiet"] = flight["quiet"]
    copy["still_time"] = flight["still_time"]
    copy["relation"] = flight["relation"]
    copy["asleep"] = flight["asleep"]
    copy["stray"] = flight["stray"]


def fly_on(ball: BallRow, flight: FlightRow, age: float) -> None:
    """Move a ball to where it is at an age of its flight."""
    x, y, vx, vy = place_after(ball, flight, age)
    ball["x"] = x
    ball["y"] = y
    if flight["kind"] == FLYING:
        ball["vx"] = vx
        ball["vy"] = vy


def note_all_passing(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    ahead: float,
    age: float,
    path: Path,
    met: int,
) -> None:
    """Let a ball pass the shapes that it overlaps and came into past an end since its `path` began, `age` seconds ago.

    All but the one in row `met`. Its row is where it is `ahead` seconds after its flight began.

    One that overlaps a shape otherwise was pushed onto it. One that slides or rolls is handed from shape to shape at
    their joint, where its hop lies a little off the next one. There must be room for a relation with each.
    """
    index, cells, members = shape_index
    x, y = float(ball["x"]), float(ball["y"])
    begin, end = cell_span(cells, locate(index[FIXED], cells, x, y))
    for k in range(begin, end):
        row = row_of(members[k])
        if row != met:
            note_passing(state, ball, flight, i, shapes, row, relations, ahead, age, path)
    near, wide = kinematic_near(index, cells, x, y)
    while is_any_near(near, wide):
        row, near, wide = next_near(shapes, members, near, wide)
        if row != met:
            note_passing(state, ball, flight, i, shapes, row, relations, ahead, age, path)


def note_passing(
    state: StateRow,
    ball: BallRow,
    flight: FlightRow,
    i: int,
    shapes: Table[ShapeRow],
    row: int,
    relations: Table[RelationRow],
    ahead: float,
    age: float,
    path: Path,
) -> None:
    """Let a ball pass a shape if it overlaps it and came into it past an end."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    shape = shapes[row]
    if not has_ends(shape["kind"]):
        return
    if not is_moving(shape) and (
        x + radius < shape["left"]
        or x - radius > shape["right"]
        or y + radius < shape["bottom"]
        or y - radius > shape["top"]
    ):
        return
    slides = has_kind(relations, ball, LASTING)
    depth = (LIFT if slides else END_DEPTH_CONTINUOUS) * radius
    motion_age = age_of_motion(shape, flight) + ahead if is_moving(shape) else 0.0
    found = gap_to_shape(shape, motion_age, x, y, radius, 0.0, 0.0)
    if found is None:
        return
    gap, _nx, _ny = found
    if (
        gap < -depth
        and shape["sensor"] == 0
        and ball["sensor"] == 0
        and may_collide(ball, shape)
        and not find_relation(relations, ball, PASSING, row)
        and not find_relation(relations, ball, LASTING, row)
        and was_past_end(shape, motion_age - age, path, radius, age, depth, slides)
    ):
        add_relation(state, relations, ball, i, PASSING, row)


def was_past_end(
    shape: ShapeRow, motion_age: float, path: Path, radius: float, age: float, depth: float, slides: bool
) -> bool:
    """True if a ball that is deep in a shape now was past its ends when its path began, or when it came to be so deep.

    The path began `age` seconds ago, at an age of the shape's motion. Of one that `slides` only its beginning is known.
    """
    past, _deep = seen_on_path(shape, motion_age, path, radius, 0.0, depth)
    if past or slides:
        return past
    low, high = 0.0, age
    for _ in range(ENTRY_HALVINGS):
        middle = 0.5 * (low + high)
        past_then, deep = seen_on_path(shape, motion_age, path, radius, middle, depth)
        if deep:
            high = middle
        else:
            low, past = middle, past_then
    return past
