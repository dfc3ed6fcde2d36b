"""Poincaré sections: where orbits cross a line, and how."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import ArrayLike

from carom.checks import array, refuse, whole
from carom.rows.kinds import is_straight
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import SegmentDescriptor
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.study.billiards.ensembles import Batch, Numbers, batches
from carom.study.billiards.maps import MOST_BINS, MOST_HITS, Density, density_of
from carom.study.billiards.outline import Floats
from carom.study.billiards.tables import Table, table
from carom.typing import Vector
from carom.world.boundary import ends_of


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """The crossings of a line from its right to its left, orbit after orbit, each in order of time.

    Attributes:
        cut: The ends of the line; right and left are as seen from the first to the second.
        orbit: Whose each crossing is, from 0.
        time: When it is.
        distance: How far it is from the line's first end.
        along: The velocity along the line, positive towards its second end.
        across: The velocity across it, positive.
        seconds: How long each orbit was followed.
        orbits: How many there were.
        speed: The greatest of a ball.
    """

    cut: tuple[Vector, Vector]
    orbit: Numbers
    time: Floats
    distance: Floats
    along: Floats
    across: Floats
    seconds: float
    orbits: int
    speed: float

    @spelled
    def density(self, bins: int = 10) -> Density:
        """How many crossings a second an orbit has in each bin of distance and of the velocity along the line.

        The mean of all orbits, with its error, from how they differ. Without gravity it is even:
        speed·length/(π·area·bins²) in each. Raises `InvalidArgument` for what is no number of bins.
        """
        count = whole("bins", bins, 1, MOST_BINS)
        (ax, ay), (bx, by) = self.cut
        edges = np.linspace(0.0, hypot(bx - ax, by - ay), count + 1), np.linspace(-self.speed, self.speed, count + 1)
        found = density_of(self.orbit, self.orbits, (self.distance, self.along), edges)
        return Density(found.value / self.seconds, found.error / self.seconds, *edges)


@spelled
def section(
    scene: Scene | Table | str,
    cut: Segment | str | ArrayLike,
    n: int = 100,
    hits: int = 200,
    seed: int = 0,
    *,
    speed: float = 1.0,
) -> Section:
    """Where `n` orbits cross a line in a table from its right to its left, and with what velocity.

    Places and times are those at which the way between two hits, a straight line or a parabola, is on the line. Orbits
    start uniformly in phase space. Without gravity, and where no wall stands on the line, crossings are uniform in
    `distance` and `along`, and there are speed·length/(π·area) a second of each orbit.

    Args:
        scene: What `study.table` takes.
        cut: The line: its two ends, a `Segment`, or the name of a segment in the scene, such as a sensor. For crossings
            from left to right its ends are given the other way round.
        n: How many orbits there are.
        hits: How many hits of each are followed, on average.
        seed: What NumPy draws their starts from.
        speed: Their own; see `Table.random_starts`.

    Raises:
        InvalidArgument: The scene is no closed table, or an argument cannot be used.

    >>> from carom import scenes, study
    >>> found = study.section(scenes.circle(radius=1.0), ((0, 0), (1, 0)), n=5, hits=20)
    >>> momentum = found.distance * found.across  # about the middle, which the wall does not change
    >>> bool(np.ptp(momentum[found.orbit == found.orbit[0]]) < 1e-12)
    True
    """
    room, count = table(scene), whole("hits", hits, 1, MOST_HITS)
    ends = _ends(room, cut)
    starts = room.random_starts(n, seed, speed=speed)
    found, seconds = [], 0.0
    for batch in batches(room, starts, speed):
        seconds = count * batch.free_time
        found.append(_crossings(batch, seconds, ends))
    orbit, time, distance, along, across = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return Section(ends, orbit, time, distance, along, across, seconds, len(starts.position), float(speed))


def _ends(room: Table, cut: Segment | str | ArrayLike) -> tuple[Vector, Vector]:
    """The ends of the line that a cut is."""
    if isinstance(cut, str):
        named = [shape for shape in room.scene.shapes if shape.name == cut and isinstance(shape, SegmentDescriptor)]
        if len(named) != 1:
            raise refuse("cut", "must be the name of one segment in the scene", cut)
        return named[0].start, named[0].end
    if isinstance(cut, Shape) and is_straight(cut._row["kind"]):
        return ends_of(cut)
    (ax, ay), (bx, by) = array("cut", cut, (2, 2)).tolist()
    if (ax, ay) == (bx, by):
        raise refuse("cut", "must have two ends apart", cut)
    return (ax, ay), (bx, by)


def _crossings(
    batch: Batch, seconds: float, ends: tuple[Vector, Vector]
) -> tuple[Numbers, Floats, Floats, Floats, Floats]:
    """Whose the crossings in so many seconds are, their times and distances, and the velocities along and across.

    A time u before its end, a flight is at r - v u + g u²/2. It crosses from right to left where its velocity across
    is the positive root of that at the end, squared, less 2 g times the height over the line.
    """
    (ax, ay), (bx, by) = ends
    length = hypot(bx - ax, by - ay)
    way = np.array([(bx - ax) / length, (by - ay) / length])
    normal = np.array([-way[1], way[0]])
    gravity = np.array(batch.table.scene.world.gravity)
    orbit, time, lasting, position, velocity = _ways(batch, seconds)
    away = position - np.array([ax, ay])
    height, speed, pull = away @ normal, velocity @ normal, float(gravity @ normal)
    squared = speed * speed - 2.0 * pull * height
    across = np.sqrt(np.maximum(squared, 0.0))
    # Of the two forms of one root, that in which nothing cancels.
    plain = speed > 0.0
    above, below = np.where(plain, 2.0 * height, speed - across), np.where(plain, speed + across, pull)
    before = np.divide(above, below, out=np.full(len(height), -1.0), where=below != 0.0)
    distance = away @ way - before * (velocity @ way) + 0.5 * float(gravity @ way) * before * before
    on = (squared > 0.0) & (before >= 0.0) & (before < lasting) & (distance >= 0.0) & (distance <= length)
    along = velocity @ way - before * float(gravity @ way)
    return orbit[on], (time - before)[on], distance[on], along[on], across[on]


def _ways(batch: Batch, seconds: float) -> tuple[Numbers, Floats, Floats, Floats, Floats]:
    """The ways of a batch's orbits, flight after flight, the last of each up to the end of so many seconds.

    For each: whose it is, when it ends and how long it takes, and the place and the velocity at its end.
    """
    ends, lengths, counts = batch.flights(seconds)
    balls, now = batch.world.balls, batch.world.time
    begins = np.cumsum(counts) - counts
    last = np.full(batch.size, now - seconds)
    last[counts > 0] = ends["time"][(begins + counts - 1)[counts > 0]]
    behind = begins + counts
    return (
        batch.first + np.repeat(np.arange(batch.size), counts + 1),
        np.insert(ends["time"], behind, now),
        np.insert(lengths, behind, now - last),
        np.insert(ends["position"], behind, balls.position, axis=0),
        np.insert(ends["velocity"], behind, balls.velocity, axis=0),
    )
