"""The row of a world's state: settings, time, counts, statistics and the place of a step, and what its numbers mean."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4, i8

# Detections.
DISCRETE = 0
CONTINUOUS = 1

# Broad phases.
BRUTE = 0
GRID = 1
QUADTREE = 2

# Why a step's kernel came back.
DONE = 0
NEEDS_ROOM = 1  # for hits or relations: `state["wanted_hits"]`, `state["wanted_relations"]`
NEEDS_PAIRS = 2  # for pairs of balls, cells or members: `state["wanted_*"]`
NOT_FINITE = 3  # the state is as it was before the step
REFUSED = 4  # a radius, mass, elasticity or friction was made what it may not be through a view
HAS_STRAYS = 5  # balls that left the bounds are to be removed; the step is complete
PAUSE = 6  # continuous: nothing, but a chance for Ctrl-C; call again
TOO_MANY_IMPACTS = 7  # continuous: a ball has reached `max_impacts`; the step ends at that instant

# Why the index of all shapes is to be made anew.
STALE = 1
OTHER_REACH = 2  # the shapes are as they were, the largest ball is not

# What was changed from outside, for which the next step wakes all balls.
NO_CHANGE = 0
CHANGED = 1  # anything but how kinematic shapes lie and move
MOTIONS_CHANGED = 2  # that too

# Which kinematic shapes were copied when a step began (continuous).
MOVERS = 0  # those that move
WHOLE = 1  # all
UNCHANGED = 2  # none: it changes no row but to show where a shape is

# Where a step is; a kernel that ran out of room goes on from here.
BEGIN = 0
MOVE = 1
SHAPES = 2
FIND_PAIRS = 3
PAIRS = 4
FINISH = 5
END = 6
TAKE_UP = 7  # continuous: flights go on, or begin anew where something was changed
FORESEE = 8
FLY = 9
SHOW = 10
NOTE = 11  # what balls in flight have begun to pass is noted, because something was changed


class StateRow(TypedDict):
    """Settings, time, counts, statistics, and the place of a step that was interrupted.

    There are two rows, the second of which is the copy that a step which fails is rolled back to.
    """

    # settings
    gravity_x: f8
    gravity_y: f8
    friction: f8
    sleep_speed: f8
    sleep_time: f8
    rest_speed: f8  # below 0: twice the speed that gravity adds in a substep
    max_speed: f8  # below 0: none
    left: f8
    bottom: f8
    right: f8
    top: f8
    max_impacts: i8
    substeps: i8
    iterations: i8
    levels: i8
    detection: i8
    broad_phase: i8
    total_restitution: i8
    bounded: i8
    remove_strays: i8
    # time
    time: f8
    time_low: f8  # what `time` lacks
    next_id: i8
    # statistics
    box_tests: i8
    full_tests: i8
    collisions: i8
    strays: i8
    overlaps: i8
    sleeping: i8
    held: i8
    squeezed: i8
    slowed: i8
    # counts of rows in use
    balls: i8
    shapes: i8
    dropped: i8  # of the shapes in `order`, how many are gone, and stand first
    fixed: i8  # how many of them are gone or static; the kinematic ones follow
    hits: i8
    relations: i8  # in use
    relations_high: i8  # rows of the pool ever used; those above are free
    free_relation: i4  # first of the released rows below `relations_high`, or NO_RELATION
    wake: i4  # what was changed from outside: 0, CHANGED or MOTIONS_CHANGED
    index_stale: i8  # whether the index of all shapes is to be made anew: 0, STALE or OTHER_REACH
    moving_stale: i8  # the same of that of the kinematic shapes: 0 or STALE
    taken: i8  # static shapes that are to be taken out of the index, and
    put: i8  # those that are to be put in: `order` names them behind all others, see `patch_index`
    reach: f8  # the largest radius that the index is to serve
    # the place of the step
    dt: f8
    steps_left: i8
    steps_made: i8  # since this was set to 0
    stop_hits: i8  # the steps end with the first one after which there are as many hits; 0: with none
    stage: i8
    stage_entered: i8  # whether what the stage does once is done
    substep: i8
    step_number: i8  # of this world's calls, steps counted; marks what a step has changed
    running: i8  # whether this is not the first step of a call, so that nothing was changed from outside
    foreseen: i8  # whether the queue holds what comes next
    now: f8  # the instant that is dealt with (continuous)
    now_low: f8
    horizon: f8  # the instant at which the step ends
    horizon_low: f8
    change: f8  # the instant at which the next shape stops or arrives; infinite if none does
    change_low: f8
    valid: f8  # the instant up to which the regions of kinematic shapes hold; infinite if no shape leaves its own
    valid_low: f8
    renewals: i8  # of those regions since the last event
    movers: i8  # kinematic shapes that do not rest, listed in `order` behind all shapes
    kept_whole: i8  # which kinematic shapes were copied when the step began: MOVERS, WHOLE or UNCHANGED
    events: i8  # since the kernel was called
    watched: i8  # one more than the ball whose first impact ends the step; 0 if none's does (continuous)
    queued: i8
    binned: i8
    bin_left: f8
    bin_bottom: f8
    bin_side: f8
    bin_stride: i8
    bin_mask: i8
    bin_levels: i8
    bin_least: f8  # the least width of cells of balls in flight; 0: as narrow as balls allow
    # what was done since the cells were fitted last: balls filed anew, predicted, and tested against each other
    bin_filings: i8
    bin_predictions: i8
    bin_tests: i8
    iteration: i8
    cursor: i8  # the ball or pair at which the stage goes on; in a beginning, how many balls it has moved (discrete)
    pairs: i8
    found: i8  # overlaps that this iteration has met
    met_noted: i8  # whether the step's beginning has moved the balls, and noted where they come to (discrete)
    near: i8  # balls that have a shape near, listed in the slots (discrete)
    grid_size: i8  # cells of a grid around all those places, laid ahead; 0: there is none (discrete)
    grid_stride: i8
    grid_mask: i8
    grid_left: f8
    grid_bottom: f8
    grid_side: f8
    doubtful: i8  # whether a ball may have come to be where numbers do not reach (discrete)
    step_hits: i8  # hits there were when the step began
    spent: i8  # shapes that have switched themselves off in this step
    outside: i8  # balls wholly outside of the bounds
    braked: i8  # balls with a friction of their own
    wanted_hits: i8
    wanted_relations: i8
    wanted_pairs: i8
    wanted_starts: i8
    wanted_cells: i8
    wanted_members: i8


STATE = dtype_of(StateRow)
