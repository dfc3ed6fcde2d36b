"""Whatever carom gives can be pickled and copied: an object of each public class, with something in it.

`MADE` has one for each public class; one that is in neither table fails, so a new one gets its own here.
"""

from __future__ import annotations

import copy
import enum
import inspect
import pickle
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

import numpy as np
import pydantic
import pytest

import carom
from carom import draw, errors, record, rl, scene, study, world, worlds
from carom.world.views import Balls, Shapes

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pytest.importorskip("gymnasium", reason='no gymnasium: pip install "carom[rl]"')

MODULES = (carom, world, worlds, scene, record, draw, study, rl)
#: Public classes of which there is nothing to copy: a screen and what draws on one, and abstract ones.
NOT_COPIED = {draw.Live, draw.Painter, draw.RasterPainter, draw.SvgPainter, carom.Shape}


@cache
def table() -> carom.World:
    """A world in which something has happened."""
    made = carom.scenes.toy().build()
    made.run(3.0)
    return made


@cache
def hits() -> carom.Hits:
    """The hits of such a world."""
    return carom.scenes.toy().build().run(3.0)


@cache
def room() -> carom.World:
    """A world in which balls are seen to meet something."""
    return carom.scenes.stadium().build()


@cache
def recording() -> carom.Recording:
    """A recording with names and hits."""
    made = carom.scenes.toy().build()
    made.balls[0].name = "red"
    return carom.Recording.of(made, 1.0, name="a run", about="for an hour")


@cache
def many() -> carom.Worlds:
    """Copies of a world that differ."""
    made = carom.Worlds("toy", 3)
    made.balls.position[1, 0] += 0.01
    made.run(1.0)
    return made


@cache
def copy_hits() -> worlds.CopyHits:
    """The hits of copies."""
    return carom.Worlds("toy", 3).run(1.0)


def environment(vector: bool) -> Any:
    """An environment that has begun."""
    made = rl.TaskVectorEnv(rl.tasks.breakout(), 2) if vector else rl.TaskEnv(rl.tasks.breakout())
    made.reset(seed=3)
    return made


def recorder() -> carom.Recorder:
    """A recorder that has noted something."""
    made = carom.Recorder(carom.scenes.toy().build(), name="a run")
    for _ in range(20):
        made.note(made._world.step(1 / 60))
    return made


def trace() -> draw.Trace:
    """A trace of what happened."""
    followed = carom.scenes.toy().build()
    made = draw.Trace(followed)
    for _ in range(20):
        made.note(followed.step(1 / 60))
    return made


