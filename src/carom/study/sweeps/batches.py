"""Runs whose scenes differ only in where balls start and how fast: their worlds are copies that one call steps.

Each copy comes to the bits that its world would come to alone, see `Worlds`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from carom.study.sweeps.grid import Run
from carom.study.sweeps.sources import Source

if TYPE_CHECKING:
    from carom.scene import Scene
    from carom.world import Hits, World

#: Copies that are stepped together at most; more of them would only take more memory, with their hits.
MOST_TOGETHER = 256


def batches(source: Source, runs: Sequence[Run]) -> list[list[int]]:
    """The places of runs, those together that may be copies of one world."""
    found: dict[str | int, list[int]] = {}
    full: list[list[int]] = []
    for place, run in enumerate(runs):
        likeness = source.likeness(run)
        key = place if likeness is None else likeness
        found.setdefault(key, []).append(place)
        if len(found[key]) == MOST_TOGETHER:
            full.append(found.pop(key))
    return [*full, *found.values()]


def ends(scenes: Sequence[Scene], seconds: float, dt: float) -> Iterator[tuple[World, Hits] | None]:
    """The world of each scene at its end, with its hits; None where it has lost a ball, and has to be run alone.

    The scenes are those of a batch. The worlds are one and the same, which becomes one after the other. Raises what a
    run of `Worlds` raises.
    """
    from carom.worlds import Worlds  # here, so that sweeps can be listed and looked at without a compiler
    from carom.worlds.hits import hits_of

    world = scenes[0].build()
    copies = Worlds(world, len(scenes), threads=1)
    position, velocity = copies.balls.position, copies.balls.velocity
    for copy, scene in enumerate(scenes):
        position[copy] = np.reshape([ball.position for ball in scene.balls], (-1, 2))
        velocity[copy] = np.reshape([ball.velocity for ball in scene.balls], (-1, 2))
    hits = copies.run(seconds, dt)
    for copy in range(len(scenes)):
        if copies.balls.in_play[copy].all():
            copies.store(copy, world)
            yield world, hits_of(hits, copy, world)
        else:
            yield None
