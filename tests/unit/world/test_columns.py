"""The columns of `world.balls` and the arguments of `add_balls`: the attributes of balls, for all of them at once."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import Ball, World
from carom.rows.ball import ALL_LAYERS

MODES = ("discrete", "continuous")
masks = st.one_of(st.integers(0, ALL_LAYERS), st.sampled_from((0, 1, 2, ALL_LAYERS)))

#: What each column may hold, and what a ball's attribute is where a column holds it.
VALUES: dict[str, st.SearchStrategy[Any]] = {
    "radius": st.floats(0.01, 2.0),
    "mass": st.floats(0.01, 2.0),
    "elasticity": st.floats(0.0, 2.0),
    "friction": st.one_of(st.just(-1.0), st.floats(0.0, 2.0)),
    "layer": masks,
    "collides_with": masks,
    "sensor": st.booleans(),
    "can_collide": st.booleans(),
}
DTYPES = {"layer": np.uint32, "collides_with": np.uint32, "sensor": np.bool_, "can_collide": np.bool_}


def attribute(column: str, value: Any) -> Any:
    """What a ball says where a column holds a value."""
    return None if column == "friction" and value == -1.0 else value


def columns(count: int) -> st.SearchStrategy[dict[str, list[Any]]]:
    """Values of every column for some balls."""
    return st.fixed_dictionaries({name: st.lists(s, min_size=count, max_size=count) for name, s in VALUES.items()})


def scattered(detection: str = "discrete", **column: Any) -> World:
    """A world of six balls that are about to meet each other, a wall and a sensor."""
    world = World(detection=detection, friction=0.5)  # type: ignore[arg-type]
    world.add(carom.Segment((-1, -3), (9, -3)), carom.Circle((3, 0), 2, sensor=True, solid=True))
    position = [(1.1 * n, 0.4 * n) for n in range(6)]
    world.add_balls(position, [(2 - n, -3) for n in range(6)], **({"radius": 0.5} | column))
    return world


@pytest.mark.slow
@given(columns(6))
def test_add_balls_makes_what_constructors_make(values: dict[str, list[Any]]) -> None:
    together = scattered(**values)
    singly = scattered()
    balls = [
        Ball(ball.position, velocity=ball.velocity, **{name: attribute(name, values[name][n]) for name in values})
        for n, ball in enumerate(singly.balls)
    ]
    singly.remove(*singly.balls)
    singly.add(*balls)
    together_rows, singly_rows = together._arrays.balls.used.copy(), singly._arrays.balls.used.copy()
    together_rows["id"] = singly_rows["id"] = 0
    assert together_rows.tobytes() == singly_rows.tobytes()
    for name, given_values in values.items():
        assert getattr(together.balls, name).tolist() == given_values
        assert [getattr(ball, name) for ball in together.balls] == [attribute(name, value) for value in given_values]


@pytest.mark.slow
@given(st.data())
def test_one_value_stands_for_all(data: st.DataObject) -> None:
    values = {name: data.draw(strategy) for name, strategy in VALUES.items()}
    assert scattered(**values).digest() == scattered(**{name: [value] * 6 for name, value in values.items()}).digest()


def test_the_friction_of_all_may_be_none() -> None:
    world = scattered(friction=None)
    assert [ball.friction for ball in world.balls] == [None] * 6
    assert world.balls.friction.tolist() == [-1.0] * 6


@pytest.mark.parametrize("detection", MODES)
@settings(max_examples=12, deadline=None)
@given(columns(6), st.integers(0, 4))
def test_writing_to_columns_is_setting_attributes(detection: str, values: dict[str, list[Any]], steps: int) -> None:
    through_views, through_objects = scattered(detection), scattered(detection)
    for world in (through_views, through_objects):
        world.run(steps / 16, 1 / 16)
    for name, given_values in values.items():
        column = getattr(through_views.balls, name)
        assert column.dtype == DTYPES.get(name, np.float64)
        column[:] = given_values
        for ball, value in zip(through_objects.balls, given_values, strict=True):
            setattr(ball, name, attribute(name, value))
    for _ in range(4):
        hits = [np.asarray(world.step(1 / 16)).tobytes() for world in (through_views, through_objects)]
        assert hits[0] == hits[1]
        assert through_views.digest() == through_objects.digest()


@pytest.mark.parametrize("detection", MODES)
@pytest.mark.parametrize(
    "switch",
    [
        lambda world: world.balls.can_collide.__setitem__(0, False),
        lambda world: world.balls.layer.__setitem__(0, 0),
        lambda world: world.balls.collides_with.__setitem__(0, 0),
    ],
    ids=["can_collide", "layer", "collides_with"],
)
def test_a_ball_that_is_switched_off_inside_a_sensor_leaves_it(detection: str, switch: Callable[[World], None]) -> None:
    world = World(detection=detection)  # type: ignore[arg-type]
    eye = world.add(carom.Circle((0, 0), 5, sensor=True, solid=True))
    world.add_balls([(0, 0)], radius=1.0)
    assert [hit.kind.name for hit in world.step(0.1)] == ["ENTER"]
    switch(world)
    (leave,) = world.run(0.2)
    assert (leave.kind.name, leave.shape) == ("EXIT", eye)


@pytest.mark.parametrize("detection", MODES)
def test_a_sensor_of_a_column_meets_and_moves_nothing(detection: str) -> None:
    world = World(detection=detection)  # type: ignore[arg-type]
    floor = world.add(carom.Segment((-5, 0), (5, 0)))
    world.add_balls([(-2, 1), (2, 1)], (0, -4), 0.5)
    world.balls.sensor[0] = True
    hits = world.run(0.5)
    assert {(hit.ball, hit.kind.name) for hit in hits if hit.shape is floor} == {
        (world.balls[0], "ENTER"),
        (world.balls[0], "EXIT"),
        (world.balls[1], "BOUNCE"),
    }


@pytest.mark.parametrize("name", ["elasticity", "friction", "layer", "collides_with", "sensor", "can_collide"])
def test_writing_wakes_and_reading_does_not(name: str) -> None:
    world = World(sleep_speed=0.5, sleep_time=0.1)
    world.add_balls([(0, 0), (5, 0), (9, 0)], radius=1.0)
    column = getattr(world.balls, name)
    world.run(0.5)
    assert world.balls.asleep.all()
    before = world.digest()
    getattr(world.balls, name).copy()
    assert world.digest() == before
    world.step(0.001)
    assert world.statistics.sleeping == 3
    column[1] = not column[1] if column.dtype == np.bool_ else 3
    world.step(0.001)
    assert world.statistics.sleeping == 0


def test_a_change_from_before_they_slept_does_not_wake_them() -> None:
    world = World(sleep_speed=0.5, sleep_time=0.1)
    world.add_balls([(0, 0), (5, 0)], radius=1.0)
    world.balls.elasticity[:] = 0.5
    world.run(0.5)
    world.balls.elasticity.copy()
    for _ in range(3):
        world.step(0.01)
        assert world.statistics.sleeping == 2


def test_ids_and_sleep_can_be_read_alone() -> None:
    world = scattered()
    for name in ("id", "asleep"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(world.balls, name)[0] = 1
    assert world.balls.asleep.dtype == np.bool_
    assert world.balls.asleep.tolist() == [ball.asleep for ball in world.balls]


@pytest.mark.parametrize("detection", MODES)
@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("elasticity", -0.5, r"elasticity must not be negative, not -0\.5 as for balls 4, 6"),
        ("friction", -0.5, r"friction must be 0 or more, or -1 for the world's, not -0\.5 as for balls 4, 6"),
        ("elasticity", np.nan, "balls 4, 6 are not finite"),
        ("elasticity", np.inf, "balls 4, 6 are not finite"),
        ("friction", np.nan, "balls 4, 6 are not finite"),
        ("friction", np.inf, "balls 4, 6 are not finite"),
        ("friction", -np.inf, "balls 4, 6 are not finite"),
    ],
)
def test_what_may_not_be_is_refused_by_the_next_step(detection: str, name: str, value: float, error: str) -> None:
    world = scattered(detection)
    world.step(0.1)
    getattr(world.balls, name)[1::2][:2] = value
    before = world.digest()
    for _ in range(2):
        with pytest.raises(carom.CaromError, match=error):
            world.step(0.1)
        assert world.digest() == before
    copy = World()
    copy.restore(world.snapshot())
    with pytest.raises(carom.CaromError, match=error):
        copy.step(0.1)
    getattr(world.balls, name)[:] = 0.5
    world.step(0.1)


@pytest.mark.parametrize("detection", MODES)
@pytest.mark.parametrize("name", ["sensor", "can_collide"])
def test_any_byte_but_0_is_yes(detection: str, name: str) -> None:
    plain, odd = scattered(detection, **{name: True}), scattered(detection)
    getattr(odd.balls, name).view(np.uint8)[:] = 7
    assert odd.digest() == plain.digest()
    for world in (plain, odd):
        world.run(0.25, 1 / 16)
    assert odd.digest() == plain.digest()
    World().restore(odd.snapshot())
