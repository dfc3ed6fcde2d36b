"""What is seen of a game: lamps, parts that move, flashes, the display of dots."""

import pygame
import pytest

from carom.play.letters import Letters
from carom.play.pinball import Control, Event, EventKind, HighScores, LampState, Pinball
from carom.play.pinball.art import pictures as art
from carom.play.pinball.screen.effects import KICK, NEWS, POINTS, SHAKE, SHOW, SPARK, Effects, announced
from carom.play.pinball.screen.view import TableView


def begun() -> Pinball:
    """A game in which a ball lies on the plunger."""
    game = Pinball(HighScores(), seed=1)
    game.press(Control.START, True)
    game.tick()
    game.take_events()
    return game


def drawn(view: TableView) -> pygame.Surface:
    """The table as it is drawn now."""
    surface = pygame.Surface(art.SIZE, 0, 32)
    view.draw(surface)
    return surface


def at(surface: pygame.Surface, place: tuple[float, float]) -> int:
    """The sum of the colours at a pixel."""
    return sum(surface.get_at((int(place[0]), int(place[1])))[:3])


def level(surface: pygame.Surface, area: pygame.Rect) -> int:
    """The sum of the mean colours of an area."""
    return sum(pygame.transform.average_color(surface, area)[:3])


# -- the table ---------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_lamps_that_burn_are_brighter_and_those_that_blink_now_and_then() -> None:
    game = begun()
    view = TableView(game, Letters())
    game.lamps.put_out()
    spots = {
        name: view.art.lights[name].lens.get_rect(topleft=view.art.lights[name].lens_at).inflate(-8, -8)
        for name in ("2x", "3x", "left inlane")
    }
    dark = drawn(view)
    game.lamps.put(LampState.ON, "2x")
    game.lamps.put(LampState.BLINK, "3x")
    seen = []
    for _ in range(2):
        lit = drawn(view)
        assert level(lit, spots["2x"]) > level(dark, spots["2x"]) + 60
        assert level(lit, spots["left inlane"]) == level(dark, spots["left inlane"])
        seen.append(level(lit, spots["3x"]) > level(dark, spots["3x"]) + 60)
        view.effects.advance(0.17)
    assert seen == [True, False]


@pytest.mark.slow
def test_a_bumper_flashes_when_it_kicks_and_a_slingshot_too() -> None:
    game = begun()
    view = TableView(game, Letters())
    before = drawn(view)
    view.effects.note([Event(EventKind.BUMPER, "low bumper"), Event(EventKind.SLINGSHOT, "left slingshot's band")])
    kicked = drawn(view)
    for place in (view.art.bumper_places["low bumper"], view.art.kickers["left slingshot's band"]):
        beside = (place[0] + 34.0, place[1])
        assert at(kicked, beside) > at(before, beside)
    view.effects.advance(KICK + 0.01)
    assert pygame.image.tobytes(drawn(view), "RGB") == pygame.image.tobytes(before, "RGB")


@pytest.mark.slow
def test_flippers_targets_and_plunger_are_seen_where_they_are() -> None:
    game = begun()
    view = TableView(game, Letters())
    before = drawn(view)
    game.table.lower("drop target 2")
    game.plunger_pull = 1.0
    for _ in range(4):
        game.press(Control.LEFT, True)
        game.tick()
    moved = drawn(view)
    x, y = view.art.targets["drop target 2"][2]
    assert at(moved, (x + 10, y + 12)) < at(before, (x + 10, y + 12))
    around = pygame.Rect(80, 600, 110, 110)
    assert pygame.image.tobytes(moved.subsurface(around), "RGB") != pygame.image.tobytes(
        before.subsurface(around), "RGB"
    )
    tip = art.pixel((19.3, 0.5))
    assert at(before, tip) != at(moved, tip)


@pytest.mark.slow
def test_balls_that_wait_are_seen_behind_the_aprons_window() -> None:
    game = begun()
    view = TableView(game, Letters())
    window = pygame.Rect(250, 745, 110, 50)
    pictures = set()
    for number in (1, 2, 3):
        game.ball_number = number
        pictures.add(pygame.image.tobytes(drawn(view).subsurface(window), "RGB"))
    assert len(pictures) == 3


