"""Pool in large windows: the picture is drawn larger, and shows the same."""

from __future__ import annotations

from threading import Thread

import numpy as np
import pygame
import pytest

from carom.play.pool import tables
from carom.play.pool.game import Setup
from carom.play.pool.table_art import table_picture
from tests.pixels import blocks
from tests.play.pool.test_pool_window import Player
from tests.play.screens import different

#: The part of the blocks that may differ where there are few words, and where there are many: the widths of letters are
#: whole pixels at each size, so long lines shift.
FEW_SHIFTED, MOST_SHIFTED = 0.01, 0.05


class Unpainted(Thread):
    """A painter that takes for ever: nobody waits for it here."""

    def start(self) -> None:
        pass

    def is_alive(self) -> bool:
        return True


@pytest.fixture
def player(monkeypatch: pytest.MonkeyPatch) -> Player:
    """A player whose large table is not painted."""
    monkeypatch.setattr(tables, "Thread", Unpainted)
    return Player(Setup(cue=(200.0, 60.0), eight=(220.0, 66.0)))


def enlarge(player: Player, times: int) -> None:
    """Make the window so many times as large, and go on by no time."""
    pygame.display.set_mode((1200 * times, 720 * times), pygame.RESIZABLE)
    player.window.frame(0.0)


@pytest.mark.parametrize("times", [2, pytest.param(3, marks=pytest.mark.slow)])
def test_a_magnified_picture_shows_the_same(player: Player, times: int) -> None:
    def shown() -> pygame.Surface:
        return pygame.transform.smoothscale(player.window.surface, (600, 360))

    def check(most: float) -> None:
        player.window.frame(0.0)
        small, turn = shown(), player.app.view.balls["cue ball"].turn
        enlarge(player, times)
        assert player.app.view.balls["cue ball"].turn is turn, "a ball is seen turned as it was"
        assert player.window.surface.get_size() == player.app.size == (1200 * times, 720 * times)
        assert different(shown(), small) <= most
        enlarge(player, 1)
        assert different(shown(), small) == 0.0

    player.point((219.0, 63.0))
    check(FEW_SHIFTED)
    for key in (pygame.K_s, pygame.K_c, pygame.K_RETURN, pygame.K_b, *[pygame.K_n] * 12):
        player.press(key)
    check(FEW_SHIFTED)
    player.press(pygame.K_F1)
    check(MOST_SHIFTED)


def test_the_mouse_points_where_it_is_in_a_magnified_picture(player: Player) -> None:
    enlarge(player, 2)
    x, y = player.app.view.layout.pixel((120.0, 100.0))
    assert (x, y) > (600.0, 200.0)
    player.mouse(pygame.MOUSEMOTION, pos=(round(x), round(y)), rel=(0, 0), buttons=(0, 0, 0))
    assert player.session._pointer == pytest.approx((120.0, 100.0), abs=0.2)


@pytest.mark.slow
def test_the_large_table_is_painted_in_the_background_like_the_small_one() -> None:
    player = Player()
    enlarge(player, 2)
    painter = player.app.view.table.painter
    assert painter is not None
    painter.join()
    player.window.frame(0.0)
    assert player.app.view.table.painter is None
    large, small = table_picture(2), table_picture()
    assert np.array_equal(pygame.surfarray.array3d(player.app.view.table.picture), large)
    halved = large.reshape(1200, 2, 720, 2, 3).mean(axis=(1, 3))
    assert np.abs(blocks(halved, 6) - blocks(small.astype(float), 6)).max() < 20.0
