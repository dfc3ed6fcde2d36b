"""What `carom sweep` does: its options as the arguments of `study.sweep`, and what is said at the end."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import typer

from carom import study
from carom.cli.files import INTERRUPTED
from carom.cli.mistakes import Mistake
from carom.cli.report import counted
from carom.errors import InvalidArgument

if TYPE_CHECKING:
    from collections.abc import Sequence

#: `0:1000` and `0:1000:10`: whole numbers from the first up to the second, which is not among them.
_RANGE = re.compile(r"(-?\d+):(-?\d+)(?::(\d+))?")
_WORDS: dict[str, Any] = {"true": True, "false": False, "none": None}
#: Values in one `--vary` at most, so that a slip of the keys does not fill the memory.
MOST_VALUES = 10_000_000


T = TypeVar("T")


def given(option: str, value: T | None, what: str) -> T:
    """The value of an option that must be given; raises `Mistake`, which says what to say by it, where it is not."""
    if not value:
        raise Mistake(f"{option}: is missing; say {what}")
    return value


def sweep(
    scene: str,
    vary: Sequence[str],
    measure: str,
    seconds: float,
    dt: float,
    out: str,
    cluster: str | None,
    resume: bool,
) -> None:
    """Run a sweep, and say where its tables are; raises `Mistake` for what was asked wrongly."""
    grid = dict(varied(text) for text in vary)
    if len(grid) < len(vary):
        raise Mistake("--vary: one name is given twice")
    try:
        table = study.sweep(
            scene, grid, measure=measure, seconds=seconds, dt=dt, out=out, cluster=cluster, resume=resume
        )
    except InvalidArgument as error:
        raise Mistake(str(error).replace("resume goes on with it", "--resume goes on with it")) from None
    except KeyboardInterrupt:
        typer.echo(f"carom: interrupted; {out} keeps what is done, --resume goes on with it", err=True)
        raise typer.Exit(INTERRUPTED) from None
    runs = 1
    for values in grid.values():
        runs *= len(values)
    failed = runs - table.num_rows
    folder = out if "://" in out else str(Path(out))
    typer.echo(f"{counted(runs, 'run')}: {folder}/table.parquet")
    if failed:
        typer.echo(f"{failed:,} of them failed: {folder}/failures.parquet")


def varied(text: str) -> tuple[str, Sequence[Any]]:
    """The name and the values that a `--vary` writes: `NAME=0,2,4`, `NAME=(0,-30),(0,-40)`, `seed=0:1000`."""
    name, is_there, written = text.partition("=")
    name = name.strip()
    if not is_there or not name or not written.strip():
        raise Mistake(f'--vary {text}: must be a name and values, like "seed=0:100" or "world.gravity=(0,-1),(0,-2)"')
    found = _RANGE.fullmatch(written.strip())
    if found:
        step = int(found[3] or 1)
        if step == 0:
            raise Mistake(f"--vary {text}: steps by 0")
        values = range(int(found[1]), int(found[2]), step)
        if not 0 < len(values) <= MOST_VALUES:
            raise Mistake(f"--vary {text}: has {len(values):,} values; from 1 to {MOST_VALUES:,} can be")
        return name, values
    return name, [_value(text, part) for part in _parts(text, written)]


def _parts(text: str, written: str) -> list[str]:
    """The parts between the commas that stand in no brackets."""
    parts, depth = [""], 0
    for letter in written:
        depth += (letter in "([") - (letter in ")]")
        if depth < 0:
            break
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    if depth != 0 or not all(part.strip() for part in parts):
        raise Mistake(f"--vary {text}: its brackets do not match, or a value is missing between commas")
    return [part.strip() for part in parts]


def _value(text: str, part: str) -> Any:
    """A number, a list in brackets, true, false, none, or else a string."""
    if part[0] in "([" and part[-1] in ")]":
        return [_value(text, item) for item in _parts(text, part[1:-1])]
    if part.lower() in _WORDS:
        return _WORDS[part.lower()]
    for kind in (int, float):
        try:
            return kind(part)
        except ValueError:
            continue
    return part
