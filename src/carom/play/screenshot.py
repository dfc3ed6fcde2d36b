"""Screenshots: the picture of a game as a PNG file of its own, in the user's pictures folder or the current one."""

from __future__ import annotations

import re
from io import BytesIO
from itertools import count
from pathlib import Path

import platformdirs
import pygame


def folders() -> list[Path]:
    """Where a screenshot may go, the best place first: the user's pictures folder if there is one, the current one."""
    pictures = platformdirs.user_pictures_path()
    return [pictures, Path.cwd()] if pictures.is_dir() else [Path.cwd()]


def keep(surface: pygame.Surface, title: str) -> str:
    """Where a surface was kept as a PNG file named after a title, in words; or why it was not.

    The file gets a number that no other has: none is overwritten.
    """
    png = BytesIO()
    pygame.image.save(surface, png, "screenshot.png")
    stem = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")
    failure = ""
    for folder in folders():
        try:
            return f"screenshot: {write_new(folder, stem, png.getvalue())}"
        except OSError as error:
            failure = f"no screenshot: {folder} takes none ({error.strerror})"
    return failure


def write_new(folder: Path, stem: str, content: bytes) -> Path:
    """The file that was written: `stem` with the first number from 1 on that is free. Raises `OSError`."""
    for number in count(1):
        path = folder / f"{stem}-{number}.png"
        try:
            with path.open("xb") as file:
                file.write(content)
        except FileExistsError:
            continue
        return path
    raise AssertionError("there is always a number")