#: An object of each class.
MADE: dict[type, Callable[[], Any]] = {
    # shapes and what they answer
    carom.Aabb: lambda: carom.Aabb(0, 1, 2, 3),
    carom.Arc: lambda: carom.Arc((0, 1), 2, 0, 1, name="arc"),
    carom.Ball: lambda: carom.Ball((0, 1), 2, velocity=(3, 4), name="ball"),
    carom.Circle: lambda: carom.Circle((0, 1), 2, layer=3),
    carom.Compound: lambda: carom.Compound([carom.Point((0, 1)), carom.Point((2, 3))], (0, 0), name="compound"),
    carom.Contact: lambda: carom.Point((0, 0)).detect(carom.Ball((0, 0.5), 1.0)),
    carom.Gate: lambda: carom.Gate((0, 0), (1, 0), direction=(0, 1)),
    carom.Group: lambda: carom.Group([carom.Point((0, 1)), carom.Point((2, 3))], name="group"),
    carom.Line: lambda: carom.Line((0, 1), 2.0),
    carom.Point: lambda: carom.Point((0, 1), kick=1.0),
    carom.Segment: lambda: carom.Segment((0, 0), (1, 0), elasticity=0.5),
    carom.Motion: lambda: carom.Motion.KINEMATIC,
    # worlds and what they answer
    world.World: table,
    world.Statistics: lambda: table().statistics,
    world.Hits: hits,
    world.Hit: lambda: hits()[0],
    world.HitKind: lambda: world.HitKind.ENTER,
    world.Counts: lambda: hits().counts(),
    world.Count: lambda: hits().counts()[0],
    world.Touches: lambda: hits().touches(),
    world.Touch: lambda: hits().touches()[0],
    world.Boundary: lambda: hits().boundary([hits()[0].shape]),
    world.Aim: lambda: room().aim(room().balls[0]),
    world.Aims: lambda: room().aim(room().balls.id, (1, 0)),
    world.CastHit: lambda: room().ray_cast((0, 0), (100, 3)),
    world.CastHits: lambda: room().ray_cast([(0, 0), (0, 1)], (100, 3)),
    world.Neighbor: lambda: room().nearest((0, 0)),
    world.Neighbors: lambda: room().nearest([(0, 0), (0, 1)]),
    world.Contacts: lambda: crossed().contacts(),
    Balls: lambda: table().balls,
    Shapes: lambda: table().shapes,
    worlds.Worlds: many,
    worlds.CopyHits: copy_hits,
    worlds.CopyHit: lambda: copy_hits()[0],
    # scenes, recordings, pictures
    scene.Scene: lambda: carom.scenes.toy(),
    record.Recorder: recorder,
    record.Recording: recording,
    draw.Picture: lambda: draw.picture_at(recording(), layers=frozenset(draw.Layer)),
    draw.Film: lambda: draw.Film(recording(), theme=draw.ThemeName.DARK, size=(320, 240)),
    draw.Trace: trace,
    draw.Partition: lambda: draw.partition_of(table()),
    draw.Cell: lambda: draw.partition_of(table()).cells[0],
    draw.Layer: lambda: draw.Layer.NAMES,
    draw.Lettering: lambda: draw.Lettering("muted", 9.0, bold=True),
    draw.Style: lambda: draw.Style("wall", width=2.0),
    draw.ThemeName: lambda: draw.ThemeName.PRINT,
    # studies
    study.Table: lambda: study.table("stadium"),
    study.Starts: lambda: study.table("stadium").random_starts(4, 1),
    study.BoundaryMap: lambda: study.boundary_map("stadium", 3, 5),
    study.Density: lambda: study.boundary_map("stadium", 3, 5).density(4),
    study.Correlation: lambda: study.correlation("stadium", 10, 1.0, 20),
    study.Escape: lambda: study.escape("stadium", (0.0, 1.0), 20, 60.0),
    study.Lyapunov: lambda: study.lyapunov("stadium", 5, 20),
    study.MeanFreePath: lambda: study.mean_free_path("stadium", 10, 10),
    study.RunLyapunov: lambda: study.lyapunov_of(carom.scenes.stadium().build(), 2.0),
    study.Section: lambda: study.section("stadium", carom.Segment((-1, -0.5), (1, 0.5)), 5, 10),
    # environments
    rl.Task: lambda: rl.tasks.breakout(),
    rl.End: lambda: rl.tasks.breakout().end,
    rl.Impulse: lambda: rl.Impulse(ball="white", speed=2.0),
    rl.Observation: lambda: rl.tasks.breakout().observation,
    rl.Points: lambda: rl.tasks.breakout().reward.points[0],
    rl.Reward: lambda: rl.tasks.breakout().reward,
    rl.Spread: lambda: rl.tasks.breakout().start[0],
    rl.Travel: lambda: rl.Travel(shape="paddle", speeds=(1.0, -1.0)),
    rl.Turn: lambda: rl.Turn(shape="bat", speeds=(1.0, -1.0)),
    rl.TaskEnv: lambda: environment(vector=False),
    rl.TaskVectorEnv: lambda: environment(vector=True),
}


def crossed() -> carom.World:
    """A world in which a ball overlaps a shape."""
    made = carom.World()
    made.add(carom.Segment((0, 0), (4, 0)), carom.Ball((2, 0.5), 1.0))
    return made


