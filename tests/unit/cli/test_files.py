"""Pictures, animations, pages and recordings from the command line: whole, or not there; refused early."""

import sys
from pathlib import Path

import pytest

import carom
from carom import draw
from carom.cli import main
from carom.draw.paint import letters

SCENE = """version = 1
[world]
gravity = [0, -10]
[[shapes]]
kind = "segment"
start = [-5, 0]
end = [5, 0]
name = "floor"
[[balls]]
position = [0, 1]
radius = 0.5
"""
BEGINNINGS = {
    "png": b"\x89PNG\r\n\x1a\n",
    "gif": b"GIF89a",
    "html": b"<!doctype html>",
    "carom": b"PK\x03\x04",
    "svg": b"<svg",
}


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with a scene."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "drop.toml").write_text(SCENE)
    return tmp_path


def status_of(*arguments: str) -> int:
    """How a command exits."""
    with pytest.raises(SystemExit) as caught:
        main(list(arguments))
    return int(caught.value.code or 0)


def outs(*names: str) -> list[str]:
    """The options that ask for some files."""
    return [argument for name in names for argument in ("--out", name)]


def test_a_run_makes_every_kind_of_picture(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = [f"drop.{ending}" for ending in (*BEGINNINGS, "mp4")]
    assert status_of("run", "drop.toml", "--seconds", "0.5", "--size", "96", *outs(*names)) == 0
    out = capsys.readouterr().out
    assert [line.split()[1] for line in out.splitlines() if line.startswith("wrote")] == names
    for ending, beginning in BEGINNINGS.items():
        assert (here / f"drop.{ending}").read_bytes().lower().startswith(beginning.lower()), ending
    assert b"ftyp" in (here / "drop.mp4").read_bytes()[:16]
    assert sorted(path.name for path in here.iterdir()) == sorted([*names, "drop.toml"])


def test_a_page_begins_with_the_layers_that_were_asked_for(here: Path) -> None:
    assert status_of("run", "drop.toml", "--seconds", "0.1", "--layers", "cells", *outs("drop.html")) == 0
    page = (here / "drop.html").read_text(encoding="utf-8")
    assert '{"name":"cells","on":true}' in page
    assert page.count('"on":true') == 1


def test_a_recording_is_drawn_later(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert status_of("run", "drop.toml", "--seconds", "0.5", *outs("drop.carom")) == 0
    recording = carom.Recording.load("drop.carom")
    assert (recording.name, len(recording)) == ("drop", 31)
    for name, more in (("end.svg", ()), ("begin.svg", ("--at", "0")), ("drop.gif", ("--size", "96"))):
        assert status_of("show", "drop.carom", *outs(name), *more) == 0
    assert ">0.5\N{NO-BREAK SPACE}s<" in (here / "end.svg").read_text(encoding="utf-8")
    assert ">0\N{NO-BREAK SPACE}s<" in (here / "begin.svg").read_text(encoding="utf-8")
    assert (here / "drop.gif").read_bytes().startswith(b"GIF89a")
    assert ">floor<" in (here / "end.svg").read_text(encoding="utf-8")
    assert ">floor<" not in (here / "begin.svg").read_text(encoding="utf-8")
    capsys.readouterr()
    assert status_of("check", "drop.carom") == 0
    assert capsys.readouterr().out == "drop: good: 31 frames, 1 ball, 1 hit\n"
    assert status_of("show", "drop.carom", "--at", "0.2", *outs("later.html")) == 2
    assert capsys.readouterr().err == "carom: --at 0.2: is for pictures; later.html shows the whole run\n"
    assert status_of("show", "drop.carom", "--at", "99", *outs("later.svg")) == 2
    assert capsys.readouterr().err.startswith("carom: --at 99: the recording goes from 0 to ")
    assert status_of("run", "drop.carom") == 2
    assert "carom show makes pictures of it" in capsys.readouterr().err


def test_steps_shorter_than_frames_are_not_all_recorded(here: Path) -> None:
    assert status_of("run", "drop.toml", "--seconds", "0.1", "--dt", "1/600", *outs("drop.carom")) == 0
    assert len(carom.Recording.load(here / "drop.carom")) == 7


def test_layers_and_themes_are_those_asked_for(here: Path) -> None:
    options = ("--layers", "boxes,names", "--theme", "print", "--size", "1280x720")
    assert status_of("show", "drop.toml", *outs("drop.svg"), *options) == 0
    text = (here / "drop.svg").read_text(encoding="utf-8")
    assert '<g id="boxes">' in text
    assert ">floor<" in text
    assert '<g id="balls">' not in text
    assert 'width="1280" height="720"' in text
    assert ".f-paper{fill:#ffffff}" in text


@pytest.mark.parametrize(("name", "told"), [("drop.png", "raster pictures need pygame-ce"), ("drop.gif", "pygame-ce")])
def test_a_missing_extra_is_told_before_the_run(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, name: str, told: str
) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    assert status_of("run", "drop.toml", *outs(name)) == 1
    printed = capsys.readouterr()
    assert printed.out == ""
    assert told in printed.err
    assert printed.err.endswith('pip install "carom[draw]"\n')
    assert printed.err.count("\n") == 1
    assert [path.name for path in here.iterdir()] == ["drop.toml"]


def test_a_missing_encoder_is_told_before_the_run(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    assert status_of("run", "drop.toml", *outs("drop.mp4")) == 1
    assert capsys.readouterr().err == 'carom: animations need imageio-ffmpeg: pip install "carom[draw]"\n'


@pytest.mark.parametrize("name", ["drop.png", "drop.gif", "drop.mp4", "drop.carom", "drop.html"])
def test_a_full_disk_leaves_no_half_of_a_file(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    (here / name).write_text("old")

    def full(path: Path, *_: object, **__: object) -> None:
        path.touch()
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    monkeypatch.setattr(Path, "write_text", full)
    monkeypatch.setattr(draw, "write_film", lambda film, path, tell: full(path))
    assert status_of("run", "drop.toml", "--seconds", "0.1", "--size", "96", *outs(name)) == 1
    assert capsys.readouterr().err == f"carom: {name}: cannot be written: No space left on device\n"
    assert (here / name).read_bytes() == b"old"
    assert sorted(path.name for path in here.iterdir()) == sorted(["drop.toml", name])


def test_letters_without_their_fonts_are_said_in_one_line(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    letters.fonts_folder.cache_clear()
    monkeypatch.setattr(letters, "find_spec", lambda name: None)
    assert status_of("show", "drop.toml", *outs("drop.png")) == 0
    letters.fonts_folder.cache_clear()
    assert capsys.readouterr().err == f"carom: {letters.MISSING}\n"
