"""The balls: shaded spheres that roll, drawn anew for each place between the pixels that they come to rest on."""

from __future__ import annotations

from functools import lru_cache, partial
from itertools import pairwise
from math import cos, floor, hypot, sin
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.play.pool.game import Vector
from carom.play.pool.sprites import surface_of

if TYPE_CHECKING:
    import pygame

Field: TypeAlias = NDArray[np.float64]

#: Samples along each side of a pixel, and of one of a ball whose radius is more than `LARGE` pixels.
FINER, FEWER, LARGE = 3, 2, 16.0

#: Places within a pixel, along each axis, that a ball's centre is rounded to.
PLACES = 4

#: Towards the lamp: x to the right, y up, z out of the screen.
LAMP = np.array((-0.36, 0.48, 0.80))

#: The number's disc on a ball and the spots of the cue ball: the cosine of the angle that they span.
DISC, SPOT = cos(0.62), cos(0.17)

#: The colour of each ball by its number, red, green, blue; 8 is that of all figures too.
COLOURS: dict[int, tuple[float, float, float]] = {
    1: (236.0, 186.0, 30.0),
    2: (32.0, 72.0, 178.0),
    3: (206.0, 40.0, 36.0),
    4: (104.0, 44.0, 138.0),
    5: (236.0, 116.0, 28.0),
    6: (20.0, 104.0, 52.0),
    7: (122.0, 28.0, 36.0),
    8: (26.0, 26.0, 30.0),
}

#: The figures as lines on a disc whose radius is about 0.58, the ball's being 1; and half a line's width.
DIGITS: dict[int, tuple[Vector, ...]] = {
    1: ((-0.1, 0.17), (0.03, 0.28), (0.03, -0.28)),
    2: ((-0.14, 0.17), (-0.05, 0.28), (0.08, 0.28), (0.15, 0.17), (0.12, 0.05), (-0.15, -0.28), (0.17, -0.28)),
    3: ((-0.14, 0.28), (0.14, 0.28), (-0.01, 0.05), (0.13, -0.04), (0.14, -0.18), (0.02, -0.28), (-0.15, -0.22)),
    4: ((0.07, -0.28), (0.07, 0.28), (-0.17, -0.1), (0.18, -0.1)),
    5: ((0.14, 0.28), (-0.11, 0.28), (-0.13, 0.04), (0.05, 0.07), (0.15, -0.08), (0.1, -0.23), (-0.15, -0.26)),
    6: (
        (0.1, 0.28),
        (-0.06, 0.16),
        (-0.14, -0.08),
        (-0.1, -0.24),
        (0.03, -0.28),
        (0.14, -0.16),
        (0.1, -0.02),
        (-0.03, 0.03),
        (-0.13, -0.1),
    ),
    7: ((-0.15, 0.28), (0.16, 0.28), (-0.03, -0.28)),
}
STROKE = 0.055


def _turned(axis: tuple[float, float, float], angle: float) -> Field:
    """The matrix that turns by an angle round a unit axis. Source: Rodrigues' formula."""
    x, y, z = axis
    cross = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    turn: Field = np.eye(3) + sin(angle) * cross + (1.0 - cos(angle)) * (cross @ cross)
    return turn


#: How a ball is turned before it rolls: its number up, and a little to the side.
UPRIGHT = _turned((1.0, 0.0, 0.0), 0.2) @ _turned((0.0, 1.0, 0.0), -0.15)


