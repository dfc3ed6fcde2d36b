"""A session of the pinball game for tests: its window, keys that are posted, screens that are kept."""

from functools import cache
from pathlib import Path

import pygame
import pytest

from carom.play.pinball import HighScores, Pinball, PinballApp
from carom.play.pinball.art import back as art_back
from carom.play.pinball.art import pictures as art
from carom.play.pinball.rules.table import Table
from carom.play.pinball.screen import sounds
from carom.play.window import Window
from tests.play import screens

#: Frames of one step each.
STEP = Pinball.STEP
#: The width and the height of the screens that are kept: less than the window's, for they show much.
SCREEN = (560, 588)

Art = art.Art
art_once = cache(lambda times: Art(Table().world, times))
backs_once, sounds_once = cache(art_back.paint_backs), cache(sounds.make)


def make_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have art and sounds made once for all sessions."""
    monkeypatch.setattr(art, "Art", lambda world, times: art_once(times))
    monkeypatch.setattr(art_back, "paint_backs", backs_once)
    monkeypatch.setattr(sounds, "make", sounds_once)


def session(seed: int = 1, scores: HighScores | None = None) -> tuple[PinballApp, Window]:
    """A game that has just been opened, with the standing high scores or others, in a window."""
    app = PinballApp(lambda line: pytest.fail(line), Pinball(scores or HighScores(), seed))
    window = Window(app)
    pygame.event.clear()
    return app, window


def key(number: int, down: bool = True) -> None:
    """Have a key go down or up before the next frame."""
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN if down else pygame.KEYUP, key=number))


def tapped(window: Window, number: int, frames: int = 1) -> None:
    """Press a key, let some frames of one step pass, and let it go."""
    key(number)
    for _ in range(frames):
        window.frame(STEP)
    key(number, down=False)
    window.frame(STEP)


def bytes_of(window: Window, area: pygame.Rect | None = None) -> bytes:
    """The picture in a window, or in an area of it."""
    shown = window.surface if area is None else window.surface.subsurface(area)
    return pygame.image.tobytes(shown, "RGB")


def keep(name: str, window: Window, renew: bool, folder: Path) -> None:
    """Compare what is in a window with the screen that is kept."""
    screens.check(name, pygame.transform.smoothscale(window.surface, SCREEN), renew=renew, folder=folder)
