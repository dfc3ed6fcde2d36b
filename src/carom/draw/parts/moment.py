"""What there is to be seen at one time, wherever it comes from: a world as it stands, or a frame of a recording."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from carom.rows.hit import HIT
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from carom.draw.history.tracks import Track
    from carom.draw.paint.painter import Points
    from carom.draw.parts.looks import Look
    from carom.rows.tables import Rows
    from carom.shapes.assembly import Assembly
    from carom.shapes.shape import Shape
    from carom.world.world import World

#: Seconds for which a hit is one of the latest, and how many of these there are at most.
LATEST, MOST_LATEST = 1.0, 24
#: The hits weaker than the strongest have sizes relative to this quantile of the impulses, so that one blow in a
#: thousand does not make dust of all others. Speeds likewise.
STRONG = 0.95


def no_points() -> Points:
    """No points, (0, 2)."""
    return np.zeros((0, 2))


@dataclass(frozen=True, slots=True)
class Balls:
    """The balls as they stand: `centers` (n, 2), `radii` (n,), `ids` (n,), `velocities` (n, 2)."""

    centers: Points
    radii: NDArray[np.float64]
    ids: NDArray[np.int64]
    velocities: Points = field(default_factory=no_points)

    @classmethod
    def of(cls, world: World) -> Balls:
        """The balls of a world as they stand now."""
        balls = world.balls
        # Not the column of radii: that may be written to, so those who ask for it wake the balls that sleep.
        radii = world._arrays.balls.used["radius"]
        return cls(balls.position.copy(), radii.copy(), balls.id.copy(), balls.velocity.copy())


@dataclass(frozen=True, slots=True)
class Drawn:
    """A single shape as it is drawn: how it looks, its id where it was recorded, and what it is a part of."""

    shape: Shape
    look: Look
    id: int
    whole: Assembly | None = None  # kept here too, for the copy of a part alone is free


@dataclass(frozen=True, slots=True)
class Moment:
    """What there is to be seen at one time."""

    time: float
    balls: Balls
    moving: tuple[Drawn, ...] = ()  # the shapes that are not always where and what they are now
    tracks: tuple[Track, ...] = ()
    since: float = 0.0  # the time at which tracks begin
    hits: Rows = field(default_factory=lambda: np.zeros(0, HIT))  # bounces, the strongest first
    latest: Rows = field(default_factory=lambda: np.zeros(0, HIT))  # bounces, the last one last


@dataclass(frozen=True, slots=True)
class Measures:
    """What sizes of marks are relative to: an impulse and speeds that few hits and balls of the run exceed."""

    impulse: float
    impact_speed: float
    speed: float

    @classmethod
    def of(cls, bounces: Rows, velocities: Points) -> Measures:
        """The measures of some bounces, and of balls' velocities (n, 2), among which may be NaN."""
        speeds = np.sqrt(np.sum(velocities * velocities, axis=-1)).ravel()
        return cls(strong(bounces["impulse"]), strong(bounces["speed"]), strong(speeds[speeds > 0.0]))


def strong(values: NDArray[np.float64]) -> float:
    """The value that few of some values exceed; 1 where there are none, or all are 0."""
    return (float(np.quantile(values, STRONG)) if len(values) else 0.0) or 1.0


def bounces_of(hits: Rows) -> Rows:
    """The bounces among `hits`."""
    rows: Rows = np.asarray(hits)
    return np.compress(rows["kind"] == HitKind.BOUNCE, rows)


def strongest(bounces: Rows, most: int) -> Rows:
    """The `most` strongest of some bounces, the strongest first; of equally strong ones, the earliest."""
    return np.take(bounces, np.argsort(-bounces["impulse"], kind="stable")[:most])


def latest_of(bounces: Rows, time: float) -> Rows:
    """The bounces of the last `LATEST` seconds before `time`, the last `MOST_LATEST` of them."""
    return bounces[bounces["time"] > time - LATEST][-MOST_LATEST:]
