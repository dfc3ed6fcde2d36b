"""How a ball comes to an event: a new flight begins where it is, and what it came onto past an end it passes."""

from math import hypot, pi
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Segment
from carom.geometry.path import Path
from carom.rows.flight import ASLEEP, COPIED_LINES, COURSE, EVENT_LINES, FLIGHT, NO_SHAPE
from carom.rows.relation import LASTING, PASSING
from carom.rows.tables import LINE
from carom.world.kernels.continuous.arrival import arrive, copy_course, fly_on, keep_course, note_passing
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, look_at, near_tables
from tests.worlds import continuous_world


def come(arrays: Arrays, seconds: float, met: int = NO_SHAPE) -> None:
    """Let the ball arrive so many seconds after the step began."""
    look_at(arrays, seconds)
    tables = *near_tables(arrays), arrays.flights, arrays.relations
    arrive(arrays.states[0], arrays.balls.rows, *tables, 0, met)


def test_a_new_flight_begins_where_the_ball_is() -> None:
    arrays = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0, -2)))
    version = int(arrays.flights["version"][0])
    come(arrays, 0.5)
    row, flight = arrays.balls.rows[0], arrays.flights[0]
    assert tuple(row[name] for name in ("x", "y", "vx", "vy")) == (2.5, 3.75, 3, 3)
    assert (flight["time"], flight["low"], flight["version"]) == (0.5, 0.0, version + 1)
    come(arrays, 0.5)
    assert (row["x"], flight["version"]) == (2.5, version + 2)


def test_all_of_a_course_is_copied_but_what_an_event_leaves_and_its_lines_are_those_that_are_asked_for() -> None:
    left = {"id", *(name for name in FLIGHT.names or () if name.startswith("shown"))}
    wanted = {*(COURSE.names or ())} - left | {"still_time", "relation", "asleep", "stray"}
    flights = np.zeros(2, FLIGHT)
    for k, name in enumerate(FLIGHT.names or ()):
        flights[0][name] = k + 1
    copy_course(flights[0], flights[1])
    copied = {name for name in FLIGHT.names or () if flights[1][name] != 0}
    assert copied == wanted
    assert all(flights[1][name] == flights[0][name] for name in wanted)
    places = {name: int(FLIGHT.fields[name][1]) // LINE for name in FLIGHT.names or ()}
    assert max(places[name] for name in wanted | {"impacts"}) == COPIED_LINES - 1
    assert {name for name in places if places[name] >= EVENT_LINES} == {
        f"{when}_{what}" for when in ("shown", "seen") for what in ("x", "y", "vx", "vy")
    }


def test_a_sleeper_arrives_where_it_lies() -> None:
    arrays = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4))))
    arrays.flights["kind"][0] = ASLEEP
    fly_on(arrays.balls.rows[0], arrays.flights[0], 2.0)
    assert tuple(arrays.balls.rows[0][name] for name in ("x", "y", "vx")) == (1, 2, 3)


def test_what_a_step_goes_back_to_is_kept_once_a_step() -> None:
    arrays = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4))))
    ball, flight, copies = arrays.balls.rows[0], arrays.flights[0], len(arrays.flights) // 2
    # Its flight began in this step, so there is nothing to go back to; in the next one there is.
    arrays.states[0]["step_number"] += 1
    flight["impacts"] = 9
    arrays.states[0]["step_number"] += 1
    keep_course(arrays.states[0], ball, arrays.flights, 0)
    assert flight["impacts"] == 0
    ball["x"] = 7.0
    flight["impacts"] = 3
    keep_course(arrays.states[0], ball, arrays.flights, 0)
    assert (arrays.flights[copies]["x"], arrays.flights[copies]["vx"], flight["impacts"]) == (1, 3, 3)
    arrays.states[0]["step_number"] += 1
    keep_course(arrays.states[0], ball, arrays.flights, 0)
    assert (arrays.flights[copies]["x"], flight["impacts"]) == (7, 0)


