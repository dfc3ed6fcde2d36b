"""Windows of any size: whatever a person or a window manager does to one, the game in it goes on and is all there.

A window changes its size while events are handed out: the surface of the display is another one from then on. Here
`Desktop` does that to `pygame.event.get`, as systems do it to a window on a screen.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.play.meter import FrameMeter
from carom.play.pool.app import PoolApp
from carom.play.window import Game, Window
from tests.play.pinball import playing as pinball_playing

pygame_gui = pytest.importorskip("pygame_gui", reason='no pygame_gui: pip install "carom[play]"')

from carom.play.toy.app import Toy  # noqa: E402  # needs pygame_gui

Size = tuple[int, int]

F11 = pygame.K_F11
WHITE, BLACK = (255, 255, 255), (0, 0, 0)
#: Sizes that people and window managers make: small, flat, narrow, hardly there, as large as a screen, any.
SIZES: list[Size] = [
    (200, 150),
    (500, 500),
    (1920, 1080),
    (1280, 800),
    (1, 1),
    (1, 900),
    (1600, 1),
    (2, 3),
    (3840, 2160),
]


class Desktop:
    """What hands out events: first the window gets new sizes, one after another, then there is what was posted."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._get = pygame.event.get
        self._sizes: list[Size] = []
        monkeypatch.setattr(pygame.event, "get", self._events)

    def _events(self, *arguments: Any) -> list[pygame.event.Event]:
        """The events, as `pygame.event.get` hands them out."""
        for size in self._sizes:
            pygame.display.set_mode(size, pygame.RESIZABLE)
            pygame.event.post(pygame.event.Event(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1]))
        self._sizes = []
        return self._get(*arguments)

    def frame(self, window: Window, sizes: Iterable[Size] = (), *posted: pygame.event.Event) -> None:
        """Play a frame, before which the window gets some sizes, and some events come."""
        self._sizes = list(sizes)
        for event in posted:
            pygame.event.post(event)
        window.frame(1 / 60)


def pressed(key: int) -> pygame.event.Event:
    """A key that goes down."""
    return pygame.event.Event(pygame.KEYDOWN, key=key, mod=0, unicode="", scancode=0)


def moved(place: tuple[int, int]) -> pygame.event.Event:
    """A mouse that moves."""
    return pygame.event.Event(pygame.MOUSEMOTION, pos=place, rel=(1, 1), buttons=(0, 0, 0))


class White:
    """A game that is all white, and notes where the mouse is."""

    title = "White"
    size = (320, 200)

    def __init__(self) -> None:
        self.running = True
        self.meter = FrameMeter(60)
        self.mouse = (-1, -1)

    def handle(self, event: pygame.event.Event) -> None:
        if event.type == pygame.MOUSEMOTION:
            self.mouse = event.pos

    def advance(self, seconds: float) -> None:
        pass

    def draw(self, surface: pygame.Surface) -> None:
        assert surface.get_size() == self.size, "a game draws into a surface of its size, whatever the window's is"
        surface.fill(WHITE)


def shown_size() -> Size:
    """The window's size."""
    window = pygame.display.get_surface()
    assert window is not None
    return window.get_size()


def check_whole(game: White, window: Window, desktop: Desktop) -> None:
    """Check that the whole picture is in the window, as large as fits, black around it, and that the mouse is right."""
    width, height = shown_size()
    scale = min(width / game.size[0], height / game.size[1])
    surface = pygame.display.get_surface()
    assert surface is not None
    # Not black: pygame makes grey of a white picture that it shrinks to a few pixels.
    seen = pygame.surfarray.array3d(surface).max(axis=2) > 0
    columns, lines = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    box = pygame.Rect(columns[0], lines[0], columns[-1] - columns[0] + 1, lines[-1] - lines[0] + 1)
    assert np.count_nonzero(seen) == box.width * box.height
    for side, wanted in zip(box.size, game.size, strict=True):
        assert abs(side - max(1.0, scale * wanted)) <= 1.0
    assert abs(box.centerx - width / 2) <= 1.0
    assert abs(box.centery - height / 2) <= 1.0
    desktop.frame(window, (), moved(box.center))
    assert abs(game.mouse[0] - game.size[0] / 2) <= 1.0 / scale + 1.0
    assert abs(game.mouse[1] - game.size[1] / 2) <= 1.0 / scale + 1.0


sizes = st.sampled_from([size for size in SIZES if max(size) < 1300]) | st.tuples(
    st.integers(1, 700), st.integers(1, 700)
)


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(frames=st.lists(st.tuples(st.lists(sizes, max_size=3), st.booleans()), max_size=6))
def test_after_any_sizes_the_whole_picture_is_shown(frames: list[tuple[list[Size], bool]]) -> None:
    with pytest.MonkeyPatch.context() as monkeypatch:
        desktop, game = Desktop(monkeypatch), White()
        window = Window(game)
        for wanted, full in frames:
            desktop.frame(window, wanted, *([pressed(F11)] if full else []))
            check_whole(game, window, desktop)
    pygame.quit()


