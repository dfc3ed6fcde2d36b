"""The cue ball is put on the base line before the first shot, by mouse and keys, and nowhere else."""

from __future__ import annotations

from math import atan2, hypot

import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.play.pool.game import ROOM, Phase, Pool, Setup
from tests.play.pool.test_pool_window import Player

QUARTER = 254.0 / 4.0


@settings(max_examples=25, deadline=None)
@given(heights=st.lists(st.floats(-50.0, 200.0), min_size=1, max_size=5), eight=st.floats(10.0, 117.0))
def test_wherever_it_is_put_it_lies_on_the_line_clear_of_cushions_and_the_eight(
    heights: list[float], eight: float
) -> None:
    pool = Pool(Setup(cue=(100.0, 60.0), eight=(QUARTER, eight)))
    radius = pool.cue.radius
    for height in heights:
        before = pool.cue.position
        pool.put_cue(height)
        x, y = pool.cue.position
        if (x, y) != before:
            assert x == pytest.approx(QUARTER)
            assert ROOM * radius - 1e-9 <= y <= 127.0 - ROOM * radius + 1e-9
            assert y == pytest.approx(min(max(height, ROOM * radius), 127.0 - ROOM * radius))
        assert hypot(x - QUARTER, y - eight) >= ROOM * radius
        assert (pool.setup.cue, pool.shot_from[0], pool.setup.eight) == ((x, y), (x, y), (QUARTER, eight))


@pytest.mark.slow
def test_the_ball_is_dragged_and_no_shot_is_made() -> None:
    player = Player()
    layout, start = player.app.view.layout, player.pool.cue.position
    player.mouse(pygame.MOUSEBUTTONDOWN, pos=layout.pixel(start), button=1)
    assert player.session.dragging
    player.point((90.0, 30.0))
    assert player.pool.cue.position == pytest.approx((QUARTER, 30.0), abs=0.3)
    player.mouse(pygame.MOUSEBUTTONUP, pos=layout.pixel((90.0, 30.0)), button=1)
    assert not player.session.dragging
    x, y = player.pool.eight.position
    assert player.session.angle == pytest.approx(atan2(y - 30.0, x - QUARTER), abs=0.01)
    player.point((90.0, 80.0))
    assert player.pool.cue.position == pytest.approx((QUARTER, 30.0), abs=0.3)
    assert (player.pool.shots, player.pool.phase) == (0, Phase.AIM)


def test_keys_put_it_up_and_down_and_the_same_position_comes_again_with_it() -> None:
    player = Player()
    height = player.pool.cue.position[1]
    player.press(pygame.K_w)
    player.press(pygame.K_w)
    assert player.pool.cue.position == pytest.approx((QUARTER, height + 1.0))
    player.press(pygame.K_x, frames=60)
    assert player.pool.cue.position[1] == pytest.approx(height + 1.0 - 0.5 - 30.0 * 0.75, abs=1.5)
    put = player.pool.cue.position
    player.press(pygame.K_RETURN)
    player.press(pygame.K_w)
    assert player.pool.shots == 1
    player.frames(5)
    assert player.pool.cue.position != put
    player.press(pygame.K_t)
    assert player.pool.cue.position == put


def test_after_the_first_shot_it_is_played_from_where_it_lies() -> None:
    player = Player(Setup(cue=(QUARTER, 60.0), eight=(200.0, 20.0)))
    player.session.power = 0.05
    player.press(pygame.K_RETURN)
    for _ in range(40):
        player.frames(30)
        if player.pool.phase is Phase.AIM:
            break
    assert (player.pool.phase, player.pool.base_line) == (Phase.AIM, None)
    place = player.pool.cue.position
    player.press(pygame.K_w, frames=10)
    assert player.pool.cue.position == place
    player.mouse(pygame.MOUSEBUTTONDOWN, pos=player.app.view.layout.pixel(place), button=1)
    assert not player.session.dragging
