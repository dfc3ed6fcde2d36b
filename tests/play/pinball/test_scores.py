"""High scores: their order, their file, and what happens when that is damaged or cannot be written."""

import json
from pathlib import Path

import platformdirs
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from carom.play.pinball import HighScores, Score
from carom.play.pinball.rules.entry import Entry
from carom.play.pinball.rules.scores import KEPT, LETTERS, default_path


@pytest.fixture
def told() -> list[str]:
    return []


def test_ten_are_kept_best_first_and_equal_scores_in_the_order_they_came() -> None:
    scores = HighScores([])
    for number in range(12):
        scores.add("AAA", 100 * number + 100)
    assert scores.add("BBB", 800) == 5
    assert [entry.score for entry in scores.scores] == [1200, 1100, 1000, 900, 800, 800, 700, 600, 500, 400]
    assert scores.scores[5].initials == "BBB"
    assert scores.add("CCC", 400) is None
    assert len(scores.scores) == KEPT


def test_no_score_is_no_place() -> None:
    assert HighScores([]).place(0) is None
    assert HighScores([]).place(1) == 0
    assert HighScores([]).best.score == 0


def test_scores_last(tmp_path: Path, told: list[str]) -> None:
    path = tmp_path / "new folder" / "pinball.json"
    scores = HighScores.load(path, told.append)
    assert scores.add("ZOE", 2_000_000) == 0
    again = HighScores.load(path, told.append)
    assert again.best == Score(initials="ZOE", score=2_000_000)
    assert again.scores == scores.scores
    assert told == []
    assert [file.name for file in path.parent.iterdir()] == ["pinball.json"]


GOOD = {"version": 1, "scores": [{"initials": "AAA", "score": 5}]}


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\xff\xfe nonsense",
        b"[1, 2",
        b'{"version": 2, "scores": []}',
        json.dumps(GOOD | {"more": 1}).encode(),
        json.dumps({"version": 1, "scores": [{"initials": "aaa", "score": 5}]}).encode(),
        json.dumps({"version": 1, "scores": [{"initials": "AAAA", "score": 5}]}).encode(),
        json.dumps({"version": 1, "scores": [{"initials": "AAA", "score": -5}]}).encode(),
        json.dumps({"version": 1, "scores": [{"initials": "AAA", "score": "5"}]}).encode(),
        json.dumps({"version": 1, "scores": [{"initials": "AAA", "score": 5}] * 11}).encode(),
        b"(" * 100_000,
    ],
)
def test_a_damaged_file_is_kept_aside_and_the_game_goes_on(tmp_path: Path, told: list[str], content: bytes) -> None:
    path = tmp_path / "pinball.json"
    path.write_bytes(content)
    scores = HighScores.load(path, told.append)
    assert scores.scores == HighScores().scores
    assert len(told) == 1
    assert "\n" not in told[0]
    assert "pinball.json.damaged" in told[0]
    assert (tmp_path / "pinball.json.damaged").read_bytes() == content
    scores.add("NEW", 10**7)
    assert HighScores.load(path, told.append).best.initials == "NEW"
    assert len(told) == 1


def test_no_damaged_file_is_written_over(tmp_path: Path, told: list[str]) -> None:
    path = tmp_path / "pinball.json"
    for number in (1, 2, 3):
        path.write_text(f"damaged {number}", encoding="utf-8")
        HighScores.load(path, told.append)
    kept = {file.name: file.read_text(encoding="utf-8") for file in tmp_path.iterdir()}
    assert kept == {
        "pinball.json.damaged": "damaged 1",
        "pinball.json.damaged2": "damaged 2",
        "pinball.json.damaged3": "damaged 3",
    }


def test_a_damaged_file_that_cannot_be_renamed_stays(
    tmp_path: Path, told: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "pinball.json"
    path.write_text("damaged", encoding="utf-8")

    def refuse(self: Path, target: object) -> Path:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "rename", refuse)
    scores = HighScores.load(path, told.append)
    scores.add("NEW", 10**7)
    assert path.read_text(encoding="utf-8") == "damaged"
    assert len(told) == 1
    assert "stay as they are" in told[0]
    monkeypatch.setattr(Path, "exists", lambda self: True)
    HighScores.load(path, told.append)
    assert path.read_text(encoding="utf-8") == "damaged"


def test_where_nothing_can_be_written_one_line_says_so_and_scores_last_in_memory(
    tmp_path: Path, told: list[str]
) -> None:
    blocker = tmp_path / "file"
    blocker.write_text("", encoding="utf-8")
    scores = HighScores([], blocker / "pinball.json", told.append)
    assert scores.add("ANN", 100) == 0
    assert scores.best.initials == "ANN"
    assert len(told) == 1
    assert "\n" not in told[0]
    assert "cannot be kept" in told[0]


def test_a_file_that_cannot_be_read_is_told_of(tmp_path: Path, told: list[str]) -> None:
    scores = HighScores.load(tmp_path, told.append)
    assert scores.scores == HighScores().scores
    assert len(told) == 1
    assert "cannot be read" in told[0]


def test_an_old_file_stays_whole_when_the_new_one_cannot_be_finished(
    tmp_path: Path, told: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "pinball.json"
    scores = HighScores([], path, told.append)
    scores.add("OLD", 100)
    before = path.read_bytes()

    def fail(self: Path, target: object) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", fail)
    scores.add("NEW", 200)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["pinball.json"]
    assert "No space left" in told[0]


def test_scores_are_kept_in_the_users_data_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(platformdirs, "user_data_path", lambda name: tmp_path / name)
    assert default_path() == tmp_path / "carom" / "pinball.json"
    HighScores.load().add("ANN", 10**7)
    assert HighScores.load().best.initials == "ANN"


def test_initials_are_three_letters_of_those_there_are() -> None:
    for wrong in ("", "AB", "abc", "A B", "ABCD"):
        with pytest.raises(ValidationError):
            Score(initials=wrong, score=1)


def test_letters_go_round_and_are_accepted_one_by_one() -> None:
    entry = Entry("AAA")
    entry.turn(-1)
    assert entry.initials == f"{LETTERS[-1]}AA"
    entry.turn(2)
    assert not entry.accept()
    entry.turn(1)
    assert not entry.accept()
    assert entry.initials == "BBA"
    assert entry.accept()
    assert entry.place == 2


@given(typed=st.lists(st.sampled_from([*"abcXYZ09.-", "", "ä", "ab", " "]), max_size=12))
def test_what_is_typed_is_what_stands_there_and_can_be_taken_back(typed: list[str]) -> None:
    entry, wanted, place = Entry("AAA"), list("AAA"), 0
    for letter in typed:
        entry.type(letter)
        if letter == "":
            place = max(place - 1, 0)
        elif len(letter) == 1 and letter.upper() in LETTERS:
            wanted[place], place = letter.upper(), min(place + 1, 2)
        assert (entry.initials, entry.place) == ("".join(wanted), place)


def test_the_last_initials_are_remembered(tmp_path: Path) -> None:
    path = tmp_path / "scores.json"
    scores = HighScores.load(path)
    assert scores.last == "AAA"
    scores.add("ZOE", 2_000_000)
    scores.add("TOM", 1)
    assert HighScores.load(path).last == "ZOE", "who is not among the best was not asked"
    path.write_text(json.dumps(GOOD))
    assert HighScores.load(path).last == "AAA"
    path.write_text(json.dumps(GOOD | {"last": "zoe"}))
    told: list[str] = []
    HighScores.load(path, told.append)
    assert len(told) == 1
