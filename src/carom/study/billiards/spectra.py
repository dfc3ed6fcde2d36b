"""Lyapunov exponents: how fast orbits that begin side by side part."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log, sqrt

import numpy as np

from carom.checks import whole
from carom.scene.scene import Scene
from carom.spelling import spelled
from carom.study.billiards.ensembles import Batch, Numbers, batches
from carom.study.billiards.maps import MOST_HITS
from carom.study.billiards.outline import Floats
from carom.study.billiards.tables import Table, table
from carom.study.billiards.tangents import Walls, impact_maps, products, times, walls_of

#: Hits whose maps are multiplied at once, about: so few that these stay in a processor's cache, so many that Python has
#: little to do.
BLOCK = 16384
#: Part of the time in which changes take the direction that grows, before it is measured how fast they do.
SETTLING = 0.25


@dataclass(frozen=True, slots=True, eq=False)
class Lyapunov:
    """The Lyapunov exponents of a table, each the logarithm of a growth in a second.

    Attributes:
        spectrum: All four, the greatest first: λ, 0, 0, -λ. Energy is kept and time has no beginning, which makes two
            of them 0; volumes in phase space are kept, which makes the others opposite.
        error: Their standard errors: how the orbits differ, and what changes grow by in a table without chaos, where
            they do so in proportion to time, which would otherwise be taken for a small exponent.
        exponents: The greatest of each orbit.
        counts: How many hits each orbit had while it was measured; λ·seconds/counts.mean() is the exponent of a hit.
        seconds: How long that was, the same for all.
    """

    spectrum: Floats
    error: Floats
    exponents: Floats
    counts: Numbers
    seconds: float


@spelled
def lyapunov(
    scene: Scene | Table | str, n: int = 100, hits: int = 1000, seed: int = 0, *, speed: float = 1.0
) -> Lyapunov:
    """The Lyapunov exponents of a table, from the tangent map along `n` orbits.

    Orbits start uniformly in phase space and fly as long, so long that they have about `hits` hits each. In the first
    quarter of that time changes settle. `spectrum` is the mean over all orbits; a table with order and chaos is better
    told by the `exponents` of each.

    Args:
        scene: What `study.table` takes, with walls that are elastic; it may have gravity.
        n: How many orbits there are, 2 at least.
        hits: How many hits each has, about; 10 at least.
        seed: What NumPy draws their starts from.
        speed: Their own; see `Table.random_starts`.

    Raises:
        InvalidArgument: The scene is no closed table of elastic walls, or an argument cannot be used.

    Source: G. Benettin, L. Galgani, A. Giorgilli and J.-M. Strelcyn, Lyapunov characteristic exponents for smooth
    dynamical systems, 1980; the tangent map is that of Ch. Dellago, H. A. Posch and W. G. Hoover, 1996.

    >>> from carom import study
    >>> found = study.lyapunov("circle", n=5, hits=40)  # has no chaos
    >>> bool(abs(found.spectrum[0]) < 2.0 * found.error[0])
    True
    """
    room, count = table(scene), whole("hits", hits, 10, MOST_HITS)
    starts = room.random_starts(whole("n", n, 2), seed, speed=speed)
    found = [_growth(batch, count) for batch in batches(room, starts, speed)]
    grown, counts = (np.concatenate(parts) for parts in zip(*((one[0], one[1]) for one in found), strict=True))
    seconds = found[0][2]
    exponents = grown / seconds
    largest, scatter = float(exponents.mean()), float(exponents.std(ddof=1)) / sqrt(len(exponents))
    error = sqrt(scatter * scatter + (log(1.0 / SETTLING) / seconds) ** 2)
    spectrum, errors = np.array([largest, 0.0, 0.0, -largest]), np.array([error, 0.0, 0.0, error])
    return Lyapunov(spectrum, errors, exponents, counts, seconds)


def _growth(batch: Batch, hits: int) -> tuple[Floats, Numbers, float]:
    """By how many e-foldings changes of a batch's orbits grow once they have settled, in how many hits and seconds."""
    walls, seconds = walls_of(batch.world, "scene"), hits * batch.free_time
    parts = ceil(hits * batch.size / BLOCK)
    settling = max(1, round(SETTLING * parts))
    pieces = [SETTLING * seconds / settling] * settling
    measured = max(1, parts - settling)
    pieces += [(1.0 - SETTLING) * seconds / measured] * measured
    # No direction is special; all orbits begin with the same change, whose parts are as large in a mean free flight.
    change = np.array([0.5, 0.7, 0.6 / batch.free_time, -0.4 / batch.free_time])[:, None, None]
    change = np.repeat(change, batch.size, axis=2)
    grown, counts = np.zeros(batch.size), np.zeros(batch.size, np.int64)
    for number, piece in enumerate(pieces):
        change, more, met = _carried(batch, walls, change, piece)
        if number >= settling:
            grown += more
            counts += met
    return grown, counts, (1.0 - SETTLING) * seconds


def _carried(batch: Batch, walls: Walls, change: Floats, seconds: float) -> tuple[Floats, Floats, Numbers]:
    """Changes so many seconds later, scaled to a size of 1, the logarithms of their growth, and the hits of each orbit.

    `change` has the shape (4, 1, orbits).
    """
    last, radius = np.full(batch.size, batch.world.time), float(batch.world.balls.radius[0])
    flights = batch.flights(seconds)
    met = flights.counts > 0
    last[met] = flights.ends["time"][np.cumsum(flights.counts)[met] - 1]
    maps, grown = products(impact_maps(walls, flights.ends, flights.lengths, radius), flights.counts)
    change = times(maps, change)
    change[:2] += (batch.world.time - last) * change[2:]
    weighed = change * np.array([1.0, 1.0, batch.free_time, batch.free_time])[:, None, None]
    size = np.sqrt(np.sum(weighed * weighed, axis=(0, 1)))
    return change / size, grown + np.log(size), flights.counts
