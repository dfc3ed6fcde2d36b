"""What all games stand on: the window and its loop, the clock, controllers, sounds, letters."""

import os

import numpy as np
import pygame
import pytest

import carom
from carom.play.controls import Button, Controls
from carom.play.letters import Letters
from carom.play.meter import FrameMeter
from carom.play.screen import NoDisplay, window_size
from carom.play.sound import RATE, Speaker, faded, joined, mixed, noise, samples, tone
from carom.play.window import Patience, Ticker, Window, play


class Counting:
    """A game that counts what it is told."""

    title = "Counting"
    size = (200, 120)

    def __init__(self, frames: int = 3) -> None:
        self.running = True
        self.meter = FrameMeter(60)
        self.keys: list[int] = []
        self.seconds: list[float] = []
        self._frames = frames

    def handle(self, event: pygame.event.Event) -> None:
        if event.type == pygame.KEYDOWN:
            self.keys.append(event.key)

    def advance(self, seconds: float) -> None:
        self.seconds.append(seconds)
        self.running = self.running and len(self.seconds) < self._frames

    def draw(self, surface: pygame.Surface) -> None:
        surface.fill((10, 20, 30))


def test_a_window_gives_events_and_time_and_shows_the_picture() -> None:
    game = Counting(frames=9)
    window = Window(game)
    assert pygame.display.get_caption()[0] == "Counting"
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_a))
    window.frame(0.02)
    window.frame(3.0)
    assert game.keys == [pygame.K_a]
    assert game.seconds == [0.02, 0.25], "a frame that took longer counts as a quarter of a second"
    assert window.surface.get_size() == game.size
    assert tuple(window.surface.get_at((5, 5)))[:3] == (10, 20, 30)
    assert game.meter.frames == 2


def test_while_kernels_are_compiled_a_line_in_the_corner_says_so_and_time_makes_no_leaps(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Wide(Counting):
        size = (400, 120)

    window, ticker = Window(Wide(frames=9)), Ticker(1 / 480)
    for compiling in (True, False):
        monkeypatch.setattr(carom, "compiling", lambda compiling=compiling: compiling)
        window.frame(0.02)
        shown = pygame.surfarray.array3d(window.surface)
        told = (shown != (10, 20, 30)).any(axis=2)
        assert told.any() == compiling
        assert not told[:, :100].any()
        assert ticker.due(0.25) == (8 if compiling else 48)


def test_steps_that_take_long_while_kernels_are_compiled_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    compiling = True
    monkeypatch.setattr(carom, "compiling", lambda: compiling)
    patience = Patience()
    assert patience.allows(0.02)
    for times in (1, 2):
        patience.took(0.2)
        assert not patience.allows(times - 0.5)
        assert patience.allows(0.6), "it is tried again"
    patience.took(0.01)
    assert patience.allows(0.02)
    for _ in range(3):
        patience.took(0.2)
    assert not patience.allows(99.0)
    compiling = False
    assert patience.allows(0.02)


def test_the_line_about_compiling_says_for_how_long(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(carom, "compiling", lambda: True)
    window = Window(Counting(frames=99))
    written: list[str] = []
    monkeypatch.setattr(Letters, "draw", lambda self, surface, words, *_, **__: written.append(words))
    for _ in range(5):
        window.frame(0.6)
    assert [words.split(" s:")[0][-4:] for words in written] == ["or 1", "or 1", "or 2", "or 2", "or 3"]


def test_a_window_says_that_it_is_there_until_its_first_frame() -> None:
    window = Window(Counting())
    shown = pygame.surfarray.array3d(pygame.display.get_surface()).max(axis=2)
    words = np.argwhere(shown > 150)
    assert len(words) > 50
    assert words.mean(axis=0) == pytest.approx((100, 60), abs=6.0)
    window.frame(0.01)
    assert (pygame.surfarray.array3d(pygame.display.get_surface()) == (10, 20, 30)).all()


def test_a_window_that_is_closed_ends_the_game() -> None:
    game = Counting(frames=99)
    window = Window(game)
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    window.frame(0.01)
    assert not game.running


def test_f11_is_the_windows_own_key() -> None:
    game = Counting()
    window = Window(game)
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_F11))
    window.frame(0.01)
    assert game.keys == []


