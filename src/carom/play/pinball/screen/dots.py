"""A display of glowing dots that shows pages of words, made anew when the page changes."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

#: Dots across and down, and the pixels of each.
COLUMNS, ROWS, DOT = 116, 36, 3
HEIGHT, BETWEEN = 7, 1

#: The columns of each letter, its top in the lowest bit.
_FONT = {
    "0": "3e5149453e",
    "1": "427f40",
    "2": "7249494946",
    "3": "2141494d33",
    "4": "1814127f10",
    "5": "2745454539",
    "6": "3c4a494931",
    "7": "4121110907",
    "8": "3649494936",
    "9": "464949291e",
    "A": "7e1111117e",
    "B": "7f49494936",
    "C": "3e41414122",
    "D": "7f4141413e",
    "E": "7f49494941",
    "F": "7f09090901",
    "G": "3e41415173",
    "H": "7f0808087f",
    "I": "417f41",
    "J": "2040413f01",
    "K": "7f08142241",
    "L": "7f40404040",
    "M": "7f021c027f",
    "N": "7f0408107f",
    "O": "3e4141413e",
    "P": "7f09090906",
    "Q": "3e4151215e",
    "R": "7f09192946",
    "S": "2649494932",
    "T": "01017f0101",
    "U": "3f4040403f",
    "V": "1f2040201f",
    "W": "3f4038403f",
    "X": "6314081463",
    "Y": "0304780403",
    "Z": "6159494d43",
    "x": "2214081422",
    " ": "000000",
    "!": "5f",
    "'": "0402",
    "+": "08083e0808",
    ",": "8060",
    "-": "080808",
    ".": "6060",
    "/": "2010080402",
    ":": "3636",
    "?": "0201590906",
    "_": "4040404040",
}


class Line(NamedTuple):
    """A line of a page.

    Attributes:
        words: Its words.
        top: The row of its upper edge.
        size: How many dots each dot of the letters has on a side.
        light: How bright it is, of 1.
        anchor: Which end of the display, or its middle, it keeps to.
    """

    words: str
    top: int
    size: int = 1
    light: float = 1.0
    anchor: Literal["start", "middle", "end"] = "middle"


class Bar(NamedTuple):
    """A bar on a page: its row, its height, how much of it is lit, of 1."""

    top: int
    height: int
    part: float


class Page(NamedTuple):
    """What the display shows."""

    lines: tuple[Line, ...]
    bars: tuple[Bar, ...] = ()


def width(words: str, size: int = 1) -> int:
    """How many dots wide words are."""
    return size * (sum(len(_glyph(letter)) + BETWEEN for letter in words) - BETWEEN)


@lru_cache(maxsize=128)
def _glyph(letter: str) -> tuple[int, ...]:
    """The columns of a letter; of a small one those of the capital, but for the sign of multiplication."""
    known = _FONT.get(letter) or _FONT.get(letter.upper()) or _FONT["?"]
    return tuple(bytes.fromhex(known))


@lru_cache(maxsize=256)
def _bits(words: str, size: int) -> NDArray[np.float64]:
    """The dots of words, (columns, rows), 1 where lit; a comma hangs one row below the others."""
    columns: list[int] = []
    for letter in words:
        columns.extend((*_glyph(letter), *(0,) * BETWEEN))
    bits = np.array([[column >> row & 1 for row in range(HEIGHT + 1)] for column in columns[:-BETWEEN]], dtype=float)
    return bits.repeat(size, axis=0).repeat(size, axis=1)


def wrapped(words: str, columns: int = COLUMNS) -> list[str]:
    """Words in as few lines as hold them, each at most so many dots wide."""
    lines: list[str] = []
    for word in words.split():
        if lines and width(f"{lines[-1]} {word}") <= columns:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines


def largest(words: str, most: int = 3) -> int:
    """The largest size, up to `most`, at which words fit on the display; 1 at least."""
    return max((size for size in range(1, most + 1) if width(words, size) <= COLUMNS - 2), default=1)


class Dots:
    """The display's picture, made of pages; a dot is `times` as many pixels wide and high as `DOT` says."""

    def __init__(self, unlit: tuple[int, int, int], lit: tuple[int, int, int], times: int = 1) -> None:
        dot = DOT * times
        self.size = (COLUMNS * dot, ROWS * dot)
        self._unlit, self._lit = np.array(unlit, dtype=float), np.array(lit, dtype=float)
        self._small = pygame.Surface((COLUMNS, ROWS), 0, 32)
        mask = np.full((*self.size, 3), 255, np.uint8)
        corners = np.zeros((dot, dot))
        corners[-times:, :] = corners[:, -times:] = 1.0
        mask[np.tile(corners, (COLUMNS, ROWS)) > 0] = 40
        self._mask = pygame.Surface(self.size, 0, 32)
        pygame.surfarray.blit_array(self._mask, mask)
        self._page: Page | None = None
        self._picture = pygame.Surface(self.size, 0, 32)

    def picture(self, page: Page) -> pygame.Surface:
        """The picture of a page; the same one while the page is the same."""
        if page != self._page:
            self._page = page
            self._make(lights_of(page))
        return self._picture

    def _make(self, lights: NDArray[np.float64]) -> None:
        """Make the picture of dots and of the shine round them."""
        colours = self._unlit + lights[:, :, None] * (self._lit - self._unlit)
        pygame.surfarray.blit_array(self._small, colours.astype(np.uint8))
        pygame.transform.scale(self._small, self.size, self._picture)
        self._picture.blit(self._mask, (0, 0), special_flags=pygame.BLEND_RGB_MULT)
        shine = pygame.transform.smoothscale(self._small, (COLUMNS // 2, ROWS // 2))
        shine.fill((70, 70, 70), special_flags=pygame.BLEND_RGB_MULT)
        shine = pygame.transform.smoothscale(shine, self.size)
        self._picture.blit(shine, (0, 0), special_flags=pygame.BLEND_RGB_ADD)


def lights_of(page: Page) -> NDArray[np.float64]:
    """How bright each dot of a page is: (columns, rows), 0 to 1."""
    lights = np.zeros((COLUMNS, ROWS))
    for line in page.lines:
        if not line.words:
            continue
        bits = line.light * _bits(line.words, line.size)
        left = {"start": 1, "middle": (COLUMNS - len(bits)) // 2, "end": COLUMNS - 1 - len(bits)}[line.anchor]
        left = max(0, left)
        shown = bits[: COLUMNS - left, : ROWS - line.top]
        place = lights[left : left + shown.shape[0], line.top : line.top + shown.shape[1]]
        np.maximum(place, shown, out=place)
    for bar in page.bars:
        full = round((COLUMNS - 4) * min(max(bar.part, 0.0), 1.0))
        lights[2 : COLUMNS - 2 : 2, bar.top + bar.height // 2] = 0.35
        lights[2 : 2 + full, bar.top : bar.top + bar.height] = 1.0
    return lights
