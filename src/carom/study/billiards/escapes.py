"""Escape through a hole, and how fast a ball forgets its direction."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np

from carom.checks import pair, positive, refuse, whole
from carom.scene.scene import Scene
from carom.spelling import spelled
from carom.study.billiards.ensembles import Batch, batches
from carom.study.billiards.outline import Floats
from carom.study.billiards.tables import Table, table
from carom.typing import Pair

#: Times in a curve of survival.
LOOKS = 400
#: Parts of a run, after each of which the orbits that have left are followed no more.
PARTS = 20
#: Mean free paths after which the rate of escape is measured, by default: what starts in sight of the hole is gone.
SETTLED = 10.0
#: Steps of a correlation at most.
MOST_STEPS = 1_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Escape:
    """How long orbits stay in a table with a hole.

    Attributes:
        time: Times, evenly from 0 to the end.
        survival: The share of all orbits that are still there.
        error: Its standard error.
        times: When each orbit hit the hole; infinite where it did not.
        rate: The rate of escape, orbits a second of those that are there, from `since` on.
        rate_error: Its standard error; infinite where none escaped, as the rate is 0 then.
        since: From when on it was measured.
        expected: What it is to first order in the hole where orbits are chaotic: speed·hole/(π·area).
    """

    time: Floats
    survival: Floats
    error: Floats
    times: Floats
    rate: float
    rate_error: float
    since: float
    expected: float


@dataclass(frozen=True, slots=True, eq=False)
class Correlation:
    """The autocorrelation of velocity.

    Attributes:
        time: Times, evenly from 0 to the end.
        value: The mean of v(0)·v(t), in parts of that of v(0)².
        error: Its standard error, from how the orbits differ.
    """

    time: Floats
    value: Floats
    error: Floats


@spelled
def escape(
    scene: Scene | Table | str,
    hole: Pair,
    n: int = 10_000,
    seconds: float = 100.0,
    seed: int = 0,
    *,
    since: float | None = None,
    speed: float = 1.0,
) -> Escape:
    """How many of `n` orbits are still in a table after times up to `seconds`, if they leave by a hole in its wall.

    Args:
        scene: What `study.table` takes.
        hole: Where it begins and where it ends, as arc lengths along the outline, as `boundary_map` has them.
        n: How many orbits there are; they start uniformly in phase space.
        seconds: How long they are followed.
        seed: What NumPy draws them from.
        speed: Their own; see `Table.random_starts`.
        since: From when on the rate is measured; by default from ten mean free paths on.

    Raises:
        InvalidArgument: The scene is no closed table, or an argument cannot be used.

    The rate is the likeliest for exponential decay, with those that survive. Source of what is expected: W. Bauer and
    G. F. Bertsch, Decay of ordered and chaotic systems, 1990.
    """
    room, last = table(scene), positive("seconds", seconds)
    begin, end = pair("hole", hole)
    if not 0.0 <= begin < end <= room.perimeter:
        raise refuse("hole", f"must be two arc lengths from 0 to {room.perimeter!r}, the lesser first", hole)
    starts = room.random_starts(whole("n", n, 2), seed, speed=speed)
    first = positive("since", SETTLED * pi * room.area / (room.perimeter * speed) if since is None else since)
    if first >= last:
        if since is None:
            raise refuse("seconds", f"must be more than ten mean free times, {first!r}", last)
        raise refuse("since", f"must be less than seconds={last!r}", since)
    times = np.full(len(starts.position), np.inf)
    for batch in batches(room, starts, speed):
        _follow(batch, (begin, end), last, times[batch.first : batch.first + batch.size])
    time = np.linspace(0.0, last, LOOKS + 1)
    survival = 1.0 - np.searchsorted(np.sort(times), time, side="right") / len(times)
    error = np.sqrt(survival * (1.0 - survival) / len(times))
    later = times[times > first]
    gone = int(np.count_nonzero(np.isfinite(later)))
    at_risk = float(np.sum(np.minimum(later, last) - first))
    rate = gone / at_risk if gone else 0.0
    rate_error = rate / sqrt(gone) if gone else np.inf
    return Escape(time, survival, error, times, rate, rate_error, first, speed * (end - begin) / (pi * room.area))


def _follow(batch: Batch, hole: Pair, seconds: float, times: Floats) -> None:
    """Note in `times` when each orbit of a batch hits the hole, if it does within so many seconds.

    Now and then those that have left are let go, for in a long run they are nearly all.
    """
    begin, end = hole
    for _ in range(PARTS):
        found = batch.run(seconds / PARTS)
        along, _ = batch.boundary(found)
        out = (along >= begin) & (along < end)
        np.minimum.at(times, batch.numbers(found)[out], found["time"][out])
        there = np.isinf(times)
        if not there.any():
            return
        batch.world.balls.can_collide[:] = there


@spelled
def correlation(
    scene: Scene | Table | str,
    n: int = 1000,
    seconds: float = 10.0,
    steps: int = 200,
    seed: int = 0,
    *,
    speed: float = 1.0,
) -> Correlation:
    """How much of their velocity balls still have after times up to `seconds`, on average over `n` orbits.

    They start uniformly in phase space (`seed` and `speed`: see `Table.random_starts`). Without gravity it begins with
    the slope -4/3 a mean free time in every table, as the mean of cos² of the angles of incidence is 2/3.

    Raises:
        InvalidArgument: The scene is no closed table, or an argument cannot be used.
    """
    room, last = table(scene), positive("seconds", seconds)
    looks = whole("steps", steps, 1, MOST_STEPS)
    starts = room.random_starts(whole("n", n, 2), seed, speed=speed)
    sums, squares = np.zeros(looks + 1), np.zeros(looks + 1)
    for batch in batches(room, starts, speed):
        world = batch.world
        before = world.balls.velocity.copy()
        for look in range(looks + 1):
            if look:
                world.run(last / looks, last / looks, keep="none")
            product = np.sum(before * world.balls.velocity, axis=1)
            sums[look] += product.sum()
            squares[look] += (product * product).sum()
    count = len(starts.position)
    mean = sums / count
    error = np.sqrt(np.maximum(squares / count - mean * mean, 0.0) / (count - 1))
    return Correlation(np.linspace(0.0, last, looks + 1), mean / mean[0], error / mean[0])
