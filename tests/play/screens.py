"""Screens of games compared with kept ones, at half their size and in blocks: what is there, not how letters are made.

The renderer of letters and of smooth edges is pygame's, another one in another version; so a few blocks may differ.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.pixels import blocks, pixels, pygame

KEPT = Path(__file__).parent / "kept"
#: Pixels of the kept picture: the side of the blocks whose mean colours are compared.
BLOCK = 6
#: Levels of 255 by which the mean of a block may differ, and the part of the blocks that may differ by more.
MOST_LEVELS, MOST_BLOCKS = 20.0, 0.002
#: Before this version pygame-ce drew letters of another width.
LETTERS_SINCE = (2, 5, 7)
#: Bytes that a kept picture may have.
LARGEST = 160_000


def check(name: str, surface: pygame.Surface, *, renew: bool, folder: Path) -> None:
    """Fail unless a screen is the kept one of that name, or keep it if it is to be renewed."""
    if pygame.version.vernum < LETTERS_SINCE:
        pytest.skip(f"pygame-ce {pygame.version.ver} draws other letters than those kept")
    half = pygame.transform.smoothscale(surface.convert(24), [side // 2 for side in surface.get_size()])
    path = KEPT / f"{name}.png"
    made = path if renew else folder / f"{name}.png"
    pygame.image.save(half, made)
    if renew:
        assert path.stat().st_size < LARGEST, f"{name} has {path.stat().st_size} bytes: show less of it"
        return
    assert path.is_file(), f"there is no kept screen {path.name}; look at it and keep it: pytest --renew-pictures"
    kept = pygame.image.load(path)
    assert half.get_size() == kept.get_size(), f"{made} has another size than {path}"
    part = different(half, kept)
    assert part <= MOST_BLOCKS, (
        f"{made} is not {path}: {100 * part:.1f} % of it differ. If it is right: --renew-pictures"
    )


def different(made: pygame.Surface, kept: pygame.Surface) -> float:
    """The part of the blocks in which two pictures differ."""
    differences = np.abs(blocks(pixels(made), BLOCK) - blocks(pixels(kept), BLOCK)).max(axis=2)
    return float((differences > MOST_LEVELS).mean())
