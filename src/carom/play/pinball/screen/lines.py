"""The exact shapes of the table as lines: alone, or over its art, to show that the two agree."""

from __future__ import annotations

from enum import Enum

import pygame

from carom import draw
from carom.play.pinball.art import pictures as art
from carom.play.pinball.rules.game import Pinball

LAYERS = frozenset({draw.Layer.SHAPES, draw.Layer.SENSORS, draw.Layer.BALLS, draw.Layer.VELOCITIES})


#: By how much the art is dimmed under lines.
DIMMED = (150, 150, 160)


class Mode(Enum):
    """How the table is drawn."""

    ART = "art"
    BOTH = "art and lines"
    LINES = "lines"

    @property
    def following(self) -> Mode:
        """The mode after this one."""
        modes = list(Mode)
        return modes[(modes.index(self) + 1) % len(modes)]


class Lines:
    """Draws the shapes of a game's world by the library's own painter, `times` as large as pictures of `art.SIZE`."""

    def __init__(self, game: Pinball, times: int = 1) -> None:
        targets = [shape for shapes in game.table.targets.values() for shape in shapes]
        self._size = (art.SIZE[0] * times, art.SIZE[1] * times)
        self._live = draw.Live(game.world, art.BOX, self._size, layers=LAYERS, changing=targets, zoom=times)
        self._still: pygame.Surface | None = None

    def draw(self, surface: pygame.Surface) -> None:
        """Draw lines alone."""
        self._live.draw(surface)

    def draw_over(self, surface: pygame.Surface) -> None:
        """Draw lines over the art."""
        if self._still is None:
            self._still = pygame.Surface(self._size, 0, 32)
            self._live.draw_still(self._still, ground=False)
        surface.fill(DIMMED, special_flags=pygame.BLEND_RGB_MULT)
        # The lighter of the two colours stays: lines are seen, and what they fill with paper is not.
        surface.blit(self._still, (0, 0), special_flags=pygame.BLEND_RGB_MAX)
        self._live.draw_moving(surface)
