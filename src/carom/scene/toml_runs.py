"""TOML with long runs of tables of a list, such as `[[balls]]` a hundred thousand times, read in a tenth of the time.

A run of plain tables, one number, pair, switch or word a line, is rewritten as JSON, whose reader is quicker. All else,
with the first and the last table of the run in their places, is left to TOML's own reader, which so sees everything
that can be wrong; where it objects, or anything is not as expected, it reads the whole text.
"""

from __future__ import annotations

import json
import re
import tomllib
from typing import Any

#: Fewer tables in a row than this are not worth it.
SHORTEST_RUN = 500

_NUMBER = r"-?(?:0|[1-9]\d{0,17})(?:\.\d+)?(?:[eE][-+]?\d{1,3})?"
_VALUE = rf'(?:{_NUMBER}|\[ *{_NUMBER} *, *{_NUMBER} *\]|true|false|"[A-Za-z0-9 .,_\-]*")'
_LINE = rf"[a-z_]+ = {_VALUE}\n"
_TABLE = rf"\n(?:{_LINE})++\n*+"


def run_of(shortest: int) -> re.Pattern[str]:
    """What finds a run of more than `shortest` tables of one list, whose name is the first group."""
    again = rf"(?:\[\[\1\]\]{_TABLE})"
    return re.compile(rf"^\[\[(balls|shapes)\]\]{_TABLE}{again}{{{shortest},}}+", re.MULTILINE)


_RUN = run_of(SHORTEST_RUN)
_NAMES = re.compile(r"^([a-z_]+) = ", re.MULTILINE)
#: The mark in the first table of a run, which is left to TOML's reader; no name in a run has a colon.
_MARK = "run:"


def read_toml(text: str) -> dict[str, Any]:
    """The table that a TOML text holds; raises `tomllib.TOMLDecodeError` as TOML's own reader does."""
    run = _RUN.search(text) if text.count("\n[[") >= SHORTEST_RUN else None
    if run is not None:
        table = _read_around(text, run)
        if table is not None:
            return table
    return tomllib.loads(text)


def _read_around(text: str, run: re.Match[str]) -> dict[str, Any] | None:
    """The table that `text` holds with its run, or None where that is better left to TOML's reader."""
    heading = f"[[{run[1]}]]\n"
    tables = run[0].split(heading)[1:]
    middle = _tables_of(tables[1:-1])
    mark = _MARK + run[1]
    if middle is None or mark in text:
        return None
    first, last = heading + f'"{mark}" = 1\n' + tables[0], heading + tables[-1]
    try:
        table = read_toml(text[: run.start()] + first + last + text[run.end() :])
    except ValueError:
        return None
    items = table.get(run[1])
    if not isinstance(items, list):
        return None
    places = [place for place, item in enumerate(items) if mark in item]
    if not places:
        return None
    del items[places[0]][mark]
    items[places[0] + 1 : places[0] + 1] = middle
    return table


def _tables_of(texts: list[str]) -> list[dict[str, Any]] | None:
    """The tables of a run, or None where one has a name twice."""
    lines = "\n" + "},{\n".join(texts)
    names = set(_NAMES.findall(lines))
    # Words hold no equals signs, quotes or braces, so these are all the names that there are.
    count = lines.count(" = ")
    for name in names:
        lines = lines.replace(f"\n{name} = ", f',"{name}":')
    tables: list[dict[str, Any]] = json.loads("[{" + lines.replace("\n", "").replace("{,", "{")[1:] + "}]")
    return tables if sum(map(len, tables)) == count else None
