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
        """Called after a member's row was changed from outside, with the member."""


class RowTable(Generic[R]):
    """Rows of one dtype, and which of them is whose. `rows` may be longer than what is in use.

    A world's table overrides `index`, where rows move: it finds the row of `owner._id`, or of `owner._index`.
    """

    __slots__ = ("rows",)

    def __init__(self, rows: Rows) -> None:
        self.rows = rows

    @classmethod
    def of_one(cls, dtype: np.dtype[Any]) -> Self:
        """A table of one row, all zeros."""
        return cls(np.zeros(1, dtype))

    def index(self, owner: Owner) -> int:
        """The index of `owner`'s row in `rows`."""
        return owner._index

    def row(self, owner: Owner) -> R:
        """`owner`'s row, as a view that can be written to."""
        row: R = self.rows[self.index(owner)]
        return row

    def write(self, owner: Owner, row: R) -> None:
        """Copy the fields of `row` into `owner`'s row."""
        self.rows[self.index(owner)] = row


def put_fields(row: Any, fields: Mapping[str, object]) -> None:
    """Write some fields of a row, which the caller's own types say that it has."""
    for field, value in fields.items():
        row[field] = value
