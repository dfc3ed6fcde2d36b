"""Measures of a run for sweeps: functions of a world at its end, its hits and the parameters, that return numbers.

A measure of your own is such a function at the top of a module: `measure(world, hits, parameters)`, which returns a
dictionary of numbers, strings and small arrays by name.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.checks import instance
from carom.record.members import BALLS, parts
from carom.shapes.label import label_of
from carom.spelling import hint
from carom.world.hits import HitKind, rows_of
from carom.world.world import World

if TYPE_CHECKING:
    from carom.world import Hits

__all__ = ["energy", "hits_by_kind", "hits_by_shape", "impact_speeds", "last_state", "statistics"]


def hits_by_shape(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, int]:  # noqa: ARG001
    """How often each shape bounced a ball or was entered, by name; shapes of one name, and balls, count together."""
    _check(world, hits)
    labels = {shape.id or 0: label_of(shape) for shape in parts(world.shapes)}
    counts: Counter[str] = Counter(dict.fromkeys(labels.values(), 0))
    told = np.asarray(hits["shape"])[np.asarray(hits["kind"]) != HitKind.EXIT]
    for shape, count in zip(*np.unique(told, return_counts=True), strict=True):
        counts[labels.get(int(shape), BALLS)] += int(count)
    return dict(counts)


def hits_by_kind(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, int]:  # noqa: ARG001
    """How many bounces there were, how many sensors were entered, and how many left."""
    _check(world, hits)
    kinds = np.asarray(hits["kind"])
    return {f"{kind.name.lower()}s": int(np.count_nonzero(kinds == kind)) for kind in HitKind}


def impact_speeds(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, float]:  # noqa: ARG001
    """The number of bounces, and their mean and greatest speed and impulse; 0 where there were none."""
    _check(world, hits)
    bounces = np.asarray(hits)[np.asarray(hits["kind"]) == HitKind.BOUNCE]
    found: dict[str, float] = {"bounces": len(bounces)}
    for name in ("speed", "impulse"):
        found[f"mean {name}"] = float(bounces[name].mean()) if len(bounces) else 0.0
        found[f"greatest {name}"] = float(bounces[name].max()) if len(bounces) else 0.0
    return found


def energy(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, float]:  # noqa: ARG001
    """The balls' kinetic energy at the end, and the sum with that of their height in the world's gravity."""
    _check(world, hits)
    velocity, position, mass = world.balls.velocity, world.balls.position, world.balls.mass
    kinetic = float(0.5 * np.sum(mass * np.sum(velocity * velocity, axis=1)))
    x, y = world.gravity
    return {
        "kinetic energy": kinetic,
        "energy": kinetic - float(np.sum(mass * (x * position[:, 0] + y * position[:, 1]))),
    }


def last_state(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, Any]:  # noqa: ARG001
    """The time at the end, how many balls are left, and the places and velocities of these, as lists."""
    _check(world, hits)
    x, y = world.balls.position.T.copy()
    vx, vy = world.balls.velocity.T.copy()
    return {"time": world.time, "balls": len(world.balls), "x": x, "y": y, "vx": vx, "vy": vy}


def statistics(world: World, hits: Hits, parameters: Mapping[str, Any]) -> dict[str, int]:  # noqa: ARG001
    """The world's counters, as `World.statistics` has them."""
    _check(world, hits)
    return dict(world.statistics.as_dict())


def _check(world: Any, hits: Any) -> None:
    """Raise `InvalidArgument` for what are no world and no hits of it."""
    rows_of(instance("world", world, World, "a World"), hits)


def by_name(name: str) -> str:
    """The reference of the measure called `name`, `hits-by-shape`; a text that names none of them stays as it is."""
    plain = name.replace("-", "_")
    if plain in __all__:
        return f"{__name__}:{plain}"
    if ":" not in name:
        from carom.errors import InvalidArgument

        known = [measure.replace("_", "-") for measure in __all__]
        said = hint(name, known) or f"there are {', '.join(known)}"
        raise InvalidArgument(f"measure {name!r} is none of study.measures and no 'module:function'; {said}")
    return name
