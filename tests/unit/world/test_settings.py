"""Settings: keyword arguments and attributes, validated when set, that act from the next step on."""

import inspect
from typing import Any

import pytest

import carom
from carom.world.settings import SETTINGS

#: For every setting, another value than its default.
OTHER: dict[str, Any] = {
    "gravity": (1.0, -2.0),
    "detection": "discrete",
    "substeps": 7,
    "iterations": 3,
    "broad_phase": "quadtree",
    "levels": 3,
    "restitution": "total",
    "friction": 0.5,
    "sleep_speed": 0.25,
    "sleep_time": 2.0,
    "rest_speed": 0.0,
    "max_speed": 9.0,
    "max_impacts": 10,
    "bounds": carom.Aabb(0, 1, 2, 3),
    "remove_strays": True,
}

#: The defaults, as the signature has them.
DEFAULTS = {name: parameter.default for name, parameter in inspect.signature(carom.World).parameters.items()}


def test_every_setting_is_known_here_and_documented() -> None:
    assert set(OTHER) == set(SETTINGS)
    for name in SETTINGS:
        assert getattr(carom.World, name).__doc__.endswith(".")


def test_the_keyword_arguments_are_the_settings_with_their_defaults() -> None:
    parameters = inspect.signature(carom.World).parameters
    assert tuple(parameters) == SETTINGS
    world = carom.World()
    for name, parameter in parameters.items():
        assert parameter.kind is inspect.Parameter.KEYWORD_ONLY
        assert parameter.default == getattr(world, name), name


@pytest.mark.parametrize("name", SETTINGS)
def test_a_setting_is_what_it_was_set_to_at_once_and_at_any_time(name: str) -> None:
    assert getattr(carom.World(**{name: OTHER[name]}), name) == OTHER[name]
    world = carom.World()
    world.add(carom.Ball((0, 0), 1))
    world.step(0.1)
    setattr(world, name, OTHER[name])
    assert getattr(world, name) == OTHER[name]
    world.step(0.1)
    assert getattr(world, name) == OTHER[name]
    setattr(world, name, DEFAULTS[name])
    assert world.digest() == (lambda twin: twin.restore(world.snapshot()) or twin.digest())(carom.World())


@pytest.mark.parametrize("name", SETTINGS)
def test_a_setting_that_is_set_back_leaves_nothing_behind(name: str) -> None:
    world = carom.World()
    before = world.digest()
    setattr(world, name, OTHER[name])
    setattr(world, name, DEFAULTS[name])
    assert world.digest() == before


def test_bounds_are_taken_as_a_box_or_four_numbers() -> None:
    world = carom.World(bounds=(0, 1, 2, 3))
    assert world.bounds == carom.Aabb(0, 1, 2, 3)
    world.bounds = [0, 0, 1, 1]
    assert world.bounds == carom.Aabb(0, 0, 1, 1)


def test_numbers_of_other_types_are_taken() -> None:
    import numpy as np

    world = carom.World(
        substeps=np.int32(3), friction=np.float32(0.5), remove_strays=np.True_, gravity=np.array([0, 1])
    )
    assert (world.substeps, world.friction, world.remove_strays, world.gravity) == (3, 0.5, True, (0.0, 1.0))
    assert [type(value) for value in (world.substeps, world.friction, world.remove_strays)] == [int, float, bool]


def test_the_default_rest_speed_is_twice_what_gravity_adds_in_a_substep() -> None:
    for speed, rests in ((0.99 * 2 * 10 * 0.01, True), (1.01 * 2 * 10 * 0.01, False)):
        world = carom.World(detection="discrete", gravity=(0, -10), substeps=1)
        world.add(carom.Segment((-5, 0), (5, 0), elasticity=0.5))
        ball = world.add(carom.Ball((0, 1 - 1e-12), 1, (0, -speed)))
        hits = world.step(0.01)
        assert (len(hits) == 0) == rests == (ball.velocity[1] == 0.0)


def test_changes_between_steps_act_from_the_next_one_on() -> None:
    world = carom.World(gravity=(0, -1), substeps=1)
    ball = world.add(carom.Ball((0, 0), 1))
    world.step(1.0)
    world.gravity = (2, 0)
    world.step(1.0)
    assert ball.velocity == (2.0, -1.0)
    world.friction = 1.0
    world.step(0.0)
    assert ball.velocity == (2.0, -1.0)
    world.gravity = (0, 0)
    world.friction = 100.0
    world.step(1.0)
    assert ball.velocity == (0.0, 0.0)


def test_a_setting_wakes_all() -> None:
    world = carom.World(sleep_speed=1.0, sleep_time=0.1)
    world.add(carom.Ball((0, 0), 1))
    world.run(0.5)
    world.gravity = (0, -1)
    world.step(0.01)
    assert world.statistics.sleeping == 0
