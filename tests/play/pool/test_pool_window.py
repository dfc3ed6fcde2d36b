"""Whole games of pool in a window, played by events alone, and what the window looks like."""

from __future__ import annotations

from math import atan2, cos, pi, sin
from pathlib import Path

import numpy as np
import pygame
import pytest

from carom.play.pool import run, setups, sounds
from carom.play.pool.app import PoolApp
from carom.play.pool.game import Impact, Phase, Setup
from carom.play.pool.layout import SCALE, SIZE
from carom.play.pool.table_art import pockets
from carom.play.pool.view import ARROW
from carom.play.window import HIGH, PLATE, Window
from tests.play import screens

EASY = Setup(cue=(238.0, 111.0), eight=(248.0, 121.0))
DANGER = Setup(cue=(244.0, 117.0), eight=(60.0, 60.0))


class Player:
    """A window with the game in it, and a player's hands."""

    def __init__(self, place: Setup | None = None) -> None:
        pygame.display.init()
        self.told: list[str] = []
        self.app = PoolApp(self.told.append)
        self.window = Window(self.app)
        self.session = self.app.session
        self.pool = self.session.pool
        self.heard: list[str] = []
        play = self.app.speaker.play
        self.app.speaker.play = lambda name, volume=1.0: (self.heard.append(str(name)), play(name, volume))[1]
        if place is not None:
            self.pool.place(place)
        self.frames(1)

    def frames(self, count: int) -> None:
        """Show some frames."""
        for _ in range(count):
            self.window.frame(1 / 60)

    def press(self, key: int, frames: int = 0) -> None:
        """Press a key, hold it for some frames, and let it go."""
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key))
        self.frames(frames)
        pygame.event.post(pygame.event.Event(pygame.KEYUP, key=key))
        self.frames(1)

    def point(self, place: tuple[float, float]) -> None:
        """Move the mouse to a place of the table."""
        self.mouse(pygame.MOUSEMOTION, pos=self.app.view.layout.pixel(place), rel=(0, 0), buttons=(0, 0, 0))

    def mouse(self, kind: int, **what: object) -> None:
        """Use the mouse."""
        pygame.event.post(pygame.event.Event(kind, **what))
        self.frames(1)

    def aim_to_win(self) -> None:
        """Aim so that the eight falls."""
        shot, power = setups.winning(self.pool) or pytest.fail("no shot wins")
        x, y = self.pool.cue.position
        self.point((x + 60.0 * shot.direction[0], y + 60.0 * shot.direction[1]))
        assert self.session.angle == pytest.approx(atan2(shot.direction[1], shot.direction[0]))
        self.mouse(pygame.MOUSEWHEEL, x=0, y=round((power - self.session.power) / 0.02))
        assert self.session.power == pytest.approx(power)

    def until_over(self, most: int = 1500) -> None:
        """Watch until the game is over and its message is there."""
        for _ in range(most):
            if self.pool.over and self.session.since_end > 1.0:
                return
            self.frames(1)
        pytest.fail("the game does not end")

    def check(self, name: str, renew: bool, folder: Path) -> None:
        """Compare the window with the kept one."""
        screens.check(f"pool-{name}", self.window.surface, renew=renew, folder=folder)


# -- whole games -----------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.compiled
def test_a_game_is_won_lost_and_played_again(renew: bool, tmp_path: Path) -> None:
    player = Player()
    player.aim_to_win()
    player.check("aim", renew, tmp_path)
    player.press(pygame.K_RETURN)
    player.until_over()
    assert player.pool.phase is Phase.WON
    assert player.heard[:2] == [Impact.STRIKE, Impact.BALLS]
    assert player.heard[-1] == sounds.WON
    player.check("won", renew, tmp_path)

    player.press(pygame.K_r)
    assert player.pool.phase is Phase.AIM
    assert player.session.number == 1
    pocket = next(shape for shape in player.pool.world.shapes if shape.name == "upper right pocket")
    player.point(pocket.position)
    player.check("danger", renew, tmp_path)
    player.press(pygame.K_SPACE, frames=40)
    player.until_over()
    assert player.pool.phase is Phase.LOST
    assert sounds.LOST in player.heard
    player.check("lost", renew, tmp_path)
    assert (player.session.won, player.session.lost) == (1, 1)

    player.press(pygame.K_SPACE)
    assert player.session.number == 2
    assert player.pool.phase is Phase.AIM


