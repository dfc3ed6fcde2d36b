"""All pictures of the pinball table, painted once by the program."""

from __future__ import annotations

from math import pi

import numpy as np
import pygame

import carom
from carom.play.pinball.art import sprites as art_sprites
from carom.play.pinball.art.apron import paint_apron, paint_trough
from carom.play.pinball.art.ground import paint_print, sky
from carom.play.pinball.art.lamps import Light, lenses, light_of, paint_unlit
from carom.play.pinball.art.paint import FINER, TEAL, Canvas, Spot, glow, opaque
from carom.play.pinball.art.parts import band_of, paint_parts
from carom.play.pinball.rules import lamps
from carom.play.pinball.rules.table import BALL_RADIUS

#: Pixels per unit, and what of the world the table's picture shows: the field, the cabinet round it. Of a picture that
#: is not magnified, as all pixels here.
SCALE = 19.0
SIZE = (416, 840)
BOX = carom.Aabb(-0.9, -1.2, -0.9 + SIZE[0] / SCALE, -1.2 + SIZE[1] / SCALE)
#: From so many times on the largest pictures are painted only so much larger than they are shown, for their number of
#: pixels: edges are as smooth to the eye where pixels are so small.
LARGE, COARSE = 3, 2


def pixel(spot: Spot) -> tuple[float, float]:
    """The pixel of a point of the table on its picture."""
    return (spot[0] - BOX.left) * SCALE, (BOX.top - spot[1]) * SCALE


class Art:
    """The table's pictures, `times` as large as those of `SIZE`.

    Attributes:
        size: Width and height in pixels.
        scale: Pixels per unit.
        ground: All that never changes, lamps unlit.
        apron: What covers the trough, laid over the balls, at `apron_at`.
        lights: The pictures of each lamp in the playfield.
        bumpers: Of each bumper its pictures: unlit, lit, kicking.
        shine: The light of each bumper.
        targets: Of each drop target its pictures, up and down, and their corner.
        flippers: By name, pictures from the lower stop to the upper one.
        spinner: Pictures of half a turn.
        ball: A ball, and its `shadow`.
        tail: Lights behind a fast ball.
        spark: The light of an impact.
        kick: The light of a slingshot or of the saucer that kicks, in the middle of one of `kickers`.
        plunger: The plunger, its tip in the middle of the upper edge.
    """

    def __init__(self, world: carom.World, times: int = 1) -> None:
        self.times, self.scale = times, SCALE * times
        self.size = (SIZE[0] * times, SIZE[1] * times)
        finer = FINER if times < LARGE else COARSE
        ground = Canvas(BOX, self.scale, sky(BOX, self.scale), finer=finer)
        found = lenses(world)
        paint_print(ground)
        paint_unlit(ground, found)
        paint_trough(ground)
        paint_parts(ground, world)
        self.ground = opaque(ground.finished())
        self.lights: dict[str, Light] = {name: light_of(ground, lens) for name, lens in found.items()}
        apron_box = carom.Aabb(BOX.left, BOX.bottom, BOX.right, BOX.bottom + 7.0)
        apron = Canvas(apron_box, self.scale, finer=finer)
        paint_apron(apron, world.shapes)
        self.apron = apron.finished()
        self.apron_at = (0, self.size[1] - self.apron.get_height())
        self._round(world)
        self._moving(world)

    def pixel(self, spot: Spot) -> tuple[float, float]:
        """The pixel of a point of the table."""
        x, y = pixel(spot)
        return x * self.times, y * self.times

    def _round(self, world: carom.World) -> None:
        """Paint bumpers, balls and lights."""
        self.bumpers: dict[str, tuple[pygame.Surface, ...]] = {}
        self.shine: dict[str, pygame.Surface] = {}
        self.bumper_places: dict[str, tuple[float, float]] = {}
        for shape in world.shapes:
            if isinstance(shape, carom.Circle) and shape.name in lamps.BUMPERS:
                colours = art_sprites.CAPS[shape.name]
                self.bumper_places[shape.name] = self.pixel(shape.center)
                self.bumpers[shape.name] = tuple(
                    art_sprites.bumper(shape.radius, colours, self.scale, lit, squeeze)
                    for lit, squeeze in ((False, 0.0), (True, 0.0), (True, 1.0))
                )
                self.shine[shape.name] = glow(round(3.1 * self.scale), colours[0], 0.75)
        radius = BALL_RADIUS * self.scale
        self.ball = art_sprites.ball(radius)
        self.shadow = art_sprites.shadow(radius)
        self.tail = art_sprites.trail(round(radius))
        self.kickers: dict[str, tuple[float, float]] = {
            name: self.pixel(middle_of(box_of(world, name)))
            for name in ("left slingshot's band", "right slingshot's band", lamps.SAUCER)
        }
        self.kick = glow(round(3.0 * self.scale), TEAL, 0.8)
        self.spark = glow(round(1.1 * self.scale), (255, 236, 190), 0.9)
        self.plunger = art_sprites.plunger(self.scale)

    def _moving(self, world: carom.World) -> None:
        """Paint what turns and what drops."""
        self.flippers: dict[str, tuple[pygame.Surface, ...]] = {}
        self.pivots: dict[str, tuple[float, float]] = {}
        self.targets: dict[str, tuple[pygame.Surface, pygame.Surface, tuple[int, int]]] = {}
        for shape in world.shapes:
            if isinstance(shape, carom.Compound) and shape.turn_limits is not None:
                name = shape.name or ""
                low, high = shape.turn_limits
                far = high if high > -low else low
                outline = turned_back(shape)
                self.flippers[name] = tuple(
                    art_sprites.flipper(
                        outline, shape.pivot, far * number / (art_sprites.FLIPPER_PICTURES - 1), self.scale
                    )
                    for number in range(art_sprites.FLIPPER_PICTURES)
                )
                self.pivots[name] = self.pixel(shape.pivot)
            elif isinstance(shape, carom.Compound):
                count = art_sprites.SPINNER_PICTURES
                outline = turned_back(shape)
                self.spinner = tuple(
                    art_sprites.spinner(outline, shape.pivot, pi * number / count, self.scale)
                    for number in range(count)
                )
                self.pivots["spinner"] = self.pixel(shape.pivot)
        for name in lamps.BANK:
            box = box_of(world, name)
            x, y = self.pixel((box.left - art_sprites.MARGIN, box.top + art_sprites.MARGIN))
            self.targets[name] = (
                art_sprites.drop_target(box, self.scale, True),
                art_sprites.drop_target(box, self.scale, False),
                (round(x), round(y)),
            )


def turned_back(part: carom.Compound) -> list[Spot]:
    """The outline of a band as it lay when it was made, before it turned."""
    x, y = part.pivot
    away = art_sprites.turned_about(band_of(part), part.pivot, -part.orientation)
    return [(x + along, y + up) for along, up in away]


def box_of(world: carom.World, name: str) -> carom.Aabb:
    """The box round all shapes of a name."""
    boxes = [shape.aabb for shape in world.shapes if shape.name == name]
    sides = np.array([(box.left, box.bottom, -box.right, -box.top) for box in boxes]).min(axis=0)
    return carom.Aabb(float(sides[0]), float(sides[1]), -float(sides[2]), -float(sides[3]))


def middle_of(box: carom.Aabb) -> Spot:
    """The middle of a box."""
    return 0.5 * (box.left + box.right), 0.5 * (box.bottom + box.top)
