"""Films: each frame is the picture of its moment, whichever came before; files play as long as the run took."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw.film.film import FILM_HITS, SPAN
from carom.draw.film.footage import Footage
from carom.draw.film.movie import EncodingError, encoder, frames_of, reason, write_film
from carom.draw.parts.looks import OFF
from tests.worlds import crowded, recorded

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')


@pytest.fixture(scope="module")
def recording() -> carom.Recording:
    """A second of a crowd, in which a ball leaves and a shape is switched off."""
    return recorded(crowded(20), 60, change=30, name="crowd")


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


def test_what_changes_is_drawn_as_it_is(recording: carom.Recording) -> None:
    footage = Footage(recording)
    still = {drawn.id for drawn in footage.still}
    before, looks_before = footage.moment(20, SPAN), {drawn.id: drawn.look for drawn in footage.moment(20, SPAN).moving}
    after, looks_after = footage.moment(50, SPAN), {drawn.id: drawn.look for drawn in footage.moment(50, SPAN).moving}
    first = int(recording.shape_ids[0])
    assert first not in still
    assert looks_before[first] is not OFF
    assert looks_after[first] is OFF
    assert set(recording.moving.tolist()) < set(looks_after)
    assert len(before.balls.ids) == 20
    assert len(after.balls.ids) == 19
    assert footage.facts(20) == (
        ("time", "0.33\N{NO-BREAK SPACE}s"),
        ("balls", "20"),
        ("hits", footage.facts(20)[2][1]),
    )


def test_tracks_and_hits_are_those_of_the_last_seconds(recording: carom.Recording) -> None:
    moment = Footage(recording).moment(60, 0.25, 2)
    assert moment.since == pytest.approx(0.75)
    assert len(moment.hits) == 2
    assert moment.hits["time"].min() >= 0.75
    assert (np.diff(moment.hits["impulse"]) <= 0.0).all()
    ball = int(moment.balls.ids[3])
    (track,) = [track for track in moment.tracks if track.ball == ball]
    assert track.points[-1].tolist() == recording.positions[60, recording.ids == ball][0].tolist()
    assert FILM_HITS > 2


def test_without_shapes_all_places_of_the_balls_are_shown() -> None:
    world = carom.World()
    world.add(carom.Ball((0, 0), 1, velocity=(30, 0)))
    picture = draw.picture_at(carom.Recording.of(world, 0.5))
    assert picture.frame.stage.left < -1.0
    assert picture.frame.stage.right > 16.0
    nothing = draw.picture_at(carom.Recording.of(carom.World(), 0.0))
    assert nothing.frame.shows(0.0, 0.0)


def seconds_in(path: Path) -> float:
    """How long a film plays, as its own encoder reads it."""
    told = subprocess.run([encoder(), "-i", str(path), "-f", "null", "-"], capture_output=True, text=True, check=True)
    hours, minutes, seconds = told.stderr.partition("Duration: ")[2].partition(",")[0].split(":")
    return 3600.0 * float(hours) + 60.0 * float(minutes) + float(seconds)


@pytest.mark.parametrize("ending", ["gif", "mp4"])
def test_a_film_plays_as_long_as_the_run_took(tmp_path: Path, recording: carom.Recording, ending: str) -> None:
    path = tmp_path / f"run.{ending}"
    told: list[tuple[int, int]] = []
    film = draw.Film(recording, size=97, theme=draw.ThemeName.DARK)
    write_film(film, path, lambda done, total: told.append((done, total)))
    rate = {"gif": 20, "mp4": 60}[ending]
    assert seconds_in(path) == pytest.approx((rate + 1) / rate, abs=0.03)
    assert told == [(done, rate + 1) for done in range(1, rate + 2)]
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


def test_each_frame_is_shown_at_its_time(recording: carom.Recording) -> None:
    film = draw.Film(recording, size=97)
    assert frames_of(film, 60) == list(range(61))
    assert frames_of(film, 20) == list(range(0, 61, 3))


def test_an_encoder_that_fails_says_why(tmp_path: Path, recording: carom.Recording) -> None:
    film = draw.Film(recording, size=97)
    for name in ("run.gif", "run.mp4"):
        with pytest.raises(EncodingError, match=r"^No such file or directory$"):
            write_film(film, tmp_path / "missing" / name)


def test_a_file_with_another_ending_is_refused(tmp_path: Path, recording: carom.Recording) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"path must end in \.gif or \.mp4, not .*run\.avi"):
        write_film(draw.Film(recording, size=97), tmp_path / "run.avi")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize("name", ["run.gif", "run.mp4"])
def test_a_full_disk_is_named(tmp_path: Path, recording: carom.Recording, name: str) -> None:
    (tmp_path / name).symlink_to("/dev/full")
    with pytest.raises(EncodingError, match=r"^No space left on device$"):
        write_film(draw.Film(recording, size=97), tmp_path / name)


class Brought:
    """An imageio-ffmpeg that brings another program."""

    def __init__(self, program: Path) -> None:
        self.get_ffmpeg_exe = lambda: str(program)


@pytest.mark.skipif(sys.platform == "win32", reason="the program is a shell script")
def test_an_encoder_that_dies_without_a_word_is_told_by_its_status(
    tmp_path: Path, recording: carom.Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = tmp_path / "ffmpeg"
    program.write_text("#!/bin/sh\nexit 7\n")
    program.chmod(0o755)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", Brought(program))
    with pytest.raises(EncodingError, match="status 7"):
        write_film(draw.Film(recording, size=97), tmp_path / "run.mp4")


def test_what_interrupts_the_frames_ends_the_encoder_too(tmp_path: Path, recording: carom.Recording) -> None:
    film = draw.Film(recording, size=97)

    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_film(film, tmp_path / "run.mp4", stop)
    assert b"moov" not in b"".join(path.read_bytes() for path in tmp_path.iterdir())  # which ends a film that is whole


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (["[x @ 0] Error: No space left on device", "Conversion failed!"], "No space left on device"),
        (["first", "Unknown thing"], "Unknown thing"),
    ],
)
def test_the_reason_is_picked_out_of_what_the_encoder_says(lines: list[str], told: str) -> None:
    assert reason(lines) == told


def test_drawing_a_recording_changes_nothing_in_it(recording: carom.Recording) -> None:
    def state() -> list[Any]:
        return [recording.positions.tobytes(), recording.poses.tobytes(), recording.hits.tobytes()]

    before = state()
    draw.Film(recording, size=97).frame(30)
    assert state() == before
