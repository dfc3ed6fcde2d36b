"""Lasting contacts: the acceleration that holds a ball, the way along a slope, and how long balls wait."""

from math import cos, pi, sin, sqrt

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, Shape
from carom.constants import PATIENCE_DEPTH, PATIENCE_PART
from carom.rows.pose import surface_velocity
from carom.rows.relation import LASTING, NO_RELATION
from carom.world.kernels.continuous.support import holding_acceleration, lean, patience, slide_time
from carom.world.kernels.continuous.surfaces import gap_to_shape
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world

TURNING = {"motion": "kinematic", "pivot": (0.5, -0.5), "velocity": (1.0, -0.5), "angular_velocity": 1.5}
#: A shape of each kind, at rest and in motion, and the direction in which a ball of radius 0.5 is held by it.
HOLDERS: list[tuple[Shape, tuple[float, float]]] = [
    (made, normal)
    for options in ({}, TURNING)
    for made, normal in (
        (Point((1, 1), **options), (0.6, 0.8)),
        (Segment((-3, 1), (4, 1), **options), (0.0, 1.0)),
        (Circle((1, 1), 2, solid=True, **options), (0.6, 0.8)),
        (Circle((1, 1), 2, **options), (-0.6, -0.8)),
        (Arc((1, 1), 2, 0.0, 2.0, **options), (0.6, 0.8)),
    )
]


@pytest.mark.parametrize(("shape", "normal"), HOLDERS, ids=repr)
def test_a_ball_that_is_held_stays_at_its_gap_to_the_second_order(shape: Shape, normal: tuple[float, float]) -> None:
    row, radius = shape._row, 0.5
    row["spin"] = 1.5 if row["motion"] else 0.0
    (nx, ny), reach = normal, 0.0 if isinstance(shape, Point) else 2.0
    place = (1.0, 1.0) if isinstance(shape, Segment) else (1 + 0.6 * reach, 1 + 0.8 * reach)
    x, y = place[0] + radius * nx, place[1] + radius * ny
    ux, uy = surface_velocity(row, float(row["spin"]), x, y, 0.0)
    vx, vy = ux - 1.3 * ny, uy + 1.3 * nx
    held = holding_acceleration(row, 0.0, x, y, vx, vy, nx, ny)
    step, gaps = 1e-3, []
    for time in (-step, 0.0, step):
        at = x + vx * time + held * nx * time**2 / 2, y + vy * time + held * ny * time**2 / 2
        found = gap_to_shape(row, time, *at, radius, 0.0, 0.0)
        assert found is not None
        gaps.append(found[0])
    assert gaps == pytest.approx([0.0] * 3, abs=1e-8)
    assert (gaps[0] - 2 * gaps[1] + gaps[2]) / step**2 == pytest.approx(0.0, abs=0.02)


def resting(*shapes: Shape, ball: Ball, gravity: tuple[float, float] = (0, -10)) -> Arrays:
    """The tables of a world in which shapes hold a ball."""
    arrays = in_flight(continuous_world(*shapes, ball, gravity=gravity), 1.0)
    arrays.balls.rows["relation"], arrays.states[0]["free_relation"] = NO_RELATION, NO_RELATION
    for row in range(len(shapes)):
        add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, LASTING, row)
    return arrays


def leaning(arrays: Arrays) -> tuple[float, float]:
    """The acceleration of a ball that its shapes hold."""
    lean(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows, arrays.relations, 1.0, True)
    return float(arrays.flights[0]["ax"]), float(arrays.flights[0]["ay"])


@pytest.mark.parametrize("slope", [0.0, 0.3, -1.2])
def test_a_ball_on_a_slope_falls_along_it(slope: float) -> None:
    t, n = (cos(slope), sin(slope)), (-sin(slope), cos(slope))
    arrays = resting(Segment((-5 * t[0], -5 * t[1]), (5 * t[0], 5 * t[1])), ball=Ball(n, 1))
    assert leaning(arrays) == pytest.approx((-10 * sin(slope) * t[0], -10 * sin(slope) * t[1]), abs=1e-12)


def test_a_ball_in_a_wedge_does_not_fall_and_one_that_is_lifted_off_falls_freely() -> None:
    left, right = Segment((0, 0), (-5, 5)), Segment((0, 0), (5, 5))
    assert leaning(resting(left, right, ball=Ball((0, sqrt(2)), 1))) == pytest.approx((0, 0), abs=1e-12)
    roof = resting(Segment((-5, 0), (5, 0)), ball=Ball((0, -1), 1))
    assert leaning(roof) == (0, -10)
    assert not find_relation(roof.relations, roof.balls.rows[0], LASTING, 0)


def test_a_ball_that_runs_through_a_bowl_is_pulled_to_its_middle() -> None:
    arrays = resting(Arc((0, 0), 3, pi, 2 * pi), ball=Ball((0, -2), 1, velocity=(4, 0)))
    assert leaning(arrays) == pytest.approx((0, 4 * 4 / 2))


@pytest.mark.parametrize(("place", "speed"), [(-2.0, 1.0), (1.0, -2.0), (0.0, 3.0)])
def test_a_ball_slides_to_the_end_of_a_slope_as_long_as_the_parabola_says(place: float, speed: float) -> None:
    slope, pull = 0.4, -10 * sin(0.4)
    t, n = (cos(slope), sin(slope)), (-sin(slope), cos(slope))
    ball = Ball((n[0] + place * t[0], n[1] + place * t[1]), 1, velocity=(speed * t[0], speed * t[1]))
    arrays = resting(Segment((-4 * t[0], -4 * t[1]), (3 * t[0], 3 * t[1])), ball=ball)
    leaning(arrays)
    time, leaves = slide_time(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], 9.0)
    roots = [*np.roots([pull / 2, speed, place + 4]), *np.roots([pull / 2, speed, place - 3])]
    assert leaves
    assert time == pytest.approx(min(root.real for root in roots if abs(root.imag) < 1e-12 and root.real > 0), abs=1e-6)
    assert slide_time(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], 0.01) == (0.01, False)


@pytest.mark.parametrize("pull", [0.001, 1.0, 300.0])
def test_balls_that_rest_on_each_other_wait_for_a_tick_in_which_they_hardly_sink_in(pull: float) -> None:
    arrays = in_flight(continuous_world(Ball((0, 0), 2), Ball((3, 0), 1), gravity=(0, -pull)), 1.0)
    wait, quiet = patience(
        arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.balls.rows[1], arrays.flights[1]
    )
    ticks = PATIENCE_PART / wait
    assert ticks == 2.0 ** round(np.log2(ticks))
    assert 0.5 * pull * wait * wait <= PATIENCE_DEPTH
    assert ticks == 1.0 or 0.5 * pull * 4 * wait * wait > PATIENCE_DEPTH
    assert quiet == pull * wait
