"""The slow twin of `carom.Worlds`: copies of one world that are stepped one after the other, from Python.

Names and meanings are those of `Worlds`; how fast it is, and how many threads it has, is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

import carom
from carom.rows.hit import BOUNCE, ENTER, HIT

#: A hit, and the index of the copy that it happened in.
HIT_IN_COPY = np.dtype([*HIT.descr, ("world", "i8")])
#: Hits of one shape of one copy.
COUNT = np.dtype([("impacts", "i8"), ("enters", "i8")])
#: The columns of balls that can be written to.
WRITABLE = (
    "position", "velocity", "radius", "mass", "elasticity", "friction", "layer", "collides_with", "sensor",
    "can_collide",
)  # fmt: skip


class SlowWorlds:
    """So many copies of a scene, a world, or the shipped scene of that name."""

    def __init__(self, scene: carom.Scene | carom.World | str, copies: int, threads: int | None = None) -> None:
        if isinstance(scene, str):
            scene = carom.scenes.by_name(scene)
        world = scene.build() if isinstance(scene, carom.Scene) else scene
        self.start = world.snapshot()
        self.worlds = [restored(self.start) for _ in range(copies)]
        self.balls = SlowBalls(self)
        self.shapes = SlowShapes(self)
        #: The columns of `counts`: what was hit, by id.
        self.ids = [part.id for shape in world.shapes for part in parts_of(shape)]
        self.counts = np.zeros((copies, len(self.ids)), COUNT)

    def __len__(self) -> int:
        return len(self.worlds)

    def __getitem__(self, copy: int) -> carom.World:
        self.balls.push()
        return restored(self.worlds[copy].snapshot())

    def load(self, copy: int, world: carom.World) -> None:
        """Make one copy what a world of the same shapes and balls is."""
        self.worlds[copy].restore(world.snapshot())
        self.balls.in_play[copy] = True
        self.balls.pull(copy, (*WRITABLE, "asleep"))

    def reset(self, where: Any = None) -> None:
        """Bring all copies to the start, or those of a mask, of indices, or of one index."""
        for copy in np.atleast_1d(np.arange(len(self))[slice(None) if where is None else where]):
            self.worlds[copy].restore(self.start)
            self.balls.in_play[copy] = True
            self.balls.pull(copy, (*WRITABLE, "asleep"))
            self.counts[copy] = 0

    def step(self, dt: float) -> NDArray[Any]:
        """Every hit of one step of `dt` seconds, copy by copy, each copy's in order of time."""
        self.balls.push()
        return np.concatenate([self._step(copy, dt) for copy in range(len(self))])

    def run(self, seconds: float, dt: float = 1 / 60) -> NDArray[Any]:
        """Every hit of `round(seconds / dt)` steps, copy by copy, each copy's in order of time."""
        found = [self.step(dt) for _ in range(round(seconds / dt))]
        hits = np.concatenate([np.zeros(0, HIT_IN_COPY), *found])
        return hits[np.argsort(hits["world"], kind="stable")]

    def _step(self, copy: int, dt: float) -> NDArray[Any]:
        """The hits of one copy's step; its balls that are not in play stay where they are."""
        world, parked = self.worlds[copy], ~self.balls.in_play[copy]
        before = world.balls.position[parked], world.balls.velocity[parked]
        hits = world.step(dt).view(np.ndarray)
        world.balls.position[parked], world.balls.velocity[parked] = before
        self.balls.pull(copy, ("position", "velocity", "asleep"))
        self._count(copy, hits)
        rows = np.zeros(len(hits), HIT_IN_COPY)
        for name in HIT.names or ():
            rows[name] = hits[name]
        rows["world"] = copy
        return rows

    def _count(self, copy: int, hits: NDArray[Any]) -> None:
        """Count the hits of one copy by shape."""
        for kind, shape in zip(hits["kind"], hits["shape"], strict=True):
            if shape in self.ids and kind in (BOUNCE, ENTER):
                self.counts[copy, self.ids.index(shape)]["impacts" if kind == BOUNCE else "enters"] += 1

    @property
    def time(self) -> NDArray[np.float64]:
        """Seconds since the start of each copy."""
        return np.array([world.time for world in self.worlds])

    @property
    def statistics(self) -> NDArray[Any]:
        """The counters of each copy."""
        tables = [world.statistics.as_dict() for world in self.worlds]
        return np.array([tuple(table.values()) for table in tables], [(name, "i8") for name in tables[0]])

    def digests(self) -> NDArray[Any]:
        """A hash of the state of each copy."""
        self.balls.push()
        return np.array([world.digest() for world in self.worlds])


class SlowBalls:
    """The balls of all copies, as columns of shape (copies, balls) or (copies, balls, 2)."""

    def __init__(self, worlds: SlowWorlds) -> None:
        self._worlds = worlds.worlds
        self.in_play = np.ones((len(self._worlds), len(self._worlds[0].balls)), bool)
        for name in (*WRITABLE, "asleep"):
            setattr(self, name, np.array([getattr(world.balls, name) for world in self._worlds]))

    def pull(self, copy: int, names: Sequence[str]) -> None:
        """Read columns from a copy, into the arrays that were handed out before."""
        for name in names:
            getattr(self, name)[copy] = getattr(self._worlds[copy].balls, name)

    def push(self) -> None:
        """Write into the copies what differs there from the columns; a ball that is not in play meets nothing."""
        for copy, world in enumerate(self._worlds):
            for name in WRITABLE:
                wanted = getattr(self, name)[copy]
                if name == "can_collide":
                    wanted = wanted & self.in_play[copy]
                column = getattr(world.balls, name)
                if column.tobytes() != wanted.tobytes():
                    column[:] = wanted


class SlowShapes:
    """The shapes and compounds of all copies, by name or by the scene's index."""

    def __init__(self, worlds: SlowWorlds) -> None:
        self._worlds = worlds

    def __len__(self) -> int:
        return len(self._worlds.worlds[0].shapes)

    def __getitem__(self, key: int | str) -> SlowShape:
        index = key
        if isinstance(key, str):
            names = [shape.name for shape in self._worlds.worlds[0].shapes]
            if key not in names:
                raise KeyError(key)
            index = names.index(key)
        return SlowShape([world.shapes[index] for world in self._worlds.worlds])  # type: ignore[index]


class SlowShape:
    """One shape or compound in all copies: what it has is an array over them, and is set by one or by a number."""

    def __init__(self, shapes: Sequence[carom.Shape | carom.Compound]) -> None:
        object.__setattr__(self, "shapes", shapes)

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name == "can_collide":
            return np.array([all(part.can_collide for part in parts_of(shape)) for shape in self.shapes])
        return np.array([getattr(shape, name) for shape in self.shapes])

    def __setattr__(self, name: str, values: Any) -> None:
        shape = (len(self.shapes), 2) if name in ("velocity", "position") else (len(self.shapes),)
        for one, value in zip(self.shapes, np.broadcast_to(values, shape).tolist(), strict=True):
            setattr(one, name, value)


def restored(snapshot: bytes) -> carom.World:
    """A new world of a snapshot."""
    world = carom.World()
    world.restore(snapshot)
    return world


def parts_of(shape: carom.Shape | carom.Compound) -> list[carom.Shape]:
    """The shapes that hits may name: a compound's parts, or the shape itself."""
    return list(shape.shapes) if isinstance(shape, carom.Compound) else [shape]
