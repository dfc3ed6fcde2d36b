"""One of the toy's tables: its world, the parts that turn, and how many balls were put into it."""

from __future__ import annotations

import carom


class Table:
    """The scene `toy` as a world, with what the toy wants to know of it.

    Attributes:
        world: The world; balls that leave its bounds are taken out of it, and counted.
        launched: Balls that were ever put into it since it was last cleared.
    """

    def __init__(self) -> None:
        self.world: carom.World = carom.scenes.toy().build()
        self.world.remove_strays = True
        self.launched = len(self.world.balls)

    @property
    def in_play(self) -> int:
        """Balls that are in it now."""
        return len(self.world.balls)

    @property
    def strays(self) -> int:
        """Balls that got out through a wall since it was last cleared."""
        return self.world.statistics.strays

    def step(self, dt: float) -> carom.Hits:
        """Every hit of one step of `dt` seconds."""
        return self.world.step(dt)

    def launch(self, position: tuple[float, float], radius: float, speed: float) -> carom.Ball:
        """A new ball that goes straight up; as heavy as its area says, 1 at the radius of the scene's balls."""
        ball = carom.Ball(position, radius=radius, velocity=(0.0, speed), mass=(radius / USUAL_RADIUS) ** 2)
        self.launched += 1
        return self.world.add(ball)

    def clear(self) -> None:
        """Take all balls out and begin to count anew."""
        self.world.remove(*self.world.balls)
        self.world.statistics.reset()
        self.launched = 0

    def become(self, other: Table) -> None:
        """Make this the very same table as another, down to the bit."""
        self.world.restore(other.world.snapshot())
        self.launched = other.launched


#: The radius of the scene's own balls, whose mass is 1.
USUAL_RADIUS = 0.5
