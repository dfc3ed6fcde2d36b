"""How large an SVG drawing is, in what unit, and where its coordinates lie in the scene."""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import isfinite

from carom.scene.drawings.paths import NUMBER, numbers
from carom.scene.drawings.pieces import Matrix, Vector
from carom.scene.drawings.tree import Element

#: Pixels in an inch, as CSS has it.
PIXELS = 96.0
#: Pixels in the units of length that a drawing can be measured in.
UNITS = {"": 1.0, "px": 1.0, "mm": PIXELS / 25.4, "cm": PIXELS / 2.54, "in": PIXELS, "pt": PIXELS / 72.0, "pc": 16.0}

_LENGTH = re.compile(rf"{NUMBER}\s*([a-zA-Z]*|%)")


@dataclass(frozen=True, slots=True)
class Page:
    """The sheet of a drawing: its unit of length in pixels, and its size in that unit (None: not said)."""

    width: float | None
    height: float | None
    unit: float

    def contents(self, root: Element) -> tuple[Matrix, Vector]:
        """Where the contents of the root lie on the sheet, y down, and what 100% are in them."""
        box = view_box(root)
        if box is None:
            scale = 1.0 / self.unit
            return Matrix(scale, 0.0, 0.0, scale), (
                (self.width or 100.0) * self.unit,
                (self.height or 100.0) * self.unit,
            )
        return fitting(root, (0.0, 0.0), (self.width or box[2], self.height or box[3])), (box[2], box[3])


def pixels(text: str, whole: float) -> float:
    """A length in pixels, where 100% are `whole`; raises `ValueError`."""
    try:
        value = float(text)
    except ValueError:
        found = _LENGTH.fullmatch(text.strip())
        if found is None or (found[1] not in {*UNITS, "%"}):
            known = ", ".join(filter(None, UNITS))
            raise ValueError(f"must be a number, with a unit among {known} or %, not {text[:60]!r}") from None
        amount = float(text.strip().removesuffix(found[1]))
        value = 0.01 * whole * amount if found[1] == "%" else UNITS[found[1]] * amount
    if not isfinite(value):
        raise ValueError(f"must be finite, not {text[:60]!r}")
    return value


def view_box(element: Element) -> tuple[float, float, float, float] | None:
    """The view box of an element: x, y, width, height; None where it has none that shows anything."""
    text = element.attributes.get("viewBox")
    if text is None:
        return None
    box = numbers(text)
    if len(box) != 4:
        raise ValueError(f"must be four numbers, not {text[:60]!r}")
    return (box[0], box[1], box[2], box[3]) if box[2] > 0.0 and box[3] > 0.0 else None


def page_of(root: Element) -> Page:
    """The sheet of a drawing, in the unit that its width has; one side follows from the other by the view box."""
    unit: float | None = None
    sides: list[float | None] = []
    for name in ("width", "height"):
        text = root.attributes.get(name, "").strip()
        if text in {"", "auto"} or text.endswith("%"):
            sides.append(None)
            continue
        length = pixels(text, 0.0)
        found = _LENGTH.fullmatch(text)
        own = UNITS[found[1]] if found else 1.0
        unit = own if unit is None else unit
        sides.append(float(text.removesuffix(found[1])) if found and own == unit else length / unit)
    width, height = sides
    box = view_box(root)
    if box is not None:
        if width is None and height is None:
            width, height = box[2], box[3]
        elif width is None and height is not None:
            width = height * box[2] / box[3]
        elif height is None and width is not None:
            height = width * box[3] / box[2]
    return Page(width, height, unit or 1.0)


def fitting(element: Element, corner: Vector, size: Vector) -> Matrix:
    """How the contents of `element` lie in a viewport with an upper left `corner`. Source: SVG 2, 8.2."""
    box = view_box(element)
    if box is None:
        return Matrix(e=corner[0], f=corner[1])
    x, y, width, height = box
    across, along = size[0] / width, size[1] / height
    words = element.attributes.get("preserveAspectRatio", "xMidYMid").split()
    align = words[0] if words else "xMidYMid"
    if align != "none":
        across = along = max(across, along) if "slice" in words else min(across, along)
    shift = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    left = shift.get(align[1:4], 0.0) * (size[0] - width * across)
    top = shift.get(align[5:8], 0.0) * (size[1] - height * along)
    return Matrix(across, 0.0, 0.0, along, corner[0] + left - x * across, corner[1] + top - y * along)
