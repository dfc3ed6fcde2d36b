"""The end of a substep: friction, sleep, and relations that hold no more."""

from math import nan

import numpy as np
import pytest

from carom import Ball, Segment, World
from carom.rows.ball import OF_WORLD
from carom.rows.hit import EXIT, HIT_ROW
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, PASSING
from carom.rows.state import DONE, HAS_STRAYS, NOT_FINITE
from carom.rows.tables import Rows
from carom.world.kernels.step.ending import end_step, find_strays, finish_substep, still_holds, sweep_relations
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import ball_rows, begun, prepared, state_row
from tests.worlds import world_of


def moving_rows(speeds: list[float]) -> Rows:
    """Balls that move at these speeds, in directions of their own, and have the world's friction."""
    rows = ball_rows([(0.0, 0.0, 1.0)] * len(speeds))
    angles = 1.0 + np.arange(len(speeds))
    rows["vx"], rows["vy"], rows["friction"] = speeds * np.cos(angles), speeds * np.sin(angles), OF_WORLD
    return rows


def test_each_ball_loses_what_its_friction_or_the_worlds_takes() -> None:
    rows = moving_rows([5.0, 5.0, 5.0, 0.4, 5.0])
    rows["friction"][1:3] = 8.0, 0.0
    rows["asleep"][4] = 1
    before, state = rows.copy(), state_row(rows, "grid", 1)
    state["friction"], state["braked"] = 2.0, 2
    finish_substep(state, rows, 0.25)
    lost = np.array([0.5, 2.0, 0.0, 0.4, 0.0])
    speed = np.hypot(before["vx"], before["vy"])
    assert np.hypot(rows["vx"], rows["vy"]) == pytest.approx(speed - lost)
    assert rows["vx"] * before["vy"] == pytest.approx(rows["vy"] * before["vx"])


def test_a_ball_falls_asleep_once_it_was_slow_for_long_enough_without_a_break() -> None:
    rows = moving_rows([0.5, 0.5, 1.001])
    state = state_row(rows, "grid", 1)
    state["sleep_speed"], state["sleep_time"] = 1.0, 1.0
    for step in range(5):
        rows["vx"][1] = 2.0 if step == 2 else 0.5
        finish_substep(state, rows, 0.25)
        assert rows["asleep"].tolist() == [int(step >= 3), 0, 0]
        assert state["sleeping"] == int(step >= 3)
    assert rows["still_time"].tolist() == [1.0, 0.5, 0.0]
    assert (rows["vx"][0], rows["vy"][0]) == (0.0, 0.0)


def related(world: World, kind: int, other: int) -> Arrays:
    """The tables of a world whose last ball has a relation to a row."""
    arrays = prepared(world)
    place = arrays.balls.count - 1
    arrays.balls.rows["relation"] = -1
    arrays.states[0]["free_relation"] = -1
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[place], place, kind, other)
    return arrays


@pytest.mark.parametrize(
    ("kind", "y", "holds"),
    [
        (PASSING, 0.9, True),
        (PASSING, 1.1, False),
        (INSIDE_SHAPE, 0.9, True),
        (INSIDE_SHAPE, 1.1, False),
        (INSIDE_BALL, 2.44, True),
        (INSIDE_BALL, 2.46, False),
    ],
)
def test_a_relation_holds_as_long_as_what_it_is_to_is_overlapped(kind: int, y: float, holds: bool) -> None:
    wall = Segment((0, 0), (9, 0), sensor=kind == INSIDE_SHAPE)
    world = world_of(wall, Ball((0.0, 0.0), 1.5, sensor=True), Ball((0.5, y), 1.0))
    arrays = related(world, kind, 0)
    state, balls, shapes = arrays.states[0], arrays.balls.rows, arrays.shapes.rows
    assert still_holds(state, balls, shapes, balls[1], kind, 0) == holds
    sweep_relations(state, balls, shapes, arrays.hits.view(HIT_ROW), arrays.relations, 7.0)
    assert find_relation(arrays.relations, balls[1], kind, 0) == holds
    ended = not holds and kind != PASSING
    assert state["hits"] == int(ended)
    if ended:
        hit = arrays.hits[0]
        other = world.balls[0].id if kind == INSIDE_BALL else wall.id
        assert (hit["time"], hit["kind"], hit["ball"], hit["shape"]) == (7.0, EXIT, world.balls[1].id, other)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("kind", [PASSING, INSIDE_SHAPE, INSIDE_BALL])
def test_a_relation_ends_with_what_it_was_to_or_when_that_is_a_sensor_no_more(kind: int, detection: str) -> None:
    wall = Segment((0, 0), (9, 0), sensor=kind == INSIDE_SHAPE)
    other, ball = Ball((0.0, 0.0), 1.5, sensor=kind == INSIDE_BALL), Ball((0.5, 0.9), 1.0)
    world = world_of(wall, other, ball, detection=detection)
    arrays = related(world, kind, 0)
    partner = arrays.balls.rows[0] if kind == INSIDE_BALL else arrays.shapes.rows[0]

    def holds() -> bool:
        """Whether it does now."""
        return still_holds(arrays.states[0], arrays.balls.rows, arrays.shapes.rows, arrays.balls.rows[1], kind, 0)

    assert holds()
    for row in (partner, arrays.balls.rows[1]):
        row["can_collide"] = 0
        assert not holds()
        row["can_collide"] = 1
    partner["sensor"] = 1 - partner["sensor"]
    assert not holds()
    arrays.balls.rows[1]["sensor"] = 1
    assert holds() == (kind != PASSING)


@pytest.mark.parametrize(("removes", "status"), [(True, HAS_STRAYS), (False, DONE)])
def test_a_step_ends_with_its_time_and_with_those_that_have_left_the_bounds(removes: bool, status: int) -> None:
    world = World(detection="discrete", bounds=(0, 0, 10, 10), remove_strays=removes)
    for x, y in ((5, 5), (-0.99, 5), (-1.01, 5), (5, 11.01), (5, 10.99), (11.5, 11.5)):
        world.add(Ball((x, y), 1))
    arrays = prepared(world)
    arrays.states[0]["dt"], arrays.states[0]["steps_left"] = 0.25, 3
    assert begun(arrays) == DONE
    arrays.balls.rows["stray"][5] = 1
    found = end_step(arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations)
    assert found == status
    assert arrays.balls.used["stray"].tolist() == [0, 0, 1, 1, 0, 1]
    state = arrays.states[0]
    assert (state["time"], state["steps_left"], state["outside"], state["strays"]) == (0.25, 2, 3, 2)


def test_a_step_that_leaves_a_ball_infinite_is_undone() -> None:
    arrays = prepared(world_of(Segment((0, 0), (1, 0)), Ball((0, 0), 1), Ball((5, 5), 1, velocity=(1, 2))))
    assert begun(arrays) == DONE
    before = arrays.balls.used.tobytes()
    arrays.balls.used["x"] = 3.0, nan
    # Whatever moves or turns a ball looks whether it is sound still, and notes where it is not.
    arrays.states[0]["doubtful"] = 1
    found = end_step(arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations)
    assert found == NOT_FINITE
    assert arrays.balls.used.tobytes() == before
    assert arrays.states[0]["time"] == 0.0


def test_a_ball_on_the_border_is_no_stray() -> None:
    arrays = prepared(world_of(Ball((-1, 5), 1), Ball((11, 5), 1), bounds=(0, 0, 10, 10)))
    find_strays(arrays.states[0], arrays.balls.rows)
    assert arrays.states[0]["strays"] == 0
