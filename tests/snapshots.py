"""Snapshots taken apart and put together again, and a world in the middle of things to take them of."""

import hashlib
import io
from typing import Any, NamedTuple

import numpy as np

import carom
from carom.world.snapshot import HASH_SIZE, MAGIC
from tests.worlds import crowded


class Parts(NamedTuple):
    """What a snapshot is made of."""

    text: Any
    state: Any
    balls: Any
    shapes: Any
    relations: Any
    hits: Any
    courses: Any


def taken_apart(snapshot: bytes) -> Parts:
    """The parts of a snapshot."""
    file = io.BytesIO(snapshot[len(MAGIC) + HASH_SIZE :])
    return Parts(*[np.lib.format.read_array(file) for _ in Parts._fields])


def sealed(payload: bytes) -> bytes:
    """A snapshot with a hash that is right."""
    return MAGIC + hashlib.blake2b(payload, digest_size=HASH_SIZE).digest() + payload


def put_together(parts: Parts) -> bytes:
    """A snapshot of parts."""
    file = io.BytesIO()
    for part in parts:
        np.save(file, part)
    return sealed(file.getvalue())


def eventful() -> carom.World:
    """A world in the middle of things: with relations, pending hits, a sleeper, names, a compound."""
    world = crowded(sleep_speed=1.0)
    world.run(1.0)
    for shape in list(world.shapes):
        if shape.name == "eye":
            world.remove(shape)
    world.add(carom.Circle((6, 6), 5, sensor=True, solid=True))
    world.add(carom.Gate((5.0, 5.0), (7.0, 7.0)))
    world.add(carom.Ball((6.0, 6.2), 0.5, (-1, 1)))
    world.add(carom.Ball((6.3, 5.6), 0.5, (1, -1), sensor=True))
    world.step(0.001)
    world.remove(world.balls[-1])
    world.balls[2].name = "named"
    parts = taken_apart(world.snapshot())
    assert len(parts.relations) > 2
    assert len(parts.hits) > 0
    return world


def refused(world: carom.World, snapshot: bytes) -> bool:
    """Whether a snapshot was refused, and then left the world as it was."""
    before = world.snapshot(), [id(member) for member in (*world.shapes, *world.balls)]
    try:
        world.restore(snapshot)
    except carom.SnapshotError:
        assert (world.snapshot(), [id(member) for member in (*world.shapes, *world.balls)]) == before
        return True
    return False
