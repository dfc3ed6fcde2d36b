"""What is printed on the playfield: the night sky, a sun that rises between the flippers, planets' paths, a comet."""

from __future__ import annotations

from math import asin, cos, pi, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from carom import Aabb
from carom.play.pinball.art.paint import (
    CORAL,
    CREAM,
    GOLD,
    NIGHT,
    TEAL,
    VIOLET,
    Canvas,
    Spot,
    bow,
    mixed,
    polar,
    ring,
    shaded,
    star,
)

SUN: Spot = (9.3, 5.0)
SYSTEM: Spot = (9.3, 27.2)
RAYS = 36


def sky(box: Aabb, scale: float) -> pygame.Surface:
    """The sky's picture: night above, dusk below, and the rays of the sun across it."""
    width, height = round((box.right - box.left) * scale), round((box.top - box.bottom) * scale)
    x = (box.left + (np.arange(width) + 0.5) / scale)[:, None]
    y = (box.top - (np.arange(height) + 0.5) / scale)[None, :]
    stops = np.array([0.0, 9.0, 19.0, 30.0, 44.0])
    hues = np.array([(122, 40, 104), (96, 36, 124), (48, 30, 112), (20, 20, 74), NIGHT], dtype=float)
    colours = np.stack([np.interp(y[0], stops, hues[:, part]) for part in range(3)], axis=-1)[None, :, :]
    colours = np.repeat(colours, width, axis=0)
    rays = _rays(x, y, scale)
    dawn = np.array(CORAL, dtype=float) * 0.75 + np.array(GOLD, dtype=float) * 0.25
    colours += rays[:, :, None] * (dawn - colours)
    distance = np.hypot(x - SUN[0], y - SUN[1])
    shine = np.clip(1.0 - distance / 13.0, 0.0, 1.0) ** 2.2
    colours += 0.75 * shine[:, :, None] * (np.array(GOLD, dtype=float) - colours)
    far = np.hypot((x - SYSTEM[0]) / 1.1, y - SYSTEM[1])
    colours += (np.clip(1.0 - far / 9.0, 0.0, 1.0) ** 1.5)[:, :, None] * np.array((34.0, 22.0, 74.0))
    return shaded((width, height), colours)


def _rays(x: NDArray[np.floating], y: NDArray[np.floating], scale: float) -> NDArray[np.float64]:
    """How much of a ray each point has: wedges from the sun, sharp to a pixel, which fade with the distance."""
    away_x, away_y = x - SUN[0], y - SUN[1]
    distance = np.hypot(away_x, away_y)
    wave = np.sin(np.arctan2(away_y, away_x) * RAYS + pi / 2.0)
    edge = np.clip(wave * distance * scale / RAYS + 0.5, 0.0, 1.0)
    return np.asarray(edge * 0.62 * np.clip(1.0 - (distance - 3.0) / 23.0, 0.0, 1.0) ** 1.3)


def paint_print(canvas: Canvas) -> None:
    """Paint the heavens over the sky."""
    _stars(canvas)
    _comet(canvas)
    _system(canvas)
    _compass(canvas, (9.3, 18.8))
    _sun(canvas)


def _stars(canvas: Canvas) -> None:
    """Strew stars, denser towards the top."""
    seeded = np.random.default_rng(1910)
    for x, height, size in seeded.random((260, 3)):
        spot = (20.6 * x - 0.3, 42.2 - 27.0 * height**1.4)
        colour = (CREAM, TEAL, GOLD, CREAM)[int(size * 400) % 4]
        canvas.disc(spot, 0.03 + 0.05 * size**3, (*colour, int(90 + 150 * (1.0 - height))))
    for spot, size in (
        ((3.6, 38.0), 0.55),
        ((17.2, 38.4), 0.5),
        ((4.6, 31.6), 0.4),
        ((14.6, 31.2), 0.42),
        ((13.9, 23.0), 0.35),
        ((4.4, 24.2), 0.35),
        ((1.1, 34.0), 0.3),
        ((9.3, 40.6), 0.4),
    ):
        canvas.light(spot, size * 2.4, CREAM, 0.28)
        canvas.fill(star(spot, size, size * 0.16), (*CREAM, 235))


def _comet(canvas: Canvas) -> None:
    """Paint the comet over the lanes, its tails bent along the dome."""
    head = (14.15, 38.05)
    center = (10.0, 32.0)
    for tail, (colour, wide, angle, sure) in enumerate(
        ((VIOLET, 1.5, 2.62, 150), (CORAL, 1.1, 2.5, 150), (GOLD, 0.72, 2.36, 190), (CREAM, 0.36, 2.05, 230))
    ):
        begin = 0.97
        outer = bow(center, 7.33 + wide / 2.0 - 0.1 * tail, begin, angle)
        inner = bow(center, 7.33 - wide / 2.0 + 0.05 * tail, begin, angle)
        tip = polar(center, 7.6, angle + 0.12)
        half = len(outer)
        path = [
            (a[0] + (tip[0] - a[0]) * (number / half) ** 3, a[1] + (tip[1] - a[1]) * (number / half) ** 3)
            for number, a in enumerate(outer)
        ]
        back = [
            (a[0] + (tip[0] - a[0]) * (number / half) ** 3, a[1] + (tip[1] - a[1]) * (number / half) ** 3)
            for number, a in enumerate(inner)
        ]
        canvas.fill([*path, *back[::-1]], (*colour, sure))
        canvas.disc(head, wide / 2.0, (*colour, 255))
    canvas.light(head, 2.4, GOLD, 0.8)
    canvas.disc(head, 0.42, CREAM)


