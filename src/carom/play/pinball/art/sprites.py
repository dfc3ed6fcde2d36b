"""The pictures of what moves or lights up: ball, flippers, bumpers, targets, spinner, gates, plunger."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, pi, sin

import numpy as np
import pygame

import carom
from carom.play.pinball.art.paint import (
    CORAL,
    CREAM,
    FINER,
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
    polar,
    ring,
    star,
)
from carom.play.pinball.art.parts import DARK_STEEL, STEEL

#: Pictures of a flipper between its stops, and of the spinner in half a turn.
FLIPPER_PICTURES = 29
SPINNER_PICTURES = 48
#: Room round a drop target's picture, in units.
MARGIN = 0.25
CAPS: dict[str, tuple[Colour, Colour]] = {
    "left bumper": (CORAL, GOLD),
    "right bumper": (TEAL, CREAM),
    "low bumper": (GOLD, CORAL),
}


def ball(radius: float) -> pygame.Surface:
    """A ball of polished steel that mirrors the table: `radius` in pixels."""
    half = int(radius) + 2
    fine = half * 2 * FINER
    place = (np.arange(fine) + 0.5) / (radius * FINER) - half / radius
    x, y = place[:, None], -place[None, :]
    far = np.sqrt(x * x + y * y)
    inside = np.clip((1.0 - far) * radius * FINER + 0.5, 0.0, 1.0)
    depth = np.sqrt(np.clip(1.0 - far * far, 0.0, 1.0))
    # What a mirror ball shows at each height of its normal: sky above, the table's dusk and a dark rim below.
    stops = [-1.0, -0.7, -0.42, -0.18, -0.02, 0.22, 0.6, 1.0]
    hues = np.array(
        [
            (20, 16, 44),
            (60, 40, 84),
            (176, 112, 128),
            (70, 62, 98),
            (38, 40, 70),
            (178, 186, 212),
            (238, 242, 252),
            (150, 158, 192),
        ]
    )
    bend = y * (1.2 - 0.2 * depth) + 0.16 * x * x - 0.05
    colours = np.stack([np.interp(bend, stops, hues[:, part]) for part in range(3)], axis=-1)
    colours *= (0.35 + 0.65 * depth**0.5)[:, :, None]
    spark = 1.2 * np.exp(-((x + 0.34) ** 2 + (y - 0.44) ** 2) / 0.03) + 0.5 * np.exp(
        -((x - 0.42) ** 2 + (y + 0.5) ** 2) / 0.02
    )
    colours += 255.0 * spark[:, :, None]
    picture = pygame.Surface((fine, fine), pygame.SRCALPHA)
    pygame.surfarray.blit_array(picture, np.clip(colours, 0, 255).astype(np.uint8))
    pygame.surfarray.pixels_alpha(picture)[:] = (inside * 255.0).astype(np.uint8)
    return pygame.transform.smoothscale(picture, (half * 2, half * 2))


def shadow(radius: float) -> pygame.Surface:
    """The soft shadow of a ball: `radius` in pixels."""
    half = int(radius * 1.35) + 1
    place = np.arange(-half, half + 1) / (radius * 1.35)
    far = np.sqrt(place[:, None] ** 2 + place[None, :] ** 2)
    picture = pygame.Surface(far.shape, pygame.SRCALPHA)
    pygame.surfarray.pixels_alpha(picture)[:] = (150.0 * np.clip(1.25 - far, 0.0, 0.75) / 0.75).astype(np.uint8)
    return picture


def turned_about(spots: Sequence[Spot], pivot: Spot, angle: float) -> list[Spot]:
    """Points turned about a pivot, as places from the pivot."""
    turn_x, turn_y = cos(angle), sin(angle)
    return [
        ((x - pivot[0]) * turn_x - (y - pivot[1]) * turn_y, (x - pivot[0]) * turn_y + (y - pivot[1]) * turn_x)
        for x, y in spots
    ]


def flipper(outline: Sequence[Spot], pivot: Spot, angle: float, scale: float) -> pygame.Surface:
    """A flipper turned by an angle, its pivot in the picture's middle: a bat in a rubber, with its shadow."""
    spots = turned_about(outline, pivot, angle)
    reach = max(max(abs(x), abs(y)) for x, y in spots) + 0.4
    canvas = Canvas(carom.Aabb(-reach, -reach, reach, reach), scale)
    canvas.fill([(x + 0.16, y - 0.22) for x, y in spots], (0, 0, 0, 105))
    canvas.fill(spots, CORAL)
    canvas.stroke(spots, 0.06, mixed(CORAL, NIGHT, 0.5), closed=True)
    canvas.fill([(x * 0.93, y * 0.93) for x, y in _shrunk(spots, 0.15)], CREAM)
    tip = max(spots, key=lambda spot: spot[0] * spot[0] + spot[1] * spot[1])
    canvas.stroke([(tip[0] * 0.3, tip[1] * 0.3), (tip[0] * 0.78, tip[1] * 0.78)], 0.16, CORAL)
    canvas.stroke([(tip[0] * 0.34, tip[1] * 0.34), (tip[0] * 0.7, tip[1] * 0.7)], 0.05, GOLD)
    canvas.disc((0.0, 0.0), 0.33, mixed(GOLD, NIGHT, 0.5))
    canvas.disc((-0.03, 0.04), 0.24, GOLD)
    canvas.stroke([polar((0.0, 0.0), 0.15, angle), polar((0.0, 0.0), -0.15, angle)], 0.06, NIGHT)
    return canvas.finished()


