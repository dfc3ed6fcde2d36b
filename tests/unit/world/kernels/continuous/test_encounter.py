"""Impacts of balls in flight: momentum and energy, rest, sensors, and those that are stopped for the substep."""

from math import hypot

import numpy as np
import pytest

from carom import Ball, Circle, Gate, Segment, World
from carom.rows.flight import FLYING, STALLED
from carom.rows.hit import ENTER, HIT_ROW
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, NO_RELATION, PASSING
from carom.world.kernels.continuous.encounter import count_impact, impact_of_balls, impact_with_shape
from carom.world.kernels.step.relations import find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, shape_index
from tests.worlds import continuous_world


def flying(world: World) -> Arrays:
    """The tables of a world at the beginning of a span of a second."""
    arrays = in_flight(world, 1.0)
    arrays.balls.rows["relation"] = NO_RELATION
    arrays.states[0]["free_relation"] = NO_RELATION
    return arrays


def met(arrays: Arrays, rest_speed: float = 0.0) -> bool:
    """Let the first two balls meet."""
    rows = arrays.balls.rows, arrays.flights, 0, 1, arrays.hits.view(HIT_ROW), arrays.relations
    return impact_of_balls(arrays.states[0], *rows, rest_speed)


def touched(arrays: Arrays, rest_speed: float = 0.0) -> None:
    """Let the first ball touch the first shape."""
    found = arrays.shapes.rows, 0, *shape_index(arrays), arrays.hits.view(HIT_ROW), arrays.relations
    impact_with_shape(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], 0, *found, rest_speed)


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
    arrays = flying(world)
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


def test_who_has_been_stopped_is_met_as_a_wall() -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1, (3, 1)), Ball((2, 0), 1, (-9, 9), mass=1e-3)))
    arrays.flights["kind"][1] = STALLED
    met(arrays)
    assert arrays.balls.used["vx"].tolist() == [-3, -9]
    assert arrays.balls.used["vy"].tolist() == [1, 9]


@pytest.mark.parametrize("rest_speed", [1.0, 3.0])
def test_a_slow_approach_of_inelastic_balls_is_no_bounce(rest_speed: float) -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1, (1, 0), elasticity=0.5), Ball((2, 0), 1, (-1, 0))))
    met(arrays, rest_speed)
    rests = rest_speed > 2.0
    assert arrays.balls.used["vx"].tolist() == ([0, 0] if rests else [-0.5, 0.5])
    assert arrays.states[0]["hits"] == int(not rests)
    # Balls that rest on each other wait before they meet again.
    assert (arrays.flights["patience"][:2] > 0.0).tolist() == [rests, rests]


def test_overlapping_balls_are_moved_apart_and_say_so() -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1, (1, 0), mass=3), Ball((1.6, 0), 1)))
    assert met(arrays)
    x = arrays.balls.used["x"]
    assert x[1] - x[0] == pytest.approx(2.0)
    assert 3 * x[0] + x[1] == pytest.approx(1.6)


def test_a_sensor_is_entered_and_changes_nothing() -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1, (1, 0)), Ball((2, 0), 1, sensor=True)))
    met(arrays)
    assert arrays.hits[0]["kind"] == ENTER
    assert find_relation(arrays.relations, arrays.balls.rows[1], INSIDE_BALL, 0)
    arrays = flying(continuous_world(Circle((2, 0), 1, sensor=True, solid=True), Ball((0, 0), 1, (1, 0))))
    touched(arrays)
    assert (arrays.hits[0]["kind"], arrays.balls.rows["vx"][0]) == (ENTER, 1)
    assert find_relation(arrays.relations, arrays.balls.rows[0], INSIDE_SHAPE, 0)


@pytest.mark.parametrize(("elasticity", "kick"), [(1.0, 0.0), (0.5, 0.0), (0.5, 2.0)])
def test_a_ball_leaves_a_moving_wall_as_it_would_one_at_rest_seen_from_it(elasticity: float, kick: float) -> None:
    wall = Segment((0, -5), (0, 5), motion="kinematic", velocity=(-2, 7), elasticity=elasticity, kick=kick)
    arrays = flying(continuous_world(wall, Ball((-1, 0), 1, (3, 1))))
    arrays.shapes.rows["spin"] = 0.0
    touched(arrays)
    ball = arrays.balls.rows[0]
    assert (ball["vx"], ball["vy"]) == pytest.approx((-2 - elasticity * 5 - kick, 1))
    assert arrays.hits[0]["speed"] == pytest.approx(hypot(5, -6))


def test_a_gate_is_passed_from_its_open_side() -> None:
    for direction, passes in (((1, 0), True), ((-1, 0), False)):
        arrays = flying(continuous_world(Gate((0, -5), (0, 5), direction), Ball((-1, 0), 1, (3, 0))))
        touched(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], PASSING, 0) == passes
        assert arrays.balls.rows["vx"][0] == (3 if passes else -3)


def test_a_rebound_that_would_end_at_once_is_a_contact_that_lasts() -> None:
    for speed, lasts in ((0.01, True), (2.0, False)):
        arrays = flying(continuous_world(Segment((-5, 0), (5, 0)), Ball((0, 1), 1, (1, -speed), elasticity=0.5)))
        arrays.states[0]["gravity_y"] = -10.0
        touched(arrays)
        assert find_relation(arrays.relations, arrays.balls.rows[0], LASTING, 0) == lasts
        assert arrays.balls.rows["vy"][0] == (0.0 if lasts else 0.5 * speed)


def test_a_ball_is_stopped_when_it_has_had_too_many_impacts() -> None:
    arrays = flying(continuous_world(Ball((0, 0), 1), max_impacts=3, gravity=(0, -1)))
    for count in range(1, 5):
        count_impact(arrays.states[0], arrays.flights[0])
        assert arrays.flights[0]["kind"] == (STALLED if count >= 3 else FLYING)
        assert arrays.flights[0]["ay"] == (0 if count >= 3 else -1)
        assert arrays.states[0]["stalled"] == int(count >= 3)
