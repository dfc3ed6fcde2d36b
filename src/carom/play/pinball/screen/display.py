"""What the back of the table tells: the score on a display of dots, signs that light, the high scores."""

from __future__ import annotations

import pygame

from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.pinball.art import back as art_back
from carom.play.pinball.art.paint import CORAL, CREAM, GOLD, NIGHT, TEAL, Colour, mixed
from carom.play.pinball.rules.controls import Phase
from carom.play.pinball.rules.game import BALLS, Pinball
from carom.play.pinball.rules.lamps import LampState
from carom.play.pinball.screen.dots import Bar, Dots, Line, Page, largest, wrapped
from carom.play.pinball.screen.effects import Effects, News

#: Seconds that a page of the demonstration stays, those of a hint, and those of half a blink.
PAGE_TIME, HINT_TIME, BLINK_TIME = 3.0, 1.5, 0.25
#: What is shown before any news.
URGENT = {"WARNING", "TILT"}
#: How many times a second the bulbs round the painting change, and in a show of lamps.
CHASE, CHASE_OF_SHOW = 3.0, 14.0
#: High scores on one page.
PER_PAGE = 3
# Shift is not named here: Windows takes five presses of it for the wish for sticky keys.
KEYS = "Left, Right: flippers    Space: plunger    A W D: nudge    F1: help"


def page_of(game: Pinball, seconds: float, news: News | None = None) -> Page:
    """What the dots show: `seconds` is the time of blinking and of the pages' order, `news` is what is announced."""
    lit = int(seconds / BLINK_TIME) % 2 == 0
    if game.phase is Phase.ATTRACT:
        return _demonstration(game, seconds, lit)
    if game.phase is Phase.ENTRY:
        return _entry(game, seconds)
    if game.phase is Phase.BONUS:
        return Page(
            (
                Line("BONUS", 1, light=0.7),
                Line(f"{game.bonus:,} x {game.multiplier}", 11, 2 if game.bonus < 100_000 else 1),
                Line(f"{game.score:,}", 28, light=0.8),
            )
        )
    if game.phase is Phase.OVER:
        return Page((Line("GAME OVER", 2, 2), Line(f"{game.score:,}", 21, 2)))
    if news is not None and game.message not in URGENT:
        return _news(news, lit)
    if game.message == f"BALL {game.ball_number}":
        return _score(game, lit)
    return _notice(game, lit)


def _score(game: Pinball, lit: bool) -> Page:
    """The score, large, and below it what to shoot; while a ball waits ball and bonus, and what to do."""
    words = f"{game.score:,}"
    size = largest(words)
    lines = [Line(words, 2 if size == 3 else 6, size)]
    if game.plunger_pull > 0.0 and game.ledger.held:
        return Page(tuple(lines), (Bar(29, 6, game.plunger_pull),))
    if game.balls_in_play:
        return Page((*lines, Line(game.goal, 28, 1, 0.8)))
    lines.append(Line(f"BALL {game.ball_number}", 28, 1, 0.7, "start"))
    if game.ledger.held and not game.balls_in_play:
        lines.append(Line("HOLD SPACE", 28, 1, 1.0 if lit else 0.4, "end"))
    elif game.bonus:
        lines.append(Line(f"{game.bonus:,} x {game.multiplier}", 28, 1, 0.7, "end"))
    return Page(tuple(lines))


def _news(news: News, lit: bool) -> Page:
    """What is announced, and its points."""
    points = f"{news.points:,}" if news.points else ""
    size = largest(news.words, 2)
    return Page((Line(news.words, 10 - 4 * size if points else 10, size), Line(points, 20, 2, 1.0 if lit else 0.6)))


def _notice(game: Pinball, lit: bool) -> Page:
    """A message, as large as fits, and the score below it."""
    lines = wrapped(game.message)[:3]
    score = Line(f"{game.score:,}", 28, 1, 0.7)
    if len(lines) == 1:
        size = largest(lines[0])
        return Page((Line(lines[0], 13 - 4 * size, size, 1.0 if lit else 0.75), score))
    return Page((*(Line(words, 2 + 9 * place, 1, 1.0 if lit else 0.75) for place, words in enumerate(lines)), score))


def _entry(game: Pinball, seconds: float) -> Page:
    """The initials that are being chosen, the one in turn blinking, and what to press."""
    lit = int(seconds / BLINK_TIME) % 2 == 0
    hints = ("FLIPPERS CHOOSE", "SPACE TAKES", "OR TYPE THEM")
    hint = hints[int(seconds / HINT_TIME) % len(hints)]
    shown = "".join(letter if place != game.initial_place or lit else "_" for place, letter in enumerate(game.initials))
    return Page(
        (
            Line("HIGH SCORE", 0),
            Line(" ".join(shown), 9, 2),
            Line(hint, 27, 1, 0.7),
        )
    )


