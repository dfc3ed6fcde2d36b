"""The pool table's picture, the balls that roll on it, and its sounds."""

from __future__ import annotations

from math import dist, pi

import numpy as np
import pygame
import pytest

import carom
from carom.play.pool import sounds
from carom.play.pool.ball_art import RollingBall
from carom.play.pool.game import Impact, Pool
from carom.play.pool.layout import CLOTH, SCALE, SIZE
from carom.play.pool.session import Session
from carom.play.pool.sprites import Cue, ring, spot
from carom.play.pool.table_art import cloth_of, outline, pockets, rim, table_picture
from carom.play.pool.view import View, stroke

BALL = 11.0


def drawn(ball: RollingBall, place: tuple[float, float] = (20.0, 20.0), **looks: float) -> np.ndarray:
    """The colours of a small surface with a ball on it."""
    surface = pygame.Surface((40, 40), 0, 32)
    surface.fill((0, 90, 80))
    ball.draw(surface, place, **looks)
    return pygame.surfarray.array3d(surface).astype(int)


# -- the table -------------------------------------------------------------------------------------------------------


def test_a_pixel_and_its_place_belong_together() -> None:
    layout = cloth_of(Pool().world)
    assert (layout.width, layout.height) == pytest.approx((254.0, 127.0))
    assert layout.place(layout.pixel((31.0, 99.0))) == pytest.approx((31.0, 99.0))
    assert layout.pixel((0.0, 10.0))[1] > layout.pixel((0.0, 20.0))[1]


