"""A step in the discrete mode: overlaps are found after moving.

Each stage can stop where room runs out, and go on from there when there is more.
"""

from __future__ import annotations

from math import inf

from carom.constants import REGION_SUBSTEPS
from carom.rows.ball import BallRow
from carom.rows.hit import HitRow
from carom.rows.index import CellRow, IndexRow, PairTables, ShapeIndex, SlotRow
from carom.rows.pose import rest as let_rest
from carom.rows.prefetch import prefetch
from carom.rows.relation import RelationRow
from carom.rows.saved import BUT_PAIRS, KEPT, PAIRS_DUE, SavedRow
from carom.rows.shape import ShapeRow
from carom.rows.state import (
    BEGIN,
    BRUTE,
    DISCRETE,
    DONE,
    END,
    FIND_PAIRS,
    FINISH,
    GRID,
    MOVE,
    NEEDS_PAIRS,
    NEEDS_ROOM,
    NOT_FINITE,
    OTHER_REACH,
    PAIRS,
    SHAPES,
    STALE,
    StateRow,
)
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.grid import pairs_ahead, pairs_by_grid
from carom.world.kernels.broad_phase.pairs import pairs_by_brute_force, pairs_by_quadtree, plant_ball_tree
from carom.world.kernels.broad_phase.patching import patch_index
from carom.world.kernels.broad_phase.regions import are_few, build_regions, span_on_way
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING, build_index
from carom.world.kernels.step.beginning import begin_step
from carom.world.kernels.step.ending import end_step, finish_substep, sweep_relations
from carom.world.kernels.step.motion import move_shapes
from carom.world.kernels.step.narrow import balls_overlap, keep_side, meet_ball, meet_sensing_ball
from carom.world.kernels.step.rollback import roll_back
from carom.world.kernels.step.rounds import meet_all_shapes
from carom.world.kernels.step.soundness import shapes_are_sound
from carom.world.kernels.step.stages import enter_stage, lacks_room
from carom.world.kernels.step.times import substep_end, substep_length

#: So many pairs ahead of the one that is tested, rows of balls are brought near.
PAIRS_AHEAD = 8


