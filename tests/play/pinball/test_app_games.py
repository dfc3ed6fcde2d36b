"""The screens of the Pinball Game, and whole games played with keys."""

from collections.abc import Callable
from pathlib import Path

import pygame
import pytest

from carom.play.pinball import HighScores, Phase, PinballApp, Score
from carom.play.window import Window
from tests.play.pinball.playing import STEP, keep, key, make_once, session, tapped

#: Frames in which the flippers are used in a whole game, so that it ends soon.
FLIPPING = 1_500


@pytest.fixture(autouse=True)
def once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Art and sounds made once for all sessions."""
    make_once(monkeypatch)


# -- screens -----------------------------------------------------------------------------------------------------------


def start(window: Window) -> None:
    """Start a game and show it for a step."""
    tapped(window, pygame.K_RETURN)


SHOWN: dict[str, Callable[[PinballApp, Window], None]] = {
    "pinball-start": lambda app, window: start(window),
    "pinball-help": lambda app, window: tapped(window, pygame.K_F1),
    "pinball-both": lambda app, window: (start(window), tapped(window, pygame.K_F3))[0],
    "pinball-lines": lambda app, window: (start(window), tapped(window, pygame.K_F3), tapped(window, pygame.K_F3))[0],
    "pinball-pause": lambda app, window: (start(window), tapped(window, pygame.K_p))[0],
}


@pytest.mark.parametrize("name", SHOWN)
def test_screens_look_as_they_did_when_someone_looked_at_them(name: str, renew: bool, tmp_path: Path) -> None:
    app, window = session()
    window.frame(STEP)
    SHOWN[name](app, window)
    keep(name, window, renew, tmp_path)


# -- whole games -------------------------------------------------------------------------------------------------------


def play_a_game(window: Window, app: PinballApp, most: int, at: Callable[[int], None]) -> None:
    """Start a game and play it to its end with keys, 60 frames a second, flipping in turn.

    The plunger is drawn for a second whenever a ball lies on it; `at` is called after each frame.
    """
    tapped(window, pygame.K_SPACE)
    for frame in range(most):
        if frame % 90 == 0:
            key(pygame.K_SPACE)
        if frame % 90 == 66:
            key(pygame.K_SPACE, down=False)
        for number, moment in ((pygame.K_LSHIFT, 0), (pygame.K_RSHIFT, 13)):
            if frame < FLIPPING and frame % 26 == moment:
                key(number)
            if frame % 26 == moment + 8:
                key(number, down=False)
        window.frame(1.0 / 60.0)
        at(frame)
        if app.game.phase not in (Phase.PLAY, Phase.BONUS):
            break
    for number in (pygame.K_SPACE, pygame.K_LSHIFT, pygame.K_RSHIFT):
        key(number, down=False)
    window.frame(1.0 / 60.0)


@pytest.mark.slow
@pytest.mark.compiled
def test_a_whole_game_is_played_with_keys_to_its_end_and_another_begins(renew: bool, tmp_path: Path) -> None:
    easy = HighScores([Score(initials="EVA", score=5_000), Score(initials="TOM", score=1_000_000)])
    app, window = session(seed=8, scores=easy)
    balls: list[int] = []
    scores: list[int] = []

    def note(frame: int) -> None:
        balls.append(app.game.ball_number)
        scores.append(app.game.score)
        if frame == 600:
            keep("pinball-play", window, renew, tmp_path)

    window.frame(STEP)
    play_a_game(window, app, 60 * 60 * 10, note)
    assert sorted(set(balls)) == [1, 2, 3]
    assert scores == sorted(scores)
    assert scores[-1] > 1_000
    assert app.game.ledger.balances
    final = app.game.score
    assert app.game.phase is Phase.ENTRY
    for _ in range(61):
        window.frame(1.0 / 60.0)
    for number in (pygame.K_RSHIFT, pygame.K_SPACE, pygame.K_SPACE, pygame.K_SPACE):
        tapped(window, number)
    assert app.game.phase is Phase.OVER
    assert [(entry.initials, entry.score) for entry in easy.scores] == [
        ("TOM", 1_000_000),
        ("BAA", final),
        ("EVA", 5_000),
    ]
    for _ in range(90):
        window.frame(1.0 / 60.0)
    keep("pinball-over", window, renew, tmp_path)
    tapped(window, pygame.K_SPACE)
    assert app.game.phase is Phase.PLAY
    assert app.game.score == 0
    assert app.game.ball_number == 1


@pytest.mark.slow
@pytest.mark.compiled
def test_the_game_is_the_same_at_any_frame_rate() -> None:
    digests = []
    for frames in (1, 4, 12):
        app, window = session(seed=2)
        tapped(window, pygame.K_RETURN)
        key(pygame.K_SPACE)
        for _ in range(480 // frames):
            window.frame(frames * STEP)
        key(pygame.K_SPACE, down=False)
        for _ in range(960 // frames):
            window.frame(frames * STEP)
        digests.append((app.game.world.digest(), app.game.score))
    assert digests[0] == digests[1] == digests[2]


@pytest.mark.slow
@pytest.mark.compiled
def test_the_demonstration_plays_well_by_itself_and_is_drawn_in_every_mode() -> None:
    app, window = session(seed=3)
    for number in range(60 * 20):
        if number % 400 == 399:
            key(pygame.K_F3)
        window.frame(1.0 / 60.0)
    assert app.game.phase is Phase.ATTRACT
    assert app.game.score > 5_000
