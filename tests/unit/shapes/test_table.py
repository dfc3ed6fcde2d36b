"""Tables: a shape's or ball's row, wherever it is kept, as a view that can be written to."""

import numpy as np

from carom import Ball, Point
from carom.rows.ball import BALL
from carom.rows.shape import SHAPE
from carom.shapes.table import RowTable, put_fields


class Owner:
    """What a table knows of whose row it is asked for."""

    def __init__(self, index: int) -> None:
        self._index = index
        self._id: int | None = None


def test_a_table_of_one_row_is_all_zeros() -> None:
    for dtype in (BALL, SHAPE):
        table = RowTable.of_one(dtype)
        assert (len(table.rows), table.rows.dtype) == (1, dtype)
        assert table.rows.tobytes() == bytes(dtype.itemsize)


def test_a_row_is_a_view_and_writing_copies_into_it() -> None:
    table = RowTable(np.zeros(3, BALL))
    first, second = Owner(0), Owner(2)
    table.row(second)["x"] = 7.0
    assert table.rows["x"].tolist() == [0, 0, 7]
    given = table.row(second).copy()
    table.write(first, given)
    given["x"] = 9.0
    assert table.rows["x"].tolist() == [7, 0, 7]
    assert [table.index(owner) for owner in (first, second)] == [0, 2]


def test_a_lone_shape_has_a_table_of_its_own() -> None:
    one, other = Ball((0, 0), 1), Ball((5, 5), 1)
    one.radius = 2
    assert other.radius == 1
    assert not np.shares_memory(Point((0, 0))._table.rows, Point((0, 0))._table.rows)


def test_fields_are_put_into_a_row_by_name() -> None:
    row = Ball((0, 0), 1)._row
    put_fields(row, {"x": 2.0, "mass": 5.0})
    assert (row["x"], row["y"], row["mass"]) == (2.0, 0.0, 5.0)