@pytest.mark.parametrize("motion", [{}, {"motion": "kinematic", "velocity": (-0.5, 0)}])
def test_a_ball_that_comes_past_an_end_passes_a_wall(motion: dict[str, Any]) -> None:
    ball = Ball((-2, 0.5), 1, velocity=(0.5 if motion else 1, 0))
    arrays = in_flight(continuous_world(Segment((0, 0), (9, 0), **motion), ball))
    come(arrays, 1.9)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)
    come(arrays, 2.5)
    assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)


@pytest.mark.parametrize("motion", [{}, {"motion": "kinematic", "velocity": (-0.5, 0)}])
@pytest.mark.parametrize("met", [0, 1])
def test_of_two_walls_the_one_that_a_ball_meets_is_not_passed(motion: dict[str, Any], met: int) -> None:
    ball = Ball((-2, 0.5), 1, velocity=(0.5 if motion else 1, 0))
    arrays = in_flight(continuous_world(*(Segment((0, 0), (9, y), **motion) for y in (0, 1)), ball))
    come(arrays, 2.5, met)
    passed = [find_relation(arrays.relations, arrays.balls.rows[0], PASSING, row) for row in range(2)]
    assert passed == [met != 0, met != 1]


@pytest.mark.parametrize(
    ("shape", "passes"),
    [
        (Segment((0, 0), (9, 0)), True),
        (Arc((0, -30), 30, 0.3, 1.5708), True),
        (Segment((0, 0), (9, 0), sensor=True), False),
        (Segment((0, 0), (9, 0), can_collide=False), False),
        (Circle((4, 0), 3), False),
    ],
)
def test_what_has_no_ends_or_is_not_met_is_not_passed(shape: Any, passes: bool) -> None:
    arrays = in_flight(continuous_world(shape, Ball((-2, 0.5), 1, velocity=(1, 0))))
    come(arrays, 2.5)
    assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0) == passes


def test_a_ball_that_was_pushed_onto_a_wall_does_not_pass_it() -> None:
    arrays = in_flight(continuous_world(Segment((0, 0), (9, 0)), Ball((3, 0.9), 1)))
    come(arrays, 1.0)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)


@pytest.mark.parametrize("step", [0.0, 1e-4, 1e-2])
def test_a_ball_that_slides_over_a_joint_is_handed_on_over_a_small_step(step: float) -> None:
    walls = Segment((-9, 0), (0, 0)), Segment((0, step), (9, step))
    arrays = in_flight(continuous_world(*walls, Ball((-1, 1), 1, velocity=(1, 0))))
    state, ball, flight = arrays.states[0], arrays.balls.rows[0], arrays.flights[0]
    add_relation(state, arrays.relations, ball, 0, LASTING, 0)
    ball["x"] = 0.5
    path = Path(-1.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    for row in range(2):
        note_passing(state, ball, flight, 0, arrays.shapes.rows, row, arrays.relations, 0.0, 1.5, path)
    assert find_relation(arrays.relations, ball, PASSING, 1) == (step > 1e-3)


def test_who_leaves_a_ring_by_its_gap_passes_the_end_that_it_overlaps_then() -> None:
    # It came from within the ring, beside the arc, and got into it past the end.
    ring = Arc((0, 0), 3, pi + 0.5, pi - 0.5)
    arrays = in_flight(continuous_world(ring, Ball((-1.5, 1.2), 0.5, velocity=(-1.5, -2.95))))
    come(arrays, 1.0)
    ball = arrays.balls.rows[0]
    assert 2.5 < hypot(ball["x"], ball["y"]) < 3.5
    assert find_relation(arrays.relations, ball, PASSING, 0)


def test_what_was_put_onto_a_ball_on_its_way_is_not_passed() -> None:
    arrays = in_flight(continuous_world(Segment((0, 0), (9, 0)), Ball((3, 2), 1, velocity=(0.5, -1))))
    come(arrays, 1.5)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)
