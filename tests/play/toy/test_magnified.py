"""The toy in large windows: the picture is drawn larger, shows the same, and is handled in the same places."""

import pygame
import pytest

from carom.play.toy.sentences import SENTENCES
from carom.play.toy.settings import SHOWN
from tests.play.screens import different
from tests.play.toy.playing import Player

#: The part of the blocks that may differ where there are few words, and where there are many: the widths of letters are
#: whole pixels at each size, so long lines shift.
FEW_SHIFTED, MOST_SHIFTED = 0.012, 0.05


def enlarge(player: Player, times: int) -> None:
    """Make the window so many times as large, and go on by no time."""
    pygame.display.set_mode((1280 * times, 800 * times), pygame.RESIZABLE)
    player.window.frame(0.0)
    player.window.frame(0.0)


def shown(player: Player) -> pygame.Surface:
    """What is in the window, in half the size of the smallest one."""
    return pygame.transform.smoothscale(player.window.surface, (640, 400))


def check(player: Player, times: int, most: float) -> None:
    """Fail unless the picture shows the same in a window so many times as large, and in one of the old size again."""
    enlarge(player, 1)
    small = shown(player)
    enlarge(player, times)
    assert player.window.surface.get_size() == player.toy.size == (1280 * times, 800 * times)
    assert different(shown(player), small) <= most
    enlarge(player, 1)
    assert different(shown(player), small) == 0.0


@pytest.mark.slow
@pytest.mark.parametrize("times", [2, 3])
def test_a_magnified_picture_shows_the_same(player: Player, times: int) -> None:
    player.point((20.0, 17.0))
    check(player, times, FEW_SHIFTED)
    for name in SHOWN:
        player.desk.change(name, True)
    check(player, times, FEW_SHIFTED)
    player.point((15.4, 13.0))
    player.key(pygame.K_F1)
    check(player, times, MOST_SHIFTED)
    player.key(pygame.K_F1)
    player.click(("detection", "both"))
    check(player, times, FEW_SHIFTED)


def test_controls_of_a_magnified_panel_are_where_they_are_seen(player: Player) -> None:
    places = player.toy.panel.places
    enlarge(player, 2)
    for name, rect in player.toy.panel.places.items():
        assert tuple(rect) == pytest.approx(tuple(places[name]), abs=1.0), name
    player.click("boxes")
    assert player.desk.is_on("boxes")
    player.click(("broad_phase", "quadtree"))
    assert player.desk.settings.broad_phase == "quadtree"
    before = player.desk.settings.gravity
    player.slide("gravity", 30)
    assert player.desk.settings.gravity > before + 2.0
    player.mouse(pygame.MOUSEMOTION, player.toy.panel.places["launch"].center)
    assert player.toy.panel.sentence(player.toy._mouse) == SENTENCES["launch"]


def test_a_ball_is_thrown_and_a_shape_dragged_in_a_magnified_picture(player: Player) -> None:
    enlarge(player, 2)
    view = player.toy.views[0]
    ball = player.world.balls[0]
    player.mouse(pygame.MOUSEBUTTONDOWN, view.pixel(ball.position))
    assert player.desk.hand.ball is not None
    x, y = ball.position
    player.mouse(pygame.MOUSEMOTION, view.pixel((x + 2.0, y + 1.0)))
    assert player.desk.hand.target == pytest.approx((x + 2.0, y + 1.0), abs=0.06)
    player.mouse(pygame.MOUSEBUTTONUP, view.pixel((x + 2.0, y + 1.0)))
    assert ball.velocity[0] > 1.0
    player.click("editing")
    post = next(shape for shape in player.world.shapes if shape.name == "bumper")
    x, y = post.position
    player.mouse(pygame.MOUSEBUTTONDOWN, view.pixel((x, y)))
    player.mouse(pygame.MOUSEMOTION, view.pixel((x + 1.0, y)))
    player.mouse(pygame.MOUSEBUTTONUP, view.pixel((x + 1.0, y)))
    assert post.position == pytest.approx((x + 1.0, y), abs=0.06)
