"""The icon of the games' windows: a ball that bounces off a wall, painted by the program."""

from __future__ import annotations

import pygame

#: Pixels: the icon's side; and how many times larger it is painted, so that its edges are smooth.
SIDE, FINER = 64, 4
NIGHT, WALL, TRACK, BALL, SHINE = (18, 21, 26), (108, 178, 255), (112, 119, 130), (255, 207, 107), (255, 244, 214)


def icon() -> pygame.Surface:
    """The icon, its corners transparent."""
    fine = pygame.Surface((SIDE * FINER, SIDE * FINER), pygame.SRCALPHA)

    def at(*sides: float) -> list[int]:
        return [round(FINER * side) for side in sides]

    pygame.draw.rect(fine, NIGHT, fine.get_rect(), border_radius=14 * FINER)
    pygame.draw.line(fine, WALL, at(8, 53), at(56, 53), 5 * FINER)
    pygame.draw.lines(fine, TRACK, False, [at(9, 14), at(26, 40), at(43, 20)], 3 * FINER)
    pygame.draw.circle(fine, BALL, at(43, 20), 11 * FINER)
    pygame.draw.circle(fine, SHINE, at(39, 16), 3 * FINER)
    return pygame.transform.smoothscale(fine, (SIDE, SIDE))
