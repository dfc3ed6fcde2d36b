"""The names of shapes and balls, each where there is room for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.draw.paint.painter import Lettering, Style
from carom.draw.parts.labels import Labels, Wish, placed
from carom.draw.parts.outlines import anchor
from carom.draw.parts.widths import widest

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from carom.draw.paint.painter import Painter
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.labels import Box, Boxes, Label, Place
    from carom.draw.parts.moment import Balls, Drawn
    from carom.draw.picture import Picture
    from carom.shapes.assembly import Assembly
    from carom.shapes.shape import Shape

LABEL = Lettering("text", 11.0, anchor="middle")
GROUND = Style(fill="stage", opacity=0.85)
LEADER = Style("muted", width=1.0)
#: Pixels around the letters that belong to a label, and that are kept clear around a shape's place.
AROUND, CLEAR = 2.0, 3.0
#: Places that a name may stand at, at most.
MOST_PLACES = 8
#: Among more balls than this labels stand where they will.
MOST_BALLS = 500


def draw_names(painter: Painter, picture: Picture) -> None:
    """Write the names of shapes and of balls: those of what stays where they are kept, the others beside them."""
    moving = moving_labels(picture)
    labels = (*picture.labels.found, *moving.found)
    for label in labels:
        if label.leader is not None:
            start, end = label.leader
            painter.segment(picture.frame.world(*start), picture.frame.world(*end), LEADER)
    for label in labels:
        label_mark(painter, picture.frame, label)


def still_labels(frame: Frame, names: Mapping[int, str], still: Iterable[Drawn], balls: Balls) -> Labels:
    """The names of the shapes that never change, which keep off the balls as they are at one time."""
    return placed(tuple(shape_wishes(frame, names, still)), stage_box(frame), ball_boxes(frame, balls))


def moving_labels(picture: Picture) -> Labels:
    """The names of all other shapes and of the balls at a picture's moment."""
    frame, moment = picture.frame, picture.moment
    balls = ball_boxes(frame, moment.balls)
    wishes = (*shape_wishes(frame, picture.names, moment.moving), *ball_wishes(frame, picture.names, moment.balls))
    return placed(wishes, stage_box(frame), balls, picture.labels.boxes())


def stage_box(frame: Frame) -> Box:
    """The stage, in pixels."""
    stage = frame.stage
    return (*frame.pixel(stage.left, stage.top), *frame.pixel(stage.right, stage.bottom))


def ball_boxes(frame: Frame, balls: Balls) -> Boxes:
    """The boxes of the balls in pixels, (n, 4); none where there are more than `MOST_BALLS`."""
    if len(balls.ids) > MOST_BALLS:
        return np.zeros((0, 4))
    x, y = frame.pixel(*balls.centers.T)
    radii = balls.radii * frame.scale
    return np.column_stack((x - radii, y - radii, x + radii, y + radii))


def label_mark(painter: Painter, frame: Frame, label: Label) -> None:
    """Write a label into its box, on a ground that keeps it apart from what is below."""
    left, top, right, bottom = label.box
    corners = ((left, bottom), (right, bottom), (right, top), (left, top))
    painter.polyline(np.array([frame.world(*corner) for corner in corners]), GROUND)
    painter.text(frame.world(0.5 * (left + right), bottom - AROUND - 0.2 * LABEL.size), label.words, LABEL)


def wish(words: str, places: Iterable[Place]) -> Wish:
    """The wish that words stand at one of some places."""
    return Wish(words, LABEL.size * widest(words) + 2.0 * AROUND, LABEL.size + 2.0 * AROUND, tuple(places))


def ball_wishes(frame: Frame, names: Mapping[int, str], balls: Balls) -> Iterator[Wish]:
    """The names of the balls that are on the stage."""
    for center, radius, ball in zip(balls.centers.tolist(), balls.radii.tolist(), balls.ids.tolist(), strict=True):
        if ball in names and frame.shows(*center):
            yield wish(names[ball], [(frame.pixel(*center), radius * frame.scale)])


def shape_wishes(frame: Frame, names: Mapping[int, str], shapes: Iterable[Drawn]) -> Iterator[Wish]:
    """Each name among some shapes, with the places that it may stand at; shapes of one name share a label."""
    groups: dict[str, list[Drawn]] = {}
    for drawn in shapes:
        if drawn.id in names:
            groups.setdefault(names[drawn.id], []).append(drawn)
    for name, members in groups.items():
        places = ((frame.pixel(*anchor(drawn.shape)), CLEAR) for drawn in members[:MOST_PLACES])
        yield wish(shared_label(name, [drawn.whole or drawn.shape for drawn in members]), places)


def shared_label(name: str, members: Iterable[Shape | Assembly]) -> str:
    """The words for all shapes of one name: it, and how many there are; for parts, what they are parts of is given."""
    count = len({id(member) for member in members})
    return name if count == 1 else f"{name} \N{MULTIPLICATION SIGN} {count}"
