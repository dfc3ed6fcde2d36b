"""Impacts of balls in flight: momentum and energy, rest sensors and the squeezed."""

from math import cos, hypot, sin, sqrt

import numpy as np
import pytest

from carom import Ball, Circle, Gate, Segment
from carom.constants import ELASTIC_REBOUND, MOST_AT_ONCE, REBOUND, SHORT_FLIGHTS
from carom.rows.flight import ASLEEP, FLYING
from carom.rows.hit import ENTER, HIT_ROW
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, LYING, PASSING
from carom.world.kernels.continuous.encounter import (
    impact_of_balls,
    impact_with_shape,
    keep_push_out,
    stop_between,
)
from carom.world.kernels.step.relations import find_relation, set_force
from carom.world.tables import Arrays
from tests.heaps import impetus, joined
from tests.kernel_calls import in_flight, near_tables, shape_index
from tests.worlds import continuous_world


def met(arrays: Arrays) -> bool:
    """Let the first two balls meet."""
    rows = arrays.balls.rows, arrays.flights, 0, 1, arrays.hits.view(HIT_ROW), arrays.relations
    return impact_of_balls(arrays.states[0], *rows)


def touched(arrays: Arrays, row: int = 0) -> None:
    """Let the first ball touch a shape."""
    tables = row, *shape_index(arrays), arrays.hits.view(HIT_ROW), arrays.relations
    impact_with_shape(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], 0, arrays.shapes.rows, *tables)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("elasticity", [1.0, 0.5, 0.0])
def test_balls_keep_their_momentum_and_lose_what_their_elasticity_takes(seed: int, elasticity: float) -> None:
    random = np.random.default_rng(seed)
    angle, masses, radii = random.uniform(0, 6), random.uniform(0.1, 9, 2), random.uniform(0.5, 2, 2)
    normal = np.array([np.cos(angle), np.sin(angle)])
    world = continuous_world(
        Ball((0, 0), radii[0], tuple(3 * normal + random.normal(0, 1, 2)), masses[0], elasticity=elasticity),
        Ball(tuple(sum(radii) * normal), radii[1], tuple(-3 * normal + random.normal(0, 1, 2)), masses[1]),
    )
    arrays = in_flight(world)
    before = world.balls.velocity.copy()
    assert not met(arrays)
    after = world.balls.velocity
    assert masses @ after == pytest.approx(masses @ before)
    u, v = (before[1] - before[0]) @ normal, (after[1] - after[0]) @ normal
    assert v == pytest.approx(-elasticity * u)
    across = np.array([-normal[1], normal[0]])
    assert after @ across == pytest.approx(before @ across)
    hit = arrays.hits[0]
    assert hit["normal"] == pytest.approx(normal)
    assert (hit["ball"], hit["shape"]) == (world.balls[1].id, world.balls[0].id)
    assert hit["impulse"] == pytest.approx(masses[1] * (after[1] - before[1]) @ normal)


@pytest.mark.parametrize("rest_speed", [1.0, 3.0])
@pytest.mark.parametrize("press", [0.0, 0.5])
def test_a_slow_approach_of_balls_that_are_pressed_together_is_no_bounce(rest_speed: float, press: float) -> None:
    balls = Ball((0, 0), 1, (1, 0), elasticity=0.5), Ball((2, 0), 1, (-1, 0))
    arrays = in_flight(continuous_world(*balls, rest_speed=rest_speed, gravity=(0, -1)))
    arrays.flights["ax"][0] = press
    met(arrays)
    rests = rest_speed > 2.0 and press > 0.0
    assert arrays.balls.used["vx"].tolist() == ([0, 0] if rests else [-0.5, 0.5])
    assert arrays.states[0]["hits"] == int(not rests)
    # Then they lie on each other, and each knows it.
    assert find_relation(arrays.relations, arrays.balls.rows[0], LYING, 1) == rests
    assert find_relation(arrays.relations, arrays.balls.rows[1], LYING, 0) == rests


