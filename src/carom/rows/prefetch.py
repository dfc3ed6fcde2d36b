"""What a processor can be told of the memory that it will need: a request of which nothing but the speed depends."""

from __future__ import annotations

from typing import Any

from carom.rows.tables import Table


def prefetch(table: Table[Any], place: int) -> None:
    """Have the processor bring the row at a place of a table near; nothing waits for it, there need be no such row."""
