"""A player who plays by itself: in demonstrations, and in thousands of games that test the table."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from carom.play.pinball.game import Control, Pinball


class Player:
    """Presses the controls of a game as a good player would; call `tick` before each of the game's."""

    def __init__(self, game: Pinball, seed: int = 0, press: Callable[[Control, bool], None] | None = None) -> None:
        self._game = game
        self._random = Random(seed)
        self._press = game.press if press is None else press

    def tick(self) -> None:
        """Nothing; presses what it thinks right before the next step."""
