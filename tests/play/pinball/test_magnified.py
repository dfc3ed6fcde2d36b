"""Pinball in large windows: the picture is drawn larger, and shows the same."""

import pygame
import pytest

from carom.play.pinball import Event, EventKind, PinballApp
from carom.play.pinball.art import pictures as art
from carom.play.pinball.screen.lines import Mode
from carom.play.window import Window
from tests.play.pinball.playing import STEP, backs_once, key, make_once, session, tapped
from tests.play.screens import different

#: The part of the blocks that may differ: the widths of letters are whole pixels at each size, so long lines shift.
SHIFTED, MOST_SHIFTED = 0.005, 0.08


@pytest.fixture(autouse=True)
def once(monkeypatch: pytest.MonkeyPatch) -> None:
    make_once(monkeypatch)


def enlarge(window: Window, times: int) -> None:
    """Make the window so many times as large, and go on by no time."""
    pygame.display.set_mode((800 * times, 840 * times), pygame.RESIZABLE)
    window.frame(0.0)


def shown(window: Window) -> pygame.Surface:
    """What is in the window, in the size of the smallest one."""
    return pygame.transform.smoothscale(window.surface, (400, 420))


def check(app: PinballApp, window: Window, times: int, most: float) -> None:
    """Fail unless the picture shows the same in a window so many times as large, and in one of the old size again."""
    window.frame(0.0)
    small = shown(window)
    enlarge(window, times)
    assert window.surface.get_size() == app.size == (800 * times, 840 * times)
    assert different(shown(window), small) <= most
    enlarge(window, 1)
    assert different(shown(window), small) == 0.0


@pytest.mark.slow
@pytest.mark.parametrize("times", [2, 3])
def test_a_magnified_picture_shows_the_same(times: int) -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    (ball,) = app.game.world.balls
    ball.position = (9.0, 14.0)
    app.game.plunger_pull = 0.6
    app.game.table.lower("drop target 2")
    key(pygame.K_LEFT)
    window.frame(12 * STEP)
    app.effects.note([Event(EventKind.TARGET, "left target", (9.3, 21.5), 60.0, 1_000), Event(EventKind.MULTIBALL)])
    for mode in Mode:
        app.mode = mode
        check(app, window, times, SHIFTED)
    app.paused = True
    check(app, window, times, SHIFTED)
    app.helping = True
    check(app, window, times, MOST_SHIFTED)


@pytest.mark.slow
def test_a_nudged_table_moves_as_far_in_a_magnified_picture() -> None:
    app, window = session()
    enlarge(window, 2)
    before = pygame.Surface((1600, 1680))
    app.draw(before)
    app.effects.note([Event(EventKind.NUDGE, "nudge right")])
    after = pygame.Surface((1600, 1680))
    app.draw(after)
    along, down = app.effects.shift
    moved = before.subsurface((0, 0, 700, 1600)), after.subsurface((2 * along, 2 * down, 700, 1600))
    assert (along, down) != (0, 0)
    assert pygame.image.tobytes(moved[0], "RGB") == pygame.image.tobytes(moved[1], "RGB")


def test_the_back_is_painted_as_large() -> None:
    assert {back.get_size() for back in backs_once(2)} == {(768, 1680)}


@pytest.mark.slow
def test_words_and_shadows_are_where_they_are_in_a_small_picture() -> None:
    app, window = session()
    tapped(window, pygame.K_RETURN)
    (ball,) = app.game.world.balls
    ball.position = (9.0, 14.0)
    app.effects.note([Event(EventKind.LANE, "left lane", (9.3, 21.5), 0.0, 88_888)])
    seen = []
    for times in (1, 2):
        enlarge(window, times)
        x, y = art.pixel((9.0, 14.0))
        beside = pygame.Rect(int(x) - 4, int(y) + 12, 12, 4)
        x, y = art.pixel((9.3, 21.5))
        words = pygame.Rect(int(x) - 26, int(y) - 16, 52, 16)
        areas = [[times * side for side in rect] for rect in (beside, words)]
        seen.append([pygame.transform.average_color(window.surface, area)[:3] for area in areas])
    for small, large in zip(*seen, strict=True):
        assert large == pytest.approx(small, abs=12.0)
