"""What a recording must be: every part of it checked once, whoever made it."""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.errors import RecordingError
from carom.record.members import shapes_of
from carom.rows.hit import HIT
from carom.scene.scene import Scene
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.record.recording import Recording

#: The arrays, each with its dtype and its axes: frames n, balls m, shapes s, shapes that move k, a number of hits h.
ARRAYS: dict[str, tuple[str, tuple[str | int, ...]]] = {
    "times": ("f8", ("n",)),
    "ids": ("i8", ("m",)),
    "radii": ("f8", ("m",)),
    "masses": ("f8", ("m",)),
    "positions": ("f8", ("n", "m", 2)),
    "velocities": ("f8", ("n", "m", 2)),
    "asleep": ("?", ("n", "m")),
    "shape_ids": ("i8", ("s",)),
    "colliding": ("?", ("n", "s")),
    "moving": ("i8", ("k",)),
    "poses": ("f8", ("n", "k", 3)),
}
#: The arrays whose lengths say how many of each there are.
COUNTED = {"n": "times", "m": "ids", "s": "shape_ids", "k": "moving"}


def check_recording(recording: Recording) -> dict[str, Any]:
    """The fields of a recording as it holds them: arrays read-only, tables frozen; raises `RecordingError`."""
    if not isinstance(recording.scene, Scene):
        raise refused("scene", "must be a Scene")
    checked: dict[str, Any] = {field: _array(recording, field) for field in ARRAYS}
    counts = {axis: len(checked[field]) for axis, field in COUNTED.items()}
    for field, (_, axes) in ARRAYS.items():
        shape = tuple(axis if isinstance(axis, int) else counts[axis] for axis in axes)
        _demand(checked[field].shape == shape, field, f"must have shape {shape}, not {checked[field].shape}")
    _check_frames(checked)
    _check_members(checked, recording.scene)
    checked["hits"] = _hits(recording.hits)
    checked["names"] = _table("names", recording.names, int, str)
    checked["statistics"] = _table("statistics", recording.statistics, str, int)
    for field in ("name", "about"):
        _demand(isinstance(getattr(recording, field), str), field, "must be a string")
    return checked


def refused(field: str, must: str) -> RecordingError:
    """The error that says what a field must do."""
    return RecordingError(f"{field} {must}")


def _demand(fulfilled: bool | np.bool_, field: str, must: str) -> None:
    """Raise unless a demand on a field is fulfilled."""
    if not fulfilled:
        raise refused(field, must)


def _array(recording: Recording, field: str) -> NDArray[Any]:
    """A read-only view of an array field, of its dtype."""
    dtype, axes = ARRAYS[field]
    given = np.asarray(getattr(recording, field))
    _demand(given.ndim == len(axes), field, f"must have {len(axes)} axes, not {given.ndim}")
    _demand(np.can_cast(given.dtype, dtype, "same_kind") or given.size == 0, field, f"must be of type {dtype}")
    view = given.astype(dtype, copy=False).view()
    view.flags.writeable = False
    return view


def _check_frames(fields: dict[str, Any]) -> None:
    """Raise unless times and what is at them can be."""
    times = fields["times"]
    _demand(len(times) > 0, "times", "must have at least one frame")
    _demand(np.isfinite(times).all(), "times", "must be finite")
    _demand((np.diff(times) >= 0.0).all(), "times", "must not descend")
    _demand(np.isfinite(fields["poses"]).all(), "poses", "must be finite")
    there = ~np.isnan(fields["positions"]).any(axis=2)
    for field in ("positions", "velocities"):
        values = fields[field]
        fits = np.where(there[:, :, None], np.isfinite(values), np.isnan(values)).all()
        _demand(fits, field, "must be finite for balls that are there, NaN for those that are not")


def _check_members(fields: dict[str, Any], scene: Scene) -> None:
    """Raise unless balls and shapes are those of a world."""
    for field in ("radii", "masses"):
        _demand((np.isfinite(fields[field]) & (fields[field] > 0.0)).all(), field, "must be positive and finite")
    _demand((np.diff(fields["ids"]) > 0).all() and (fields["ids"] >= 0).all(), "ids", "must ascend from 0 or more")
    shapes = fields["shape_ids"]
    _demand(len(np.unique(shapes)) == len(shapes) and (shapes >= 0).all(), "shape_ids", "must differ, 0 or more")
    count = len(shapes_of(scene))
    _demand(len(shapes) == count, "shape_ids", f"must name the {count} shapes of the scene, not {len(shapes)}")
    _demand(np.isin(fields["moving"], shapes).all(), "moving", "must be among shape_ids")
    _demand(len(np.unique(fields["moving"])) == len(fields["moving"]), "moving", "must differ")


def _hits(given: Any) -> NDArray[Any]:
    """The hits, read-only, checked."""
    hits = np.asarray(given)
    _demand(hits.dtype == HIT and hits.ndim == 1, "hits", "must be rows as those of Hits")
    for field in ("time", "point", "normal", "setback", "speed", "impulse", "velocity", "position"):
        _demand(np.isfinite(hits[field]).all(), f"hits[{field!r}]", "must be finite")
    _demand((np.diff(hits["time"]) >= 0.0).all(), "hits['time']", "must not descend")
    _demand(np.isin(hits["kind"], [kind.value for kind in HitKind]).all(), "hits['kind']", "must be a HitKind")
    view = hits.view()
    view.flags.writeable = False
    return view


def _table(field: str, given: Any, key_type: type, value_type: type) -> MappingProxyType[Any, Any]:
    """A frozen copy of a mapping, checked."""
    try:
        table = dict(given)
    except (TypeError, ValueError):
        raise refused(field, "must be a mapping") from None
    fits = all(type(key) is key_type and type(value) is value_type for key, value in table.items())
    _demand(fits, field, f"must map {key_type.__name__} to {value_type.__name__}")
    return MappingProxyType(table)
