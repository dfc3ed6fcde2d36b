"""A scene is found by the name of a shipped one, or in a file, and is called what it or its file is called."""

import os
from pathlib import Path

import pytest

import carom
from carom.cli.mistakes import Mistake
from carom.cli.sources import find, shipped
from tests.drawings import svg
from tests.worlds import quiet


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.slow
def test_every_shipped_scene_is_found_and_has_a_line_about_it() -> None:
    assert tuple(source.name for source in shipped()) == carom.scenes.names()
    for source in shipped():
        assert find(source.name) == source
        assert source.scene() == carom.scenes.by_name(source.name)
        assert source.path is None
        assert source.recording is None
        assert source.about.endswith((".", ",", ":"))
        assert "\n" not in source.about


def test_a_shipped_scene_has_a_title_and_a_picture_after_its_name() -> None:
    cradle = find("newtons_cradle")
    assert (cradle.title, cradle.picture) == ("Newton's cradle", Path("newtons_cradle.svg"))


@pytest.mark.parametrize(("name", "told"), [("a scene", "a scene"), (None, "table")])
def test_a_file_is_called_what_its_scene_is_called_or_as_it_is(here: Path, name: str | None, told: str) -> None:
    (here / "folder").mkdir()
    scene = carom.Scene(name=name, balls=[carom.Ball((0, 0), 1)])
    scene.save("folder/table.toml")
    source = find("folder/table.toml")
    assert (source.name, source.title, source.about) == (told, told, "")
    assert (source.path, source.picture) == (Path("folder/table.toml"), Path("table.svg"))
    assert source.scene() == scene


def test_a_drawing_is_found_and_says_once_what_was_left_out(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "table.svg").write_text(svg('<line x2="9"/><text>a</text>'))
    source = find("table.svg")
    assert (source.name, source.picture) == ("table", Path("table-picture.svg"))
    assert [shape.kind for shape in source.scene().shapes] == ["segment"]
    assert capsys.readouterr().err == "carom: table.svg: not understood, and left out: text (1)\n"


@pytest.mark.parametrize("name", ["run.carom", "run.CAROM"])
def test_a_recording_is_found_with_its_scene(name: str) -> None:
    world = quiet()
    scene = carom.Scene.from_world(world)
    carom.Recording.of(world, 0.1, name="two balls", about="They fall.").save(name)
    source = find(name)
    assert (source.name, source.about, source.picture) == ("two balls", "They fall.", Path("run.svg"))
    assert source.recording is not None
    assert len(source.recording) == 7
    assert source.scene() == scene


@pytest.mark.parametrize("folder", ["", "tables/"])
def test_a_misspelt_file_is_asked_for_by_its_name(here: Path, folder: str) -> None:
    (here / folder).mkdir(exist_ok=True)
    for name in ("table.toml", "table.txt"):
        (here / folder / name).write_text("")
    with pytest.raises(Mistake, match=rf"did you mean {folder}table\.toml\?"):
        find(f"{folder}tabel.toml")
    with pytest.raises(Mistake, match="shipped are"):
        find("nowhere/qqq.toml")


def test_a_shipped_scene_comes_before_a_file_of_its_name(here: Path) -> None:
    (here / "toy").write_text("no scene")
    assert find("toy").path is None


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("tyo", "tyo: no such file, and no shipped scene of that name; did you mean toy?"),
        ("qqq", f"qqq: no such file, and no shipped scene of that name; shipped are {', '.join(carom.scenes.names())}"),
        (".", ".: is a folder, not a scene file"),
        ("", f"the name of a scene must not be empty; shipped are {', '.join(carom.scenes.names())}"),
        ("n" * 300, f"{'n' * 300}: cannot be read: File name too long"),
    ],
)
def test_what_is_no_scene_is_a_mistake(text: str, told: str) -> None:
    with pytest.raises(Mistake) as caught:
        find(text)
    assert str(caught.value) == told


@pytest.mark.skipif(not Path(os.devnull).exists(), reason="devices are no files here")
def test_a_device_is_no_scene() -> None:
    with pytest.raises(Mistake, match=f"{os.devnull}: is a device or the like, not a scene file"):
        find(os.devnull)
