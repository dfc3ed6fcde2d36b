"""What there is to be seen at each frame of a recording."""

from __future__ import annotations

from dataclasses import replace
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np

from carom.checks import instance
from carom.draw.history.trace import MOST_HITS, followed
from carom.draw.history.tracks import Track, centers_at, thinned
from carom.draw.parts.cells import cells_of
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer, layers_of
from carom.draw.parts.legend import remarks, seconds
from carom.draw.parts.looks import LOOKS, look_now, material_of
from carom.draw.parts.moment import Balls, Drawn, Measures, Moment, bounces_of, latest_of, strongest
from carom.draw.parts.outlines import ends_of
from carom.draw.parts.panel import Panel
from carom.draw.picture import TRACK_TOLERANCE, box_around, checked_shares, composed
from carom.draw.theme import BALL_INKS
from carom.record.recording import Recording
from carom.spelling import spelled

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from carom.draw.parts.cells import Cell
    from carom.draw.parts.frame import Size
    from carom.draw.picture import Picture
    from carom.rows.tables import Rows

#: Seconds of tracks and of hits in the picture of a frame that stands alone.
LONG = 20.0


class Footage:
    """A recording, made ready to be drawn frame by frame."""

    def __init__(self, recording: Recording) -> None:
        self.recording = instance("recording", recording, Recording, "a Recording")
        self.bounces = bounces_of(recording.hits)
        self.measures = Measures.of(self.bounces, recording.velocities)
        self._shapes = recording.shapes_at(0)
        ids = recording.shape_ids.tolist()
        colliding = recording.colliding
        changing = np.isin(recording.shape_ids, recording.moving) | (colliding != colliding[0]).any(axis=0)
        ends = ends_of(self._shapes)
        materials = [material_of(shape, ends) for shape in self._shapes]
        self._order = sorted(range(len(ids)), key=lambda place: LOOKS.index(materials[place]))
        self._materials = materials
        self._changing = [place for place in self._order if changing[place]]
        self.still = tuple(self._drawn(place) for place in self._order if not changing[place])
        self.followed: list[int] = followed(recording.ids).tolist()
        self.inks = dict(zip(self.followed, cycle(BALL_INKS), strict=False))
        self.tracks: tuple[Track, ...] = tuple(self._track(ball) for ball in self.followed)
        self.box = box_around([(one.shape, one.look) for one in self._all()], self._everywhere())

    def _all(self) -> tuple[Drawn, ...]:
        """All shapes as they stand now."""
        return tuple(self._drawn(place) for place in self._order)

    def _everywhere(self) -> Balls:
        """All balls at all places where they were."""
        frames, columns = np.nonzero(~np.isnan(self.recording.positions[:, :, 0]))
        places = self.recording.positions[frames, columns]
        return Balls(places, self.recording.radii[columns], self.recording.ids[columns])

    def _drawn(self, place: int) -> Drawn:
        """A shape as it stands now."""
        shape = self._shapes[place]
        look = look_now(shape, self._materials[place])
        return Drawn(shape, look, int(self.recording.shape_ids[place]), shape._whole)

    def _track(self, ball: int) -> Track:
        """The way of a ball through the whole run."""
        recording = self.recording
        column = int(np.searchsorted(recording.ids, ball))
        points = recording.positions[:, column]
        there = ~np.isnan(points[:, 0])
        bounce_times, centers = centers_at(self.bounces, ball, float(recording.radii[column]))
        # A bounce at a step's end stands before where the ball was then: it may have moved on since.
        times = np.concatenate([bounce_times, recording.times[there]])
        order = np.argsort(times, kind="stable")
        return Track(ball, times[order], np.concatenate([centers, points[there]])[order])

    def moment(self, frame: int, span: float, most: int = MOST_HITS) -> Moment:
        """What there is to be seen at a frame, with the tracks and at `most` so many hits of `span` seconds before it.

        Valid until another one is asked for: shapes that move are the same objects each time.
        """
        recording = self.recording
        recording.pose(self._shapes, frame)
        time = float(recording.times[frame])
        there = ~np.isnan(recording.positions[frame, :, 0])
        balls = Balls(
            recording.positions[frame, there],
            recording.radii[there],
            recording.ids[there],
            recording.velocities[frame, there],
        )
        now = set(balls.ids.tolist())
        tracks = tuple(track for track in self.tracks if track.ball in now and track.times[0] < time)
        begin = max(float(recording.times[0]), time - span)
        return Moment(
            time,
            balls,
            tuple(self._drawn(place) for place in self._changing),
            tracks,
            begin,
            strongest(self._between(begin, time), most),
            latest_of(self._between(recording.times[0], time), time),
        )

    def _between(self, begin: float, end: float) -> Rows:
        """The bounces from one time to another."""
        first = int(np.searchsorted(self.bounces["time"], begin, side="left"))
        return self.bounces[first : int(np.searchsorted(self.bounces["time"], end, side="right"))]

    def facts(self, frame: int) -> tuple[tuple[str, str], ...]:
        """The panel's numbers at a frame."""
        recording = self.recording
        balls = len(recording.ids) - int(np.count_nonzero(np.isnan(recording.positions[frame, :, 0])))
        time = float(recording.times[frame])
        hits = int(np.searchsorted(self.bounces["time"], time, side="right"))
        return ("time", seconds(time)), ("balls", f"{balls:,}"), ("hits", f"{hits:,}")

    def picture(
        self,
        frame: int,
        span: float,
        *,
        shares: Sequence[tuple[str, int]] = (),
        layers: Collection[Layer] = DEFAULT_LAYERS,
        size: Size = None,
    ) -> Picture:
        """The picture of a frame."""
        shown, recording, moment = layers_of(layers), self.recording, self.moment(frame, span)
        cells: tuple[Cell, ...] = ()
        if Layer.CELLS in shown:
            cells = cells_of(recording.scene, float(recording.radii.max(initial=0.0)))
        seen, bounces = moment.time - moment.since, len(self._between(moment.since, moment.time))
        notes = remarks(shown, len(self.tracks), len(recording.ids), seen, bounces, cells)
        picture = composed(
            Panel(recording.name, recording.about, self.facts(frame), checked_shares(shares), notes=notes),
            self.still,
            moment,
            self.box,
            layers=shown,
            size=size,
            inks=self.inks,
            names=dict(recording.names),
            cells=cells,
            measures=self.measures,
            of_run=True,
            empty=[
                layer for layer, there in ((Layer.TRACKS, self.tracks), (Layer.HITS, self.bounces)) if not len(there)
            ],
        )
        tolerance = picture.frame.units(TRACK_TOLERANCE)
        self.tracks = tuple(thinned(track, tolerance, in_time=True) for track in self.tracks)
        return replace(picture, moment=self.moment(frame, span))


@spelled
def picture_at(
    recording: Recording,
    frame: int = -1,
    *,
    shares: Sequence[tuple[str, int]] = (),
    layers: Collection[Layer] = DEFAULT_LAYERS,
    size: Size = None,
) -> Picture:
    """The picture of a frame of a recording, the last one by default, with the tracks and hits before it.

    Raises:
        InvalidArgument: There is no such frame, layer or size.
    """
    return Footage(recording).picture(frame, LONG, shares=shares, layers=layers, size=size)
