"""Films as files: they play as long as the run took, and an encoder that fails says why."""

import subprocess
import sys
from pathlib import Path

import pytest

import carom
from carom import draw
from carom.draw.film.movie import EncodingError, encoder, frames_of, reason, write_film

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')


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


@pytest.mark.slow
def test_films_of_one_size_follow_each_other(tmp_path: Path, recording: carom.Recording) -> None:
    films = [draw.Film(recording, size=(97, 64), theme=theme) for theme in (draw.ThemeName.DARK, draw.ThemeName.LIGHT)]
    told: list[tuple[int, int]] = []
    write_film(films, tmp_path / "runs.mp4", lambda done, total: told.append((done, total)))
    assert seconds_in(tmp_path / "runs.mp4") == pytest.approx(2 * 61 / 60, abs=0.03)
    assert told[-1] == (122, 122)
    write_film(films, tmp_path / "runs.gif")
    assert seconds_in(tmp_path / "runs.gif") == pytest.approx(2 * 21 / 20, abs=0.05)
    other = draw.Film(recording, size=(99, 64))
    for wrong in ([films[0], other], []):
        with pytest.raises(carom.InvalidArgument, match="film must be one or several of the same size"):
            write_film(wrong, tmp_path / "runs.mp4")


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


class Silent:
    """An imageio-ffmpeg without an ffmpeg."""

    @staticmethod
    def get_ffmpeg_exe() -> str:
        """Do nothing: there is none."""
        raise RuntimeError("No ffmpeg exe could be found.")


def test_an_encoder_that_is_not_brought_for_this_machine_is_missing_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", Silent)
    with pytest.raises(carom.MissingExtra, match="does not bring for this machine"):
        encoder()