def test_the_outline_is_closed_and_has_no_jumps() -> None:
    shapes = rim(Pool().world)
    corners = outline(shapes)
    longest = max(shape.length for shape in shapes if isinstance(shape, carom.Segment))
    steps = [dist(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    assert max(steps) <= longest + 1e-9
    assert sum(steps) == pytest.approx(sum(shape.length for shape in shapes), rel=1e-3)
    assert len(pockets(Pool().world)) == 6


@pytest.mark.slow
def test_the_picture_shows_cloth_wood_and_dark_pockets() -> None:
    picture = table_picture().astype(int)
    world = Pool().world
    layout = cloth_of(world)
    assert picture.shape == (*SIZE, 3)
    x, y = map(round, layout.pixel((100.0, 60.0)))
    assert np.abs(picture[x, y] - CLOTH).max() < 30
    for arc in pockets(world):
        x, y = map(round, layout.pixel(arc.center))
        assert picture[x, y].max() < 40
    x, y = map(round, layout.pixel((100.0, -10.0)))
    red, _, blue = picture[x, y]
    assert red > 1.5 * blue


# -- balls -----------------------------------------------------------------------------------------------------------


def test_a_ball_covers_its_circle_and_nothing_else() -> None:
    for number in range(9):
        changed = np.abs(drawn(RollingBall(BALL, number)) - (0, 90, 80)).max(axis=2) > 8
        x, y = np.meshgrid(np.arange(40) + 0.5, np.arange(40) + 0.5, indexing="ij")
        distance = np.hypot(x - 20.0, y - 20.0)
        assert changed[distance < BALL - 1.0].mean() > 0.99
        assert not changed[distance > BALL + 1.0].any()


def test_a_ball_lies_between_pixels_too() -> None:
    ball = RollingBall(BALL, number=0)
    x = np.arange(40) + 0.5
    middles = []
    for shift in (0.0, 0.25, 0.5, 0.75):
        weight = np.abs(drawn(ball, (20.0 + shift, 20.0)) - (0, 90, 80)).max(axis=2) > 40
        middles.append(float((weight.sum(axis=1) * x).sum() / weight.sum()))
    assert np.diff(middles) == pytest.approx(0.25, abs=0.2)
    assert middles[-1] - middles[0] == pytest.approx(0.75, abs=0.2)


def test_a_ball_rolls_over_its_circumference_in_one_turn() -> None:
    ball = RollingBall(BALL, number=8)
    before = drawn(ball)
    ball.roll(0.0, 0.0)
    assert (drawn(ball) == before).all()
    ball.roll(0.5 * pi * BALL, 0.0)
    assert (drawn(ball) != before).any()
    ball.roll(1.5 * pi * BALL, 0.0)
    assert np.abs(drawn(ball) - before).max() <= 1
    ball.roll(3.0, 4.0)
    ball.reset()
    assert (drawn(ball) == before).all()


def test_a_point_on_top_of_a_ball_rolls_the_way_it_goes() -> None:
    ball = RollingBall(BALL, number=8)
    ball.turn = np.eye(3)
    ball.roll(0.3 * BALL, 0.0)
    top = ball.turn @ np.array((0.0, 0.0, 1.0))
    assert top[0] > 0.25
    assert top[1] == pytest.approx(0.0)


def test_a_ball_in_a_pocket_is_smaller_and_darker() -> None:
    ball = RollingBall(BALL, number=0)
    bright, dark = drawn(ball), drawn(ball, size=0.8, bright=0.3)
    assert dark[20, 20].sum() < 0.5 * bright[20, 20].sum()
    assert (np.abs(dark - (0, 90, 80)).max(axis=2) > 8).sum() < (np.abs(bright - (0, 90, 80)).max(axis=2) > 8).sum()


# -- other pictures --------------------------------------------------------------------------------------------------


def test_the_cue_points_at_the_ball_from_behind() -> None:
    surface = pygame.Surface((1400, 400), 0, 32)
    cue = Cue()
    for _ in range(2):
        surface.fill((255, 255, 255))
        cue.draw(surface, (1000.0, 200.0), (1.0, 0.0))
        changed = pygame.surfarray.array3d(surface).min(axis=2) < 250
        columns = np.flatnonzero(changed[:, 190:205].any(axis=1))
        assert columns[-1] == pytest.approx(1000, abs=3)
        assert columns[0] == pytest.approx(430, abs=4)


def test_rings_and_spots_fade_into_what_is_there() -> None:
    alpha = pygame.surfarray.array_alpha(ring(10.0, 2.0, (1, 2, 3), 1.0))
    middle = alpha.shape[0] // 2
    assert alpha[middle, middle] == 0
    assert alpha[middle + 9 : middle + 11, middle].max() == 255
    alpha = pygame.surfarray.array_alpha(spot(10.0, (1, 2, 3), 0.5, 1.0))
    assert alpha[alpha.shape[0] // 2, alpha.shape[1] // 2] == pytest.approx(127, abs=4)
    assert alpha[0, 0] == 0


def test_a_line_without_length_draws_nothing() -> None:
    surface = pygame.Surface((20, 20), 0, 32)
    stroke(surface, (5.0, 5.0), (5.0, 5.0), (255, 255, 255))
    assert pygame.surfarray.array3d(surface).max() == 0
    stroke(surface, (5.0, 5.0), (15.0, 5.0), (255, 255, 255))
    assert pygame.surfarray.array3d(surface)[10, 4:7].max() > 100


def test_every_pocket_has_its_ring() -> None:
    pygame.display.init()
    session = Session()
    view = View(session)
    names = {shape.name for shape in session.pool.world.shapes if shape.sensor}
    assert {*view._pockets} == names
    assert view.radius == pytest.approx(session.pool.cue.radius * SCALE)


# -- sounds ----------------------------------------------------------------------------------------------------------


def test_there_is_a_sound_for_every_impact_and_for_the_end() -> None:
    waves = sounds.waves()
    assert {*waves} == {*Impact, sounds.WON, sounds.LOST}
    for wave in waves.values():
        assert np.isfinite(wave).all()
        assert 0.05 < np.abs(wave).max() <= 1.0


@pytest.mark.parametrize("impact", [*Impact])
def test_harder_impacts_are_louder(impact: Impact) -> None:
    volumes = [sounds.volume(impact, impulse) for impulse in (0.02, 1.0, 10.0, 40.0, 1000.0)]
    assert volumes == sorted(volumes)
    assert volumes[-1] == 1.0
    assert volumes[0] < 0.05
