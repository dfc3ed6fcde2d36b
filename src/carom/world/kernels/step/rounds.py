"""Rounds in which balls meet the shapes near them: in the first they move, later ones see to what was pushed since."""

from __future__ import annotations

from carom.constants import FEW_TO_SORT, NEW_CELLS
from carom.rows.ball import BallRow
from carom.rows.hit import HitRow
from carom.rows.index import IndexRow, PairTables, ShapeIndex, SlotRow
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving
from carom.rows.prefetch import prefetch
from carom.rows.relation import RelationRow
from carom.rows.saved import BUT_PAIRS, COUNTED, KEPT, PAIRS_DUE, SHAPES_DUE, SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import DISCRETE, DONE, FIND_PAIRS, FINISH, NEEDS_PAIRS, NEEDS_ROOM, StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import clear_grid, count_ball, grid_ahead
from carom.world.kernels.broad_phase.regions import LISTS, list_near
from carom.world.kernels.broad_phase.shape_index import (
    FIXED,
    MOVING,
    Front,
    cell_near,
    cell_span,
    comes_first,
    front_of,
    is_free,
    locate,
    rest_of_cell,
)
from carom.world.kernels.step.motion import launch_ball, moved, note_met, put_ball, unsoundness
from carom.world.kernels.step.narrow import Way, boxes_apart, meet_shape
from carom.world.kernels.step.seams import overlap_beside_walls
from carom.world.kernels.step.stages import enter_stage, lacks_room
from carom.world.kernels.step.times import substep_length

#: So many balls ahead of one that meets shapes again, rows are brought near.
DUE_AHEAD = 8


