"""A world's whole state as bytes, and back.

A snapshot is a line that says what it is, a BLAKE2b hash of the rest, and the rest: arrays in NumPy's own file format,
one after the other (names and compounds as JSON text, the state's row, balls, shapes, relations, pending hits). Nothing
in it depends on the room that tables happen to have, so worlds in the same state give the same bytes.
"""

from __future__ import annotations

import hashlib
import io
import json
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.errors import SnapshotError
from carom.rows import ALL_LAYERS, ARC, BALL, KINEMATIC, NO_RELATION, SHAPE, Rows
from carom.shapes import SHAPE_CLASSES
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.shape import Shape
from carom.world.layout import HIT, INSIDE_BALL, PASSING, STATE
from carom.world.removal import Relation, leave_world, relations_in_order, set_relations
from carom.world.tables import clear_kernel_place

if TYPE_CHECKING:
    from carom.world.world import World

MAGIC = b"carom snapshot 1\n"
HASH_SIZE = 16

#: Fields of the state that only say how its tables stand, which a snapshot leaves at 0.
_DERIVED = (
    "hits",
    "relations",
    "relations_high",
    "free_relation",
    "fixed",
    "index_stale",
    "moving_stale",
    "dt",
    "step_hits",
    "new_strays",
    "wanted_hits",
    "wanted_relations",
    "wanted_pairs",
    "wanted_starts",
    "wanted_cells",
    "wanted_members",
)


def write_snapshot(world: World) -> bytes:
    """The bytes of a world's state."""
    payload = _payload(world)
    return MAGIC + _hash(payload) + payload


def digest_of(world: World) -> str:
    """The hash that a snapshot of the world would carry, as hexadecimal digits."""
    return _hash(_payload(world)).hex()


def _hash(payload: bytes) -> bytes:
    return hashlib.blake2b(payload, digest_size=HASH_SIZE).digest()


def _payload(world: World) -> bytes:
    """The arrays of a snapshot, one after the other."""
    room = world._room
    state = room.states[:1].copy()
    clear_kernel_place(state[0])
    state["balls"], state["shapes"] = room.balls.count, room.shapes.count
    state["wake"] = world._will_wake()
    for field in _DERIVED:
        state[field] = 0
    balls = room.balls.used.copy()
    balls["relation"] = NO_RELATION
    relations = np.array(relations_in_order(room), "i8").reshape(-1, 3)
    text = np.frombuffer(json.dumps(_header(world), sort_keys=True).encode(), "u1")
    file = io.BytesIO()
    for array in (text, state, balls, room.shapes.used, relations, room.hits[: int(room.states[0]["hits"])]):
        np.save(file, array, allow_pickle=False)
    return file.getvalue()


def _header(world: World) -> dict[str, Any]:
    """Names, compounds, and the order of what was added."""
    names = {str(key): member.name for key, member in sorted(world._objects.items()) if member.name is not None}
    compounds = [
        {
            "parts": [part.id for part in (shape.center_point, *shape.shapes)],
            "name": shape.name,
            "surface": dict(shape._surface),
        }
        for shape in world._added.values()
        if isinstance(shape, Compound)
    ]
    return {"names": names, "compounds": compounds, "added": list(world._added)}


