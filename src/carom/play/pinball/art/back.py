"""The back of the table: a city under a comet, the name in neon, and the frames round score, signs and high scores."""

from __future__ import annotations

from math import pi

import numpy as np
import pygame

import carom
from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.pinball.art import sprites as art_sprites
from carom.play.pinball.art.ground import sky
from carom.play.pinball.art.paint import (
    CORAL,
    CREAM,
    GOLD,
    INDIGO,
    NIGHT,
    TEAL,
    VIOLET,
    Canvas,
    Colour,
    Spot,
    bow,
    glow,
    mixed,
    star,
)
from carom.play.pinball.art.parts import LACQUER

SIZE = (384, 840)
#: Pixels: the painting, the display's dots, the signs, the high scores.
PAINTING = pygame.Rect(12, 12, 360, 372)
DISPLAY = pygame.Rect(18, 404, 348, 108)
SIGNS = pygame.Rect(12, 528, 360, 44)
SCORES = pygame.Rect(12, 586, 360, 196)
UNIT = 18.0
#: One of so many bulbs is lit at a time.
BULBS = 3
#: The part of the sky that is seen on the painting, in units; the sun rises in the middle of its lower edge.
SCENE = carom.Aabb(-0.7, 4.3, 19.3, 4.3 + 372 / UNIT)

#: The strokes of the letters of the name, in a square of 1; a number more is an arc: centre, radii, from, to.
_C = [bow((0.5, 0.5), 0.5, 0.9, 2.0 * pi - 0.9)]
_O = [bow((0.5, 0.5), 0.5, 0.0, 2.0 * pi)]
_R = [
    [(0.05, 0.0), (0.05, 1.0), (0.58, 1.0), *bow((0.62, 0.72), 0.28, pi / 2.0, -pi / 2.0), (0.05, 0.44)],
    [(0.45, 0.44), (0.92, 0.0)],
]
STROKES: dict[str, list[list[Spot]]] = {
    "A": [[(0.0, 0.0), (0.5, 1.0), (1.0, 0.0)], [(0.18, 0.3), (0.82, 0.3)]],
    "C": _C,
    "E": [[(0.9, 1.0), (0.08, 1.0), (0.08, 0.0), (0.9, 0.0)], [(0.08, 0.56), (0.72, 0.56)]],
    "M": [[(0.0, 0.0), (0.12, 1.0), (0.5, 0.3), (0.88, 1.0), (1.0, 0.0)]],
    "O": _O,
    "R": _R,
    "T": [[(0.0, 1.0), (1.0, 1.0)], [(0.5, 1.0), (0.5, 0.0)]],
}


def paint_backs(times: int = 1) -> tuple[pygame.Surface, ...]:
    """The back with all that never changes, once for each third of the bulbs that is lit, `times` the `SIZE`."""
    back = _back(times)
    return tuple(_bulbs(back.copy(), lit, times) for lit in range(BULBS))


def _bulbs(back: pygame.Surface, lit: int, times: int) -> pygame.Surface:
    """A back with bulbs round its painting, every third of them lit."""
    path = PAINTING.inflate(2, 2)
    wide, high = path.width // 15, path.height // 15
    places = [
        *((path.left + path.width * n / wide, path.top) for n in range(wide)),
        *((path.right, path.top + path.height * n / high) for n in range(high)),
        *((path.right - path.width * n / wide, path.bottom) for n in range(wide)),
        *((path.left, path.bottom - path.height * n / high) for n in range(high)),
    ]
    shine = glow(9 * times, GOLD, 0.9, 1.4)
    for number, (x, y) in enumerate(places):
        on = number % BULBS == lit
        middle = round(x) * times, round(y) * times
        if on:
            back.blit(shine, (middle[0] - 9 * times, middle[1] - 9 * times), special_flags=pygame.BLEND_RGB_ADD)
        pygame.draw.aacircle(back, CREAM if on else mixed(GOLD, NIGHT, 0.55), middle, 3 * times)
    return back


