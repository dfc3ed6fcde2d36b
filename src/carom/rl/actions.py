"""Actions: the space of those that a task takes, and what each does to all copies of its world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from carom.checks import refuse
from carom.rl.descriptors import Impulse, Travel, Turn

if TYPE_CHECKING:
    from carom.rl.names import Names
    from carom.rl.task import Task
    from carom.worlds import Worlds
    from carom.worlds.balls import CopiesOfBalls
    from carom.worlds.shapes import CopiesOfShape

Floats = NDArray[np.float64]


class _Drive(Protocol):
    """What one actuator does."""

    def act(self, values: Floats, seconds: float) -> None:
        """Do what the action says, `values` for each copy, to what is driven, for so many seconds."""


@dataclass(frozen=True, slots=True)
class _Turning:
    """A shape that is turned."""

    shape: CopiesOfShape

    def act(self, values: Floats, seconds: float) -> None:  # noqa: ARG002  # what turns has stops of its own
        self.shape.angular_velocity = values[:, 0]


@dataclass(frozen=True, slots=True)
class _Travelling:
    """A shape that is moved along a line."""

    shape: CopiesOfShape
    start: Floats
    way: Floats
    limits: tuple[float, float] | None

    def act(self, values: Floats, seconds: float) -> None:
        speeds = values[:, 0]
        if self.limits is not None:
            along = self.shape.position - self.start
            gone = along[:, 0] * self.way[0] + along[:, 1] * self.way[1]
            # So that it is at the end of its way when the step is over, and not beyond.
            speeds = (np.clip(gone + speeds * seconds, *self.limits) - gone) / seconds
        self.shape.velocity = speeds[:, None] * self.way


@dataclass(frozen=True, slots=True)
class _Struck:
    """A ball that is struck."""

    balls: CopiesOfBalls
    ball: int
    speed: float

    def act(self, values: Floats, seconds: float) -> None:  # noqa: ARG002  # it is over at once
        length = np.sqrt(values[:, 0] * values[:, 0] + values[:, 1] * values[:, 1])
        strokes = values * (self.speed / np.maximum(length, 1.0))[:, None]
        self.balls.velocity[:, self.ball] += strokes * self.balls.in_play[:, self.ball, None]


class Actions:
    """What the actions of a task are, and what they do.

    `space` is `Discrete`, `MultiDiscrete` where there are several actuators, or a `Box` from -1 to 1.
    """

    def __init__(self, task: Task, names: Names, worlds: Worlds) -> None:
        self._copies = len(worlds)
        self._drives = [_drive(actuator, names, worlds) for actuator in task.actuators]
        self._seconds = task.seconds
        self._tables: list[Floats] = []
        self._scales: list[float] = []
        self._widths = [2 if isinstance(actuator, Impulse) else 1 for actuator in task.actuators]
        for actuator in task.actuators:
            if isinstance(actuator, Impulse):
                self._scales += [1.0, 1.0]  # the stroke has its speed
            elif actuator.speed is not None:
                self._scales.append(actuator.speed)
            else:
                self._tables.append(np.array(actuator.speeds))
        self.space = self._space()

    def _space(self) -> spaces.Discrete | spaces.MultiDiscrete | spaces.Box:
        """The space of single actions."""
        counts = [len(table) for table in self._tables]
        if not counts:
            return spaces.Box(-1.0, 1.0, (len(self._scales),), np.float32)
        return spaces.Discrete(counts[0]) if len(counts) == 1 else spaces.MultiDiscrete(counts)

    def act(self, actions: Any) -> None:
        """Do what the `actions` say, one for each copy; raise `InvalidArgument` before any, where one is none."""
        values = self._values(actions)
        first = 0
        for drive, width in zip(self._drives, self._widths, strict=True):
            drive.act(values[:, first : first + width], self._seconds)
            first += width

    def _values(self, actions: Any) -> Floats:
        """The speeds, or parts of strokes, that the actions stand for, of shape (copies, width)."""
        copies, width = self._copies, len(self._tables) or len(self._scales)
        shape = (copies,) if isinstance(self.space, spaces.Discrete) else (copies, width)
        given = np.asarray(actions)
        if given.shape != shape:
            raise refuse("actions", f"must be of shape {shape}", given.shape)
        given = given.reshape(copies, width)
        if self._tables:
            return self._chosen(given)
        if given.dtype.kind not in "iuf" or not np.isfinite(given).all():
            raise refuse("actions", "must be finite numbers", actions)
        return np.clip(given.astype(np.float64), -1.0, 1.0) * self._scales

    def _chosen(self, given: NDArray[Any]) -> Floats:
        """The speeds of values that choose them."""
        counts = [len(table) for table in self._tables]
        if given.dtype.kind not in "iu" or given.min() < 0 or (given >= counts).any():
            raise refuse("actions", f"must be whole numbers, each less than that of {counts}", given)
        # Each actuator's stand together.
        return np.array([table[given[:, place]] for place, table in enumerate(self._tables)]).T


def _drive(actuator: Turn | Travel | Impulse, names: Names, worlds: Worlds) -> _Drive:
    """What an actuator drives."""
    if isinstance(actuator, Impulse):
        return _Struck(worlds.balls, names.balls.index(actuator.ball), actuator.speed)
    (index,) = names.bearers(actuator.shape)
    if isinstance(actuator, Turn):
        return _Turning(worlds.shapes[index])
    way = np.array(actuator.direction)
    return _Travelling(
        worlds.shapes[index],
        np.array(names.shapes[index].position),
        way / np.sqrt(way[0] * way[0] + way[1] * way[1]),
        actuator.limits,
    )
