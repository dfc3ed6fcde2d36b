"""`Recorder`: notes a world's state after each step, for a `Recording`."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from carom import checks
from carom.errors import RecordingError
from carom.record.members import names_in, parts
from carom.record.recording import Recording
from carom.rows.hit import HIT
from carom.rows.shape import KINEMATIC
from carom.scene.scene import Scene
from carom.shapes.ball import Ball
from carom.shapes.label import name_of
from carom.spelling import spelled
from carom.world.hits import rows_of
from carom.world.tables import joined
from carom.world.world import MOST_STEPS, World

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from carom.rows.tables import Rows

#: What is noted of a ball at a frame.
BALL_FIELDS = ["id", "x", "y", "vx", "vy", "radius", "mass", "asleep"]


@spelled
class Recorder:
    """Follows a world; `note` is to be called after each step, `finish` at the end.

    The world is not changed. Balls may come and go. Of the shapes, those that are there at the beginning are followed:
    where kinematic ones are, and which ones can collide. A geometry that is set anew is not seen.

    >>> import carom
    >>> from carom.record import Recorder
    >>> world = carom.scenes.toy().build()
    >>> recorder = Recorder(world, name="toy")
    >>> for _ in range(60):
    ...     recorder.note(world.step(1 / 60))
    >>> recorder.finish()
    <recording of 61 frames, 5 balls, 6 hits>
    """

    def __init__(self, world: World, *, name: str = "", about: str = "", every: int = 1) -> None:
        self._world = checks.instance("world", world, World, "a World")
        self._name, self._about = checks.text("name", name), checks.text("about", about)
        self._every = checks.whole("every", every, 1)
        self._steps = 0
        self._scene = Scene.from_world(world)
        self._names = names_in(world)
        self._there = world.balls.id.copy()
        self._time = world.time
        self._shape_ids = np.array([shape.id for shape in parts(world.shapes)], np.int64)
        rows = world._arrays.shapes.used
        self._moving = rows["id"][(rows["motion"] == KINEMATIC) & np.isin(rows["id"], self._shape_ids)].copy()
        self._times: list[float] = []
        self._balls: list[Rows] = []
        self._poses: list[NDArray[np.float64]] = []
        self._colliding: list[NDArray[np.bool_]] = []
        self._hits: list[Rows] = []
        self._take()

    @spelled
    def note(self, hits: Rows) -> None:
        """Note a step that was made, and its `hits`.

        What was noted stays as it is where this raises, and `finish` makes a recording of it.

        Raises:
            InvalidArgument: The hits are none, or those of another world.
            RecordingError: The world has gone back in time since the last note, as by `restore`, or holds balls that
                no recording can hold, as ones whose place is NaN.
        """
        rows = rows_of(self._world, hits)
        if self._has_gone_back():
            raise RecordingError(
                f"the world has gone back from {self._time:g} s to {self._world.time:g} s since the last note, and a"
                " recording goes forward; finish() gives what was noted"
            )
        if (self._steps + 1) % self._every == 0:
            self._take()
        self._keep_names(rows)
        if len(rows):
            self._hits.append(rows)
        self._steps += 1
        self._time = self._world.time

    def finish(self) -> Recording:
        """The recording of all that was noted until now; the last step is a frame of it."""
        if self._steps % self._every != 0 and not self._has_gone_back():
            with suppress(RecordingError):
                self._take()
            self._steps = 0
        hits = joined(self._hits, HIT)
        ids = np.unique(np.concatenate([rows["id"] for rows in self._balls]))
        return Recording(
            scene=self._scene,
            times=np.array(self._times),
            **self._ball_columns(ids),
            shape_ids=self._shape_ids,
            colliding=self._stacked(),
            moving=self._moving,
            poses=np.array(self._poses).reshape(len(self._times), len(self._moving), 3),
            # A ball in flight finds out that it has left a sensor only later, sometimes after a step's end.
            hits=np.take(hits, np.argsort(hits["time"], kind="stable")),
            names=self._names if self._has_gone_back() else self._names | names_in(self._world),
            statistics=self._world.statistics.as_dict(),
            name=self._name,
            about=self._about,
        )

    def _has_gone_back(self) -> bool:
        """Whether the world stands at an earlier time than at the last note."""
        return self._world.time < self._time

    def _keep_names(self, hits: Rows) -> None:
        """Keep the names of what has left since the last note, and of what came meanwhile and was hit."""
        ids = self._world.balls.id
        if not np.array_equal(ids, self._there):
            gone = np.setdiff1d(self._there, ids)
            self._there = ids.copy()
        elif not len(hits):
            return
        else:
            gone = ids[:0]
        for key in np.unique(np.concatenate([gone, hits["ball"], hits["shape"]])).tolist():
            member = self._world._departed.find(key)
            name = None if member is None else member.name if isinstance(member, Ball) else name_of(member)
            if name:
                self._names[key] = name

    def _take(self) -> None:
        """Note the world as it stands as a frame; raises `RecordingError` where no recording could hold it."""
        arrays = self._world._arrays
        balls = arrays.balls.used[BALL_FIELDS].copy()
        finite = all(np.isfinite(balls[field]).all() for field in BALL_FIELDS)
        if not finite or (balls["radius"] <= 0.0).any() or (balls["mass"] <= 0.0).any():
            raise RecordingError("the world's balls must be finite, their radii and masses positive")
        self._balls.append(balls)
        self._times.append(self._world.time)
        shapes = arrays.shapes.used
        there, indices = self._indices(shapes["id"], self._moving)
        poses = self._poses[-1].copy() if self._poses else np.zeros((len(self._moving), 3))
        for column, field in enumerate(("pivot_x", "pivot_y", "orientation")):
            poses[there, column] = shapes[field][indices]
        self._poses.append(poses)
        there, indices = self._indices(shapes["id"], self._shape_ids)
        there[there] = shapes["can_collide"][indices] != 0
        # Frames that agree share one array: most runs switch no shape off, and scenes may have thousands.
        same = bool(self._colliding) and np.array_equal(self._colliding[-1], there)
        self._colliding.append(self._colliding[-1] if same else there)

    @staticmethod
    def _indices(ids: NDArray[np.int64], wanted: NDArray[np.int64]) -> tuple[NDArray[np.bool_], NDArray[np.intp]]:
        """Which of the `wanted` are among ascending `ids`, (wanted,), and where these stand there."""
        there = np.isin(wanted, ids)
        return there, np.searchsorted(ids, wanted[there])

    def _stacked(self) -> NDArray[np.bool_]:
        """Which shapes collide at each frame: (n, s), without copies where that never changes."""
        first = self._colliding[0]
        if all(frame is first for frame in self._colliding):
            return np.broadcast_to(first, (len(self._colliding), len(first)))
        return np.array(self._colliding)

    def _ball_columns(self, ids: NDArray[np.int64]) -> dict[str, Any]:
        """What was noted of the balls `ids`, as the columns of a recording."""
        frames, balls = len(self._balls), len(ids)
        radii, masses = np.zeros(balls), np.zeros(balls)
        positions = np.full((frames, balls, 2), np.nan)
        velocities = np.full((frames, balls, 2), np.nan)
        asleep = np.zeros((frames, balls), np.bool_)
        for frame, rows in enumerate(self._balls):
            indices = np.searchsorted(ids, rows["id"])
            radii[indices], masses[indices] = rows["radius"], rows["mass"]
            positions[frame, indices, 0], positions[frame, indices, 1] = rows["x"], rows["y"]
            velocities[frame, indices, 0], velocities[frame, indices, 1] = rows["vx"], rows["vy"]
            asleep[frame, indices] = rows["asleep"] != 0
        return {
            "ids": ids,
            "radii": radii,
            "masses": masses,
            "positions": positions,
            "velocities": velocities,
            "asleep": asleep,
        }


def recorded(
    world: World,
    seconds: float,
    dt: float,
    every: int,
    name: str,
    about: str,
    progress: Callable[[float, float], Any] | None,
) -> Recording:
    """A recording of a run that `world` makes now; see `Recording.of`."""
    total, length = checks.non_negative("seconds", seconds), checks.positive("dt", dt)
    if total / length > MOST_STEPS:
        raise checks.refuse("seconds", f"must be less than {MOST_STEPS} steps of dt={length!r}", seconds)
    steps = round(total / length)
    checks.callable_or_none("progress", progress)
    recorder = Recorder(world, name=name, about=about, every=every)
    done = 0
    while done < steps:
        count = min(recorder._every, steps - done)
        hits = world.run(count * length, dt=length)
        for step in range(count):
            recorder.note(hits if step == 0 else hits[:0])
        done += count
        if progress is not None:
            progress(done * length, steps * length)
    return recorder.finish()
