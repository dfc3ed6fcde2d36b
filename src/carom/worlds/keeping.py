"""A copy as a world's snapshot, and back; what was written to the arrays of all copies."""

from __future__ import annotations

import hashlib
import io
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.checks import refuse
from carom.errors import InvalidArgument, SnapshotError
from carom.rows.relation import NO_RELATION
from carom.rows.state import DISCRETE
from carom.rows.tables import Rows
from carom.world.settings import SETTINGS, Settings
from carom.world.snapshot import fill, hash_of, header_of, payload, read, sealed
from carom.world.snapshot_check import Contents
from carom.world.tables import OF_BALLS, Arrays
from carom.world.views import LENT
from carom.world.waking import mark_changed, note_changed, will_wake
from carom.world.world import World
from carom.worlds.memory import Memory
from carom.worlds.stage import Common

MAGIC = b"carom snapshot of copies 1\n"
HASH_SIZE = 16

# -- one copy ---------------------------------------------------------------------------------------------------------


def fresh(contents: Contents) -> Arrays:
    """New tables that are what a snapshot holds."""
    arrays = Arrays()
    fill(arrays, contents)
    return arrays


def world_of(base: World, snapshot: bytes) -> World:
    """A world of its own with the objects of another one, as a snapshot says."""
    world = copy(base)
    world.restore(snapshot)
    return world


def base_of(scene: Any) -> World:
    """A world of its own that is what is to be copied."""
    if isinstance(scene, World):
        return world_of(scene, scene.snapshot())
    from carom.scene import Scene
    from carom.scene.shipped import by_name

    if isinstance(scene, str):
        return by_name(scene).build()
    if not isinstance(scene, Scene):
        raise refuse("scene", "must be a Scene, a World or the name of a shipped scene", scene)
    return scene.build()


def snapshot_of(base: World, arrays: Arrays) -> bytes:
    """The snapshot of the world that has these tables, and the names and compounds of another one."""
    return sealed(payload(arrays, _header(base, arrays), will_wake(arrays)))


def digest_of(base: World, arrays: Arrays) -> str:
    """The digest of that world."""
    return hash_of(arrays, _header(base, arrays), will_wake(arrays))


def _header(base: World, arrays: Arrays) -> dict[str, Any]:
    """Names, compounds and groups of a world, without those of balls that are not there."""
    header = header_of(base)
    here = {*arrays.balls.used["id"].tolist(), *arrays.shapes.used["id"].tolist()}
    return {**header, "names": {key: name for key, name in header["names"].items() if int(key) in here}}


def contents_of(origin: Contents, common: Common, snapshot: bytes) -> Contents:
    """What a snapshot of a world holds; raises `InvalidArgument` where that is no copy of the one that was copied."""
    contents = read(snapshot)
    wrong = _difference(origin, contents, common)
    if wrong:
        raise InvalidArgument(f"world must be of the same scene as the copies; {wrong} not the same")
    return contents


def _difference(first: Contents, second: Contents, common: Common) -> str:
    """What of two worlds is not the same but must be in all copies; "" where nothing is."""
    for name in SETTINGS:
        setting = vars(Settings)[name]
        if setting._read(first.state[0]) != setting._read(second.state[0]):
            return f"{name} is"
    if not np.isin(second.balls["id"], common.ids).all():
        return "balls are"
    for wholes in ("compounds", "groups"):
        if first.header[wholes] != second.header[wholes]:
            return f"{wholes} are"
    if len(first.shapes) != len(second.shapes):
        return "shapes are"
    still = np.ones(len(first.shapes), np.bool_)
    still[common.moving] = False
    alike = [_without_switches(contents.shapes[still]) for contents in (first, second)]
    if alike[0].tobytes() != alike[1].tobytes():
        return "static shapes are"
    one, other = first.shapes[~still], second.shapes[~still]
    if any((one[name] != other[name]).any() for name in ("id", "kind", "motion")):
        return "kinematic shapes are"
    return ""


def _without_switches(shapes: Rows) -> Rows:
    """Rows of shapes that differ in nothing that may differ in static ones."""
    rows = shapes.copy()
    rows["can_collide"] = rows["once"] = 0
    return rows


def switched_of(common: Common, arrays: Arrays, contents: Contents) -> NDArray[np.intp]:
    """The static shapes whose switches are not as in all copies so far, and which have none of their own yet."""
    here, there = arrays.shapes.used, contents.shapes
    differs = (here["can_collide"] != there["can_collide"]) | (here["once"] != there["once"])
    differs[common.moving] = False
    differs[common.switched] = False
    return np.flatnonzero(differs)


