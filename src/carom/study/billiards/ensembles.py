"""Ensembles: many orbits of one table, in worlds of a few hundred balls that do not meet, one world after the other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import repeat
from math import ceil, pi
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from carom.rows.hit import BOUNCE
from carom.rows.tables import Rows
from carom.study.billiards.outline import Floats, unfit
from carom.study.billiards.tables import Starts, Table
from carom.world.boundary import Piece, Track

if TYPE_CHECKING:
    from carom.world import Hits, World

Numbers = NDArray[np.int64]

#: Orbits in one world: so few that their events stay in a processor's cache, so many that Python has little to do.
BATCH = 500
#: A run for so many hits first takes this part of the time that they need on average, then goes on by a smaller one,
#: which grows, so many times at most. Between two parts the balls that have had enough are let go.
FIRST, FURTHER, MORE, MOST_RUNS = 0.85, 0.08, 1.3, 60
#: Hits in one run of that part, about: so few that they stay in a cache until they are looked at, so many that what a
#: run takes to begin is nothing.
RUN = 50_000


class Flights(NamedTuple):
    """The flights of a batch that ended with a bounce, orbit after orbit, each in order of time.

    `ends` are the rows of these bounces, `lengths` are how long the flights took, and `counts` how many each orbit had.
    """

    ends: Rows
    lengths: Floats
    counts: Numbers


@dataclass
class Batch:
    """Some orbits of an ensemble: the table, a world of it with a ball for each, and the number of the first of them.

    `track` is where hits on the table's walls are; `free_time` is about how long a ball flies from wall to wall. The
    world and the track are those of all batches of an ensemble: what is asked of one is asked before the next is made.
    """

    table: Table
    world: World
    track: Track
    first: int
    free_time: float

    def __post_init__(self) -> None:
        self._first_id = int(self.world.balls.id[0])
        self.size = len(self.world.balls)

    def run(self, seconds: float) -> Hits:
        """The bounces of so many seconds, in order of time."""
        hits = self.world.run(seconds, seconds)
        bounces = hits["kind"] == BOUNCE
        return hits if bounces.all() else hits[bounces]

    def flights(self, seconds: float) -> Flights:
        """The flights of so many seconds; the first of each orbit begins with them."""
        began = self.world.time
        found = self.run(seconds)
        numbers = self.numbers(found)
        ends = found.view(np.ndarray)[np.argsort(numbers, kind="stable")]
        counts = np.bincount(numbers, minlength=self.size)
        lengths = np.diff(ends["time"], prepend=began)
        first = (np.cumsum(counts) - counts)[counts > 0]
        lengths[first] = ends["time"][first] - began
        return Flights(ends, lengths, counts)

    def numbers(self, hits: Hits) -> Numbers:
        """Whose each hit is: the number of the orbit in this batch."""
        return np.asarray(hits["ball"]) - self._first_id

    def boundary(self, hits: Hits) -> tuple[Floats, Floats]:
        """Where along the table's outline hits are, loop after loop, and the sines of their angles of incidence."""
        places, on = self.track.places_of(hits["shape"])
        rows = hits.view(np.ndarray)
        if on.all():
            return self.track.coordinates(rows, places)
        along, sine = np.empty(len(hits)), np.empty(len(hits))
        along[on], sine[on] = self.track.coordinates(rows[on], places[on])
        along[~on], sine[~on] = self._at_corners(rows[~on])
        return along, sine

    def _at_corners(self, hits: Rows) -> tuple[Floats, Floats]:
        """The same for hits on the points of corners, whose tangent is square to the ball's way off."""
        walls = self.table.pieces
        ends = np.array([wall.ends[0] for wall in walls])
        begins = np.cumsum([0.0, *(wall.wall.length for wall in walls[:-1])])
        away = hits["point"][:, None, :] - ends
        nearest = np.argmin(np.sum(away * away, axis=-1), axis=1)
        normal, velocity = hits["normal"], hits["velocity"]
        across = normal[:, 1] * velocity[:, 0] - normal[:, 0] * velocity[:, 1]
        outer = nearest < len(self.table.loops[0].pieces)
        return begins[nearest], np.where(outer, across, -across) / np.sqrt(np.sum(velocity * velocity, axis=1))


def batches(table: Table, starts: Starts, speed: float) -> Iterator[Batch]:
    """Worlds that hold the orbits from `starts`, some hundreds each; `speed` is the greatest of a ball."""
    free_time = pi * table.area / (table.perimeter * speed)
    world = table.world_of(Starts(*(column[:BATCH] for column in starts)))
    shapes: Any = world.shapes
    track = Track([Piece(shapes[wall.place], wall.forward) for wall in table.pieces])
    yield Batch(table, world, track, 0, free_time)
    for first in range(BATCH, len(starts.position), BATCH):
        table.fill(world, Starts(*(column[first : first + BATCH] for column in starts)))
        yield Batch(table, world, track, first, free_time)


def _runs_for(batch: Batch, hits: int) -> Iterator[tuple[float, bool]]:
    """How long to run a batch, time after time, until each orbit has so many hits.

    With each whether to let those go then that have them. That begins the flights of all balls anew, to other last
    digits, so the first part's runs do not.
    """
    needed = hits * batch.free_time
    parts = ceil(FIRST * hits * batch.size / RUN)
    part = FIRST * needed / parts
    yield from repeat((part, False), parts - 1)
    yield FIRST * needed - (parts - 1) * part, True
    further = max(FURTHER * needed, batch.free_time)
    for _ in range(MOST_RUNS):
        yield further, True
        further *= MORE


def first_hits(batch: Batch, hits: int) -> tuple[Floats, Floats, Floats]:
    """The times of the first `hits` bounces of each orbit, their arc lengths and sines, each of shape (orbits, hits).

    Raises `InvalidArgument` where a ball stops bouncing, on a wall that takes its speed.
    """
    columns: list[tuple[Numbers, Floats, Floats, Floats]] = []
    counts = np.zeros(batch.size, np.int64)
    for seconds, letting_go in _runs_for(batch, hits):
        found = batch.run(seconds)
        numbers = batch.numbers(found)
        counts += np.bincount(numbers, minlength=batch.size)
        columns.append((numbers, np.ascontiguousarray(found["time"]), *batch.boundary(found)))
        if counts.min() >= hits:
            break
        if letting_go:
            batch.world.balls.can_collide[:] = counts < hits
    else:
        raise unfit(batch.table.scene, f"must let balls bounce; one has done so {counts.min()} times")
    numbers, *values = (np.concatenate(parts) for parts in zip(*columns, strict=True))
    order = np.argsort(numbers, kind="stable")
    begins = np.concatenate([[0], np.cumsum(counts)[:-1]])
    rows = order[begins[:, None] + np.arange(hits)]
    time, along, sine = (value[rows] for value in values)
    return time, along, sine
