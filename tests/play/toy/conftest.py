"""A toy that is played with."""

from pathlib import Path

import pytest

from tests.play.toy.playing import Player


@pytest.fixture
def player(blind: None, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Player:
    """A toy in a window without a screen, two frames after it was opened, and stopped so that tests are quick.

    It keeps tables and screenshots in a folder of the test's own.
    """
    monkeypatch.chdir(tmp_path)
    made = Player()
    made.frames(1)
    made.key(PAUSE)
    return made


PAUSE = ord("p")
