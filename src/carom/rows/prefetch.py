"""What a processor can be told of the memory that it will need: a request of which nothing but the speed depends."""

from __future__ import annotations

from typing import Any

from carom.rows.tables import Table


def prefetch(table: Table[Any], place: int) -> None:
    """Have the processor bring the row at a place of a table near; nothing waits for it, there need be no such row.

    Of a row that is longer than a line of memory, its beginning.
    """


def prefetch_lines(table: Table[Any], place: int, count: int) -> None:
    """The same of so many lines of a row, from its beginning."""
