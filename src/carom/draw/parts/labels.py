"""Where labels stand: each beside what it names, over no other, and over no ball while there is room elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.draw.paint.painter import Vector

#: Left, top, right and bottom, in pixels.
Box: TypeAlias = tuple[float, float, float, float]
Boxes: TypeAlias = NDArray[np.float64]
#: The pixel that a label may stand at, and how many pixels around it are to be kept clear.
Place: TypeAlias = tuple["Vector", float]

#: Pixels between a label and what it names, and what comes on top of them where there is no room: a line leads there.
GAP = 5.0
FARTHER = (18.0, 40.0)
#: The sides of a place that a label may stand at, in order: right (1) or left (-1) of it, and below (1) or above (-1).
SIDES = ((0, -1), (0, 1), (1, 0), (-1, 0), (1, -1), (-1, -1), (1, 1), (-1, 1))
#: What a label's nearest corner keeps of the distance, in x and in y, where it stands at a slant.
SLANT = 0.7


@dataclass(frozen=True, slots=True)
class Wish:
    """Words that are to stand at one of some places, the first before all, in a box of some pixels."""

    words: str
    width: float
    height: float
    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Label:
    """Words in their box; `leader` is the line to what they name, in pixels, where they stand farther from it."""

    words: str
    box: Box
    leader: tuple[Vector, Vector] | None = None


@dataclass(frozen=True, slots=True)
class Labels:
    """Labels that lie over none of each other, and how many others found no room."""

    found: tuple[Label, ...] = ()
    left_out: int = 0

    def boxes(self) -> list[Box]:
        """The boxes of all of them."""
        return [label.box for label in self.found]


def placed(wishes: Sequence[Wish], stage: Box, balls: Boxes, taken: Sequence[Box] = ()) -> Labels:
    """The labels that have room on the `stage`, one after the other, each at the first place that is free.

    None lies over a box that is `taken`, and none over one of the `balls`, (n, 4), unless there is no other place.
    """
    found: list[Label] = []
    occupied = np.zeros((len(taken) + len(wishes), 4))
    occupied[: len(taken)] = np.reshape(taken, (-1, 4))
    for wish in wishes:
        label = free_label(wish, stage, balls, occupied[: len(taken) + len(found)])
        if label is not None:
            occupied[len(taken) + len(found)] = label.box
            found.append(label)
    return Labels(tuple(found), len(wishes) - len(found))


def free_label(wish: Wish, stage: Box, balls: Boxes, occupied: Boxes) -> Label | None:
    """The label in the first box that is on the stage and over nothing, else over balls alone, or None."""
    boxes = candidates(wish)
    inside = (boxes[:, :2] >= stage[:2]).all(axis=1) & (boxes[:, 2:] <= stage[2:]).all(axis=1)
    free = inside & ~over_any(boxes, occupied)
    clear = free & ~over_any(boxes, balls)
    choice = clear if clear.any() else free
    if not choice.any():
        return None
    number = int(choice.argmax())
    left, top, right, bottom = boxes[number].tolist()
    box = (left, top, right, bottom)
    farther, place = divmod(number // len(SIDES), len(wish.places))
    middle = wish.places[place][0]
    return Label(wish.words, box, (middle, nearest(box, middle)) if farther else None)


def candidates(wish: Wish) -> Boxes:
    """The boxes that a wish may fill, (n, 4): at each side of each place, then the same farther off."""
    places = np.array([(*place, clearance + GAP) for place, clearance in wish.places])
    off = np.array((0.0, *FARTHER))[:, None] + places[:, 2]
    ways = np.array(SIDES, dtype=np.float64)
    slant = np.where(ways.all(axis=1), SLANT, 1.0)
    half = 0.5 * np.array((wish.width, wish.height))
    middles = places[:, None, :2] + ways * (off[:, :, None, None] * slant[:, None] + half)
    return np.concatenate((middles - half, middles + half), axis=-1).reshape(-1, 4)


def nearest(box: Box, place: Vector) -> Vector:
    """The point of a box that is nearest to a place."""
    return min(max(place[0], box[0]), box[2]), min(max(place[1], box[1]), box[3])


def over_any(boxes: Boxes, others: Boxes) -> NDArray[np.bool_]:
    """Which of some boxes, (n, 4), have more than an edge in common with any of some others, (m, 4)."""
    left, top, right, bottom = boxes.T[:, :, None]
    apart = (left >= others[:, 2]) | (others[:, 0] >= right) | (top >= others[:, 3]) | (others[:, 1] >= bottom)
    over: NDArray[np.bool_] = ~apart.all(axis=1)
    return over
