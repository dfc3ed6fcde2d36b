"""Whatever is given to the functions that draw, record and study is taken, or refused by an error of carom's.

`CALLS` has a right call for each public function and class; one that is in no table fails, so a new one gets its own.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache, partial
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom import draw, record, rl, study
from carom.study import measures, plots

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pyplot = pytest.importorskip("matplotlib.pyplot", reason='no matplotlib: pip install "carom[study]"')
pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')
pytest.importorskip("gymnasium", reason='no gymnasium: pip install "carom[rl]"')

MODULES = {"draw": draw, "record": record, "plots": plots, "measures": measures, "study": study, "rl": rl}

#: What each argument is given in turn.
BAD = [
    None, 5, -1, 1.5, nan, True, "nonsense", b"x", object(), [], {}, (1,), [1, 2, 3],
    carom.Ball((0, 0), 1), np.zeros(3), np.array("x"),
]  # fmt: skip

#: Names that take nothing of the user's, or whose calls are tried elsewhere (`test_paths`, `test_descriptors`).
ELSEWHERE = {
    "draw": {"DEFAULT_LAYERS", "Cell", "Layer", "Lettering", "Painter", "Partition", "Picture", "Style", "ThemeName"},
    "record": set(),
    "plots": set(),
    "measures": set(),
    "study": {
        "BoundaryMap", "Correlation", "Density", "Escape", "Lyapunov", "MeanFreePath", "RunLyapunov", "Section",
        "Starts", "Table", "measures", "plots", "sweep",
    },
    "rl": {"End", "Impulse", "Observation", "Points", "Reward", "Spread", "Task", "Travel", "Turn", "tasks"},
}  # fmt: skip


@cache
def world() -> carom.World:
    """A world, as it is after a while."""
    made = carom.scenes.newtons_cradle().build()
    made.run(0.2)
    return made


@cache
def run() -> carom.Recording:
    """A recording."""
    return carom.Recording.of(carom.scenes.newtons_cradle().build(), 0.2)


@cache
def found(study_of: str) -> Any:
    """What a study of a table finds."""
    return {
        "boundary_map": lambda: study.boundary_map("stadium", 3, 5),
        "correlation": lambda: study.correlation("stadium", 10, 1.0, 20),
        "mean_free_path": lambda: study.mean_free_path("stadium", 10, 10),
        "section": lambda: study.section("stadium", carom.Segment((-1, -0.5), (1, 0.5)), 5, 10),
        "spectrum": lambda: study.lyapunov("stadium", 5, 20),
        "survival": lambda: study.escape("stadium", (0.0, 1.0), 20, 60.0),
    }[study_of]()


@cache
def environment(vector: bool) -> Any:
    """An environment that has begun."""
    made = rl.TaskVectorEnv(rl.tasks.breakout(), 2) if vector else rl.TaskEnv(rl.tasks.breakout())
    made.reset(seed=3)
    return made


def picture() -> draw.Picture:
    """A picture."""
    return draw.picture_of(world())


def live(**arguments: Any) -> draw.Live:
    """A world drawn as it goes on."""
    return draw.Live(**({"world": world(), "box": carom.Aabb(-2, -2, 12, 8), "size": (160, 120)} | arguments))


def shown(one: draw.Live, layers: Any) -> None:
    """Show other layers."""
    one.layers = layers


def stadium() -> Any:
    """A closed table."""
    return study.table("stadium")


Call = tuple[Callable[..., Any], dict[str, Any]]

#: Which argument of a study comes first, and the others.
TABLE = {"scene": "stadium", "n": 3, "seed": 1}

#: How each public function is called rightly, and methods that are called with a dot in their names.
CALLS: dict[str, Callable[[], Call]] = {
    "draw.picture_of": lambda: (
        draw.picture_of,
        {
            "world": world(), "name": "x", "caption": "y", "trace": draw.Trace(world()), "shares": [("wall", 1)],
            "layers": draw.DEFAULT_LAYERS, "size": 100,
        },
    ),
    "draw.picture_at": lambda: (
        draw.picture_at,
        {"recording": run(), "frame": 0, "shares": [("wall", 1)], "layers": draw.DEFAULT_LAYERS, "size": 100},
    ),
    "draw.svg": lambda: (draw.svg, {"picture": picture(), "theme": "light", "scene": carom.scenes.toy()}),
    "draw.png": lambda: (draw.png, {"picture": picture(), "theme": "dark"}),
    "draw.replay_page": lambda: (
        draw.replay_page,
        {"recording": run(), "theme": "light", "layers": draw.DEFAULT_LAYERS},
    ),
    "draw.partition_of": lambda: (draw.partition_of, {"world": world()}),
    "draw.write_film": lambda: (draw.write_film, {"film": film(), "path": "film.gif", "tell": None}),
    "draw.Film": lambda: (
        draw.Film,
        {"recording": run(), "layers": draw.DEFAULT_LAYERS, "theme": "light", "size": (100, 100)},
    ),
    "draw.Film.frame": lambda: (film().frame, {"frame": 0}),
    "draw.Film.rgb": lambda: (film().rgb, {"frame": 0}),
    "draw.Trace": lambda: (draw.Trace, {"world": world()}),
    "draw.Trace.note": lambda: (draw.Trace(world()).note, {"hits": world().step(0.1)}),
    "draw.Live": lambda: (
        live,
        {
            "world": world(), "box": carom.Aabb(0, 0, 1, 1), "size": (160, 120), "layers": [], "theme": "dark",
            "changing": list(world().shapes), "zoom": 1,
        },
    ),
    "draw.Live.note": lambda: (live().note, {"hits": world().step(0.1)}),
    "draw.Live.layers": lambda: (partial(shown, live()), {"layers": []}),
    "draw.SvgPainter": lambda: (partial(draw.SvgPainter, picture().frame), {"theme": "light"}),
    "draw.RasterPainter": lambda: (partial(draw.RasterPainter, picture().frame), {"theme": "light"}),
    "record.Recorder": lambda: (record.Recorder, {"world": world(), "name": "", "about": "", "every": 1}),
    "record.Recorder.note": lambda: (record.Recorder(world()).note, {"hits": world().step(0.1)}),
    "record.Recording": lambda: (
        record.Recording.of,
        {"world": world(), "seconds": 0.1, "dt": 0.1, "every": 1, "name": "", "about": "", "progress": None},
    ),
    "record.Recording.frame_at": lambda: (run().frame_at, {"time": 0.1}),
    "record.Recording.label_of": lambda: (run().label_of, {"member_id": 1}),
    "record.Recording.shapes_at": lambda: (run().shapes_at, {"frame": 0}),
    "record.Recording.pose": lambda: (run().pose, {"shapes": run().shapes_at(0), "frame": 0}),
    "plots.energy": lambda: (plots.energy, {"recording": run(), "axes": None}),
    "plots.hits_by_shape": lambda: (
        plots.hits_by_shape,
        {"recording": run(), "axes": None, "rows": 3, "count": "hits"},
    ),
    "plots.heat_map": lambda: (plots.heat_map, {"recording": run(), "axes": None, "cells": 9}),
    "plots.speeds": lambda: (plots.speeds, {"recording": run(), "axes": None, "since": 0.0, "bins": 9}),
    **{
        f"plots.{name}": partial(
            lambda name: (getattr(plots, name), {"found": found(name), "axes": None}), name
        )
        for name in ("boundary_map", "correlation", "mean_free_path", "section", "spectrum", "survival")
    },
    **{
        f"measures.{name}": partial(
            lambda name: (
                partial(getattr(measures, name), parameters={}), {"world": world(), "hits": world().step(0.1)}
            ),
            name,
        )
        for name in measures.__all__
    },
    "study.table": lambda: (study.table, {"scene": "stadium"}),
    "study.boundary_map": lambda: (study.boundary_map, {**TABLE, "hits": 5, "boundary": True, "speed": 1.0}),
    "study.correlation": lambda: (study.correlation, {**TABLE, "seconds": 1.0, "steps": 20, "speed": 1.0}),
    "study.escape": lambda: (
        study.escape,
        {**TABLE, "hole": (0.0, 1.0), "n": 20, "seconds": 60.0, "since": None, "speed": 1.0},
    ),
    "study.lyapunov": lambda: (study.lyapunov, {**TABLE, "hits": 20, "speed": 1.0}),
    "study.lyapunov_of": lambda: (
        study.lyapunov_of,
        {"world": carom.scenes.stadium().build(), "seconds": 1.0},
    ),
    "study.mean_free_path": lambda: (study.mean_free_path, {**TABLE, "hits": 10}),
    "study.section": lambda: (
        study.section,
        {**TABLE, "cut": carom.Segment((-1, -0.5), (1, 0.5)), "hits": 10, "speed": 1.0},
    ),
    "study.Table.contains": lambda: (stadium().contains, {"points": [(0, 0)]}),
    "study.Table.random_starts": lambda: (stadium().random_starts, {"n": 3, "seed": 1}),
    "study.Table.ensemble": lambda: (stadium().ensemble, {"n": 3, "seed": 1, "boundary": False, "speed": 1.0}),
    "study.BoundaryMap.density": lambda: (found("boundary_map").density, {"bins": 4}),
    "study.Section.density": lambda: (found("section").density, {"bins": 4}),
    "rl.TaskEnv": lambda: (rl.TaskEnv, {"task": "breakout", "render_mode": None}),
    "rl.TaskEnv.reset": lambda: (environment(vector=False).reset, {"seed": 1, "options": None}),
    "rl.TaskEnv.step": lambda: (partial(stepped, environment(vector=False)), {"action": 1}),
    "rl.TaskVectorEnv": lambda: (
        rl.TaskVectorEnv,
        {"task": "breakout", "num_envs": 2, "threads": None, "autoreset_mode": "NextStep", "render_mode": None},
    ),
    "rl.TaskVectorEnv.reset": lambda: (environment(vector=True).reset, {"seed": 1, "options": None}),
    "rl.TaskVectorEnv.step": lambda: (partial(stepped, environment(vector=True)), {"action": np.array([1, 1])}),
}  # fmt: skip


@cache
def film() -> draw.Film:
    """A film."""
    return draw.Film(run(), size=96)


def stepped(env: Any, action: Any) -> Any:
    """A step of an environment that has just begun."""
    env.reset(seed=1)
    return env.step(action)


@pytest.mark.parametrize("name", CALLS)
def test_what_is_wrong_is_refused_by_an_error_of_the_family(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    function, good = CALLS[name]()
    function(**good)
    refused = 0
    for argument in good:
        for bad in BAD:
            try:
                function(**{**good, argument: bad})
            except carom.CaromError as error:
                refused += len(str(error)) > 0
            except Exception as error:  # noqa: BLE001  # it is what the test looks for
                pytest.fail(f"{name}({argument}={bad!r}) raises {type(error).__name__}: {error}")
        pyplot.close("all")
    assert refused > 0


def test_the_theme_is_named_in_the_error() -> None:
    with pytest.raises(carom.InvalidArgument, match=r"theme must be one of 'auto', .*, not 'neon'"):
        draw.svg(picture(), "neon")  # type: ignore[arg-type]


@pytest.mark.parametrize("module", MODULES)
def test_every_public_name_is_called(module: str) -> None:
    called = {name.split(".")[1] for name in CALLS if name.startswith(f"{module}.")}
    assert set(MODULES[module].__all__) <= called | ELSEWHERE[module]
    for name, call in CALLS.items():
        if name.count(".") == 1 and name.startswith(f"{module}."):
            public = getattr(MODULES[module], name.split(".")[1])
            function, good = call()
            if inspect.isfunction(public):
                assert set(inspect.signature(function).parameters) >= set(good)
