"""A world's whole state as bytes, and back.

A snapshot is a line that says what it is, a BLAKE2b hash of the rest, and the rest: arrays in NumPy's own file format,
one after the other (names, compounds and groups as JSON text, the state's row, balls, shapes, relations, pending hits).
Nothing in it depends on the room that tables happen to have, so worlds in the same state give the same bytes.
"""

from __future__ import annotations

import hashlib
import io
import json
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from carom.errors import SnapshotError
from carom.rows.flight import COURSE
from carom.rows.relation import NO_RELATION
from carom.rows.state import DISCRETE, STATE
from carom.rows.tables import Rows
from carom.shapes import SHAPE_CLASSES
from carom.shapes.assembly import Assembly
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.world.departed import Departed
from carom.world.removal import relations_in_order, set_relations
from carom.world.snapshot_check import DERIVED, Contents, check_contents, ids_and_kinds
from carom.world.tables import Arrays, grown

if TYPE_CHECKING:
    from carom.world.world import World

W = TypeVar("W", Compound, Group)

MAGIC = b"carom snapshot 2\n"
HASH_SIZE = 16

#: Bytes of an array's head, the last two of which tell how many more it has, and how many heads are kept.
HEAD_SIZE, HEADS_KEPT = 10, 64

#: So many snapshots that were read last are kept as they were read, each of at most so many bytes.
KEPT, MOST_KEPT = 8, 2**20

#: What tells how much was searched, and for how large balls the index of shapes serves.
WORK = ("box_tests", "full_tests", "reach")


def write_snapshot(world: World) -> bytes:
    """The bytes of a world's state."""
    return sealed(payload(world._arrays, header_of(world), world._will_wake()))


def digest_of(world: World) -> str:
    """A hash of what a snapshot holds, as hexadecimal digits.

    In the continuous mode how much was searched is left out: it is all that depends on when one looks.
    """
    return hash_of(world._arrays, header_of(world), world._will_wake())


def sealed(payload: bytes) -> bytes:
    """A snapshot that holds some arrays."""
    return MAGIC + _hash(payload) + payload


def hash_of(arrays: Arrays, header: dict[str, Any], wake: int) -> str:
    """What `digest_of` says of a world with these tables, names and compounds, that wakes so or, for 0, does not."""
    left_out = WORK if arrays.states[0]["detection"] != DISCRETE else ()
    return _hash(payload(arrays, header, wake, left_out)).hex()


def _hash(payload: bytes) -> bytes:
    return hashlib.blake2b(payload, digest_size=HASH_SIZE).digest()


def payload(arrays: Arrays, header: dict[str, Any], wake: int, left_out: tuple[str, ...] = ()) -> bytes:
    """The arrays of a snapshot, one after the other, with zeros for the counts that are left out."""
    state = np.array([arrays.states[0]], STATE)
    state["balls"], state["shapes"] = arrays.balls.count, arrays.shapes.count
    state["wake"] = wake
    for field in (*DERIVED, *left_out):
        state[field] = 0
    balls = arrays.balls.used.copy()
    balls["relation"] = NO_RELATION
    for field in ("sensor", "can_collide"):
        balls[field] = balls[field] != 0  # whatever bytes were written through a view: kernels ask for 0 or not
    relations = np.array(relations_in_order(arrays), "f8").reshape(-1, 5)
    text = np.frombuffer(json.dumps(header, sort_keys=True).encode(), "u1")
    pending = arrays.hits[: int(arrays.states[0]["hits"])]
    tables = (text, state, balls, arrays.shapes.used, relations, pending, _courses(arrays))
    return b"".join(part for table in tables for part in (_head(table.dtype, table.shape), table.tobytes()))