@pytest.mark.slow
@pytest.mark.compiled
def test_impacts_are_shown_while_the_balls_roll(renew: bool, tmp_path: Path) -> None:
    player = Player()
    player.point((195.0, 50.0))
    for _ in range(20):
        player.mouse(pygame.MOUSEWHEEL, x=0, y=1)
    player.press(pygame.K_c)
    player.press(pygame.K_RETURN)
    player.frames(210)
    assert player.pool.phase is Phase.ROLL
    assert {mark.impact for mark in player.pool.marks} == {Impact.BALLS, Impact.CUSHION}
    player.check("impacts", renew, tmp_path)
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_SPACE))
    for _ in range(1500):
        player.frames(1)
        if player.pool.phase is not Phase.ROLL:
            break
    # They have come to rest, whichever of them has fallen.
    assert player.pool.phase is not Phase.ROLL
    pygame.event.post(pygame.event.Event(pygame.KEYUP, key=pygame.K_SPACE))
    player.frames(1)


def test_step_by_step_the_balls_show_how_fast_they_are(renew: bool, tmp_path: Path) -> None:
    player = Player()
    player.point((195.0, 47.5))
    player.press(pygame.K_s)
    player.press(pygame.K_RETURN)
    player.frames(60)
    assert player.pool.age == 0.0
    player.press(pygame.K_b)
    assert len(player.pool.marks) == 1
    for _ in range(14):
        player.press(pygame.K_n)
    player.press(pygame.K_c)
    player.check("steps", renew, tmp_path)


@pytest.mark.slow
@pytest.mark.compiled
def test_the_same_presses_show_the_same_picture() -> None:
    pictures = set()
    for _ in range(2):
        player = Player()
        player.point((180.0, 100.0))
        player.press(pygame.K_c)
        player.press(pygame.K_SPACE, frames=50)
        player.frames(100)
        pictures.add((player.pool.digest(), pygame.image.tobytes(player.window.surface, "RGB")))
        pygame.quit()
    assert len(pictures) == 1


def test_the_help_covers_the_table(renew: bool, tmp_path: Path) -> None:
    player = Player()
    player.press(pygame.K_F1)
    player.check("help", renew, tmp_path)
    player.press(pygame.K_h)
    assert player.session.modes == set()


def test_a_short_game_is_won_by_keys() -> None:
    player = Player(EASY)
    player.session.angle, player.session.power = 0.7853981633974483, 0.3
    player.press(pygame.K_c)
    player.press(pygame.K_F2)
    player.press(pygame.K_RETURN)
    while not player.pool.over:
        player.frames(1)
    player.frames(60)
    player.press(pygame.K_c)
    player.frames(1)
    assert player.heard == [Impact.STRIKE, Impact.BALLS, Impact.POCKET, sounds.WON]
    assert player.session.won == 1
    pocket = next(arc for arc in pockets(player.pool.world) if arc.center[0] > 200.0 and arc.center[1] > 100.0)
    assert brightened(player, pocket.center, 5.2 * SCALE) > 0.6


def test_a_short_game_is_lost_by_the_mouse() -> None:
    player = Player(DANGER)
    player.point((250.0, 123.0))
    player.mouse(pygame.MOUSEBUTTONDOWN, button=1, pos=(0, 0))
    player.frames(50)
    assert player.session.draw is not None
    player.mouse(pygame.MOUSEBUTTONUP, button=1, pos=(0, 0))
    player.frames(30)
    assert player.pool.phase is Phase.LOST
    assert player.heard == [Impact.STRIKE, sounds.LOST, Impact.POCKET]


def brightened(player: Player, place: tuple[float, float], radius: float) -> float:
    """The part of a circle round a place of the table, `radius` pixels wide, that is brighter than the bare table."""
    x, y = player.app.view.layout.pixel(place)
    angles = [2.0 * pi * part / 40.0 for part in range(40)]
    pixels = [(round(x + radius * cos(angle) - 0.5), round(y + radius * sin(angle) - 0.5)) for angle in angles]
    screen, table = player.window.surface, player.app.view.table.picture
    return sum(sum(screen.get_at(pixel)[:3]) > sum(table.get_at(pixel)[:3]) + 60 for pixel in pixels) / len(pixels)


def test_the_ghost_ball_is_a_ring_where_the_cue_ball_will_be() -> None:
    player = Player()
    player.point((190.0, 60.0))
    shown = player.session.preview() or pytest.fail("there is no line of aim")
    radius = player.app.view.radius
    assert brightened(player, shown.aim.ghost, radius) > 0.7
    assert brightened(player, (127.0, 90.0), radius) == 0.0


def test_collision_mode_draws_a_ring_where_each_ball_was() -> None:
    player = Player(Setup(cue=(200.0, 60.0), eight=(220.0, 66.0)))
    player.session.angle, player.session.power = 0.2914567944778671, 0.5
    player.press(pygame.K_s)
    player.press(pygame.K_RETURN)
    player.press(pygame.K_b)
    for _ in range(12):
        player.press(pygame.K_n)
    places = dict(player.pool.marks[0].balls)
    radius = player.app.view.radius
    assert brightened(player, places["eight"], radius) < 0.2
    player.press(pygame.K_c)
    assert brightened(player, places["cue ball"], radius) > 0.5
    assert brightened(player, places["eight"], radius) > 0.5


