"""The font of the toy's letters: that of pygame_gui's buttons, so that the whole panel is of one hand."""

from __future__ import annotations

from importlib.resources import files

import pygame

from carom.play.letters import load

FONT = "NotoSans-Regular.ttf"
#: pygame's own font is that much larger at the same size.
LARGER = 1.08


def load_script(size: int) -> pygame.font.Font:
    """The font that pygame_gui brings, its letters about `size` pixels high; pygame's own where it brings none."""
    path = files("pygame_gui") / "data" / FONT
    return pygame.font.Font(str(path), round(LARGER * size)) if path.is_file() else load(size)
