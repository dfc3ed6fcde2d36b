"""Where rows live: a lone shape or ball owns a table of one row, a world has two tables for all of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Generic, Protocol, Self, TypeVar

import numpy as np

from carom.rows.tables import Numbered, Rows
from carom.turns import Turn

#: A row of shapes or of balls.
R = TypeVar("R", bound=Numbered)


class Owner(Protocol):
    """What a table knows of the shapes and balls that are views of its rows."""

    _index: int
    _id: int | None


class Home(Protocol):
    """What a shape or ball knows of the world that it is in."""

    _turn: Turn

    def _changed(self, member: Any) -> None:
        """Called after a member's row was changed from outside."""

    def _note_change(self) -> None:
        """Called instead where a ball was put elsewhere or was set to move otherwise, and nothing else was."""

    def _set_going(self) -> None:
        """Called instead where shapes were set to move otherwise, and are where they were."""

    def _moved(self, shape: Any, before: Any) -> None:
        """Called instead where that may say where and how a shape lies or moves, with the row that it had."""


class RowTable(Generic[R]):
    """Rows of one dtype, and which of them is whose. `rows` may be longer than what is in use.

    A world's table overrides `at`, where rows move: it finds the row of `owner._id`, or of `owner._index`.

    What is read and written all the time goes by words of 64 bits, not by fields of records, which take NumPy several
    times as long.

    Attributes:
        floats: All rows as floats, from the one that `at` names on.
        whole: The same as whole numbers.
        octets: The same as bytes, eight for each of the others.
        width: How many words of 64 bits a row has.
    """

    __slots__ = ("_seen", "floats", "octets", "rows", "whole", "width")

    floats: memoryview[float]
    whole: memoryview[int]
    octets: memoryview[int]

    def __init__(self, rows: Rows) -> None:
        self.rows = rows
        self._seen: Rows | None = None
        self.width = rows.dtype.itemsize // 8

    @classmethod
    def of_row(cls, row: R) -> Self:
        """A table of one row, a copy of another."""
        rows: Any = row
        # By bytes: NumPy copies structured rows field by field.
        return cls(np.frombuffer(bytearray(rows.tobytes()), rows.dtype))

    def at(self, owner: Owner) -> int:
        """The word of `floats` and `whole` at which `owner`'s row begins; to be asked before these are read."""
        if self._seen is not self.rows:
            self._look()
        return owner._index * self.width

    def index(self, owner: Owner) -> int:
        """The index of `owner`'s row in `rows`."""
        return self.at(owner) // self.width

    def row(self, owner: Owner) -> R:
        """`owner`'s row, as a view that can be written to."""
        row: R = self.rows[self.index(owner)]
        return row

    def copied(self, owner: Owner) -> R:
        """A copy of `owner`'s row."""
        at = self.at(owner)
        row: R = np.frombuffer(bytearray(self.whole[at : at + self.width]), self.rows.dtype)[0]
        return row

    def _look(self) -> None:
        """Make the words be those of the rows, which were replaced."""
        self.floats = memoryview(self.rows.view(np.float64))  # type: ignore[arg-type]
        self.whole = memoryview(self.rows.view(np.int64))  # type: ignore[arg-type]
        self.octets = memoryview(self.rows.view(np.uint8))  # type: ignore[arg-type]
        self._seen = self.rows

    def write(self, owner: Owner, row: R) -> bool:
        """Whether that was another one: `row` is `owner`'s row from here on."""
        at = self.at(owner)
        given: Any = row
        before, after = self.octets[8 * at : 8 * (at + self.width)], given.tobytes()
        if before == after:
            return False
        before[:] = after
        return True


def word_of(dtype: np.dtype[Any], field: str) -> int:
    """Which 64-bit word of a row a field is."""
    fields: Any = dtype.fields
    return int(fields[field][1]) // 8


def put_fields(row: Any, fields: Mapping[str, object]) -> None:
    """Write some fields of a row, which the caller's own types say that it has."""
    for field, value in fields.items():
        row[field] = value
