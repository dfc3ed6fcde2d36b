"""The dtypes of a world's tables besides its shapes and balls, and the numbers that kernels and `World` exchange."""

from __future__ import annotations

import numpy as np

# What a hit is (`HitKind` names them for users).
BOUNCE = 0
ENTER = 1
EXIT = 2

# What a relation is: a state of a ball and another row that outlives a substep.
PASSING = 0  # the ball passes a segment, arc or gate, whichever way it leaves
INSIDE_SHAPE = 1  # the ball and a shape overlap, and one of them is a sensor
INSIDE_BALL = 2  # the same for two balls
LASTING = 3  # the ball rests on a shape, rolls on it or slides along it (continuous)

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

# Where a step is; a kernel that ran out of room goes on from here.
BEGIN = 0
MOVE = 1
SHAPES = 2
FIND_PAIRS = 3
PAIRS = 4
FINISH = 5
END = 6
SPAN = 7  # continuous: shapes and balls are set going
FORESEE = 8
FLY = 9

NO_CHILD = -1

# What comes next in a ball's flight.
NOTHING = 0
LOOK = 1  # it is filed anew and looks around anew
LEAVE = 2  # it comes to the end of the segment that it rests on
HIT_SHAPE = 3
HIT_BALL = 4

# How a ball takes part in a span.
FLYING = 0
ASLEEP = 1
STALLED = 2  # it has reached `max_impacts` and stands still for the rest of the substep

NO_PLACE = -1  # of a ball that is not in the queue of events
NO_BALL = -1

# What a ball that a response has moved is still to be tested against.
SHAPES_DUE = 1
PAIRS_DUE = 2
COUNTED = 4  # not due, but done: it was counted as squeezed in this substep
MET = 8  # it has overlapped a shape when it met the shapes last
CROWDED = 16  # more than one, or one so deep or with so little room that it may be near the side of another

#: Settings, time, counts, statistics and the place of a step that was interrupted: a table of two rows, the second of
#: which is the copy that a step which fails is rolled back to.
STATE = np.dtype(
    [
        # settings
        ("gravity_x", "f8"),
        ("gravity_y", "f8"),
        ("friction", "f8"),
        ("sleep_speed", "f8"),
        ("sleep_time", "f8"),
        ("rest_speed", "f8"),  # below 0: twice the speed that gravity adds in a substep
        ("max_speed", "f8"),  # below 0: none
        ("left", "f8"),
        ("bottom", "f8"),
        ("right", "f8"),
        ("top", "f8"),
        ("max_impacts", "i8"),
        ("substeps", "i8"),
        ("iterations", "i8"),
        ("levels", "i8"),
        ("detection", "i8"),
        ("broad_phase", "i8"),
        ("total_restitution", "i8"),
        ("bounded", "i8"),
        ("remove_strays", "i8"),
        # time
        ("time", "f8"),
        ("next_id", "i8"),
        # statistics
        ("box_tests", "i8"),
        ("full_tests", "i8"),
        ("collisions", "i8"),
        ("strays", "i8"),
        ("overlaps", "i8"),
        ("sleeping", "i8"),
        ("stalled", "i8"),
        ("squeezed", "i8"),
        ("slowed", "i8"),
        # counts of rows in use
        ("balls", "i8"),
        ("shapes", "i8"),
        ("fixed", "i8"),  # of the shapes in `order`, how many are static; the kinematic ones follow
        ("hits", "i8"),
        ("relations", "i8"),  # in use
        ("relations_high", "i8"),  # rows of the pool ever used; those above are free
        ("free_relation", "i4"),  # first of the released rows below `relations_high`, or NO_RELATION
        ("wake", "i4"),  # something was changed from outside
        ("index_stale", "i8"),  # the index of all shapes must be made anew
        ("moving_stale", "i8"),  # that of the kinematic shapes must
        ("reach", "f8"),  # the largest radius that the index is to serve
        # the place of the step
        ("dt", "f8"),
        ("steps_left", "i8"),
        ("stage", "i8"),
        ("stage_entered", "i8"),  # whether what the stage does once is done
        ("substep", "i8"),
        ("span_begin", "f8"),  # of the substep that is done when the span begins, in seconds
        ("span", "f8"),  # its length: the substep, or until the next shape stops or arrives
        ("queued", "i8"),
        ("swept", "i8"),  # whether `pairs` are all that may meet in the span, if nothing changes a path
        ("binned", "i8"),
        ("bin_left", "f8"),
        ("bin_bottom", "f8"),
        ("bin_side", "f8"),
        ("bin_stride", "i8"),
        ("bin_mask", "i8"),
        ("bin_levels", "i8"),
        ("iteration", "i8"),
        ("cursor", "i8"),  # the ball or pair at which the stage goes on
        ("pairs", "i8"),
        ("found", "i8"),  # overlaps that this iteration has met
        ("step_hits", "i8"),  # hits there were when the step began
        ("outside", "i8"),  # balls wholly outside of the bounds
        ("braked", "i8"),  # balls with a friction of their own
        ("wanted_hits", "i8"),
        ("wanted_relations", "i8"),
        ("wanted_pairs", "i8"),
        ("wanted_starts", "i8"),
        ("wanted_cells", "i8"),
        ("wanted_members", "i8"),
    ]
)

