"""The Pinball Game as an application: keys, controllers, pause, help, drawing modes, sound."""

from pathlib import Path

import pygame
import pytest

from carom.play.controls import Button
from carom.play.pinball import Control, HighScores, Phase, Pinball, PinballApp, Score, run
from carom.play.pinball.screen import display, help
from carom.play.pinball.screen.app import BUTTONS, KEYS
from carom.play.pinball.screen.lines import Mode
from carom.play.pinball.screen.sheet import BEHIND
from carom.play.window import Window
from tests.play.pinball.playing import STEP, bytes_of, key, make_once, session, tapped


@pytest.fixture(autouse=True)
def once(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Art and sounds made once for all sessions, but for the one that `run` opens."""
    if "run" not in request.node.name:
        make_once(monkeypatch)


# -- keys --------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("number", [pygame.K_SPACE, pygame.K_RETURN, pygame.K_1], ids=["space", "return", "1"])
def test_the_demonstration_goes_on_until_a_game_is_started(number: int) -> None:
    app, window = session()
    window.frame(STEP)
    assert app.game.phase is Phase.ATTRACT
    tapped(window, number)
    assert app.game.phase is Phase.PLAY
    assert app.game.ball_number == 1


@pytest.mark.slow
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
        assert app.effects.shift[axis] * sign > 0
        assert window.surface.get_at(bared)[:3] == BEHIND
        assert bytes_of(window, pygame.Rect(470, 60, 60, 60)) == back, "the back is not nudged"
        for _ in range(3):
            app.effects.advance(0.1)
        assert app.effects.shift == (0, 0)


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
    assert app.effects.shift[0] < 0


def test_escape_leaves() -> None:
    app, window = session()
    tapped(window, pygame.K_ESCAPE)
    assert not app.running


def test_escape_closes_the_help_pauses_a_game_and_leaves_it_at_the_second_press() -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    tapped(window, pygame.K_F1)
    tapped(window, pygame.K_ESCAPE)
    assert (app.helping, app.paused, app.running) == (False, False, True)
    tapped(window, pygame.K_ESCAPE)
    assert (app.paused, app.running) == (True, True)
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


@pytest.mark.slow
def test_run_plays_for_some_seconds_with_the_users_high_scores(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("carom.play.pinball.rules.scores.default_path", lambda: tmp_path / "pinball.json")
    told: list[str] = []
    meter = run(tell=told.append, seconds=0.02)
    assert meter.frames >= 1
    assert told == []
    assert not pygame.get_init()


def test_keys_that_do_not_trip_sticky_keys_are_named_first() -> None:
    flippers = [keys.split(", ")[0] for keys, meaning in help.KEYS if "flipper;" in meaning]
    assert flippers == ["Left", "Right"]
    assert display.KEYS.startswith("Left, Right: flippers")


@pytest.mark.compiled
def test_initials_are_typed_and_taken_back_and_letters_do_nothing_else_meanwhile() -> None:
    app, window = session(scores=HighScores([Score(initials="EVA", score=5)]))
    app.game.high_scores.last = "KIM"
    app.game.press(Control.START, True)
    app.game.tick()
    app.game._rules.score = 1_000
    app.game._end_game()
    assert (app.game.phase, app.game.initials) == (Phase.ENTRY, "KIM")

    def typed(number: int, letter: str = "") -> None:
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=number, unicode=letter, mod=0))
        window.frame(1.0 / 60.0)

    typed(pygame.K_z, "z")
    assert app.game.initials == "KIM", "what is pressed at once was meant for the ball"
    for _ in range(61):
        window.frame(1.0 / 60.0)
    for letter in "zm":
        typed(ord(letter), letter)
    assert (app.game.initials, app.game.initial_place, app.speaker.muted) == ("ZMM", 2, False)
    typed(pygame.K_BACKSPACE)
    typed(pygame.K_BACKSPACE)
    assert app.game.initial_place == 0
    for letter in "P1":
        typed(ord(letter.lower()), letter)
    assert (app.game.initials, app.paused) == ("P1M", False)
    typed(pygame.K_RETURN)
    assert app.game.phase is Phase.OVER
    assert app.game.high_scores.best.initials == app.game.high_scores.last == "P1M"
