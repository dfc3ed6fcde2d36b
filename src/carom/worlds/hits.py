"""The hits of many copies: those of a world, with one more field that says in which copy each was."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.rows.hit import HIT
from carom.rows.tables import Rows
from carom.world.hits import Hit, Hits
from carom.world.plural import OfHits

if TYPE_CHECKING:
    from carom.world.world import World

#: A hit's row, and the index of the copy.
COPY_HIT = np.dtype([*((name, *HIT.fields[name][:1]) for name in HIT.names or ()), ("world", "i8")])  # type: ignore[index]


@dataclass(frozen=True, slots=True)
class CopyHit(Hit):
    """One impact, or one crossing of a sensor's edge, in one of many copies.

    `ball` and `shape` are those of the world that was copied: they say what it was, not how it is in the copy.

    Attributes:
        world: The index of the copy.
    """

    world: int


class CopyHits(OfHits[CopyHit]):
    """Every hit of a step or a run of many copies, copy by copy, each copy's in order of time.

    A structured array with the fields of `Hits` and one more, `world`; items are `CopyHit` objects.
    """

    DTYPE = COPY_HIT

    def __repr__(self) -> str:
        return f"<{len(self)} hits in {len(np.unique(self['world']))} worlds>"

    __str__ = __repr__

    def _object(self, world: World, row: Any) -> CopyHit:
        rows = np.zeros(1, HIT)
        for name in HIT.names or ():
            rows[name] = row[name]
        hit = Hits.of(world, rows, self._gone)[0]
        return CopyHit(**{field.name: getattr(hit, field.name) for field in fields(hit)}, world=int(row["world"]))


def gathered(base: World, parts: list[tuple[Rows, Rows]]) -> CopyHits:
    """The hits of some copies from their rows and, for each, the index of its copy."""
    rows: Rows = np.zeros(sum(len(copies) for _, copies in parts), COPY_HIT)
    if not len(rows):
        return CopyHits.of(base, rows)
    bytes_of = rows.view(np.uint8).reshape(len(rows), COPY_HIT.itemsize)
    begin = 0
    for hits, copies in parts:
        end = begin + len(copies)
        # As plain bytes: NumPy copies structured rows field by field.
        bytes_of[begin:end, : HIT.itemsize] = hits.view(np.uint8).reshape(len(copies), HIT.itemsize)
        rows["world"][begin:end] = copies
        begin = end
    world, time = rows["world"], rows["time"]
    # A ball in flight finds out that it has left a sensor only later.
    if (np.diff(world) < 0).any() or ((np.diff(time) < 0.0) & (np.diff(world) == 0)).any():
        rows = rows[np.lexsort((time, world))]
    return CopyHits.of(base, rows)


def hits_of(hits: CopyHits, copy: int, world: World) -> Hits:
    """The hits of one copy, which `world` is now."""
    first, last = np.searchsorted(hits["world"], (copy, copy + 1)).tolist()
    rows = np.ascontiguousarray(hits[first:last].view(np.ndarray)).view(np.uint8).reshape(-1, COPY_HIT.itemsize)
    return Hits.of(world, np.ascontiguousarray(rows[:, : HIT.itemsize]).view(HIT)[:, 0])
