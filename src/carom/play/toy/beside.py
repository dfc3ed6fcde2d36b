"""Two tables side by side: which is which, and how many balls each has lost."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

import pygame

from carom.play.letters import Colour
from carom.play.pen import Pen
from carom.play.toy import colours
from carom.play.toy.view import View
from carom.play.toy.words import short

#: The colour of each detection, and what it does.
LOOKS: dict[str, tuple[Colour, str]] = {
    "discrete": (colours.WARM, "moves the balls, then looks for overlaps"),
    "continuous": (colours.GOOD, "finds the times of impacts"),
}
#: Pixels: above the tables, and between them.
HEAD, GAP = 70, 10
#: Seconds of the curves of lost balls, at least and at most, and between two points of them.
LEAST_SPAN, MOST_SPAN, PAUSE = 10.0, 60.0, 0.25
#: Lost balls that the curves have room for, at least.
LEAST_COUNT = 4
TRY = "Both tables are given the same launches. Try few motion iterations and fast balls, then launch n."
WAIT = "Both tables stand still until their step is compiled, once on this machine: about a minute."


def areas(area: pygame.Rect) -> list[pygame.Rect]:
    """Where the two tables are."""
    width = (area.width - GAP) // 2
    height = width * 25 // 33
    return [pygame.Rect(area.left + place * (width + GAP), area.top + HEAD, width, height) for place in range(2)]


class Losses:
    """How many balls each table has lost, over time."""

    def __init__(self) -> None:
        self._time = 0.0
        self._points: deque[tuple[float, tuple[int, ...]]] = deque()

    def wait(self, seconds: float, counts: tuple[int, ...]) -> None:
        """Go on by so much time, after which so many balls are lost."""
        self._time += seconds
        if not self._points or self._time - self._points[-1][0] >= PAUSE:
            self._points.append((self._time, counts))
        while self._points[0][0] < self._time - MOST_SPAN:
            self._points.popleft()

    def draw(self, pen: Pen, area: pygame.Rect, kinds: Sequence[str], *, waits: bool = False) -> None:
        """Draw a curve for each table, and what to look for, or that the tables wait for a compiler."""
        pen.words("Balls lost through walls", area.topleft, 14, colours.TEXT)
        words, ink = (WAIT, colours.WARM) if waits else (TRY, colours.MUTED)
        pen.words(words, (area.left, area.top + 22), 12, ink)
        chart = pygame.Rect(area.left, area.top + 52, area.width - 44, area.height - 74)
        span = max(LEAST_SPAN, self._time - self._points[0][0])
        most = max(LEAST_COUNT, *(max(counts) for _, counts in self._points))
        for part in (0.0, 0.5, 1.0):
            y = chart.bottom - round(part * chart.height)
            pen.line(colours.RULE, (chart.left, y), (chart.right, y))
        pen.words(f"{span:.0f} s ago", (chart.left, chart.bottom + 4), 11, colours.FAINT)
        pen.words("now", (chart.right, chart.bottom + 4), 11, colours.FAINT, anchor="end")
        for place in reversed(range(len(kinds))):
            colour = LOOKS[kinds[place]][0]
            points = [
                (
                    chart.right - (self._time - time) / span * chart.width,
                    chart.bottom - counts[place] / most * chart.height,
                )
                for time, counts in self._points
            ]
            points.append((float(chart.right), points[-1][1]))
            pen.lines(colour, points, 3)
            last = self._points[-1][1][place]
            pen.words(short(last), (chart.right + 10, points[-1][1] - 11), 15, colour)


def draw_captions(pen: Pen, views: Sequence[View], kinds: Sequence[str]) -> None:
    """Draw the name of each detection above its table, and its counts below."""
    for view, kind in zip(views, kinds, strict=True):
        colour, words = LOOKS[kind]
        left, top = view.area.left + 16, view.area.top - HEAD
        pen.words(kind, (left, top + 16), 22, colour)
        pen.words(words, (left, top + 44), 12, colours.MUTED)
        table, rates = view.table, view.figures.rates
        counts = (
            (short(table.launched), "launched", colours.TEXT),
            (short(table.in_play), "in play", colours.TEXT),
            (short(table.strays), "lost through walls", colours.BAD if table.strays else colours.GOOD),
            (short(rates.box_tests), "box tests / s", colours.TEXT),
        )
        for place, (number, label, ink) in enumerate(counts):
            x = left + place * (view.area.width - 16) / len(counts)
            pen.words(number, (x, view.area.bottom + 14), 28, ink)
            pen.words(label, (x, view.area.bottom + 48), 11, colours.MUTED)
