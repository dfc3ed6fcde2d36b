"""A pen that draws in the pixels of a layout onto a surface that may have several for each of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import pygame

from carom.play.letters import Anchor, Colour, Letters

Vector: TypeAlias = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Pen:
    """Draws on `surface`, on which a pixel of the layout is `times` wide and high.

    Places, sizes and widths of all that it draws are the layout's.

    >>> pen = Pen(pygame.Surface((40, 20)), Letters(), times=2)
    >>> pen.area(pygame.Rect(3, 4, 5, 6))
    Rect(6, 8, 10, 12)
    """

    surface: pygame.Surface
    letters: Letters
    times: int = 1

    def at(self, place: Vector) -> Vector:
        """Where a place of the layout is on the surface."""
        return place[0] * self.times, place[1] * self.times

    def area(self, rect: pygame.Rect) -> pygame.Rect:
        """What of the surface a part of the layout is."""
        return pygame.Rect(*(self.times * side for side in rect))

    def fill(self, colour: Colour, rect: pygame.Rect) -> None:
        """Fill a part of the layout."""
        self.surface.fill(colour, self.area(rect))

    def rect(self, colour: Colour, rect: pygame.Rect, width: int = 0, radius: int = 0) -> None:
        """Draw a rectangle with round corners: its edge, or all of it where `width` is 0."""
        times = self.times
        pygame.draw.rect(self.surface, colour, self.area(rect), width * times, border_radius=radius * times)

    def line(self, colour: Colour, start: Vector, end: Vector, width: int = 1) -> None:
        """Draw a straight line."""
        pygame.draw.line(self.surface, colour, self.at(start), self.at(end), width * self.times)

    def lines(self, colour: Colour, places: Sequence[Vector], width: int) -> None:
        """Draw a line through some places."""
        pygame.draw.lines(self.surface, colour, False, [self.at(place) for place in places], width * self.times)

    def thread(self, colour: Colour, start: Vector, end: Vector) -> None:
        """Draw a thin line whose edges are smooth."""
        pygame.draw.aaline(self.surface, colour, self.at(start), self.at(end), self.times)

    def circle(self, colour: Colour, center: Vector, radius: float, width: int = 0) -> None:
        """Draw a circle: its edge, or all of it where `width` is 0."""
        pygame.draw.aacircle(self.surface, colour, self.at(center), radius * self.times, width * self.times)

    def polygon(self, colour: Colour, corners: Sequence[Vector]) -> None:
        """Fill a polygon."""
        pygame.draw.polygon(self.surface, colour, [self.at(corner) for corner in corners])

    def words(self, words: str, place: Vector, size: int, colour: Colour, *, anchor: Anchor = "start") -> None:
        """Write one line of words, its upper edge at a place, its letters `size` high."""
        self.letters.draw(self.surface, words, self.at(place), size * self.times, colour, anchor=anchor)

    def width(self, words: str, size: int) -> float:
        """How wide words are."""
        return self.letters.width(words, size * self.times) / self.times
