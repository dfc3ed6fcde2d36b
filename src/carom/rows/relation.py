"""The rows of relations: states of a ball and another row that outlive a substep."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4

NO_RELATION = -1

# What a relation is: a state of a ball and another row that outlives a substep.
PASSING = 0  # the ball passes a segment, arc or gate, whichever way it leaves
INSIDE_SHAPE = 1  # the ball and a shape overlap, and one of them is a sensor
INSIDE_BALL = 2  # the same for two balls
LASTING = 3  # the ball rests on a shape, rolls on it or slides along it (continuous)
LYING = 4  # two balls are pressed together, and both have the relation to each other (continuous)


class RelationRow(TypedDict):
    """A row of `RELATION`."""

    force_x: f8  # with which the other presses the ball, over the tick of its island; 0 outside of islands
    force_y: f8
    kind: i4
    ball: i4
    other: i4
    next: i4


RELATION = dtype_of(RelationRow)
