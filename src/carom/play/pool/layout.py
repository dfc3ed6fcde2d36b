"""Where the table lies in the window, in pixels, and the colours of everything."""

from __future__ import annotations

from typing import TypeAlias

from carom.play.pool.game import Vector

Colour: TypeAlias = tuple[int, int, int]

#: Pixels: the window.
SIZE = (1200, 720)

#: Pixels in a centimetre.
SCALE = 3.9

#: cm: from the noses of the cushions to their backs, and to the table's outer edge.
CUSHION, RAIL = 4.9, 15.0

#: Pixels: the table's left and top outer edges.
MARGIN_LEFT, MARGIN_TOP = 26.0, 60.0

ROOM: Colour = (13, 15, 19)
IVORY: Colour = (245, 240, 226)
GOLD: Colour = (255, 201, 92)
MUTED: Colour = (154, 160, 170)
GOOD: Colour = (120, 214, 150)
BAD: Colour = (255, 122, 110)
CLOTH: Colour = (26, 121, 108)
CUSHION_CLOTH: Colour = (19, 96, 88)
WOOD: Colour = (104, 56, 33)


class Layout:
    """The way between the table's centimetres, y up, and the picture's pixels, y down.

    `width` and `height` are those of the cloth between the noses of the cushions, whose lower left corner is (0, 0);
    the picture is `times` as large as `SIZE`, and has `scale` pixels in a centimetre.
    """

    def __init__(self, width: float, height: float, times: int = 1) -> None:
        self.width, self.height = width, height
        self.times, self.scale = times, SCALE * times
        self.size = SIZE[0] * times, SIZE[1] * times
        self.left = MARGIN_LEFT * times + RAIL * self.scale
        self.top = MARGIN_TOP * times + RAIL * self.scale

    def pixel(self, place: Vector) -> Vector:
        """Where a place of the table is in the picture."""
        return self.left + place[0] * self.scale, self.top + (self.height - place[1]) * self.scale

    def place(self, pixel: Vector) -> Vector:
        """The place of the table at a pixel: the inverse of `pixel`."""
        return (pixel[0] - self.left) / self.scale, self.height - (pixel[1] - self.top) / self.scale

    def distance_to_edge(self, place: Vector, direction: Vector) -> float:
        """How far it is from a place to the edge of the cloth along a unit vector, in cm; 0 from beyond it."""
        ways = [
            ((side if along > 0.0 else 0.0) - at) / along
            for at, along, side in zip(place, direction, (self.width, self.height), strict=True)
            if along != 0.0
        ]
        return max(min(ways), 0.0)

    @property
    def center(self) -> Vector:
        """The middle of the table in the picture."""
        return self.pixel((self.width / 2.0, self.height / 2.0))
