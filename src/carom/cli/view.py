"""What a picture is to look like: the options that are common to all of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import TYPE_CHECKING

from carom.cli.mistakes import Mistake
from carom.draw import DEFAULT_LAYERS, Layer, ThemeName
from carom.draw.frame import LEAST_SIDE, MOST_SIDE
from carom.draw.page_run import FIRST_LAYERS

if TYPE_CHECKING:
    from typing import Self

    from carom.draw.frame import Size

ALL = "all"


@dataclass(frozen=True, slots=True)
class View:
    """The colours, the layers and the size of pictures, and the layers that a page shows at first."""

    theme: ThemeName = ThemeName.AUTO
    layers: frozenset[Layer] = DEFAULT_LAYERS
    page_layers: frozenset[Layer] = FIRST_LAYERS
    size: Size = None

    @classmethod
    def of(cls, theme: ThemeName, layers: str | None, size: str | None) -> Self:
        """What the options say; raises `Mistake`."""
        view = cls(theme, size=None if size is None else size_from(size))
        if layers is None:
            return view
        chosen = layers_from(layers)
        return replace(view, layers=chosen, page_layers=chosen)


def layers_from(text: str) -> frozenset[Layer]:
    """The layers that `text` names, separated by commas, or `all`; raises `Mistake`."""
    if text == ALL:
        return frozenset(Layer)
    known = {layer.value: layer for layer in Layer}
    names = [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in known:
            near = get_close_matches(name, known, n=1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}, and {ALL}"
            raise Mistake(f"--layers {name}: no such layer; {hint}")
    if not names:
        raise Mistake(f"--layers {text}: names no layer; there are {', '.join(known)}, and {ALL}")
    return frozenset(known[name] for name in names)


def size_from(text: str) -> Size:
    """The size that `text` writes: `1280x720`, or the longer side alone; raises `Mistake`."""
    sides = text.lower().split("x")
    if len(sides) > 2 or not all(side.isascii() and side.isdigit() for side in sides):
        raise Mistake(f"--size {text}: must be a width and a height like 1280x720, or a longer side like 800")
    pixels = [int(side[:9]) for side in sides]
    if not all(LEAST_SIDE <= side <= MOST_SIDE for side in pixels):
        raise Mistake(f"--size {text}: must be from {LEAST_SIDE} to {MOST_SIDE} pixels")
    return (pixels[0], pixels[1]) if len(pixels) == 2 else pixels[0]
