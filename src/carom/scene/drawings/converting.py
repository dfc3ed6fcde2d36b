"""Drawings as scenes that a person can read: with numbers as long as they say something.

Numbers are rounded to the power of ten below the tolerance. An outline with an arc in it keeps more digits, for there a
straight piece goes on smoothly into an arc, and rounding would bend that joint, or open it.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from math import ceil, cos, floor, log10, sin
from typing import Any

from carom.errors import SceneError
from carom.scene.drawings.reading import read_drawing
from carom.scene.scene import Scene

#: Digits, in the drawing's size, that the places of an outline with arcs keep: a joint is then as smooth as before.
SEAMLESS = 13
#: The fields that are lengths or places.
_LENGTHS = ("position", "start", "end", "center", "radius", "pivot")
_ANGLES = ("start_angle", "end_angle")

Table = dict[str, Any]


def converted(path: str | os.PathLike[str], tolerance: float | None = None) -> Scene:
    """The scene that a drawing shows, with its numbers rounded; raises `SceneError`."""
    try:
        read = read_drawing(path, tolerance)
        if not read.lists:
            return Scene(**read.table)
        shapes = [shape.plain() for shape in read.lists["shapes"]]
        balls = [ball.plain() for ball in read.lists["balls"]]
        coarse = digits_of(read.tolerance)
        fine = SEAMLESS - ceil(log10(max(map(abs, _numbers_in([*shapes, *balls])), default=1.0) or 1.0))
        lists = [shapes, *(shape["shapes"] for shape in shapes if shape["kind"] == "compound")]
        seamless = {id(table) for tables in lists for table in _with_arcs(tables, read.tolerance)}
        for tables in (*lists, balls):
            for table in tables:
                round_table(table, fine if id(table) in seamless else coarse, fine)
        return Scene(**read.table, shapes=shapes, balls=balls)
    except SceneError as error:
        raise SceneError(f"{os.fspath(path)}: {error}") from None


def digits_of(tolerance: float) -> int:
    """Digits after the point of numbers that are rounded to a tolerance."""
    return -floor(log10(tolerance)) if tolerance > 0.0 else SEAMLESS


def round_table(table: Table, digits: int, fine: int) -> None:
    """Round what is a length or a place in the table of a shape or ball, as far as it stays a shape."""
    rounded = {name: _rounded(table[name], digits) for name in _LENGTHS if name in table}
    if rounded.get("radius", 1.0) <= 0.0 or ("end" in rounded and rounded["start"] == rounded["end"]):
        rounded = {name: _rounded(table[name], fine) for name in rounded}
    table |= rounded | {name: round(table[name], SEAMLESS) for name in _ANGLES if name in table}


def _rounded(value: Any, digits: int) -> Any:
    """A number or a pair of them, rounded, without a minus before 0."""
    return [round(one, digits) + 0.0 for one in value] if isinstance(value, list) else round(value, digits) + 0.0


def _numbers_in(tables: Iterable[Table]) -> Iterable[float]:
    """All numbers that are lengths or places."""
    for table in tables:
        for name in _LENGTHS:
            value = table.get(name, ())
            yield from value if isinstance(value, list) else ([value] if value != () else [])
        yield from _numbers_in(table.get("shapes", ()))


def _with_arcs(tables: list[Table], tolerance: float) -> list[Table]:
    """The tables of outlines that have an arc: those whose ends meet, from one to the next, an arc among them."""
    near = 1e-6 * tolerance
    ends: dict[tuple[int, int], list[int]] = {}
    places = [[(round(x / near), round(y / near)) for x, y in _ends_of(table)] for table in tables]
    for row, keys in enumerate(places):
        for key in keys:
            ends.setdefault(key, []).append(row)
    found = {row for row, table in enumerate(tables) if table["kind"] == "arc"}
    waiting = sorted(found)
    while waiting:
        for column, line in places[waiting.pop()]:
            for key in ((column + i, line + j) for i in (-1, 0, 1) for j in (-1, 0, 1)):
                new = [row for row in ends.pop(key, ()) if row not in found]
                found.update(new)
                waiting += new
    return [tables[row] for row in sorted(found)]


def _ends_of(table: Table) -> list[tuple[float, float]]:
    """The ends of a segment, gate or arc, and the place of a point."""
    if table["kind"] == "arc":
        (x, y), radius = table["center"], table["radius"]
        return [(x + radius * cos(table[name]), y + radius * sin(table[name])) for name in _ANGLES]
    return [(table[name][0], table[name][1]) for name in ("start", "end", "position") if name in table]
