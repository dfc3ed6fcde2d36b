"""A toy that is played with."""

import pytest

from tests.play.toy.playing import Player


@pytest.fixture
def player(blind: None) -> Player:
    """A toy in a window without a screen, two frames after it was opened, and stopped so that tests are quick."""
    made = Player()
    made.frames(1)
    made.key(PAUSE)
    return made


PAUSE = ord("p")
