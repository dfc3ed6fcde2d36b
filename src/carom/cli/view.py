"""What a picture is to look like: the options that are common to all of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from carom.cli.mistakes import Mistake, no_such
from carom.draw import DEFAULT_LAYERS, Layer, ThemeName
from carom.draw.page.run import FIRST_LAYERS
from carom.draw.parts.frame import LEAST_SIDE, MOST_SIDE

if TYPE_CHECKING:
    from typing import Self

    from carom.draw.parts.frame import Size

ALL = "all"


@dataclass(frozen=True, slots=True)
class View:
    """The colours, the layers and the size of pictures, and the layers that a page shows at first."""

    theme: ThemeName = ThemeName.AUTO
    layers: frozenset[Layer] = DEFAULT_LAYERS
    page_layers: frozenset[Layer] = FIRST_LAYERS
    size: Size = None

    @classmethod
    def of(cls, theme: str, layers: str | None, size: str | None) -> Self:
        """What the options say; raises `Mistake`."""
        view = cls(theme_from(theme), size=None if size is None else size_from(size))
        if layers is None:
            return view
        chosen = layers_from(layers)
        return replace(view, layers=chosen, page_layers=chosen)


def theme_from(text: str) -> ThemeName:
    """The theme that `text` names; raises `Mistake`."""
    if text not in set(ThemeName):
        raise no_such("theme", text, ThemeName, "--theme")
    return ThemeName(text)


def layers_from(text: str) -> frozenset[Layer]:
    """The layers that `text` names, separated by commas, or `all`; raises `Mistake`."""
    if text == ALL:
        return frozenset(Layer)
    known = {layer.value: layer for layer in Layer}
    names = [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in known:
            raise no_such("layer", name, [*known, ALL], "--layers")
    if not names:
        raise Mistake(f"--layers {text}: names no layer; there are {', '.join(known)}, {ALL}")
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
