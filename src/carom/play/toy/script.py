"""The toy's letters: those of pygame_gui's buttons, so that the whole panel is of one hand."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files

import pygame

from carom.play.letters import Letters, load

FONT = "NotoSans-Regular.ttf"
#: pygame's own font is that much larger at the same size.
LARGER = 1.08


class Script(Letters):
    """Writes words in the font that pygame_gui brings, or in pygame's where it does not."""

    def __init__(self) -> None:
        super().__init__()
        self._font = lru_cache(maxsize=64)(load_script)


def load_script(size: int) -> pygame.font.Font:
    """The font, its letters about `size` pixels high."""
    path = files("pygame_gui") / "data" / FONT
    return pygame.font.Font(str(path), round(LARGER * size)) if path.is_file() else load(size)
