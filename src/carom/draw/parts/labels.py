"""Where labels stand: each beside what it names, over no other, and over no ball while there is room elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

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


def placed(wishes: Iterable[Wish], stage: Box, balls: Boxes, taken: Sequence[Box] = ()) -> Labels:
    """The labels that have room on the `stage`, one after the other, each at the first place that is free.

    None lies over a box that is `taken`, and none over one of the `balls`, (n, 4), unless there is no other place.
    """
    found: list[Label] = []
    occupied = list(taken)
    left_out = 0
    for wish in wishes:
        label = free_place(wish, stage, balls, np.array(occupied).reshape(-1, 4))
        if label is None:
            left_out += 1
        else:
            occupied.append(label.box)
            found.append(label)
    return Labels(tuple(found), left_out)


def free_place(wish: Wish, stage: Box, balls: Boxes, occupied: Boxes) -> Label | None:
    """The label at the first candidate that is on the stage and over nothing, else over balls alone, or None."""
    over_balls = None
    for label in candidates(wish):
        left, top, right, bottom = label.box
        inside = stage[0] <= left and stage[1] <= top and right <= stage[2] and bottom <= stage[3]
        if not inside or any_overlap(label.box, occupied):
            continue
        if not any_overlap(label.box, balls):
            return label
        over_balls = over_balls or label
    return over_balls


def candidates(wish: Wish) -> Iterator[Label]:
    """The labels that a wish may become: at each side of each place, then farther off."""
    for farther in (0.0, *FARTHER):
        for place, clearance in wish.places:
            for right, below in SIDES:
                box = beside(place, clearance + GAP + farther, right, below, wish)
                yield Label(wish.words, box, (place, nearest(box, place)) if farther else None)


def beside(place: Vector, off: float, right: int, below: int, wish: Wish) -> Box:
    """The box of a wish on one side of a place, so many pixels off it."""
    if right and below:
        off *= SLANT
    x = place[0] + right * (off + 0.5 * wish.width)
    y = place[1] + below * (off + 0.5 * wish.height)
    return x - 0.5 * wish.width, y - 0.5 * wish.height, x + 0.5 * wish.width, y + 0.5 * wish.height


def nearest(box: Box, place: Vector) -> Vector:
    """The point of a box that is nearest to a place."""
    return min(max(place[0], box[0]), box[2]), min(max(place[1], box[1]), box[3])


def any_overlap(box: Box, others: Boxes) -> bool:
    """Whether a box has more than an edge in common with any of some others, (n, 4)."""
    left, top, right, bottom = others.T
    return bool(((box[0] < right) & (left < box[2]) & (box[1] < bottom) & (top < box[3])).any())
