"""The Pinball Game as an application: keys, controllers, pause, help, drawing modes, sound, and its screens."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pygame
import pytest

import carom
from carom.play.controls import Button
from carom.play.pinball import Control, HighScores, Phase, Pinball, PinballApp, Score, art, art_back, run, sounds
from carom.play.pinball.app import BEHIND, BUTTONS, KEYS
from carom.play.pinball.lines import Mode
from carom.play.window import Window
from tests.play import screens

#: Frames of one step each.
STEP = Pinball.STEP
#: The width and the height of the screens that are kept: less than the window's, for they show much.
SCREEN = (560, 588)

#: Frames in which the flippers are used in a whole game, so that it ends soon.
FLIPPING = 1_500
Art = art.Art
art_once = cache(lambda: Art(carom.scenes.pinball().build()))
backs_once, sounds_once = cache(art_back.paint_backs), cache(sounds.make)


@pytest.fixture(autouse=True)
def once(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Art and sounds made once for all sessions, but for the one that `run` opens."""
    for owner, name, made in (
        (art, "Art", lambda world: art_once()),
        (art_back, "paint_backs", backs_once),
        (sounds, "make", sounds_once),
    ):
        if "run" not in request.node.name:
            monkeypatch.setattr(owner, name, made)


def session(seed: int = 1, scores: HighScores | None = None) -> tuple[PinballApp, Window]:
    """A game that has just been opened, with the standing high scores or others, in a window."""
    app = PinballApp(lambda line: pytest.fail(line), Pinball(scores or HighScores(), seed))
    window = Window(app)
    pygame.event.clear()
    return app, window


def key(number: int, down: bool = True) -> None:
    """Nothing; has a key go down or up before the next frame."""
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN if down else pygame.KEYUP, key=number))


def tapped(window: Window, number: int, frames: int = 1) -> None:
    """Nothing; a key goes down, some frames of one step pass, it goes up."""
    key(number)
    for _ in range(frames):
        window.frame(STEP)
    key(number, down=False)
    window.frame(STEP)


def bytes_of(window: Window, area: pygame.Rect | None = None) -> bytes:
    """The picture in a window, or in an area of it."""
    shown = window.surface if area is None else window.surface.subsurface(area)
    return pygame.image.tobytes(shown, "RGB")


def keep(name: str, window: Window, renew: bool, folder: Path) -> None:
    """Nothing; compares what is in a window with the screen that is kept."""
    screens.check(name, pygame.transform.smoothscale(window.surface, SCREEN), renew=renew, folder=folder)


# -- keys --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("number", [pygame.K_SPACE, pygame.K_RETURN, pygame.K_1], ids=["space", "return", "1"])
def test_the_demonstration_goes_on_until_a_game_is_started(number: int) -> None:
    app, window = session()
    window.frame(STEP)
    assert app.game.phase is Phase.ATTRACT
    tapped(window, number)
    assert app.game.phase is Phase.PLAY
    assert app.game.ball_number == 1


@pytest.mark.parametrize(
    ("number", "side"),
    [(pygame.K_LSHIFT, 0), (pygame.K_z, 0), (pygame.K_RSHIFT, 1), (pygame.K_SLASH, 1)],
    ids=["left shift", "z", "right shift", "slash"],
)
def test_a_flipper_rises_in_the_very_step_after_its_key(number: int, side: int) -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    key(number)
    window.frame(STEP)
    assert app.game.flipper_angles[side] > 0.0
    assert app.game.flipper_angles[1 - side] == 0.0
    key(number, down=False)
    for _ in range(3):
        window.frame(STEP)
    assert app.game.flipper_angles[side] == 0.0


def test_the_plunger_is_drawn_while_its_key_is_held_and_shoots_the_ball() -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    key(pygame.K_SPACE)
    pulls = []
    for _ in range(12):
        window.frame(STEP)
        pulls.append(app.game.plunger_pull)
    assert pulls == sorted(pulls)
    assert pulls[-1] > pulls[0] > 0.0
    key(pygame.K_SPACE, down=False)
    window.frame(STEP)
    assert app.game.plunger_pull == 0.0


def test_nudges_move_the_picture_and_calm_down() -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    back = bytes_of(window, pygame.Rect(470, 60, 60, 60))
    for number, axis, sign, bared in (
        (pygame.K_a, 0, -1, (414, 400)),
        (pygame.K_d, 0, 1, (1, 400)),
        (pygame.K_w, 1, -1, (200, 838)),
    ):
        tapped(window, number)
        assert app.view.effects.shift[axis] * sign > 0
        assert window.surface.get_at(bared)[:3] == BEHIND
        assert bytes_of(window, pygame.Rect(470, 60, 60, 60)) == back, "the back is not nudged"
        for _ in range(3):
            app.view.effects.advance(0.1)
        assert app.view.effects.shift == (0, 0)


def test_every_control_has_a_key_and_a_button() -> None:
    assert set(Control) <= set(KEYS.values())
    assert set(Control) <= set(BUTTONS.values())