HIT = np.dtype(
    [
        ("time", "f8"),
        ("kind", "i8"),
        ("ball", "i8"),
        ("shape", "i8"),
        ("point", "f8", (2,)),
        ("normal", "f8", (2,)),
        ("setback", "f8"),
        ("speed", "f8"),
        ("impulse", "f8"),
    ]
)

#: A hit as the kernels write it: the same bytes, each number a field of its own.
HIT_ROW = np.dtype(
    [
        ("time", "f8"),
        ("kind", "i8"),
        ("ball", "i8"),
        ("shape", "i8"),
        ("point_x", "f8"),
        ("point_y", "f8"),
        ("normal_x", "f8"),
        ("normal_y", "f8"),
        ("setback", "f8"),
        ("speed", "f8"),
        ("impulse", "f8"),
    ]
)

RELATION = np.dtype([("kind", "i4"), ("ball", "i4"), ("other", "i4"), ("next", "i4")])

#: Where the candidates for a place are found: a table of two rows, one for the static shapes, one for the kinematic.
INDEX = np.dtype(
    [
        ("left", "f8"),
        ("bottom", "f8"),
        ("side", "f8"),  # of a grid's cell
        ("reach", "f8"),  # the largest radius of a ball that it serves
        ("longest", "i8"),  # members of the fullest cell
        ("columns", "i8"),
        ("lines", "i8"),
        ("cells_begin", "i8"),
        ("cells_end", "i8"),
        ("members_begin", "i8"),
        ("members_end", "i8"),
    ]
)

#: A node of a quadtree (with its centre and the first of its four children) or a cell of a grid, and its members.
CELL = np.dtype([("x", "f8"), ("y", "f8"), ("child", "i4"), ("begin", "i4"), ("end", "i4"), ("depth", "i4")])

#: A ball as the grid sorts it by cell, so that neighbours in space are neighbours in memory.
SLOT = np.dtype([("x", "f8"), ("y", "f8"), ("radius", "f8"), ("ball", "i4"), ("cell", "i4")])

#: What a step changes in a ball, kept so that a step that fails leaves the state as it was.
SAVED = np.dtype(
    [
        ("x", "f8"),
        ("y", "f8"),
        ("vx", "f8"),
        ("vy", "f8"),
        ("still_time", "f8"),
        ("met_x", "f8"),  # where it was when it had met the shapes last
        ("met_y", "f8"),
        ("relation", "i4"),
        ("asleep", "u1"),
        ("stray", "u1"),
        ("touched", "u1"),  # what a response has made necessary again: SHAPES_DUE, PAIRS_DUE; COUNTED, MET, CROWDED
        ("overflowed", "u1"),  # the ball was not finite when a step was undone
    ]
)

#: A ball's flight in a span of a substep (continuous).
FLIGHT = np.dtype(
    [
        ("time", "f8"),  # of the span, at which the ball is where its row says
        ("ax", "f8"),
        ("ay", "f8"),
        ("energy", "f8"),  # per mass, while it slides along shapes at rest
        ("patience", "f8"),  # until when it does not look for impacts with balls that are patient too
        ("event_time", "f8"),
        ("bin_x", "f8"),
        ("bin_y", "f8"),
        ("event", "i4"),
        ("partner", "i4"),
        ("partner_version", "i4"),
        ("version", "i4"),  # changes with the path
        ("place", "i4"),  # in the queue
        ("kind", "i4"),
        ("impacts", "i4"),
        ("level", "i4"),
        ("cell", "i4"),
        ("next", "i4"),  # in the same cell
    ]
)
