"""Where the world lies in a picture: the stage it is shown on, and the panel of words beside it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.shapes.aabb import Aabb

if TYPE_CHECKING:
    from carom.draw.painter import Vector

#: Pixels: the longer side of the stage.
STAGE_SIZE = 920.0
#: Pixels between the picture's edge, the stage and the panel.
MARGIN = 20.0
#: Pixels between the stage's edge and the outermost shape.
PADDING = 16.0
#: Pixels: the panel beside the stage.
PANEL_WIDTH = 224.0


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture's layout: its size in pixels, its stage in world coordinates, and the way between the two."""

    width: float
    height: float
    stage: Aabb
    scale: float  # pixels per unit of length
    stage_left: float  # pixels
    stage_top: float

    @classmethod
    def around(cls, box: Aabb, panel_height: float) -> Frame:
        """The frame that shows `box`, its longer side as long as a stage may be, beside a panel of some height."""
        longer = max(box.right - box.left, box.top - box.bottom)
        if not longer > 0.0:
            box, longer = widened(box, 0.5), 1.0
        scale = (STAGE_SIZE - 2.0 * PADDING) / longer
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


def widened(box: Aabb, length: float) -> Aabb:
    """`box` with `length` added on all four sides."""
    return Aabb(box.left - length, box.bottom - length, box.right + length, box.top + length)
