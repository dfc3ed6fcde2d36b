"""What is seen of a game: lamps, parts that move, flashes, the display of dots."""

from types import SimpleNamespace
from typing import Any

import pygame
import pytest

from carom.play.letters import Letters
from carom.play.pinball import (
    Control,
    Event,
    EventKind,
    HighScores,
    LampState,
    Ledger,
    Phase,
    Pinball,
    art,
    dots,
    lamps,
)
from carom.play.pinball.display import Display, page_of
from carom.play.pinball.dots import Bar, Dots, Line, Page
from carom.play.pinball.effects import KICK, NEWS, POINTS, SHAKE, SHOW, SPARK, Effects, announced
from carom.play.pinball.view import TableView


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


def told(**changes: Any) -> Any:
    """What the display reads of a game, in play, with some changes."""
    state = {
        "phase": Phase.PLAY,
        "score": 12_345,
        "ball_number": 2,
        "message": "BALL 2",
        "bonus": 1_200,
        "multiplier": 3,
        "plunger_pull": 0.0,
        "ledger": Ledger(created=1, in_play=1),
        "balls_in_play": 1,
        "saver": 0.0,
        "tilted": False,
        "lamps": dict.fromkeys(lamps.NAMES, LampState.OFF),
        "initials": "ABC",
        "initial_place": 1,
        "high_scores": HighScores(),
    }
    return SimpleNamespace(**{**state, **changes})


def words(page: Page) -> list[str]:
    """The words of a page."""
    return [line.words for line in page.lines]


# -- the table ---------------------------------------------------------------------------------------------------------


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


def test_a_bumper_flashes_when_it_kicks_and_a_slingshot_too() -> None:
    game = begun()
    view = TableView(game, Letters())
    before = drawn(view)
    view.effects.note([Event(EventKind.BUMPER, "low bumper"), Event(EventKind.SLINGSHOT, "left slingshot's band")])
    kicked = drawn(view)
    for place in (view.art.bumper_places["low bumper"], view.art.slingshots["left slingshot's band"]):
        beside = (place[0] + 34.0, place[1])
        assert at(kicked, beside) > at(before, beside)
    view.effects.advance(KICK + 0.01)
    assert pygame.image.tobytes(drawn(view), "RGB") == pygame.image.tobytes(before, "RGB")


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


def test_balls_that_wait_are_seen_behind_the_aprons_window() -> None:
    game = begun()
    view = TableView(game, Letters())
    window = pygame.Rect(250, 745, 110, 50)
    pictures = set()
    for number in (1, 2, 3):
        game.ball_number = number
        pictures.add(pygame.image.tobytes(drawn(view).subsurface(window), "RGB"))
    assert len(pictures) == 3


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


def test_a_show_of_lamps_runs_over_the_table() -> None:
    game = begun()
    view = TableView(game, Letters())
    view.effects.note([Event(EventKind.BANK)])
    pictures = set()
    for _ in range(4):
        pictures.add(pygame.image.tobytes(drawn(view), "RGB"))
        view.effects.advance(0.07)
    assert len(pictures) == 4


# -- the display -------------------------------------------------------------------------------------------------------


def test_the_display_says_what_the_game_is_about() -> None:
    assert words(page_of(told(), 0.0)) == ["12,345", "BALL 2", "1,200 x 3"]
    assert words(page_of(told(bonus=0), 0.0)) == ["12,345", "BALL 2"]
    waiting = {"ledger": Ledger(created=1, held=1), "balls_in_play": 0}
    assert words(page_of(told(**waiting), 0.0))[-1] == "HOLD SPACE"
    assert page_of(told(plunger_pull=0.5, **waiting), 0.0).bars == (Bar(29, 6, 0.5),)
    assert page_of(told(plunger_pull=0.5), 0.0).bars == (), "there is no ball to shoot"
    assert words(page_of(told(message="BALL SAVED"), 0.0)) == ["BALL SAVED", "12,345"]
    assert words(page_of(told(message="ONE TWO THREE FOUR FIVE SIX SEVEN"), 0.0))[-1] == "12,345"
    assert words(page_of(told(phase=Phase.BONUS), 0.0)) == ["BONUS", "1,200 x 3", "12,345"]
    assert words(page_of(told(phase=Phase.OVER), 0.0)) == ["GAME OVER", "12,345"]
    assert words(page_of(told(phase=Phase.ENTRY), 0.0))[1] == "A B C"
    assert words(page_of(told(phase=Phase.ENTRY), 0.3))[1] == "A _ C"
    assert [words(page_of(told(phase=Phase.ENTRY), seconds))[2] for seconds in (0.0, 1.6)] == [
        "FLIPPERS CHOOSE",
        "SPACE TAKES",
    ]