def with_more(arrays: Arrays, base: World, entering: Rows) -> Contents:
    """What the tables of a stage hold, and balls that come in, in the order of ids: they touch nothing yet."""
    contents = read(snapshot_of(base, arrays))
    rows = entering.copy()
    rows["relation"], rows["asleep"], rows["still_time"], rows["stray"] = NO_RELATION, 0, 0.0, 0
    places = np.searchsorted(contents.balls["id"], rows["id"])
    relations = contents.relations.copy()
    for column, of_balls in ((1, np.ones(len(relations), np.bool_)), (2, np.isin(relations[:, 0], OF_BALLS))):
        index = relations[of_balls, column]
        relations[of_balls, column] = index + np.searchsorted(places, index, side="right")
    courses = contents.courses
    if arrays.states[0]["detection"] != DISCRETE:
        courses = np.insert(courses, places, np.zeros(len(rows), courses.dtype))
    balls = np.insert(contents.balls, places, rows)
    return replace(contents, balls=balls, relations=relations, courses=courses)


# -- all copies -------------------------------------------------------------------------------------------------------


def lent_columns(memory: Memory) -> Rows:
    """The columns of the balls that may be written to and are not looked at by every step, as they are now."""
    rows = memory.balls
    columns: Rows = np.zeros(rows.shape, [(name, rows.dtype[name]) for name in LENT])
    for name in LENT:
        columns[name] = rows[name]
    return columns


def wake_changed(memory: Memory, lent: Rows) -> None:
    """Have the copies wake of which such columns are not what they were, where that makes a difference.

    A ball that is not what it was begins a new flight.
    """
    changed = np.zeros(lent.shape, np.bool_)
    for name in LENT:
        changed |= memory.balls[name] != lent[name]
    # What a ball has that is not in play means nothing.
    changed &= memory.in_play
    if memory.layout[0]["flights_at"]:
        mark_changed(memory.flights, changed)
    matters = (memory.state["sleeping"] > 0) | (memory.state["detection"] != DISCRETE)
    note_changed(memory.state, changed.any(axis=1) & matters)


def chosen(name: str, where: Any, count: int) -> NDArray[Any]:
    """A mask or indices of copies; raises where it is neither."""
    given = np.asarray(where)
    if given.dtype.kind == "b" and given.shape == (count,):
        return given
    must = f"must be a mask of shape ({count},), or whole numbers from {-count} to {count - 1}"
    if given.dtype.kind not in "iu" and given.size:
        raise refuse(name, must, where)
    indices = given.astype(np.int64).reshape(-1)
    if len(indices) and not (-count <= indices.min() and indices.max() < count):
        raise refuse(name, must, where)
    return indices


def packed(parts: list[bytes], counts: NDArray[np.int64]) -> bytes:
    """The snapshot of all copies: a line, a hash, and arrays."""
    file = io.BytesIO()
    for array in (counts, np.cumsum([len(part) for part in parts]), np.frombuffer(b"".join(parts), np.uint8)):
        np.save(file, array, allow_pickle=False)
    data = file.getvalue()
    return MAGIC + hashlib.blake2b(data, digest_size=HASH_SIZE).digest() + data


def unpacked(snapshot: Any, shape: tuple[int, ...]) -> tuple[list[bytes], NDArray[np.int64]]:
    """The snapshots of single copies, and the counts, whose shape is known; raises `SnapshotError`."""
    if not isinstance(snapshot, (bytes, bytearray, memoryview)):
        raise SnapshotError(f"snapshot must be bytes, not {type(snapshot).__name__}")
    data = bytes(snapshot)
    start = len(MAGIC) + HASH_SIZE
    if not data.startswith(MAGIC):
        raise SnapshotError("snapshot must begin with the line that snapshots of copies begin with")
    if hashlib.blake2b(data[start:], digest_size=HASH_SIZE).digest() != data[len(MAGIC) : start]:
        raise SnapshotError("snapshot is damaged: its hash is not that of its contents")
    try:
        file = io.BytesIO(data[start:])
        counts, ends, text = (np.lib.format.read_array(file, allow_pickle=False) for _ in range(3))
        parts = [text[begin:end].tobytes() for begin, end in zip([0, *ends[:-1]], ends, strict=True)]
    except Exception as error:  # noqa: BLE001  # NumPy's reader raises many kinds
        raise SnapshotError(f"snapshot cannot be read: {error}") from None
    if len(parts) != shape[0]:
        raise SnapshotError(f"snapshot must be of {shape[0]} copies, not of {len(parts)}")
    if counts.shape != shape or counts.dtype != np.int64:
        shapes = counts.shape[1] if counts.ndim == len(shape) else "others"
        raise SnapshotError(f"snapshot must be of copies of the same scene: of {shape[1]} shapes, not of {shapes}")
    return parts, counts
