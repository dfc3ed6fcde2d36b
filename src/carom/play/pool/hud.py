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
    from carom.play.meter import FrameMeter

#: Pixels: the power's bar.
BAR = pygame.Rect(1157, 150, 16, 420)

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
        self._help: tuple[str, pygame.Surface] = ("", pygame.Surface((1, 1)))
        self._gradient = _gradient(BAR.size)

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
        self.letters.draw(surface, headline, (36, 9), 25, colour)
        self.letters.draw(surface, words.detail(session), (36, 38), 14, MUTED)
        self.letters.draw(surface, words.tally(session), (SIZE[0] - 72, 13), 15, IVORY, anchor="end")
        on = [name for mode, name in MODE_NAMES.items() if mode in session.modes]
        self.letters.draw(surface, "  ·  ".join(on), (SIZE[0] - 72, 38), 14, GOLD, anchor="end")

    def _bottom(self, surface: pygame.Surface, session: Session, meter: FrameMeter) -> None:
        """Say which keys there are, and how fast frames are."""
        keys = KEYS_LINE if session.pool.base_line is None else FIRST_LINE
        self.letters.draw(surface, keys, (36, 689), 13, MUTED)
        right = MODES_LINE
        if Mode.RATE in session.modes:
            right = f"{meter.rate:.0f} frames a second, {1e3 * meter.work:.1f} ms of work each"
        self.letters.draw(surface, right, (SIZE[0] - 72, 689), 13, MUTED, anchor="end")

    def _power(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the power as a bar that fills from below."""
        power = session.strength
        pygame.draw.rect(surface, (34, 38, 45), BAR.inflate(8, 8), 0, 11)
        pygame.draw.rect(surface, (8, 9, 11), BAR, 0, 8)
        filled = round(power * BAR.height)
        part = pygame.Rect(0, BAR.height - filled, BAR.width, filled)
        surface.blit(self._gradient, (BAR.x, BAR.bottom - filled), part)
        for quarter in (1, 2, 3):
            y = BAR.y + quarter * BAR.height // 4
            pygame.draw.line(surface, (60, 66, 75), (BAR.x - 9, y), (BAR.x - 5, y))
        level = BAR.bottom - filled
        colour = GOLD if session.draw else IVORY
        pygame.draw.polygon(
            surface, colour, [(BAR.right + 5, level), (BAR.right + 12, level - 5), (BAR.right + 12, level + 5)]
        )
        self.letters.draw(surface, "power", (BAR.centerx, BAR.y - 30), 13, MUTED, anchor="middle")
        self.letters.draw(surface, f"{100 * power:.0f} %", (BAR.centerx, BAR.bottom + 12), 15, colour, anchor="middle")
        speed = f"{speed_of(power) / 100:.1f} m/s"
        self.letters.draw(surface, speed, (BAR.centerx, BAR.bottom + 32), 12, MUTED, anchor="middle")

    def _end(self, surface: pygame.Surface, session: Session) -> None:
        """Say that the game is won or lost, and how to play again."""
        won = session.pool.phase is Phase.WON
        colour = GOOD if won else BAD
        share = min((session.since_end - WAIT) / APPEAR, 1.0)
        # What is to be seen of the impacts is not covered.
        small = Mode.IMPACTS in session.modes
        panel = pygame.Rect(0, 0, 620, 42 if small else 190)
        panel.center = (round(self.middle[0]), BELOW if small else round(self.middle[1]))
        picture = _panel(panel.size, colour)
        middle = panel.width / 2.0
        if not small:
            self.letters.draw(picture, "You win" if won else "You lose", (middle, 30.0), 50, colour, anchor="middle")
            self.letters.draw(picture, words.ending(session.pool), (middle, 96.0), 17, IVORY, anchor="middle")
        again = "R, Space or a click: again   ·   T: the same position once more"
        below = 12.0 if small else 142.0
        self.letters.draw(picture, again, (middle, below), 15, IVORY if small else MUTED, anchor="middle")
        picture.set_alpha(round(255.0 * share))
        surface.blit(picture, panel)

    def _help_with(self, rule: str) -> pygame.Surface:
        """The rule, and what each key and each button does, on a panel."""
        if self._help[0] == rule:
            return self._help[1]
        picture = _panel((900, 112 + 23 * len(HELP)), GOLD)
        self._help = rule, picture
        self.letters.draw(picture, "The pool end game", (36, 20), 24, GOLD)
        self.letters.draw(picture, rule, (36, 56), 15, IVORY)
        for line, (keys, buttons, what) in enumerate(HELP):
            below = 92 + 23 * line
            self.letters.draw(picture, keys, (36, below), 15, IVORY)
            self.letters.draw(picture, buttons, (270, below), 15, MUTED)
            self.letters.draw(picture, what, (410, below), 15, IVORY)
        return picture


#: What the switches are called where they are on.
MODE_NAMES = {Mode.STEPS: "step mode", Mode.IMPACTS: "collision mode", Mode.MUTE: "no sound"}


def _panel(size: tuple[int, int], colour: Colour) -> pygame.Surface:
    """A dark panel that lets a little of the table through, with an edge of a colour."""
    picture = pygame.Surface(size, pygame.SRCALPHA)
    box = picture.get_rect()
    pygame.draw.rect(picture, (*PANEL, 238), box, 0, 16)
    pygame.draw.rect(picture, (*colour, 170), box, 2, 16)
    return picture


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