@pytest.mark.parametrize("elasticity", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("pull", [1e-3, 1.0, 300.0])
def test_a_rebound_lower_than_a_part_of_the_radius_lets_balls_lie_on_each_other(elasticity: float, pull: float) -> None:
    height = (ELASTIC_REBOUND if elasticity == 1.0 else REBOUND) * 0.5
    highest = sqrt(2 * pull * height) / (elasticity or 1e-9)
    # Without elasticity nothing rebounds.
    for speed in (0.99 * highest, 1.01 * highest)[: 1 if elasticity == 0.0 else 2]:
        balls = Ball((0, 0), 0.5, (speed, 0), elasticity=elasticity), Ball((1.5, 0), 1)
        arrays = in_flight(continuous_world(*balls))
        arrays.flights["ax"][0] = pull
        met(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], LYING, 1) == (speed < highest)
        after = arrays.balls.used["vx"]
        assert after[1] - after[0] == pytest.approx(0.0 if speed < highest else elasticity * speed, abs=1e-12 * speed)
    # Nor does one that turns about the other faster than it is pressed onto it.
    balls = Ball((0, 0), 0.5, (0, 1.01 * sqrt(1.5 * pull))), Ball((1.5, 0), 1)
    arrays = in_flight(continuous_world(*balls))
    arrays.flights["ax"][0] = pull
    met(arrays)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], LYING, 1)


def test_impacts_too_close_to_be_told_apart_let_balls_lie_on_each_other() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, (1, 0), elasticity=0.5), Ball((2, 0), 1, (-1, 0))))
    arrays.flights["short"][1], arrays.flights["met_time"][1] = SHORT_FLIGHTS, 0.0
    met(arrays)
    assert find_relation(arrays.relations, arrays.balls.rows[0], LYING, 1)
    assert arrays.balls.used["vx"].tolist() == [0, 0]


def test_a_ball_that_sleeps_wakes_when_it_is_hit() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, (1, 0)), Ball((2, 0), 1)))
    arrays.balls.rows["asleep"][1], arrays.flights["kind"][1], arrays.states[0]["sleeping"] = 1, ASLEEP, 1
    met(arrays)
    assert arrays.balls.used["vx"].tolist() == [0, 1]
    assert (arrays.flights["kind"][1], arrays.balls.rows["asleep"][1], arrays.states[0]["sleeping"]) == (FLYING, 0, 0)


def test_overlapping_balls_are_moved_apart_and_say_so() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, (1, 0), mass=3), Ball((1.6, 0), 1)))
    assert met(arrays)
    x = arrays.balls.used["x"]
    assert x[1] - x[0] == pytest.approx(2.0)
    assert 3 * x[0] + x[1] == pytest.approx(1.6)


def test_a_sensor_is_entered_and_changes_nothing() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, (1, 0)), Ball((2, 0), 1, sensor=True)))
    met(arrays)
    assert arrays.hits[0]["kind"] == ENTER
    assert find_relation(arrays.relations, arrays.balls.rows[1], INSIDE_BALL, 0)
    arrays = in_flight(continuous_world(Circle((2, 0), 1, sensor=True, solid=True), Ball((0, 0), 1, (1, 0))))
    touched(arrays)
    assert (arrays.hits[0]["kind"], arrays.balls.rows["vx"][0]) == (ENTER, 1)
    assert find_relation(arrays.relations, arrays.balls.rows[0], INSIDE_SHAPE, 0)


@pytest.mark.parametrize(("elasticity", "kick"), [(1.0, 0.0), (0.5, 0.0), (0.5, 2.0)])
def test_a_ball_leaves_a_moving_wall_as_it_would_one_at_rest_seen_from_it(elasticity: float, kick: float) -> None:
    wall = Segment((0, -5), (0, 5), motion="kinematic", velocity=(-2, 7), elasticity=elasticity, kick=kick)
    arrays = in_flight(continuous_world(wall, Ball((-1, 0), 1, (3, 1))))
    touched(arrays)
    ball = arrays.balls.rows[0]
    assert (ball["vx"], ball["vy"]) == pytest.approx((-2 - elasticity * 5 - kick, 1))
    assert arrays.hits[0]["speed"] == pytest.approx(hypot(5, -6))


