"""Where the world lies in a picture: the stage it is shown on, and the panel of words beside it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil
from typing import TYPE_CHECKING, TypeAlias

from carom.checks import whole
from carom.shapes.aabb import Aabb

if TYPE_CHECKING:
    from carom.draw.paint.painter import Vector

#: How large a picture is to be, in pixels: its width and height, its longer side, or None for what suits it.
Size: TypeAlias = tuple[int, int] | int | None

#: Pixels: the sides that a picture may have.
LEAST_SIDE, MOST_SIDE = 64, 8192
#: Pixels: the longer side of the stage.
STAGE_SIZE = 920.0
#: Pixels between the picture's edge, the stage and the panel.
MARGIN = 20.0
#: Pixels between the stage's edge and the outermost shape.
PADDING = 16.0
#: Pixels: the panel beside the stage.
PANEL_WIDTH = 224.0
#: Pixels: a stage beside a panel is at least so wide. Pictures that would not have that much are without a panel.
LEAST_STAGE = 300.0
#: Pixels: in larger pictures than this, words and lines are larger too.
FULL_WIDTH, FULL_HEIGHT = 1184.0, 720.0
#: Pixels: the margin of pictures without a panel.
BARE_MARGIN = 8.0
#: Words are not shrunk further than this; where they would be, there is no panel.
LEAST_ZOOM = 0.85
#: A side shorter than this part of the longer one does not say how large the rest is drawn.
THIN = 1e-6


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture's layout: its size in pixels, its stage in world coordinates, and the way between the two.

    Widths of lines and heights of letters are the same number of pixels in every layout. `zoom` says how many pixels
    of the finished picture are one of the layout.
    """

    width: float
    height: float
    stage: Aabb
    scale: float  # pixels per unit of length
    stage_left: float  # pixels
    stage_top: float
    panel: bool = True
    zoom: float = 1.0

    @classmethod
    def around(cls, box: Aabb, panel_height: float) -> Frame:
        """The frame that shows `box`, its longer side as long as a stage may be, beside a panel of some height."""
        scale = (STAGE_SIZE - 2.0 * PADDING) / longer_side(box)
        stage = widened(box, PADDING / scale)
        stage_width = (stage.right - stage.left) * scale
        stage_height = (stage.top - stage.bottom) * scale
        inner_height = max(stage_height, panel_height)
        return cls(
            width=round(stage_width + PANEL_WIDTH + 3.0 * MARGIN),
            height=round(inner_height + 2.0 * MARGIN),
            stage=stage,
            scale=scale,
            stage_left=MARGIN,
            stage_top=MARGIN + 0.5 * (inner_height - stage_height),
        )

    @classmethod
    def fit(cls, box: Aabb, panel_height: float, size: Size) -> Frame:
        """The frame that shows `box` in a picture of a size, beside a panel of some height if there is room for it."""
        if size is None:
            return cls.around(box, panel_height)
        for side in size if isinstance(size, tuple) else (size,):
            whole("size", side, LEAST_SIDE, MOST_SIDE)
        if isinstance(size, tuple):
            width, height = size
            zoom = max(1.0, min(width / FULL_WIDTH, height / max(FULL_HEIGHT, panel_height + 2.0 * MARGIN)))
            return cls._within(box, panel_height, width / zoom, height / zoom, zoom)
        full = cls.around(box, panel_height)
        zoom = size / max(full.width, full.height)
        if zoom >= LEAST_ZOOM:
            return replace(full, zoom=zoom)
        if box.right == box.left and box.top == box.bottom:
            return cls._within(box, panel_height, size, size, 1.0)
        scale = (size - 2.0 * (BARE_MARGIN + PADDING)) / longer_side(box)
        around = 2.0 * (BARE_MARGIN + PADDING)
        width = ceil((box.right - box.left) * scale + around)
        return cls._within(box, panel_height, width, ceil((box.top - box.bottom) * scale + around), 1.0)

    @classmethod
    def _within(cls, box: Aabb, panel_height: float, width: float, height: float, zoom: float) -> Frame:
        """The frame of a layout of some width and height."""
        panel = width >= LEAST_STAGE + PANEL_WIDTH + 3.0 * MARGIN and height >= panel_height + 2.0 * MARGIN
        margin = MARGIN if panel else BARE_MARGIN
        beside = PANEL_WIDTH + MARGIN if panel else 0.0
        room_width, room_height = width - beside - 2.0 * margin, height - 2.0 * margin
        rooms = ((room_width, box.right - box.left), (room_height, box.top - box.bottom))
        thin = THIN * longer_side(box)
        scales = [(room - 2.0 * PADDING) / extent for room, extent in rooms if extent > thin]
        scale = min(scales, default=min(room_width, room_height) - 2.0 * PADDING)
        stage = widened(box, PADDING / scale)
        stage_width, stage_height = (stage.right - stage.left) * scale, (stage.top - stage.bottom) * scale
        return cls(
            width=width,
            height=height,
            stage=stage,
            scale=scale,
            stage_left=margin + 0.5 * (room_width - stage_width),
            stage_top=margin + 0.5 * (room_height - stage_height),
            panel=panel,
            zoom=zoom,
        )

    @property
    def pixels(self) -> tuple[int, int]:
        """Width and height of the finished picture."""
        return round(self.width * self.zoom), round(self.height * self.zoom)

    @property
    def panel_left(self) -> float:
        """The panel's left edge, in pixels."""
        return self.stage_left + (self.stage.right - self.stage.left) * self.scale + MARGIN

    def pixel(self, x: float, y: float) -> Vector:
        """Where the world's point (x, y) lies, in pixels from the picture's top left corner."""
        return self.stage_left + (x - self.stage.left) * self.scale, self.stage_top + (self.stage.top - y) * self.scale

    def world(self, pixel_x: float, pixel_y: float) -> Vector:
        """The world's point that lies at a pixel: the inverse of `pixel`."""
        return (
            self.stage.left + (pixel_x - self.stage_left) / self.scale,
            self.stage.top - (pixel_y - self.stage_top) / self.scale,
        )

    def units(self, pixels: float) -> float:
        """A length in the world's units."""
        return pixels / self.scale

    def shows(self, x: float, y: float) -> bool:
        """Whether the world's point (x, y) is on the stage."""
        return self.stage.left <= x <= self.stage.right and self.stage.bottom <= y <= self.stage.top


def longer_side(box: Aabb) -> float:
    """The longer side of a box, or 1 for one without extent."""
    return max(box.right - box.left, box.top - box.bottom) or 1.0


def widened(box: Aabb, length: float) -> Aabb:
    """`box` with `length` added on all four sides."""
    return Aabb(box.left - length, box.bottom - length, box.right + length, box.top + length)