def meet_all_shapes(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    pair_tables: PairTables,
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when every ball has moved (first iteration) and met the shapes near it.

    NEEDS_ROOM if hits or relations ran out, NEEDS_PAIRS if there are too few cells. After the last iteration come the
    shapes at rest alone, the static ones at the end.
    """
    first = state["iteration"] == 0 and state["detection"] == DISCRETE
    if first and state["sleeping"] == 0 and state["balls"] > FEW_TO_SORT:
        return meet_first_shapes(state, balls, shapes, shape_index, pair_tables, saved, hits, relations)
    index = shape_index[0]
    # One round more than there are iterations: shapes at rest have the last word, whatever pairs did.
    settling = state["iteration"] == state["iterations"]
    kept = PAIRS_DUE | COUNTED | KEPT if state["iteration"] > 0 else KEPT
    gravity_x, gravity_y, duration = float(state["gravity_x"]), float(state["gravity_y"]), substep_length(state)
    most = most_meetings(state, index)
    front = front_of(state, index)
    swept = index[MOVING]["swept"] != 0
    slots = pair_tables[0]
    if state["stage_entered"] == 0:
        state["near"] = state["balls"] if first else list_due(state, slots, saved)
        state["stage_entered"] = 1
    last = int(state["near"]) - 1
    for k in range(state["cursor"], state["near"]):
        i = k if first else int(slots[k]["ball"])
        if not first:
            ahead = int(slots[min(k + DUE_AHEAD, last)]["ball"])
            prefetch(balls, ahead)
            prefetch(saved, ahead)
        ball, mark = balls[i], saved[i]
        if ball["asleep"] != 0:
            note_met(mark, ball)
            note_pairs_due(state, mark)
            continue
        if lacks_room(state, len(hits), len(relations), k, most):
            return NEEDS_ROOM
        from_x, from_y = float(ball["x"]), float(ball["y"])
        if first:
            x, y, vx, vy = moved(ball, duration, gravity_x, gravity_y)
            put_ball(ball, x, y, vx, vy)
            if unsoundness(x, y, vx, vy) != 0.0:
                state["doubtful"] = 1
        mark["touched"] &= kept
        near, looked = has_near(ball, shapes, shape_index, front)
        state["box_tests"] += looked
        if near or (swept and has_moving_near(ball, shapes, shape_index)):
            way = (from_x, from_y, float(ball["x"]), float(ball["y"]))
            meet_shapes_near(state, ball, i, shapes, shape_index, hits, relations, mark, first, settling, way)
            note_pairs_due(state, mark)
        note_met(mark, ball)
    enter_stage(state, FINISH if settling else FIND_PAIRS)
    return DONE


def list_due(state: StateRow, slots: Table[SlotRow], saved: Table[SavedRow]) -> int:
    """List in the slots the rows of the balls that are due to meet shapes again; returns how many there are.

    Few are: a branch for each ball costs more than to write all.
    """
    listed = 0
    for i in range(state["balls"]):
        slots[listed]["ball"] = i
        listed += int(saved[i]["touched"] & SHAPES_DUE != 0)
    return listed


def meet_first_shapes(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    pair_tables: PairTables,
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> int:
    """The same in the first iteration where none sleeps.

    In the same go they are counted in the grid that was laid ahead, if there is one.
    """
    slots, starts, _pairs = pair_tables
    if state["stage_entered"] == 0 and not clear_grid(state, starts):
        return NEEDS_PAIRS
    if state["stage_entered"] == 0:
        if state["substep"] > 0 or state["met_noted"] == 0:
            launch_balls(state, balls, slots, saved)
        list_balls_near(state, shape_index, slots, starts, saved)
        state["stage_entered"] = 1
    most = most_meetings(state, shape_index[0])
    front = front_of(state, shape_index[0])
    swept = shape_index[0][MOVING]["swept"] != 0
    grid = grid_ahead(state)
    for k in range(state["cursor"], state["near"]):
        if lacks_room(state, len(hits), len(relations), k, most):
            return NEEDS_ROOM
        i = int(slots[k]["ball"])
        ball, mark = balls[i], saved[i]
        near, looked = has_near(ball, shapes, shape_index, front)
        state["box_tests"] += looked
        if near or (swept and has_moving_near(ball, shapes, shape_index)):
            way = (float(slots[k]["x"]), float(slots[k]["y"]), float(ball["x"]), float(ball["y"]))
            meet_shapes_near(state, ball, i, shapes, shape_index, hits, relations, mark, True, False, way)
            note_pairs_due(state, mark)
            note_met(mark, ball)
        if state["grid_size"] > 0:
            slot = slots[int(state["balls"]) + i]
            slot["x"] = ball["x"]
            slot["y"] = ball["y"]
            if not count_ball(grid, slot, starts):
                leave_grid(state)
    enter_stage(state, FIND_PAIRS)
    return DONE


def launch_balls(state: StateRow, balls: Table[BallRow], slots: Table[SlotRow], saved: Table[SavedRow]) -> None:
    """Move the balls as `look_at_balls` does in the first substep; where they come from stands in slots."""
    gravity_x, gravity_y, duration = float(state["gravity_x"]), float(state["gravity_y"]), substep_length(state)
    for i in range(state["balls"]):
        ball, mark = balls[i], saved[i]
        mark["touched"] = 0
        slots[i]["x"] = ball["x"]
        slots[i]["y"] = ball["y"]
        x, y, vx, vy = moved(ball, duration, gravity_x, gravity_y)
        launch_ball(ball, mark, slots[state["balls"] + i], i, x, y, vx, vy)
    state["doubtful"] = 1


def list_balls_near(
    state: StateRow, shape_index: ShapeIndex, slots: Table[SlotRow], starts: Table[int], saved: Table[SavedRow]
) -> None:
    """List the balls that have shapes near, and count the others in the grid that was laid ahead, if any.

    The list stands in the lower half of the slots, with the places from which they came. A loop with no more in it than
    this keeps what it needs in registers.
    """
    front = front_of(state, shape_index[0])
    grid = grid_ahead(state)
    laid = state["grid_size"] > 0
    first = state["substep"] == 0
    total, listed = int(state["balls"]), 0
    for i in range(total):
        slot = slots[total + i]
        if not is_free(front, float(slot["x"]), float(slot["y"])):
            # In a later substep they stand there, each at its own place, which is not before this one.
            slots[listed]["ball"] = i
            slots[listed]["x"] = saved[i]["x"] if first else slots[i]["x"]
            slots[listed]["y"] = saved[i]["y"] if first else slots[i]["y"]
            listed += 1
            continue
        if laid and not count_ball(grid, slot, starts):
            laid = False
            leave_grid(state)
    state["near"] = listed


def leave_grid(state: StateRow) -> None:
    """Do without the grid that was laid ahead: a ball was pushed far out of it, or is not where numbers reach."""
    state["grid_size"] = 0
    state["doubtful"] = 1


def has_near(
    ball: BallRow, shapes: Table[ShapeRow], shape_index: ShapeIndex, front: Front
) -> tuple[bool, int]:  # fmt: skip
    """False where the box of a ball surely meets none of the static shapes, and how many were compared to see that.

    True where the front knows nothing.
    """
    _index, cells, members = shape_index
    x, y = float(ball["x"]), float(ball["y"])
    if not front[0]:
        return True, 0
    if is_free(front, x, y):
        return False, 0
    cell = cell_near(cells, front, x, y)
    if cell < 0:
        return False, 0
    begin, end = cell_span(cells, cell)
    for k in range(begin, end):
        if not boxes_apart(ball, shapes[members[k]]):
            return True, 0
    return False, end - begin


def has_moving_near(ball: BallRow, shapes: Table[ShapeRow], shape_index: ShapeIndex) -> bool:
    """True if the box of a ball meets that of a kinematic shape."""
    index, cells, members = shape_index
    for which in range(MOVING, LISTS):
        begin, end = list_near(index, cells, which, float(ball["x"]), float(ball["y"]))
        for k in range(begin, end):
            if not boxes_apart(ball, shapes[members[k]]):
                return True
    return False


def meet_shapes_near(
    state: StateRow,
    ball: BallRow,
    i: int,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    mark: SavedRow,
    first: bool,
    settling: bool,
    way: Way,
) -> None:
    """Let a ball meet the shapes that the index has for its place; there must be room. The rest as in `meet_shape`."""
    index, cells, members = shape_index
    for turn in range(2):
        # Static shapes last in that round: what moves may push a ball into a wall, never the reverse.
        entry = index[1 - turn if settling else turn]
        cell = locate(entry, cells, float(ball["x"]), float(ball["y"]))
        k, end = cell_span(cells, cell)
        w, wide_end = int(entry["wide_begin"]), int(entry["wide_end"])
        swept = entry["swept"] != 0
        if not swept:
            state["box_tests"] += (end - k) + (wide_end - w)
        left = NEW_CELLS
        while k < end or w < wide_end:
            if w == wide_end or (k < end and comes_first(shapes, int(members[k]), int(members[w]))):
                row = int(members[k])
                k += 1
            else:
                row = int(members[w])
                w += 1
            shape = shapes[row]
            if boxes_apart(ball, shape):
                continue
            state["box_tests"] += int(swept)
            if not may_collide(ball, shape) or (settling and is_moving(shape)):
                continue
            contact = overlap_beside_walls(state, ball, shape, shapes, shape_index, relations, first, way)
            if contact is None:
                continue
            px, py, nx, ny, setback = contact
            touch = (px, py, nx, ny, setback)
            pushed = meet_shape(state, ball, i, shapes, row, shape_index, hits, relations, mark, first, way, touch)
            # A push may have taken it into another cell, whose shapes it meets from there on, in the same order.
            if pushed and left > 0:
                new_cell = locate(entry, cells, float(ball["x"]), float(ball["y"]))
                if new_cell != cell:
                    left -= 1
                    cell = new_cell
                    unseen = end - k
                    k, end = rest_of_cell(shapes, cells, members, cell, row)
                    if not swept:
                        state["box_tests"] += end - k - unseen


def note_pairs_due(state: StateRow, mark: SavedRow) -> None:
    """Note in the first iteration that a ball's pairs are not due again: those of all balls are to come."""
    if state["iteration"] == 0:
        mark["touched"] &= BUT_PAIRS


def most_meetings(state: StateRow, index: Table[IndexRow]) -> int:
    """How many shapes a ball can meet in one iteration at most."""
    fixed, moving = int(state["fixed"]), int(state["shapes"] - state["fixed"])
    # The cell that it was in, and those that pushes may take it into.
    lists = 1 + NEW_CELLS
    return min(lists * int(index[FIXED]["longest"]), fixed) + min(lists * int(index[MOVING]["longest"]), moving)