class RollingBall:
    """A ball's picture, which turns as the ball rolls.

    Args:
        radius: In pixels.
        number: Its number, from 1 to 8; 0 is the cue ball.
    """

    def __init__(self, radius: float, number: int) -> None:
        self.radius = radius
        self._paint = partial(_numbered_paint, number=number) if number else _cue_paint
        self._gloss = 0.95 if number else 0.55
        self._drawn: tuple[tuple[int, int, float, float], pygame.Surface] | None = None
        self.turn = UPRIGHT

    def reset(self) -> None:
        """Turn it as a ball is put onto the table: its number can be read."""
        if self.turn is not UPRIGHT:
            self.turn, self._drawn = UPRIGHT, None

    def turn_as(self, other: RollingBall) -> None:
        """Turn it as another one is turned."""
        self.turn, self._drawn = other.turn, None

    def roll(self, dx: float, dy: float) -> None:
        """Roll it without slipping over `dx` and `dy`, in pixels, y up."""
        way = hypot(dx, dy)
        if way > 0.0:
            self.turn = _turned((-dy / way, dx / way, 0.0), way / self.radius) @ self.turn
            self._drawn = None

    def draw(self, surface: pygame.Surface, place: Vector, size: float = 1.0, bright: float = 1.0) -> None:
        """Draw it with its centre at `place`, as large as `size` and as bright as `bright` say of 1."""
        left, top = floor(place[0]), floor(place[1])
        part_x, part_y = round((place[0] - left) * PLACES), round((place[1] - top) * PLACES)
        key = (part_x, part_y, size, bright)
        if self._drawn is None or self._drawn[0] != key:
            self._drawn = key, self._picture(part_x, part_y, self.radius * size, bright)
        picture = self._drawn[1]
        half = picture.get_width() // 2
        surface.blit(picture, (left - half, top - half))

    def _picture(self, part_x: int, part_y: int, radius: float, bright: float) -> pygame.Surface:
        """The ball as it is turned now, its centre a number of parts of a pixel right of and below the middle."""
        normal, shade, gloss, cover = _light(part_x, part_y, radius)
        colour = self._paint(normal @ self.turn)
        light = colour * shade[..., None] + (255.0 * self._gloss) * gloss[..., None]
        light = np.minimum(light, 255.0) * (bright * cover)[..., None]
        finer = _finer(radius)
        side = cover.shape[0] // finer
        blocks = (side, finer, side, finer)
        total = cover.reshape(blocks).sum(axis=(1, 3))
        mean = light.reshape((*blocks, 3)).sum(axis=(1, 3)) / np.maximum(total, 1e-9)[..., None]
        alpha = total * (255.0 / (finer * finer))
        return surface_of(np.concatenate((mean, alpha[..., None]), axis=2).round().astype(np.uint8))


def _finer(radius: float) -> int:
    """How many samples there are along each side of a pixel of a ball."""
    return FEWER if radius > LARGE else FINER


@lru_cache(maxsize=256)
def _light(part_x: int, part_y: int, radius: float) -> tuple[Field, Field, Field, Field]:
    """The sphere's unit normals, how bright each is, how it shines, and whether each sample is on the ball."""
    half = int(radius) + 3
    finer = _finer(radius)
    steps = (np.arange(2 * half * finer) + 0.5) / finer - half
    x = (steps[None, :] - part_x / PLACES) / radius
    y = -(steps[:, None] - part_y / PLACES) / radius
    flat = x * x + y * y
    cover = (flat <= 1.0).astype(np.float64)
    z = np.sqrt(np.maximum(1.0 - flat, 0.0))
    normal = np.stack(np.broadcast_arrays(x, y, z), axis=2)
    lamp = LAMP / np.linalg.norm(LAMP)
    facing = normal @ lamp
    shade = 0.34 + 0.72 * np.maximum(facing, 0.0) - 0.18 * (1.0 - z) ** 2
    middle = lamp + np.array((0.0, 0.0, 1.0))
    shine = np.maximum(normal @ (middle / np.linalg.norm(middle)), 0.0)
    gloss = 0.85 * shine**70 + 0.14 * shine**9
    return normal, shade, gloss, cover


def _cue_paint(body: Field) -> Field:
    """The colours of the cue ball: ivory with six red spots, which show how it rolls."""
    spots = np.abs(body).max(axis=2) > SPOT
    return np.where(spots[..., None], np.array((196.0, 40.0, 38.0)), np.array((250.0, 245.0, 230.0)))


def _numbered_paint(body: Field, number: int) -> Field:
    """The colours of a ball with its number on a white disc on two sides."""
    disc = np.abs(body[..., 2]) > DISC
    x, y, z = body[disc].T
    figure = _eight(x * np.sign(z), y) if number == 8 else _stroked(x * np.sign(z), y, DIGITS[number])
    paint = np.empty(body.shape)
    paint[:] = COLOURS[number]
    paint[disc] = np.where(figure[:, None], np.array(COLOURS[8]), np.array((246.0, 243.0, 236.0)))
    return paint


def _eight(x: Field, y: Field) -> NDArray[np.bool_]:
    """Whether places on a ball's disc are in an 8: two rings."""
    upper, lower = np.hypot(x, y - 0.17), np.hypot(x, y + 0.15)
    return (np.abs(upper - 0.125) < 0.055) | (np.abs(lower - 0.155) < 0.055)


def _stroked(x: Field, y: Field, corners: tuple[Vector, ...]) -> NDArray[np.bool_]:
    """Whether places on a ball's disc are in a figure, which is one line along its corners."""
    drawn = np.zeros(x.shape, bool)
    for (x0, y0), (x1, y1) in pairwise(corners):
        dx, dy = x1 - x0, y1 - y0
        along = np.clip(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
        drawn |= np.hypot(x - x0 - along * dx, y - y0 - along * dy) < STROKE
    return drawn
