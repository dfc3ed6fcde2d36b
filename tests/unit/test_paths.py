"""Whatever takes a path takes a string and what stands for one, and refuses what is none; found by a walk."""

from __future__ import annotations

import inspect
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import carom
from carom import draw, record, rl, scene, study, world, worlds
from carom.study import measures, plots

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')
pytest.importorskip("gymnasium", reason='no gymnasium: pip install "carom[rl]"')
pytest.importorskip("dask", reason='no dask: pip install "carom[sweep]"')

MODULES = (carom, world, worlds, scene, record, draw, study, plots, measures, rl)


class Somewhere:
    """A path of a kind that the standard library does not know."""

    def __init__(self, path: Any) -> None:
        self._path = path

    def __fspath__(self) -> Any:
        return self._path


def films() -> draw.Film:
    """A short film."""
    return draw.Film(carom.Recording.of(carom.scenes.newtons_cradle().build(), 0.1), size=96)


def swept(**places: Any) -> Any:
    """A sweep of one run."""
    given = {"scene": carom.scenes.newtons_cradle(), "out": "out", **places}
    parameters = {"world.gravity": [(0.0, -1.0)]}
    return study.sweep(parameters=parameters, measure="energy", seconds=0.1, cluster="serial", progress=False, **given)


#: For each function and argument that is a path: the file it is tried with, and how it is called.
CALLS: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "Scene.load.path": ("scene.toml", carom.Scene.load),
    "Scene.load.path of a drawing": ("drawing.svg", carom.Scene.load),
    "Scene.save.path": ("new.json", carom.scenes.toy().save),
    "Recording.load.path": ("run.carom", carom.Recording.load),
    "Recording.save.path": ("new.carom", lambda path: films().recording.save(path)),
    "write_film.path": ("new.gif", lambda path: draw.write_film(films(), path)),
    "Task.load.path": ("task.toml", rl.Task.load),
    "Task.save.path": ("new.toml", lambda path: rl.tasks.breakout().save(path)),
    "Task.scene": ("scene.toml", lambda path: rl.Task(scene=path, actuators=[rl.Impulse(ball="cue ball", speed=2.0)])),
    "TaskEnv.task": ("task.toml", rl.TaskEnv),
    "TaskVectorEnv.task": ("task.toml", rl.TaskVectorEnv),
    "sweep.scene": ("scene.toml", lambda path: swept(scene=path)),
    "sweep.out": ("swept", lambda path: swept(out=path)),
}

NO_PATHS = [
    None,
    5,
    b"new.toml",
    "",
    "a\0b.toml",
    "a\0b.svg",
    Somewhere(b"new.toml"),
    Somewhere(""),
    Somewhere(5),
    ["new.toml"],
]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a file of each kind, where the process stands."""
    table = carom.scenes.pool()
    table.save(tmp_path / "scene.toml")
    rl.tasks.breakout().save(tmp_path / "task.toml")
    films().recording.save(tmp_path / "run.carom")
    (tmp_path / "drawing.svg").write_text(draw.svg(draw.picture_of(table.build()), scene=table), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("kind", [str, Path, Somewhere])
@pytest.mark.parametrize("call", CALLS)
def test_paths_of_all_kinds_are_taken(call: str, kind: Callable[[str], Any], folder: Path) -> None:
    name, do = CALLS[call]
    for path in (name, str(folder / name)):
        do(kind(path))
        assert (folder / name).exists()
        if name.startswith("new"):
            assert (folder / name).stat().st_size > 0
            (folder / name).unlink()
        shutil.rmtree(folder / "swept", ignore_errors=True)
        shutil.rmtree(folder / "out", ignore_errors=True)


@pytest.mark.parametrize("bad", NO_PATHS)
@pytest.mark.parametrize("call", CALLS)
def test_what_is_no_path_is_refused_by_name(call: str, bad: Any, folder: Path) -> None:
    before = sorted(folder.rglob("*"))
    with pytest.raises(carom.CaromError):
        CALLS[call][1](bad)
    assert sorted(folder.rglob("*")) == before


def test_a_film_is_not_taken_for_an_option_or_an_address(folder: Path) -> None:
    for name in ("-y.gif", "a: b.gif", "pipe:1.gif"):
        draw.write_film(films(), name)
        assert (folder / name).stat().st_size > 0


def test_every_function_that_takes_a_path_is_tried() -> None:
    found = set()
    for module in MODULES:
        for name in module.__all__:
            for owner, function in functions_of(name, getattr(module, name)):
                for argument in inspect.signature(function).parameters.values():
                    if "PathLike" in str(argument.annotation) or argument.name in ("path", "file", "folder", "out"):
                        found.add(f"{owner}.{argument.name}")
    # A task's scene is a field, and its type says what comes out of what is given.
    assert {call.partition(" ")[0] for call in CALLS} - found == {"Task.scene"}
    assert found <= set(CALLS)


def functions_of(name: str, value: Any) -> list[tuple[str, Callable[..., Any]]]:
    """A public function, or the class's own and its public methods, each with its name."""
    if inspect.isclass(value):
        methods = inspect.getmembers(value, inspect.isroutine)
        own = [(f"{name}.{key}", method) for key, method in methods if not key.startswith("_")]
        own = [(key, method) for key, method in own if str(getattr(method, "__module__", "")).startswith("carom")]
        return [(name, value), *own] if value.__module__.startswith("carom") and "__init__" in vars(value) else own
    return [(name, value)] if inspect.isfunction(value) else []
