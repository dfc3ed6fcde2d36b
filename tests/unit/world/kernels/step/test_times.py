"""Lengths and times of substeps."""

from math import sqrt

import pytest

from carom.constants import REBOUND
from carom.rows.state import CONTINUOUS, DISCRETE
from carom.rows.tables import Row
from carom.world.kernels.step.times import hit_time, rest_speed, substep_end, substep_length
from tests.kernel_calls import ball_rows, state_row


def state_at(substep: int) -> Row:
    """The state in a substep of a step of a tenth of a second that begins at 0.7."""
    state = state_row(ball_rows([]), "grid", 1)
    state["time"], state["dt"], state["substeps"], state["substep"] = 0.7, 0.1, 3, substep
    return state


def test_substeps_are_parts_of_a_step_and_the_last_one_ends_with_it_to_the_bit() -> None:
    assert [substep_length(state_at(k)) for k in range(3)] == [0.1 / 3] * 3
    assert [substep_end(state_at(k)) for k in range(3)] == [0.7 + 0.1 / 3, 0.7 + 2 * 0.1 / 3, 0.7 + 0.1]


def test_overlaps_are_met_at_the_end_of_a_substep_or_where_all_else_flies_now() -> None:
    for detection, time in ((DISCRETE, 0.7 + 2 * 0.1 / 3), (CONTINUOUS, 0.7)):
        state = state_at(1)
        state["detection"], state["now"] = detection, 0.7
        assert hit_time(state) == pytest.approx(time, rel=1e-15)


@pytest.mark.parametrize(("given", "speed"), [(0.5, 0.5), (0.0, 0.0), (-1.0, 2 * 5 * 0.1 / 3)])
def test_the_speed_of_rest_is_the_one_given_or_twice_what_gravity_adds_in_a_substep(given: float, speed: float) -> None:
    state = state_at(0)
    state["rest_speed"], state["gravity_x"], state["gravity_y"] = given, 3.0, -4.0
    assert rest_speed(state, 0.25) == pytest.approx(speed)


def test_where_all_else_flies_the_speed_of_rest_does_not_depend_on_the_step() -> None:
    state = state_at(0)
    state["detection"], state["rest_speed"], state["gravity_x"], state["gravity_y"] = CONTINUOUS, -1.0, 3.0, -4.0
    assert rest_speed(state, 0.25) == sqrt(2 * 5 * REBOUND * 0.25)
    state["dt"] = 17.0
    assert rest_speed(state, 0.25) == sqrt(2 * 5 * REBOUND * 0.25)
    state["rest_speed"] = 0.5
    assert rest_speed(state, 0.25) == 0.5
