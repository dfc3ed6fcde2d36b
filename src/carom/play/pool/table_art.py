"""The table as it looks from above: made of the world's own shapes, once, before the game begins."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, cos, sin, tau
from typing import TYPE_CHECKING

import numpy as np

import carom
from carom.play.pool.canvas import Canvas, Field, blurred, noise
from carom.play.pool.layout import CLOTH, CUSHION, CUSHION_CLOTH, RAIL, ROOM, WOOD, Layout

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.play.pool.game import Vector

#: Radians: arcs are drawn as chords no longer than this.
CHORD = 0.06

BRASS = (196, 158, 88)
LEATHER = (46, 34, 29)
PEARL = (238, 232, 215)


def cloth_of(world: carom.World, times: int = 1) -> Layout:
    """The layout for the table in a world, `times` as large: the longest cushions say how large its cloth is."""
    noses = sorted((shape for shape in rim(world) if isinstance(shape, carom.Segment)), key=lambda shape: -shape.length)
    ends = [end for shape in noses[:6] for end in (shape.p0, shape.p1)]
    return Layout(max(x for x, _ in ends), max(y for _, y in ends), times)


def rim(world: carom.World) -> list[carom.Segment | carom.Arc]:
    """The closed line of cushions and pockets, in order."""
    return [
        shape
        for shape in world.shapes
        if isinstance(shape, carom.Segment | carom.Arc) and shape.name in ("cushion", "pocket")
    ]


def pockets(world: carom.World) -> list[carom.Arc]:
    """The walls of the pockets."""
    return [shape for shape in rim(world) if isinstance(shape, carom.Arc) and shape.name == "pocket"]


def outline(shapes: list[carom.Segment | carom.Arc]) -> list[Vector]:
    """The corners of a closed line of shapes, each of which begins or ends where the one before it ended."""
    corners: list[Vector] = []
    for shape in shapes:
        points = _points(shape)
        if corners and _distance(points[-1], corners[-1]) < _distance(points[0], corners[-1]):
            points.reverse()
        corners += points
    return corners


def _points(shape: carom.Segment | carom.Arc) -> list[Vector]:
    """Points along a shape from end to end."""
    if isinstance(shape, carom.Segment):
        return [shape.p0, shape.p1]
    (x, y), (begin_x, begin_y), (end_x, end_y) = shape.center, shape.p0, shape.p1
    begin = atan2(begin_y - y, begin_x - x)
    turn = (atan2(end_y - y, end_x - x) - begin) % tau
    count = max(int(turn / CHORD), 2)
    angles = [begin + turn * place / count for place in range(count + 1)]
    return [(x + shape.radius * cos(angle), y + shape.radius * sin(angle)) for angle in angles]


def _distance(a: Vector, b: Vector) -> float:
    """The squared distance between two points."""
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])


@lru_cache(maxsize=2)
def table_picture(times: int = 1) -> NDArray[np.uint8]:
    """The colours of the whole picture, `times` as large, with the empty table in it, of shape (width, height, 3)."""
    world = carom.scenes.pool().build()
    return TableArt(world, cloth_of(world, times)).picture()


class TableArt:
    """The painter of one table; `picture` is the finished picture of all that is round it too."""

    def __init__(self, world: carom.World, layout: Layout) -> None:
        self.layout = layout
        self.canvas = Canvas(layout.size, 3 if layout.times == 1 else 2)
        self.pockets = pockets(world)
        self.holes = [(layout.pixel(arc.center), arc.radius * layout.scale) for arc in self.pockets]
        self.inside = self.canvas.polygon([layout.pixel(corner) for corner in outline(rim(world))])
        columns, lines = np.meshgrid(np.arange(layout.size[0]), np.arange(layout.size[1]), indexing="ij")
        self.x = ((columns + 0.5 - layout.left) / layout.scale).astype(np.float32)
        self.y = (layout.height - (lines + 0.5 - layout.top) / layout.scale).astype(np.float32)
        across, along = np.maximum(-self.x, self.x - layout.width), np.maximum(-self.y, self.y - layout.height)
        self.outward = np.maximum(across, along)
        self.sideways = across > along
        self.lamp = self._lamp()
        self.specks = self._noise(1, 1, 6)

    def picture(self) -> NDArray[np.uint8]:
        """The picture's colours."""
        self._paint_room()
        self._paint_wood()
        self._paint_cushions()
        self._paint_pocket_rims()
        self._paint_cloth()
        self._paint_holes()
        self._paint_sights()
        return self.canvas.picture()

    def _noise(self, wide: int, high: int, seed: int) -> Field:
        """Noise whose grain is so large in a picture that is not magnified."""
        times = self.layout.times
        return noise(self.layout.size, (wide * times, high * times), seed)

    def _blurred(self, field: Field, radius: float) -> Field:
        """A field softened over so many pixels of a picture that is not magnified."""
        return blurred(field, radius * self.layout.times)

    def _lamp(self) -> Field:
        """How bright the lamp above the table makes each pixel, 1 in the middle."""
        x = (self.x - self.layout.width / 2.0) / self.layout.width
        y = (self.y - self.layout.height * 0.54) / self.layout.height
        light = 1.06 / (1.0 + 1.15 * x * x + 0.62 * y * y)
        return np.asarray(light, np.float32)

    def _box(self, outward: float, corner: float) -> Field:
        """The mask of a box that is `outward` cm larger than the cloth on each side."""
        left, top = self.layout.pixel((-outward, self.layout.height + outward))
        width, height = self.layout.width + 2.0 * outward, self.layout.height + 2.0 * outward
        return self.canvas.box(
            left, top, width * self.layout.scale, height * self.layout.scale, corner * self.layout.scale
        )

    def _paint_room(self) -> None:
        """Paint the dark room, a little of the lamp on its floor, and the table's shadow there."""
        glow = np.clip(self.lamp, 0.0, 1.0) ** 3
        self.canvas.light[:] = ROOM
        self.canvas.light += (glow * 16.0)[..., None] * np.array((0.9, 1.0, 1.15), np.float32)
        shadow = np.roll(self._box(RAIL + 0.5, 8.0), 9 * self.layout.times, axis=1)
        self.canvas.darken(self._blurred(shadow, 16) * np.float32(0.8))

    def _paint_wood(self) -> None:
        """Paint the rails, their grain along them, bevelled to both sides."""
        grain = np.where(
            self.sideways,
            self._noise(2, 90, 1) * 0.7 + self._noise(9, 260, 2),
            self._noise(90, 2, 3) * 0.7 + self._noise(260, 9, 4),
        )
        across = np.clip((self.outward - CUSHION) / (RAIL - CUSHION), 0.0, 1.0)
        bevel = 0.68 + 0.42 * np.sin(np.pi * np.clip(across * 0.9 + 0.08, 0.0, 1.0)) ** 0.7
        # The lamp hangs above the middle: the side of a rail that looks there is brighter.
        shade = bevel * (1.12 - 0.22 * across) * (0.94 + 0.13 * grain) * (0.45 + 0.6 * self.lamp)
        mitre = np.abs(
            np.abs(self.x - self.layout.width / 2.0)
            - np.abs(self.y - self.layout.height / 2.0)
            - (self.layout.width - self.layout.height) / 2.0
        )
        shade = shade * (1.0 - 0.35 * np.exp(-((mitre * 3.0) ** 2)))
        mask = self._box(RAIL, 7.0)
        self.canvas.paint(mask, WOOD, shade.astype(np.float32))
        edge = np.clip(mask - self._box(RAIL - 0.55, 6.5), 0.0, 1.0)
        self.canvas.paint(edge * np.float32(0.5), (226, 164, 108), self.lamp)
        self.canvas.darken(
            np.clip(self._box(CUSHION + 0.9, 1.0) - self._box(CUSHION, 0.5), 0.0, 1.0) * np.float32(0.55)
        )

    def _paint_cushions(self) -> None:
        """Paint the cushions: their slope from the nose to the rail, and the dark seam at their back."""
        depth = np.clip(self.outward / CUSHION, 0.0, 1.0)
        nose = np.exp(-(((self.outward - 0.7) / 0.55) ** 2))
        shade = (0.90 + 0.34 * nose - 0.24 * depth) * self.lamp * (1.0 + 0.004 * self.specks)
        self.canvas.paint(self._box(CUSHION, 0.5), CUSHION_CLOTH, shade.astype(np.float32))

    def _paint_pocket_rims(self) -> None:
        """Paint brass and leather round the pockets."""
        outside = self._box(RAIL - 0.7, 6.4) * (1.0 - self.inside)
        brass = self.canvas.polygons([self._pie(arc, 3.3) for arc in self.pockets]) * outside
        leather = self.canvas.polygons([self._pie(arc, 2.5) for arc in self.pockets]) * outside
        self.canvas.darken(self._blurred(brass, 5) * outside * np.float32(0.5))
        # Brushed brass gleams in two directions, seen from the middle of each pocket.
        gleam = np.zeros(self.layout.size, np.float32)
        for arc in self.pockets:
            dx, dy = self.x - arc.center[0], self.y - arc.center[1]
            near = dx * dx + dy * dy < 150.0
            gleam[near] = 0.5 + 0.5 * np.cos(3.0 * np.arctan2(dy[near], dx[near]) - 0.9)
        self.canvas.paint(brass, BRASS, ((0.55 + 0.75 * gleam) * (0.45 + 0.6 * self.lamp)).astype(np.float32))
        self.canvas.paint(leather, LEATHER, (0.55 + 0.5 * self.lamp).astype(np.float32))

    def _pie(self, arc: carom.Arc, margin: float) -> list[Vector]:
        """The corners, in pixels, of the piece of a disc that an arc bounds, `margin` cm larger."""
        (x, y), grown = arc.center, (arc.radius + margin) / arc.radius
        rim_points = [(x + (px - x) * grown, y + (py - y) * grown) for px, py in _points(arc)]
        return [self.layout.pixel(place) for place in [(x, y), *rim_points]]

    def _paint_cloth(self) -> None:
        """Paint the cloth: its weave, its lines, and the shadow that the cushions cast on it."""
        weave = 1.0 + 0.004 * self.specks + 0.012 * self._noise(30, 30, 8)
        self.canvas.paint(self.inside, CLOTH, (weave * self.lamp).astype(np.float32))
        quarter, middle = self.layout.width / 4.0, self.layout.height / 2.0
        line = np.exp(-(((self.x - quarter) / 0.22) ** 2)) * self.inside
        self.canvas.paint((line * 0.16).astype(np.float32), (255, 255, 255))
        spots = [(self.layout.pixel((quarter * part, middle)), 0.75 * self.layout.scale) for part in (1, 2, 3)]
        self.canvas.paint(self.canvas.discs(spots) * np.float32(0.3), (245, 250, 245))
        overhang = self._blurred(1.0 - self.inside, 9)
        self.canvas.darken((overhang * self.inside * 0.62).astype(np.float32))

    def _paint_holes(self) -> None:
        """Paint what is seen of the pockets from above: the dark, and a lip that catches light."""
        discs = self.canvas.discs(self.holes) * self.inside
        self.canvas.paint(discs, (7, 7, 8))
        lip = np.clip(
            discs - self.canvas.discs([(center, radius - 2.5 * self.layout.times) for center, radius in self.holes]),
            0.0,
            1.0,
        )
        self.canvas.paint(lip * np.float32(0.8), (58, 47, 42), self.lamp)

    def _paint_sights(self) -> None:
        """Paint the sights: eighths of the length and quarters of the width."""
        width, height, out = self.layout.width, self.layout.height, (CUSHION + RAIL) / 2.0 + 0.4
        places = [(width * part / 8.0, y) for part in (1, 2, 3, 5, 6, 7) for y in (-out, height + out)]
        places += [(x, height * part / 4.0) for part in (1, 2, 3) for x in (-out, width + out)]
        for half, colour, strength in ((1.5, (40, 20, 12), 0.8), (1.15, PEARL, 1.0)):
            diamonds = [[self.layout.pixel(corner) for corner in _diamond(place, half)] for place in places]
            self.canvas.paint(self.canvas.polygons(diamonds) * np.float32(strength), colour, self.lamp)


def _diamond(place: Vector, half: float) -> list[Vector]:
    """The corners of a sight."""
    x, y = place
    return [(x - half, y), (x, y - half), (x + half, y), (x, y + half)]
