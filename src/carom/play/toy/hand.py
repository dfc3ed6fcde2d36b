"""The hand that drags a ball by the mouse and throws it."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from math import hypot
from typing import TypeAlias

import carom
from carom.play.toy.table import Table

Vector: TypeAlias = tuple[float, float]

#: Seconds: a throw has the velocity that the mouse had, on average, for so long before.
MEMORY = 0.1
#: Seconds without an event of the mouse after which it has stopped.
STILL = 0.05
#: How much of the way to the mouse a held ball goes in a step.
EAGERNESS = 0.5
#: In radii a motion iteration: how fast a held ball is at most, so that walls hold it.
MOST_RADII = 0.5
#: The fastest that the mouse throws, in units a second.
FASTEST = 150.0


class Hand:
    """Holds one ball of each table, the same in all, and follows the mouse.

    While it is held a ball is given a velocity towards the mouse, so it meets walls and other balls as ever; what it is
    let go with is the mouse's own velocity.

    Attributes:
        ball: The id of the ball that is held, or None.
        target: Where the mouse is, on the table.
    """

    def __init__(self) -> None:
        self.ball: int | None = None
        self.target: Vector = (0.0, 0.0)
        self._way: deque[tuple[float, Vector]] = deque()
        self._time = 0.0

    def take(self, ball: carom.Ball, target: Vector) -> None:
        """Take hold of a ball."""
        self.ball = ball.id
        self._way.clear()
        self.move(target)

    def move(self, target: Vector) -> None:
        """Take the mouse to be somewhere else now."""
        self.target = target
        self._way.append((self._time, target))

    def wait(self, seconds: float) -> None:
        """Go on by so much real time."""
        self._time += seconds
        while len(self._way) > 1 and self._way[1][0] <= self._time - MEMORY:
            self._way.popleft()

    @property
    def velocity(self) -> Vector:
        """The velocity of the mouse, in units of the table a real second."""
        if not self._way:
            return 0.0, 0.0
        # A mouse that has just moved moves still; one that has not for a while has stopped.
        last = self._way[-1][0]
        end = last if self._time - last < STILL else self._time
        (began, (x, y)), then = self._way[0], end - MEMORY
        if began < then and len(self._way) > 1:
            after, (next_x, next_y) = self._way[1]
            part = min(1.0, (then - began) / (after - began))
            x, y = x + part * (next_x - x), y + part * (next_y - y)
        seconds = max(end - max(began, then), 1e-3)
        vx, vy = (self.target[0] - x) / seconds, (self.target[1] - y) / seconds
        scale = min(1.0, FASTEST / max(hypot(vx, vy), 1e-9))
        return scale * vx, scale * vy

    def pull(self, tables: Sequence[Table], dt: float) -> None:
        """Send the held ball of each table towards the mouse for a step of `dt`."""
        for ball in self.held(tables):
            (x, y), world = ball.position, ball.world
            vx, vy = EAGERNESS * (self.target[0] - x) / dt, EAGERNESS * (self.target[1] - y) / dt
            most = MOST_RADII * ball.radius * world.substeps / dt
            scale = min(1.0, most / max(hypot(vx, vy), 1e-9))
            ball.velocity = (scale * vx, scale * vy)

    def throw(self, tables: Sequence[Table]) -> None:
        """Let the ball go with the velocity of the mouse."""
        for ball in self.held(tables):
            ball.velocity = self.velocity
        self.drop()

    def drop(self) -> None:
        """Let go of whatever is held."""
        self.ball = None

    def held(self, tables: Sequence[Table]) -> list[carom.Ball]:
        """The held ball in each table that still has it."""
        if self.ball is None:
            return []
        found = [table.world.object(self.ball) for table in tables if self.ball in table.world.balls.id]
        return [ball for ball in found if isinstance(ball, carom.Ball)]
