"""The help that lies over the table."""

from __future__ import annotations

import pygame

from carom.play.letters import Letters
from carom.play.toy import colours
from carom.play.toy.keys import HELP

#: Pixels: of the sheet, its columns, and from line to line.
WIDTH, HEIGHT, COLUMN, KEYS, LINE = 760, 600, 370, 92, 24
LARGE, SMALL = 22, 13
#: Which of the groups stand in the left column.
LEFT = 3


def draw_help(surface: pygame.Surface, letters: Letters, area: pygame.Rect) -> None:
    """Darken what is there and draw a sheet with all keys."""
    veil = pygame.Surface(area.size, pygame.SRCALPHA)
    veil.fill((*colours.PAPER, 190))
    surface.blit(veil, area)
    sheet = pygame.Rect(0, 0, WIDTH, HEIGHT)
    sheet.center = area.center
    pygame.draw.rect(surface, colours.RAISED, sheet, border_radius=10)
    pygame.draw.rect(surface, colours.RULE, sheet, 1, border_radius=10)
    left, top = sheet.left + 32, sheet.top + 26
    letters.draw(surface, "Collision Math Toy", (left, top), LARGE, colours.TEXT)
    for column, groups in enumerate((HELP[:LEFT], HELP[LEFT:])):
        y = top + 46
        for heading, lines in groups:
            letters.draw(surface, heading, (left + column * COLUMN, y), SMALL, colours.ACCENT)
            y += LINE
            for key, words in lines:
                letters.draw(surface, key, (left + column * COLUMN, y), SMALL, colours.TEXT)
                letters.draw(surface, words, (left + column * COLUMN + KEYS, y), SMALL, colours.MUTED)
                y += LINE - 4
            y += 12