def _shrunk(spots: Sequence[Spot], by: float) -> list[Spot]:
    """A closed outline, counterclockwise, moved inward."""
    found = []
    for before, (x, y), (end_x, end_y) in zip([spots[-1], *spots], spots, [*spots[1:], spots[0]], strict=False):
        along_x, along_y = end_x - before[0], end_y - before[1]
        length = hypot(along_x, along_y)
        found.append((x - along_y / length * by, y + along_x / length * by))
    return found


def spinner(outline: Sequence[Spot], pivot: Spot, angle: float, scale: float) -> pygame.Surface:
    """The spinner turned by an angle, its pivot in the picture's middle."""
    spots = turned_about(outline, pivot, angle)
    reach = max(max(abs(x), abs(y)) for x, y in spots) + 0.4
    canvas = Canvas(carom.Aabb(-reach, -reach, reach, reach), scale)
    canvas.fill([(x + 0.14, y - 0.18) for x, y in spots], (0, 0, 0, 110))
    canvas.fill(spots, STEEL)
    canvas.stroke(spots, 0.07, DARK_STEEL, closed=True)
    far = max(spots, key=lambda spot: spot[0] * spot[0] + spot[1] * spot[1])
    for side in (-1.0, 1.0):
        canvas.stroke(
            [(far[0] * side * 0.35, far[1] * side * 0.35), (far[0] * side * 0.8, far[1] * side * 0.8)], 0.2, CORAL
        )
    canvas.disc((0.0, 0.0), 0.3, mixed(GOLD, NIGHT, 0.4))
    canvas.disc((-0.03, 0.03), 0.2, GOLD)
    return canvas.finished()


def bumper(
    radius: float, colours: tuple[Colour, Colour], scale: float, lit: bool, squeeze: float = 0.0
) -> pygame.Surface:
    """A bumper from above: skirt, ring, and a cap with a star; `squeeze` draws the ring down as it kicks."""
    reach = radius + 0.4
    canvas = Canvas(carom.Aabb(-reach, -reach, reach, reach), scale)
    middle = (0.0, 0.0)
    first, second = colours
    dim = 0.0 if lit else 0.42
    canvas.disc((0.18, -0.24), radius, (0, 0, 0, 110))
    canvas.disc(middle, radius, mixed(CREAM, NIGHT, 0.5 - 0.5 * squeeze))
    canvas.stroke(ring(middle, radius - 0.07), 0.14, STEEL if not lit else (255, 255, 255), closed=True)
    cap = radius * (0.84 - 0.1 * squeeze)
    canvas.disc(middle, cap, mixed(first, NIGHT, dim + 0.25))
    canvas.disc((-0.02, 0.04), cap * 0.96, mixed(first, NIGHT, dim))
    for number in range(8):
        angle = number * pi / 4.0
        canvas.fill(
            [middle, *bow(middle, cap * 0.96, angle, angle + pi / 8.0)], mixed(first, CREAM, 0.16 if not lit else 0.4)
        )
    canvas.disc(middle, cap * 0.62, mixed(INDIGO if not lit else VIOLET, NIGHT, dim))
    canvas.fill(star(middle, cap * 0.6, cap * 0.27, 5), mixed(second, NIGHT, dim * 0.7))
    canvas.disc(middle, cap * 0.2, mixed(CREAM, NIGHT, dim * 0.6))
    canvas.fill(bow((0.0, cap * 0.1), cap * 0.82, 0.75, 2.4), (255, 255, 255, 38 if not lit else 80))
    return canvas.finished()


def drop_target(box: carom.Aabb, scale: float, up: bool) -> pygame.Surface:
    """A drop target from above: its top edge when it is up, the slot that it leaves when it is down."""
    canvas = Canvas(carom.Aabb(box.left - MARGIN, box.bottom - MARGIN, box.right + MARGIN, box.top + MARGIN), scale)
    corners = [(box.left, box.bottom), (box.left, box.top), (box.right, box.top), (box.right, box.bottom)]
    middle = (box.left + box.right) / 2.0
    path = [(middle, box.bottom + 0.2), (middle, box.top - 0.2)]
    if not up:
        canvas.stroke(path, 0.36, mixed(GOLD, NIGHT, 0.7))
        canvas.stroke(path, 0.24, (6, 6, 16))
        return canvas.finished()
    canvas.fill([(x + 0.13, y - 0.17) for x, y in corners], (0, 0, 0, 110))
    canvas.stroke(path, 0.4, mixed(GOLD, NIGHT, 0.45))
    canvas.stroke(path, 0.3, GOLD)
    canvas.stroke([(x - 0.05, y) for x, y in path], 0.08, CREAM)
    return canvas.finished()


def plunger(scale: float) -> pygame.Surface:
    """The plunger, its tip in the middle of the picture's upper edge: tip, rod with a spring."""
    canvas = Canvas(carom.Aabb(-0.7, -3.0, 0.7, 0.0), scale)
    canvas.fill([(-0.13, -0.3), (0.13, -0.3), (0.13, -3.0), (-0.13, -3.0)], STEEL)
    for number in range(9):
        y = -0.75 - number * 0.26
        canvas.stroke([(-0.38, y), (0.38, y - 0.13)], 0.11, mixed(CREAM, NIGHT, 0.25))
    canvas.stroke([(-0.42, -0.2), (0.42, -0.2)], 0.36, CORAL)
    canvas.stroke([(-0.42, -0.12), (0.42, -0.12)], 0.1, mixed(CORAL, CREAM, 0.6))
    return canvas.finished()


def trail(radius: int) -> tuple[pygame.Surface, ...]:
    """Lights of a comet's tail, from the ball backward: they shrink and fade, to be added."""
    return tuple(
        glow(
            max(3, round(radius * (1.25 - 0.07 * number))),
            mixed(GOLD, VIOLET, min(1.0, number / 9.0)),
            0.42 - 0.022 * number,
            1.1,
        )
        for number in range(15)
    )
