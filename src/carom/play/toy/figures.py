"""The figures on the panel: how many tests and collisions there are, an iteration and a second."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Any

import carom
from carom import draw
from carom.play.toy.table import Table
from carom.play.window import RATE

#: Seconds between two readings, and seconds that a rate is the mean of.
PAUSE, MEMORY = 0.2, 1.0
COUNTED = ("box_tests", "full_tests", "collisions")
#: Settings that say how many box tests an iteration makes.
ALIKE = ("detection", "broad_phase", "levels", "gravity", "max_speed")


@dataclass(frozen=True, slots=True)
class Rates:
    """Tests and collisions of one table.

    Attributes:
        box_tests_once: Box tests of one iteration.
        box_tests: Box tests a second.
        full_tests: Full tests a second.
        collisions: Collisions a second.
    """

    box_tests_once: int = 0
    box_tests: float = 0.0
    full_tests: float = 0.0
    collisions: float = 0.0


@dataclass(frozen=True, slots=True)
class Tree:
    """The broad phase of the shapes at rest: a quadtree's nodes and leaves, or a grid's cells that hold something.

    Attributes:
        nodes: Nodes of the quadtree, 0 where there is none.
        leaves: Leaves, 0 where there is none.
        width: Width of the smallest leaf or cell that holds shapes.
        height: Its height.
        most: The most shapes in one.
    """

    nodes: int
    leaves: int
    width: float
    height: float
    most: int


def tree_of(world: carom.World) -> Tree:
    """What the broad phase of a world looks like."""
    partition = draw.partition_of(world)
    boxes = [cell.box for cell in partition.cells]
    return Tree(
        partition.nodes,
        partition.leaves,
        min((box.width for box in boxes), default=0.0),
        min((box.height for box in boxes), default=0.0),
        max((cell.shapes for cell in partition.cells), default=0),
    )


class Figures:
    """Reads a table's counters a few times a second.

    Attributes:
        rates: What was read last.
    """

    def __init__(self, table: Table) -> None:
        self._table = table
        self._readings: deque[tuple[float, list[int]]] = deque()
        self._twin = Twin(table.world)
        self._time = 0.0
        self.rates = Rates()
        self._read()

    def wait(self, seconds: float) -> bool:
        """Whether there are new figures, now that so much real time has gone by."""
        self._time += seconds
        if self._time - self._readings[-1][0] < PAUSE:
            return False
        self._read()
        return True

    def _read(self) -> None:
        """Read the counters, and what they say of the time since the oldest reading that counts."""
        statistics = self._table.world.statistics.as_dict()
        counts = [statistics[name] for name in COUNTED]
        if self._readings and counts < self._readings[-1][1]:
            self._readings.clear()  # the table was cleared
        self._readings.append((self._time, counts))
        while self._readings[0][0] < self._time - MEMORY - PAUSE:
            self._readings.popleft()
        began, before = self._readings[0]
        seconds = max(self._time - began, 1e-9)
        rates = [(now - then) / seconds for now, then in zip(counts, before, strict=True)]
        self.rates = Rates(self._twin.box_tests(), *rates)


class Twin:
    """A second world with the same shapes, in which one iteration is made to count its box tests."""

    def __init__(self, world: carom.World) -> None:
        self._world = world
        self._twin: carom.World = carom.Scene(shapes=list(world.shapes)).build()
        self._twin.substeps = self._twin.iterations = 1
        pairs = zip(self._twin.shapes, world.shapes, strict=True)
        self._turning: list[tuple[Any, Any]] = [pair for pair in pairs if isinstance(pair[0], carom.Compound)]

    def box_tests(self) -> int:
        """The box tests of the first iteration that would be made now, if all balls were awake."""
        world, twin = self._world, self._twin
        # What is set anew has the twin look at all of its shapes anew, so only what has changed is.
        for name in ALIKE:
            if getattr(twin, name) != getattr(world, name):
                setattr(twin, name, getattr(world, name))
        for ours, theirs in self._turning:
            if ours.orientation != theirs.orientation:
                ours.orientation = theirs.orientation
        self._copy_balls()
        twin.statistics.reset()
        twin.step(1.0 / (RATE * world.substeps))
        return twin.statistics.box_tests

    def _copy_balls(self) -> None:
        """Put as many balls into the twin, and make them alike."""
        balls, copies = self._world.balls, self._twin.balls
        missing = len(balls) - len(copies)
        if missing > 0:
            self._twin.add_balls(balls.position[:missing], radius=1.0)
        for ball in copies[len(balls) :]:
            self._twin.remove(ball)
        for name in ("position", "velocity", "radius"):
            getattr(copies, name)[:] = getattr(balls, name)
