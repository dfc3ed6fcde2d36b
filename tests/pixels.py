"""Pictures as arrays of colours, for those that compare them with kept ones."""

from __future__ import annotations

import os

import numpy as np
import pytest

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')


def pixels(surface: pygame.Surface) -> np.ndarray:
    """The colours of a surface: (lines, columns, 3)."""
    width, height = surface.get_size()
    return np.frombuffer(pygame.image.tobytes(surface, "RGB"), np.uint8).reshape(height, width, 3).astype(float)


def blocks(picture: np.ndarray, side: int) -> np.ndarray:
    """The mean colours of the blocks of a picture, each so many pixels wide and high."""
    lines, columns = picture.shape[0] // side, picture.shape[1] // side
    cut = picture[: lines * side, : columns * side]
    return cut.reshape(lines, side, columns, side, 3).mean(axis=(1, 3))
