"""Words on surfaces, in the font that pygame brings."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Literal, TypeAlias

import pygame

Colour: TypeAlias = tuple[int, int, int]
Anchor: TypeAlias = Literal["start", "middle", "end"]


def load(size: int) -> pygame.font.Font:
    """The font, its letters `size` pixels high."""
    return pygame.font.Font(pygame.font.get_default_font(), size)


class Letters:
    """Writes words; what was written before is not rendered again.

    Args:
        font: The font at a size in pixels.
    """

    def __init__(self, font: Callable[[int], pygame.font.Font] = load) -> None:
        pygame.font.init()
        self._font = lru_cache(maxsize=64)(font)
        self._rendered = lru_cache(maxsize=1024)(self._render)

    def draw(
        self,
        surface: pygame.Surface,
        words: str,
        place: tuple[float, float],
        size: int,
        colour: Colour,
        *,
        anchor: Anchor = "start",
    ) -> None:
        """Write one line of `words`, its upper edge at `place` in pixels, its letters `size` pixels high."""
        picture = self._rendered(words, size, colour)
        x, y = place
        shift = {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor]
        surface.blit(picture, (round(x - shift * picture.get_width()), round(y)))

    def width(self, words: str, size: int) -> int:
        """How many pixels wide words are."""
        return self._font(size).size(words)[0]

    def _render(self, words: str, size: int, colour: Colour) -> pygame.Surface:
        """Words as a surface."""
        return self._font(size).render(words, True, colour)
