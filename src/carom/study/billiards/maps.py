"""Boundary maps and mean free paths: what the hits of an ensemble say."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np

from carom.checks import whole
from carom.scene.scene import Scene
from carom.spelling import spelled
from carom.study.billiards.ensembles import Numbers, batches, first_hits
from carom.study.billiards.outline import Floats, unfit
from carom.study.billiards.tables import Table, table

#: Hits of each orbit at most.
MOST_HITS = 100_000_000


#: Bins along either side at most.
MOST_BINS = 1000


@dataclass(frozen=True, slots=True, eq=False)
class Density:
    """How much of what orbits do falls into each of the bins of a rectangle, `value` and `error` of shape (bins, bins).

    Attributes:
        value: The mean over the orbits.
        error: Its standard error, from how the orbits differ.
        first: The edges of the bins that the rows are, one more than bins.
        second: Those of the columns.
    """

    value: Floats
    error: Floats
    first: Floats
    second: Floats


def density_of(orbit: Numbers, orbits: int, columns: tuple[Floats, Floats], edges: tuple[Floats, Floats]) -> Density:
    """How many of some places of each of so many orbits fall into each bin, the mean and its error."""
    bins = len(edges[0]) - 1
    pairs = zip(edges, columns, strict=True)
    at = [np.clip(np.searchsorted(edge, x, side="right") - 1, 0, bins - 1) for edge, x in pairs]
    cells, counts = np.unique((at[0] * bins + at[1]) * orbits + orbit, return_counts=True)
    total, squares = np.zeros(bins * bins), np.zeros(bins * bins)
    np.add.at(total, cells // orbits, counts)
    np.add.at(squares, cells // orbits, counts * counts)
    value = total / orbits
    scatter = np.maximum(squares / orbits - value * value, 0.0)
    error = np.sqrt(scatter / max(orbits - 1, 1))
    return Density(value.reshape(bins, bins), error.reshape(bins, bins), *edges)


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryMap:
    """Orbits on the outline of a table in the coordinates of Birkhoff; a row of each array is an orbit.

    Attributes:
        table: The table.
        time: When each hit is.
        arc_length: How far along the outline, loop after loop, each counterclockwise.
        sine: The sine of the angle of incidence, the part of the velocity along the outline, in [-1, 1].
    """

    table: Table
    time: Floats
    arc_length: Floats
    sine: Floats

    @spelled
    def density(self, bins: int = 10) -> Density:
        """Which share of the hits is in each bin of arc length and sine, with its error, from how the orbits differ.

        Of starts from the walls it is even, as the invariant measure is: 1/bins² in each. Raises `InvalidArgument` for
        what is no number of bins.
        """
        count = whole("bins", bins, 1, MOST_BINS)
        orbits, hits = self.sine.shape
        edges = np.linspace(0.0, self.table.perimeter, count + 1), np.linspace(-1.0, 1.0, count + 1)
        orbit = np.repeat(np.arange(orbits), hits)
        found = density_of(orbit, orbits, (self.arc_length.ravel(), self.sine.ravel()), edges)
        return Density(found.value / hits, found.error / hits, *edges)


@dataclass(frozen=True, slots=True, eq=False)
class MeanFreePath:
    """How far balls fly from wall to wall.

    Attributes:
        value: The mean over all flights.
        error: Its standard error, from how the orbits differ.
        expected: What it is for every table: π times the area over the perimeter.
        counts: How many hits each orbit had, all in the same time.
        paths: The lengths of all flights that began and ended with a hit.
    """

    value: float
    error: float
    expected: float
    counts: Numbers
    paths: Floats


@spelled
def boundary_map(
    scene: Scene | Table | str,
    n: int = 100,
    hits: int = 200,
    seed: int = 0,
    *,
    boundary: bool = True,
    speed: float = 1.0,
) -> BoundaryMap:
    """The first `hits` hits of `n` orbits of a table, as places along its outline and sines of angles.

    Args:
        scene: What `study.table` takes.
        n: How many orbits there are.
        hits: How many hits of each are kept.
        seed: What NumPy draws their starts from.
        boundary: Whether they start from the walls or anywhere in the table; see `Table.random_starts`.
        speed: Their own; likewise.

    Raises:
        InvalidArgument: The scene is no closed table, or an argument cannot be used.

    >>> from carom import study
    >>> found = study.boundary_map("circle", n=3, hits=5)
    >>> found.sine.shape, bool(abs(found.sine - found.sine[:, :1]).max() < 1e-12)
    ((3, 5), True)
    """
    room, count = table(scene), whole("hits", hits, 1, MOST_HITS)
    starts = room.random_starts(n, seed, boundary=boundary, speed=speed)
    found = [first_hits(batch, count) for batch in batches(room, starts, speed)]
    time, along, sine = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return BoundaryMap(room, time, along, sine)


@spelled
def mean_free_path(scene: Scene | Table | str, n: int = 1000, hits: int = 200, seed: int = 0) -> MeanFreePath:
    """The mean free path of a table without gravity, its error, and what it must be: π·area/perimeter.

    All orbits, which start uniformly in phase space, fly as long, so long that they have about `hits` hits each. The
    hits of each are then counted without bias, whether the table is chaotic or not. Source: L. A. Santaló, Integral
    geometry and geometric probability, 1976; N. Chernov, Entropy, Lyapunov exponents, and mean free path for
    billiards, 1997.

    Raises:
        InvalidArgument: The scene is no closed table or has gravity, or `n` is less than 2.
    """
    room, count = table(scene), whole("hits", hits, 1, MOST_HITS)
    if room.scene.world.gravity != (0.0, 0.0):
        raise unfit(room.scene, "must have no gravity")
    starts = room.random_starts(whole("n", n, 2), seed)
    expected = pi * room.area / room.perimeter
    counts, paths = [], []
    for batch in batches(room, starts, 1.0):
        found = batch.run(count * batch.free_time)
        numbers = batch.numbers(found)
        counts.append(np.bincount(numbers, minlength=batch.size))
        order = np.argsort(numbers, kind="stable")
        time = found["time"][order]
        paths.append(np.diff(time)[np.diff(numbers[order]) == 0])
    each = np.concatenate(counts)
    value = count * expected / float(each.mean())
    error = value * float(each.std(ddof=1)) / (float(each.mean()) * sqrt(len(each)))
    return MeanFreePath(value, error, expected, each, np.concatenate(paths))
