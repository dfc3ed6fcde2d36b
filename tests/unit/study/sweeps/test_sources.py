"""What is run, and what a seed does."""

from pathlib import Path
from typing import Any

import pytest

import carom
from carom.study.sweeps.grid import Run, runs_of
from carom.study.sweeps.sources import SPREAD, source_of, spread
from tests import sweeping

CRADLE = carom.scenes.newtons_cradle(balls=3)


def scene_of(given: Any, seed: int | None = None, **parameters: Any) -> carom.Scene:
    """The scene of a run."""
    return source_of(given).of(Run(parameters, seed))


def test_scenes_files_names_and_functions_are_sources(tmp_path: Path) -> None:
    path = tmp_path / "cradle.toml"
    CRADLE.save(path)
    for given in (CRADLE, path, str(path)):
        assert scene_of(given) == CRADLE
        assert source_of(given).identity == CRADLE.plain()
    for given in ("newtons_cradle", carom.scenes.newtons_cradle):
        assert scene_of(given, balls=3) == CRADLE
    for given in (sweeping.drop, "tests.sweeping:drop"):
        assert scene_of(given, number=7) == sweeping.drop({"number": 7})
    assert source_of("gas").identity != source_of("sinai").identity


def test_paths_are_set_in_what_a_function_made() -> None:
    assert scene_of("newtons_cradle", **{"balls": 3, "balls[0].mass": 2.0}).balls[0].mass == 2.0
    assert scene_of(sweeping.drop, **{"number": 7, "world.friction": 0.5}).world.friction == 0.5


def test_a_seed_goes_to_a_function_that_takes_it() -> None:
    assert scene_of("gas", 5, balls=10) == carom.scenes.gas(balls=10, seed=5)
    assert scene_of(sweeping.drop, 5) == sweeping.drop({"seed": 5})


@pytest.mark.parametrize("given", [CRADLE, "newtons_cradle"])
def test_a_seed_spreads_the_start_of_any_other_scene(given: Any) -> None:
    quiet, one, same, other = (scene_of(given, seed) for seed in (None, 1, 1, 2))
    assert one == same
    for scene in (one, other):
        for moved, ball in zip(scene.balls, quiet.balls, strict=True):
            off = [a - b for a, b in zip(moved.position, ball.position, strict=True)]
            assert 0.0 < max(map(abs, off)) <= SPREAD * ball.radius * (1 + 1e-9)
    assert len({ball.position for scene in (quiet, one, other) for ball in scene.balls}) == 3 * len(quiet.balls)
    assert scene_of(given, 1).model_copy(update={"balls": quiet.balls}) == quiet


def test_the_spread_is_even() -> None:
    ball = carom.Ball((0, 0), 2.0)
    xs = [spread(carom.Scene(balls=[ball]), seed).balls[0].position[0] / (2.0 * SPREAD) for seed in range(400)]
    # 400 numbers that are even on [-1, 1]: their mean is off by 1/sqrt(3·400) = .029, so four times that is rare.
    assert abs(sum(xs) / len(xs)) < 0.12
    assert min(xs) < -0.95
    assert max(xs) > 0.95


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("pinbal", "scene 'pinbal': no such file, and no shipped scene of that name; did you mean pinball"),
        (3, "scene must be a function that can be imported"),
        (lambda parameters: CRADLE, "scene must be a function at the top of a module"),
        ("no.such:f", "scene no.such:f cannot be imported"),
    ],
)
def test_what_is_no_scene_is_refused(given: Any, words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words):
        source_of(given)


def test_a_file_that_is_no_scene_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text("version = 1\nshapes = 3\n")
    with pytest.raises(carom.SceneError, match=r"shapes: must be a list"):
        source_of(tmp_path / "a.toml")


@pytest.mark.parametrize(
    ("given", "parameters", "words"),
    [
        (CRADLE, {"balls": [1]}, "must be named by paths that begin with world or shapes or balls, not 'balls'"),
        ("newtons_cradle", {"ball": [1]}, "parameters: ball: is unknown; did you mean balls"),
        (CRADLE, {"world.gravty": [1]}, "world.gravty: world has no field gravty"),
        (CRADLE, {"world.friction": [0.0, 1.0, -1.0]}, "world.friction: must not be negative, not -1"),
        (CRADLE, {"world.gravity": [(0, 1)], "world.gravity[1]": [2.0]}, "two of them set world.gravity"),
    ],
)
def test_parameters_are_checked_before_anything_is_run(given: Any, parameters: dict[str, Any], words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words):
        source_of(given).check(runs_of(parameters))


def test_what_a_function_returns_must_be_a_scene() -> None:
    with pytest.raises(TypeError, match="builtins:dict must return a Scene, not a dict"):
        scene_of(dict)