def test_news_are_shown_with_their_points_but_a_tilt_goes_first() -> None:
    effects = Effects()
    effects.note([Event(EventKind.BANK, score=10_000)])
    assert words(page_of(told(), 0.0, effects.news)) == ["TARGETS", "10,000"]
    assert words(page_of(told(tilted=True, message="TILT"), 0.0, effects.news)) == ["TILT", "12,345"]
    assert words(page_of(told(message="WARNING"), 0.0, effects.news)) == ["WARNING", "12,345"]
    effects.note([Event(EventKind.EXTRA)])
    assert words(page_of(told(), 0.0, effects.news)) == ["EXTRA BALL", ""]


def test_the_demonstration_shows_name_start_and_high_scores_in_turn() -> None:
    pages = [words(page_of(told(phase=Phase.ATTRACT), seconds)) for seconds in (0.0, 3.1, 6.1, 9.1, 12.1)]
    assert pages[0] == ["CAROM", "COMET"] == pages[4]
    assert pages[1] == ["PRESS", "SPACE"]
    best = HighScores().best
    assert pages[2][1:3] == [f"1 {best.initials}", f"{best.score:,}"]
    assert pages[3][1].startswith("4 ")


def test_signs_light_up() -> None:
    display, effects = Display(Letters()), Effects()
    burning = dict.fromkeys(lamps.NAMES, LampState.ON)
    pictures = []
    for game in (told(), told(saver=9.0, tilted=True, lamps=burning), told(phase=Phase.OVER)):
        surface = pygame.Surface((384, 840), 0, 32)
        display.draw(surface, 0, game, effects)
        pictures.append(surface)
    for x in (130, 230, 325):
        assert at(pictures[1], (x, 541)) > at(pictures[0], (x, 541)) + 200
    assert at(pictures[0], (60, 541)) > at(pictures[2], (60, 541)) + 200


def test_words_are_as_large_as_fits_and_wrapped() -> None:
    assert dots.largest("10") == 3
    assert dots.largest("1,234,567") == 2
    assert dots.largest("A VERY LONG LINE INDEED, TOO LONG") == 1
    assert dots.wrapped("HIGH SCORE  ENTER INITIALS  ABC") == ["HIGH SCORE ENTER", "INITIALS ABC"]
    assert dots.wrapped("") == []
    assert dots.width("A") == 5
    assert dots.width("AB", 2) == 22


def test_a_page_is_made_once_and_lights_its_dots() -> None:
    display = Dots((0, 0, 0), (255, 150, 40))
    page = Page((Line("I", 0, anchor="start"), Line("", 9), Line("é", 30, 2, 0.5, "end")), (Bar(20, 4, 2.0),))
    picture = display.picture(page)
    assert picture.get_size() == (dots.COLUMNS * dots.DOT, dots.ROWS * dots.DOT)
    corner = picture.get_at((0, 0))
    picture.set_at((0, 0), (255, 0, 255))
    assert display.picture(page) is picture
    assert picture.get_at((0, 0))[:3] == (255, 0, 255), "the same page was made anew"
    picture.set_at((0, 0), corner)
    lights = dots.lights_of(page)
    assert lights[1:4, :7].tolist() == [[1, 0, 0, 0, 0, 0, 1], [1] * 7, [1, 0, 0, 0, 0, 0, 1]]
    assert lights[2 : dots.COLUMNS - 2, 20:24].min() == 1.0
    assert lights[-12:, 30:].max() == 0.5
    before = pygame.image.tobytes(picture, "RGB")
    assert pygame.image.tobytes(display.picture(Page((Line("!", 0),))), "RGB") != before
