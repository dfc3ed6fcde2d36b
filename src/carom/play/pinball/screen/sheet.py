"""The picture of the game at one size: the table in each drawing mode, and its back beside it."""

from __future__ import annotations

import pygame

from carom.play.letters import Letters
from carom.play.pinball.art import pictures as art
from carom.play.pinball.rules.game import Pinball
from carom.play.pinball.screen.display import Display
from carom.play.pinball.screen.effects import Effects
from carom.play.pinball.screen.lines import Lines, Mode
from carom.play.pinball.screen.view import TableView

#: The colour round a table that is nudged.
BEHIND = (14, 9, 28)


class Sheet:
    """Draws a game `times` as large as pictures of `art.SIZE`, with what flashes and floats in `effects`."""

    def __init__(self, game: Pinball, letters: Letters, times: int, effects: Effects) -> None:
        self._game = game
        self._times = times
        self._effects = effects
        self._view = TableView(game, letters, times, effects)
        self._table = pygame.Surface(self._view.art.size, 0, 32)
        self._display = Display(letters, times)
        self._lines = Lines(game, times)

    def draw(self, surface: pygame.Surface, mode: Mode) -> None:
        """Draw the table, moved as it is nudged, and its back."""
        if mode is Mode.LINES:
            self._lines.draw(self._table)
        else:
            self._view.draw(self._table)
        if mode is Mode.BOTH:
            self._lines.draw_over(self._table)
        self._display.draw(surface, art.SIZE[0], self._game, self._effects)
        along, down = (way * self._times for way in self._effects.shift)
        width, height = self._table.get_size()
        if (along, down) != (0, 0):
            surface.fill(BEHIND, (0, 0, width, height))
        surface.blit(self._table, (along, down), (0, 0, width - max(0, along), height))
