"""The row of what a step changes in a ball."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4, u1

# What a ball that a response has moved is still to be tested against.
SHAPES_DUE = 1
PAIRS_DUE = 2
COUNTED = 4  # not due, but done: it was counted as squeezed in this substep
MET = 8  # it has overlapped a shape when it met the shapes last
CROWDED = 16  # more than one, or one so deep or with so little room that it may be near the side of another
KEPT = 32  # continuous: it is on its flight still, which sees to shallow overlaps, and to all with others that are

#: All of these but that pairs are due, or but that it is on its flight still.
BUT_PAIRS, BUT_KEPT = 255 - PAIRS_DUE, 255 - KEPT


class SavedRow(TypedDict):
    """What a step changes in a ball, kept so that a step that fails leaves the state as it was."""

    x: f8
    y: f8
    vx: f8
    vy: f8
    still_time: f8
    met_x: f8  # where it was when it had met the shapes last
    met_y: f8
    relation: i4
    asleep: u1
    stray: u1
    touched: u1  # what a response has made necessary again: SHAPES_DUE, PAIRS_DUE; and the others
    overflowed: u1  # the ball was not finite when a step was undone


SAVED = dtype_of(SavedRow)
