"""The shipped scenes: their names, their arguments, and tables whose joints are tangent or guarded."""

import inspect
from math import inf, nan
from typing import Any

import pytest

import carom
from carom import scenes
from tests.worlds import SMALL, small_scene

NAMES = (
    *(
        "annulus",
        "breakout",
        "circle",
        "ellipse",
        "flower",
        "galton",
        "gas",
        "lemon",
        "lorentz",
        "mushroom",
        "newtons_cradle",
    ),
    *("pinball", "pool", "rectangle", "sinai", "stadium", "toy", "wedge"),
)
COUNTS = {"balls", "petals", "rows", "seed"}
NOT_COUNTS = (0, -1, 1.0, "5", None, True, 10**7)
NOT_LENGTHS = (0.0, -1.0, nan, inf, "5", None, True)
#: Lengths that may be 0.
MAY_BE_NOTHING = {("stadium", "length"), ("annulus", "offset")}
ARGUMENTS = [(name, argument) for name in NAMES for argument in inspect.signature(getattr(scenes, name)).parameters]


@pytest.mark.slow
def test_all_are_listed_and_found_by_name() -> None:
    assert scenes.names() == NAMES == tuple(scenes.__all__)
    for name in NAMES:
        assert scenes.by_name(name).name == name


@pytest.mark.parametrize(
    ("name", "hint"), [("pinbal", "did you mean 'pinball'"), ("x", "there are annulus, breakout"), (3, "")]
)
def test_a_name_that_is_none_is_refused(name: Any, hint: str) -> None:
    with pytest.raises(carom.SceneError, match=f"no shipped scene is called {name!r}; .*{hint}"):
        scenes.by_name(name)


@pytest.mark.parametrize(("name", "argument"), ARGUMENTS)
def test_arguments_are_counts_and_lengths(name: str, argument: str) -> None:
    refused = NOT_COUNTS if argument in COUNTS else NOT_LENGTHS
    if argument == "seed":
        refused = NOT_COUNTS[1:-1]
    elif (name, argument) in MAY_BE_NOTHING:
        refused = NOT_LENGTHS[1:]
    for value in refused:
        with pytest.raises(carom.InvalidArgument, match=argument):
            getattr(scenes, name)(**SMALL.get(name, {}) | {argument: value})


@pytest.mark.parametrize("name", NAMES)
def test_a_scene_is_the_same_each_time(name: str) -> None:
    assert small_scene(name) == small_scene(name)
    assert small_scene(name).build().digest() == small_scene(name).build().digest()


@pytest.mark.parametrize("name", ["galton", "gas"])
def test_chance_comes_from_the_seed(name: str) -> None:
    make = getattr(scenes, name)
    assert make(**SMALL[name]) == make(**SMALL[name], seed=0) != make(**SMALL[name], seed=1)


@pytest.mark.parametrize("name", NAMES)
def test_nothing_overlaps_at_the_start(name: str) -> None:
    world = small_scene(name).build()
    for ball in world.balls:
        for shape in world.shapes:
            for part in shape.shapes if isinstance(shape, carom.Compound) else [shape]:
                contact = part.detect(ball)
                assert contact is None or part.sensor or contact.setback < 1e-9, (ball, part)


@pytest.mark.parametrize("name", NAMES)
def test_every_ball_is_within_the_bounds(name: str) -> None:
    world = small_scene(name).build()
    assert world.bounds is not None
    for ball in world.balls:
        assert ball.position in world.bounds


# -- joints ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_bare_end_is_guarded(name: str) -> None:
    shapes = list(small_scene(name).build().shapes)
    solid = [part for shape in shapes for part in (shape.shapes if isinstance(shape, carom.Compound) else [shape])]
    solid = [part for part in solid if part.can_collide and not part.sensor]
    assert carom.guard_points(solid) == []
