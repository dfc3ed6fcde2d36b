"""Pictures compared with kept ones: strictly where there are marks, loosely where there are words.

Marks are carom's own pixels, the same everywhere but for the last digit. Letters are those of the font renderer that
pygame brings, another one in another version; so of a word only how dark it is as a whole is compared.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from carom import draw
from tests.pixels import blocks, pixels, pygame

KEPT = Path(__file__).parent / "kept"
#: Pixels: the side of the blocks whose mean colours are compared.
BLOCK = 4
#: Levels of 255 by which the mean of a block, and of a word with what is around it, may differ from the kept one.
MOST_MARKS, MOST_WORDS = 24.0, 8.0
#: Bytes that a kept picture may have.
LARGEST = 70_000
RENEW = "pytest tests/pictures --renew-pictures"


class Noting(draw.RasterPainter):
    """A painter that notes where words are: left, top, right, bottom, in pixels."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.words: list[tuple[int, int, int, int]] = []

    def text(self, position: tuple[float, float], words: str, lettering: draw.Lettering) -> None:
        """Note where one line of words is, then write it."""
        x, y = self._pixel(*position)
        size = lettering.size * self._zoom
        width = 0.75 * size * len(words) + 4.0
        left = x - width * {"start": 0.0, "middle": 0.5, "end": 1.0}[lettering.anchor]
        self.words.append((int(left) - 4, int(y - size) - 2, int(left + width) + 8, int(y + 0.4 * size) + 3))
        super().text(position, words, lettering)


def check(name: str, picture: draw.Picture, theme: draw.ThemeName, *, renew: bool, folder: Path) -> None:
    """Fail unless a picture is the kept one of that name, or keep it if it is to be renewed."""
    painter = Noting(picture.frame, theme)
    picture.draw(painter)
    data = painter.png()
    assert len(data) < LARGEST, f"{name} has {len(data)} bytes: make it smaller"
    path = KEPT / f"{name}.png"
    if renew:
        path.write_bytes(data)
        return
    assert path.is_file(), f"there is no kept picture {path.name}; look at it and keep it: {RENEW}"
    kept = pygame.image.load(path)
    faults = differences(pixels(painter.surface), pixels(kept), painter.words)
    if faults:
        made = folder / f"{name}.png"
        made.write_bytes(data)
        pytest.fail(f"{made} is not {path}: {'; '.join(faults[:4])}. If it is right: {RENEW}")


def differences(made: np.ndarray, kept: np.ndarray, words: list[tuple[int, int, int, int]]) -> list[str]:
    """Where two pictures differ by more than they may, in words."""
    if made.shape != kept.shape:
        return [f"it is {made.shape[1]} by {made.shape[0]} pixels, not {kept.shape[1]} by {kept.shape[0]}"]
    faults = []
    plain = np.ones(made.shape[:2], dtype=bool)
    for left, top, right, bottom in words:
        box = slice(max(0, top), max(0, bottom)), slice(max(0, left), max(0, right))
        plain[box] = False
        difference = np.abs(made[box].mean(axis=(0, 1)) - kept[box].mean(axis=(0, 1))).max(initial=0.0)
        if difference > MOST_WORDS:
            faults.append(f"the words at ({left}, {top}) differ by {difference:.0f} levels")
    masked = np.abs(blocks(made * plain[:, :, None], BLOCK) - blocks(kept * plain[:, :, None], BLOCK)).max(axis=2)
    lines, columns = np.nonzero(masked > MOST_MARKS)
    faults += [
        f"around ({BLOCK * column}, {BLOCK * line}) it differs by {masked[line, column]:.0f} levels"
        for line, column in zip(lines.tolist(), columns.tolist(), strict=True)
    ]
    return faults
