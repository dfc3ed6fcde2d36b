"""The balls: shaded spheres that roll, drawn anew for each place between the pixels that they come to rest on."""

from __future__ import annotations

from functools import lru_cache
from math import cos, floor, hypot, sin
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.play.pool.game import Vector
from carom.play.pool.sprites import surface_of

if TYPE_CHECKING:
    import pygame

Field: TypeAlias = NDArray[np.float64]

#: Samples along each side of a pixel.
FINER = 3

#: Places within a pixel, along each axis, that a ball's centre is rounded to.
PLACES = 4

#: Towards the lamp: x to the right, y up, z out of the screen.
LAMP = np.array((-0.36, 0.48, 0.80))

#: The number's disc on the eight and the spots of the cue ball: the cosine of the angle that they span.
DISC, SPOT = cos(0.62), cos(0.17)


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
        eight: Whether it is the eight; else it is the cue ball.
    """

    def __init__(self, radius: float, eight: bool) -> None:
        self.radius = radius
        self._paint = _eight_paint if eight else _cue_paint
        self._gloss = 0.95 if eight else 0.55
        self._drawn: tuple[tuple[int, int, float, float], pygame.Surface] | None = None
        self.turn = UPRIGHT

    def reset(self) -> None:
        """Turn it as a ball is put onto the table: its number can be read."""
        if self.turn is not UPRIGHT:
            self.turn, self._drawn = UPRIGHT, None

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
        side = cover.shape[0] // FINER
        blocks = (side, FINER, side, FINER)
        total = cover.reshape(blocks).sum(axis=(1, 3))
        mean = light.reshape((*blocks, 3)).sum(axis=(1, 3)) / np.maximum(total, 1e-9)[..., None]
        alpha = total * (255.0 / (FINER * FINER))
        return surface_of(np.concatenate((mean, alpha[..., None]), axis=2).round().astype(np.uint8))


@lru_cache(maxsize=256)
def _light(part_x: int, part_y: int, radius: float) -> tuple[Field, Field, Field, Field]:
    """The sphere's unit normals, how bright each is, how it shines, and whether each sample is on the ball."""
    half = int(radius) + 3
    steps = (np.arange(2 * half * FINER) + 0.5) / FINER - half
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


def _eight_paint(body: Field) -> Field:
    """The colours of the eight: black, with its number on a white disc on two sides."""
    disc = np.abs(body[..., 2]) > DISC
    x, y = body[..., 0] * np.sign(body[..., 2]), body[..., 1]
    upper, lower = np.hypot(x, y - 0.17), np.hypot(x, y + 0.15)
    figure = (np.abs(upper - 0.125) < 0.055) | (np.abs(lower - 0.155) < 0.055)
    white = disc & ~figure
    return np.where(white[..., None], np.array((246.0, 243.0, 236.0)), np.array((26.0, 26.0, 30.0)))
