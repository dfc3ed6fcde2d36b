"""The lamps under the playfield: where each one is, its lens as it looks unlit, and its light."""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil, cos, pi, sin
from typing import NamedTuple

import pygame

import carom
from carom.play.pinball.art.paint import (
    CORAL,
    CREAM,
    GOLD,
    NIGHT,
    TEAL,
    Canvas,
    Colour,
    Spot,
    glow,
    mixed,
    polar,
    ring,
    star,
)
from carom.play.pinball.art.parts import MIDDLE, AnyShape
from carom.play.pinball.rules import lamps

MULTIPLIER_HEIGHTS = (12.2, 12.55, 12.55, 12.2)
#: How far the light of a lamp reaches beyond its lens, in units.
REACH = 1.5


class Lens(NamedTuple):
    """A lamp's lens.

    Attributes:
        spot: Its middle.
        outline: Its edge, round `spot`.
        colour: That of its light.
        word: What is written on it.
        size: That of the letters, in units.
    """

    spot: Spot
    outline: tuple[Spot, ...]
    colour: Colour
    word: str = ""
    size: float = 0.8

    def grown(self, by: float) -> list[Spot]:
        """The outline moved outward from the middle."""
        return [
            (x + (x - self.spot[0]) / far * by, y + (y - self.spot[1]) / far * by)
            for x, y in self.outline
            if (far := max(abs(x - self.spot[0]), abs(y - self.spot[1]), 1e-9))
        ]


class Light(NamedTuple):
    """The pictures of a lamp that is lit.

    Attributes:
        lens: The lens, to be laid over the ground.
        lens_at: The pixel of its corner.
        shine: The light round it, to be added.
        shine_at: The pixel of its corner.
    """

    lens: pygame.Surface
    lens_at: tuple[int, int]
    shine: pygame.Surface
    shine_at: tuple[int, int]


def _disc(spot: Spot, radius: float, colour: Colour, word: str = "", size: float = 0.8) -> Lens:
    """A round lens."""
    return Lens(spot, tuple(ring(spot, radius)), colour, word, size)


def _arrow(spot: Spot, size: float, angle: float, colour: Colour) -> Lens:
    """A lens like an arrow's head."""
    outline = tuple(
        (
            spot[0] + size * (along * cos(angle) - aside * sin(angle)),
            spot[1] + size * (along * sin(angle) + aside * cos(angle)),
        )
        for along, aside in ((1.1, 0.0), (-0.7, 0.72), (-0.35, 0.0), (-0.7, -0.72))
    )
    return Lens(spot, outline, colour)


def lenses(world: carom.World) -> dict[str, Lens]:
    """Every lens in the playfield by its lamp's name; a bumper's lamp is its cap, and "tilt" is on the back."""
    found = _signs()
    places = {shape.name: _middle(shape) for shape in world.shapes if shape.name in lamps.PLACED}
    for name, letter in zip(lamps.LANES, "SKY", strict=True):
        found[name] = _disc(places[name], 0.5, GOLD, letter, 0.95)
    for name in lamps.INLANES:
        found[name] = Lens(places[name], tuple(star(places[name], 0.66, 0.34, 5)), TEAL)
    for name in lamps.OUTLANES:
        found[name] = Lens(places[name], tuple(star(places[name], 0.66, 0.36, 4)), CORAL)
    for name in lamps.ORBITS:
        x, y = places[name]
        found[name] = _arrow((x, y - 1.5), 0.6, pi / 2.0, TEAL)
    x, y = places[lamps.SAUCER]
    found[lamps.SAUCER] = _arrow((x, y - 1.9), 0.62, pi / 2.0, GOLD)
    for name in lamps.TARGETS:
        x, y = places[name]
        side = 1.0 if x < MIDDLE else -1.0
        found[name] = _arrow((x + side * (1.2 if side > 0.0 else 2.35), y), 0.62, pi / 2.0 + side * pi / 2.0, CORAL)
    for number, name in enumerate(lamps.BANK, 1):
        x, y = places[name]
        found[name] = _disc((x - 0.95, y), 0.4, GOLD, str(number), 0.75)
    return found


