"""`Recording`: what a run was, as arrays over frames, hits, and the scene that it began with."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from carom import checks
from carom.pictured import Played
from carom.record.check import check_recording
from carom.record.files import read_recording, write_recording
from carom.record.hits import RecordedHits
from carom.record.members import put, shapes_of
from carom.shapes.label import label_of
from carom.spelling import spelled

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Mapping

    from numpy.typing import NDArray

    from carom.rows.tables import Rows
    from carom.scene.scene import Scene
    from carom.shapes.shape import Shape
    from carom.world.world import World


@spelled
@dataclass(frozen=True, eq=False, repr=False)
class Recording(Played):
    """What a run was: n frames of m balls, frame 0 the beginning.

    `Recording.of(world, seconds)` makes one, `Recorder` one of steps that someone else makes, `load` reads one. Nothing
    in it can be changed; arrays are read-only. Arguments that do not fit each other raise `RecordingError`.

    Attributes:
        scene: The world as it stood at frame 0.
        name: What the run is called.
        about: A line about it.
        times: (n,) the world's time at each frame, in seconds, not descending.
        ids: (m,) the ids of all balls that were there at some frame, ascending.
        radii: (m,) of these balls.
        masses: (m,) of these balls.
        positions: (n, m, 2) their centres; NaN where a ball is not there.
        velocities: (n, m, 2) likewise.
        asleep: (n, m) whether they sleep.
        shape_ids: (s,) the ids of the single shapes of frame 0, the parts of compounds and groups in place of these, in
            the order of the scene; shapes that are added later are not recorded.
        colliding: (n, s) `can_collide` of each, False too once it has left the world.
        moving: (k,) the ids of those that were kinematic at frame 0.
        poses: (n, k, 3) their pivots, x and y, and orientations.
        hits: Every hit of the run as a structured array, in order of time; fields as those of `Hits`, ids for objects.
        names: The names of shapes and balls that have one, by id.
        statistics: The world's counters at the end, by name.
    """

    scene: Scene
    times: NDArray[np.float64]
    ids: NDArray[np.int64]
    radii: NDArray[np.float64]
    masses: NDArray[np.float64]
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]
    asleep: NDArray[np.bool_]
    shape_ids: NDArray[np.int64]
    colliding: NDArray[np.bool_]
    moving: NDArray[np.int64]
    poses: NDArray[np.float64]
    hits: Rows
    names: Mapping[int, str]
    statistics: Mapping[str, int]
    name: str = ""
    about: str = ""

    def __post_init__(self) -> None:
        for field, value in check_recording(self).items():
            object.__setattr__(self, field, RecordedHits.of(self, value) if field == "hits" else value)

    def __reduce__(self) -> Any:
        """The fields, plain arrays and tables, of which the same recording is made."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        values |= {"hits": np.asarray(self.hits), "names": dict(self.names), "statistics": dict(self.statistics)}
        return type(self), tuple(values.values())

    @staticmethod
    @spelled
    def of(
        world: World,
        seconds: float,
        dt: float = 1 / 60,
        *,
        every: int = 1,
        name: str = "",
        about: str = "",
        progress: Callable[[float, float], Any] | None = None,
    ) -> Recording:
        """The recording of a run of `round(seconds / dt)` steps, which the world makes now.

        Args:
            world: The world, which goes on from where it is.
            seconds: How long, in seconds of the world's time; not negative.
            dt: The length of a step; positive.
            every: A frame is taken after so many steps, and at the end.
            name: What the run is called.
            about: A line about it.
            progress: Called with the seconds done and the seconds in all, after each frame.

        Raises:
            As `World.run`.
        """
        from carom.record.recorder import recorded

        return recorded(world, seconds, dt, every, name, about, progress)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The recording in a file that `save` wrote; raises `RecordingError`, with the file's name, for any other."""
        return read_recording(cls, path)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file that loads as the same recording, bit for bit.

        The file is complete or as it was before, whatever happens. Raises `RecordingError` where it cannot be written.
        """
        write_recording(self, path)

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"<recording of {len(self)} frames, {len(self.ids)} balls, {len(self.hits)} hits>"

    @property
    def duration(self) -> float:
        """Seconds from the first frame to the last."""
        return float(self.times[-1] - self.times[0])

    def frame_at(self, time: float) -> int:
        """The last frame that is not after `time`, which is a finite number; the first one for times before it."""
        time = checks.number("time", time)
        return max(0, int(np.searchsorted(self.times, time, side="right")) - 1)

    def kinetic_energy(self) -> NDArray[np.float64]:
        """The kinetic energy of the balls that are there, at each frame: (n,)."""
        squares = np.nansum(self.velocities * self.velocities, axis=2)
        energies: NDArray[np.float64] = 0.5 * (squares @ self.masses)
        return energies

    def energy(self) -> NDArray[np.float64]:
        """Kinetic energy and that of position in the scene's gravity, 0 at the origin, at each frame: (n,)."""
        heights = np.nansum(self.positions * np.asarray(self.scene.world.gravity), axis=2)
        energies: NDArray[np.float64] = self.kinetic_energy() - heights @ self.masses
        return energies

    def label_of(self, member_id: int) -> str:
        """What to call the shape or ball with an id: its name, what and where a shape was at frame 0, or `ball 7`.

        A shape that was added later is `shape 9`.
        """
        member_id = checks.whole("member_id", member_id, 0, 2**63 - 1)
        kind = "ball" if member_id in self.ball_ids else "shape"
        return self.names.get(member_id) or self._labels.get(member_id) or f"{kind} {member_id}"

    def shapes_at(self, frame: int) -> list[Shape]:
        """New shapes, of no world, as they stood at a frame, in the order of `shape_ids`; those gone are switched off.

        Raises:
            InvalidArgument: There is no such frame; negative ones count from the end.
        """
        shapes = shapes_of(self.scene)
        self.pose(shapes, frame)
        return shapes

    def pose(self, shapes: list[Shape], frame: int) -> None:
        """Make `shapes`, which `shapes_at` has made, what they were at another frame.

        Raises:
            InvalidArgument: There is no such frame, or it has other shapes.
        """
        checks.whole("frame", frame, -len(self), len(self) - 1)
        given = checks.instance("shapes", shapes, list, "a list of shapes")
        if [type(shape) for shape in given] != self._kinds:
            raise checks.refuse("shapes", "must be those that shapes_at has made", shapes)
        for shape, colliding in zip(shapes, self.colliding[frame].tolist(), strict=True):
            shape._row["can_collide"] = colliding
        for index, (x, y, orientation) in zip(self._moving_indices.tolist(), self.poses[frame].tolist(), strict=True):
            put(shapes[index], x, y, orientation)

    @cached_property
    def _moving_indices(self) -> NDArray[np.intp]:
        """Where the shapes that move stand among all."""
        order = np.argsort(self.shape_ids)
        indices: NDArray[np.intp] = order[np.searchsorted(self.shape_ids[order], self.moving)]
        return indices

    @cached_property
    def _kinds(self) -> list[type[Shape]]:
        """The classes of the shapes."""
        return [type(shape) for shape in shapes_of(self.scene)]

    @cached_property
    def ball_ids(self) -> frozenset[int]:
        """The ids of all balls, of those too that came and went between two frames."""
        return frozenset(self.ids.tolist()).union(self.hits["ball"].tolist())

    @cached_property
    def _labels(self) -> dict[int, str]:
        """What to call the shapes, by id."""
        return {int(key): label_of(shape) for key, shape in zip(self.shape_ids, shapes_of(self.scene), strict=True)}