class Pointing(Counting):
    """A game that notes where the mouse is, and shows one white corner."""

    def __init__(self) -> None:
        super().__init__(frames=99)
        self.places: list[tuple[tuple[int, int], tuple[int, int]]] = []

    def handle(self, event: pygame.event.Event) -> None:
        if event.type == pygame.MOUSEMOTION:
            self.places.append((event.pos, event.rel))

    def draw(self, surface: pygame.Surface) -> None:
        surface.fill((0, 0, 0))
        surface.fill((255, 255, 255), (150, 90, 50, 30))


@pytest.mark.parametrize(
    ("window_sides", "mouse", "place", "white"),
    [
        ((200, 120), (160, 100), (160, 100), (190, 110)),
        ((400, 240), (320, 200), (160, 100), (380, 220)),
        ((400, 120), (260, 100), (160, 100), (290, 110)),  # bars at both sides
        ((100, 90), (80, 65), (160, 100), (95, 70)),  # bars above and below
    ],
)
def test_a_window_of_any_size_shows_all_of_the_picture_and_knows_where_the_mouse_is(
    window_sides: tuple[int, int], mouse: tuple[int, int], place: tuple[int, int], white: tuple[int, int]
) -> None:
    game = Pointing()
    window = Window(game)
    pygame.display.set_mode(window_sides, pygame.RESIZABLE)
    window.frame(0.01)
    pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=mouse, rel=(4, 2), buttons=(0, 0, 0)))
    window.frame(0.01)
    scale = min(window_sides[0] / 200, window_sides[1] / 120)
    assert game.places == [(place, (round(4 / scale), round(2 / scale)))]
    shown = pygame.display.get_surface()
    assert tuple(shown.get_at(white))[:3] == (255, 255, 255)
    assert tuple(shown.get_at((window_sides[0] // 2, window_sides[1] // 2)))[:3] == (0, 0, 0)
    assert window.surface.get_size() == game.size


def test_a_picture_larger_than_the_desktop_is_shown_smaller() -> None:
    assert window_size((800, 840), (1920, 1080)) == (800, 840)
    assert window_size((800, 840), (1920, 1080), most=3) == (800, 840)
    assert window_size((800, 840), (3840, 2160)) == (800, 840)
    assert window_size((800, 840), (3840, 2160), most=3) == (1600, 1680)
    assert window_size((800, 840), (9999, 9999), most=3) == (2400, 2520)
    width, height = window_size((800, 840), (1366, 768))
    assert height < 0.9 * 768
    assert width / height == pytest.approx(800 / 840, rel=0.01)


def test_f11_fills_the_screen_and_leaves_it_again() -> None:
    window = Window(Counting(frames=99))
    sizes = []
    for _ in range(3):
        sizes.append(pygame.display.get_surface().get_size())
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_F11))
        window.frame(0.01)
    assert sizes[0] == sizes[2] == (200, 120)
    assert sizes[1] != (200, 120)
    assert window.surface.get_size() == (200, 120)


def test_a_screen_that_cannot_be_filled_keeps_the_window(monkeypatch: pytest.MonkeyPatch) -> None:
    game = Counting(frames=99)
    window = Window(game)
    set_mode = pygame.display.set_mode

    def refuse(size: tuple[int, int], flags: int) -> pygame.Surface:
        if flags & pygame.FULLSCREEN:
            raise pygame.error("no such mode")
        return set_mode(size, flags)

    monkeypatch.setattr(pygame.display, "set_mode", refuse)
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_F11))
    window.frame(0.01)
    assert game.running
    assert window.surface.get_size() == game.size


def test_a_game_is_played_until_it_ends_or_its_time_is_over() -> None:
    games: list[Counting] = []
    for frames, seconds in ((3, None), (10_000, 0.05)):

        def make(frames: int = frames) -> Counting:
            games.append(Counting(frames))
            return games[-1]

        meter = play(make, seconds)
        assert not pygame.display.get_init()
        assert 1 <= meter.frames < 100
    assert len(games[0].seconds) == 3


def test_without_a_screen_one_line_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ("SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"):
        monkeypatch.delenv(variable, raising=False)
    made: list[Counting] = []
    if os.name != "posix":
        pytest.skip("there is always a screen")
    with pytest.raises(NoDisplay, match=r"^no window can be opened: .+$"):
        play(lambda: made.append(Counting()) or made[0], None)  # type: ignore[func-returns-value]
    assert made == []
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    with pytest.raises(carom.CaromError, match=r"no window can be opened: .*nonsense"):
        play(Counting, None)


