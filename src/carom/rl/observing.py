"""Observations: numbers from -1 to 1, of all copies at once."""

from __future__ import annotations

from math import cos, sin
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from carom.rl.descriptors import Impulse
from carom.rl.names import Names
from carom.shapes.group import Group

if TYPE_CHECKING:
    from carom.rl.scoring import Score
    from carom.rl.task import Task
    from carom.shapes.aabb import Aabb
    from carom.shapes.compound import Compound
    from carom.shapes.shape import Shape
    from carom.worlds import Worlds

Seen: TypeAlias = NDArray[np.float32]
Floats: TypeAlias = NDArray[np.float64]


class Numbers:
    """What is seen of the worlds of a task as a list of numbers, in the order that `Observation` tells."""

    def __init__(self, task: Task, names: Names, worlds: Worlds, score: Score, box: Aabb) -> None:
        seen = task.observation
        self._worlds = worlds
        chosen = names.balls_like(seen.balls)
        self._count = len(chosen)
        # All of them are taken much faster by a slice.
        self._balls = slice(None) if self._count == len(names.balls) else chosen
        speeds = fastest(task, names)
        self._turning = [
            (worlds.shapes[index], stops_of(names.shapes[index]), speeds[index])
            for index in names.shapes_like(seen.turning)
        ]
        self._travelling = [(worlds.shapes[index], speeds[index]) for index in names.shapes_like(seen.travelling)]
        self._in_play, self._lights = score.in_play, score.lights.hit
        self._several = self._count > 1
        self._middle = np.array([box.left + box.right, box.bottom + box.top]) / 2.0
        self._half = np.array([box.right - box.left, box.top - box.bottom]) / 2.0
        # A box without a width or a height has everything in its middle.
        self._half[self._half == 0.0] = 1.0
        self._speed = seen.speed or task.scene.world.max_speed or 2.0 * float(self._half.max())
        turns = [3 if limits is None else 2 for _, limits, _ in self._turning]
        movers = sum(turns) + 4 * len(self._travelling)
        width = self._count * (4 + self._several) + movers + self._lights.shape[1]
        self.space = spaces.Box(-1.0, 1.0, (width,), np.float32)

    def see(self) -> Seen:
        """The observation of each copy, a new array of shape (copies, width)."""
        found: Seen = np.empty((len(self._worlds), *self.space.shape), np.float32)
        place = self._see_balls(found)
        for shape, limits, fastest in self._turning:
            place += see_orientation(shape.orientation, limits, found[:, place:])
            found[:, place] = shape.angular_velocity / fastest
            place += 1
        for shape, fastest in self._travelling:
            found[:, place : place + 2] = (shape.position - self._middle) / self._half
            found[:, place + 2 : place + 4] = shape.velocity / fastest
            place += 4
        found[:, place:] = self._lights
        return np.clip(found, -1.0, 1.0, out=found)

    def _see_balls(self, found: Seen) -> int:
        """Write what is seen of the balls; return how many numbers that is."""
        columns = 4 + self._several
        width = self._count * columns
        balls = found[:, :width].reshape(len(found), self._count, columns)  # a view
        in_play = self._in_play[:, self._balls]
        # Copied at once, for each copy's lie on a page of their own; then worked on number by number, for NumPy takes
        # ten times as long over pairs.
        numbers = np.empty((4, *in_play.shape))
        numbers[:2] = self._worlds.balls.position[:, self._balls].copy().transpose(2, 0, 1)
        numbers[2:] = self._worlds.balls.velocity[:, self._balls].copy().transpose(2, 0, 1)
        numbers[:2] -= self._middle[:, None, None]
        numbers[:2] /= self._half[:, None, None]
        numbers[2:] /= self._speed
        if not in_play.all():
            numbers *= in_play
        for column in range(4):
            balls[:, :, column] = numbers[column]
        if self._several:
            balls[:, :, 4] = in_play
        return width


def see_orientation(orientation: Floats, limits: tuple[float, float] | None, found: Seen) -> int:
    """Write what is seen of how far a shape is turned; return how many numbers that is."""
    if limits is None:
        # Not those of NumPy, which need not be the same for an angle alone and for one among many.
        found[:, 0] = [sin(angle) for angle in orientation.tolist()]
        found[:, 1] = [cos(angle) for angle in orientation.tolist()]
        return 2
    low, high = limits
    found[:, 0] = (2.0 * orientation - (low + high)) / ((high - low) or 1.0)
    return 1


def stops_of(shape: Shape | Compound | Group) -> tuple[float, float] | None:
    """The stops of what turns; None where it has none."""
    return None if isinstance(shape, Group) else shape.turn_limits


def fastest(task: Task, names: Names) -> dict[int, float]:
    """The speed of each shape, by its index, that is seen as 1: the top one of its actuators, or else its own."""
    speeds: dict[int, float] = {}
    for index, shape in enumerate(names.shapes):
        x, y = (0.0, 0.0) if isinstance(shape, Group) else shape.velocity
        spin = 0.0 if isinstance(shape, Group) else shape.angular_velocity
        speeds[index] = abs(spin) or float(np.sqrt(x * x + y * y)) or 1.0
    for actuator in task.actuators:
        if not isinstance(actuator, Impulse):
            (index,) = names.bearers(actuator.shape)
            speeds[index] = actuator.top_speed
    return speeds
