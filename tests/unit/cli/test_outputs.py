"""Output files: refused before the run where they cannot be written; whole, or as they were before."""

import errno
import os
from pathlib import Path

import pytest

from carom.cli.mistakes import Mistake
from carom.cli.outputs import check_outputs, write

ENDINGS = (".svg", ".csv", ".toml")


def refusal(path: Path, scene: Path | None = None) -> str:
    """What is said of a path that is refused."""
    with pytest.raises(Mistake) as caught:
        check_outputs([path], ENDINGS, scene)
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("name", ["run.png", "run", "svg", "run.svg.gz", ".csv"])
def test_an_unknown_ending_is_refused(tmp_path: Path, name: str) -> None:
    assert "its ending must be one of .svg, .csv, .toml" in refusal(tmp_path / name)


def test_endings_may_be_upper_case(tmp_path: Path) -> None:
    check_outputs([tmp_path / "RUN.SVG"], ENDINGS, None)


def test_a_missing_folder_is_refused(tmp_path: Path) -> None:
    assert "there is no folder" in refusal(tmp_path / "missing" / "run.svg")


def test_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "run.svg").mkdir()
    assert "is a folder" in refusal(tmp_path / "run.svg")


def test_a_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert "there is no folder" in refusal(tmp_path / "file" / "run.svg")


def test_a_place_where_no_file_can_be_made_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def touch(path: Path) -> None:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS))

    monkeypatch.setattr(Path, "touch", touch)
    assert os.strerror(errno.EROFS) in refusal(tmp_path / "run.svg")


def test_a_read_only_file_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "run.svg").write_text("old")
    monkeypatch.setattr(os, "access", lambda path, mode: False)  # the tests may run as root, who may write everything
    assert "read-only" in refusal(tmp_path / "run.svg")


def test_the_scene_itself_is_refused_by_any_of_its_names(tmp_path: Path) -> None:
    scene = tmp_path / "table.toml"
    scene.write_text("version = 1\n")
    link = tmp_path / "link.toml"
    link.symlink_to(scene)
    assert "the scene itself" in refusal(scene, scene)
    assert "the scene itself" in refusal(link, scene)


def test_one_file_asked_for_twice_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    with pytest.raises(Mistake, match="twice"):
        check_outputs([tmp_path / "run.svg", tmp_path / "a" / ".." / "run.svg"], ENDINGS, None)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_device_is_refused_and_stays_one(tmp_path: Path) -> None:
    link = tmp_path / "run.svg"
    link.symlink_to("/dev/full")
    assert "a device or the like" in refusal(link)
    assert Path("/dev/full").is_char_device()


def test_checking_leaves_nothing_behind(tmp_path: Path) -> None:
    check_outputs([tmp_path / "run.svg", tmp_path / "run.csv"], ENDINGS, None)
    assert list(tmp_path.iterdir()) == []


def test_a_file_is_replaced_in_one_go_and_keeps_its_mode(tmp_path: Path) -> None:
    path = tmp_path / "run.csv"
    path.write_text("old")
    path.chmod(0o640)
    seen = []

    def writer(beside: Path) -> None:
        beside.write_text("new text")
        seen.append(path.read_text())

    assert write(path, writer) == len("new text")
    assert seen == ["old"]
    assert path.read_text() == "new text"
    assert path.stat().st_mode & 0o777 == 0o640
    assert list(tmp_path.iterdir()) == [path]


def test_a_link_goes_on_being_one(tmp_path: Path) -> None:
    real = tmp_path / "real.csv"
    real.write_text("old")
    link = tmp_path / "link.csv"
    link.symlink_to(real)
    write(link, lambda beside: beside.write_text("new") and None)
    assert link.is_symlink()
    assert real.read_text() == "new"


@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt()])
def test_a_writer_that_fails_leaves_what_was_there(tmp_path: Path, error: BaseException) -> None:
    path = tmp_path / "run.csv"
    path.write_text("old")

    def writer(beside: Path) -> None:
        beside.write_text("half of")
        raise error

    with pytest.raises(type(error)):
        write(path, writer)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