def _demonstration(game: Pinball, seconds: float, lit: bool) -> Page:
    """The pages of the demonstration, one after the other."""
    scores = game.high_scores.scores
    pages = [
        Page((Line("CAROM", 1, 2), Line("COMET", 19, 2))),
        Page((Line("PRESS", 1, 2, 1.0 if lit else 0.5), Line("SPACE", 19, 2, 1.0 if lit else 0.5))),
    ]
    for begin in range(0, min(len(scores), 2 * PER_PAGE), PER_PAGE):
        lines = [Line("HIGH SCORES", 0, 1, 0.7)]
        for place, entry in enumerate(scores[begin : begin + PER_PAGE]):
            lines.append(Line(f"{begin + place + 1} {entry.initials}", 10 + 9 * place, 1, 1.0, "start"))
            lines.append(Line(f"{entry.score:,}", 10 + 9 * place, 1, 1.0, "end"))
        pages.append(Page(tuple(lines)))
    return pages[int(seconds / PAGE_TIME) % len(pages)]


class Display:
    """Draws the back of the table beside it."""

    def __init__(self, letters: Letters, times: int = 1) -> None:
        self._letters = letters
        self._times = times
        self._backs = art_back.paint_backs(times)
        self._dots = Dots((26, 12, 10), (255, 146, 40), times)

    def draw(self, surface: pygame.Surface, left: int, game: Pinball, effects: Effects) -> None:
        """Draw the back from the column `left` of a surface on, counted as if it were not magnified."""
        pen = Pen(surface, self._letters, self._times)
        seconds, news = effects.time, effects.news
        chase = CHASE if effects.show is None else CHASE_OF_SHOW
        surface.blit(self._backs[int(seconds * chase) % len(self._backs)], pen.at((left, 0)))
        surface.blit(self._dots.picture(page_of(game, seconds, news)), pen.area(art_back.DISPLAY.move(left, 0)))
        self._signs(pen, left, game, seconds)
        self._scores(pen, left, game)
        pen.words(KEYS, (left + 192, 804), 11, mixed(CREAM, NIGHT, 0.25), anchor="middle")

    def _signs(self, pen: Pen, left: int, game: Pinball, seconds: float) -> None:
        """Draw the signs: which ball, the ball save, multiball, tilt."""
        lit = int(seconds / BLINK_TIME) % 2 == 0
        playing = game.phase in (Phase.PLAY, Phase.BONUS)
        top = art_back.SIGNS.top + 8
        x = left + art_back.SIGNS.left + 8
        for number in range(1, BALLS + 1):
            on = playing and number == game.ball_number
            self._sign(pen, str(number), pygame.Rect(x, top, 28, 28), GOLD if on else None, GOLD)
            x += 34
        signs: tuple[tuple[str, int, Colour, bool], ...] = (
            ("BALL SAVE", 84, TEAL, playing and game.saver > 0.0 and (lit or game.saver > 4.0)),
            ("MULTIBALL", 84, CORAL, playing and game.lamps["multiball"] is LampState.ON and lit),
            ("TILT", 54, CORAL, game.tilted),
        )
        for words, wide, colour, on in signs:
            self._sign(pen, words, pygame.Rect(x, top, wide, 28), colour if on else None, colour)
            x += wide + 7

    def _sign(self, pen: Pen, words: str, rect: pygame.Rect, light: Colour | None, hue: Colour) -> None:
        """Draw a sign, lit in a colour or dark."""
        if light is None:
            pen.rect(mixed(hue, NIGHT, 0.72), rect, 1, radius=5)
        else:
            pen.rect(light, rect, radius=5)
        ink = NIGHT if light is not None else mixed(hue, NIGHT, 0.45)
        pen.words(words, (rect.centerx, rect.centery - 7), 13, ink, anchor="middle")

    def _scores(self, pen: Pen, left: int, game: Pinball) -> None:
        """Draw the ten high scores in two columns."""
        area = art_back.SCORES
        write = pen.words
        write("HIGH SCORES", (left + area.centerx, area.top + 10), 17, GOLD, anchor="middle")
        for place, entry in enumerate(game.high_scores.scores):
            column, row = divmod(place, 5)
            x, y = left + area.left + 14 + column * 176, area.top + 42 + row * 29
            ink = (CORAL, GOLD, TEAL)[place] if place < 3 else CREAM
            write(f"{place + 1}", (x + 16, y + 1), 14, mixed(ink, NIGHT, 0.35), anchor="end")
            write(entry.initials, (x + 26, y), 16, ink)
            write(f"{entry.score:,}", (x + 158, y), 16, ink, anchor="end")
