"""Everything round the table: the words above and below it, the power, the help, and the message at the end."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from carom.play.letters import Letters
from carom.play.pool import words
from carom.play.pool.actions import HELP
from carom.play.pool.game import Phase, speed_of
from carom.play.pool.layout import BAD, GOLD, GOOD, IVORY, MUTED, SIZE, Colour, Layout
from carom.play.pool.session import Mode, Session
from carom.play.pool.sprites import put

if TYPE_CHECKING:
    from carom.play.letters import Anchor
    from carom.play.meter import FrameMeter

#: Pixels of a picture that is not magnified, as all numbers below: the power's bar.
BAR = (1157, 150, 16, 420)

#: Seconds after the end until its message is there, and that it takes to appear.
WAIT, APPEAR = 0.35, 0.35

#: Pixels: the middle of the message where it is small.
BELOW = 654

PANEL: Colour = (16, 19, 24)

KEYS_LINE = "Mouse, Left, Right: aim   ·   Up, Down: power   ·   click, Space: shoot; hold: draw the cue"
FIRST_LINE = "Mouse: aim   ·   wheel: power   ·   drag the cue ball, or W, X: base line   ·   click: shoot"
MODES_LINE = "C: collisions   ·   S: steps   ·   G: more balls   ·   R: again   ·   F1: help"


class Hud:
    """The words and panels round a table."""

    def __init__(self, layout: Layout) -> None:
        self.letters = Letters()
        self.middle = layout.center
        self.times = layout.times
        self._bar = pygame.Rect(*(self.times * side for side in BAR))
        self._help: tuple[str, pygame.Surface] = ("", pygame.Surface((1, 1)))
        self._gradient = _gradient(self._bar.size)

    def _write(
        self,
        surface: pygame.Surface,
        words: str,
        place: tuple[float, float],
        size: int,
        colour: Colour,
        anchor: Anchor = "start",
    ) -> None:
        """Write words; the place and the size are those of a picture that is not magnified."""
        times = self.times
        self.letters.draw(surface, words, (place[0] * times, place[1] * times), size * times, colour, anchor=anchor)

    def draw(self, surface: pygame.Surface, session: Session, meter: FrameMeter) -> None:
        """Draw all of it."""
        self._top(surface, session)
        self._bottom(surface, session, meter)
        self._power(surface, session)
        if Mode.HELP in session.modes:
            put(surface, self._help_with(words.rule(session.pool)), self.middle)
        elif session.pool.over and session.since_end > WAIT:
            self._end(surface, session)

    def _top(self, surface: pygame.Surface, session: Session) -> None:
        """Say how the game stands."""
        headline, colour = words.headline(session)
        self._write(surface, headline, (36, 9), 25, colour)
        self._write(surface, words.detail(session), (36, 38), 14, MUTED)
        self._write(surface, words.tally(session), (SIZE[0] - 72, 13), 15, IVORY, "end")
        on = [name for mode, name in MODE_NAMES.items() if mode in session.modes]
        self._write(surface, "  ·  ".join(on), (SIZE[0] - 72, 38), 14, GOLD, "end")

    def _bottom(self, surface: pygame.Surface, session: Session, meter: FrameMeter) -> None:
        """Say which keys there are, and how fast frames are."""
        keys = KEYS_LINE if session.pool.base_line is None else FIRST_LINE
        self._write(surface, keys, (36, 689), 13, MUTED)
        right = MODES_LINE
        if Mode.RATE in session.modes:
            right = f"{meter.rate:.0f} frames a second, {1e3 * meter.work:.1f} ms of work each"
        self._write(surface, right, (SIZE[0] - 72, 689), 13, MUTED, "end")

    def _power(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the power as a bar that fills from below."""
        power, bar, times = session.strength, self._bar, self.times
        pygame.draw.rect(surface, (34, 38, 45), bar.inflate(8 * times, 8 * times), 0, 11 * times)
        pygame.draw.rect(surface, (8, 9, 11), bar, 0, 8 * times)
        filled = round(power * bar.height)
        part = pygame.Rect(0, bar.height - filled, bar.width, filled)
        surface.blit(self._gradient, (bar.x, bar.bottom - filled), part)
        for quarter in (1, 2, 3):
            y = bar.y + quarter * bar.height // 4
            pygame.draw.line(surface, (60, 66, 75), (bar.x - 9 * times, y), (bar.x - 5 * times, y), times)
        level, near, far = bar.bottom - filled, bar.right + 5 * times, bar.right + 12 * times
        colour = GOLD if session.draw else IVORY
        pygame.draw.polygon(surface, colour, [(near, level), (far, level - 5 * times), (far, level + 5 * times)])
        left, top, width, height = BAR
        middle, below = left + width // 2, top + height
        self._write(surface, "power", (middle, top - 30), 13, MUTED, "middle")
        self._write(surface, f"{100 * power:.0f} %", (middle, below + 12), 15, colour, "middle")
        self._write(surface, f"{speed_of(power) / 100:.1f} m/s", (middle, below + 32), 12, MUTED, "middle")

    def _end(self, surface: pygame.Surface, session: Session) -> None:
        """Say that the game is won or lost, and how to play again."""
        won = session.pool.phase is Phase.WON
        colour = GOOD if won else BAD
        share = min((session.since_end - WAIT) / APPEAR, 1.0)
        # What is to be seen of the impacts is not covered.
        small = Mode.IMPACTS in session.modes
        width, height = 620, 42 if small else 190
        picture = self._panel((width, height), colour)
        panel = picture.get_rect()
        panel.center = (round(self.middle[0]), BELOW * self.times if small else round(self.middle[1]))
        middle = width / 2.0
        if not small:
            self._write(picture, "You win" if won else "You lose", (middle, 30.0), 50, colour, "middle")
            self._write(picture, words.ending(session.pool), (middle, 96.0), 17, IVORY, "middle")
        again = "R, Space or a click: again   ·   T: the same position once more"
        below = 12.0 if small else 142.0
        self._write(picture, again, (middle, below), 15, IVORY if small else MUTED, "middle")
        picture.set_alpha(round(255.0 * share))
        surface.blit(picture, panel)

    def _help_with(self, rule: str) -> pygame.Surface:
        """The rule, and what each key and each button does, on a panel."""
        if self._help[0] == rule:
            return self._help[1]
        picture = self._panel((900, 112 + 23 * len(HELP)), GOLD)
        self._help = rule, picture
        self._write(picture, "The pool end game", (36, 20), 24, GOLD)
        self._write(picture, rule, (36, 56), 15, IVORY)
        for line, (keys, buttons, what) in enumerate(HELP):
            below = 92 + 23 * line
            self._write(picture, keys, (36, below), 15, IVORY)
            self._write(picture, buttons, (270, below), 15, MUTED)
            self._write(picture, what, (410, below), 15, IVORY)
        return picture

    def _panel(self, size: tuple[int, int], colour: Colour) -> pygame.Surface:
        """A dark panel that lets a little of the table through, with an edge of a colour."""
        times = self.times
        picture = pygame.Surface((size[0] * times, size[1] * times), pygame.SRCALPHA)
        box = picture.get_rect()
        pygame.draw.rect(picture, (*PANEL, 238), box, 0, 16 * times)
        pygame.draw.rect(picture, (*colour, 170), box, 2 * times, 16 * times)
        return picture


#: What the switches are called where they are on.
MODE_NAMES = {Mode.STEPS: "step mode", Mode.IMPACTS: "collision mode", Mode.MUTE: "no sound"}


def _gradient(size: tuple[int, int]) -> pygame.Surface:
    """The colours of the power's bar, from green below to red above, with round ends."""
    width, height = size
    picture = pygame.Surface(size, pygame.SRCALPHA)
    for y in range(height):
        share = 1.0 - y / height
        low, high, part = (GOOD, GOLD, 2.0 * share) if share < 0.5 else (GOLD, BAD, 2.0 * share - 1.0)
        colour = [round(a + (b - a) * part) for a, b in zip(low, high, strict=True)]
        pygame.draw.line(picture, colour, (0, y), (width, y))
    ends = pygame.Surface(size, pygame.SRCALPHA)
    pygame.draw.rect(ends, "white", ends.get_rect(), 0, width // 2)
    picture.blit(ends, (0, 0), None, pygame.BLEND_RGBA_MIN)
    return picture
