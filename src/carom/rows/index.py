"""The rows of the broad phase: an index of shapes, its cells, and balls sorted by cell."""

from typing import TypedDict

from carom.rows.tables import Pairs, Table, dtype_of, f8, i4, i8, u4

NO_CHILD = -1


class IndexRow(TypedDict):
    """Where the candidates for a place are found: one row for the static shapes, one for the kinematic."""

    left: f8
    bottom: f8
    right: f8
    top: f8
    side: f8  # of a grid's cell
    reach: f8  # the largest radius of a ball that it serves
    free_left: f8  # a rectangle in which a ball's centre has no static shape's box in reach: see `find_free`
    free_bottom: f8
    free_right: f8
    free_top: f8
    longest: i8  # members of the fullest cell
    measured: i8  # whether it is known how far a grid's cells are from those with members: `clear`
    columns: i8
    lines: i8
    cells_begin: i8
    cells_end: i8
    members_begin: i8
    members_end: i8
    phase: i8  # what its cells are: BRUTE, GRID or QUADTREE
    # of the regions of kinematic shapes
    shown: i8  # whether rows showed where shapes were when they were found, and not where their motion began
    swept: i8  # whether a list may hold what is not near now, so that box tests count where boxes meet alone
    span: f8  # seconds for which they hold: from when they were found (continuous) or now on (discrete); 0: as places
    widest: f8  # a shape that moves in a wider one is in the list of those which are asked everywhere; below 0: all are
    wide_begin: i8  # where that list is
    wide_end: i8
    resting: i8  # shapes at rest that are not in it
    moving: i8
    # of kinematic shapes that are left alone in a step while no ball is near (discrete)
    calm: i8  # how many there are, the last ones of those that do not rest
    owed: i8  # substeps that are to be made up for
    calm_left: f8  # the box that no ball may come out of
    calm_bottom: f8
    calm_right: f8
    calm_top: f8


INDEX = dtype_of(IndexRow)


class CellRow(TypedDict):
    """A node of a quadtree (its centre, the first of its four children) or a cell of a grid, and its members."""

    x: f8
    y: f8
    child: i4
    begin: i4
    end: i4
    depth: i4  # in a quadtree; of a grid's cell, members that are to come
    clear: i8  # of a grid's cell: how wide squares from it on are without members, at most: see `measure_clear`
    marks: i8  # of a grid's cell: a bit for each of its parts, set where the box of a member is in reach


CELL = dtype_of(CellRow)


class SlotRow(TypedDict):
    """A ball as the grid sorts it by cell, so that neighbours in space are neighbours in memory."""

    x: f8
    y: f8
    radius: f8
    ball: u4
    cell: u4


SLOT = dtype_of(SlotRow)


#: What answers which shapes a ball may meet: the two indexes, their cells, and the rows of shapes in each cell.
ShapeIndex = tuple[Table[IndexRow], Table[CellRow], Table[int]]

#: Where the pairs of balls that may meet are looked for: the balls sorted by cell, where each cell begins, the pairs.
PairTables = tuple[Table[SlotRow], Table[int], Pairs]
