"""The palette of the pinball table, and a canvas in the table's units that paints smooth edges."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise
from math import ceil, cos, floor, hypot, pi, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from carom import Aabb
from carom.play.letters import load

Colour = tuple[int, int, int]
Spot = tuple[float, float]

NIGHT: Colour = (9, 11, 36)
INDIGO: Colour = (28, 26, 92)
VIOLET: Colour = (98, 38, 128)
CORAL: Colour = (255, 92, 88)
GOLD: Colour = (255, 190, 66)
CREAM: Colour = (255, 242, 210)
TEAL: Colour = (36, 214, 196)

#: The size of letters of which a line is one unit high.
LETTERS = 0.69
#: How much larger art is painted than it is shown; what is shown is the mean of so many pixels each way.
FINER = 3


def mixed(first: Colour, second: Colour, share: float) -> Colour:
    """The colour between two: all of the first at a share of 0, all of the second at 1."""
    red, green, blue = (round(a + (b - a) * share) for a, b in zip(first, second, strict=True))
    return red, green, blue


def polar(center: Spot, radius: float, angle: float) -> Spot:
    """The point at an angle on the circle round `center`."""
    return center[0] + radius * cos(angle), center[1] + radius * sin(angle)


def bow(center: Spot, radius: float, start: float, end: float, step: float = 0.06) -> list[Spot]:
    """Points along an arc from the angle `start` to `end`, either way round."""
    count = max(2, ceil(abs(end - start) / step))
    return [polar(center, radius, start + (end - start) * number / count) for number in range(count + 1)]


def ring(center: Spot, radius: float) -> list[Spot]:
    """Points round a whole circle."""
    return bow(center, radius, 0.0, 2.0 * pi)[:-1]


def star(center: Spot, radius: float, inner: float, points: int = 4, turn: float = pi / 2.0) -> list[Spot]:
    """The outline of a star: points at `radius`, notches at `inner`."""
    radii = (radius, inner)
    return [polar(center, radii[number % 2], turn + number * pi / points) for number in range(2 * points)]


def glow(radius: int, colour: Colour, strength: float = 1.0, power: float = 2.0) -> pygame.Surface:
    """Light that fades from the middle to nothing at `radius` pixels: to be added to a picture (BLEND_RGB_ADD)."""
    place = np.arange(-radius, radius + 1) / max(radius, 1)
    distance = np.sqrt(place[:, None] * place[:, None] + place[None, :] * place[None, :])
    light = strength * np.clip(1.0 - distance, 0.0, 1.0) ** power
    picture = pygame.Surface(distance.shape, 0, 32)
    pygame.surfarray.blit_array(picture, np.clip(light[:, :, None] * np.array(colour), 0, 255).astype(np.uint8))
    return picture


class Canvas:
    """A picture of a box of the table, painted in the table's units and larger than it is shown.

    Args:
        box: What of the table is on it.
        scale: Pixels per unit of the finished picture.
        ground: A picture to begin with, of the finished size; transparent without one.
        finer: How many times larger it is painted than it is shown.
    """

    def __init__(self, box: Aabb, scale: float, ground: pygame.Surface | None = None, *, finer: int = FINER) -> None:
        self.box = box
        self.scale = scale
        self.size = (round((box.right - box.left) * scale), round((box.top - box.bottom) * scale))
        self._finer = finer
        self.fine = scale * finer
        large = (self.size[0] * finer, self.size[1] * finer)
        self.picture = pygame.Surface(large, pygame.SRCALPHA)
        self._corner = (0, 0)
        if ground is not None:
            self.picture.blit(pygame.transform.smoothscale(ground, large), (0, 0))

    def at(self, spot: Spot) -> Spot:
        """A point's pixel on the large picture."""
        left, top = self._corner
        return (spot[0] - self.box.left) * self.fine - left, (self.box.top - spot[1]) * self.fine - top

    def pixel(self, spot: Spot) -> tuple[int, int]:
        """A point's pixel on the finished picture."""
        x, y = self.at(spot)
        return round(x / self._finer), round(y / self._finer)

    def fill(self, spots: Iterable[Spot], colour: Sequence[int]) -> None:
        """Fill a polygon; a colour of four numbers is laid over what is there."""
        pixels = [self.at(spot) for spot in spots]
        if len(colour) == 3 or colour[3] == 255:
            pygame.draw.polygon(self.picture, colour, pixels)
            return
        left, top = (int(min(pixel[axis] for pixel in pixels)) - 1 for axis in (0, 1))
        width, height = (ceil(max(pixel[axis] for pixel in pixels)) + 2 for axis in (0, 1))
        layer = pygame.Surface((width - left, height - top), pygame.SRCALPHA)
        pygame.draw.polygon(layer, colour, [(x - left, y - top) for x, y in pixels])
        self.picture.blit(layer, (left, top))

    def clear(self, spots: Iterable[Spot]) -> None:
        """Cut a polygon out."""
        pygame.draw.polygon(self.picture, (0, 0, 0, 0), [self.at(spot) for spot in spots])

    def disc(self, center: Spot, radius: float, colour: Sequence[int]) -> None:
        """Fill a circle."""
        self.fill(bow(center, radius, 0.0, 2.0 * pi, 0.1)[:-1], colour)

    def stroke(self, spots: Sequence[Spot], width: float, colour: Sequence[int], closed: bool = False) -> None:
        """Draw a path of some width in units, with round joints and ends."""
        if len(colour) == 4 and colour[3] < 255:
            self._laid(spots, width, colour, closed)
            return
        path = [self.at(spot) for spot in spots]
        path = [*path, path[0]] if closed else path
        half = width * self.fine / 2.0
        for (x, y), (end_x, end_y) in pairwise(path):
            length = hypot(end_x - x, end_y - y) or 1.0
            aside_x, aside_y = (y - end_y) / length * half, (end_x - x) / length * half
            corners = [
                (x + aside_x, y + aside_y),
                (end_x + aside_x, end_y + aside_y),
                (end_x - aside_x, end_y - aside_y),
                (x - aside_x, y - aside_y),
            ]
            pygame.draw.polygon(self.picture, colour, corners)
        if half >= 1.0:
            for pixel in path:
                pygame.draw.circle(self.picture, colour, pixel, half)

    def _laid(self, spots: Sequence[Spot], width: float, colour: Sequence[int], closed: bool) -> None:
        """Draw a path of a colour that is seen through, evenly where the path meets itself."""
        places, half = [self.at(spot) for spot in spots], ceil(width * self.fine / 2.0) + 2
        left, top = (floor(min(place[axis] for place in places)) - half for axis in (0, 1))
        right, bottom = (ceil(max(place[axis] for place in places)) + half for axis in (0, 1))
        with self.layer(colour[3], area=pygame.Rect(left, top, right - left, bottom - top)):
            self.stroke(spots, width, tuple(colour[:3]), closed)

    @contextmanager
    def layer(self, alpha: int, aside: Spot = (0.0, 0.0), *, area: pygame.Rect | None = None) -> Iterator[None]:
        """What is painted within is laid over the canvas as one sheet, seen through by `alpha` and moved `aside`.

        The sheet is as large as the canvas, or the part `area` of its large picture.
        """
        part = self.picture.get_rect() if area is None else area
        whole, self.picture = self.picture, pygame.Surface(part.size, pygame.SRCALPHA)
        sheet, self._corner = self.picture, part.topleft
        yield
        self.picture, self._corner = whole, (0, 0)
        sheet.set_alpha(alpha)
        self.picture.blit(sheet, (part.left + aside[0] * self.fine, part.top - aside[1] * self.fine))

    def light(self, center: Spot, radius: float, colour: Colour, strength: float = 1.0, power: float = 2.0) -> None:
        """Add light that fades from `center` to nothing at `radius`."""
        shine = glow(round(radius * self.fine), colour, strength, power)
        x, y = self.at(center)
        corner = (x - shine.get_width() / 2.0, y - shine.get_height() / 2.0)
        self.picture.blit(shine, corner, special_flags=pygame.BLEND_RGB_ADD)

    def words(self, text: str, center: Spot, size: float, colour: Colour, apart: float = 0.0) -> None:
        """Write words round their middle: `size` and the room between letters are in units."""
        pygame.font.init()
        font = load(round(LETTERS * size * self.fine))
        letters = [font.render(letter, True, colour) for letter in text]
        room = apart * self.fine
        width = sum(letter.get_width() for letter in letters) + room * (len(letters) - 1)
        line = pygame.Surface((ceil(width) + 2, letters[0].get_height()), pygame.SRCALPHA)
        x = 0.0
        for letter in letters:
            line.blit(letter, (x, 0))
            x += letter.get_width() + room
        self.paste(line, center)

    def paste(self, picture: pygame.Surface, center: Spot) -> None:
        """Lay a picture of the large size over the canvas, its middle at a point."""
        x, y = self.at(center)
        self.picture.blit(picture, (x - picture.get_width() / 2.0, y - picture.get_height() / 2.0))

    def finished(self) -> pygame.Surface:
        """The picture in the size that is shown."""
        return pygame.transform.smoothscale(self.picture, self.size)


def shaded(size: tuple[int, int], colours: NDArray[np.float64]) -> pygame.Surface:
    """A picture of colours from 0 to 255, given per pixel: (width, height, 3)."""
    picture = pygame.Surface(size, 0, 32)
    pygame.surfarray.blit_array(picture, np.clip(colours, 0, 255).astype(np.uint8))
    return picture


def opaque(picture: pygame.Surface) -> pygame.Surface:
    """A picture that is not seen through, in the format in which it is drawn fastest."""
    found = pygame.Surface(picture.get_size(), 0, 32)
    found.blit(picture, (0, 0))
    return found
