"""Scene files: TOML and JSON to and from plain tables, and saving that leaves no half of a file behind."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from secrets import token_hex
from typing import Any, TypeAlias

import tomli_w

from carom import checks
from carom.errors import InvalidArgument, SceneError
from carom.limits import LONGEST_FILE
from carom.scene.scanning import check_json, check_toml
from carom.scene.toml_runs import read_toml

Plain: TypeAlias = dict[str, Any]


def read_plain(path: str | os.PathLike[str]) -> Plain:
    """The table that a `.toml` or `.json` file holds; raises `SceneError`, with path and place, where that fails."""
    read, _ = _form_of(path)
    text = _text_of(path)
    try:
        return read(text)
    except ValueError as error:
        raise SceneError(f"{os.fspath(path)}: {error}") from None


def write_plain(path: str | os.PathLike[str], table: Plain) -> None:
    """Write `table` to a `.toml` or `.json` file, which is either as before or complete, whatever happens."""
    _, write = _form_of(path)
    data = write(table).encode("utf-8")
    if len(data) > LONGEST_FILE:
        raise SceneError(f"{os.fspath(path)}: would be longer than the {LONGEST_FILE} bytes that can be read again")
    try:
        write_whole(path, data)
    except OSError as error:
        raise SceneError(f"{os.fspath(path)}: cannot be written: {error.strerror}") from None


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Make `data` the contents of a file, which is either as before or complete; raise `OSError`."""
    target = Path(os.path.realpath(path))
    beside = target.with_name(f".{target.name}.{token_hex(8)}.part")
    try:
        with beside.open("xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        beside.replace(target)
    finally:
        with suppress(OSError):
            beside.unlink()


def path_of(path: Any) -> str:
    """A path as text; raises `SceneError` where it is none."""
    try:
        return checks.path("path", path)
    except InvalidArgument as error:
        raise SceneError(str(error)) from None


def _form_of(path: Any) -> tuple[Callable[[str], Plain], Callable[[Plain], str]]:
    """How files with this path's ending are read and written."""
    path = path_of(path)
    ending = Path(path).suffix.lower()
    if ending not in _FORMS:
        known = " or ".join(_FORMS)
        raise SceneError(f"{os.fspath(path)}: must end in {known}, not {ending!r}")
    return _FORMS[ending]


def _text_of(path: str | os.PathLike[str]) -> str:
    """What stands in a file, without the mark that some editors put before UTF-8."""
    try:
        with Path(path).open("rb") as file:
            data = file.read(LONGEST_FILE + 1)
        if len(data) > LONGEST_FILE:
            raise SceneError(f"{os.fspath(path)}: is longer than {LONGEST_FILE} bytes")
        return data.decode("utf-8-sig")
    except OSError as error:
        raise SceneError(f"{os.fspath(path)}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise SceneError(f"{os.fspath(path)}: is not UTF-8: {error.reason} (at byte {error.start})") from None


def _from_json(text: str) -> Plain:
    """The table that JSON holds; the words NaN and Infinity are read, so that the fault they are gets its path."""
    check_json(text)
    table = json.loads(text, object_pairs_hook=_without_twins)
    if not isinstance(table, dict):
        raise ValueError(f"must hold one table, not a {type(table).__name__}")
    return table


def _without_twins(pairs: list[tuple[str, Any]]) -> Plain:
    """The pairs as a table, unless a name stands in it twice."""
    table: Plain = {}
    for name, value in pairs:
        if name in table:
            raise ValueError(f"{name!r} stands twice in one table")
        table[name] = value
    return table


def _from_toml(text: str) -> Plain:
    """The table that TOML holds."""
    check_toml(text)
    return read_toml(text)


def _to_json(table: Plain) -> str:
    """`table` as JSON, two spaces deep."""
    return json.dumps(table, indent=2, ensure_ascii=False) + "\n"


def _to_toml(table: Plain) -> str:
    """`table` as TOML, each list of numbers on one line, balls last."""
    rest = {name: value for name, value in table.items() if name != "balls"}
    # Strings are written on one line, so that a list's line breaks are the only ones within a value.
    text = re.sub(r"\[\n((?: *[-+.\w]+,\n)+) *\]", _on_one_line, tomli_w.dumps(rest))
    return text + "".join(map(_ball_as_toml, table.get("balls", ())))


def _ball_as_toml(ball: Plain) -> str:
    """A ball as an item of a list in TOML: as `tomli_w` writes it, which takes six times as long."""
    return "".join(["\n[[balls]]\n", *(_WRITERS[type(value)](name, value) for name, value in ball.items())])


#: How each type of value in a ball is written.
_WRITERS: dict[type, Callable[[str, Any], str]] = {
    float: lambda name, value: f"{name} = {value!r}\n",
    int: lambda name, value: f"{name} = {value}\n",
    bool: lambda name, value: f"{name} = {'true' if value else 'false'}\n",
    list: lambda name, value: f"{name} = [{value[0]!r}, {value[1]!r}]\n",
    str: lambda name, value: tomli_w.dumps({name: value}),
}


def _on_one_line(found: re.Match[str]) -> str:
    """A list that was written with one number a line."""
    return "[" + ", ".join(found[1].replace(",", " ").split()) + "]"


#: By ending: how to read and how to write.
_FORMS: dict[str, tuple[Callable[[str], Plain], Callable[[Plain], str]]] = {
    ".toml": (_from_toml, _to_toml),
    ".json": (_from_json, _to_json),
}
