"""Scene files: what cannot be read says where and why, and saving leaves a whole file or the one before."""

import json
import os
import re
import stat
from pathlib import Path
from typing import Any

import pytest
import tomli_w
from hypothesis import given

import carom
from carom.scene import files
from tests.scene_tables import tables_of_scenes

SCENE = carom.Scene(
    name='a "scene" of\nlines, \\ and \x7f and ä',
    shapes=[
        {"kind": "segment", "start": (0, 0), "end": (1, -0.0), "name": "ground"},
        carom.Circle((0.1, 1e-300), 1e16, solid=True),
    ],
    balls=[{"position": (1 / 3, 2.0), "radius": 0.5, "velocity": (-0.0, 5e-324)}],
    guard=True,
)


def fault_of(path: Path, data: bytes) -> str:
    """What loading a file with `data` says, without the file's name."""
    path.write_bytes(data)
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene.load(path)
    assert str(caught.value).startswith(f"{path}: ")
    return str(caught.value).removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (b"version = ", "Invalid value (at end of document)"),
        (b"version = 1\n[world]\ngravity = [0, 0", "Unclosed array (at end of document)"),
        (b"version = 1\nversion = 1\n", "Cannot overwrite a value (at line 2, column 12)"),
        (b'version = 1\nname = "\xff"\n', "is not UTF-8: invalid start byte (at byte 20)"),
        (b"version = 1\nname = " + b"[" * 100_000, "nested too deeply: more than 16 levels"),
        (b"", "version: is missing"),
        (b"version = 2", "version: must be 1, not 2"),
        (b"version = 1979-05-27", "version: must be 1, not datetime.date(1979, 5, 27)"),
        (b"version = 1\nguard = 1e999", "guard: must be true or false, not inf"),
    ],
)
def test_bad_toml_is_refused_with_its_place(tmp_path: Path, data: bytes, fault: str) -> None:
    assert fault_of(tmp_path / "bad.toml", data) == fault


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (b"", "Expecting value: line 1 column 1 (char 0)"),
        (b'{"version": 1,', "Expecting property name enclosed in double quotes: line 1 column 15 (char 14)"),
        (b"[]", "must hold one table, not a list"),
        (b"null", "must hold one table, not a NoneType"),
        (b'{"version": 1, "version": 1}', "'version' stands twice in one table"),
        (b"\xfe\xff", "is not UTF-8: invalid start byte (at byte 0)"),
        (b'{"version":' + b"[" * 100_000, "nested too deeply: more than 16 levels"),
        (b'{"version": 1, "world": {"friction": NaN}}', "world.friction: must be finite, not nan"),
        (b'{"version": 1, "world": {"friction": -Infinity}}', "world.friction: must be finite, not -inf"),
        (b'{"version": 1, "name": null, "guard": null}', "guard: must be true or false, not None"),
        (b'{"version": 1, "name": "\\ud800"}', "name: must be text that UTF-8 can hold, not '\\ud800'"),
    ],
)
def test_bad_json_is_refused_with_its_place(tmp_path: Path, data: bytes, fault: str) -> None:
    assert fault_of(tmp_path / "bad.json", data).startswith(fault)


def test_a_number_of_too_many_digits_is_refused(tmp_path: Path) -> None:
    assert "4300 digits" in fault_of(tmp_path / "bad.json", b'{"version": ' + b"1" * 5000 + b"}")
    assert "4300 digits" in fault_of(tmp_path / "bad.toml", b"version = " + b"1" * 5000)


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    for path in (tmp_path / "none.toml", tmp_path / "none" / "none.json"):
        with pytest.raises(carom.SceneError, match=r"none\.(toml|json): cannot be read: No such file or directory"):
            carom.Scene.load(path)


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    folder = tmp_path / "folder.toml"
    folder.mkdir()
    with pytest.raises(carom.SceneError, match=r"folder\.toml: cannot be read: Is a directory"):
        carom.Scene.load(folder)
    with pytest.raises(carom.SceneError, match=r"folder\.toml: cannot be written: "):
        SCENE.save(folder)
    assert list(tmp_path.iterdir()) == [folder]


@pytest.mark.parametrize("name", ["scene", "scene.yaml", "scene.toml.bak", ".toml"])
def test_an_unknown_ending_is_refused(tmp_path: Path, name: str) -> None:
    for act in (carom.Scene.load, SCENE.save):
        with pytest.raises(carom.SceneError, match=r"must end in \.toml or \.json, not '"):
            act(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("path", [None, 3, b"scene.toml", 1.5, "a\0b.toml"])
def test_what_is_no_path_is_refused(path: Any) -> None:
    for act in (carom.Scene.load, SCENE.save):
        with pytest.raises(carom.SceneError, match=r"path must be a file's name, not "):
            act(path)


@pytest.mark.parametrize("ending", [".toml", ".json", ".TOML", ".Json"])
def test_what_is_saved_loads_bit_for_bit(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"scene{ending}"
    SCENE.save(path)
    assert repr(carom.Scene.load(str(path))) == repr(SCENE)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_a_mark_of_utf_8_is_skipped(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(b"\xef\xbb\xbfversion = 1\r\n")
    assert carom.Scene.load(path) == carom.Scene()


def test_a_file_begins_with_its_version_and_says_no_more_than_it_must(tmp_path: Path) -> None:
    SCENE.save(tmp_path / "scene.toml")
    lines = (tmp_path / "scene.toml").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "version = 1"
    assert lines[lines.index("[[shapes]]") :][:5] == [
        "[[shapes]]",
        'kind = "segment"',
        'name = "ground"',
        "start = [0.0, 0.0]",
        "end = [1.0, -0.0]",
    ]
    SCENE.save(tmp_path / "scene.json")
    assert next(iter(json.loads((tmp_path / "scene.json").read_text(encoding="utf-8")))) == "version"


def test_saving_replaces_what_was_there(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    path.write_text("something else, and longer than a scene " * 100, encoding="utf-8")
    SCENE.save(path)
    assert carom.Scene.load(path) == SCENE


def test_saving_that_fails_leaves_the_file_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "scene.toml"
    carom.Scene(name="before").save(path)

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(carom.SceneError, match=r"scene\.toml: cannot be written: No space left on device"):
        SCENE.save(path)
    assert carom.Scene.load(path).name == "before"
    assert list(tmp_path.iterdir()) == [path]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    target, link = tmp_path / "target.toml", tmp_path / "link.toml"
    target.touch()
    link.symlink_to(target)
    SCENE.save(link)
    assert link.is_symlink()
    assert carom.Scene.load(target) == SCENE


def test_a_saved_file_has_the_rights_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "any").touch()
    SCENE.save(tmp_path / "scene.toml")
    rights = [stat.S_IMODE((tmp_path / name).stat().st_mode) for name in ("any", "scene.toml")]
    assert rights[0] == rights[1]


@pytest.mark.slow
@given(tables_of_scenes)
def test_a_scene_is_written_as_by_the_slow_writer(table: dict[str, Any]) -> None:
    plain = carom.Scene(**table).plain()
    slow = re.sub(r"\[\n((?: *[-+.\w]+,\n)+) *\]", files._on_one_line, tomli_w.dumps(plain))
    assert files._to_toml(plain) == slow
