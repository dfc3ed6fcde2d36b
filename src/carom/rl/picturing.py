"""Pictures of a task's worlds, as arrays of pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.draw.live import Live
from carom.draw.parts.frame import LEAST_SIDE
from carom.draw.parts.layers import Layer
from carom.draw.parts.moment import Balls
from carom.draw.picture import box_around, looks_of
from carom.extras import needed
from carom.record.members import parts

if TYPE_CHECKING:
    from carom.scene import Scene
    from carom.shapes.aabb import Aabb
    from carom.world.world import World

#: Pixels: the longer side of what `render` gives.
LONGER_SIDE = 600
#: What is shown: the table and its balls, and nothing of the past.
LAYERS = (Layer.SENSORS, Layer.SHAPES, Layer.BALLS)


def table_box(world: World) -> Aabb:
    """The box around all shapes of a world, or around its balls where it has none."""
    return box_around(looks_of(world.shapes), Balls.of(world))


class Camera:
    """Takes pictures of worlds that are in one state or another of a scene; raises `MissingExtra` without pygame."""

    def __init__(self, scene: Scene, size: tuple[int, int] | None = None) -> None:
        self._pygame = needed("pygame", "pygame-ce", "draw", "pictures of environments")
        self._world = scene.build()
        box = table_box(self._world)
        self.size = size or fitting(box)
        changing = [part for part in parts(self._world.shapes) if part.once]
        self._live = Live(self._world, box, self.size, layers=LAYERS, changing=changing)
        self._surface = self._pygame.Surface(self.size)

    def take(self, world: World) -> NDArray[np.uint8]:
        """A picture of a world, of shape (height, width, 3)."""
        self._world.restore(world.snapshot())
        self._live.draw(self._surface)
        pixels: Any = self._pygame.surfarray.array3d(self._surface)
        return np.ascontiguousarray(pixels.swapaxes(0, 1))


def fitting(box: Aabb) -> tuple[int, int]:
    """The width and height in pixels of a picture that shows a box, and nothing beside it."""
    width, height = box.right - box.left, box.top - box.bottom
    scale = LONGER_SIDE / max(width, height)
    return max(LEAST_SIDE, round(width * scale)), max(LEAST_SIDE, round(height * scale))
