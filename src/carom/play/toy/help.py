"""The help that lies over the table."""

from __future__ import annotations

import pygame

from carom.play.pen import Pen
from carom.play.toy import colours
from carom.play.toy.keys import HELP

#: Pixels: of the sheet, its columns, and from line to line.
WIDTH, HEIGHT, COLUMN, KEYS, LINE = 760, 600, 370, 92, 24
LARGE, SMALL = 22, 13
#: Which of the groups stand in the left column.
LEFT = 3


def draw_help(pen: Pen, area: pygame.Rect) -> None:
    """Darken what is there and draw a sheet with all keys."""
    veil = pygame.Surface(pen.area(area).size, pygame.SRCALPHA)
    veil.fill((*colours.PAPER, 190))
    pen.surface.blit(veil, pen.area(area))
    sheet = pygame.Rect(0, 0, WIDTH, HEIGHT)
    sheet.center = area.center
    pen.rect(colours.RAISED, sheet, radius=10)
    pen.rect(colours.RULE, sheet, 1, radius=10)
    left, top = sheet.left + 32, sheet.top + 26
    pen.words("Collision Math Toy", (left, top), LARGE, colours.TEXT)
    for column, groups in enumerate((HELP[:LEFT], HELP[LEFT:])):
        y = top + 46
        for heading, lines in groups:
            pen.words(heading, (left + column * COLUMN, y), SMALL, colours.ACCENT)
            y += LINE
            for key, words in lines:
                pen.words(key, (left + column * COLUMN, y), SMALL, colours.TEXT)
                pen.words(words, (left + column * COLUMN + KEYS, y), SMALL, colours.MUTED)
                y += LINE - 4
            y += 12
