"""Initials for a high score, chosen letter by letter."""

from __future__ import annotations

from carom.play.pinball.rules.scores import INITIALS, LETTERS


class Entry:
    """Three letters, of which one is being chosen.

    >>> entry = Entry()
    >>> entry.turn(1)
    >>> entry.accept(), entry.initials, entry.place
    (False, 'BAA', 1)
    """

    def __init__(self) -> None:
        self._letters = [0] * INITIALS
        self.place = 0

    @property
    def initials(self) -> str:
        """The letters as they stand."""
        return "".join(LETTERS[letter] for letter in self._letters)

    def turn(self, step: int) -> None:
        """Take the next letter, or the one before, round and round."""
        self._letters[self.place] = (self._letters[self.place] + step) % len(LETTERS)

    def accept(self) -> bool:
        """Whether that was the last letter; goes on to the next where it was not."""
        if self.place == INITIALS - 1:
            return True
        self.place += 1
        return False
