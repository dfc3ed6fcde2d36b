"""Files that a game writes for its player: each gets a number that no other has, so that none is overwritten."""

from __future__ import annotations

from itertools import count
from pathlib import Path


def keep(folders: list[Path], name: str, content: bytes) -> str:
    """Where a file was kept, in words, or why it was not: in the first of the `folders` that takes it.

    `name` has a `{}` where the number comes.
    """
    failure = "there is no folder"
    for folder in folders:
        try:
            return f"kept as {write_new(folder, name, content)}"
        except OSError as error:
            failure = f"not kept: {folder} takes no file ({error.strerror})"
    return failure


def write_new(folder: Path, name: str, content: bytes) -> Path:
    """The file that was written: `name` with the first number from 1 on that is free. Raises `OSError`."""
    for number in count(1):
        path = folder / name.format(number)
        try:
            with path.open("xb") as file:
                file.write(content)
        except FileExistsError:
            continue
        return path
    raise AssertionError("there is always a number")


def places(folder: Path) -> list[Path]:
    """Where a file may go, the best place first: where the program was started, then `folder`, if there is one."""
    return [Path.cwd(), folder] if folder.is_dir() else [Path.cwd()]
