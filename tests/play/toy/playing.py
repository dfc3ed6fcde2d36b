"""The toy under scripted input: events are posted as a person's hands would make them, frame by frame."""

from __future__ import annotations

import os
import warnings
from typing import Any

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

import pygame
import pytest

pytest.importorskip("pygame_gui", reason='no pygame_gui: pip install "carom[play]"')

from carom.play.toy.app import Toy
from carom.play.window import Window

FRAME = 1 / 60


class Steady:
    """A meter that always says the same, for screens that are compared."""

    rate, work, share = 60.0, 0.004, 0.24

    def begin(self) -> None:
        """Take no time."""

    def end(self) -> None:
        """Take no time."""


class Player:
    """A toy in a window without a screen, and hands that press its keys and move its mouse.

    Attributes:
        told: What the toy said.
    """

    def __init__(self) -> None:
        self.told: list[str] = []
        self.toy = Toy(self.told.append)
        self.toy.meter = Steady()  # type: ignore[assignment]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.window = Window(self.toy)
        self.desk = self.toy.desk

    @property
    def world(self) -> Any:
        """The world of the first table."""
        return self.desk.tables[0].world

    def frames(self, count: int = 1) -> None:
        """Let frames go by."""
        for _ in range(count):
            self.window.frame(FRAME)

    def key(self, key: int) -> None:
        """Press a key and let it go."""
        for kind in (pygame.KEYDOWN, pygame.KEYUP):
            pygame.event.post(pygame.event.Event(kind, key=key, mod=0, unicode="", scancode=0))
        self.frames()

    def mouse(self, kind: int, place: tuple[float, float]) -> None:
        """Move the mouse to a place of the picture, were it not magnified, or press or let go its button there."""
        times = self.window.surface.get_width() // Toy.size[0]
        spot = (round(times * place[0]), round(times * place[1]))
        more = {"rel": (0, 0), "buttons": (0, 0, 0)} if kind == pygame.MOUSEMOTION else {"button": 1}
        pygame.event.post(pygame.event.Event(kind, pos=spot, **more))
        self.frames()

    def click(self, name: Any) -> None:
        """Click on a button of the panel, by its name, or by the name and the value of a choice."""
        place = self.toy.panel.places[name].center
        for kind in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            self.mouse(kind, place)
        self.frames()

    def slide(self, name: str, pixels: int) -> None:
        """Drag the knob of a slider to the right, or to the left where `pixels` is below 0."""
        x, y = self.toy.panel.places[name].center
        self.mouse(pygame.MOUSEMOTION, (x, y))
        self.mouse(pygame.MOUSEBUTTONDOWN, (x, y))
        self.mouse(pygame.MOUSEMOTION, (x + pixels, y))
        self.mouse(pygame.MOUSEBUTTONUP, (x + pixels, y))
        self.frames()

    def point(self, place: tuple[float, float]) -> None:
        """Move the mouse to a place of the first table."""
        self.mouse(pygame.MOUSEMOTION, self.toy.views[0].pixel(place))