class _Parts:
    """The checked contents of a snapshot."""

    def __init__(self, snapshot: bytes) -> None:
        if not isinstance(snapshot, (bytes, bytearray, memoryview)):
            raise SnapshotError(f"snapshot must be bytes, not {type(snapshot).__name__}")
        data = bytes(snapshot)
        start = len(MAGIC) + HASH_SIZE
        if not data.startswith(MAGIC) or len(data) < start:
            raise SnapshotError("snapshot must begin with the line that carom's snapshots begin with")
        if _hash(data[start:]) != data[len(MAGIC) : start]:
            raise SnapshotError("snapshot is damaged: its hash is not that of its contents")
        try:
            file = io.BytesIO(data[start:])
            arrays = [np.load(file, allow_pickle=False) for _ in range(6)]
            text, state, self.balls, self.shapes, relations, self.hits = arrays
            self.state = state[0]
            self.header = json.loads(text.tobytes().decode())
            self.relations: list[Relation] = [tuple(row) for row in relations.tolist()]
            self._check(state)
        except SnapshotError:
            raise
        except Exception as error:  # noqa: BLE001  # NumPy's and JSON's readers raise many kinds
            raise SnapshotError(f"snapshot cannot be read: {error}") from None

    def _check(self, state: Rows) -> None:
        """Nothing; raises where the contents are not what a world can be in."""
        dtypes = (state.dtype, self.balls.dtype, self.shapes.dtype, self.hits.dtype)
        if dtypes != (STATE, BALL, SHAPE, HIT):
            raise SnapshotError("snapshot is of another version of carom")
        for rows in (self.balls, self.shapes):
            ids = rows["id"]
            if rows.ndim != 1 or (len(ids) and (np.diff(ids) <= 0).any()):
                raise SnapshotError("snapshot has ids out of order")
            if len(ids) and not 0 < int(ids[0]) <= int(ids[-1]) < int(self.state["next_id"]):
                raise SnapshotError("snapshot has ids out of range")
        if (self.shapes["kind"] > ARC).any() or (self.shapes["motion"] > KINEMATIC).any():
            raise SnapshotError("snapshot has shapes of unknown kinds")
        for kind, ball, other in self.relations:
            others = self.balls if kind == INSIDE_BALL else self.shapes
            if not (PASSING <= kind <= INSIDE_BALL and 0 <= ball < len(self.balls) and 0 <= other < len(others)):
                raise SnapshotError("snapshot has relations of unknown rows")
        parts = [part for compound in self.header["compounds"] for part in compound["parts"]]
        known = set(self.shapes["id"].tolist())
        if not set(parts) <= known or len(set(parts)) < len(parts) or not set(self.header["added"]) <= known:
            raise SnapshotError("snapshot has compounds of unknown parts")
        if any(not 0 <= compound["surface"].get("layer", 1) <= ALL_LAYERS for compound in self.header["compounds"]):
            raise SnapshotError("snapshot has a compound on an unknown layer")


def read_snapshot(world: World, snapshot: bytes) -> None:
    """Nothing; makes a world what the snapshot says, or raises `SnapshotError` and leaves it as it was."""
    parts = _Parts(snapshot)
    room = world._room
    kinds = {int(row["id"]): int(row["kind"]) for row in parts.shapes}
    kinds.update({int(row["id"]): Ball._KIND for row in parts.balls})
    kept = {key: member for key, member in world._objects.items() if kinds.get(key) == member._KIND}
    compounds = [shape for shape in world._added.values() if isinstance(shape, Compound)]
    for key, member in world._objects.items():
        if key not in kept:
            leave_world(member)
    for table, rows in ((room.balls, parts.balls), (room.shapes, parts.shapes)):
        table.rows = rows.copy()
        table.count = len(rows)
    room.states[0] = parts.state
    room.hits = np.concatenate([parts.hits, np.zeros(64, HIT)])
    room.states[0]["hits"] = len(parts.hits)
    set_relations(room, parts.relations)
    room.prepare()
    _keep_saved(world)
    world._objects = kept
    _restore_objects(world, parts, compounds)
    world._arguments = None
    world._dt = -1.0


def _keep_saved(world: World) -> None:
    """Nothing; fills the copy by which the next step sees whether balls were changed through views."""
    room = world._room
    for field in ("x", "y", "vx", "vy"):
        room.saved[field][: room.balls.count] = room.balls.used[field]


def _restore_objects(world: World, parts: _Parts, compounds: list[Compound]) -> None:
    """Nothing; makes the shapes that are missing, and the compounds, and gives all their names."""
    for row in parts.shapes:
        key = int(row["id"])
        if key not in world._objects:
            shape_class = SHAPE_CLASSES[int(row["kind"])]
            world._objects[key] = shape_class._of_row(world, world._room.shapes, key)
    for member in world._objects.values():
        member._name = None
    for key, name in parts.header["names"].items():
        world.object(int(key)).name = name
    known = {id(shape.center_point): shape for shape in compounds}
    by_center: dict[int, Compound] = {}
    for entry in parts.header["compounds"]:
        members = [world._objects[part] for part in entry["parts"]]
        compound = known.pop(id(members[0]), None) or Compound.__new__(Compound)
        if not hasattr(compound, "user"):
            compound.user = None
        compound._parts = [member for member in members if isinstance(member, Shape)]
        compound._surface = dict(entry["surface"])
        compound._name = entry["name"]
        for part in compound._parts:
            part._compound = compound
        by_center[entry["parts"][0]] = compound
    world._added = {}
    for key in parts.header["added"]:
        member = world._objects[key]
        if isinstance(member, Shape):
            world._added[key] = by_center.get(key, member)