def test_a_gate_is_passed_from_its_open_side() -> None:
    for direction, passes in (((1, 0), True), ((-1, 0), False)):
        arrays = in_flight(continuous_world(Gate((0, -5), (0, 5), direction), Ball((-1, 0), 1, (3, 0))))
        touched(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0) == passes
        assert arrays.balls.rows["vx"][0] == (3 if passes else -3)


def test_what_a_ball_is_not_beside_when_it_meets_it_again_and_again_it_passes() -> None:
    world = continuous_world(Segment((0, 0), (4, 0)), Ball((5, 0.5), 0.5, (0, -1)))
    arrays = in_flight(world)
    for k in range(MOST_AT_ONCE):
        assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0), k
        touched(arrays)
    assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)
    assert (world.balls[0].velocity, arrays.flights[0]["at_once"]) == ((0, -1), 0)


def test_a_rebound_that_would_end_at_once_is_a_contact_that_lasts() -> None:
    for speed, lasts in ((0.01, True), (2.0, False)):
        arrays = in_flight(continuous_world(Segment((-5, 0), (5, 0)), Ball((0, 1), 1, (1, -speed), elasticity=0.5)))
        arrays.states[0]["gravity_y"] = -10.0
        touched(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], LASTING, 0) == lasts
        assert arrays.balls.rows["vy"][0] == (0.0 if lasts else 0.5 * speed)


@pytest.mark.parametrize("speed", [3.0, 300.0])
def test_the_greatest_speed_is_not_below_that_of_the_surface_that_pushes(speed: float) -> None:
    paddle = Segment((0, -5), (0, 5), motion="kinematic", velocity=(speed, 0))
    arrays = in_flight(continuous_world(paddle, Ball((1, 0), 1, velocity=(0, 4)), max_speed=10.0))
    touched(arrays)
    vx, vy = float(arrays.balls.rows["vx"][0]), float(arrays.balls.rows["vy"][0])
    assert vx >= speed
    assert vx == pytest.approx(min(2 * speed, max(speed, 10)))
    assert arrays.states[0]["slowed"] == int(speed > 10)
    assert abs(vy) <= 4


def test_balls_are_limited_in_speed_too() -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 1, (30, 0)), Ball((2, 0), 1), max_speed=10.0))
    met(arrays)
    assert arrays.balls.used["vx"].tolist() == [0, 10]
    assert arrays.states[0]["slowed"] == 1


def test_a_limited_ball_is_no_slower_than_the_one_that_pushes_it() -> None:
    heavy, light = Ball((0, 0), 1, (9, 0), mass=100.0), Ball((2, 0), 1, (0, 9.5))
    arrays = in_flight(continuous_world(heavy, light, max_speed=10.0))
    momentum = impetus(arrays)[0]
    met(arrays)
    first, second = arrays.balls.used["vx"]
    assert second >= first
    assert arrays.states[0]["slowed"] == 1
    assert impetus(arrays)[0] <= momentum


def vice(gap: float, both: bool) -> Arrays:
    """A ball between a wall and a mover that comes to it, or two of them that close; so much room is left."""
    left = {"motion": "kinematic", "velocity": (1, 0)} if both else {}
    walls = (
        Segment((-1 - gap, -5), (-1 - gap, 5), **left),
        Segment((1, -5), (1, 5), motion="kinematic", velocity=(-1, 0)),
    )
    return in_flight(continuous_world(*walls, Ball((0, 0), 1)))


@pytest.mark.parametrize("both", [False, True])
def test_a_ball_squeezed_between_closing_walls_is_stopped_by_one_and_passed_by_the_other(both: bool) -> None:
    arrays = vice(1e-9, both)
    touched(arrays, 1)
    ball = arrays.balls.rows[0]
    assert (arrays.states[0]["squeezed"], ball["vx"]) == (1, 0)
    assert find_relation(arrays.relations, ball, PASSING, 1)
    # The one that stands still, or comes first in order, has the last word.
    arrays = vice(1e-9, both)
    touched(arrays, 0)
    assert arrays.states[0]["squeezed"] == 0
    assert not find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0)


