"""What a ball finds where its flight has taken it: what it has left, what it has come onto past an end, and when."""

from math import sqrt

import numpy as np
import pytest

from carom import Ball, Circle, Segment, World
from carom.rows.hit import ENTER, EXIT, HIT_ROW
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, NO_RELATION, PASSING
from carom.world.kernels.continuous.arrival import arrive, note_late, time_of
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, shape_index
from tests.worlds import continuous_world


def flying(world: World, span: float) -> Arrays:
    """The tables of a world at the beginning of a span."""
    arrays = in_flight(world, span)
    arrays.balls.rows["relation"] = NO_RELATION
    arrays.states[0]["free_relation"] = NO_RELATION
    return arrays


def come(arrays: Arrays, i: int, time: float) -> list[tuple[int, float]]:
    """The kinds and times of hits that a ball finds when it has flown until a time."""
    tables = arrays.shapes.rows, arrays.order, *shape_index(arrays), np.zeros(64, "i4"), arrays.flights
    hits = arrays.hits.view(HIT_ROW)
    arrive(arrays.states[0], arrays.balls.rows, *tables, hits, arrays.relations, i, time)
    return [(int(hit["kind"]), float(hit["time"])) for hit in hits[: int(arrays.states[0]["hits"])]]


def test_times_of_a_span_are_times_of_the_world() -> None:
    state = flying(continuous_world(Ball((0, 0), 1)), 8.0).states[0]
    state["time"], state["substeps"], state["substep"], state["span_begin"] = 100.0, 4, 2, 0.5
    assert time_of(state, 0.25) == 100 + 2 * 2 + 0.5 + 0.25
    # Not even rounding takes it past the step's end.
    assert time_of(state, 99.0) == 108.0


def test_what_is_found_out_late_stands_in_the_order_of_time() -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1)), 8.0)
    arrays.states[0]["step_hits"] = arrays.states[0]["hits"] = 1  # of the step before
    arrays.hits[0]["time"] = 5.0
    for time in (2.0, 1.0, 3.0, 1.5):
        note_late(arrays.states[0], arrays.hits.view(HIT_ROW), time, EXIT, 1, 2)
    assert arrays.hits["time"][:5].tolist() == [5.0, 1.0, 1.5, 2.0, 3.0]


@pytest.mark.parametrize("motion", [{}, {"motion": "kinematic", "velocity": (-1, 0)}])
def test_a_ball_has_left_a_sensor_when_it_last_touched_it(motion: dict[str, object]) -> None:
    eye = Circle((0, 0), 3, solid=True, sensor=True, **motion)  # type: ignore[arg-type]
    arrays = flying(continuous_world(eye, Ball((1, 0), 0.5, velocity=(2, 0))), 8.0)
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, INSIDE_SHAPE, 0)
    away = 2.5 / (3 if motion else 2)
    assert come(arrays, 0, 0.9 * away) == []
    assert find_relation(arrays.relations, arrays.balls.rows[0], INSIDE_SHAPE, 0)
    assert come(arrays, 0, 4.0) == [(EXIT, pytest.approx(away))]
    assert not find_relation(arrays.relations, arrays.balls.rows[0], INSIDE_SHAPE, 0)
    assert arrays.balls.rows["x"][0] == 9


def test_a_ball_has_left_another_when_it_last_touched_it() -> None:
    arrays = flying(
        continuous_world(Ball((0, 0), 1, sensor=True), Ball((1, 0), 1, velocity=(2, 0)), gravity=(0, -9)), 8.0
    )
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[1], 1, INSIDE_BALL, 0)
    assert come(arrays, 1, 3.0) == [(EXIT, pytest.approx(0.5))]


@pytest.mark.parametrize("sensor", [True, False])
def test_a_ball_that_comes_past_an_end_passes_a_segment_and_enters_a_sensor(sensor: bool) -> None:
    wall = Segment((0, 0), (9, 0), sensor=sensor)
    arrays = flying(continuous_world(wall, Ball((-2, 0.5), 1, velocity=(1, 0))), 8.0)
    entered = 2.0  # when its centre is above the end
    assert come(arrays, 0, 1.9) == []
    assert come(arrays, 0, 2.5) == ([(ENTER, pytest.approx(entered))] if sensor else [])
    assert find_relation(arrays.relations, arrays.balls.rows[0], INSIDE_SHAPE if sensor else PASSING, 0)
    assert come(arrays, 0, 3.0) == ([(ENTER, pytest.approx(entered))] if sensor else [])


def test_a_ball_passes_a_segment_until_it_is_clear_of_its_ends_too() -> None:
    arrays = flying(continuous_world(Segment((0, 0), (9, 0)), Ball((1, 0.5), 1, velocity=(-1, 0))), 8.0)
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, PASSING, 0)
    for time, passes in ((1.1, True), (0.99 * (1 + sqrt(0.75)), True), (1.01 * (1 + sqrt(0.75)), False)):
        come(arrays, 0, time)
        assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0) == passes
