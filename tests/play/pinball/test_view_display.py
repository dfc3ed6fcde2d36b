"""What the display of dots and the signs beside it tell."""

from types import SimpleNamespace
from typing import Any

import pygame

from carom.play.letters import Letters
from carom.play.pinball import Event, EventKind, HighScores, LampState, Ledger, Phase
from carom.play.pinball.rules import lamps
from carom.play.pinball.screen import dots
from carom.play.pinball.screen.display import Display, page_of
from carom.play.pinball.screen.dots import Bar, Dots, Line, Page
from carom.play.pinball.screen.effects import Effects


def at(surface: pygame.Surface, place: tuple[float, float]) -> int:
    """The sum of the colours at a pixel."""
    return sum(surface.get_at((int(place[0]), int(place[1])))[:3])


def told(**changes: Any) -> Any:
    """What the display reads of a game, in play, with some changes."""
    state = {
        "phase": Phase.PLAY,
        "score": 12_345,
        "ball_number": 2,
        "message": "BALL 2",
        "goal": "ORBITS 8,000 30 S",
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


# -- the display -------------------------------------------------------------------------------------------------------


def test_the_display_says_what_the_game_is_about() -> None:
    assert words(page_of(told(), 0.0)) == ["12,345", "ORBITS 8,000 30 S"]
    assert words(page_of(told(balls_in_play=0), 0.0)) == ["12,345", "BALL 2", "1,200 x 3"]
    assert words(page_of(told(balls_in_play=0, bonus=0), 0.0)) == ["12,345", "BALL 2"]
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
    assert [words(page_of(told(phase=Phase.ENTRY), seconds))[2] for seconds in (0.0, 1.6, 3.1)] == [
        "FLIPPERS CHOOSE",
        "SPACE TAKES",
        "OR TYPE THEM",
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
