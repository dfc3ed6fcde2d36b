"""The files that a command writes: refused early where they cannot be written, and whole or not there at all."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from carom.cli.mistakes import Mistake, meant


def check_outputs(paths: Sequence[Path], endings: Sequence[str], scene: Path | None) -> None:
    """Raise `Mistake` unless every one of `paths` has one of `endings` and can be written now.

    `scene` is the file that the scene comes from, which no output may overwrite.
    """
    seen: list[Path] = []
    for path in paths:
        if path.suffix.lower() not in endings:
            hint = meant(path.suffix, endings)
            raise Mistake(f"{path}: its ending must be one of {', '.join(endings)}{hint and '; '}{hint}")
        target = path.resolve()
        if target in seen:
            raise Mistake(f"{path}: asked for twice")
        if scene is not None and target == scene.resolve():
            raise Mistake(f"{path}: is the scene itself, and would be overwritten")
        seen.append(target)
        try:
            _check_place(path, target)
        except OSError as error:
            raise Mistake(f"{path}: cannot be written: {error.strerror}") from None


def _check_place(path: Path, target: Path) -> None:
    """Raise unless a file can be made at `target`, and the one way to know is to make one beside it."""
    if target.is_dir():
        raise Mistake(f"{path}: is a folder")
    if not target.parent.is_dir():
        raise Mistake(f"{path}: there is no folder {path.parent}")
    if target.exists() and not target.is_file():
        raise Mistake(f"{path}: is no file that could be replaced, but a device or the like")
    if target.exists() and not os.access(target, os.W_OK):
        raise Mistake(f"{path}: cannot be written: it is read-only")
    beside = _beside(target)
    beside.touch()
    beside.unlink()


def write(path: Path, writer: Callable[[Path], None]) -> int:
    """The size in bytes of the file `path`, which `writer` has written; if it fails, what was there before still is."""
    with _replacing(path) as temporary:
        writer(temporary)
        size = temporary.stat().st_size
    return size


@contextmanager
def _replacing(path: Path) -> Iterator[Path]:
    """A path beside `path` with the same ending, to write to: at the end the file there becomes `path`, in one go."""
    target = path.resolve()
    temporary = _beside(target)
    try:
        yield temporary
        if target.exists():
            shutil.copymode(target, temporary)
        temporary.replace(target)
    finally:
        temporary.unlink(missing_ok=True)


def _beside(target: Path) -> Path:
    """A path in the same folder, with the same ending, that no one else uses."""
    return target.with_name(f".carom-{os.getpid()}{target.suffix}")
