"""Small pictures that are made once and then laid onto frames: shadows, rings, glows, and the cue."""

from __future__ import annotations

from math import atan2, degrees, hypot

import numpy as np
import pygame
from numpy.typing import NDArray

from carom.play.pool.game import Vector
from carom.play.pool.layout import Colour

#: Pixels: the cue, twice as large as it is shown so that it can be turned smoothly.
CUE_LENGTH, CUE_WIDTH = 1140, 26

#: The cue's colours along it from the tip, each from a pixel on to the next.
CUE_PARTS: tuple[tuple[int, Colour], ...] = (
    (0, (70, 120, 170)),
    (8, (240, 236, 224)),
    (30, (226, 190, 134)),
    (560, (34, 26, 24)),
    (570, (212, 178, 96)),
    (580, (120, 52, 30)),
    (760, (28, 28, 32)),
    (960, (120, 52, 30)),
    (1100, (212, 178, 96)),
    (1112, (24, 22, 22)),
)


def spot(radius: float, colour: Colour, strength: float, soft: float) -> pygame.Surface:
    """A round spot of a colour, `strength` of 1 in the middle, that fades out over `soft` of its radius."""
    distance = _distances(radius) / radius
    fade = np.clip((1.0 - distance) / soft, 0.0, 1.0)
    return _tinted(colour, strength * fade * fade * (3.0 - 2.0 * fade))


def ring(radius: float, width: float, colour: Colour, strength: float, inside: float = 0.0) -> pygame.Surface:
    """A ring, its line `width` pixels wide round `radius`, over a disc that is as strong as `inside` says."""
    distance = _distances(radius + width)
    line = np.clip(0.5 + 0.5 * width - np.abs(distance - radius), 0.0, 1.0)
    disc = np.clip(0.5 + radius - distance, 0.0, 1.0)
    return _tinted(colour, np.maximum(strength * line, inside * disc))


def _distances(radius: float) -> NDArray[np.float64]:
    """How far each pixel of a square that holds a circle is from its middle, which lies on a pixel's corner."""
    half = int(radius) + 2
    steps = np.arange(2 * half) + 0.5 - half
    distances: NDArray[np.float64] = np.hypot(steps[:, None], steps[None, :])
    return distances


def surface_of(pixels: NDArray[np.uint8]) -> pygame.Surface:
    """A surface of pixels of shape (height, width, 4): red, green, blue and alpha.

    Its bytes are in the order that screens have them in: one in another order is laid onto a screen ten times slower.
    """
    height, width, _ = pixels.shape
    return pygame.image.frombytes(pixels[..., [2, 1, 0, 3]].tobytes(), (width, height), "BGRA")


def _tinted(colour: Colour, alpha: NDArray[np.float64]) -> pygame.Surface:
    """A surface of one colour that covers as much as `alpha`, of shape (height, width), says of 1."""
    pixels = np.empty((*alpha.shape, 4), np.uint8)
    pixels[..., :3] = colour
    pixels[..., 3] = np.round(255.0 * np.clip(alpha, 0.0, 1.0))
    return surface_of(pixels)


def put(surface: pygame.Surface, picture: pygame.Surface, place: Vector) -> None:
    """Lay a picture onto a surface with its middle at `place`."""
    width, height = picture.get_size()
    surface.blit(picture, (round(place[0] - 0.5 * width), round(place[1] - 0.5 * height)))


class Cue:
    """The cue, `times` as large, and its shadow; a cue of the same direction as last time is not turned again."""

    def __init__(self, times: int = 1) -> None:
        self._times = times
        stick, shade = _cue_pictures()
        self._pictures = (shade, stick)
        self._turned: tuple[float, tuple[pygame.Surface, ...]] = (400.0, ())

    def draw(self, surface: pygame.Surface, tip: Vector, towards: Vector, bright: float = 1.0) -> None:
        """Draw it with its tip at a pixel, pointing `towards`, y down; faint where `bright` is below 1."""
        angle = round(degrees(atan2(towards[1], -towards[0])), 2)
        if angle != self._turned[0]:
            self._turned = (
                angle,
                tuple(pygame.transform.rotozoom(each, angle, 0.5 * self._times) for each in self._pictures),
            )
        length = hypot(*towards)
        half = 0.25 * CUE_LENGTH * self._times
        x, y = tip[0] - half * towards[0] / length, tip[1] - half * towards[1] / length
        for picture, (dx, dy) in zip(self._turned[1], ((6.0, 11.0), (0.0, 0.0)), strict=True):
            picture.set_alpha(round(255.0 * bright))
            put(surface, picture, (x + dx * self._times, y + dy * self._times))


def _cue_pictures() -> tuple[pygame.Surface, pygame.Surface]:
    """The cue from its tip at the left to its butt, and its shadow."""
    along = np.arange(CUE_LENGTH)
    half = 5.0 + 5.5 * along / CUE_LENGTH
    across = np.arange(CUE_WIDTH) + 0.5 - 0.5 * CUE_WIDTH
    share = across[:, None] / half[None, :]
    cover = np.clip((half[None, :] - np.abs(across)[:, None]) + 0.5, 0.0, 1.0)
    colours = np.zeros((CUE_LENGTH, 3))
    for begin, colour in CUE_PARTS:
        colours[begin:] = colour
    light = 0.62 + 0.5 * np.sqrt(np.clip(1.0 - (share + 0.25) ** 2, 0.0, 1.0))
    gleam = np.exp(-(((share + 0.42) / 0.16) ** 2))
    pixels = np.empty((CUE_WIDTH, CUE_LENGTH, 4))
    pixels[..., :3] = np.clip(colours[None] * light[..., None] + 70.0 * gleam[..., None], 0.0, 255.0)
    pixels[..., 3] = 255.0 * cover
    return surface_of(pixels.round().astype(np.uint8)), pygame.transform.gaussian_blur(
        _tinted((0, 0, 0), 0.42 * cover), 2
    )