def test_the_pocket_that_a_ball_would_reach_has_a_ring() -> None:
    player = Player(DANGER)
    near = pockets(player.pool.world)
    pocket = next(arc.center for arc in near if arc.center[0] > 200.0 and arc.center[1] > 100.0)
    others = [arc.center for arc in near if arc.center != pocket]
    for place, towards in ((DANGER, (254.0, 127.0)), (EASY, EASY.eight)):
        player.pool.place(place)
        player.session.power = 0.3
        player.point(towards)
        assert brightened(player, pocket, 5.2 * SCALE) > 0.6
        assert max(brightened(player, other, 5.2 * SCALE) for other in others) < 0.2


def test_step_mode_draws_an_arrow_where_a_ball_goes() -> None:
    player = Player()
    player.session.angle, player.session.power = pi / 2.0, 0.4
    player.press(pygame.K_RETURN)
    player.frames(3)
    x, y = player.pool.cue.position
    ahead = (x, y + player.pool.cue.radius + 0.1 * player.pool.cue.velocity[1])
    assert brightened(player, ahead, 1.0) == 0.0
    player.press(pygame.K_s)
    assert brightened(player, ahead, 1.0) > 0.2


def test_an_arrow_ends_at_the_cushion_that_a_ball_goes_to() -> None:
    player = Player()
    player.session.angle, player.session.power = pi / 2.0, 1.0
    player.press(pygame.K_RETURN)
    x, y = player.pool.cue.position
    layout = player.app.view.layout
    beyond = (x, layout.height + 3.0)
    assert y + ARROW * player.pool.cue.velocity[1] > beyond[1] + 10.0
    player.press(pygame.K_s)
    assert brightened(player, beyond, 2.0) == 0.0
    assert brightened(player, (x, layout.height - 5.0), 1.0) > 0.2


# -- events ----------------------------------------------------------------------------------------------------------


def test_the_right_button_puts_the_cue_down_and_others_do_nothing() -> None:
    player = Player()
    player.mouse(pygame.MOUSEBUTTONDOWN, button=1, pos=(0, 0))
    player.frames(20)
    player.mouse(pygame.MOUSEBUTTONDOWN, button=3, pos=(0, 0))
    player.mouse(pygame.MOUSEBUTTONUP, button=3, pos=(0, 0))
    player.mouse(pygame.MOUSEBUTTONUP, button=1, pos=(0, 0))
    player.mouse(pygame.MOUSEBUTTONDOWN, button=2, pos=(0, 0))
    assert player.pool.shots == 0


def test_a_controller_aims_and_shoots() -> None:
    player = Player()
    angle = player.session.angle
    player.mouse(pygame.JOYHATMOTION, instance_id=0, hat=0, value=(-1, 0))
    player.mouse(pygame.JOYHATMOTION, instance_id=0, hat=0, value=(0, 0))
    assert player.session.angle > angle
    player.mouse(pygame.JOYBUTTONDOWN, instance_id=0, button=0)
    player.frames(20)
    player.mouse(pygame.JOYBUTTONUP, instance_id=0, button=0)
    assert player.pool.phase is Phase.ROLL


def test_escape_closes_the_window() -> None:
    player = Player()
    player.press(pygame.K_ESCAPE)
    assert not player.app.running
    player.app.running = True
    assert player.session.running


def test_without_a_sound_card_one_line_says_so_and_the_game_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "no such card")
    player = Player(EASY)
    player.press(pygame.K_RETURN)
    player.frames(3)
    assert len(player.told) == 1
    assert player.told[0].startswith("no sound: ")
    assert player.pool.phase is Phase.ROLL


def test_sound_can_be_switched_off() -> None:
    player = Player()
    player.press(pygame.K_m)
    assert player.app.speaker.muted
    player.press(pygame.K_m)
    assert not player.app.speaker.muted


def test_a_sitting_ends_after_its_seconds() -> None:
    meter = run(tell=lambda line: None, seconds=0.05)
    assert meter.frames >= 1


def test_the_line_in_the_corner_leaves_the_line_of_keys_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    player = Player(EASY)
    keys = pygame.Rect(36, SIZE[1] - 2 * HIGH - 1, 600, HIGH + 1)
    monkeypatch.setattr(player.window, "_kept_left", 0.0)
    without = pygame.surfarray.array3d(player.window.surface.subsurface(keys))
    player.window._kept, player.window._kept_left = "screenshot kept as " + 60 * "x", 1.0
    player.frames(1)
    assert np.array_equal(pygame.surfarray.array3d(player.window.surface.subsurface(keys)), without)
    below = player.window.surface.get_at((3, SIZE[1] - HIGH + 1))[:3]
    assert below == PLATE
