"""The screen: a window of any size that shows a picture of one size, and where the mouse is in that."""

from __future__ import annotations

import os
from typing import Any

import pygame

import carom

#: What SDL opens where there is no screen, unless it was asked for by name.
BLIND = {"offscreen", "dummy", "evdev"}
#: The part of the desktop that a window may take whose picture is larger.
ROOM = 0.88
#: What is around a picture that has not the window's form.
AROUND = (0, 0, 0)


class NoDisplay(carom.CaromError):
    """There is no screen to open a window on."""


class Screen:
    """A window for a picture of `size` pixels, which is shown as large as the window has room for.

    Attributes:
        picture: What is to be drawn into; the window itself, where it has the picture's size.
    """

    picture: pygame.Surface

    def __init__(self, size: tuple[int, int]) -> None:
        check_screen()
        self._size = size
        self._full = False
        self._open()
        self._own = pygame.Surface(size).convert()
        self.fit()

    def _open(self) -> None:
        """Nothing; opens the window, or the full screen."""
        wanted = (0, 0) if self._full else window_size(self._size, pygame.display.get_desktop_sizes()[0])
        try:
            pygame.display.set_mode(wanted, pygame.FULLSCREEN if self._full else pygame.RESIZABLE)
        except pygame.error as error:
            raise NoDisplay(f"no window of {wanted[0]} by {wanted[1]} pixels can be opened: {error}") from None
        self._window_size = (0, 0)

    def fit(self) -> None:
        """Nothing; finds the picture's place in a window that has changed its size."""
        window = shown()
        if window.get_size() == self._window_size:
            return
        self._window_size = window.get_size()
        width, height = self._size
        self._scale = min(self._window_size[0] / width, self._window_size[1] / height)
        self._area = pygame.Rect(0, 0, round(self._scale * width), round(self._scale * height))
        self._area.center = window.get_rect().center
        self.picture = window if self._window_size == self._size else self._own
        window.fill(AROUND)

    def toggle_full(self) -> None:
        """Nothing; goes from a window to the full screen, or back; stays a window where no full screen can be had."""
        self._full = not self._full
        try:
            self._open()
        except NoDisplay:
            self._full = False
            self._open()
        self.fit()

    def seen(self, event: pygame.event.Event) -> pygame.event.Event:
        """An event with its places in the picture's pixels."""
        if self.picture is not self._own or not hasattr(event, "pos"):
            return event
        values: dict[str, Any] = dict(event.dict)
        x, y = values["pos"]
        values["pos"] = (round((x - self._area.left) / self._scale), round((y - self._area.top) / self._scale))
        if "rel" in values:
            values["rel"] = tuple(round(change / self._scale) for change in values["rel"])
        return pygame.event.Event(event.type, values)

    def show(self) -> None:
        """Nothing; brings the picture into the window."""
        if self.picture is self._own:
            pygame.transform.smoothscale(self._own, self._area.size, shown().subsurface(self._area))


def shown() -> pygame.Surface:
    """The window's surface."""
    window = pygame.display.get_surface()
    assert window is not None
    return window


def window_size(picture: tuple[int, int], desktop: tuple[int, int]) -> tuple[int, int]:
    """How large a window is for a picture: as large as that, or smaller where the desktop has no room for it."""
    if picture[0] <= desktop[0] and picture[1] <= desktop[1]:
        return picture
    scale = ROOM * min(desktop[0] / picture[0], desktop[1] / picture[1])
    return round(scale * picture[0]), round(scale * picture[1])


def check_screen() -> None:
    """Nothing; raises `NoDisplay` where there is no screen, unless a driver without one was asked for by name."""
    try:
        pygame.display.init()
    except pygame.error as error:
        raise NoDisplay(f"no window can be opened: {error}") from None
    if pygame.display.get_driver() in BLIND and not os.environ.get("SDL_VIDEODRIVER"):
        raise NoDisplay("no window can be opened: there is no screen (is DISPLAY set?)")
