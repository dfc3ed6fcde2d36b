"""The rows of queries: what is asked, the grid that serves it, and what is answered."""

from typing import TypedDict

from carom.rows.tables import Table, dtype_of, f8, f8x2, i4, i8, u4


class QueryRow(TypedDict):
    """What a query asks, and what it sees. A box goes from x, y to to_x, to_y."""

    x: f8
    y: f8
    to_x: f8
    to_y: f8
    radius: f8
    layer: u4
    collides_with: u4
    sensors: i4


QUERY = dtype_of(QueryRow)


class SearchGridRow(TypedDict):
    """Where a grid lies that serves queries: its corner, the width of its cells, and how many there are."""

    left: f8
    bottom: f8
    side: f8
    columns: i8
    lines: i8


SEARCH_GRID = dtype_of(SearchGridRow)

#: A grid of items, shapes and balls: where it lies, where each cell's members begin, and the members.
SearchGrid = tuple[SearchGridRow, Table[int], Table[int]]


class CastRow(TypedDict):
    """A row of `CAST_HIT`."""

    shape: i8
    fraction: f8
    point: f8x2
    normal: f8x2


CAST_HIT = dtype_of(CastRow)


class NeighborRow(TypedDict):
    """A row of `NEIGHBOR`."""

    shape: i8
    distance: f8
    point: f8x2


NEIGHBOR = dtype_of(NeighborRow)


class InBoxRow(TypedDict):
    """A row of `IN_BOX`."""

    box: i8
    shape: i8


IN_BOX = dtype_of(InBoxRow)


class ContactRow(TypedDict):
    """A row of `CONTACT`."""

    shape: i8
    ball: i8
    point: f8x2
    normal: f8x2
    setback: f8
    speed: f8


CONTACT = dtype_of(ContactRow)


class AimRow(TypedDict):
    """A row of `AIM`."""

    ball: i8
    shape: i8
    time: f8
    start: f8x2
    ghost: f8x2
    distance: f8
    point: f8x2
    normal: f8x2
    direction: f8x2
    speed: f8
    other_direction: f8x2
    other_speed: f8


AIM = dtype_of(AimRow)
