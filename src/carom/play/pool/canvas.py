"""Painting in arrays of light: textures, soft edges and shadows that a still picture is made of, once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
import pygame
from numpy.typing import NDArray

from carom.play.pool.game import Vector

#: One number for each pixel, of shape (width, height): how much of it is covered, or how bright it is.
Field: TypeAlias = NDArray[np.float32]
#: The farthest, in pixels, over which edges are softened; over more of them they are made fewer.
SOFTEST = 4.0


class Canvas:
    """A picture of `size` pixels as numbers from 0 to 255, of shape (width, height, 3).

    Pixels of a mask are first drawn `finer` times finer along each side.
    """

    def __init__(self, size: tuple[int, int], finer: int = 3) -> None:
        self.size, self.finer = size, finer
        self.light = np.zeros((*size, 3), np.float32)
        self._fine = pygame.Surface((size[0] * self.finer, size[1] * self.finer), 0, 32)

    def mask(self, draw: Callable[[pygame.Surface], object]) -> Field:
        """How much of each pixel is covered by what `draw` paints white on a surface `finer` times as large."""
        self._fine.fill(0)
        draw(self._fine)
        return _red(pygame.transform.smoothscale(self._fine, self.size))

    def polygon(self, corners: Sequence[Vector]) -> Field:
        """The mask of a polygon."""
        fine = [(x * self.finer, y * self.finer) for x, y in corners]
        return self.mask(lambda surface: pygame.draw.polygon(surface, "white", fine))

    def polygons(self, many: Sequence[Sequence[Vector]]) -> Field:
        """The mask of several polygons."""

        def draw(surface: pygame.Surface) -> None:
            for corners in many:
                pygame.draw.polygon(surface, "white", [(x * self.finer, y * self.finer) for x, y in corners])

        return self.mask(draw)

    def discs(self, discs: Sequence[tuple[Vector, float]]) -> Field:
        """The mask of discs, each a centre and a radius."""

        def draw(surface: pygame.Surface) -> None:
            for (x, y), radius in discs:
                pygame.draw.circle(surface, "white", (x * self.finer, y * self.finer), radius * self.finer)

        return self.mask(draw)

    def box(self, left: float, top: float, width: float, height: float, corner: float = 0.0) -> Field:
        """The mask of a box with round corners."""
        edges = pygame.Rect(*(round(value * self.finer) for value in (left, top, width, height)))
        return self.mask(lambda surface: pygame.draw.rect(surface, "white", edges, 0, round(corner * self.finer)))

    def paint(self, mask: Field, colour: Sequence[float] | NDArray[np.float32], shade: Field | float = 1.0) -> None:
        """Lay a colour, or a picture, times `shade` over what `mask` covers."""
        paint = np.asarray(colour, np.float32) * (shade[..., None] if isinstance(shade, np.ndarray) else shade)
        self.light += (paint - self.light) * mask[..., None]

    def darken(self, mask: Field) -> None:
        """Take the share `mask` of its light from each pixel."""
        self.light *= (1.0 - mask)[..., None]

    def picture(self) -> NDArray[np.uint8]:
        """The finished picture's colours."""
        colours: NDArray[np.uint8] = np.clip(self.light + 0.5, 0.0, 255.0).astype(np.uint8)
        return colours


def blurred(field: Field, radius: float) -> Field:
    """`field` with its edges softened over about `radius` pixels.

    What is softened far has nothing fine, and is softened in larger pixels.
    """
    coarser = max(int(radius / SOFTEST), 1)
    grey = np.clip(field * 255.0, 0.0, 255.0).astype(np.uint8)
    surface = pygame.Surface(field.shape, 0, 32)
    pygame.surfarray.blit_array(surface, np.repeat(grey[..., None], 3, axis=2))
    small = pygame.transform.smoothscale(surface, [max(side // coarser, 1) for side in field.shape])
    soft = pygame.transform.gaussian_blur(small, max(round(radius / coarser), 1))
    return _red(pygame.transform.smoothscale(soft, field.shape))


def noise(shape: tuple[int, int], stretch: tuple[int, int], seed: int) -> Field:
    """Smooth random numbers around 0, of spread about 1, whose grain is `stretch` pixels wide and high."""
    random = np.random.default_rng(seed)
    coarse = (max(shape[0] // stretch[0], 2), max(shape[1] // stretch[1], 2))
    values = random.integers(0, 256, coarse, dtype=np.uint8)
    surface = pygame.Surface(coarse, 0, 32)
    pygame.surfarray.blit_array(surface, np.repeat(values[..., None], 3, axis=2))
    return (_red(pygame.transform.smoothscale(surface, shape)) - 0.5) * np.float32(3.5)


def _red(surface: pygame.Surface) -> Field:
    """The red of a surface, from 0 to 1."""
    values: Field = pygame.surfarray.array_red(surface).astype(np.float32) / np.float32(255.0)
    return values
