"""The page's painter keeps what it is told, for every zoom."""

import json

import numpy as np
import pytest

from carom.draw.page.painter import PagePainter, plain_style, record_into
from carom.draw.paint.painter import Lettering, Painter, Style
from carom.draw.parts.frame import Frame
from carom.draw.parts.marks import arrow_mark, pivot_mark
from carom.shapes.aabb import Aabb

WALL = Style("wall", width=2.0)
WORDS = Lettering("text", 12.0)


def frame_of(scale: float) -> Frame:
    """A frame of so many pixels per unit of length."""
    return Frame(100.0, 100.0, Aabb(0.0, 0.0, 10.0, 10.0), scale, 0.0, 0.0)


def test_every_call_is_kept_in_order_with_its_style() -> None:
    painter = PagePainter()
    painter.layer("one")
    painter.segment((0.0, 1.0), (2.0, 3.0), WALL)
    painter.circle((1.0, 1.0), 2.0, WALL)
    painter.arc((1.0, 2.0), 3.0, 0.5, 1.5, WALL)
    painter.layer("two")
    painter.polyline(np.array([[0, 0], [1, 1], [2, 0]]), WALL)
    painter.text((5.0, 6.0), "words", WORDS)
    painter.layer("one")
    painter.circle((9.0, 9.0), 1.0, Style(fill="hit"))
    assert painter.layers == {
        "one": [
            ["segment", 0, [0.0, 1.0, 2.0, 3.0], None],
            ["circle", 0, [1.0, 1.0, 2.0], None],
            ["arc", 0, [1.0, 2.0, 3.0, 0.5, 1.5], None],
            ["circle", 2, [9.0, 9.0, 1.0], None],
        ],
        "two": [
            ["polyline", 0, [0.0, 0.0, 1.0, 1.0, 2.0, 0.0], None],
            ["text", 1, [5.0, 6.0], None, "words"],
        ],
    }
    assert painter.styles == [WALL, WORDS, Style(fill="hit")]
    assert json.loads(json.dumps(plain_style(WALL)))["stroke"] == "wall"


def test_a_layer_without_marks_is_not_kept() -> None:
    painter = PagePainter()
    painter.layer("empty")
    assert painter.layers == {}


def test_a_place_has_no_pixels_and_a_dot_is_nothing_else() -> None:
    def draw(painter: Painter, frame: Frame) -> None:
        painter.layer("marks")
        painter.segment((1.0, 2.0), (3.0, 4.0), WALL)
        painter.circle((5.0, 6.0), frame.units(3.0), WALL)

    painter = PagePainter()
    record_into(painter, frame_of(7.0), draw)
    assert painter.layers["marks"] == [
        ["segment", 0, [1.0, 2.0, 3.0, 4.0], None],
        ["circle", 0, [5.0, 6.0, 0.0], [0.0, 0.0, 3.0]],
    ]


@pytest.mark.parametrize("scale", [0.3, 7.0, 5000.0])
def test_marks_are_right_at_every_zoom(scale: float) -> None:
    def draw(painter: Painter, frame: Frame) -> None:
        painter.layer("marks")
        arrow_mark(painter, frame, (5.0, 1e5), (0.6, 0.8), WALL)
        pivot_mark(painter, frame, (2.0, 3.0))

    kept = PagePainter()
    record_into(kept, frame_of(11.0), draw)
    direct = PagePainter()
    draw(direct, frame_of(scale))
    for call, wanted in zip(kept.layers["marks"], direct.layers["marks"], strict=True):
        pixels = call[3] or [0.0] * len(call[2])
        numbers = [world + pixel / scale for world, pixel in zip(call[2], pixels, strict=True)]
        assert numbers == pytest.approx(wanted[2], abs=0.01 / scale + 1e-6)


def test_what_was_recorded_before_stays_as_it_was() -> None:
    painter = PagePainter()
    for name in ("first", "second"):

        def draw(painter: Painter, frame: Frame, name: str = name) -> None:
            painter.layer(name)
            painter.circle((1.0, 1.0), frame.units(4.0), WALL)

        record_into(painter, frame_of(2.0), draw)
    assert painter.layers["first"] == painter.layers["second"] == [["circle", 0, [1.0, 1.0, 0.0], [0.0, 0.0, 4.0]]]