def test_a_controller_plays() -> None:
    app, window = session()

    def button(number: Button, down: bool = True) -> None:
        kind = pygame.JOYBUTTONDOWN if down else pygame.JOYBUTTONUP
        pygame.event.post(pygame.event.Event(kind, instance_id=7, button=number.value))
        window.frame(STEP)

    button(Button.START)
    assert app.game.phase is Phase.PLAY
    button(Button.LEFT_SHOULDER)
    assert app.game.flipper_angles[0] > 0.0
    button(Button.LEFT_SHOULDER, down=False)
    button(Button.SOUTH)
    button(Button.SOUTH)
    assert app.game.plunger_pull > 0.0
    pygame.event.post(pygame.event.Event(pygame.JOYHATMOTION, instance_id=7, hat=0, value=(-1, 0)))
    window.frame(STEP)
    assert app.view.effects.shift[0] < 0


def test_escape_leaves() -> None:
    app, window = session()
    tapped(window, pygame.K_ESCAPE)
    assert not app.running


@pytest.mark.parametrize("number", [pygame.K_p, pygame.K_F1], ids=["pause", "help"])
def test_time_stands_still_in_a_pause_and_while_help_is_read(number: int) -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    tapped(window, number)
    time = app.game.world.time
    key(pygame.K_LSHIFT)
    window.frame(0.1)
    assert app.game.world.time == time
    assert app.game.flipper_angles == (0.0, 0.0)
    tapped(window, number)
    assert app.game.world.time > time
    assert app.game.flipper_angles == (0.0, 0.0), "what was pressed in a pause is not caught up on"


def test_a_key_that_is_let_go_in_a_pause_is_let_go() -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    key(pygame.K_LSHIFT)
    window.frame(STEP)
    tapped(window, pygame.K_p)
    key(pygame.K_LSHIFT, down=False)
    window.frame(STEP)
    tapped(window, pygame.K_p)
    for _ in range(3):
        window.frame(STEP)
    assert app.game.flipper_angles == (0.0, 0.0)


def test_a_game_pauses_when_its_window_loses_the_focus_a_demonstration_does_not() -> None:
    app, window = session()
    for kinds, paused in (
        ((pygame.WINDOWFOCUSLOST,), False),
        ((pygame.WINDOWFOCUSLOST, pygame.WINDOWFOCUSGAINED), False),
        ((pygame.WINDOWFOCUSLOST,), True),
    ):
        for kind in kinds:
            pygame.event.post(pygame.event.Event(kind))
        window.frame(STEP)
        assert app.paused is paused
        pygame.event.post(pygame.event.Event(pygame.WINDOWFOCUSGAINED))
        tapped(window, pygame.K_RETURN)


def test_f3_changes_how_the_table_is_drawn() -> None:
    app, window = session()
    app.paused = True
    pictures = {}
    for mode in (Mode.BOTH, Mode.LINES, Mode.ART):
        tapped(window, pygame.K_F3)
        assert app.mode is mode
        pictures[mode] = bytes_of(window)
    assert len(set(pictures.values())) == 3
    window.frame(0.0)
    assert bytes_of(window) == pictures[Mode.ART]


def test_f2_shows_the_frame_rate() -> None:
    app, window = session()
    app.paused = True
    window.frame(0.0)
    before = bytes_of(window)
    tapped(window, pygame.K_F2)
    assert bytes_of(window) != before
    assert app.meter.frames >= 2
    tapped(window, pygame.K_F2)
    assert bytes_of(window) == before


# -- sound -------------------------------------------------------------------------------------------------------------


def test_m_mutes_and_sounds_again() -> None:
    app, window = session()
    assert not app.speaker.silent
    for silent in (True, False):
        tapped(window, pygame.K_m)
        assert app.speaker.silent is silent


def test_without_a_sound_card_it_is_said_once_and_the_game_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "none of them")
    told: list[str] = []
    app = PinballApp(told.append, Pinball(HighScores(), 1))
    window = Window(app)
    tapped(window, pygame.K_RETURN)
    assert len(told) == 1
    assert told[0].startswith("no sound")
    assert app.game.phase is Phase.PLAY


def test_events_are_heard(monkeypatch: pytest.MonkeyPatch) -> None:
    app, window = session()
    heard: list[str] = []
    monkeypatch.setattr(app.speaker, "play", lambda name, volume: heard.append(name))
    tapped(window, pygame.K_RETURN)
    tapped(window, pygame.K_LSHIFT)
    assert {"start", "serve", "flipper"} <= set(heard)


# -- screens -----------------------------------------------------------------------------------------------------------


def start(window: Window) -> None:
    """Nothing; starts a game and shows it for a step."""
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
    """Nothing; starts a game and plays it to its end with keys, 60 frames a second, flipping in turn.

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


@pytest.mark.compiled
def test_the_demonstration_plays_well_by_itself_and_is_drawn_in_every_mode() -> None:
    app, window = session(seed=3)
    for number in range(60 * 20):
        if number % 400 == 399:
            key(pygame.K_F3)
        window.frame(1.0 / 60.0)
    assert app.game.phase is Phase.ATTRACT
    assert app.game.score > 5_000


def test_run_plays_for_some_seconds_with_the_users_high_scores(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("carom.play.pinball.scores.default_path", lambda: tmp_path / "pinball.json")
    told: list[str] = []
    meter = run(tell=told.append, seconds=0.02)
    assert meter.frames >= 1
    assert told == []
    assert not pygame.get_init()