def test_steps_of_one_length_are_made_of_frames_of_any_length() -> None:
    ticker = Ticker(0.01)
    assert sum(ticker.due(1.0 / 60.0) for _ in range(600)) in (999, 1000)
    assert ticker.due(0.004) + ticker.due(0.004) + ticker.due(0.004) == 1
    assert Ticker(0.01, most=0.1).due(5.0) == 10
    exact = Ticker(1.0 / 60.0)
    assert [exact.due(1.0 / 60.0) for _ in range(300)] == [1] * 300


def test_a_meter_tells_rate_and_work() -> None:
    meter = FrameMeter(50)
    assert (meter.rate, meter.work, meter.share, meter.line()) == (0.0, 0.0, 0.0, "no frames")
    for count in (1, 2, 3, 4):
        meter.begin()
        meter.end()
        assert meter.line().startswith(f"{count} frames: ")
    assert meter.frames == 4
    assert 0.0 <= meter.work < 0.01
    assert meter.share == pytest.approx(meter.work * 50)
    assert meter.rate > 0.0


KEYS = {pygame.K_LSHIFT: "left", pygame.K_z: "left", pygame.K_SPACE: "fire"}
BUTTONS = {Button.LEFT: "left", Button.SOUTH: "fire", Button.UP: "up"}


def read(controls: Controls[str], kind: int, **values: object) -> list[tuple[str, bool]]:
    """The actions of one event."""
    return controls.read(pygame.event.Event(kind, **values))


def test_keys_are_actions() -> None:
    controls = Controls(KEYS, BUTTONS, lambda line: None)
    assert read(controls, pygame.KEYDOWN, key=pygame.K_z) == [("left", True)]
    assert read(controls, pygame.KEYUP, key=pygame.K_z) == [("left", False)]
    assert read(controls, pygame.KEYDOWN, key=pygame.K_q) == []
    assert read(controls, pygame.MOUSEMOTION, pos=(0, 0)) == []


def test_buttons_hats_and_sticks_are_actions_once_each() -> None:
    controls = Controls(KEYS, BUTTONS, lambda line: None)
    assert read(controls, pygame.JOYBUTTONDOWN, instance_id=3, button=0) == [("fire", True)]
    assert read(controls, pygame.JOYBUTTONUP, instance_id=3, button=0) == [("fire", False)]
    assert read(controls, pygame.JOYBUTTONDOWN, instance_id=3, button=77) == []
    assert read(controls, pygame.JOYHATMOTION, instance_id=3, hat=0, value=(-1, 1)) == [("left", True), ("up", True)]
    assert read(controls, pygame.JOYHATMOTION, instance_id=3, hat=0, value=(0, 0)) == [("left", False), ("up", False)]
    pushes = [0.2, -0.6, -0.4, -0.9, -0.3, 0.9]
    seen = [read(controls, pygame.JOYAXISMOTION, instance_id=3, axis=0, value=push) for push in pushes]
    assert seen == [[], [("left", True)], [], [], [("left", False)], []]
    assert read(controls, pygame.JOYAXISMOTION, instance_id=3, axis=1, value=-1.0) == [("up", True)]
    assert read(controls, pygame.JOYAXISMOTION, instance_id=3, axis=4, value=-1.0) == []


def test_what_a_lost_controller_held_is_let_go() -> None:
    told: list[str] = []
    controls = Controls(KEYS, BUTTONS, told.append)
    read(controls, pygame.JOYBUTTONDOWN, instance_id=3, button=0)
    assert read(controls, pygame.JOYDEVICEREMOVED, instance_id=3) == [("fire", False)]
    assert read(controls, pygame.JOYDEVICEADDED, device_index=40) == []
    assert told == [told[0]]
    assert told[0].startswith("a controller cannot be used: ")


class Pad:
    """A controller as pygame gives it."""

    def __init__(self, index: int) -> None:
        self.index = index

    def get_instance_id(self) -> int:
        return 10 + self.index

    def get_name(self) -> str:
        return "Old Faithful"


