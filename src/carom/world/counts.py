"""Hits counted by what was hit, all at once or while a run goes on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.rows.hit import BOUNCE, ENTER, EXIT, HIT
from carom.rows.tables import Rows
from carom.world.plural import OfHits
from carom.world.tables import joined
from carom.world.touches import Touching

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape
    from carom.world.world import World

COUNT = np.dtype(
    [
        ("shape", "i8"),
        ("touches", "i8"),
        ("bounces", "i8"),
        ("entries", "i8"),
        ("exits", "i8"),
        ("first", "f8"),
        ("fastest", "f8"),
        ("strongest", "f8"),
    ]
)

#: Hits that are gathered before they are counted, which takes about as long for one as for a hundred.
GATHERED = 4096


@dataclass(frozen=True, slots=True)
class Count:
    """What has happened at one shape or ball.

    Attributes:
        shape: What was hit. Of two balls, the one that was added first.
        touches: How often it was touched: `Hits.touches` says which hits are one.
        bounces: How many bounces there were.
        entries: How often a ball came into a sensor.
        exits: How often one left it.
        first: The time of the first hit.
        fastest: The greatest speed of a bounce; 0 if there was none.
        strongest: The strongest impulse of one.
    """

    shape: Shape | Ball
    touches: int
    bounces: int
    entries: int
    exits: int
    first: float
    fastest: float
    strongest: float


class Counts(OfHits[Count]):
    """Hits counted by what was hit, in the order of ids: a structured array whose items are `Count` objects.

    `World.run(..., keep="counts")` gives them, and `Hits.counts`. The fields are those of `Count`, with an id for
    `shape`.
    """

    DTYPE = COUNT

    def __repr__(self) -> str:
        return f"<counts of {len(self)} shapes>"

    __str__ = __repr__

    def _object(self, world: World, row: Any) -> Count:
        shape, *numbers = row.item()
        return Count(self._member(world, shape), *numbers)


class Counter:
    """Counts hits as they come, and holds no more of them than a few thousand."""

    def __init__(self) -> None:
        self._touching = Touching()
        self._rows: Rows = np.zeros(0, COUNT)
        self._waiting: list[Rows] = []
        self._gathered = 0

    def add(self, hits: Rows) -> None:
        """Count more hits, in order of time, which come after those before."""
        self._waiting.append(hits)
        self._gathered += len(hits)
        if self._gathered >= GATHERED:
            self._count()

    def rows(self) -> Rows:
        """A row of `COUNT` for each id that was hit, in order of ids."""
        self._count()
        return self._rows

    def _count(self) -> None:
        """Count the hits that wait."""
        hits = joined(self._waiting, HIT)
        self._waiting, self._gathered = [], 0
        if len(hits) == 0:
            return
        shapes = np.union1d(self._rows["shape"], hits["shape"])
        rows = np.zeros(len(shapes), COUNT)
        rows["shape"], rows["first"] = shapes, np.inf
        rows[np.searchsorted(shapes, self._rows["shape"])] = self._rows
        places = np.searchsorted(shapes, hits["shape"])
        bounces = hits["kind"] == BOUNCE
        kinds = {"bounces": bounces, "entries": hits["kind"] == ENTER, "exits": hits["kind"] == EXIT}
        for name, which in (("touches", self._touching.begins(hits)), *kinds.items()):
            rows[name] += np.bincount(places[which], minlength=len(rows))
        np.minimum.at(rows["first"], places, hits["time"])
        np.maximum.at(rows["fastest"], places[bounces], hits["speed"][bounces])
        np.maximum.at(rows["strongest"], places[bounces], hits["impulse"][bounces])
        self._rows = rows
