"""Screenshots: the picture of a game as a PNG file of its own, where the program was started."""

from __future__ import annotations

import re
from io import BytesIO

import platformdirs
import pygame

from carom.play import files


def keep(surface: pygame.Surface, title: str) -> str:
    """Where a surface was kept as a PNG file named after a title, in words; or why it was not."""
    png = BytesIO()
    pygame.image.save(surface, png, "screenshot.png")
    stem = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")
    return "screenshot " + files.keep(files.places(platformdirs.user_pictures_path()), stem + "-{}.png", png.getvalue())
