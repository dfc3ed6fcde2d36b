"""The toy played by scripted input: keys, throws, readings, two tables, and its screens compared with kept ones."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pygame
import pytest

from carom.compiler import door
from carom.compiler.kernels import Kernel
from carom.play.pen import Pen
from carom.play.toy import app, colours
from carom.play.toy.keys import BUTTONS, HELP, KEYS
from carom.play.toy.settings import SHOWN
from tests.play.screens import check
from tests.play.toy.playing import Player


def words_on(player: Player) -> tuple[str, dict[str, str]]:
    """What the strip below the table says now: a title and numbers."""
    reading = player.toy._pointed_at(Pen(player.window.surface, player.toy._letters))
    return ("", {}) if reading is None else (reading.title, dict(reading.pairs))


# -- keys -------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("place", range(len(SHOWN)))
def test_a_number_key_switches_a_layer(player: Player, place: int) -> None:
    name = list(SHOWN)[place]
    before = player.desk.is_on(name)
    player.key(pygame.K_1 + place)
    assert player.desk.is_on(name) != before


@pytest.mark.slow
def test_every_key_presses_something_that_there_is(player: Player) -> None:
    for key in KEYS:
        player.key(key)
    assert set(BUTTONS.values()) <= set(KEYS.values())


def test_the_help_names_the_keys() -> None:
    told = " ".join(key for _, lines in HELP for key, _ in lines)
    names = {pygame.K_SPACE: "Space", pygame.K_ESCAPE: "Esc", pygame.K_F1: "F1"}
    assert all(names.get(key, chr(key).upper() if key < 128 else "") in told for key in KEYS)


def test_escape_closes_the_help_and_then_the_toy(player: Player) -> None:
    player.key(pygame.K_F1)
    player.key(pygame.K_ESCAPE)
    assert player.toy.running
    assert not player.desk.help
    player.key(pygame.K_ESCAPE)
    assert not player.toy.running


def test_closing_the_window_ends_the_toy(player: Player) -> None:
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    player.frames()
    assert not player.toy.running


def test_real_time_goes_by_frame_by_frame(player: Player) -> None:
    player.key(pygame.K_p)
    before = player.world.time
    player.frames(3)
    assert player.world.time == pytest.approx(before + 3 / 60)


# -- the mouse --------------------------------------------------------------------------------------------------------


def test_a_ball_is_dragged_and_thrown_with_the_velocity_of_the_mouse(player: Player) -> None:
    ball = next(ball for ball in player.world.balls if ball.name == "left")
    view = player.toy.views[0]
    x, y = ball.position
    player.mouse(pygame.MOUSEBUTTONDOWN, view.pixel((x, y)))
    assert player.desk.hand.ball == ball.id
    for step in range(1, 10):
        player.mouse(pygame.MOUSEMOTION, view.pixel((x + 0.2 * step, y)))
    spot = view.pixel((x + 1.8, y))
    pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONUP, pos=(round(spot[0]), round(spot[1])), button=1))
    player.frames()
    assert player.desk.hand.ball is None
    assert ball.velocity == pytest.approx((12.0, 0.0), abs=0.6)


def test_a_held_ball_goes_where_the_mouse_is(player: Player) -> None:
    ball = next(ball for ball in player.world.balls if ball.name == "left")
    view = player.toy.views[0]
    x, y = ball.position
    player.mouse(pygame.MOUSEBUTTONDOWN, view.pixel((x, y)))
    player.mouse(pygame.MOUSEMOTION, view.pixel((x + 0.4, y + 0.4)))
    for _ in range(12):
        player.key(pygame.K_s)
    assert ball.position == pytest.approx((x + 0.4, y + 0.4), abs=0.1)


@pytest.mark.slow
def test_every_key_does_what_it_does_on_empty_tables_too(player: Player) -> None:
    player.key(pygame.K_c)
    for detection in ("continuous", "both"):
        player.key(pygame.K_d)
        assert player.desk.settings.detection == detection
        assert all(len(table.world.balls) == 0 for table in player.desk.tables)
    for key, name in KEYS.items():
        if name not in {"quit", "help", "detection"}:
            player.key(key)
            player.key(pygame.K_c)
            assert player.toy.running


def test_a_click_beside_all_balls_holds_nothing(player: Player) -> None:
    player.mouse(pygame.MOUSEBUTTONDOWN, player.toy.views[0].pixel((10.0, 16.0)))
    assert player.desk.hand.ball is None


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "place", "wanted"),
    [
        ("bumper, circle", (16.5, 11.8), {"radius": "1.80", "elasticity": "1.3", "center": "(16.50, 11.80)"}),
        ("pocket, arc", (1.5, 19.0), {"from": "0.0°", "to": "270.0°", "elasticity": "1.15"}),
        ("shelf, segment", (20.0, 17.0), {"from": "(18.50, 17.00)", "to": "(24.00, 17.00)", "length": "5.50"}),
        ("paddle, segment", (22.5, 9.6), {"pivot": "(24.00, 10.50)", "turns": "0 rad/s"}),
        ("launch gate, gate", (31.3, 19.4), {"lets pass": "(-0.65, 0.76)"}),
        ("post, point", (7.8, 8.2), {"position": "(7.80, 8.20)"}),
        ("upper", (16.0, 21.5), {"radius": "0.50", "mass": "1.00", "asleep": "no"}),
    ],
)
def test_pointing_at_a_shape_reads_its_numbers(
    player: Player, name: str, place: tuple[float, float], wanted: dict[str, str]
) -> None:
    player.point(place)
    title, pairs = words_on(player)
    assert title.startswith(name)
    assert wanted.items() <= pairs.items()


def test_time_stands_still_while_steps_would_hold_up_the_window(
    player: Player, monkeypatch: pytest.MonkeyPatch
) -> None:
    player.key(pygame.K_p)
    monkeypatch.setattr(app.carom, "compiling", lambda: True)
    step = player.desk.advance

    def slow(frames: int) -> Any:
        monkeypatch.setattr(app, "perf_counter", lambda: 1.0)
        return step(frames)

    monkeypatch.setattr(player.desk, "advance", slow)
    monkeypatch.setattr(app, "perf_counter", lambda: 0.0)
    player.frames(1)
    began = player.world.time
    player.frames(3)
    assert player.world.time == began
    player.key(pygame.K_F1)
    assert player.desk.help, "the window answers meanwhile"
    monkeypatch.setattr(app.carom, "compiling", lambda: False)
    player.frames(1)
    assert player.world.time > began


def test_tables_of_the_continuous_mode_wait_for_a_compiler(player: Player, monkeypatch: pytest.MonkeyPatch) -> None:
    compiling = True
    monkeypatch.setattr(app.carom, "compiling", lambda: compiling)
    player.key(pygame.K_p)
    player.key(pygame.K_d)
    assert player.world.detection == "continuous"
    began = player.world.time
    player.frames(3)
    assert player.world.time == began
    compiling = False
    player.frames(3)
    assert player.world.time > began


def test_pointing_at_nothing_or_at_the_panel_reads_nothing(player: Player) -> None:
    player.point((10.0, 16.0))
    assert words_on(player) == ("", {})
    player.mouse(pygame.MOUSEMOTION, (1270, 500))
    assert words_on(player) == ("", {})


def test_a_shape_that_is_pointed_at_looks_otherwise(player: Player) -> None:
    view = player.toy.views[0]
    for place in ((1.5, 19.0), (20.0, 17.0), (7.8, 8.2)):
        x, y = (round(number) for number in view.pixel(place))
        spot = pygame.Rect(x - 6, y - 6, 12, 12)
        player.point((10.0, 16.0))
        before = pygame.image.tobytes(player.window.surface.subsurface(spot), "RGB")
        player.point(place)
        assert pygame.image.tobytes(player.window.surface.subsurface(spot), "RGB") != before


def test_a_ball_that_sleeps_is_drawn_otherwise(player: Player) -> None:
    ball = next(ball for ball in player.world.balls if ball.name == "left")
    view = player.toy.views[0]
    spot = [round(number) for number in view.pixel(ball.position)]
    awake = player.window.surface.get_at(spot)[:3]
    for other in list(player.world.balls):
        other.velocity = (0.0, 0.0)
    player.desk.change("gravity", 0.0)
    player.desk.change("sleep", 3.0)
    player.world.sleep_time = 0.0
    player.key(pygame.K_s)
    player.frames(1)
    assert ball.asleep
    assert awake != colours.STAGE
    assert player.window.surface.get_at(spot)[:3] == colours.STAGE


# -- the whole of it --------------------------------------------------------------------------------------------------


def test_a_toy_runs_for_some_seconds_and_says_how_long_its_frames_took(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[str] = []
    monkeypatch.setattr(app, "warm_up", lambda: None)
    meter = app.run(tell=told.append, seconds=0.05)
    assert meter.frames >= 1
    assert "ms of work" in meter.line()


def test_without_a_sound_card_the_toy_says_so_once_and_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*arguments: Any, **named: Any) -> None:
        raise pygame.error("no audio device")

    monkeypatch.setattr(pygame.mixer, "init", refuse)
    player = Player()
    player.frames(3)
    assert player.told == ["no sound: no audio device"]
    assert player.world.time == pytest.approx(3 / 60)


@pytest.mark.slow
@pytest.mark.compiled
def test_all_that_is_compiled_is_compiled_before_the_table_is_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: set[Kernel] = set()

    def noting(way: Callable[..., Kernel]) -> Callable[..., Kernel]:
        def noted(kernel: Kernel, *size: Any) -> Kernel:
            asked.add(kernel)
            return way(kernel, *size)

        return noted

    monkeypatch.setattr(door, "load", noting(door.load))
    monkeypatch.setattr(door, "enter", noting(door.enter))
    app.warm_up()
    before = set(asked)
    assert len(before) >= 3
    player = Player()
    player.click("launch many")
    player.mouse(pygame.MOUSEMOTION, (450, 350))
    for name in (("broad_phase", "quadtree"), ("broad_phase", "brute"), ("detection", "both"), "rotating", "clear"):
        player.click(name)
        player.mouse(pygame.MOUSEMOTION, (450, 350))
        player.frames(4)
    for layer in SHOWN:
        player.click(layer)
    player.frames(4)
    assert asked == before


def keep(player: Player, name: str, renew: bool, folder: Path) -> None:
    """Compare the screen with the kept one."""
    player.frames(1)
    check(f"toy-{name}", player.window.surface, renew=renew, folder=folder)


def test_screen_of_the_start(player: Player, renew: bool, tmp_path: Path) -> None:
    player.key(pygame.K_p)
    player.frames(16)
    keep(player, "start", renew, tmp_path)


@pytest.mark.slow
def test_screen_of_all_layers(player: Player, renew: bool, tmp_path: Path) -> None:
    player.key(pygame.K_p)
    for name in SHOWN:
        player.desk.change(name, True)
    player.click("rotating")
    player.click(("broad_phase", "quadtree"))
    player.point((16.5, 13.0))
    player.frames(30)
    keep(player, "layers", renew, tmp_path)


def test_screen_of_the_help(player: Player, renew: bool, tmp_path: Path) -> None:
    player.key(pygame.K_F1)
    keep(player, "help", renew, tmp_path)


@pytest.mark.slow
@pytest.mark.compiled
def test_screen_of_two_tables(player: Player, renew: bool, tmp_path: Path) -> None:
    player.key(pygame.K_p)
    player.click(("detection", "both"))
    player.slide("motion", -400)
    player.slide("speed", 400)
    player.slide("count", 30)
    player.click("launch many")
    player.frames(240)
    keep(player, "side-by-side", renew, tmp_path)


@pytest.mark.slow
@pytest.mark.compiled
def test_screen_of_a_hundred_balls(player: Player, renew: bool, tmp_path: Path) -> None:
    player.desk.change("speed", 40)
    player.desk.change("count", 95)
    player.desk.do("launch many")
    player.key(pygame.K_p)
    while player.desk.lane.waiting:
        player.desk.advance(1)
    player.frames(90)
    assert player.desk.tables[0].in_play == 100
    keep(player, "hundred", renew, tmp_path)


def test_screen_of_a_throw(player: Player, renew: bool, tmp_path: Path) -> None:
    ball: Any = next(ball for ball in player.world.balls if ball.name == "left")
    view = player.toy.views[0]
    x, y = ball.position
    player.mouse(pygame.MOUSEBUTTONDOWN, view.pixel((x, y)))
    for step in range(1, 7):
        player.mouse(pygame.MOUSEMOTION, view.pixel((x + 0.3 * step, y + 0.4 * step)))
    keep(player, "throw", renew, tmp_path)
