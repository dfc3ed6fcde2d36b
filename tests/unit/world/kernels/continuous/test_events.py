"""What happens at each event, and what comes next: relations and motions that end, impacts, shapes that stop."""

from typing import Any

import numpy as np
import pytest

from carom import Ball, Circle, Segment
from carom.rows.flight import ASLEEP, CLEAR, EXIT_SHAPE, HIT_BALL, HIT_SHAPE, LEAVE, LOOK, NOTHING, SLEEP, STOP
from carom.rows.hit import EXIT, HIT_ROW
from carom.rows.relation import INSIDE_SHAPE, LASTING, PASSING
from carom.world.kernels.continuous.events import (
    came_past_end,
    change_shapes,
    deal_with,
    end_quietly,
    is_held_by_changing,
    meet_balls,
)
from carom.world.kernels.continuous.movers import foresee_changes
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import film_tables, foresee_all, foreseen, in_flight, look_at, shape_index
from tests.worlds import continuous_world


def dealt(arrays: Arrays, heads: Any, i: int) -> None:
    """Let it be the time of a ball's event, and deal with that."""
    state, flight = arrays.states[0], arrays.flights[i]
    state["now"], state["now_low"] = flight["event_time"], flight["event_low"]
    tables = (
        *film_tables(arrays),
        heads,
        arrays.hits.view(HIT_ROW),
        arrays.relations,
        arrays.flights,
        arrays.queue,
        arrays.island,
    )
    deal_with(state, arrays.balls.rows, *tables, i)


def test_an_impact_turns_the_ball_and_the_next_one_is_foreseen() -> None:
    walls = Segment((0, -5), (0, 5)), Segment((9, -5), (9, 5))
    arrays = in_flight(continuous_world(*walls, Ball((3, 0), 1, velocity=(-2, 0))))
    heads = foresee_all(arrays)
    assert foreseen(arrays) == (HIT_SHAPE, 1.0, 0.0, 0)
    dealt(arrays, heads, 0)
    assert (arrays.states[0]["hits"], arrays.balls.rows["vx"][0]) == (1, 2)
    assert foreseen(arrays) == (HIT_SHAPE, 4.5, 0.0, 1)


def test_what_a_ball_meets_it_does_not_pass_though_it_comes_to_it_a_little_late() -> None:
    arrays = in_flight(continuous_world(Segment((0, -5), (0, 5)), Ball((3, 6), 1, velocity=(-2, -2))))
    heads = foresee_all(arrays)
    assert foreseen(arrays) == (HIT_SHAPE, 1.0, 0.0, 0)
    arrays.flights["event_time"][0] = 1.01
    dealt(arrays, heads, 0)
    assert (arrays.states[0]["hits"], arrays.balls.rows["vx"][0]) == (1, 2)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)


def test_an_impact_of_two_begins_new_flights_of_both() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, velocity=(1, 0)), Ball((5, 0), 1), Ball((20, 0), 1)))
    heads = foresee_all(arrays)
    assert foreseen(arrays, 0) == (HIT_BALL, 3.0, 0.0, 1)
    dealt(arrays, heads, 0)
    assert arrays.flights["time"][:3].tolist() == [3, 3, 0]
    assert arrays.balls.used["vx"].tolist() == [0, 1, 0]
    assert foreseen(arrays, 1) == (HIT_BALL, 16.0, 0.0, 2)
    assert foreseen(arrays, 0)[0] == NOTHING


def test_an_impact_with_one_whose_path_has_changed_is_none() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, velocity=(1, 0)), Ball((5, 0), 1)))
    heads = foresee_all(arrays)
    arrays.balls.rows["y"][1] = 7.0
    arrays.flights["version"][1] += 1
    dealt(arrays, heads, 0)
    assert (arrays.states[0]["hits"], arrays.flights["time"][0]) == (0, 0)
    assert foreseen(arrays) == (NOTHING, float("inf"), 0.0, -1)


def test_a_look_changes_no_path() -> None:
    arrays = in_flight(continuous_world(Circle((9, 0), 1), Ball((0, 0), 1, velocity=(1, 0))))
    heads = foresee_all(arrays)
    flight, version = arrays.flights[0], int(arrays.flights["version"][0])
    flight["event"], flight["event_time"] = LOOK, 0.5
    dealt(arrays, heads, 0)
    assert (flight["version"], flight["time"], arrays.balls.rows["x"][0]) == (version, 0, 0)
    assert foreseen(arrays) == (HIT_SHAPE, 7.0, 0.0, 0)


