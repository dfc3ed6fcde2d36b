"""The names of shapes and balls, each where there is room for it."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from carom.draw.paint.painter import Lettering, Style
from carom.draw.parts.outlines import anchor
from carom.draw.parts.panel import CHARACTER_WIDTH

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.moment import Drawn
    from carom.draw.picture import Picture
    from carom.shapes.shape import Shape

    #: Left, top, right and bottom, in pixels.
    Box: TypeAlias = tuple[float, float, float, float]

LABEL = Lettering("text", 11.0, anchor="middle")
GROUND = Style(fill="stage", opacity=0.85)
#: Pixels around the letters that belong to a label, and between it and what it names.
AROUND, GAP = 2.0, 5.0
#: Places that a name may stand at, at most.
MOST_PLACES = 8
#: What a character is wide, in heights of a letter, at most times: a label is to be wider than its letters.
WIDE = 1.08 * CHARACTER_WIDTH


def draw_shape_names(painter: Painter, picture: Picture) -> None:
    """Write the names of the shapes that never change."""
    for words, box in placed(picture.frame, shape_wishes(picture, picture.still), []):
        label_mark(painter, picture.frame, words, box)


def draw_moving_names(painter: Painter, picture: Picture) -> None:
    """Write the names of all other shapes and of the balls, beside those that are written already."""
    frame, balls = picture.frame, picture.moment.balls
    taken = [box for _, box in placed(frame, shape_wishes(picture, picture.still), [])]
    wishes = list(shape_wishes(picture, picture.moment.moving))
    for center, radius, ball in zip(balls.centers.tolist(), balls.radii.tolist(), balls.ids.tolist(), strict=True):
        if ball in picture.names and frame.shows(*center):
            wishes.append((picture.names[ball], [(frame.pixel(*center), radius * frame.scale)]))
    for words, box in placed(frame, wishes, taken):
        label_mark(painter, frame, words, box)


def label_mark(painter: Painter, frame: Frame, words: str, box: Box) -> None:
    """Write a label into a box, on a ground that keeps it apart from what is below."""
    left, top, right, bottom = box
    corners = ((left, bottom), (right, bottom), (right, top), (left, top))
    painter.polyline(np.array([frame.world(*corner) for corner in corners]), GROUND)
    painter.text(frame.world(0.5 * (left + right), bottom - AROUND - 0.2 * LABEL.size), words, LABEL)


def shape_wishes(picture: Picture, shapes: Iterable[Drawn]) -> Iterator[tuple[str, list[tuple[Vector, float]]]]:
    """Each name among some shapes, with the places (and the pixels to keep off them) that it may stand at.

    Shapes of one name share a label.
    """
    groups: dict[str, list[Shape]] = {}
    for drawn in shapes:
        if drawn.id in picture.names:
            groups.setdefault(picture.names[drawn.id], []).append(drawn.shape)
    for name, members in groups.items():
        places = [(picture.frame.pixel(*anchor(shape)), 3.0) for shape in members[:MOST_PLACES]]
        yield shared_label(name, members), places


def shared_label(name: str, members: Iterable[Shape]) -> str:
    """The words for all shapes of one name: it, and how many there are, the parts of a compound or group being one."""
    count = len({id(shape.compound or shape.group or shape) for shape in members})
    return name if count == 1 else f"{name} \N{MULTIPLICATION SIGN} {count}"


def placed(
    frame: Frame, wishes: Iterable[tuple[str, list[tuple[Vector, float]]]], taken: list[Box]
) -> list[tuple[str, Box]]:
    """The labels that have room, each with its box: on the stage, and over none of the boxes that are `taken`."""
    left, top = frame.pixel(frame.stage.left, frame.stage.top)
    right, bottom = frame.pixel(frame.stage.right, frame.stage.bottom)
    found: list[tuple[str, Box]] = []
    occupied = list(taken)
    for words, places in wishes:
        width, height = WIDE * LABEL.size * len(words) + 2.0 * AROUND, LABEL.size + 2.0 * AROUND
        for box in candidates(places, width, height):
            inside = left <= box[0] and top <= box[1] and box[2] <= right and box[3] <= bottom
            if inside and not any(overlap(box, other) for other in occupied):
                occupied.append(box)
                found.append((words, box))
                break
    return found


def candidates(places: list[tuple[Vector, float]], width: float, height: float) -> Iterator[Box]:
    """The boxes that a label may fill: above, below, right and left of each place."""
    for (x, y), clearance in places:
        off = clearance + GAP
        for middle_x, middle_y in (
            (x, y - off - 0.5 * height),
            (x, y + off + 0.5 * height),
            (x + off + 0.5 * width, y),
            (x - off - 0.5 * width, y),
        ):
            yield (
                middle_x - 0.5 * width,
                middle_y - 0.5 * height,
                middle_x + 0.5 * width,
                middle_y + 0.5 * height,
            )


def overlap(one: Box, other: Box) -> bool:
    """Whether two boxes have more than an edge in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
