"""The screen: a window of any size that shows a picture of one size, and where the mouse is in that."""

from __future__ import annotations

import os
from typing import Any

import pygame

import carom
from carom.play.icon import icon

#: What SDL opens where there is no screen, unless it was asked for by name.
BLIND = {"offscreen", "dummy", "evdev"}
#: The part of the desktop that a window may take whose picture is larger.
ROOM = 0.88
#: How many times as large a picture is drawn at most: 3 fills a screen of 3840 by 2160.
LARGEST = 3
#: What asks for a window as large as the screen.
FILLING = (0, 0)
#: What is around a picture that has not the window's form.
AROUND = (0, 0, 0)


class NoDisplay(carom.CaromError):
    """There is no screen to open a window on."""


class Screen:
    """A window for a picture of `size` pixels, which is shown as large as the window has room for.

    Args:
        size: Width and height in pixels.
        magnified: Whether the picture itself becomes larger in large windows, by a whole number of times.

    Attributes:
        picture: What is to be drawn into; the window itself, where it has the picture's size.
        times: How many times as wide and high as `size` the picture is, from 1 to `LARGEST`.
    """

    picture: pygame.Surface
    times: int

    def __init__(self, size: tuple[int, int], *, magnified: bool = False) -> None:
        check_screen()
        # Before the window opens: some systems show no other icon than the one it opened with.
        pygame.display.set_icon(icon())
        self._size = size
        self._magnified = magnified
        self._full = False
        self._windowed = window_size(size, pygame.display.get_desktop_sizes()[0], LARGEST if magnified else 1)
        self._open(self._windowed)
        self._owns = {1: pygame.Surface(size).convert()}
        self.fit()

    def _open(self, wanted: tuple[int, int]) -> None:
        """Open a window of the `wanted` size, or the full screen."""
        try:
            pygame.display.set_mode(wanted, pygame.FULLSCREEN if self._full else pygame.RESIZABLE)
        except pygame.error as error:
            raise NoDisplay(f"no window of {wanted[0]} by {wanted[1]} pixels can be opened: {error}") from None

    def fit(self) -> None:
        """Find the picture's place in the window as large as it is now.

        To be called once events were handed out, for that is when a window changes its size, and before a picture is
        drawn: until the next events, what was found here holds.
        """
        window = shown()
        self._area, scale = area_in(window.get_size(), self._size)
        self.times = min(max(int(scale), 1), LARGEST) if self._magnified else 1
        self._scale = scale / self.times
        wanted = self._size[0] * self.times, self._size[1] * self.times
        if self.times not in self._owns:
            self._owns[self.times] = pygame.Surface(wanted).convert()
        self.picture = window if window.get_size() == wanted else self._owns[self.times]

    def toggle_full(self) -> None:
        """Go from a window to the full screen, or back to a window as large as it was.

        Stay a window where no full screen can be had.
        """
        if not self._full:
            self._windowed = shown().get_size()
        self._full = not self._full
        try:
            self._open(FILLING if self._full else self._windowed)
        except NoDisplay:
            self._full = False
            self._open(self._windowed)
        self.fit()

    def seen(self, event: pygame.event.Event) -> pygame.event.Event:
        """An event with its places in the picture's pixels."""
        if self.picture is not self._owns[self.times] or not hasattr(event, "pos"):
            return event
        values: dict[str, Any] = dict(event.dict)
        x, y = values["pos"]
        values["pos"] = (round((x - self._area.left) / self._scale), round((y - self._area.top) / self._scale))
        if "rel" in values:
            values["rel"] = tuple(round(change / self._scale) for change in values["rel"])
        return pygame.event.Event(event.type, values)

    def show(self) -> None:
        """Bring the picture into the window, and black around it."""
        if self.picture is not self._owns[self.times]:
            return
        # Each time: the window's surface is a new one whenever its size has changed.
        window, area = shown(), self._area
        width, height = window.get_size()
        for around in ((0, 0, area.left, height), (area.right, 0, width, height)):
            window.fill(AROUND, around)
        for around in ((0, 0, width, area.top), (0, area.bottom, width, height)):
            window.fill(AROUND, around)
        if area.size == self.picture.get_size():
            window.blit(self.picture, area)
        else:
            pygame.transform.smoothscale(self.picture, area.size, window.subsurface(area))


def shown() -> pygame.Surface:
    """The window's surface."""
    window = pygame.display.get_surface()
    assert window is not None
    return window


def area_in(window: tuple[int, int], picture: tuple[int, int]) -> tuple[pygame.Rect, float]:
    """Where in a window a picture is shown, as large as fits, in the middle; and how many times as large as it is."""
    scale = min(window[0] / picture[0], window[1] / picture[1])
    # A window may be so flat that of the picture's other side less than a pixel is left.
    width, height = (max(1, round(scale * side)) for side in picture)
    return pygame.Rect((window[0] - width) // 2, (window[1] - height) // 2, width, height), scale


def window_size(picture: tuple[int, int], desktop: tuple[int, int], most: int = 1) -> tuple[int, int]:
    """How large a window is for a picture: as large as that, or smaller where the desktop has no room for it.

    Up to `most` times as large where the desktop has room for that.
    """
    room = min(desktop[0] / picture[0], desktop[1] / picture[1])
    scale = 1.0 if room >= 1.0 else ROOM * room
    times = min(max(int(ROOM * room), 1), most)
    return round(scale * picture[0]) * times, round(scale * picture[1]) * times


def check_screen() -> None:
    """Raise `NoDisplay` where there is no screen, unless a driver without one was asked for by name."""
    try:
        pygame.display.init()
    except pygame.error as error:
        raise NoDisplay(f"no window can be opened: {error}") from None
    if pygame.display.get_driver() in BLIND and not os.environ.get("SDL_VIDEODRIVER"):
        raise NoDisplay("no window can be opened: there is no screen (is DISPLAY set?)")