def _signs() -> dict[str, Lens]:
    """The lenses that belong to no shape."""
    found = {
        name: _disc((MIDDLE + (number - 1.5) * 1.3, y), 0.52, (GOLD, GOLD, CORAL, CORAL)[number], name.upper(), 0.8)
        for number, (name, y) in enumerate(zip(lamps.MULTIPLIERS, MULTIPLIER_HEIGHTS, strict=True))
    }
    found["shoot again"] = _disc((MIDDLE, 10.35), 0.7, CORAL, "SHOOT\nAGAIN", 0.47)
    for name, x, colour, word in (
        ("multiball", MIDDLE - 1.25, TEAL, "MULTI\nBALL"),
        ("jackpot", MIDDLE + 1.25, GOLD, "JACK\nPOT"),
    ):
        spot = (x, 14.6)
        found[name] = Lens(spot, tuple(star(spot, 1.12, 0.82, 8)), colour, word, 0.5)
    return found


def _middle(shape: AnyShape) -> Spot:
    """The middle of a shape's box."""
    box = shape.aabb
    return (box.left + box.right) / 2.0, (box.bottom + box.top) / 2.0


def paint_unlit(canvas: Canvas, found: Mapping[str, Lens]) -> None:
    """Paint all lenses as they look unlit."""
    for lens in found.values():
        canvas.fill(lens.grown(0.13), CREAM)
        canvas.fill(lens.grown(0.05), NIGHT)
        # Under words it is darker, for these are to be read before the lamp is ever lit.
        canvas.fill(lens.outline, mixed(lens.colour, NIGHT, 0.78 if lens.word else 0.66))
        _facets(canvas, lens, mixed(lens.colour, NIGHT, 0.72 if lens.word else 0.5))
        _inscribe(canvas, lens, mixed(lens.colour, CREAM, 0.8))


def _facets(canvas: Canvas, lens: Lens, colour: Colour) -> None:
    """Paint the facets of a lens: every other wedge of it."""
    edge = lens.grown(-0.06)
    step = max(1, len(edge) // 24)
    for number in range(0, len(edge), 2 * step):
        after = edge[(number + step) % len(edge)]
        canvas.fill([lens.spot, edge[number], after], (*colour, 150))


def _inscribe(canvas: Canvas, lens: Lens, colour: Colour) -> None:
    """Write what is on a lens, line below line."""
    lines = lens.word.split("\n") if lens.word else []
    x, y = lens.spot
    for number, line in enumerate(lines):
        canvas.words(line, (x, y + lens.size * 0.8 * ((len(lines) - 1) / 2.0 - number)), lens.size, colour)


def light_of(ground: Canvas, lens: Lens) -> Light:
    """A lens's pictures when it is lit, placed on the ground's picture."""
    xs, ys = [x for x, _ in lens.outline], [y for _, y in lens.outline]
    box = carom.Aabb(min(xs) - 0.3, min(ys) - 0.3, max(xs) + 0.3, max(ys) + 0.3)
    canvas = Canvas(box, ground.scale)
    canvas.fill(lens.grown(0.13), CREAM)
    canvas.fill(lens.outline, lens.colour)
    _facets(canvas, lens, mixed(lens.colour, CREAM, 0.5))
    size = max(box.right - box.left, box.top - box.bottom)
    canvas.fill([polar(lens.spot, size * 0.2, angle * pi / 8.0) for angle in range(16)], (255, 255, 255, 120))
    _inscribe(canvas, lens, NIGHT)
    shine = glow(ceil((size / 2.0 + REACH) * ground.scale), lens.colour, 0.6)
    x, y = ground.pixel(lens.spot)
    return Light(
        canvas.finished(),
        ground.pixel((box.left, box.top)),
        shine,
        (x - shine.get_width() // 2, y - shine.get_height() // 2),
    )