@pytest.mark.parametrize("both", [False, True])
def test_where_there_is_room_a_ball_bounces_off_either(both: bool) -> None:
    arrays = vice(0.1, both)
    touched(arrays, 1)
    assert (arrays.states[0]["squeezed"], arrays.balls.rows["vx"][0]) == (0, -2)


@pytest.mark.parametrize("angle", [0.3, 1.1, 2.9])
def test_a_bounce_keeps_the_speed_and_puts_the_ball_onto_the_surface_from_either_side(angle: float) -> None:
    t, n = (cos(angle), sin(angle)), (-sin(angle), cos(angle))
    for off in (1e-10, -1e-10):
        ball = Ball(((1 + off) * n[0], (1 + off) * n[1]), 1, velocity=(0.3 * t[0] - 2 * n[0], 0.3 * t[1] - 2 * n[1]))
        arrays = in_flight(continuous_world(Segment((-5 * t[0], -5 * t[1]), (5 * t[0], 5 * t[1])), ball))
        touched(arrays)
        row = arrays.balls.rows[0]
        assert row["x"] * n[0] + row["y"] * n[1] == pytest.approx(1.0, abs=1e-15)
        assert hypot(row["vx"], row["vy"]) == pytest.approx(hypot(0.3, 2), rel=4e-16)
        assert row["vx"] * n[0] + row["vy"] * n[1] == pytest.approx(2.0, rel=1e-15)


def test_a_push_does_not_go_into_a_shape() -> None:
    arrays = in_flight(continuous_world(Segment((-5, -1), (5, -1)), Ball((0, 0), 1), Ball((3, 0), 1)))
    ball = arrays.balls.rows[0]
    ball["x"], ball["y"] = 0.01, -0.02
    tables = arrays.shapes.rows, *shape_index(arrays), arrays.relations
    keep_push_out(ball, *tables, 0.0, 0.0)
    assert (ball["x"], ball["y"]) == pytest.approx((0.01, 0.0), abs=1e-15)


@pytest.mark.parametrize(("angle", "stops"), [(0.3, True), (1.2, True), (0.0, False)])
@pytest.mark.parametrize("velocity", [(0.0, 0.0), (2.0, -1.0)])
def test_a_tired_ball_is_stopped_between_two_shapes_that_lead_it_back_and_forth(
    angle: float, stops: bool, velocity: tuple[float, float]
) -> None:
    moves = {"motion": "kinematic", "velocity": velocity}
    # The lid comes down to the left, onto the ball; the last one is level.
    c, s = cos(angle), sin(angle) if stops else 0.0
    floor, lid = Segment((-9, -1), (9, -1), **moves), Segment((-9 * c - s, -9 * s + c), (9 * c - s, 9 * s + c), **moves)
    ball = Ball((0, 0), 1, velocity=(velocity[0] - 1, velocity[1] - 0.5))
    arrays = in_flight(continuous_world(floor, lid, ball))
    tables = near_tables(arrays)
    row = arrays.balls.rows[0]
    row["vy"] = velocity[1]  # as the floor has left it
    stop_between(row, arrays.flights[0], *tables, 0, 0.0, 1.0)
    assert (row["vx"], row["vy"]) == pytest.approx(velocity if stops else (velocity[0] - 1, velocity[1]))


@pytest.mark.parametrize("lying", [0, 1])
@pytest.mark.parametrize("force", [0.0, 400.0])
def test_what_presses_a_ball_of_a_heap_presses_it_onto_whom_it_meets(lying: int, force: float) -> None:
    pull = max(10.0, force / 2.0)
    highest = sqrt(2 * pull * REBOUND * 0.5) / 0.5
    for speed in (0.99 * highest, 1.01 * highest):
        third = Ball((0, 1) if lying == 0 else (1, 1), 0.5)
        balls = Ball((0, 0), 0.5, (speed, 0), mass=2, elasticity=0.5), Ball((1, 0), 0.5, mass=2), third
        arrays = joined(in_flight(continuous_world(*balls, gravity=(0, -10))), [(lying, 2)])
        set_force(arrays.relations, arrays.balls.rows[lying], LYING, 2, 0.0, -force)
        met(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], LYING, 1) == (speed < highest)