@pytest.mark.parametrize(("event", "relation"), [(LEAVE, LASTING), (EXIT_SHAPE, INSIDE_SHAPE)])
def test_a_relation_ends_with_its_event(event: int, relation: int) -> None:
    arrays = in_flight(continuous_world(Circle((0, -2), 1), Ball((0, 0), 1)))
    state, ball = arrays.states[0], arrays.balls.rows[0]
    add_relation(state, arrays.relations, ball, 0, relation, 0)
    tables = arrays.shapes.rows, arrays.hits.view(HIT_ROW), arrays.relations
    look_at(arrays, 0.25)
    end_quietly(state, ball, arrays.flights[0], *tables, event, 0)
    assert not find_relation(arrays.relations, ball, relation, 0)
    assert state["hits"] == int(event == EXIT_SHAPE)
    if event == EXIT_SHAPE:
        assert (arrays.hits[0]["kind"], arrays.hits[0]["time"]) == (EXIT, 0.25)


@pytest.mark.parametrize("event", [STOP, SLEEP])
def test_a_motion_ends_with_its_event(event: int) -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, velocity=(1e-20, 3))))
    state, ball, flight = arrays.states[0], arrays.balls.rows[0], arrays.flights[0]
    end_quietly(state, ball, flight, arrays.shapes.rows, arrays.hits.view(HIT_ROW), arrays.relations, event, -1)
    assert (ball["vx"], ball["vy"]) == (0, 0)
    assert (ball["asleep"], state["sleeping"]) == (int(event == SLEEP),) * 2
    assert (flight["kind"] == ASLEEP) == (event == SLEEP)


def test_balls_that_were_pushed_apart_are_kept_out_of_walls() -> None:
    wall = Segment((-1, -5), (-1, 5))
    arrays = in_flight(continuous_world(wall, Ball((0, 0), 1, velocity=(1, 0)), Ball((2, 0), 1)))
    arrays.balls.rows["x"][1] = 1.9
    tables = arrays.shapes.rows, *shape_index(arrays), arrays.hits.view(HIT_ROW), arrays.relations, arrays.flights
    meet_balls(arrays.states[0], arrays.balls.rows, *tables, 0, 1)
    assert arrays.balls.rows["x"][0] == pytest.approx(0.0, abs=1e-15)
    assert arrays.balls.used["vx"].tolist() == [0, 1]


def test_what_comes_past_an_end_of_a_mover_is_told_from_what_touches_its_side() -> None:
    bar = Segment((0, 0), (9, 0), motion="kinematic", velocity=(-1, 0))
    arrays = in_flight(continuous_world(bar, Ball((-4, 0.3), 1)))
    ball, flight, shape = arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    state = arrays.states[0]
    assert not came_past_end(state, ball, flight, shape, arrays.relations)
    look_at(arrays, 4.5)
    assert came_past_end(state, ball, flight, shape, arrays.relations)
    ball["y"] = 1.0
    assert not came_past_end(state, ball, flight, shape, arrays.relations)


@pytest.mark.parametrize("event", [CLEAR, HIT_SHAPE])
def test_what_a_ball_passes_begins_and_ends_on_its_way(event: int) -> None:
    bar = Segment((0, 0), (9, 0), motion="kinematic", velocity=(-1, 0))
    arrays = in_flight(continuous_world(bar, Ball((-4, 0.3), 1)))
    heads = foresee_all(arrays)
    state, ball, flight = arrays.states[0], arrays.balls.rows[0], arrays.flights[0]
    if event == CLEAR:
        add_relation(state, arrays.relations, ball, 0, PASSING, 0)
    look_at(arrays, 4.5)
    flight["event"], flight["event_time"], flight["partner"] = event, 4.5, 0
    version = int(flight["version"])
    dealt(arrays, heads, 0)
    assert find_relation(arrays.relations, ball, PASSING, 0) == (event == HIT_SHAPE)
    assert (flight["version"], flight["time"], state["hits"]) == (version, 0, 0)


def test_when_shapes_stop_balls_that_they_hold_begin_new_flights() -> None:
    floor = Segment((-5, 0), (5, 0), motion="kinematic", pivot=(0, 0), turn_limits=(-0.5, 0.001))
    belt = Segment((-5, 39), (5, 39), motion="kinematic", velocity=(1, 0))
    world = continuous_world(floor, belt, Ball((0, 1), 1), Ball((0, 40), 1), Ball((0, 80), 1), gravity=(0, -10))
    floor.angular_velocity = 0.01
    arrays = in_flight(world)
    state = arrays.states[0]
    for row in range(2):
        add_relation(state, arrays.relations, arrays.balls.rows[row], row, LASTING, row)
    foresee_changes(state, arrays.shapes.rows, arrays.order)
    assert state["change"] == pytest.approx(0.1)
    rows = arrays.shapes.rows, arrays.relations
    assert not any(is_held_by_changing(state, ball, *rows) for ball in arrays.balls.used)
    state["now"], state["now_low"] = state["change"], state["change_low"]
    assert [is_held_by_changing(state, ball, *rows) for ball in arrays.balls.used] == [True, False, False]
    tables = *film_tables(arrays), arrays.flights, arrays.relations, arrays.island[0]
    change_shapes(state, arrays.balls.rows, *tables)
    assert arrays.shapes.rows["orientation"][0] == 0.001
    assert arrays.flights["time"][:3].tolist() == [state["now"], 0, 0]
    assert np.isinf(state["change"])