def _system(canvas: Canvas) -> None:
    """Paint the paths of planets round the middle of the bumpers, and the shine of each bumper's place."""
    for radius, colour, sure in ((3.42, TEAL, 130), (4.6, CREAM, 70), (5.9, TEAL, 80)):
        canvas.stroke(ring(SYSTEM, radius), 0.07, (*colour, sure), closed=True)
    for number in range(48):
        angle = number * pi / 24.0
        long = 0.4 if number % 4 == 0 else 0.2
        canvas.stroke([polar(SYSTEM, 5.9, angle), polar(SYSTEM, 5.9 + long, angle)], 0.05, (*TEAL, 110))
    _planet(canvas, SYSTEM, 0.98)
    for radius, angle, size, colour in (
        (4.6, 0.55, 0.2, CORAL),
        (5.9, 2.55, 0.26, GOLD),
        (5.9, -0.62, 0.2, CREAM),
        (4.6, 3.5, 0.16, TEAL),
    ):
        canvas.disc(polar(SYSTEM, radius, angle), size, colour)
        canvas.disc(polar(polar(SYSTEM, radius, angle), size * 0.35, 0.8), size * 0.45, (255, 255, 255, 90))


def _compass(canvas: Canvas, hub: Spot) -> None:
    """Paint a compass rose under the spinner."""
    canvas.disc(hub, 2.35, (*NIGHT, 150))
    canvas.stroke(ring(hub, 2.35), 0.1, (*GOLD, 220), closed=True)
    canvas.stroke(ring(hub, 2.12), 0.04, (*GOLD, 170), closed=True)
    for points, size, colour in ((8, 1.5, VIOLET), (4, 2.05, CORAL)):
        canvas.fill(star(hub, size, 0.34, points), colour)
    for number in range(4):
        angle = pi / 2.0 + number * pi / 2.0
        canvas.fill([hub, polar(hub, 2.05, angle), polar(hub, 0.34, angle + pi / 4.0)], GOLD)
    canvas.disc(hub, 0.5, NIGHT)


def _sun(canvas: Canvas) -> None:
    """Paint the sun that rises behind the apron, in bands."""
    for radius, colour in ((4.1, CORAL), (3.55, NIGHT), (3.4, GOLD), (2.6, mixed(GOLD, CREAM, 0.5)), (1.9, CREAM)):
        canvas.disc(SUN, radius, (*colour, 225))
    for number in range(-3, 4):
        angle = pi / 2.0 + number * 0.36
        canvas.fill([polar(SUN, 2.7, angle - 0.06), polar(SUN, 3.34, angle), polar(SUN, 2.7, angle + 0.06)], CORAL)


def _planet(canvas: Canvas, center: Spot, radius: float) -> None:
    """Paint a banded planet with a ring round it."""
    tilt = 0.36
    canvas.light(center, radius * 3.0, VIOLET, 0.9)
    loop = [
        (
            center[0] + radius * 1.75 * (cos(angle) * cos(tilt)) - radius * 0.45 * sin(angle) * sin(tilt),
            center[1] + radius * 1.75 * (cos(angle) * sin(tilt)) + radius * 0.45 * sin(angle) * cos(tilt),
        )
        for angle in (number * pi / 32.0 for number in range(65))
    ]
    for width, colour in ((0.26, mixed(GOLD, NIGHT, 0.35)), (0.1, GOLD)):
        canvas.stroke(loop[:33], width, colour)
    canvas.disc(center, radius, CORAL)
    for low, high, colour in ((0.35, 0.6, GOLD), (-0.1, 0.12, mixed(CORAL, CREAM, 0.5)), (-0.65, -0.4, VIOLET)):
        band = [polar(center, radius, asin(low) + tilt), *bow(center, radius, asin(low) + tilt, asin(high) + tilt)]
        other = bow(center, radius, pi - asin(high) + tilt, pi - asin(low) + tilt)
        canvas.fill([*band, *other], colour)
    shade = bow(center, radius, -2.3, 0.85)
    canvas.fill(
        [*shade, *bow((center[0] - 0.28 * radius, center[1] + 0.28 * radius), radius, 0.55, -2.0)], (*NIGHT, 120)
    )
    for width, colour in ((0.26, mixed(GOLD, NIGHT, 0.35)), (0.1, CREAM)):
        canvas.stroke(loop[32:], width, colour)
