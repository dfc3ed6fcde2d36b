"""A watched file: what is made of it is made anew when it is saved, until it is to end."""

from pathlib import Path

import pytest

from carom.cli.mistakes import Mistake
from carom.cli.watching import stamp_of, watch


def test_it_ends_when_what_is_made_was_stopped(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text("a")
    made = []
    watch(str(path), lambda: bool(made.append(1)))
    assert made == [1]


def test_a_file_that_is_away_for_a_moment_is_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.svg"
    path.write_text("a")
    made: list[str] = []
    steps = iter([path.unlink, lambda: None, lambda: path.write_text("longer")])
    monkeypatch.setattr("carom.cli.watching.sleep", lambda _: next(steps)())

    def make() -> bool:
        made.append(path.read_text())
        return len(made) < 2

    watch(str(path), make)
    assert made == ["a", "longer"]
    assert next(steps, None) is None


def test_only_files_are_watched() -> None:
    with pytest.raises(Mistake, match="--watch pinball: must be a file that can be saved"):
        watch("pinball", lambda: True)


def test_a_stamp_changes_with_the_file(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    assert stamp_of(path) is None
    path.write_text("a")
    first = stamp_of(path)
    assert first == stamp_of(path)
    path.write_text("ab")
    assert stamp_of(path) != first
