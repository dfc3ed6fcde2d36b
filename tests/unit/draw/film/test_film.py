"""Films: each frame is the picture of its moment, whichever came before; files play as long as the run took."""

from typing import Any

import numpy as np
import pytest

import carom
from carom import draw

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')


@pytest.mark.slow
def test_a_frame_is_the_same_whatever_came_before(recording: carom.Recording) -> None:
    film = draw.Film(recording, layers=list(draw.Layer), size=(700, 560))
    first = film.rgb(45)
    for frame in (0, 60, 10):
        film.frame(frame)
    assert film.rgb(45) == first
    assert film.rgb(44) != first
    assert len(first) == 3 * 700 * 560
    assert film.pixels == (700, 560)


@pytest.mark.parametrize("frame", [61, -62, 1.5, "1"])
def test_a_frame_that_is_not_there_is_refused(recording: carom.Recording, frame: Any) -> None:
    for show in (draw.Film(recording, size=97).frame, lambda frame: draw.picture_at(recording, frame)):
        with pytest.raises(carom.InvalidArgument, match="frame"):
            show(frame)


def test_a_film_shows_what_a_picture_shows(recording: carom.Recording) -> None:
    layers = [draw.Layer.SHAPES, draw.Layer.BALLS]
    film = draw.Film(recording, layers=layers, size=320)
    picture = draw.picture_at(recording, 60, layers=layers, size=320)
    painter = draw.RasterPainter(picture.frame)
    picture.draw(painter)
    made, kept = (np.frombuffer(data, np.uint8).astype(float) for data in (film.rgb(60), painter.rgb()))
    assert np.abs(made - kept).mean() < 0.5


def test_drawing_a_recording_changes_nothing_in_it(recording: carom.Recording) -> None:
    def state() -> list[Any]:
        return [recording.positions.tobytes(), recording.poses.tobytes(), recording.hits.tobytes()]

    before = state()
    draw.Film(recording, size=97).frame(30)
    assert state() == before
