"""What a picture is to look like: the options that are common to all of them."""

from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING

from carom.cli.mistakes import Mistake
from carom.draw import DEFAULT_LAYERS, Layer, ThemeName

if TYPE_CHECKING:
    from carom.draw.frame import Size

#: Pixels: the sides that a picture may have.
LEAST_SIDE, MOST_SIDE = 64, 8192
ALL = "all"


@dataclass(frozen=True, slots=True)
class View:
    """The colours, the layers and the size of pictures."""

    theme: ThemeName = ThemeName.AUTO
    layers: frozenset[Layer] = DEFAULT_LAYERS
    size: Size = None


def layers_from(text: str | None) -> frozenset[Layer]:
    """The layers that `text` names, separated by commas, or `all`; raises `Mistake`."""
    if text is None:
        return DEFAULT_LAYERS
    if text == ALL:
        return frozenset(Layer)
    known = {layer.value: layer for layer in Layer}
    names = [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in known:
            near = get_close_matches(name, known, n=1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}, and {ALL}"
            raise Mistake(f"--layers {name}: no such layer; {hint}")
    return frozenset(known[name] for name in names)


def size_from(text: str | None) -> Size:
    """The size that `text` writes: `1280x720`, or the longer side alone; raises `Mistake`."""
    if text is None:
        return None
    sides = text.lower().split("x")
    if len(sides) > 2 or not all(side.isascii() and side.isdigit() for side in sides):
        raise Mistake(f"--size {text}: must be a width and a height like 1280x720, or a longer side like 800")
    pixels = [int(side[:9]) for side in sides]
    if not all(LEAST_SIDE <= side <= MOST_SIDE for side in pixels):
        raise Mistake(f"--size {text}: must be from {LEAST_SIDE} to {MOST_SIDE} pixels")
    return (pixels[0], pixels[1]) if len(pixels) == 2 else pixels[0]