@pytest.mark.slow
def test_hard_impacts_spark_and_points_float_upward() -> None:
    game = begun()
    view = TableView(game, Letters())
    before = drawn(view)
    view.effects.note([Event(EventKind.TARGET, "left target", (9.3, 21.5), 60.0, 1_000)])
    place = art.pixel((9.3, 21.5))
    assert at(drawn(view), place) > at(before, place) + 100
    above = pygame.Rect(0, 0, 60, 26)
    above.center = (int(place[0]), int(place[1]) - 38)
    view.effects.advance(0.4)
    floating = drawn(view)
    assert at(floating, place) == at(before, place), "the spark is out"
    assert level(floating, above) > level(before, above)
    view.effects.advance(0.5)
    assert pygame.image.tobytes(drawn(view).subsurface(above), "RGB") == pygame.image.tobytes(
        before.subsurface(above), "RGB"
    )


@pytest.mark.slow
def test_a_fast_ball_has_a_tail() -> None:
    game = begun()
    view = TableView(game, Letters())
    (ball,) = game.world.balls
    ball.position = (5.0, 20.0)
    ball.velocity = (0.0, 0.0)
    drawn(view)
    ball.position = (5.0, 22.0)
    slow = drawn(view)
    view.draw(slow)
    ball.position = (5.0, 20.0)
    drawn(view)
    ball.position, ball.velocity = (5.0, 22.0), (0.0, 60.0)
    fast = drawn(view)
    behind = art.pixel((5.0, 21.1))
    assert at(fast, behind) > at(slow, behind) + 20


# -- effects -----------------------------------------------------------------------------------------------------------


def test_effects_last_for_their_time_and_no_longer() -> None:
    effects = Effects()
    effects.note(
        [
            Event(EventKind.TARGET, "left target", (3.0, 4.0), 40.0, 1_000),
            Event(EventKind.BOUNCE, "dome", (3.0, 4.0), 3.0),
            Event(EventKind.MULTIBALL),
            Event(EventKind.NUDGE, "nudge left"),
        ]
    )
    assert len(effects.sparks) == 1
    assert [spark.words for spark in effects.points] == ["1,000"]
    assert effects.show == 0.0
    assert effects.shift[0] < 0
    for seconds, over in ((SPARK, "sparks"), (SHAKE, "shift"), (POINTS, "points"), (SHOW, "show")):
        effects.advance(seconds + 0.01)
        assert not any(getattr(effects, over) or ()), over


@pytest.mark.parametrize(
    ("event", "words"),
    [
        (Event(EventKind.LANE, "left lane", score=10_000), "SKILL SHOT"),
        (Event(EventKind.LANE, "left lane", score=500), ""),
        (Event(EventKind.BANK, "jackpot", score=50_000), "JACKPOT"),
        (Event(EventKind.ORBIT, "left orbit", score=25_000), "JACKPOT"),
        (Event(EventKind.ORBIT, "left orbit", score=2_500), "ORBIT"),
        (Event(EventKind.BUMPER, "left bumper", score=100), ""),
    ],
    ids=["skill shot", "lane", "jackpot", "orbit's jackpot", "orbit", "bumper"],
)
def test_feats_are_announced(event: Event, words: str) -> None:
    assert announced(event) == words
    effects = Effects()
    effects.note([event])
    assert (effects.news.words if effects.news else "") == words
    effects.advance(NEWS + 0.01)
    assert effects.news is None


@pytest.mark.slow
def test_a_show_of_lamps_runs_over_the_table() -> None:
    game = begun()
    view = TableView(game, Letters())
    view.effects.note([Event(EventKind.BANK)])
    pictures = set()
    for _ in range(4):
        pictures.add(pygame.image.tobytes(drawn(view), "RGB"))
        view.effects.advance(0.07)
    assert len(pictures) == 4
