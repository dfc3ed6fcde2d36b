"""The help over the game: keys and rules in words."""

from __future__ import annotations

import pygame

from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.pinball.art.paint import CORAL, CREAM, GOLD, NIGHT, TEAL, mixed

KEYS = (
    ("Left, Z, left Shift", "left flipper; moves the lit lanes to the left"),
    ("Right, /, right Shift", "right flipper; moves the lit lanes to the right"),
    ("Space, Down", "hold to draw the plunger, let go to shoot; starts a game"),
    ("Return, 1", "starts a game"),
    ("A, D, W or Up", "nudge the table: to the left, to the right, upward"),
    ("Letters, Backspace", "initials for a high score: type them, take one back"),
    ("F1", "this help"),
    ("F2", "frame rate and the time that a frame takes"),
    ("F3", "art, art and exact lines, lines alone"),
    ("F11", "full screen"),
    ("F12, PrtScr", "screenshot"),
    ("P", "pause"),
    ("M", "sound on and off"),
    ("Esc", "pauses a game; once more ends it"),
    ("Controller", "shoulders: flippers, A: plunger, Start, cross: nudge"),
)
RULES = (
    "Three balls. A ball that drains within the first seconds comes back.",
    "The blinking lane of S-K-Y is the skill shot. All three multiply the bonus, up to 5 times,",
    "and bring an extra ball on the way. Flippers move the lit lanes.",
    "Drop targets 1-2-3: each bank pays more than the one before, every second one starts multiball.",
    "In multiball orbits and banks are jackpots. Inlanes light the orbits.",
    "Bumpers light when struck; all three lit raise what they pay and start a mode: the display",
    "says what to shoot, for how much, and for how many seconds yet. All its shots bring 20,000.",
    "While its arrow blinks the saucer before the left post holds a ball: it starts a mode too, or gives",
    "one that goes on 10 seconds more; in multiball it is a jackpot. An orbit opens it again.",
    "The bonus is paid as the ball drains. Nudge too hard and the table tilts: the bonus is lost.",
)
MARGIN, LINE = 36, 24


def draw_help(surface: pygame.Surface, letters: Letters, times: int = 1) -> None:
    """Draw the help over the darkened game, which is drawn `times` as large."""
    pen = Pen(surface, letters, times)
    width, height = (side // times for side in surface.get_size())
    veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    veil.fill((*mixed(NIGHT, (0, 0, 0), 0.4), 228))
    surface.blit(veil, (0, 0))
    frame = pygame.Rect(MARGIN // 2, 56, width - MARGIN, height - 112)
    for grown, colour, wide in ((0, mixed(GOLD, NIGHT, 0.5), 5), (-2, GOLD, 2)):
        pen.rect(colour, frame.inflate(grown, grown), wide, radius=10)
    y = 84
    pen.words("CAROM COMET", (width / 2, y), 30, CORAL, anchor="middle")
    y += 58
    for keys, meaning in KEYS:
        pen.words(keys, (MARGIN + 196, y), 16, GOLD, anchor="end")
        pen.words(meaning, (MARGIN + 216, y), 16, CREAM)
        y += LINE
    y += 24
    for rule in RULES:
        pen.words(rule, (width / 2, y), 15, TEAL if rule.startswith("Three") else CREAM, anchor="middle")
        y += LINE