@lru_cache(HEADS_KEPT)
def _head(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    """What stands before the rows of an array in NumPy's file format; it takes long to write and to read."""
    file = io.BytesIO()
    told = {"descr": np.lib.format.dtype_to_descr(dtype), "fortran_order": False, "shape": shape}
    np.lib.format.write_array_header_1_0(file, told)
    return file.getvalue()


@lru_cache(HEADS_KEPT)
def _told(head: bytes) -> tuple[np.dtype[Any], tuple[int, ...]]:
    """The dtype and the shape of an array, by what stands before its rows."""
    file = io.BytesIO(head)
    version = np.lib.format.read_magic(file)
    shape, transposed, dtype = np.lib.format.read_array_header_1_0(file)
    if version != (1, 0) or transposed or dtype.hasobject:
        raise SnapshotError("snapshot has tables of another form")
    return dtype, shape


def _arrays_in(data: bytes, count: int) -> tuple[Any, ...]:
    """So many arrays that stand one after the other, as views that cannot be written to, and where they end."""
    found: list[Any] = []
    at = 0
    for _ in range(count):
        rows_at = at + HEAD_SIZE + int.from_bytes(data[at + HEAD_SIZE - 2 : at + HEAD_SIZE], "little")
        dtype, shape = _told(data[at:rows_at])
        rows: Rows = np.ndarray(shape, dtype, data, rows_at)
        found.append(rows)
        at = rows_at + rows.nbytes
    return (*found, at)


def _courses(arrays: Arrays) -> Rows:
    """The flights of the balls, and what was seen of them, in the continuous mode; nothing in the other."""
    count = arrays.balls.count if arrays.states[0]["detection"] != DISCRETE else 0
    courses = np.zeros(count, COURSE)
    known = min(count, len(arrays.flights) // 2)
    for field in COURSE.names or ():
        courses[field][:known] = arrays.flights[field][:known]
    return courses


def header_of(world: World) -> dict[str, Any]:
    """Names, compounds and groups."""
    names = {str(key): member._name for key, member in list(world._objects.items()) if member._name is not None}
    return {"names": names, **wholes_of(world)}


def wholes_of(world: World) -> dict[str, list[dict[str, Any]]]:
    """Compounds and groups."""
    wholes: dict[str, list[dict[str, Any]]] = {"compounds": [], "groups": []}
    for shape in list(world._added.values()):
        if isinstance(shape, Assembly):
            parts = [part.id for part in shape._parts]
            wholes[f"{shape.kind}s"].append({"parts": parts, "name": shape.name, "surface": dict(shape._surface)})
    return wholes


def read(snapshot: Any) -> Contents:
    """What a snapshot holds, checked; raises `SnapshotError` where that is not what a world can be in."""
    if not isinstance(snapshot, (bytes, bytearray, memoryview)):
        raise SnapshotError(f"snapshot must be bytes, not {type(snapshot).__name__}")
    data = bytes(snapshot)
    return (_read if len(data) <= MOST_KEPT else _read.__wrapped__)(data)


@lru_cache(KEPT)
def _read(data: bytes) -> Contents:
    """The same of some bytes, which is not to be changed; whoever goes back to a state does so more than once."""
    start = len(MAGIC) + HASH_SIZE
    if not data.startswith(MAGIC) or len(data) < start:
        raise SnapshotError("snapshot must begin with the line that carom's snapshots begin with")
    held = data[start:]
    if _hash(held) != data[len(MAGIC) : start]:
        raise SnapshotError("snapshot is damaged: its hash is not that of its contents")
    try:
        text, *tables, end = _arrays_in(held, 7)
        contents = Contents(json.loads(text.tobytes().decode()), *tables)
        if end < len(held):
            raise SnapshotError("snapshot has more in it than a world")
        check_contents(contents)
    except SnapshotError:
        raise
    except Exception as error:  # noqa: BLE001  # NumPy's and JSON's readers raise many kinds
        raise SnapshotError(f"snapshot cannot be read: {error}") from None
    return contents


def read_snapshot(world: World, snapshot: bytes) -> None:
    """Make a world what the snapshot says, or raise `SnapshotError` and leave it as it was."""
    contents = read(snapshot)
    arrays = world._arrays
    if is_alike(world, contents):
        fill(arrays, contents)
        left = None
    else:
        left = _leave_others(world, contents)
        fill(arrays, contents)
    # Ids that were given after the snapshot was taken will be given again, to others.
    world._departed = Departed()
    world._lent = None
    if len(world._left):
        world._left = contents.balls[:0].copy()
    world._forget_block()
    if left is not None:
        _restore_objects(world, contents, left)


def is_alike(world: World, contents: Contents) -> bool:
    """True if a world has the members, names, compounds and groups of a snapshot, and only its numbers may differ."""
    arrays = world._arrays
    if ids_and_kinds(arrays.balls.used, arrays.shapes.used) != contents.ids_and_kinds:
        return False
    names = {key: member._name for key, member in list(world._objects.items()) if member._name is not None}
    header = contents.header
    return names == contents.names and all(header.get(kind) == wholes for kind, wholes in wholes_of(world).items())


def _leave_others(world: World, contents: Contents) -> list[Shape | Ball]:
    """The members of a world that a snapshot does not have, which leave it."""
    kinds = dict(zip(contents.shapes["id"].tolist(), contents.shapes["kind"].tolist(), strict=True))
    kinds.update(dict.fromkeys(contents.balls["id"].tolist(), Ball._KIND))
    left = [member for key, member in list(world._objects.items()) if kinds.get(key) != member._KIND]
    world._objects = {key: member for key, member in list(world._objects.items()) if kinds.get(key) == member._KIND}
    for member in left:
        member._leave()
    return left


def fill(arrays: Arrays, contents: Contents) -> None:
    """Make tables what the contents say."""
    arrays.fill(contents.balls, contents.shapes)
    states: Rows = arrays.states  # type: ignore[assignment]  # as NumPy has it: records go field by field, bytes do not
    states[:1].view(np.uint8)[:] = contents.state.view(np.uint8)
    count = len(contents.hits)
    if count > 0:
        arrays.hits = grown(contents.hits, count + 64, count)
    arrays.states[0]["hits"] = count
    arrays.owed = 0
    set_relations(arrays, contents.relation_list)
    arrays.prepare()
    _keep_saved(arrays, contents.courses)


def _keep_saved(arrays: Arrays, courses: Rows) -> None:
    """Fill in the flights, and the copy by which the next step sees whether balls were changed through views."""
    count = arrays.balls.count
    if len(courses):
        for field in COURSE.names or ():
            arrays.flights[field][: len(courses)] = courses[field]
    saved, balls = arrays.saved[:count], arrays.balls.used
    for field in ("x", "y", "vx", "vy"):
        saved[field] = courses[f"shown_{field}"] if len(courses) else balls[field]


def _restore_objects(world: World, contents: Contents, left: list[Shape | Ball]) -> None:
    """Make the shapes that are missing, the compounds and the groups, and give all their names."""
    for row in contents.shapes:
        key = int(row["id"])
        if key not in world._objects:
            shape_class = SHAPE_CLASSES[int(row["kind"])]
            world._objects[key] = shape_class._of_row(world, world._arrays.shapes, key)
    for member in list(world._objects.values()):
        member._name = None
    for key, name in contents.header["names"].items():
        world.object(int(key))._name = name
    wholes: list[Compound | Group] = [
        *_restore_wholes(world, Compound, contents.header["compounds"]),
        *_restore_wholes(world, Group, contents.header["groups"]),
    ]
    _regroup(world, wholes, left)
    firsts = {whole.id: whole for whole in wholes}
    world._added, world._listed = {}, []
    for key in contents.shapes["id"].tolist():
        member = world._objects[key]
        if key in firsts:
            world._added[key] = firsts[key]
        elif isinstance(member, Shape) and member._whole is None:
            world._added[key] = member


def _restore_wholes(world: World, kind: type[W], entries: list[dict[str, Any]]) -> list[W]:
    """The compounds or groups of a snapshot: those of the world whose first part is kept, and new ones."""
    known = {key: shape for key, shape in list(world._added.items()) if isinstance(shape, kind)}
    restored: list[W] = []
    for entry in entries:
        whole = known.get(entry["parts"][0])
        if whole is None:
            whole = kind.__new__(kind)
            whole.user = None
        parts = [world._objects[part] for part in entry["parts"]]
        whole._parts = [part for part in parts if isinstance(part, Shape)]
        whole._surface = dict(entry["surface"])
        whole._name = entry["name"]
        restored.append(whole)
    return restored


def _regroup(world: World, wholes: list[Compound | Group], left: list[Shape | Ball]) -> None:
    """Tell every shape which whole it is part of now, and take others out of the wholes they were in.

    A shape that leaves the world stays in its whole, unless that stays in the world without it.
    """
    part_of = {part.id: whole for whole in wholes for part in whole._parts}
    kept = {id(whole) for whole in wholes}
    abandoned = [shape for shape in left if isinstance(shape, Shape) and id(shape._whole) in kept]
    for member in (*list(world._objects.values()), *abandoned):
        if isinstance(member, Shape):
            before, now = member._whole, part_of.get(member.id)
            member._whole = now
            if before is not None and before is not now and id(before) not in kept:
                before._parts.remove(member)