def test_a_controller_that_comes_and_goes_is_told_of(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[str] = []
    monkeypatch.setattr(pygame.joystick, "Joystick", Pad)
    controls = Controls(KEYS, BUTTONS, told.append)
    assert read(controls, pygame.JOYDEVICEADDED, device_index=1) == []
    assert read(controls, pygame.JOYDEVICEREMOVED, instance_id=11) == []
    assert told == ["controller: Old Faithful", "the controller is gone; the keys still work"]


def test_sounds_are_the_same_each_time_and_within_bounds() -> None:
    for make in (
        lambda: tone(440.0, 0.2, fall=8.0, overtones=(1.0, 0.4)),
        lambda: tone(440.0, 0.1, to=220.0),
        lambda: noise(0.1, fall=20.0, dull=0.5, seed=3),
        lambda: mixed(tone(300.0, 0.1), noise(0.2)),
        lambda: joined(tone(300.0, 0.1), tone(400.0, 0.1)),
    ):
        wave = make()
        assert np.array_equal(wave, make())
        assert np.abs(wave).max() <= 1.0
        assert np.abs(wave).max() > 0.1
        assert abs(wave[0]) < 0.01
        assert abs(wave[-1]) < 0.02, "it ends without a click"


def test_a_tone_has_its_frequency_and_fades() -> None:
    wave = tone(1000.0, 0.5, fall=6.0)
    assert np.argmax(np.abs(np.fft.rfft(wave))) * RATE / len(wave) == pytest.approx(1000.0, abs=3.0)
    first, last = np.abs(wave[: RATE // 10]).max(), np.abs(wave[-RATE // 10 :]).max()
    assert last / first == pytest.approx(np.exp(-6.0 * 0.4), rel=0.1)
    glide = np.abs(np.fft.rfft(tone(1000.0, 0.5, to=500.0)))
    assert 500.0 <= np.argmax(glide) * RATE / len(wave) <= 1000.0


def test_a_speaker_plays_as_loud_as_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[str] = []
    speaker = Speaker({"click": tone(800.0, 0.5)}, told.append)
    assert told == []
    speaker.play("click", 0.5)
    heard = [channel for channel in map(pygame.mixer.Channel, range(24)) if channel.get_busy()]
    assert [channel.get_volume() for channel in heard] == [pytest.approx(0.5, abs=0.01)]
    speaker.play("click", 0.001)
    speaker.muted = True
    speaker.play("click", 1.0)
    assert sum(pygame.mixer.Channel(k).get_busy() for k in range(24)) == 1
    speaker.stop()
    assert not pygame.mixer.get_busy()


def test_without_a_sound_card_a_speaker_is_silent_and_says_so_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "nonsense")
    told: list[str] = []
    speaker = Speaker({"click": tone(800.0, 0.1)}, told.append)
    speaker.play("click")
    speaker.stop()
    assert speaker.silent
    assert len(told) == 1
    assert told[0].startswith("no sound: ")


def test_sounds_are_sixteen_bit_numbers() -> None:
    assert samples(np.array([0.0, 1.0, -2.0])) == np.array([0, 32_767, -32_767], "<i2").tobytes()
    assert np.array_equal(faded(np.ones(0), 1.0), np.ones(0))


def test_words_stand_where_they_are_to() -> None:
    letters = Letters()
    wide = letters.width("Tilt", 30)
    for anchor, left in (("start", 100), ("middle", 100 - wide / 2), ("end", 100 - wide)):
        surface = pygame.Surface((300, 60))
        letters.draw(surface, "Tilt", (100, 10), 30, (255, 255, 255), anchor=anchor)  # type: ignore[arg-type]
        box = pygame.mask.from_threshold(surface, (255, 255, 255), (90, 90, 90)).get_bounding_rects()
        assert min(one.left for one in box) == pytest.approx(left, abs=3)
        assert min(one.top for one in box) >= 10


def test_the_corner_has_one_line_where_a_screenshot_was_kept_if_one_was(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(carom, "compiling", lambda: True)
    window = Window(Counting(frames=99))
    window._kept, window._kept_left = "kept", 0.5
    written: list[str] = []
    monkeypatch.setattr(Letters, "draw", lambda self, surface, words, *_, **__: written.append(words))
    for _ in range(2):
        window.frame(0.5)
    assert written[0] == "kept"
    assert written[1].startswith("compiling")
    assert len(written) == 2