def _back(times: int) -> pygame.Surface:
    """The back without its bulbs."""
    back = pygame.Surface((SIZE[0] * times, SIZE[1] * times), 0, 32)
    back.fill(LACQUER)
    _pattern(back, times)
    canvas = Canvas(SCENE, UNIT * times, sky(SCENE, UNIT * times))
    _heaven(canvas)
    _city(canvas)
    picture = canvas.finished()
    head = art_sprites.ball(31.0 * times)
    light = glow(92 * times, GOLD, 0.8)
    picture.blit(light, ((266 - 92) * times, (176 - 92) * times), special_flags=pygame.BLEND_RGB_ADD)
    picture.blit(head, (266 * times - head.get_width() // 2, 176 * times - head.get_height() // 2))
    _neon(picture, "CAROM", pygame.Rect(34, 26, 292, 58), 15.0, CORAL, times)
    _neon(picture, "COMET", pygame.Rect(92, 104, 176, 30), 13.0, TEAL, times)
    pen = Pen(back, Letters(), times)
    back.blit(picture, pen.area(PAINTING))
    for rect in (PAINTING, DISPLAY.inflate(12, 12), SIGNS, SCORES):
        _frame(pen, rect)
    return back


def _pattern(back: pygame.Surface, times: int) -> None:
    """Cover the lacquer with scales of fans."""
    for row in range(30):
        for column in range(-1, 9):
            center = ((column * 48 + (24 if row % 2 else 0)) * times, row * 30 * times)
            for radius in (24, 17, 10):
                pygame.draw.circle(back, mixed(LACQUER, INDIGO, 0.5), center, radius * times, times, True, True)


def _frame(pen: Pen, rect: pygame.Rect) -> None:
    """Paint a frame of brass, dark inside where it is not the painting."""
    if rect is not PAINTING:
        pen.rect((10, 7, 22), rect, radius=5)
    for grown, colour, width in ((6, mixed(GOLD, NIGHT, 0.6), 5), (4, GOLD, 3), (2, CREAM, 1)):
        pen.rect(colour, rect.inflate(grown, grown), width, radius=6)


def _heaven(canvas: Canvas) -> None:
    """Paint stars, the tail of the comet and the sun."""
    seeded = np.random.default_rng(1682)
    for x, height, size in seeded.random((120, 3)):
        canvas.disc(
            (20.0 * x - 0.7, 25.0 - 13.0 * height**1.3), 0.03 + 0.05 * size**3, (*CREAM, int(100 + 140 * (1 - height)))
        )
    for spot, size in (((1.2, 18.0), 0.5), ((17.9, 19.6), 0.45), ((4.4, 15.4), 0.3), ((16.6, 23.9), 0.3)):
        canvas.light(spot, size * 2.4, CREAM, 0.3)
        canvas.fill(star(spot, size, size * 0.16), CREAM)
    for wide, reach, colour in ((2.0, 1.0, VIOLET), (1.55, 0.93, CORAL), (1.0, 0.86, GOLD), (0.5, 0.78, CREAM)):
        canvas.fill(_tail((14.08, 15.2), wide, reach), (*colour, 215))
    for radius, colour in ((5.2, CORAL), (4.5, NIGHT), (4.3, GOLD), (3.2, mixed(GOLD, CREAM, 0.5))):
        canvas.disc((9.3, 6.3), radius, (*colour, 235))


def _tail(head: Spot, wide: float, reach: float) -> list[Spot]:
    """The outline of a comet's tail behind a head: it bends upward and ends in a point."""
    upper, lower = [], []
    for number in range(25):
        along = number / 24.0
        x, y = head[0] - 13.4 * reach * along, head[1] - 3.0 * reach * along * along - 0.6 * along * (1 - along)
        half = wide * (1.0 - along) ** 0.8 * 0.86
        upper.append((x, y + half))
        lower.append((x, y - half))
    return [*upper, *lower[::-1]]


def _city(canvas: Canvas) -> None:
    """Paint a skyline of towers in two rows, lit windows, and an observatory before the sun."""
    seeded = np.random.default_rng(1930)
    for colour, low, high, step in ((mixed(VIOLET, NIGHT, 0.5), 7.0, 11.6, 1.55), (NIGHT, 5.6, 9.2, 1.75)):
        x = -1.0
        while x < 19.6:
            height = low + (high - low) * float(seeded.random()) * (0.4 + 0.6 * abs(x - 9.3) / 9.0)
            _tower(canvas, x, step * 0.94, height, colour, seeded)
            x += step
    _observatory(canvas, (9.3, 6.3))


def _tower(canvas: Canvas, x: float, wide: float, height: float, colour: Colour, seeded: np.random.Generator) -> None:
    """Paint a tower with steps and a needle, and light some of its windows."""
    middle = x + wide / 2.0
    for share, top in ((1.0, height), (0.66, height + 0.55), (0.34, height + 1.0), (0.06, height + 1.9)):
        half = wide * share / 2.0
        canvas.fill([(middle - half, 4.0), (middle - half, top), (middle + half, top), (middle + half, 4.0)], colour)
    for row in range(int((height - 4.8) / 0.5)):
        for column in range(3):
            if seeded.random() < 0.42:
                spot = (x + wide * (0.22 + 0.28 * column), 4.9 + 0.5 * row)
                warm = (GOLD, CREAM, CORAL)[int(seeded.random() * 3)]
                canvas.fill(
                    [
                        (spot[0] - 0.1, spot[1] - 0.13),
                        (spot[0] - 0.1, spot[1] + 0.13),
                        (spot[0] + 0.1, spot[1] + 0.13),
                        (spot[0] + 0.1, spot[1] - 0.13),
                    ],
                    (*mixed(warm, colour, 0.15), 225),
                )


def _observatory(canvas: Canvas, foot: Spot) -> None:
    """Paint an observatory on its hill, its telescope out."""
    x, y = foot
    canvas.fill([*bow((x, y - 6.4), 6.6, 0.45, pi - 0.45)], NIGHT)
    for half, low, high, colour in ((1.9, -0.4, 0.7, INDIGO), (1.5, 0.7, 1.2, mixed(INDIGO, VIOLET, 0.4))):
        canvas.fill([(x - half, y + low), (x - half, y + high), (x + half, y + high), (x + half, y + low)], colour)
    canvas.stroke([(x + 0.2, y + 1.6), (x + 1.25, y + 3.1)], 0.42, TEAL)
    canvas.stroke([(x + 1.0, y + 2.75), (x + 1.4, y + 3.32)], 0.55, mixed(TEAL, NIGHT, 0.4))
    canvas.fill(bow((x, y + 1.2), 1.4, 0.0, pi), mixed(VIOLET, INDIGO, 0.3))
    canvas.fill([(x, y + 1.2), *bow((x, y + 1.2), 1.42, 0.78, 1.12)], NIGHT)
    canvas.stroke(bow((x, y + 1.2), 1.4, 0.0, pi), 0.09, GOLD)
    for number in range(-2, 3):
        canvas.fill(bow((x + number * 0.66, y + 0.05), 0.2, 0.0, 2.0 * pi, 0.3), GOLD)


def _neon(picture: pygame.Surface, word: str, rect: pygame.Rect, gap: float, colour: Colour, times: int) -> None:
    """Write a word in tubes of neon, which light up what is round them, into a part of the painting."""
    wide = (rect.width - gap * (len(word) - 1)) / len(word)
    size = picture.get_size()
    width, height = PAINTING.size
    canvas = Canvas(carom.Aabb(0.0, 0.0, width, height), times)
    paths = [
        [(rect.left + (wide + gap) * place + x * wide, height - rect.bottom + y * rect.height) for x, y in stroke]
        for place, letter in enumerate(word)
        for stroke in STROKES[letter]
    ]
    tube = rect.height * 0.13
    for path in paths:
        canvas.stroke([(x + 2.0, y - 3.0) for x, y in path], tube, (6, 4, 20, 150))
    for path in paths:
        canvas.stroke(path, tube, colour)
    letters = canvas.finished()
    lit = pygame.Surface(size, 0, 32)
    lit.blit(letters, (0, 0))
    for blur in (16, 8):
        small = pygame.transform.smoothscale(lit, (width // blur, height // blur))
        picture.blit(pygame.transform.smoothscale(small, size), (0, 0), special_flags=pygame.BLEND_RGB_ADD)
    picture.blit(letters, (0, 0))
    bright = Canvas(carom.Aabb(0.0, 0.0, width, height), times)
    for path in paths:
        bright.stroke(path, tube * 0.42, mixed(colour, (255, 255, 255), 0.75))
    picture.blit(bright.finished(), (0, 0))
