"""Prints digests of every shipped scene and of rooms of every kind of shape, in both modes.

`python -m tests.determinism.scene_digests [steps]` before and after a change; equal output is the proof. To compare
two states of the sources, run it twice with `PYTHONPATH` at one `src` and at the other.
"""

import hashlib
import sys
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

import carom
from tests.worlds import bits, crowded

STEPS = 120
DT = 1 / 60
#: Each scene is asked this many times along each axis what is near.
ASKED = 24


def worlds() -> dict[str, Callable[[], carom.World]]:
    """What makes each world to be run, by name: the shipped scenes as they come, and rooms of every kind of shape."""
    shipped = {name: partial(_shipped, name) for name in carom.scenes.names()}
    return shipped | {"crowded": crowded, "crowded_tree": partial(crowded, seed=1, broad_phase="quadtree")}


def _shipped(name: str) -> carom.World:
    """The world of a shipped scene, the board with fewer balls: its heap takes the continuous mode minutes."""
    options = {"balls": 100} if name == "galton" else {}
    world: carom.World = getattr(carom.scenes, name)(**options).build()
    return world


def asked(world: carom.World) -> str:
    """A hash of what a world answers to queries of every sort, asked on a lattice over its shapes."""
    boxes = [shape.aabb for shape in world.shapes]
    across = np.linspace(min(box.left for box in boxes) - 0.1, max(box.right for box in boxes) + 0.1, ASKED)
    along = np.linspace(min(box.bottom for box in boxes) - 0.1, max(box.top for box in boxes) + 0.1, ASKED)
    places = np.stack(np.meshgrid(across, along), axis=-1).reshape(-1, 2)
    targets = np.roll(places, 5 * ASKED + 7, axis=0)
    size = 0.4 * float(across[1] - across[0])
    digest = hashlib.blake2b(digest_size=16)
    for sensors in (False, True):
        digest.update(bits(world.ray_cast(places, targets, sensors=sensors)))
        digest.update(bits(world.circle_cast(places, size, targets, sensors=sensors)))
        digest.update(bits(world.nearest(places, sensors=sensors)))
        digest.update(bits(world.overlapping(np.hstack([places - size, places + size]), sensors=sensors)))
        for contact in world.contacts(sensors=sensors):
            digest.update(repr((contact.point, contact.normal, contact.setback, contact.speed)).encode())
    return digest.hexdigest()


def lines(steps: int) -> Iterator[str]:
    """A line for each world and mode: the digest after so many steps, and hashes of all hits and of all answers."""
    for detection in ("discrete", "continuous"):
        for name, make in worlds().items():
            world = make()
            world.detection = detection
            hits = world.run(steps * DT, DT)
            happened = hashlib.blake2b(bits(hits), digest_size=16).hexdigest()
            yield f"{name} {detection} {world.digest()} {len(hits)} {happened} {asked(world)}"


if __name__ == "__main__":
    for line in lines(int(sys.argv[1]) if len(sys.argv) > 1 else STEPS):
        sys.stdout.write(line + "\n")
        sys.stdout.flush()