@settings(max_examples=30, deadline=None)
@given(size=sizes, times=st.integers(1, 3))
def test_f11_and_back_the_window_is_as_large_as_it_was(size: Size, times: int) -> None:
    with pytest.MonkeyPatch.context() as monkeypatch:
        desktop = Desktop(monkeypatch)
        window = Window(White())
        desktop.frame(window, [size])
        for _ in range(times):
            desktop.frame(window, (), pressed(F11))
            full = shown_size()
            desktop.frame(window, (), pressed(F11))
            assert shown_size() == size
        desktop.frame(window, [(300, 300), size], pressed(F11))
        assert shown_size() == full
        desktop.frame(window, (), pressed(F11))
        assert shown_size() == size
    pygame.quit()


def test_a_screen_that_cannot_be_filled_leaves_the_window_as_large_as_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    desktop, game, set_mode = Desktop(monkeypatch), White(), pygame.display.set_mode

    def refuse(size: Size, flags: int) -> pygame.Surface:
        if flags & pygame.FULLSCREEN:
            raise pygame.error("no such mode")
        return set_mode(size, flags)

    window = Window(game)
    desktop.frame(window, [(211, 307)])
    monkeypatch.setattr(pygame.display, "set_mode", refuse)
    desktop.frame(window, (), pressed(F11))
    assert shown_size() == (211, 307)
    check_whole(game, window, desktop)


class Sharp(White):
    """A game that is all white, and draws larger in large windows."""

    size = (320, 200)

    def magnify(self, times: int) -> None:
        self.size = (320 * times, 200 * times)


@pytest.mark.parametrize(
    ("window_size", "times"),
    [
        ((319, 199), 1),
        ((639, 900), 1),
        ((640, 400), 2),
        ((700, 400), 2),
        ((800, 500), 2),
        ((961, 700), 3),
        ((1300, 830), 3),
        ((1, 1), 1),
    ],
)
def test_a_game_that_can_draws_larger_in_large_windows(
    window_size: Size, times: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    desktop, game = Desktop(monkeypatch), Sharp()
    window = Window(game)
    desktop.frame(window, [window_size])
    assert window.surface.get_size() == game.size == (320 * times, 200 * times)
    # Whatever a system leaves in a window's new surface, it is black around the picture.
    pygame.display.get_surface().fill(WHITE)
    desktop.frame(window)
    check_whole(game, window, desktop)
    desktop.frame(window, [(320, 200)])
    assert game.size == (320, 200)
    assert window.surface is pygame.display.get_surface()


def test_a_window_on_a_large_screen_is_opened_larger_for_a_game_that_can(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [(1000, 700)])
    for game, times in ((White(), 1), (Sharp(), 2)):
        width, height = game.size
        window = Window(game)
        assert window.surface.get_size() == game.size == shown_size() == (times * width, times * height)
        pygame.quit()


def a_toy() -> Game:
    """The toy."""
    return Toy(lambda line: None)


def a_pinball() -> Game:
    """Pinball."""
    return pinball_playing.session()[0]


def a_pool() -> Game:
    """Pool."""
    return PoolApp(lambda line: None)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("make", [a_toy, a_pinball, a_pool])
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.filterwarnings("ignore")
def test_every_game_goes_on_in_windows_of_any_size(
    make: Callable[[], Game], seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    pinball_playing.make_once(monkeypatch)
    desktop, chance = Desktop(monkeypatch), random.Random(seed)
    pygame.display.init()
    game = make()
    window = Window(game)
    for _ in range(25):
        chosen = [
            chance.choice(SIZES) if chance.random() < 0.5 else (chance.randint(1, 1500), chance.randint(1, 1000))
            for _ in range(chance.choice([0, 1, 1, 2, 5]))
        ]
        width, height = shown_size()
        hand = [moved((chance.randint(-20, width + 20), chance.randint(-20, height + 20))) for _ in range(3)]
        place = hand[-1].pos
        kind = chance.choice([pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP])
        hand.append(pygame.event.Event(kind, pos=place, button=3))
        if chance.random() < 0.25:
            hand.insert(chance.randint(0, len(hand)), pressed(F11))
        desktop.frame(window, chosen, *hand)
        assert game.running
        assert window.surface.get_size() == game.size
    desktop.frame(window, [game.size])
    assert window.surface is pygame.display.get_surface(), "a window of the picture's size is drawn into itself"
