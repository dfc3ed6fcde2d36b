"""Tables: a shape's or ball's row, wherever it is kept, as a view that can be written to."""

import numpy as np

from carom import Ball, Point
from carom.rows.ball import BALL
from carom.rows.shape import SHAPE
from carom.shapes.table import RowTable, put_fields, word_of


class Owner:
    """What a table knows of whose row it is asked for."""

    def __init__(self, index: int) -> None:
        self._index = index
        self._id: int | None = None


def test_copies_of_rows_are_equal_and_apart() -> None:
    for thing in (Ball((1, 2), 3), Point((1, 2))):
        table = RowTable(np.array([thing._row, thing._row]))
        for row in (RowTable.of_row(thing._row).rows[0], table.copied(Owner(1))):
            assert row.dtype == thing._row.dtype
            assert row.tobytes() == thing._row.tobytes()
            row["elasticity"] = 0.5
        assert table.rows["elasticity"].tolist() == [1.0, 1.0]


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


def test_words_are_read_and_written_as_fields_are() -> None:
    table = RowTable(np.zeros(3, BALL))
    owner, word = Owner(1), word_of(BALL, "vx")
    table.rows["vx"], table.rows["id"], table.rows["sensor"] = [1, 2, 3], [4, 5, 6], [0, 1, 0]
    at = table.at(owner)
    assert (table.floats[at + word], table.whole[at + word_of(BALL, "id")]) == (2.0, 5)
    assert table.octets[8 * at + BALL.fields["sensor"][1]] == 1
    table.floats[at + word] = -0.5
    assert table.rows["vx"].tolist() == [1, -0.5, 3]
    assert all(table.rows[field].tolist() == [0, 0, 0] for field in ("x", "y", "vy", "radius"))


def test_words_are_those_of_the_rows_that_are_there_now() -> None:
    table = RowTable(np.zeros(2, BALL))
    owner = Owner(0)
    at = table.at(owner)
    assert table.floats[at] == 0.0
    table.rows = np.ones(2, BALL)
    at = table.at(owner)
    assert table.floats[at] == 1.0
    table.rows = np.full(2, 2, BALL)
    at = table.at(owner)
    table.floats[at], table.floats[at + 1] = 3.0, 4.0
    assert (table.rows["x"].tolist(), table.rows["y"].tolist()) == ([3, 2], [4, 2])


def test_every_field_has_its_word() -> None:
    for dtype in (BALL, SHAPE):
        rows = np.zeros(1, dtype)
        for name in dtype.names:
            if dtype[name] == np.float64:
                rows[name] = 0.5
                assert rows.view(np.float64)[word_of(dtype, name)] == 0.5
                rows[name] = 0.0