#: What can be seen of objects of some classes.
SEEN: dict[type, Callable[[Any], Any]] = {
    carom.World: lambda one: one.digest(),
    carom.Worlds: lambda one: (one.digests(), one.counts.tobytes()),
    carom.Recorder: lambda one: one.finish(),
    draw.Picture: draw.svg,
    draw.Film: lambda one: [one.rgb(frame) for frame in (0, -1)],
    draw.Trace: lambda one: (one.hits, one.tracks()),
    rl.TaskEnv: lambda one: (one.step(one.action_space.start + 1), one.step(one.action_space.start)),
    rl.TaskVectorEnv: lambda one: (one.step(np.ones(2, np.int64)), one.step(np.zeros(2, np.int64))),
    pydantic.BaseModel: lambda one: one.model_dump(),
    Balls: list,
    Shapes: list,
}


def seen(one: Any) -> Any:
    """What can be seen of an object: words, numbers, bytes and tuples of such."""
    for kind, look in SEEN.items():
        if isinstance(one, kind):
            return type(one).__name__, seen(look(one))
    if isinstance(one, np.ndarray):
        return type(one).__name__, one.dtype.str, one.shape, one.tobytes()
    if is_dataclass(one) and not isinstance(one, carom.Shape):
        return type(one).__name__, tuple(seen(getattr(one, field.name)) for field in fields(one))
    if isinstance(one, Mapping):
        return tuple((seen(key), seen(value)) for key, value in one.items())
    if isinstance(one, tuple | list):
        return tuple(map(seen, one))
    return type(one).__name__, repr(one)


def pickled(one: Any) -> Any:
    """What comes back from a pickle."""
    return pickle.loads(pickle.dumps(one))


#: How copies are made; one that is not deep steps the same world.
DUPLICATES = [pickled, copy.deepcopy, copy.copy]
SHALLOW = {rl.TaskEnv, rl.TaskVectorEnv}


@pytest.mark.parametrize("duplicate", DUPLICATES)
@pytest.mark.parametrize("made", MADE, ids=lambda made: made.__name__)
def test_a_copy_is_the_same(made: type, duplicate: Callable[[Any], Any]) -> None:
    if duplicate is copy.copy and made in SHALLOW:
        return
    one = MADE[made]()
    assert type(one) is made
    if hasattr(one, "__len__"):
        assert len(one) > 0
    twin = duplicate(one)
    assert type(twin) is made
    assert twin is not one or isinstance(one, enum.Enum) or duplicate is not pickled
    assert seen(twin) == seen(one)


def test_another_is_seen_to_be_another() -> None:
    assert seen(recording()) != seen(carom.Recording.of(carom.scenes.toy().build(), 1.0))
    assert seen(table()) != seen(carom.scenes.toy().build())
    assert seen(hits()) != seen(hits()[1:])
    assert seen(hits()[0]) != seen(hits()[1])
    assert seen(draw.picture_at(recording())) != seen(draw.picture_at(recording(), 0))


@pytest.mark.parametrize(
    "kind", [one for _, one in inspect.getmembers(errors, inspect.isclass) if issubclass(one, Exception)]
)
def test_errors_come_back_from_other_processes(kind: type[Exception]) -> None:
    error = kind("what is wrong")
    error.add_note("and more")
    if isinstance(error, carom.ImpactLimit):
        error.balls, error.time = [3], 2.0
    if isinstance(error, carom.CaromError):
        error.hits = hits()
    for twin in (pickled(error), copy.deepcopy(error)):
        assert (type(twin), str(twin), twin.__notes__) == (kind, "what is wrong", ["and more"])
        assert seen(vars(twin)) == seen(vars(error))


def test_every_public_class_is_copied() -> None:
    public = {
        value
        for module in MODULES
        for name in module.__all__
        if inspect.isclass(value := getattr(module, name)) and not issubclass(value, Exception)
    }
    assert public - set(MADE) == NOT_COPIED
