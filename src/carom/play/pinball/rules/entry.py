"""Initials for a high score, chosen letter by letter, or typed."""

from __future__ import annotations

from carom.play.pinball.rules.controls import Control
from carom.play.pinball.rules.scores import INITIALS, LETTERS


class Entry:
    """Three letters, of which one is being chosen, or typed.

    Args:
        initials: What they are at first.

    >>> entry = Entry("AAA")
    >>> entry.turn(1)
    >>> entry.accept(), entry.initials, entry.place
    (False, 'BAA', 1)
    >>> entry.type("x")
    >>> entry.initials, entry.place
    ('BXA', 2)
    """

    def __init__(self, initials: str) -> None:
        self._letters = [LETTERS.index(letter) for letter in initials]
        self.place = 0

    @property
    def initials(self) -> str:
        """The letters as they stand."""
        return "".join(LETTERS[letter] for letter in self._letters)

    def heed(self, control: Control) -> bool:
        """Whether a press has accepted the last letter; else it may have changed a letter, or gone on to the next."""
        if control in (Control.LEFT, Control.RIGHT):
            self.turn(-1 if control is Control.LEFT else 1)
        return control in (Control.START, Control.PLUNGER) and self.accept()

    def turn(self, step: int) -> None:
        """Take the next letter, or the one before, round and round."""
        self._letters[self.place] = (self._letters[self.place] + step) % len(LETTERS)

    def type(self, letter: str) -> None:
        """Take a typed letter, large or small, and go on to the next; "" goes back to the one before.

        What is none of the letters changes nothing.
        """
        if not letter:
            self.place = max(self.place - 1, 0)
        elif len(letter) == 1 and letter.upper() in LETTERS:
            self._letters[self.place] = LETTERS.index(letter.upper())
            self.place = min(self.place + 1, INITIALS - 1)

    def accept(self) -> bool:
        """Whether that was the last letter; goes on to the next where it was not."""
        if self.place == INITIALS - 1:
            return True
        self.place += 1
        return False
