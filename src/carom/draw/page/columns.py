"""What moves and what happens in a recording, as columns of the replay page."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.page.packing import Plain, measured, packed, sizes
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.record import Recording
    from carom.rows.tables import Rows
    from carom.shapes.aabb import Aabb

#: Units of places on a stage's longer side, of a run's length, of a turn: a unit is below a thousandth of a pixel. Hit
#: points and normals do with fewer, which saves the bytes that cannot be deflated.
PLACES, MOMENTS, TURNS = 2**20, 2**30, 2**20
HIT_PLACES, HIT_TURNS = 2**18, 2**14
#: Balls farther from the stage than this many of its sides are not shown.
FARTHEST = 1000.0
#: How many hits a page holds at most: they are what makes pages large.
MOST_HITS = 100_000
#: The states of a ball: not there, there, there and asleep.
ABSENT, AWAKE, ASLEEP = 0, 1, 2


@dataclass(frozen=True, slots=True)
class Units:
    """What is counted in: the stage's lower left corner, its longer side, the first time, and the run's length."""

    left: float
    bottom: float
    side: float
    start: float
    span: float

    @classmethod
    def of(cls, recording: Recording, stage: Aabb) -> Units:
        """The units of a recording on a stage."""
        side = max(stage.right - stage.left, stage.top - stage.bottom)
        return cls(stage.left, stage.bottom, side, float(recording.times[0]), recording.duration or 1.0)

    def xs(self, values: NDArray[np.float64], order: int, places: int = PLACES) -> Plain:
        """A column of x coordinates."""
        return measured(values, self.left, self.side / places, order)

    def ys(self, values: NDArray[np.float64], order: int, places: int = PLACES) -> Plain:
        """A column of y coordinates."""
        return measured(values, self.bottom, self.side / places, order)

    def moments(self, values: NDArray[np.float64], order: int) -> Plain:
        """A column of times."""
        return measured(values, self.start, self.span / MOMENTS, order)


def ball_columns(recording: Recording, units: Units) -> Plain:
    """Where each ball is at each frame, and its state: a row for each ball."""
    xs, ys = recording.positions[:, :, 0].T, recording.positions[:, :, 1].T
    farthest = FARTHEST * units.side
    with np.errstate(invalid="ignore"):
        there = (np.abs(xs - units.left) < farthest) & (np.abs(ys - units.bottom) < farthest)
    states = np.where(there, np.where(recording.asleep.T, ASLEEP, AWAKE), ABSENT)
    return {
        "x": units.xs(filled(xs, there, units.left), 2),
        "y": units.ys(filled(ys, there, units.bottom), 2),
        "states": packed(states, 1),
    }


def filled(values: NDArray[np.float64], there: NDArray[np.bool_], value: float) -> NDArray[np.float64]:
    """`values` with the last one before in place of those that are not `there`, and `value` before the first."""
    if values.size == 0:
        return values
    last = np.maximum.accumulate(np.where(there, np.arange(values.shape[1]), -1), axis=1)
    before = np.take_along_axis(np.where(there, values, value), np.maximum(last, 0), axis=1)
    return np.where(last < 0, value, before)


def pose_columns(recording: Recording, units: Units) -> Plain:
    """How the moving shapes stand at each frame: a row for each of them."""
    poses = recording.poses
    return {
        "x": units.xs(poses[:, :, 0].T, 2),
        "y": units.ys(poses[:, :, 1].T, 2),
        "turns": measured(poses[:, :, 2].T % (2.0 * pi), 0.0, 2.0 * pi / TURNS, 2),
    }


def kept_hits(hits: Rows) -> Rows:
    """The hits that a page holds, in order of time: all, or what happened at sensors and the strongest bounces."""
    if len(hits) <= MOST_HITS:
        return hits
    rank = np.where(hits["kind"] == HitKind.BOUNCE, -hits["impulse"], -np.inf)
    return hits[np.sort(np.argsort(rank, kind="stable")[:MOST_HITS])]


def hit_columns(recording: Recording, units: Units) -> Plain:
    """The hits: balls by number, shapes likewise, and after the shapes the balls that were hit."""
    hits = kept_hits(recording.hits)
    balls = numbers_of(hits["ball"], recording.ids)
    shapes = numbers_of(hits["shape"], recording.shape_ids)
    partners = len(recording.shape_ids) + numbers_of(hits["shape"], recording.ids)
    points, normals = hits["point"], hits["normal"]
    return {
        "total": len(recording.hits),
        "time": units.moments(hits["time"], 1),
        "kind": packed(hits["kind"], 0),
        "ball": packed(balls, 0),
        "thing": packed(np.where(shapes < len(recording.shape_ids), shapes, partners), 0),
        "x": units.xs(points[:, 0], 0, HIT_PLACES),
        "y": units.ys(points[:, 1], 0, HIT_PLACES),
        "normal": measured(np.arctan2(normals[:, 1], normals[:, 0]), 0.0, 2.0 * pi / HIT_TURNS, 0),
        "speed": sizes(hits["speed"]),
        "impulse": sizes(hits["impulse"]),
    }


def numbers_of(members: NDArray[np.int64], ids: NDArray[np.int64]) -> NDArray[np.int64]:
    """The place of each of `members` in `ids`, all different; `len(ids)` for one that is not there."""
    if len(ids) == 0:
        return np.zeros(len(members), np.int64)
    order = np.argsort(ids)
    places = order[np.minimum(np.searchsorted(ids[order], members), len(ids) - 1)]
    return np.where(ids[places] == members, places, len(ids))