def step_discrete(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    index: Table[IndexRow],
    cells: Table[CellRow],
    members: Table[int],
    slots: Table[SlotRow],
    starts: Table[int],
    pairs: Pairs,
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> int:
    """Why the kernel came back: DONE after `state["steps_left"]` steps, or what it needs to go on from where it is.

    `states` holds the world's state and the copy that a failed step is rolled back to. Called again after NEEDS_ROOM or
    NEEDS_PAIRS with more of what `state["wanted_*"]` names, the outcome is the same as if there had been room.
    """
    pair_tables = (slots, starts, pairs)
    shape_index = (index, cells, members)
    state = states[0]
    while state["steps_left"] > 0:
        stage = state["stage"]
        if stage == BEGIN:
            status = begin_step(states, balls, shapes, order, slots, saved, relations, index)
        elif stage == MOVE:
            status = begin_substep(states, balls, shapes, order, shape_index, saved, relations)
        elif stage == SHAPES:
            status = meet_all_shapes(state, balls, shapes, shape_index, pair_tables, saved, hits, relations)
        elif stage == FIND_PAIRS and state["balls"] < 2 and state["found"] == 0:
            enter_stage(state, FINISH)
            status = DONE
        elif stage == FIND_PAIRS:
            status = find_pairs(state, balls, shapes, shape_index, pair_tables, saved)
        elif stage == PAIRS:
            status = meet_all_pairs(
                state, balls, shapes, shape_index, pairs, saved, hits, relations
            )  # fmt: skip
        elif stage == FINISH:
            status = finish(state, balls, shapes, order, hits, relations)
        else:
            status = end_step(states, balls, shapes, order, saved, relations)
        if status != DONE:
            return status
    return DONE


def begin_substep(
    states: Table[StateRow],
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    shape_index: ShapeIndex,
    saved: Table[SavedRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when the kinematic shapes have moved and the index of shapes is right again.

    NEEDS_PAIRS where that has no room, NOT_FINITE if a shape went out of the range of numbers and the step was undone.
    """
    state = states[0]
    # Called again after NEEDS_PAIRS, the shapes have moved already.
    if state["stage_entered"] == 0:
        duration = substep_length(state)
        moved = move_shapes(state, balls, shapes, order, shape_index[0][MOVING], duration)
        if moved:
            spend_span(state, shape_index[0][MOVING], duration)
        state["stage_entered"] = 1
        count = int(state["shapes"])
        # The first substep sees those too that were set where no number reaches; later ones see what has moved.
        looked_at = count + int(state["movers"]) if moved or state["substep"] == 0 else count
        if not shapes_are_sound(shapes, order, count, looked_at):
            roll_back(states, balls, shapes, order, saved, relations)
            return NOT_FINITE
    if not rebuild_index(state, balls, shapes, order, shape_index):
        return NEEDS_PAIRS
    state["iteration"] = 0
    state["found"] = 0
    enter_stage(state, SHAPES)
    return DONE


def rebuild_index(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    shape_index: ShapeIndex,
) -> bool:
    """True when the index of the shapes, which rows show where they are, is right again; False where it has no room."""
    if not rebuild_static(state, balls, shapes, order, shape_index):
        return False
    # What is counted depends on how many there are, not on when they were filed.
    swept = shape_index[0][MOVING]["swept"] != 0
    if state["moving_stale"] == STALE or swept == (are_few(state, True) or state["broad_phase"] == BRUTE):
        span = span_on_way(state, shapes, order)
        if span < inf:
            span = min(span, REGION_SUBSTEPS * substep_length(state))
        if not build_regions(state, shapes, order, shape_index, span, True):
            return False
    state["moving_stale"] = 0
    return True


def spend_span(state: StateRow, entry: IndexRow, duration: float) -> None:
    """Let so many seconds be over of those for which the regions of kinematic shapes hold."""
    entry["span"] -= duration
    if entry["span"] < 0.0:
        state["moving_stale"] = STALE


def rebuild_static(
    state: StateRow, balls: Table[BallRow], shapes: Table[ShapeRow], order: Table[int], shape_index: ShapeIndex
) -> bool:
    """True when the index of the static shapes is right again; False where it has no room."""
    index, cells, members = shape_index
    fixed, moving = index[FIXED], index[MOVING]
    if state["index_stale"] == 0 and state["taken"] + state["put"] > 0:
        state["index_stale"] = 0 if patch_index(state, shapes, order, index, cells, members) else STALE
    state["taken"] = 0
    state["put"] = 0
    if state["index_stale"] == OTHER_REACH and fixed["reach"] == state["reach"]:
        # Another copy of the world has made it, whose balls are as large.
        state["index_stale"] = 0
    if state["index_stale"] != 0:
        state["index_stale"] = STALE
        if not build_index(state, balls, shapes, order, shape_index):
            return False
        state["index_stale"] = 0
    # The kinematic index stands behind the static one, which may have grown.
    grown = fixed["cells_end"] > moving["cells_begin"] or fixed["members_end"] > moving["members_begin"]
    if grown or moving["reach"] != state["reach"]:
        state["moving_stale"] = STALE
    return True


def find_pairs(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    pair_tables: PairTables,
    saved: Table[SavedRow],
) -> int:
    """DONE when `pairs` holds the pairs of balls to be tested in this iteration; NEEDS_PAIRS if it has too few rows."""
    _slots, _starts, pairs = pair_tables
    index, cells, members = shape_index
    count = 0
    if state["balls"] > 1:
        # Where room runs out the search begins anew, so its tests are not to count twice.
        tests = int(state["box_tests"])
        if state["broad_phase"] == BRUTE:
            count = pairs_by_brute_force(state, balls, pairs)
        elif state["broad_phase"] == GRID and is_counted(state):
            count = pairs_ahead(state, pair_tables)
        elif state["broad_phase"] == GRID:
            count = pairs_by_grid(state, balls, pair_tables, 0.0)
        else:
            root = int(index[MOVING]["cells_end"])
            free = int(index[MOVING]["members_end"])
            end = plant_ball_tree(state, balls, shapes, cells, members, root, free)
            count = pairs_by_quadtree(state, balls, cells, members, root, end, pairs) if end > 0 else -1
        if count < 0:
            state["box_tests"] = tests
            return NEEDS_PAIRS
    # Later iterations look only at pairs of which one was moved since it was tested.
    if state["iteration"] > 0:
        count = keep_due(pairs, count, saved)
        for i in range(state["balls"]):
            # Few are due, and to write costs more than to read.
            if saved[i]["touched"] & PAIRS_DUE:
                saved[i]["touched"] &= BUT_PAIRS
    state["pairs"] = count
    state["grid_size"] = 0
    enter_stage(state, PAIRS)
    return DONE


def is_counted(state: StateRow) -> bool:
    """True if the balls were counted in a grid laid ahead, and have not met each other since."""
    first = state["substep"] == 0 and state["iteration"] == 0
    return bool(first and state["detection"] == DISCRETE and state["grid_size"] > 0)


def keep_due(pairs: Pairs, count: int, saved: Table[SavedRow]) -> int:
    """The number of pairs left when those that have not moved since they were last tested are taken out."""
    kept = 0
    for k in range(count):
        i, j = pairs[k, 0], pairs[k, 1]
        if (saved[i]["touched"] | saved[j]["touched"]) & PAIRS_DUE:
            pairs[kept, 0] = i
            pairs[kept, 1] = j
            kept += 1
    return kept


def meet_all_pairs(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    pairs: Pairs,
    saved: Table[SavedRow],
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when the pairs have been tested, each once, and the next iteration or the substep's end is to come.

    After the last iteration the shapes at rest come once more, if it met anything: they have the last word.
    """
    last = int(state["pairs"]) - 1
    for k in range(state["cursor"], state["pairs"]):
        if lacks_room(state, len(hits), len(relations), k, 1):
            return NEEDS_ROOM
        prefetch_pair(balls, saved, pairs, min(k + PAIRS_AHEAD, last))
        # The order of a pair's balls depends on the search; what follows from it must not.
        i = min(int(pairs[k, 0]), int(pairs[k, 1]))
        j = max(int(pairs[k, 0]), int(pairs[k, 1]))
        first, second = balls[i], balls[j]
        if balls_overlap(state, first, second) and not saved[i]["touched"] & saved[j]["touched"] & KEPT:
            if first["sensor"] != 0 or second["sensor"] != 0:
                meet_sensing_ball(state, first, i, second, j, hits, relations)
            else:
                x1, y1, x2, y2 = float(first["x"]), float(first["y"]), float(second["x"]), float(second["y"])
                if meet_ball(state, first, second, saved[i], saved[j], hits[state["hits"]]):
                    keep_side(state, first, saved[i], shapes, shape_index, relations, x1, y1)
                    keep_side(state, second, saved[j], shapes, shape_index, relations, x2, y2)
    state["iteration"] += 1
    enter_stage(state, SHAPES if state["found"] > 0 else FINISH)
    state["found"] = 0
    return DONE


def prefetch_pair(balls: Table[BallRow], saved: Table[SavedRow], pairs: Pairs, k: int) -> None:
    """Have the rows of a pair's balls near when its turn comes: in a crowd they are far from those of the last."""
    for side in range(2):
        row = int(pairs[k, side])
        prefetch(saved, row)
        prefetch(balls, row)
        # A ball's row lies in two lines, the second of which has the beginning of the next row or is that row's first.
        prefetch(balls, row + 1)


def finish(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    order: Table[int],
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> int:
    """DONE when relations, movers that have arrived, friction and sleep are dealt with; what is next is to come."""
    if state["relations"] > 0:
        if len(hits) - state["hits"] < state["relations"]:
            state["wanted_hits"] = state["hits"] + state["relations"]
            return NEEDS_ROOM
        sweep_relations(state, balls, shapes, hits, relations, substep_end(state))
    finish_substep(state, balls, substep_length(state))
    state["substep"] += 1
    if state["substep"] < state["substeps"]:
        enter_stage(state, MOVE)
        return DONE
    # In other substeps those that have arrived rest before they would move on.
    for k in range(state["shapes"], state["shapes"] + state["movers"]):
        let_rest(shapes[order[k]])
    enter_stage(state, END)
    return DONE
