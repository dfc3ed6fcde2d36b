"""How an episode starts: the scene's state, with the balls off by what a copy's own random numbers say."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import cos, sin
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from carom.rl.names import Names
    from carom.rl.task import Task
    from carom.worlds import Worlds


#: The largest seed: so many a generator tells apart.
MOST_SEED = 2**128 - 1


def generators(seed: int | None, copies: Iterable[int]) -> list[np.random.Generator]:
    """A generator for each of some copies, spawned from one seed: the same for a copy, however many there are."""
    entropy = np.random.SeedSequence(seed).entropy
    children = (np.random.SeedSequence(entropy, spawn_key=(copy,)) for copy in copies)
    return [np.random.Generator(np.random.PCG64(child)) for child in children]


class Start:
    """Puts the balls of copies that begin."""

    def __init__(self, task: Task, names: Names) -> None:
        self._spreads = [(names.balls_like(spread.balls), spread) for spread in task.start]

    def put(self, worlds: Worlds, copies: Sequence[int], random: Sequence[np.random.Generator]) -> None:
        """Put the balls of some copies, which are at the scene's state, by the next numbers of their generators."""
        position, velocity = worlds.balls.position, worlds.balls.velocity
        for balls, spread in self._spreads:
            (wide, high), (across, up) = spread.position, spread.velocity
            for copy in copies:
                drawn = random[copy].uniform(-1.0, 1.0, (len(balls), 5)).tolist()
                for ball, (x, y, turn, vx, vy) in zip(balls, drawn, strict=True):
                    position[copy, ball] += (x * wide, y * high)
                    along, beside = velocity[copy, ball].tolist()
                    c, s = cos(turn * spread.angle), sin(turn * spread.angle)
                    velocity[copy, ball] = (c * along - s * beside + vx * across, s * along + c * beside + vy * up)
