"""A file that is watched: what is made of it is made anew whenever it is saved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from time import sleep

import typer

from carom.cli.mistakes import Mistake
from carom.errors import CaromError

#: Seconds between two looks at the file.
PAUSE = 0.2


def watch(scene: str, make: Callable[[], bool]) -> None:
    """Call `make` now and whenever the file `scene` is saved, until Ctrl-C or until `make` was stopped.

    What is wrong with the file is told, and the next time that it is saved waited for.
    """
    path = Path(scene)
    if not path.is_file():
        raise Mistake(f"--watch {scene}: must be a file that can be saved")
    try:
        while True:
            seen = stamp_of(path)
            try:
                if not make():
                    return
            except CaromError as error:
                typer.echo(f"carom: {error}", err=True)
            typer.echo(f"watching {scene}; Ctrl-C ends it", err=True)
            while stamp_of(path) in {seen, None}:
                sleep(PAUSE)
    except KeyboardInterrupt:
        typer.echo("", err=True)


def stamp_of(path: Path) -> tuple[int, int, int] | None:
    """What changes when a file is saved: its time, its size and which file it is; None while there is none."""
    try:
        state = path.stat()
    except OSError:
        return None
    return state.st_mtime_ns, state.st_size, state.st_ino
