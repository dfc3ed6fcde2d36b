"""The strip below the table: the numbers of what the mouse points at, or what can be done."""

from __future__ import annotations

import pygame

from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.toy import colours
from carom.play.toy.probe import Pairs, Reading

SIDE, SMALL, LARGE = 18, 11, 14
#: Pixels: the widths between numbers, and from a line to the next.
GAP, LINE = 18, 32
#: What is drawn instead of numbers while the table is edited and nothing is pointed at.
EDITING = (
    ("drag a shape", "move it"),
    ("wheel, or , and .", "turn it"),
    ("click beside all, or A", "add one"),
    ("right button, or X", "take it away"),
    ("K", "what is added"),
    ("V", "save the table"),
    ("E", "play on"),
)
HINTS = (
    ("Space", "launch a ball"),
    ("drag a ball", "throw it"),
    ("point at a shape", "read its numbers"),
    ("R", "rotate the blue parts"),
    ("F1", "all keys"),
)


def draw_reading(pen: Pen, area: pygame.Rect, reading: Reading | None, hints: Pairs = HINTS) -> None:
    """Draw numbers, or hints where there are none."""
    pen.fill(colours.PAPER, area)
    x, y = float(area.left + SIDE), area.top + 8
    title, pairs = ("", hints) if reading is None else (reading.title, reading.pairs)
    if title:
        pen.words(title, (x, y), LARGE, colours.ACCENT)
        y += 22
    else:
        y += 18
    for label, number in pairs:
        width = max(pen.width(label, SMALL), pen.width(number, LARGE - 2))
        if x + width > area.right - SIDE:
            x, y = area.left + SIDE, y + LINE
        pen.words(label, (x, y), SMALL, colours.FAINT)
        pen.words(number, (x, y + 13), LARGE - 2, colours.TEXT)
        x += width + GAP


def draw_sentence(pen: Pen, area: pygame.Rect, words: str) -> None:
    """Draw a sentence in as few lines as hold it."""
    pen.fill(colours.PAPER, area)
    for number, line in enumerate(wrapped(pen.letters, words, area.width - 2 * SIDE)):
        pen.words(line, (area.left + SIDE, area.top + 16 + 22 * number), LARGE, colours.TEXT)


def wrapped(letters: Letters, words: str, width: int) -> list[str]:
    """Words in lines of at most so many pixels."""
    lines: list[str] = []
    for word in words.split():
        if lines and letters.width(f"{lines[-1]} {word}", LARGE) <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines
