"""Tables of hits, balls and shapes for notebooks: as much as one looks at, with names for ids."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from carom.rows.hit import HIT
from carom.shapes.shape import Shape
from carom.world.hits import HitKind
from carom.world.plural import MemberRows
from carom.world.views import Balls, Shapes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.pictured import Tabled

    #: The words of a row, cell by cell.
    Row: TypeAlias = list[str]

#: How many rows are shown at most: so many of the first, and so many of the last ones.
FIRST, LAST = 10, 5
#: Columns that hold the ids of shapes and balls.
MEMBERS = {"shape", "ball"}
BALL_COLUMNS = ("id", "name", "position", "velocity", "radius", "mass", "asleep")
SHAPE_COLUMNS = ("id", "kind", "name", "position", "motion", "elasticity", "kick", "sensor")


def table_of(shown: Tabled) -> str | None:
    """What a notebook shows of hits, answers, balls or shapes, as HTML; None for an array that has no such rows."""
    if isinstance(shown, MemberRows):
        return table_of_rows(shown) if shown.dtype == shown.DTYPE and shown.ndim == 1 else None
    if isinstance(shown, Balls):
        rows = [ball_row(shown, place) for place in shown_places(len(shown))]
        return html(counted(len(shown), "balls"), BALL_COLUMNS, rows, len(shown))
    if isinstance(shown, Shapes):
        rows = [shape_row(shown, place) for place in shown_places(len(shown))]
        return html(counted(len(shown), "shapes"), SHAPE_COLUMNS, rows, len(shown))
    raise TypeError(f"there are no tables of a {type(shown).__name__}")


def shown_places(count: int) -> Sequence[int]:
    """The places of the rows that are shown, of so many."""
    return range(count) if count <= FIRST + LAST else (*range(FIRST), *range(count - LAST, count))


def html(caption: str, columns: Sequence[str], rows: Sequence[Row], count: int) -> str:
    """A table of HTML, with a line of dots where rows are left out."""
    lines = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows]
    if count > len(rows):
        lines.insert(FIRST, f"<tr>{'<td>…</td>' * len(columns)}</tr>")
    head = "".join(f"<th>{escape(column)}</th>" for column in columns)
    body = "".join(lines)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def counted(count: int, what: str) -> str:
    """How many rows there are of what."""
    return f"{count:,} {what}" if count != 1 else f"1 {what.removesuffix('s')}"


def table_of_rows(shown: MemberRows) -> str:
    """The table of hits, touches, counts, or answers to queries."""
    columns = shown.dtype.names or ()
    rows = shown.view(np.ndarray)
    cells = [[cell(shown, column, rows[place][column]) for column in columns] for place in shown_places(len(rows))]
    what = "hits" if shown.DTYPE == HIT else type(shown).__name__.lower()
    return html(counted(len(rows), what), columns, cells, len(rows))


def cell(shown: MemberRows, column: str, value: Any) -> str:
    """The words for one field of a row: names for ids, and few digits for numbers."""
    if column in MEMBERS:
        return shown._label(int(value)) if value else ""
    if column == "kind":
        return HitKind(int(value)).name.lower()
    return words(value)


def words(value: Any) -> str:
    """A number or a vector in few digits, anything else as it is."""
    if isinstance(value, np.ndarray | tuple):
        return f"({', '.join(words(part) for part in value)})"
    return f"{value + 0.0:.4g}" if isinstance(value, float | np.floating) else f"{value}"


def ball_row(balls: Balls, place: int) -> Row:
    """The words of one ball's row."""
    ball, name = balls._glance(place)
    numbers = ((ball["x"], ball["y"]), (ball["vx"], ball["vy"]), ball["radius"], ball["mass"])
    return [f"{ball['id']}", name or "", *map(words, numbers), "asleep" if ball["asleep"] else ""]


def shape_row(shapes: Shapes, place: int) -> Row:
    """The words of one row of a shape, compound or group."""
    shape = shapes[place]
    if isinstance(shape, Shape):
        values = (
            shape.position,
            shape.motion.name.lower(),
            shape.elasticity,
            shape.kick,
            "yes" if shape.sensor else "",
        )
        return [f"{shape.id}", shape.kind, shape.name or "", *map(words, values)]
    kind = f"{type(shape).__name__.lower()} of {len(shape.shapes)}"
    return ["", kind, shape.name or "", *[""] * (len(SHAPE_COLUMNS) - 3)]
